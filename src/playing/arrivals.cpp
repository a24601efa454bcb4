#include "arrivals.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "resonator_bank.hpp"

namespace idiophone::playing {

Arrivals::Arrivals(double longest_delay)
    : spreading_(&listening::Spreading::band_limited()),
      longest_delay_(longest_delay),
      ring_(std::bit_ceil(static_cast<std::size_t>(std::ceil(longest_delay)) + spreading_->width() +
                          ResonatorBank::most_samples)) {}

void Arrivals::add(std::int64_t sample, double pressure, double delay) {
  const double limited = std::clamp(delay, nearest(), longest_delay_);
  const listening::Spreading::ArrivalCell cell = listening::Spreading::cell_of(limited);
  const auto first = static_cast<std::size_t>(sample + cell.before + spreading_->first());
  const std::size_t mask = ring_.size() - 1;
  for (std::size_t group = 0; group < spreading_->width() / lane_count; ++group) {
    const Lanes4 weights = spreading_->sound(cell, group);
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      ring_[(first + group * lane_count + lane) & mask] += pressure * weights[lane];
    }
  }
}

double Arrivals::take(std::int64_t sample) {
  return std::exchange(ring_[static_cast<std::size_t>(sample) & (ring_.size() - 1)], 0.0);
}

}  // namespace idiophone::playing
