#include "idiophone/air/propagation/line_of_sight.hpp"

#include "all_triangles.hpp"
#include "idiophone/foundation/lanes.hpp"

namespace idiophone::propagation {

namespace {

/// The bodies as they are undeformed, and the obstacles. Collective.
radiation::Occluders occluders(const propagation::AudibleSurface& surface, SharedPositions& shared,
                               MPI_Comm communicator) {
  return {all_triangles(surface, communicator), surface.first_triangle, shared.share(surface.reference),
          surface.obstacles, surface.half_spaces};
}

}  // namespace

LineOfSight::LineOfSight(const propagation::AudibleSurface& surface, const Options& options, MPI_Comm communicator)
    : options_(options),
      triangles_(surface.triangle_ids),
      shared_(surface.vertex_ids, communicator),
      visibility_(occluders(surface, shared_, communicator), options.self_occlusion),
      next_(options.receivers, std::vector<float>(padded(triangles_.size()), 1.0F)) {}

void LineOfSight::start(const surface::SurfaceMotion& motion, const std::vector<Vector3>& receivers) {
  begin(motion, receivers);
  finish();
  from_ = to_ = next_;
}

void LineOfSight::update(const surface::SurfaceMotion& motion, const std::vector<Vector3>& receivers) {
  finish();
  from_.swap(to_);
  to_ = next_;
  begin(motion, receivers);
}

void LineOfSight::begin(const surface::SurfaceMotion& motion, const std::vector<Vector3>& receivers) {
  receivers_ = receivers;
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
}

}  // namespace idiophone::propagation
