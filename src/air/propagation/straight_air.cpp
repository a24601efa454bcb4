#include "straight_air.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "idiophone/air/propagation/image_paths.hpp"

namespace idiophone::propagation {

namespace {

/// The direct path bends, and those with one reflection do. They go around the mirror images of edges as well: around
/// an edge before they are reflected. By the images in a floor, the direct path goes with two reflections.
void bend_paths(const scene::Radiation& section, LineOfSight::Options& options) {
  options.bends.paths = {{.number = 0, .copies = {0}}};
  const std::vector<ImagePath> images = image_paths(section);
  for (std::size_t i = 0; i < images.size(); ++i) {
    if (images[i].reflections == 1) {
      options.edges.mirrors.push_back(images[i].planes.front());
      options.bends.paths.push_back({.number = i + 1, .copies = {0, options.edges.mirrors.size()}});
    }
  }
  if (section.floor) {
    options.bends.paths.front().copies.push_back(1);
  }
}

LineOfSight::Options sight_options(const scene::Acoustics& acoustics, const Ears& ears) {
  const scene::Radiation& section = acoustics.radiation;
  LineOfSight::Options options{.interval = section.visibility->interval(acoustics.audio.rate),
                               .receivers = ears.ear_count(),
                               .self_occlusion = ears.self_occlusion()};
  options.edges.solids = section.diffraction;
  options.bends.speed = section.air.speed;
  options.bends.rate = acoustics.audio.rate;
  if (!section.screens.empty() || section.diffraction) {
    options.section = section;
    options.paths = 1 + image_paths(section).size();
    bend_paths(section, options);
  }
  for (const scene::Screen& screen : section.screens) {
    const std::vector<Vector3>& corners = screen.corners;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      options.screens.push_back({corners[0], corners[i], corners[i + 1]});
    }
    const std::vector<radiation::DiffractingEdge> edges = radiation::screen_edges(corners);
    options.edges.screens.insert(options.edges.screens.end(), edges.begin(), edges.end());
  }
  return options;
}

/// Whether anything can stand between a triangle and a receiver: no body hides its own triangles where it is
/// transparent to itself.
bool can_be_hidden(const propagation::AudibleSurface& surface, const LineOfSight::Options& sight) {
  const std::size_t bodies = surface.first_triangle.size() - 1;
  return bodies > 1 || sight.self_occlusion == radiation::SelfOcclusion::included || sight.edges.solids ||
         !surface.obstacles.empty() || !surface.half_spaces.empty() || !sight.screens.empty();
}

/// Where the paths end that visibility is found for, m.
std::vector<Vector3> ends(const Ears& ears, const LineOfSight& sight, std::int64_t sample) {
  if (!sight.has(1)) {
    return ears.positions(sample);
  }
  std::vector<Vector3> ends;
  for (std::size_t ear = 0; ear < ears.ear_count(); ++ear) {
    std::ranges::copy(ears.path_ends(sample, ear), std::back_inserter(ends));
  }
  return ends;
}

}  // namespace

StraightAir::StraightAir(const scene::Acoustics& acoustics, const propagation::AudibleSurface& surface,
                         std::int64_t steady, parallel::Stages& stages, MPI_Comm communicator)
    : stages_(stages),
      communicator_(communicator),
      triangle_rows_(surface.triangle_ids, surface.global_triangles(), communicator),
      ears_(acoustics, steady + 1, surface.triangles.size()) {
  if (BodyFrames::needed(acoustics)) {
    if (surface.fade_step > 0.0) {
      throw std::runtime_error(
          "a listener cannot be attached to a body while the triangles of a recording change over time");
    }
    frames_ = std::make_unique<BodyFrames>(acoustics, surface, communicator_);
    ears_.attach(*frames_);
  }
  if (acoustics.radiation.visibility) {
    const LineOfSight::Options options = sight_options(acoustics, ears_);
    if (can_be_hidden(surface, options)) {
      line_of_sight_.emplace(surface, options, communicator_);
    }
  }
}

void StraightAir::start(std::int64_t sample, const surface::SurfaceMotion& steady) {
  if (line_of_sight_) {
    line_of_sight_->start(steady, ends(ears_, *line_of_sight_, sample));
  }
}

void StraightAir::propagate(std::int64_t sample, const surface::Emission& emission,
                            const surface::SurfaceMotion& motion) {
  if (frames_ && frames_->due(sample)) {
    frames_->update(sample, motion);
  }
  if (line_of_sight_ && line_of_sight_->due(sample)) {
    const parallel::Stages::Scope stage(stages_, parallel::Stage::visibility);
    line_of_sight_->update(motion, ends(ears_, *line_of_sight_, sample));
  }
  const parallel::Stages::Scope stage(stages_, parallel::Stage::radiation);
  ears_.hear(sample, emission, line_of_sight_ ? &*line_of_sight_ : nullptr);
}

void StraightAir::archive(parallel::Archive& archive) {
  if (frames_) {
    frames_->archive(archive);
  }
  if (line_of_sight_) {
    line_of_sight_->archive(archive, triangle_rows_);
  }
  ears_.archive(archive, triangle_rows_);
}

}  // namespace idiophone::propagation
