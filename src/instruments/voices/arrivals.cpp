#include "idiophone/instruments/voices/arrivals.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "idiophone/foundation/lanes.hpp"
#include "idiophone/instruments/resonators/resonator_bank.hpp"

namespace idiophone::voices {

namespace {

constexpr std::size_t most_at_once = resonators::ResonatorBank::most_samples;

}  // namespace

Arrivals::Arrivals(double longest_delay)
    : spreading_(&receivers::Spreading::band_limited()),
      longest_delay_(longest_delay),
      ring_(std::bit_ceil(spreading_->density() * (static_cast<std::size_t>(std::ceil(longest_delay)) +
                                                   spreading_->lookahead() + spreading_->width() + most_at_once))),
      near_(most_at_once + 2 * spreading_->lookahead()) {}

double Arrivals::nearest() {
  const auto& spreading = receivers::Spreading::band_limited();
  return static_cast<double>(spreading.lookahead()) - static_cast<double>(spreading.first());
}

void Arrivals::add(std::int64_t sample, double pressure, double delay) {
  const auto density = static_cast<std::int64_t>(spreading_->density());
  const double limited = std::clamp(delay, nearest_, longest_delay_);
  const auto cell = receivers::Spreading::cell_of(static_cast<double>(density) * limited);
  const auto first = static_cast<std::size_t>(density * sample + cell.before + spreading_->first_entry());
  const std::size_t mask = ring_.size() - 1;
  for (std::size_t group = 0; group < spreading_->width() / lane_count; ++group) {
    const Lanes4 weights = spreading_->weights().sound(cell, group);
    const std::size_t place = (first + group * lane_count) & mask;
    if (place + lane_count <= ring_.size()) {
      put(load(&ring_[place]) + pressure * weights, &ring_[place]);
      continue;
    }
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      ring_[(place + lane) & mask] += pressure * weights[lane];
    }
  }
  const auto reach = static_cast<std::int64_t>(spreading_->width() + spreading_->lookahead());
  silent_from_ = std::max(silent_from_, sample + static_cast<std::int64_t>(limited) + reach);
}

void Arrivals::take(std::int64_t first, std::span<double> sound, std::size_t channels) {
  const std::size_t samples = (sound.size() + channels - 1) / channels;
  std::array<double, most_at_once> arrived;
  for (std::size_t done = 0; done < samples && first + static_cast<std::int64_t>(done) < silent_from_;) {
    const std::int64_t sample = first + static_cast<std::int64_t>(done);
    const auto count = static_cast<std::size_t>(std::min(
        {static_cast<std::int64_t>(samples - done), static_cast<std::int64_t>(most_at_once), silent_from_ - sample}));
    take_some(sample, std::span(arrived).first(count));
    for (std::size_t i = 0; i < count; ++i) {
      sound[(done + i) * channels] += arrived[i];
    }
    done += count;
  }
}

/// Four samples at once. The terms of each sample are added in the order of the filters, however many are taken.
/// @param sound  at most most_at_once samples
void Arrivals::take_some(std::int64_t first, std::span<double> sound) {
  const auto& filters = spreading_->entries_to_samples();
  const std::size_t density = filters.size();
  const std::size_t mask = ring_.size() - 1;
  const std::size_t half = spreading_->lookahead();
  const std::size_t in_lanes = (sound.size() + lane_count - 1) / lane_count * lane_count;
  std::array<double, most_at_once> sums{};
  for (std::size_t d = 0; d < density; ++d) {
    const std::size_t oldest = density * (static_cast<std::size_t>(first) - half) + d;
    for (std::size_t i = 0; i < in_lanes + 2 * half; ++i) {
      near_[i] = ring_[(oldest + density * i) & mask];
    }
    for (std::size_t i = 0; i < in_lanes; i += lane_count) {
      auto sum = load(&sums[i]);
      for (std::size_t k = 0; k <= 2 * half; ++k) {
        sum += filters[d][k] * load(&near_[i + 2 * half - k]);
      }
      put(sum, &sums[i]);
    }
    for (std::size_t i = 0; i < sound.size(); ++i) {
      ring_[(oldest + density * i) & mask] = 0.0;  // no later sample needs it
    }
  }
  std::copy_n(sums.begin(), sound.size(), sound.begin());
}

}  // namespace idiophone::voices
