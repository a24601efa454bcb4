#include "idiophone/air/receivers/spreading.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "idiophone/foundation/dense/dense.hpp"

namespace idiophone::receivers {

namespace {

using std::numbers::pi;

// The kernel of kaiser_bessel_spreading().
constexpr double kernel_half_width = 4.0;  // entries
constexpr double kernel_shape = 20.0;      // a little above 2.3 for each entry of its width: ends more smoothly
constexpr int kernel_density = 2;          // entries in an audio sample

constexpr int filter_half_width = 40;  // audio samples, of the filters behind it

/// Weights kernel(x) (a + b x), x from the arrival: their sum is one and their centroid is the arrival.
template <class Kernel>
std::vector<double> centred_weights(double fraction, std::size_t width, const Kernel& kernel) {
  const double before = 0.5 * static_cast<double>(width) - 1.0;
  std::vector<double> offset, values, weights;
  double moment0 = 0.0, moment1 = 0.0, moment2 = 0.0;
  for (std::size_t tap = 0; tap < width; ++tap) {
    offset.push_back(static_cast<double>(tap) - before - fraction);
    values.push_back(kernel(offset[tap]));
    moment0 += values[tap];
    moment1 += values[tap] * offset[tap];
    moment2 += values[tap] * offset[tap] * offset[tap];
  }
  const double determinant = moment0 * moment2 - moment1 * moment1;
  for (std::size_t tap = 0; tap < width; ++tap) {
    weights.push_back(values[tap] * (moment2 - moment1 * offset[tap]) / determinant);
  }
  return weights;
}

/// I0(shape sqrt(1 - (x/half width)^2)), continued beyond the ends.
double kaiser_bessel_window(double x) {
  const double square = 1.0 - std::pow(x / kernel_half_width, 2);
  return square >= 0 ? std::cyl_bessel_i(0.0, kernel_shape * std::sqrt(square))
                     : std::cyl_bessel_j(0.0, kernel_shape * std::sqrt(-square));
}

/// The Fourier transform of the kernel, 1 at frequency 0.
/// @param frequency  in cycles per audio sample, up to 1
double kernel_spectrum(double frequency) {
  const double angle = 2.0 * pi * frequency / kernel_density * kernel_half_width;
  const double root = std::sqrt(kernel_shape * kernel_shape - angle * angle);
  return (std::sinh(root) / root) / (std::sinh(kernel_shape) / kernel_shape);
}

/// The symmetric filter on entries that undoes the kernel up to `passed` and stops what is above `stopped`, in least
/// squares over both bands: half of it, from the middle on.
std::vector<double> inverse_low_pass() {
  constexpr double passed = 0.455, stopped = 0.545;  // cycles per audio sample
  constexpr Eigen::Index unknowns = kernel_density * filter_half_width + 1, rows_of_band = 400;
  Eigen::MatrixXd cosines(2 * rows_of_band, unknowns);
  Eigen::VectorXd wanted = Eigen::VectorXd::Zero(2 * rows_of_band);
  for (Eigen::Index row = 0; row < 2 * rows_of_band; ++row) {
    const bool passes = row < rows_of_band;
    const double place = static_cast<double>(row % rows_of_band) / (rows_of_band - 1);
    const double highest = 0.5 * kernel_density;
    const double frequency = passes ? passed * place : stopped + (highest - stopped) * place;
    const double weight = passes ? kernel_spectrum(frequency) : 1.0;
    for (Eigen::Index m = 0; m < unknowns; ++m) {
      cosines(row, m) =
          weight * (m == 0 ? 1.0 : 2.0) * std::cos(2.0 * pi * frequency / kernel_density * static_cast<double>(m));
    }
    wanted[row] = passes ? kernel_density : 0.0;
  }
  const Eigen::VectorXd solution = dense::least_squares(cosines, wanted);
  return {solution.begin(), solution.end()};
}

/// See Spreading::entries_to_samples(). Each filter's sum is one, so that constants and ramps stay exact.
std::vector<std::vector<double>> inverse_filters() {
  const std::vector<double> half = inverse_low_pass();
  std::vector<std::vector<double>> filters;
  for (int d = 0; d < kernel_density; ++d) {
    std::vector<double>& filter = filters.emplace_back();
    for (int k = 0; k <= 2 * filter_half_width; ++k) {
      const auto from_middle = static_cast<std::size_t>(std::abs(kernel_density * (k - filter_half_width) - d));
      filter.push_back(from_middle < half.size() ? half[from_middle] : 0.0);
    }
    const double sum = std::accumulate(filter.begin(), filter.end(), 0.0);
    std::ranges::for_each(filter, [sum](double& tap) { tap /= sum; });
  }
  return filters;
}

}  // namespace

std::vector<double> gaussian_splat(double fraction) {
  return centred_weights(fraction, lane_count, [](double x) { return std::exp(-2.0 * x * x); });
}

std::vector<double> kaiser_bessel_spreading(double fraction) {
  return centred_weights(fraction, 2 * lane_count, kaiser_bessel_window);
}

const Spreading& Spreading::splat() {
  static const Spreading spreading(1, gaussian_splat, {{1.0}}, 0.0);
  return spreading;
}

const Spreading& Spreading::band_limited() {
  // A later arrival moves the weights to later entries, so the derivative has the opposite sign.
  static const Spreading spreading(2, kaiser_bessel_spreading, inverse_filters(), -kernel_density * cells);
  return spreading;
}

Spreading::Spreading(std::size_t groups, const Formula& formula, std::vector<std::vector<double>> filters, double slope)
    : groups_(groups), filters_(std::move(filters)), slope_(slope), table_(cells * 4 * width() / pack_size) {
  constexpr double step = 1.0 / cells;
  constexpr double tiny = step / 8.0;
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const double begin = static_cast<double>(cell) * step;
    std::array<std::vector<double>, 5> about_begin, about_end;
    for (std::size_t i = 0; i < about_begin.size(); ++i) {
      about_begin[i] = formula(begin + tiny * (static_cast<double>(i) - 2.0));
      about_end[i] = formula(begin + step + tiny * (static_cast<double>(i) - 2.0));
    }
    for (std::size_t group = 0; group < groups_; ++group) {
      const auto value = [&](const auto& about, std::size_t i) { return load(&about[i][lane_count * group]); };
      // Over one cell, by a difference of fourth order: keeps sums and centroids exact, as any linear rule does.
      const auto rise_of = [&](const auto& about) {
        return (8.0 * (value(about, 3) - value(about, 1)) - (value(about, 4) - value(about, 0))) *
               (step / (12.0 * tiny));
      };
      const Lanes4 rise = value(about_end, 2) - value(about_begin, 2);
      const std::array<Lanes4, 4> cubic = {value(about_begin, 2), rise_of(about_begin),
                                           3.0 * rise - 2.0 * rise_of(about_begin) - rise_of(about_end),
                                           rise_of(about_begin) + rise_of(about_end) - 2.0 * rise};
      for (std::size_t power = 0; power < cubic.size(); ++power) {
        put(cubic.at(power), table_.data()->values.data() + (4 * cell + power) * width() + lane_count * group);
      }
    }
  }
}

}  // namespace idiophone::receivers
