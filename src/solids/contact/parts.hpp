#pragma once
// Which of the parts of a body that touch each other is the first: the one on which the contact's force, normal and
// slip are reported. It stays the first until the two no longer touch, so that what is reported has no jumps, however
// the body turns meanwhile. A rule that looks at the present direction alone would change the sign somewhere.

#include <span>

#include "overlap.hpp"
#include "side.hpp"

namespace idiophone::contact {

/// Where two parts begin to touch, the first is the one that the contact presses towards larger x + y/2 + z/4: a
/// direction to which surfaces are rarely tangent.
inline const Vector3 towards_first = {1.0, 0.5, 0.25};

/// Sets Bond::part of all nodes that touch and have none yet. A node belongs to the part that the nodes of its cell
/// belong to, and not to that of the nodes which it touches; where none of them has a part, the direction decides.
/// @param faces  of a body's contact with itself, the same on all ranks that take part
/// @param side   with the pressures of this step
void choose_parts(std::span<const FaceShare> faces, Side& side);

}  // namespace idiophone::contact
