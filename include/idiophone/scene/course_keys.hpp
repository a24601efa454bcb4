#pragma once
// Courses, as decks and scores have them.

#include "idiophone/foundation/deck/section.hpp"
#include "idiophone/scene/course.hpp"

namespace idiophone::scene {

/// A number, or a list of points [time, number].
struct CourseRule {
  deck::Range range;
  double longest;  ///< time of a point, s
};

bool read(const deck::Node& node, deck::Mistakes& mistakes, Course& course, const CourseRule& rule);

}  // namespace idiophone::scene
