#pragma once
// Numbers that change over time, as scores have them.

#include "actions.hpp"

namespace idiophone::score {

/// A number, or a list of points [time, number].
struct CourseRule {
  deck::Range range;
  double longest = longest_force;  ///< time of a point, s
};

bool read(const deck::Node& node, deck::Mistakes& mistakes, Course& course, const CourseRule& rule);

}  // namespace idiophone::score
