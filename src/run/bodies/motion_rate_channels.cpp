#include "idiophone/run/bodies/motion_rate_channels.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace idiophone::bodies {

namespace {

/// Audio samples between two rows; 0 for no rows.
std::int64_t samples_between_rows(const scene::Scene& scene) {
  const double wanted = scene.output.motion_per_second;
  return wanted > 0 ? std::max<std::int64_t>(1, std::llround(scene.audio.rate / wanted)) : 0;
}

std::vector<spectra::Series> at_motion_rate(const scene::Scene& scene, std::vector<spectra::Series> channels) {
  const std::int64_t samples = samples_between_rows(scene);
  if (samples == 0) {
    return {};
  }
  for (spectra::Series& channel : channels) {
    channel.rate = static_cast<double>(scene.audio.rate) / static_cast<double>(samples);
  }
  return channels;
}

}  // namespace

MotionRateChannels::MotionRateChannels(const scene::Scene& scene, std::vector<spectra::Series> channels)
    : ChannelGroup(at_motion_rate(scene, std::move(channels))),
      samples_per_row_(this->channels().empty() ? 0 : samples_between_rows(scene)) {}

void MotionRateChannels::note(std::int64_t sample) {
  if (samples_per_row_ > 0 && sample % samples_per_row_ == 0) {
    note_row();
  }
}

}  // namespace idiophone::bodies
