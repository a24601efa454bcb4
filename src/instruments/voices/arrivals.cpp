#include "idiophone/instruments/voices/arrivals.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "idiophone/instruments/resonators/resonator_bank.hpp"

namespace idiophone::voices {

Arrivals::Arrivals(double longest_delay)
    : spreading_(&receivers::Spreading::band_limited()),
      longest_delay_(longest_delay),
      ring_(std::bit_ceil(spreading_->density() *
                          (static_cast<std::size_t>(std::ceil(longest_delay)) + spreading_->lookahead() +
                           spreading_->width() + resonators::ResonatorBank::most_samples))) {}

double Arrivals::nearest() {
  const auto& spreading = receivers::Spreading::band_limited();
  return static_cast<double>(spreading.lookahead()) - static_cast<double>(spreading.first());
}

void Arrivals::add(std::int64_t sample, double pressure, double delay) {
  const auto density = static_cast<std::int64_t>(spreading_->density());
  const double limited = std::clamp(delay, nearest(), longest_delay_);
  const auto cell = receivers::Spreading::cell_of(static_cast<double>(density) * limited);
  const auto first = static_cast<std::size_t>(density * sample + cell.before + spreading_->first_entry());
  const std::size_t mask = ring_.size() - 1;
  for (std::size_t group = 0; group < spreading_->width() / lane_count; ++group) {
    const Lanes4 weights = spreading_->sound(cell, group);
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      ring_[(first + group * lane_count + lane) & mask] += pressure * weights[lane];
    }
  }
  const auto reach = static_cast<std::int64_t>(spreading_->width() + spreading_->lookahead());
  silent_from_ = std::max(silent_from_, sample + static_cast<std::int64_t>(limited) + reach);
}

double Arrivals::take(std::int64_t sample) {
  if (sample >= silent_from_) {
    return 0.0;
  }
  const auto& filters = spreading_->entries_to_samples();
  const std::size_t density = filters.size();
  const std::size_t mask = ring_.size() - 1;
  const std::size_t half = spreading_->lookahead();
  double sum = 0.0;
  for (std::size_t d = 0; d < density; ++d) {
    const std::size_t last = density * (static_cast<std::size_t>(sample) + half) + d;
    for (std::size_t k = 0; k <= 2 * half; ++k) {
      sum += filters[d][k] * ring_[(last - density * k) & mask];
    }
    ring_[(last - density * 2 * half) & mask] = 0.0;  // no later sample needs it
  }
  return sum;
}

}  // namespace idiophone::voices
