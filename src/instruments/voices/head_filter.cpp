#include "idiophone/instruments/voices/head_filter.hpp"

#include <algorithm>
#include <utility>

namespace idiophone::voices {

HeadFilter::HeadFilter(std::span<const double> responses)
    : taps_(responses.size() / 2),
      responses_(responses.begin(), responses.end()),
      next_(responses_),
      heard_(2 * taps_),
      silent_(taps_) {}

void HeadFilter::begin(std::span<const double> responses) {
  std::ranges::copy(responses, next_.begin());
}

void HeadFilter::end() {
  std::swap(responses_, next_);
}

std::array<double, 2> HeadFilter::hear(double pressure, double share) {
  newest_ = (newest_ == 0 ? taps_ : newest_) - 1;
  heard_[newest_] = heard_[newest_ + taps_] = pressure;
  silent_ = pressure == 0.0 ? std::min(silent_ + 1, taps_) : 0;
  if (silent_ == taps_) {
    return {0.0, 0.0};
  }
  std::array<double, 2> ears{};
  for (std::size_t ear = 0; ear < 2; ++ear) {
    ears.at(ear) = convolved(std::span(responses_).subspan(ear * taps_, taps_));
    if (share > 0.0) {
      const double next = convolved(std::span(next_).subspan(ear * taps_, taps_));
      ears.at(ear) += share * (next - ears.at(ear));
    }
  }
  return ears;
}

double HeadFilter::convolved(std::span<const double> response) const {
  constexpr std::size_t lanes = 8;  // sums that do not wait for each other
  std::array<double, lanes> sums{};
  const std::span<const double> heard = std::span(heard_).subspan(newest_, taps_);
  for (std::size_t tap = 0; tap < taps_; ++tap) {
    sums[tap % lanes] += response[tap] * heard[tap];
  }
  double sum = 0.0;
  for (const double part : sums) {
    sum += part;
  }
  return sum;
}

}  // namespace idiophone::voices
