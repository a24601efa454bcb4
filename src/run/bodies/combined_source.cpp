#include "idiophone/run/bodies/combined_source.hpp"

#include <algorithm>
#include <iterator>

namespace idiophone::bodies {

namespace {

propagation::AudibleSurface joined_surface(const std::vector<std::unique_ptr<Source>>& sources) {
  std::vector<const propagation::AudibleSurface*> surfaces;
  std::ranges::transform(sources, std::back_inserter(surfaces), [](const auto& source) { return &source->surface(); });
  return propagation::joined(surfaces);
}

}  // namespace

CombinedSource::CombinedSource(std::vector<std::unique_ptr<Source>> sources) : Source(joined_surface(sources)) {
  first_sample_ = sources.front()->first_sample();
  for (auto& source : sources) {
    first_sample_ = std::min(first_sample_, source->first_sample());
    sources_.push_back({std::move(source), {}});
  }
  sample_ = first_sample_;
}

void CombinedSource::couple(propagation::AirLoad& air) {
  for (const auto& one : sources_) {
    one.source->couple(air);
  }
}

void CombinedSource::start(surface::SurfaceMotion& motion) {
  for (auto& [source, motion_of_source] : sources_) {
    source->start(motion_of_source);
  }
  join(motion);
}

void CombinedSource::advance(surface::SurfaceMotion& motion) {
  ++sample_;
  for (auto& [source, motion_of_source] : sources_) {
    if (sample_ > source->first_sample()) {
      source->advance(motion_of_source);
    }
  }
  join(motion);
}

void CombinedSource::join(surface::SurfaceMotion& motion) const {
  const std::size_t vertices = surface().reference.size();
  motion.pressure.assign(padded(surface().triangles.size()), 0.0);
  motion.position.assign(surface::SurfaceMotion::position_length(vertices), 0.0);
  motion.radii.clear();
  if (std::ranges::any_of(sources_, [](const MovingSource& one) { return !one.motion.radii.empty(); })) {
    for (const auto& [source, motion_of_source] : sources_) {
      const std::vector<double>& radii = motion_of_source.radii;
      std::ranges::copy(radii.empty() ? source->surface().radii : radii, std::back_inserter(motion.radii));
    }
  }
  auto pressure = motion.pressure.begin();
  auto position = motion.position.begin();
  for (const auto& [source, motion_of_source] : sources_) {
    pressure = std::copy_n(motion_of_source.pressure.begin(), source->surface().triangles.size(), pressure);
    position = std::copy_n(motion_of_source.position.begin(), 3 * source->surface().reference.size(), position);
  }
}

std::vector<ChannelGroup*> CombinedSource::channels() {
  std::vector<ChannelGroup*> all;
  for (const auto& one : sources_) {
    std::ranges::copy(one.source->channels(), std::back_inserter(all));
  }
  return all;
}

void CombinedSource::check() {
  for (const auto& one : sources_) {
    one.source->check();
  }
}

void CombinedSource::archive(parallel::Archive& archive) {
  archive.root("source/sample", sample_);
  for (const auto& one : sources_) {
    one.source->archive(archive);
  }
}

std::int64_t CombinedSource::samples_before_archive() const {
  std::int64_t samples = 0;
  for (const auto& one : sources_) {
    samples = std::max(samples, one.source->first_sample() - first_sample_ + one.source->samples_before_archive());
  }
  return samples;
}

void CombinedSource::report() const {
  for (const auto& one : sources_) {
    one.source->report();
  }
}

}  // namespace idiophone::bodies
