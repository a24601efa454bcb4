#include "idiophone/listening/spreading.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <numbers>

namespace idiophone::listening {

namespace {

constexpr double highest = 0.8 * std::numbers::pi;  // angular frequency per sample

/// Integral of cos(f x) over f from 0 to `highest`.
double cosine_moment(double x) {
  const double square = std::pow(highest * x, 2);
  return square < 1e-6 ? highest * (1.0 - square / 6.0 * (1.0 - square / 20.0)) : std::sin(highest * x) / x;
}

/// Integral of f sin(f x) over f from 0 to `highest`.
double sine_moment(double x) {
  const double angle = highest * x;
  const double square = angle * angle;
  return square < 1e-4 ? highest * highest * angle / 3.0 * (1.0 - square / 10.0 * (1.0 - square / 28.0))
                       : (std::sin(angle) - angle * std::cos(angle)) / (x * x);
}

}  // namespace

std::vector<double> gaussian_splat(double fraction) {
  std::vector<double> offset, gaussian, weights;
  double moment0 = 0.0, moment1 = 0.0, moment2 = 0.0;
  for (std::size_t tap = 0; tap < lane_count; ++tap) {
    offset.push_back(static_cast<double>(tap) - 1.0 - fraction);
    gaussian.push_back(std::exp(-2.0 * offset[tap] * offset[tap]));
    moment0 += gaussian[tap];
    moment1 += gaussian[tap] * offset[tap];
    moment2 += gaussian[tap] * offset[tap] * offset[tap];
  }
  const double determinant = moment0 * moment2 - moment1 * moment1;
  for (std::size_t tap = 0; tap < lane_count; ++tap) {
    weights.push_back(gaussian[tap] * (moment2 - moment1 * offset[tap]) / determinant);
  }
  return weights;
}

std::vector<double> least_squares_spreading(double fraction, std::size_t width, int derivative) {
  // Normal equations with multipliers for the two conditions.
  const auto taps = static_cast<Eigen::Index>(width);
  const Eigen::Index first = 1 - taps / 2;
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(taps + 2, taps + 2);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(taps + 2);
  for (Eigen::Index row = 0; row < taps; ++row) {
    const double x = static_cast<double>(row + first) - fraction;
    for (Eigen::Index column = 0; column < taps; ++column) {
      normal(row, column) = cosine_moment(static_cast<double>(row - column));
    }
    normal.col(taps)[row] = normal.row(taps)[row] = 1.0;
    normal.col(taps + 1)[row] = normal.row(taps + 1)[row] = x;
    right[row] = derivative == 0 ? cosine_moment(x) : -sine_moment(x);
  }
  right[taps + derivative] = derivative == 0 ? 1.0 : -1.0;
  const Eigen::VectorXd solution = normal.partialPivLu().solve(right);
  return {solution.begin(), solution.begin() + taps};
}

const Spreading& Spreading::splat() {
  static const Spreading spreading(1, gaussian_splat, {});
  return spreading;
}

const Spreading& Spreading::band_limited() {
  constexpr std::size_t groups = 3;
  const auto formula = [](int derivative) {
    return [=](double fraction) { return least_squares_spreading(fraction, groups * lane_count, derivative); };
  };
  static const Spreading spreading(groups, formula(0), formula(1));
  return spreading;
}

Spreading::Spreading(std::size_t groups, const Formula& sound, const Formula& change) : groups_(groups) {
  sound_ = tabulate(sound);
  if (change) {
    change_ = tabulate(change);
  }
}

std::vector<Spreading::Cubic> Spreading::tabulate(const Formula& formula) const {
  constexpr double step = 1.0 / cells;
  constexpr double tiny = step / 8.0;
  std::vector<Cubic> table;
  for (int cell = 0; cell < cells; ++cell) {
    const double begin = cell * step;
    std::array<std::vector<double>, 5> about_begin, about_end;
    for (std::size_t i = 0; i < about_begin.size(); ++i) {
      about_begin[i] = formula(begin + tiny * (static_cast<double>(i) - 2.0));
      about_end[i] = formula(begin + step + tiny * (static_cast<double>(i) - 2.0));
    }
    for (std::size_t group = 0; group < groups_; ++group) {
      const auto value = [&](const auto& about, std::size_t i) { return load(&about[i][lane_count * group]); };
      // Over one cell, by a difference of fourth order: keeps sums and centroids exact, as any linear rule does.
      const auto slope = [&](const auto& about) {
        return (8.0 * (value(about, 3) - value(about, 1)) - (value(about, 4) - value(about, 0))) *
               (step / (12.0 * tiny));
      };
      const Lanes4 rise = value(about_end, 2) - value(about_begin, 2);
      table.push_back({value(about_begin, 2), slope(about_begin),
                       3.0 * rise - 2.0 * slope(about_begin) - slope(about_end),
                       slope(about_begin) + slope(about_end) - 2.0 * rise});
    }
  }
  return table;
}

}  // namespace idiophone::listening
