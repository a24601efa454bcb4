#include "idiophone/air/propagation/line_of_sight.hpp"

#include <utility>

#include "all_triangles.hpp"
#include "idiophone/foundation/lanes.hpp"

namespace idiophone::propagation {

namespace {

/// The bodies as they are undeformed, the obstacles and the screens. Collective.
radiation::Occluders occluders(const propagation::AudibleSurface& surface,
                               const std::vector<std::array<Vector3, 3>>& screens, SharedPositions& shared,
                               MPI_Comm communicator) {
  std::vector<std::array<Vector3, 3>> obstacles = surface.obstacles;
  obstacles.insert(obstacles.end(), screens.begin(), screens.end());
  return {all_triangles(surface, communicator), surface.first_triangle, shared.share(surface.reference),
          std::move(obstacles), surface.half_spaces};
}

DiffractingEdges::Options all_edges(const propagation::AudibleSurface& surface, DiffractingEdges::Options options) {
  options.obstacles = surface.obstacles;
  return options;
}

}  // namespace

LineOfSight::LineOfSight(const propagation::AudibleSurface& surface, const Options& options, MPI_Comm communicator)
    : options_(options),
      triangles_(surface.triangle_ids),
      shared_(surface.vertex_ids, communicator),
      visibility_(occluders(surface, options.screens, shared_, communicator), options.self_occlusion),
      next_(options.receivers * options.paths, std::vector<float>(padded(triangles_.size()), 1.0F)),
      edges_(all_edges(surface, options.edges), visibility_),
      bends_(options.bends, options.receivers, triangles_.size()) {}

void LineOfSight::start(const surface::SurfaceMotion& motion, const std::vector<Vector3>& ends) {
  begin(motion, ends);
  finish();
  from_ = to_ = next_;
  bends_.start();
}

void LineOfSight::update(const surface::SurfaceMotion& motion, const std::vector<Vector3>& ends) {
  finish();
  from_.swap(to_);
  to_ = next_;
  bends_.advance();
  begin(motion, ends);
}

void LineOfSight::begin(const surface::SurfaceMotion& motion, const std::vector<Vector3>& ends) {
  ends_ = ends;
  shared_.begin(motion.position);
  updating_ = true;
}

void LineOfSight::finish() {
  if (!updating_) {
    return;
  }
  updating_ = false;
  shared_.finish(visibility_.positions());
  visibility_.move();
  const FoldedSight sight(visibility_, options_.section);
  for (std::size_t end = 0; end < ends_.size(); ++end) {
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      next_[end][i] = sight.sees(triangles_[i], ends_[end]) ? 1.0F : 0.0F;
    }
  }
  edges_.follow(visibility_);
  bends_.find(edges_, sight, triangles_, ends_, options_.paths);
}

void LineOfSight::fade(std::int64_t sample, std::size_t receiver, std::size_t path, radiation::Paths& ways) const {
  const double weight = this->weight(sample);
  const std::vector<float>& from = from_[receiver * options_.paths + path];
  const std::vector<float>& to = to_[receiver * options_.paths + path];
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double before = from[i];
    ways.gain[i] *= before + weight * (to[i] - before);
  }
}

void LineOfSight::archive(parallel::Archive& archive, const parallel::Rows& triangles) {
  finish();
  if (archive.restoring()) {
    from_ = to_ = next_;  // of the right size
  }
  archive.rows("radiation/visibility", triangles, [this](std::size_t triangle, parallel::ArchiveRow& row) {
    for (Seen* seen : {&from_, &to_, &next_}) {
      for (auto& receiver : *seen) {
        row.value(receiver[triangle]);
      }
    }
  });
  bends_.archive(archive, triangles);
}

}  // namespace idiophone::propagation
