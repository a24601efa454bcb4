#pragma once
// Which multiplet of a body each measured line is.

#include <utility>
#include <vector>

#include "frequency_model.hpp"
#include "idiophone/scene/material.hpp"
#include "idiophone/study/fitting/measurements.hpp"

namespace idiophone::fitting {

/// Pairs of a line and its multiplet, by their numbers; false lines are left out.
using LinePairs = std::vector<std::pair<std::size_t, std::size_t>>;

struct Assignment {
  LinePairs pairs;
  double cost = 0.0;  ///< as match() counts it
};

/// The cheapest assignment of lines to the multiplets of a body of this material.
/// @param lines      ascending
/// @param tolerance  the largest distance of a line from its multiplet, cents
[[nodiscard]] Assignment assign(const std::vector<Line>& lines, const FrequencyModel& model,
                                const TurnedMaterial& material, double tolerance);

/// Cents by which all frequencies of the body may have to rise, the likeliest first, as likely_shifts() finds them.
[[nodiscard]] std::vector<double> common_shifts(const std::vector<Line>& lines, const FrequencyModel& model,
                                                const TurnedMaterial& material, double largest, int most);

}  // namespace idiophone::fitting
