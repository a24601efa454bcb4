#include "idiophone/run/record/surface_recorder.hpp"

#include <algorithm>

#include "idiophone/foundation/parallel/reduce.hpp"
#include "idiophone/foundation/version.hpp"

namespace idiophone::record {

namespace {

constexpr std::int64_t bytes_kept = 64 << 20;  // on each rank

void append(const Vector3& x, std::vector<double>& numbers) {
  numbers.insert(numbers.end(), x.begin(), x.end());
}

surface::RecordingHeader make_header(const scene::Scene& scene, const propagation::AudibleSurface& surface,
                                     std::int64_t steady, std::int64_t samples) {
  surface::RecordingHeader header{.origin = {scene.name, program_version, scene.deck_text, scene.overrides},
                                  .rate = static_cast<double>(scene.audio.rate),
                                  .first_sample = steady,
                                  .samples = samples,
                                  .air_density = scene.radiation.air.density,
                                  .air_speed = scene.radiation.air.speed,
                                  .bodies = {},
                                  .obstacle_triangles = {},
                                  .half_spaces = {}};
  for (std::size_t b = 0; b < surface.bodies.size(); ++b) {
    header.bodies.push_back({surface.bodies[b], surface.first_triangle[b], surface.first_vertex[b]});
  }
  for (const auto& triangle : surface.obstacles) {
    for (const Vector3& corner : triangle) {
      append(corner, header.obstacle_triangles);
    }
  }
  for (const auto& [point, normal] : surface.half_spaces) {
    append(point, header.half_spaces);
    append(normal, header.half_spaces);
  }
  return header;
}

}  // namespace

std::filesystem::path recording_of(const std::filesystem::path& result) {
  return result.parent_path() / (result.stem().string() + "_surface.h5");
}

double recorded_bytes_per_sample(const bodies::Preparation& ready) {
  return sizeof(double) * (1.0 * ready.part.global_triangles + 3.0 * ready.part.global_vertices);
}

SurfaceRecorder::SurfaceRecorder(const scene::Scene& scene, const propagation::AudibleSurface& surface,
                                 std::int64_t steady, std::int64_t samples, std::filesystem::path path,
                                 MPI_Comm communicator)
    : surface_(surface),
      communicator_(communicator),
      triangles_(surface.triangle_ids, surface.global_triangles(), communicator),
      vertices_(surface.vertex_ids, surface.global_vertices(), communicator),
      path_(std::move(path)),
      header_(make_header(scene, surface, steady, samples)),
      corners_(propagation::global_corners(surface)) {
  for (const Vector3& vertex : surface.reference) {
    append(vertex, reference_);
  }
  const auto bytes =
      static_cast<std::int64_t>(sizeof(double) * (surface.triangles.size() + 3 * surface.reference.size()));
  const auto fitting = std::max<std::int64_t>(bytes_kept / std::max<std::int64_t>(bytes, 1), 1);
  longest_block_ = parallel::smallest(fitting, communicator_);
}

void SurfaceRecorder::declare() {
  file_ = results::SurfaceMotionFile::create(path_, header_, recorded(), communicator_);
}

void SurfaceRecorder::note(std::int64_t /*sample*/, const surface::SurfaceMotion& motion) {
  const auto take = [](std::span<const double> values, std::vector<double>& noted) {
    noted.insert(noted.end(), values.begin(), values.end());
  };
  take(std::span(motion.pressure).first(surface_.triangles.size()), pressure_);
  take(std::span(motion.position).first(reference_.size()), position_);
  ++noted_;
}

void SurfaceRecorder::write() {
  file_->append(noted_, pressure_, position_);
  file_->flush();
  noted_ = 0;
  pressure_.clear();
  position_.clear();
}

void SurfaceRecorder::archive(parallel::Archive& archive) {
  if (archive.restoring()) {
    file_ = results::SurfaceMotionFile::open(path_, recorded(), communicator_);
  }
  file_->archive(archive);
}

surface::RecordedSurface SurfaceRecorder::recorded() const {
  return {&triangles_, &vertices_, corners_, reference_};
}

}  // namespace idiophone::record
