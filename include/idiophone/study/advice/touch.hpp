#pragma once
// Where and when the two sides of a contact first touch, as far as that is known before a run.

#include <span>

#include "idiophone/foundation/types.hpp"
#include "idiophone/scene/solids.hpp"
#include "idiophone/solids/contact/contact_surfaces.hpp"

namespace idiophone::advice {

/// The nearest places of the two sides at the start.
struct Gap {
  double width = 0.0;                 ///< distance between them along the normal, m; 0 where they touch
  Vector3 across = Vector3::Zero();   ///< from the first body's place to the partner's, m
  Vector3 normal = Vector3::UnitZ();  ///< unit vector out of the partner there
};

/// The gap of a contact. Between two bodies it lies between their nearest nodes.
/// @param positions  [global nodes] undeformed, m
[[nodiscard]] Gap find_gap(const scene::Contact& contact, const contact::ContactSurfaces& surfaces,
                           std::span<const Vector3> positions);

/// When a contact can act.
struct TouchingTime {
  double begin = 0.0;       ///< s; not after the end of the run
  double duration = 0.0;    ///< the longest, s
  bool is_certain = false;  ///< whether the sides touch all that time: nothing parts them
  bool is_pressed = false;  ///< whether gravity presses a free body onto its partner, on which it bounces or lies
};

/// The part of the time in which a body touches what it bounces or lies on, at the most 1. A blow lasts as long as
/// sound travels forth and back through the body, 2 L/c, and a slow bounce of 0.02 m/s takes 2 v/g: g L/(c v). Hard
/// bodies that seem to lie still bounce like this, too.
/// @param acceleration  that presses it down, g, m/s2
/// @param extent        L, of the body, m
[[nodiscard]] double touching_share(const scene::Material& material, double acceleration, double extent);

/// From initial velocities and gravity, which bodies follow that nothing holds. Sides that gravity presses together
/// count from their first touch to the end: bouncing cannot be told from lying still. So do sides that loads, winds,
/// supports or drives move, from the start. Sides that only meet in flight count for 1 ms. Sides that touch at the
/// start and that gravity presses together, or that are held, stay together for certain.
/// @param no_gap    sides that are nearer than this touch, m
/// @param duration  of the run, s
[[nodiscard]] TouchingTime touching_time(const scene::Solids& solids, const scene::Contact& contact, const Gap& gap,
                                         double no_gap, double duration);

}  // namespace idiophone::advice
