#include "friction_keys.hpp"

namespace idiophone::scene {

void read_law(deck::Section& section, friction::Law& law) {
  using deck::Range;
  constexpr Range coefficient{.above = 0.0, .at_most = 10.0};
  constexpr Range per_speed{.at_least = 0.0, .at_most = 1e6, .unit = "N s/m"};
  const bool has_sticking = section.optional("sticking", law.sticking, coefficient);
  if (section.optional("sliding", law.sliding, coefficient) && has_sticking && law.sliding > law.sticking) {
    section.mistakes().add(section.node(), fmt::format("the coefficient of sliding, {}, is above that of sticking, {}",
                                                       law.sliding, law.sticking));
  }
  section.optional("stribeck_speed", law.stribeck_speed, Range{.at_least = 1e-6, .at_most = 1e3, .unit = "m/s"});
  section.optional("stiffness", law.stiffness, Range{.at_least = 1.0, .at_most = 1e12, .unit = "N/m"});
  section.optional("damping", law.damping, per_speed);
  section.optional("viscosity", law.viscosity, per_speed);
  section.optional("break_away", law.break_away, Range{.at_least = 0.0, .at_most = 0.99});
}

}  // namespace idiophone::scene
