#include "idiophone/record/surface_recorder.hpp"

#include <algorithm>
#include <limits>

#include "idiophone/source/audible_surface.hpp"

namespace idiophone::record {

namespace {

constexpr std::int64_t bytes_kept = 64 << 20;  // on each rank

}  // namespace

std::filesystem::path recording_of(const std::filesystem::path& result) {
  return result.parent_path() / (result.stem().string() + "_surface.h5");
}

double recorded_bytes_per_sample(const source::Preparation& ready) {
  return sizeof(double) * (1.0 * ready.part.global_triangles + 3.0 * ready.part.global_vertices);
}

SurfaceRecorder::SurfaceRecorder(const source::Preparation& ready, const parallel::Rows& triangles,
                                 const parallel::Rows& vertices, std::int64_t steady, std::int64_t samples,
                                 std::filesystem::path path, MPI_Comm communicator)
    : ready_(ready),
      triangles_(triangles),
      vertices_(vertices),
      communicator_(communicator),
      path_(std::move(path)),
      header_{.origin = {ready.scene.name, IDIOPHONE_VERSION, ready.scene.deck_text, ready.scene.overrides},
              .rate = static_cast<double>(ready.scene.audio.rate),
              .first_sample = steady,
              .samples = samples,
              .air_density = ready.scene.radiation.air.density,
              .air_speed = ready.scene.radiation.air.speed,
              .bodies = bodies(),
              .obstacle_triangles = {},
              .half_spaces = {}} {
  const auto note_down = [](const Vector3& x, std::vector<double>& numbers) {
    numbers.insert(numbers.end(), x.begin(), x.end());
  };
  const source::AudibleSurface heard = source::audible_surface(ready);
  corners_ = source::global_corners(heard);
  for (const Vector3& vertex : heard.reference) {
    note_down(vertex, reference_);
  }
  for (const auto& triangle : heard.obstacles) {
    for (const Vector3& corner : triangle) {
      note_down(corner, header_.obstacle_triangles);
    }
  }
  for (const auto& [point, normal] : heard.half_spaces) {
    note_down(point, header_.half_spaces);
    note_down(normal, header_.half_spaces);
  }
  const auto bytes = static_cast<std::int64_t>(sizeof(double) * (heard.triangles.size() + 3 * heard.reference.size()));
  most_samples_ = std::max<std::int64_t>(bytes_kept / std::max<std::int64_t>(bytes, 1), 1);
  MPI_Allreduce(MPI_IN_PLACE, &most_samples_, 1, MPI_INT64_T, MPI_MIN, communicator_);
}

void SurfaceRecorder::create() {
  file_ = store::SurfaceMotionFile::create(path_, header_, surface(), communicator_);
}

void SurfaceRecorder::resume(std::int64_t samples) {
  file_ = store::SurfaceMotionFile::resume(path_, samples + 1, surface(), communicator_);
}

void SurfaceRecorder::note(const surface::SurfaceMotion& motion) {
  const auto take = [](const std::vector<double>& values, std::size_t count, std::vector<double>& notes) {
    notes.insert(notes.end(), values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count));
  };
  take(motion.pressure, ready_.part.surface.size(), pressure_);
  take(motion.position, 3 * ready_.part.vertices.size(), position_);
  ++noted_;
}

void SurfaceRecorder::write() {
  file_->append(noted_, pressure_, position_);
  file_->flush();
  noted_ = 0;
  pressure_.clear();
  position_.clear();
}

store::RecordedSurface SurfaceRecorder::surface() const {
  return {&triangles_, &vertices_, corners_, reference_};
}

std::vector<store::RecordedBody> SurfaceRecorder::bodies() const {
  const mesh::Part& part = ready_.part;
  // A body's vertices are numbered together, after those of the bodies before it.
  std::vector<Index> first_vertices(ready_.scene.bodies.size(), std::numeric_limits<Index>::max());
  for (std::size_t t = 0; t < part.surface.size(); ++t) {
    Index& first = first_vertices[static_cast<std::size_t>(part.triangle_body[t])];
    for (const Index vertex : part.surface[t]) {
      first = std::min(first, part.vertex_ids[static_cast<std::size_t>(vertex)]);
    }
  }
  MPI_Allreduce(MPI_IN_PLACE, first_vertices.data(), static_cast<int>(first_vertices.size()), MPI_INT32_T, MPI_MIN,
                communicator_);
  std::vector<store::RecordedBody> bodies;
  for (std::size_t b = 0; b < first_vertices.size(); ++b) {
    bodies.push_back({ready_.scene.bodies[b].name, ready_.offsets.triangles[b], first_vertices[b]});
  }
  return bodies;
}

}  // namespace idiophone::record
