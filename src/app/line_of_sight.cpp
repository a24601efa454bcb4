#include "line_of_sight.hpp"

#include <algorithm>

#include "idiophone/contact/outline.hpp"
#include "idiophone/lanes.hpp"

namespace idiophone::app {

namespace {

/// The triangles of all ranks in global order, their vertices globally numbered. Collective.
std::vector<std::array<Index, 3>> all_triangles(const mesh::Part& part, MPI_Comm communicator) {
  std::vector<Index> own;
  for (const auto& triangle : part.surface) {
    std::ranges::transform(triangle, std::back_inserter(own),
                           [&](Index vertex) { return part.vertex_ids[static_cast<std::size_t>(vertex)]; });
  }
  const std::vector<Index> numbers = gather(part.triangle_ids, communicator).numbers;
  const std::vector<Index> corners = gather(own, communicator).numbers;
  std::vector<std::array<Index, 3>> triangles(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    std::copy_n(&corners[3 * i], 3, triangles[static_cast<std::size_t>(numbers[i])].begin());
  }
  return triangles;
}

/// The reference positions of all ranks' vertices. Collective.
std::vector<float> all_positions(const mesh::Part& part, SharedPositions& shared) {
  std::vector<double> own;
  for (const Index node : part.vertices) {
    const Vector3& position = part.reference[static_cast<std::size_t>(node)];
    own.insert(own.end(), position.begin(), position.end());
  }
  std::vector<float> all(3 * static_cast<std::size_t>(part.global_vertices));
  shared.begin(own);
  shared.finish(all);
  return all;
}

/// The bodies as they are meshed, and the obstacles. Collective.
radiation::Occluders occluders(const mesh::Part& part, const std::vector<Index>& first_triangle,
                               const std::vector<contact::RigidShape>& obstacles, SharedPositions& shared,
                               MPI_Comm communicator) {
  radiation::Occluders all{all_triangles(part, communicator), first_triangle, all_positions(part, shared), {}, {}};
  for (const contact::RigidShape& shape : obstacles) {
    const auto triangles = contact::outline(shape);
    all.obstacles.insert(all.obstacles.end(), triangles.begin(), triangles.end());
    if (triangles.empty()) {
      all.half_spaces.push_back({shape.planes.front().point, shape.planes.front().normal});
    }
  }
  return all;
}

}  // namespace

LineOfSight::LineOfSight(const mesh::Part& part, const std::vector<Index>& first_triangle,
                         const std::vector<contact::RigidShape>& obstacles, const Options& options,
                         MPI_Comm communicator)
    : options_(options),
      triangles_(part.triangle_ids),
      shared_(part.vertex_ids, communicator),
      visibility_(occluders(part, first_triangle, obstacles, shared_, communicator), options.own_body_hides),
      next_(options.receivers, std::vector<float>(padded(triangles_.size()), 1.0F)) {}

void LineOfSight::start(const surface::SurfaceMotion& motion, const std::vector<Vector3>& receivers) {
  begin(motion, receivers);
  finish();
  from_ = to_ = next_;
}

void LineOfSight::look(const surface::SurfaceMotion& motion, const std::vector<Vector3>& receivers) {
  finish();
  from_.swap(to_);
  to_ = next_;
  begin(motion, receivers);
}

void LineOfSight::begin(const surface::SurfaceMotion& motion, const std::vector<Vector3>& receivers) {
  receivers_ = receivers;
  shared_.begin(motion.position);
  looking_ = true;
}

void LineOfSight::finish() {
  if (!looking_) {
    return;
  }
  looking_ = false;
  shared_.finish(visibility_.positions());
  visibility_.move();
  for (std::size_t r = 0; r < options_.receivers; ++r) {
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      next_[r][i] = visibility_.sees(triangles_[i], receivers_[r]) ? 1.0F : 0.0F;
    }
  }
}

void LineOfSight::fade(std::int64_t sample, std::size_t receiver, radiation::Paths& paths) const {
  const std::int64_t past = sample > 0 ? sample % options_.interval : 0;
  const double weight = static_cast<double>(past) / static_cast<double>(options_.interval);
  const std::vector<float>& from = from_[receiver];
  const std::vector<float>& to = to_[receiver];
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double before = from[i];
    paths.gain[i] *= before + weight * (to[i] - before);
  }
}

std::vector<double> LineOfSight::save() {
  finish();
  std::vector<double> rows;
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    for (const Seen* seen : {&from_, &to_, &next_}) {
      for (const auto& receiver : *seen) {
        rows.push_back(receiver[i]);
      }
    }
  }
  return rows;
}

void LineOfSight::restore(std::span<const double> rows) {
  from_ = to_ = next_;
  auto row = rows.begin();
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    for (Seen* seen : {&from_, &to_, &next_}) {
      for (auto& receiver : *seen) {
        receiver[i] = static_cast<float>(*row++);
      }
    }
  }
}

}  // namespace idiophone::app
