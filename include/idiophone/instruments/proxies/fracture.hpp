#pragma once
// Brittle fracture by O'Morain's two rules (2005, section 9.3.1): springs and masses that are pulled too strongly are
// split, and what does not hang together any more becomes bodies of their own.

#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "idiophone/instruments/proxies/lattice.hpp"

namespace idiophone::proxies {

/// When a body breaks.
struct Strength {
  double tensile = std::numeric_limits<double>::infinity();  ///< stress that it bears, Pa
  double shortest_spring = 0.0;                              ///< m: no spring is split into shorter ones
};

/// A body or a piece of one, and its motion.
struct Fragment {
  std::shared_ptr<const Lattice> lattice;
  std::vector<Vector3> displacement;  ///< [masses] m
  std::vector<Vector3> velocity;      ///< [masses] m/s
};

/// Sums over the masses of a fragment.
struct FragmentSums {
  double mass = 0.0;                                  ///< kg
  Vector3 momentum = Vector3::Zero();                 ///< kg m/s
  Vector3 angular_momentum = Vector3::Zero();         ///< about the origin, with the masses at rest, kg m2/s
  double kinetic_energy = 0.0, elastic_energy = 0.0;  ///< J
};
[[nodiscard]] FragmentSums sums_of(const Fragment& fragment);

/// What is pulled more strongly than it bears.
struct Overload {
  Index a = 0, b = 0;                   ///< the masses of a spring; twice the same: a mass
  Vector3 direction = Vector3::Zero();  ///< in which it is pulled apart; unit vector
  double ratio = 0.0;                   ///< of the pull to what it bears, above 1
};

/// The springs and masses that are overloaded more than those near them, the greatest overload first. No two of them
/// share a tetrahedron.
///
/// A spring bears the tensile strength times the cross-section that it stands for. A mass is pulled by its stretched
/// springs towards both sides of a plane; it bears a difference of the forces of both sides that these springs would
/// have if the body were stretched along the plane's normal until the springs along it break. The normal is the
/// direction of the strongest pull. A mass none of whose springs has half the strength, or all of whose tetrahedra are
/// on one side, does not break.
[[nodiscard]] std::vector<Overload> overloads(const Fragment& fragment, const Strength& strength);

/// What is left after a break: one fragment, or the parts that do not hang together any more. A spring gets two masses
/// half-way, one for each half, and its tetrahedra become two each (figure 9.1). A mass becomes two, one for the
/// tetrahedra on either side. Tetrahedra that then share an edge or a mass, but are not joined by faces around it, come
/// apart there, because a body can't hold by a cross-section of zero. Mass, momentum and angular momentum stay the
/// same, and after the break of masses the energy, too. A part that is pinned at fewer than three masses comes loose.
/// @param overloads  no two of which share a tetrahedron
[[nodiscard]] std::vector<Fragment> broken(const Fragment& fragment, std::span<const Overload> overloads);

/// How a free fragment moves as a rigid body.
struct RigidVelocity {
  Vector3 velocity = Vector3::Zero();          ///< of its centre of mass, m/s
  Vector3 angular_velocity = Vector3::Zero();  ///< rad/s
};

/// Takes the rigid motion away from a fragment, so that only its vibration is left.
[[nodiscard]] RigidVelocity take_rigid_motion(Fragment& fragment);

}  // namespace idiophone::proxies
