#include "idiophone/air/receivers/edge_filters.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "idiophone/air/radiation/bend.hpp"
#include "in_series.hpp"

namespace idiophone::receivers {

namespace {

constexpr double numbers_per_e_fold = 2.0;
constexpr double number_of_one_sample = 13.0;
constexpr int cells_per_sample = 16;

/// A windowed sinc that passes what is below half the audio rate; x in audio samples, half_width its end.
double low_pass(double x, double half_width) {
  constexpr double shape = 8.0;
  const double inside = 1.0 - std::pow(x / half_width, 2);
  if (inside <= 0.0) {
    return 0.0;
  }
  const double angle = std::numbers::pi * x;
  const double sinc = std::abs(angle) < 1e-9 ? 1.0 : std::sin(angle) / angle;
  return sinc * std::cyl_bessel_i(0.0, shape * std::sqrt(inside)) / std::cyl_bessel_i(0.0, shape);
}

/// The filters below and above a number with a fraction.
Crossfade between(double number) {
  const double below = std::min(std::floor(number), EdgeFilters::highest - 1.0);
  const auto filter = static_cast<std::int64_t>(below);
  return {FilterWeight{filter, 1.0 - (number - below)}, {filter + 1, number - below}};
}

}  // namespace

double EdgeFilters::number_of(double delay) {
  const double number = number_of_one_sample + numbers_per_e_fold * std::log(delay);
  return std::clamp(number, lowest, highest);  // also of no delay
}

std::vector<FilterWeight> EdgeFilters::filters_of(const WavesInTurn& waves) const {
  std::vector<FilterWeight> filters = {{0, 1.0}};
  std::int64_t factor = 1;
  for (std::size_t edge = 0; edge < in_turn_; ++edge) {
    std::vector<FilterWeight> longer;
    for (const FilterWeight& filter : filters) {
      for (const auto& [gain, number] : waves.at(edge)) {
        for (const FilterWeight& next : between(number)) {
          if (gain * next.weight != 0.0) {
            longer.push_back({filter.number + factor * next.number, filter.weight * gain * next.weight});
          }
        }
      }
    }
    filters = std::move(longer);
    factor *= single_filters;
  }
  return filters;
}

std::vector<double> EdgeFilters::response(std::int64_t number) const {
  std::vector<double> taps = single_response(number % single_filters);
  for (std::size_t edge = 1; edge < in_turn_; ++edge) {
    number /= single_filters;
    taps = in_series(taps, single_response(number % single_filters));
  }
  return taps;
}

std::vector<double> EdgeFilters::single_response(std::int64_t number) const {
  std::vector<double> taps(single_taps());
  if (number == 0) {
    taps[half_kernel] = 1.0;
    return taps;
  }
  const double delay = std::exp((static_cast<double>(number) - number_of_one_sample) / numbers_per_e_fold);
  std::vector<double> kernel(2 * half_kernel * cells_per_sample + 1);  // at all distances from a cell's middle to a tap
  for (std::size_t i = 0; i < kernel.size(); ++i) {
    kernel[i] = low_pass((static_cast<double>(i) + 0.5) / cells_per_sample - half_kernel, half_kernel);
  }
  // Cell j covers the time from j/cells_per_sample on; its content goes to the taps around its middle.
  double before = 0.0;
  for (std::size_t cell = 0; cell < taps_ * cells_per_sample; ++cell) {
    const double end = static_cast<double>(cell + 1) / cells_per_sample;
    const double after = radiation::edge_response(end, delay);
    const double fade =
        0.5 + 0.5 * std::cos(std::numbers::pi * std::max(0.0, 4.0 * end / static_cast<double>(taps_) - 3.0));
    const std::size_t sample = cell / cells_per_sample;
    const std::size_t within = cell % cells_per_sample;
    for (std::size_t k = 0; k < 2 * half_kernel && sample + k + 1 < taps.size(); ++k) {
      const std::size_t place = k * cells_per_sample + (cells_per_sample - 1 - within);
      taps[sample + k + 1] += fade * (after - before) * kernel[place];
    }
    before = after;
  }
  return taps;
}

}  // namespace idiophone::receivers
