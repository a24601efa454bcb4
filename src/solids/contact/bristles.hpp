#pragma once
// Friction with memory in two directions: the elasto-plastic law of foundation/friction with vectors for the deflection
// z and the velocity v,
//
//   z' = v - a |v| z/z_v,   force = stiffness z + damping z' + viscosity v,
//
// z_v and a those of the lengths |v| and |z|, a = 0 where z is against v. On a line it is that law. A step is implicit
// (Euler): the way of the step bends the bristles, and the force is that of their deflection after it. The loss, a
// stiffness |v| z^2/z_v, is never negative.

#include "idiophone/foundation/friction/law.hpp"
#include "idiophone/foundation/types.hpp"

namespace idiophone::contact {

/// z after a step, m. Where the load has fallen, the bristles slip back so that they hold no more than the largest
/// force without sliding.
/// @param deflection  z before the step, m
/// @param velocity    v over the step, m/s
/// @param load        that presses the surfaces together, N, above 0
/// @param step        s
[[nodiscard]] Vector3 bend(const friction::Law& law, const Vector3& deflection, const Vector3& velocity, double load,
                           double step);

/// The force against the motion at the end of a step, N. It depends on nothing else, so that it is the same after a
/// restart.
/// @param deflection  z after the step, m
[[nodiscard]] Vector3 force_of_bristles(const friction::Law& law, const Vector3& deflection, const Vector3& velocity,
                                        double load);

}  // namespace idiophone::contact
