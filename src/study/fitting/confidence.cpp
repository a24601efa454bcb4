#include "confidence.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace idiophone::fitting {

namespace {

constexpr double gaussian = 1.959964;  // 97.5 % of a normal distribution are below

/// Chi-squared over its degrees of freedom that is as unlikely as normal errors above z.
double chi_squared_over_freedom(double freedom, double z) {
  const double part = 2 / (9 * freedom);
  return std::pow(1 - part + z * std::sqrt(part), 3);
}

}  // namespace

double largest_by_chance(double freedom) {
  constexpr double z = 1.644854;  // 95 % of a normal distribution are below
  return chi_squared_over_freedom(freedom, z);
}

double largest_believable(double freedom) {
  constexpr double z = 3.090232;  // 99.9 %
  return freedom * chi_squared_over_freedom(freedom, z);
}

double student_t(double freedom) {
  constexpr double z = gaussian;
  const double z2 = z * z;
  return z * (1 + (z2 + 1) / (4 * freedom) + ((5 * z2 + 16) * z2 + 3) / (96 * freedom * freedom) +
              (((3 * z2 + 19) * z2 + 17) * z2 - 15) / (384 * freedom * freedom * freedom));
}

Evidence imagined_lines(const FrequencyModel& model, const ElasticConstants& constants, const TurnedMaterial& material,
                        double uncertainty, const std::vector<double>& mesh_errors) {
  const auto lines = static_cast<Eigen::Index>(mesh_errors.size());
  const Eigen::Map<const Eigen::ArrayXd> errors(mesh_errors.data(), lines);
  const Eigen::ArrayXd uncertainties = (uncertainty * uncertainty + errors.square()).sqrt();
  const Eigen::MatrixXd slopes = -model.cents_slopes(constants, material);
  return {Eigen::VectorXd::Zero(lines), slopes.array().colwise() / uncertainties, errors / uncertainties};
}

ResidualSpread residual_spread(const Evidence& evidence, const Expectation& expected) {
  const Eigen::MatrixXd of_lines = evidence.slopes.transpose() * evidence.slopes;
  const Eigen::MatrixXd of_expectation = expected.deviation.cwiseAbs2().cwiseInverse().asDiagonal();
  const double determined = Eigen::MatrixXd(of_lines + of_expectation).ldlt().solve(of_lines).trace();
  const double freedom = std::max(1.0, static_cast<double>(evidence.slopes.rows()) - determined);
  const double mean_square = evidence.residuals.squaredNorm() / freedom;
  return mean_square <= largest_by_chance(freedom) ? ResidualSpread{1.0, gaussian}
                                                   : ResidualSpread{mean_square, student_t(freedom)};
}

Eigen::VectorXd half_widths(const Evidence& evidence, const ResidualSpread& residuals, const Expectation& expected,
                            const Eigen::MatrixXd& value_slopes) {
  const Eigen::MatrixXd of_lines = evidence.slopes.transpose() * evidence.slopes / residuals.variance;
  const Eigen::MatrixXd of_expectation = expected.deviation.cwiseAbs2().cwiseInverse().asDiagonal();
  const Eigen::LDLT<Eigen::MatrixXd> factors = Eigen::MatrixXd(of_lines + of_expectation).ldlt();
  const Eigen::MatrixXd spread = factors.solve(value_slopes.transpose());  // V G^T
  const Eigen::VectorXd variances = value_slopes.cwiseProduct(spread.transpose()).rowwise().sum();
  const Eigen::VectorXd shifts =
      spread.transpose() * evidence.slopes.transpose() * evidence.mesh_errors / residuals.variance;
  return residuals.t * (variances + shifts.cwiseAbs2()).cwiseSqrt();
}

}  // namespace idiophone::fitting
