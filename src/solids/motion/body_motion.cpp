#include "idiophone/solids/motion/body_motion.hpp"

#include <Eigen/SVD>
#include <limits>

#include "idiophone/foundation/inertia_tensor.hpp"

namespace idiophone::motion {

namespace {

Vector3 vector(const std::array<ReproducibleSum, 3>& sums) {
  return {sums[0].value(), sums[1].value(), sums[2].value()};
}

Eigen::Matrix3d full(const std::array<ReproducibleSum, 9>& sums) {
  Eigen::Matrix3d matrix;
  std::ranges::transform(sums, matrix.data(), &ReproducibleSum::value);
  return matrix;
}

Eigen::Matrix3d symmetric(const std::array<ReproducibleSum, 6>& sums) {
  Eigen::Matrix3d matrix;
  matrix << sums[0].value(), sums[1].value(), sums[3].value(),  //
      sums[1].value(), sums[2].value(), sums[4].value(),        //
      sums[3].value(), sums[4].value(), sums[5].value();
  return matrix;
}

/// The rotation of the polar decomposition.
Eigen::Quaterniond rotation(const Eigen::Matrix3d& matrix) {
  if (!matrix.allFinite()) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan, nan, nan};
  }
  return Eigen::Quaterniond(Eigen::Affine3d(matrix).rotation()).normalized();
}

/// @param unit  of the sums
/// @param arm   from the point that the sums are about to the centre of the undeformed piece, m
BodyMotion motion_of(const BodySums& sums, const BodyUnits& unit, const Piece& piece, const Vector3& arm) {
  const double mass = piece.mass;
  const Eigen::Matrix3d& rest = piece.moments;
  const double moment_unit = unit.mass * unit.length * unit.length;

  const Vector3 moved = vector(sums.displacement) * (unit.mass * unit.length);
  const Vector3 shift = vector(sums.displacement) * (unit.mass * unit.length / mass);
  const Vector3 momentum = vector(sums.momentum) * unit.mass;
  const Vector3 about_rest_centre = vector(sums.angular_momentum) * (unit.mass * unit.length) - arm.cross(momentum);
  const Eigen::Matrix3d cross = full(sums.cross_moment) * moment_unit - moved * arm.transpose();
  // With x - c = (X - C) + u - shift, and no moment of X - C: sum m (x - c)(x - c)^T.
  const Eigen::Matrix3d second =
      rest + cross + cross.transpose() + symmetric(sums.second_moment) * moment_unit - mass * shift * shift.transpose();
  const Eigen::Matrix3d moment = second + symmetric(sums.added_moment) * moment_unit;
  const Eigen::Matrix3d inertia = inertia_tensor(moment);

  BodyMotion motion;
  motion.centre = piece.centre + shift;
  motion.velocity = momentum / mass;
  motion.orientation = rotation(rest + cross);
  motion.angular_momentum = about_rest_centre - shift.cross(momentum);
  motion.angular_velocity = inertia.ldlt().solve(motion.angular_momentum);
  motion.kinetic = sums.kinetic.value() * unit.mass;
  motion.elastic = sums.elastic.value() * unit.mass;
  return motion;
}

}  // namespace

BodyMotion body_motion(const BodySums& sums, const InitialState& initial_state, std::size_t body) {
  const Piece whole{body, initial_state.masses[body], initial_state.centres[body], initial_state.moments[body]};
  return motion_of(sums, BodyUnits(initial_state, body), whole, Vector3::Zero());
}

BodyMotion piece_motion(const BodySums& sums, const InitialState& initial_state, std::size_t piece) {
  const Piece& own = initial_state.pieces[piece];
  return motion_of(sums, BodyUnits(initial_state, own.body), own, own.centre - initial_state.centres[own.body]);
}

}  // namespace idiophone::motion
