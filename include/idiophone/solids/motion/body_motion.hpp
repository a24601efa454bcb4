#pragma once
// A body's motion in plain numbers: where it is, how it is turned, and how it moves.

#include <Eigen/Geometry>

#include "idiophone/solids/motion/measure.hpp"

namespace idiophone::motion {

struct BodyMotion {
  Vector3 centre;                  ///< of mass, m
  Vector3 velocity;                ///< of the centre, m/s
  Eigen::Quaterniond orientation;  ///< unit quaternion of the rotation that fits the deformed body best; sign free
  Vector3 angular_velocity;        ///< of the rigid body with this shape and angular momentum, rad/s
  Vector3 angular_momentum;        ///< about the centre, kg m2/s
  double kinetic = 0.0;            ///< energy, J
  double elastic = 0.0;            ///< energy, J
};

/// Makes plain numbers of a body's sums. With x = X + u and c the centre now:
/// - orientation: the rotation R that makes sum m |x - c - R (X - C)|^2 smallest, which is that of the polar
///   decomposition of sum m (x - c)(X - C)^T (Kabsch, Acta Cryst. A32, 1976); R = 1 undeformed;
/// - angular velocity: w of L = I w, L the angular momentum and I the inertia tensor of the deformed body about c, with
///   added mass.
/// Where the body has travelled n times its size, the orientation is known to some 1e-15 n, the angular velocity to
/// some 1e-15 n^2 of itself.
/// @param sums  merged over all ranks
/// @return NaN where a sum is not valid
[[nodiscard]] BodyMotion body_motion(const BodySums& sums, const InitialState& initial_state, std::size_t body);

/// The same of a piece that a body can fall apart into, about the piece's own centre of mass.
/// @param sums  of the piece, about the centre of the body
[[nodiscard]] BodyMotion piece_motion(const BodySums& sums, const InitialState& initial_state, std::size_t piece);

}  // namespace idiophone::motion
