#include "idiophone/study/levels/loudness.hpp"

#include <ebur128.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace idiophone::levels {

namespace {

struct EndMeter {
  void operator()(ebur128_state* meter) const { ebur128_destroy(&meter); }
};
using Meter = std::unique_ptr<ebur128_state, EndMeter>;

/// What the meter answers, if it does, and if it is not silence.
template <class Read>
std::optional<double> answer(const Read& read) {
  double value = 0.0;
  return read(&value) == EBUR128_SUCCESS && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// The largest of all channels.
std::optional<double> true_peak(ebur128_state* meter) {
  double largest = 0.0;
  for (unsigned channel = 0; channel < meter->channels; ++channel) {
    largest = std::max(largest,
                       answer([&](double* value) { return ebur128_true_peak(meter, channel, value); }).value_or(0.0));
  }
  return largest > 0.0 ? std::optional(20.0 * std::log10(largest)) : std::nullopt;
}

}  // namespace

Loudness loudness_of(const std::vector<std::vector<double>>& channels, double rate, double full_scale) {
  const Meter meter(ebur128_init(static_cast<unsigned>(channels.size()), static_cast<unsigned long>(std::lround(rate)),
                                 EBUR128_MODE_I | EBUR128_MODE_LRA | EBUR128_MODE_TRUE_PEAK));
  if (!meter) {
    return {};
  }
  std::vector<double> frames;
  for (std::size_t sample = 0; sample < channels.front().size(); ++sample) {
    for (const std::vector<double>& channel : channels) {
      frames.push_back(channel[sample] / full_scale);
    }
  }
  if (ebur128_add_frames_double(meter.get(), frames.data(), channels.front().size()) != EBUR128_SUCCESS) {
    throw std::runtime_error("libebur128 has no memory for the sound");
  }
  constexpr double shortest_range = 3.0;  // s, the window of short-term loudness
  const bool is_long = static_cast<double>(channels.front().size()) >= shortest_range * rate;
  return {.integrated = answer([&](double* value) { return ebur128_loudness_global(meter.get(), value); }),
          .range = is_long ? answer([&](double* value) { return ebur128_loudness_range(meter.get(), value); })
                           : std::nullopt,
          .true_peak = true_peak(meter.get())};
}

}  // namespace idiophone::levels
