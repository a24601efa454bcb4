// Bows.

#include "course_keys.hpp"
#include "idiophone/scene/ranges.hpp"
#include "idiophone/scene/sections.hpp"

namespace idiophone::score {

using namespace deck;  // values, keys and sections

namespace {

struct FrictionKeys {};

bool read(const Node& node, Mistakes& mistakes, Friction& friction, const FrictionKeys& /*rule*/) {
  constexpr Range coefficient{.above = 0.0, .at_most = 10.0};
  constexpr Range per_speed{.at_least = 0.0, .at_most = 1e6, .unit = "N s/m"};
  Section section(node, mistakes);
  const bool has_sticking = section.optional("sticking", friction.sticking, coefficient);
  if (section.optional("sliding", friction.sliding, coefficient) && has_sticking &&
      friction.sliding > friction.sticking) {
    mistakes.add(node, fmt::format("the coefficient of sliding, {}, is above that of sticking, {}", friction.sliding,
                                   friction.sticking));
  }
  section.optional("stribeck_speed", friction.stribeck_speed, Range{.at_least = 1e-6, .at_most = 1e3, .unit = "m/s"});
  section.optional("stiffness", friction.stiffness, Range{.at_least = 1.0, .at_most = 1e12, .unit = "N/m"});
  section.optional("damping", friction.damping, per_speed);
  section.optional("viscosity", friction.viscosity, per_speed);
  section.optional("break_away", friction.break_away, Range{.at_least = 0.0, .at_most = 0.99});
  return section.finish();
}

}  // namespace

void read_bow(Section& section, Bow& bow) {
  section.required("at", bow.at, scene::coordinate);
  section.required("direction", bow.direction, scene::unit_vector);
  section.required("speed", bow.speed, CourseRule{{.at_least = -1e3, .at_most = 1e3, .unit = "m/s"}});
  section.required("load", bow.load, CourseRule{{.at_least = 0.0, .at_most = 1e6, .unit = "N"}});
  section.optional("friction", bow.friction, FrictionKeys{});
}

}  // namespace idiophone::score
