#pragma once
// Friction with memory in two directions: the elasto-plastic law of foundation/friction with vectors for the deflection
// z and the velocity v,
//
//   z' = v - a |v| z/z_v,   force = stiffness z + damping z' + viscosity v,
//
// z_v and a those of the lengths |v| and |z|, a = 0 where z is against v. On a line it is that law. A step is implicit
// (Euler): the way of the step bends the bristles, and the force is that of their deflection after it. The loss, a
// stiffness |v| z^2/z_v, is never negative.
//
// A node that carries the share w of a contact's load pulls with w force. The load may move from node to node, and
// bristles that were bent under a small share must not pull back with a large one: that would be energy from nothing.
// So a node remembers u, the share under which its bristles were bent, and they store u stiffness z^2/2.
//
// - w rises above u: bristles come in that are not bent, and all share the pull. z becomes z u/w, and u becomes w. The
//   force stays, and the stored energy falls by the factor u/w.
// - w falls below u: some bristles no longer pull, but stay bent, and pull again when the load comes back.
// - Under w < u they bend further: u z^2 grows by w times the growth of z^2, which is at most the work. So u falls
//   towards w as bristles are bent anew. With steady sliding, u - w falls by 86 % on the way z_v.
// - They unbend: u stays. The work that they give, that of w, is at most what they lose, that of u.
//
// While the shares stay the same, w = u, and all nodes together are one bow under the whole load.

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

/// The bristles of one node of a contact.
struct NodeBristles {
  Vector3 deflection = Vector3::Zero();  ///< z, m
  double share = 0.0;                    ///< u, of the load, under which they were bent
};

/// The bristles of a node that carries a share w of the load from now on.
[[nodiscard]] NodeBristles carry(const NodeBristles& bristles, double share);

/// The bristles of a node after a step with the share w, as above.
/// @param load   of the whole contact, N, above 0
/// @param share  w
[[nodiscard]] NodeBristles bend(const friction::Law& law, const NodeBristles& bristles, const Vector3& velocity,
                                double load, double share, double step);

/// The force against the motion at the end of a step, N. It depends on nothing else, so that it is the same after a
/// restart.
/// @param deflection  z after the step, m
[[nodiscard]] Vector3 force_of_bristles(const friction::Law& law, const Vector3& deflection, const Vector3& velocity,
                                        double load);

}  // namespace idiophone::contact
