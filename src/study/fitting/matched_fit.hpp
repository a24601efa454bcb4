#pragma once
// Elastic constants from lines and the modes of a body with similar constants: matches lines with modes and fits in
// turn.

#include <Eigen/Core>
#include <vector>

#include "assignment.hpp"
#include "elastic_constants.hpp"
#include "frequency_model.hpp"
#include "ties.hpp"

namespace idiophone::fitting {

/// What is expected of the unknowns before any line is looked at. [constants]
struct Expectation {
  Eigen::VectorXd middle;
  Eigen::VectorXd deviation;  ///< standard deviations
};

/// What is fitted to what.
struct FitProblem {
  const std::vector<Line>& lines;     ///< ascending
  const FrequencyModel& model;        ///< of the body with similar constants
  const ElasticConstants& constants;  ///< all of the material
};

struct FitRules {
  Ties ties;                              ///< what may change
  double tolerance = 0.0;                 ///< the largest distance of a line from its mode, cents
  const Expectation* expected = nullptr;  ///< counts as measurements of the constants; none: the lines alone count
};

struct MatchedFit {
  TurnedMaterial material;
  LinePairs pairs;    ///< none if no line has a mode
  double cost = 0.0;  ///< of the assignment
};

/// Constants with the least squares of the pairs' distances over the lines' uncertainties.
/// @param start  a stable material
[[nodiscard]] TurnedMaterial fit_pairs(const FitProblem& problem, const LinePairs& pairs, const TurnedMaterial& start,
                                       const FitRules& rules);

/// Matches and fits in turn from a material, until the assignment stays.
[[nodiscard]] MatchedFit fit_and_match(const FitProblem& problem, const TurnedMaterial& start, const FitRules& rules);

/// The same from several starts around a material. Where modes cross, fits end in one of several minima: the one of the
/// cheapest assignment is taken.
/// @param around  changes of each unknown, to and fro
[[nodiscard]] MatchedFit fit_around(const FitProblem& problem, const TurnedMaterial& start, const FitRules& rules,
                                    const std::vector<double>& around);

/// Distances of the lines above their modes over the lines' uncertainties. [pairs]
[[nodiscard]] Eigen::VectorXd line_residuals(const FitProblem& problem, const LinePairs& pairs,
                                             const TurnedMaterial& material);

/// Their derivatives by the unknowns of all constants. [pairs x constants]
[[nodiscard]] Eigen::MatrixXd line_slopes(const FitProblem& problem, const LinePairs& pairs,
                                          const TurnedMaterial& material);

}  // namespace idiophone::fitting
