#include "masking_threshold.hpp"

#include <algorithm>
#include <cmath>

namespace idiophone::voices {

namespace {

constexpr double bark_of_bin = 1.0 / MaskingThreshold::bins_in_bark;

/// Factor of a power over one bin. @param slope  dB/Bark
double over_a_bin(double slope) {
  return std::pow(10.0, -0.1 * slope * bark_of_bin);
}

/// Level by which a tone must be weaker to be hidden by one of the same pitch, as a factor of the power.
const std::array<double, MaskingThreshold::bins>& masking_indices() {
  static const auto indices = [] {
    std::array<double, MaskingThreshold::bins> of_bins{};
    for (std::size_t bin = 0; bin < of_bins.size(); ++bin) {
      of_bins.at(bin) = std::pow(10.0, 0.1 * (-1.525 - 0.275 * bark_of_bin * static_cast<double>(bin) - 4.5));
    }
    return of_bins;
  }();
  return indices;
}

/// dB above 20 µPa, within the levels for which the slopes are made: quiet sounds are usually played louder.
double level_of(double power) {
  constexpr double reference = 4e-10;  // Pa^2
  return std::clamp(10.0 * std::log10(power / reference), 40.0, 100.0);
}

}  // namespace

std::size_t MaskingThreshold::bin_of(double frequency) {
  const double bark = 13.0 * std::atan(0.00076 * frequency) + 3.5 * std::atan(std::pow(frequency / 7500.0, 2));
  return std::min(static_cast<std::size_t>(bark * bins_in_bark), bins - 1);
}

/// 3 Bark down and 8 Bark up. The slope of the first Bark differs from that of the others on both sides.
void MaskingThreshold::add(std::size_t bin, double power) {
  static const double steep = over_a_bin(17.0);
  const double level = level_of(power);
  const double near_below = over_a_bin(0.4 * level + 6.0), far_above = over_a_bin(17.0 - 0.15 * level);
  const double own = power * masking_indices().at(bin);
  double hidden = own;
  for (std::size_t step = 0; step < 3 * bins_in_bark && step <= bin; ++step) {
    threshold_[bin - step] += hidden;
    hidden *= step < bins_in_bark ? near_below : steep;
  }
  hidden = own;
  for (std::size_t step = 1; step < 8 * bins_in_bark && bin + step < bins; ++step) {
    hidden *= step <= bins_in_bark ? steep : far_above;
    threshold_[bin + step] += hidden;
  }
}

}  // namespace idiophone::voices
