#pragma once
// How well lines determine the constants of a material.

#include <Eigen/Core>
#include <vector>

#include "matched_fit.hpp"

namespace idiophone::fitting {

inline constexpr double undetermined = 0.1;  ///< a 95 % half-width of ln of a modulus, or of a ratio, above this

/// Chi-squared over its degrees of freedom that 95 % are below; Abramowitz and Stegun, 26.4.17. Within 4 % from 1
/// degree of freedom on.
[[nodiscard]] double largest_by_chance(double freedom);

/// Chi-squared that 99.9 % are below, by the same formula. Within 4 % from 1 degree of freedom on.
[[nodiscard]] double largest_believable(double freedom);

/// Student's t that 97.5 % are below; Abramowitz and Stegun, 26.7.5. Within 3 % from 2 degrees of freedom on.
[[nodiscard]] double student_t(double freedom);

/// What the lines say.
struct Evidence {
  Eigen::VectorXd residuals;    ///< of a fit, over the lines' uncertainties; [lines]
  Eigen::MatrixXd slopes;       ///< their derivatives by the unknowns of all constants, [lines x constants]
  Eigen::VectorXd mesh_errors;  ///< of the lines' modes, over the lines' uncertainties; [lines]
};

/// What a line of each multiplet of a model would say, if all were measured where they are computed.
/// @param uncertainty  of a line, cents; the error of the mesh is added to it
/// @param mesh_errors  [multiplets] cents
[[nodiscard]] Evidence imagined_lines(const FrequencyModel& model, const ElasticConstants& constants,
                                      const TurnedMaterial& material, double uncertainty,
                                      const std::vector<double>& mesh_errors);

/// How far the residuals of a fit spread the constants.
struct ResidualSpread {
  double variance = 1.0;  ///< of the residuals, s^2
  double t = 0.0;         ///< half-width of a 95 % interval over the deviation
};

/// The lines are as uncertain as they are said to be, s = 1 and t = 1.96, unless the residuals are larger than in 95 %
/// of such fits (chi-squared). Then s^2 is the mean square of the residuals per degree of freedom, and t is Student's.
/// The lines take the trace of (J^T J + 1/d^2)^-1 J^T J degrees of freedom for the constants.
[[nodiscard]] ResidualSpread residual_spread(const Evidence& evidence, const Expectation& expected);

/// Half-widths of the 95 % intervals of values that depend on the unknowns of all constants, those that keep their
/// values included: t times the root of the diagonal of G V G^T, with V = (J^T J/s^2 + 1/d^2)^-1, and of the square of
/// G V J^T e/s^2. G are the derivatives of the values by the unknowns. d are the expected deviations: a constant that
/// the lines do not show is uncertain by d, and makes the others uncertain. e are the mesh's errors, which are of one
/// sign, so that many lines do not make them smaller.
/// @param residuals       of the lines that were fitted; a line that is only imagined does not change it
/// @param value_slopes  G, [values x constants]
[[nodiscard]] Eigen::VectorXd half_widths(const Evidence& evidence, const ResidualSpread& residuals,
                                          const Expectation& expected, const Eigen::MatrixXd& value_slopes);

}  // namespace idiophone::fitting
