#include "fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "idiophone/foundation/dense/nonlinear_least_squares.hpp"

namespace idiophone::partials {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The residuals and their Jacobian for the method of Levenberg and Marquardt. Each line has four parameters: the real
/// and imaginary part of its amplitude over that of the strongest line, the shift of its frequency and its damping. The
/// latter two are times the sound's length, so that a change by one shifts or broadens the line by about a bin.
class Residual {
 public:
  Residual(const LineSpectrum& line_spectrum, std::span<const Complex> target, BinRange band,
           const std::vector<Line>& start)
      : line_spectrum_(line_spectrum), target_(target), band_(band), start_(start) {
    for (const Line& line : start) {
      unit_ = std::max(unit_, std::abs(line.amplitude));
    }
    unit_ = unit_ > 0.0 ? unit_ : 1.0;
  }

  [[nodiscard]] int inputs() const { return static_cast<int>(4 * start_.size()); }
  [[nodiscard]] int values() const { return static_cast<int>(2 * band_.size()); }

  [[nodiscard]] VectorXd parameters() const {
    VectorXd result(inputs());
    for (std::size_t j = 0; j < start_.size(); ++j) {
      const Line& line = start_[j];
      result.segment<4>(first(j)) << line.amplitude.real() / unit_, line.amplitude.imag() / unit_, 0.0,
          line.damping * length();
    }
    return result;
  }

  [[nodiscard]] Line line(const VectorXd& parameters, std::size_t j) const {
    const auto own = parameters.segment<4>(first(j));
    return {.frequency = start_[j].frequency + own[2] / length(),
            .damping = own[3] / length(),
            .amplitude = {unit_ * own[0], unit_ * own[1]}};
  }

  [[nodiscard]] VectorXd at(const VectorXd& parameters) const {
    VectorXd residual(values());
    put(residual, target_, -1.0);
    VectorXd one(values());
    for (std::size_t j = 0; j < start_.size(); ++j) {
      put(one, line_spectrum_.spectrum(line(parameters, j), band_), 1.0);
      residual += one;
    }
    return residual;
  }

  [[nodiscard]] MatrixXd jacobian(const VectorXd& parameters) const {
    MatrixXd jacobian(values(), inputs());
    for (std::size_t j = 0; j < start_.size(); ++j) {
      const auto derivatives = line_spectrum_.derivatives(line(parameters, j), band_);
      put(jacobian.col(first(j)), derivatives.real, unit_);
      // The spectrum of a decay at zero frequency is insensitive to its phase and its frequency.
      const double swings = start_[j].frequency > 0.0 ? 1.0 : 0.0;
      put(jacobian.col(first(j) + 1), derivatives.imaginary, swings * unit_);
      put(jacobian.col(first(j) + 2), derivatives.frequency, swings / length());
      put(jacobian.col(first(j) + 3), derivatives.damping, 1.0 / length());
    }
    return jacobian;
  }

 private:
  [[nodiscard]] double length() const { return static_cast<double>(line_spectrum_.length()); }
  static Eigen::Index first(std::size_t j) { return static_cast<Eigen::Index>(4 * j); }

  /// Real parts, then imaginary parts, times a factor.
  static void put(Eigen::Ref<VectorXd> column, std::span<const Complex> bins, double factor) {
    const Eigen::Map<const Eigen::VectorXcd> values(bins.data(), static_cast<Eigen::Index>(bins.size()));
    column << factor * values.real(), factor * values.imag();
  }

  const LineSpectrum& line_spectrum_;
  std::span<const Complex> target_;
  BinRange band_;
  const std::vector<Line>& start_;
  double unit_ = 0.0;  ///< the largest amplitude at the start
};

Line with_positive_frequency(const Line& line) {
  if (line.frequency >= 0.0) {
    return line;
  }
  return {.frequency = -line.frequency, .damping = line.damping, .amplitude = std::conj(line.amplitude)};
}

}  // namespace

Fit fit_lines(const LineSpectrum& line_spectrum, std::span<const Complex> target, BinRange band,
              const std::vector<Line>& start, int most_iterations) {
  const Residual residual(line_spectrum, target, band, start);
  const VectorXd infinite = VectorXd::Constant(residual.inputs(), std::numeric_limits<double>::infinity());
  const dense::LeastSquares found =
      dense::minimize([&](const VectorXd& parameters) { return residual.at(parameters); },
                      [&](const VectorXd& parameters) { return residual.jacobian(parameters); }, residual.parameters(),
                      {-infinite, infinite}, {.step = 1e-11, .reduction = 1e-8, .iterations = most_iterations});
  Fit fit{.lines = {}, .iterations = found.iterations};
  for (std::size_t j = 0; j < start.size(); ++j) {
    fit.lines.push_back(with_positive_frequency(residual.line(found.point, j)));
  }
  return fit;
}

std::vector<Deviation> deviations(const LineSpectrum& line_spectrum, std::span<const Complex> target, BinRange band,
                                  const std::vector<Line>& lines) {
  const Residual residual(line_spectrum, target, band, lines);
  const VectorXd rest = residual.at(residual.parameters());
  const MatrixXd jacobian = residual.jacobian(residual.parameters());
  // Padding doubles the bins, so half of the values are independent, and each counts twice.
  const double freedom = std::max(0.5 * residual.values() - residual.inputs(), 1.0);
  const double variance = rest.squaredNorm() / freedom;
  const MatrixXd normal = jacobian.transpose() * jacobian;
  const VectorXd covariance = normal.ldlt().solve(MatrixXd::Identity(normal.rows(), normal.cols())).diagonal();
  const auto deviation = [&](std::size_t parameter) {
    const double square = variance * covariance[parameter];
    return square >= 0.0 ? std::sqrt(square) / static_cast<double>(line_spectrum.length())
                         : std::numeric_limits<double>::infinity();
  };
  std::vector<Deviation> result;
  for (std::size_t j = 0; j < lines.size(); ++j) {
    result.push_back({.frequency = deviation(4 * j + 2), .damping = deviation(4 * j + 3)});
  }
  return result;
}

}  // namespace idiophone::partials
