#pragma once
// Which other size of a specimen would tell constants that its own lines do not.

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "confidence.hpp"
#include "elastic_constants.hpp"
#include "idiophone/study/fitting/identification.hpp"
#include "strained_body.hpp"

namespace idiophone::fitting {

/// A specimen that was measured, and how its constants are known.
struct Specimen {
  const StrainedBody& body;
  const TurnedMaterial& material;
  const ElasticConstants& constants;
  const Expectation& expected;
  ResidualSpread residuals;
  double uncertainty = 0.0;  ///< of a line, cents; the errors of the mesh are added
  int modes = 0;             ///< whose lines are to be measured, the lowest; of one frequency, they are one line
};

struct FurtherSizes {
  std::vector<FurtherSize> named;    ///< by size
  std::vector<std::string> refused;  ///< sizes that can't be held or solved, and why
};

/// Makes each of the three sides 4 and 2 times longer and shorter, and looks at the intervals that the lowest lines of
/// these specimens would leave by themselves. For each constant, the size with the smallest interval counts if that is
/// no more than half of the one that is known. The errors of the mesh are estimated only there, because that may take
/// longer than the modes. Of a body that fills less than three quarters of its box, nothing is named: a bell or a tube
/// that is stretched along a side is none that could be had.
/// @param widths  half-widths of the intervals of the unknowns that are known; 0 for those that are wanted no smaller
/// @param watch   is called with 1 after each eigenvalue problem, with 0 after each estimate of the errors of the mesh,
///                and ends the search by an exception
[[nodiscard]] FurtherSizes further_sizes(const Specimen& specimen, const Eigen::VectorXd& widths,
                                         const std::function<void(int solves)>& watch);

}  // namespace idiophone::fitting
