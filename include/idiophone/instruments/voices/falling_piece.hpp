#pragma once
// A piece of a proxy that broke: a rigid body that falls, and bounces on floors and walls.

#include <Eigen/Geometry>
#include <cstdint>
#include <deque>
#include <vector>

#include "idiophone/foundation/types.hpp"

namespace idiophone::voices {

/// Everything behind a plane.
struct Floor {
  Vector3 at = Vector3::Zero();       ///< a point of the plane, m
  Vector3 normal = Vector3::UnitZ();  ///< unit vector, out of the floor
};

/// What pieces fall on.
struct Ground {
  Vector3 gravity = Vector3::Zero();  ///< m/s2
  std::vector<Floor> floors{};
  double restitution = 0.3;  ///< normal speed of a point after an impact over that before, 0 to 1
  double friction = 0.4;     ///< Coulomb's coefficient
  double hardness = 2e8;     ///< of the contact, as score::Hammer has it, N/m^(3/2)
};

/// A rigid body, in its own coordinates.
struct RigidPiece {
  double mass = 0.0;                                 ///< kg
  Vector3 centre = Vector3::Zero();                  ///< of mass, m
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  ///< sum of m (x - centre)(x - centre)^T, kg m2
  std::vector<Vector3> points{};                     ///< that touch floors, m
};

/// How a rigid body is placed and moves, in the coordinates of the room.
struct RigidState {
  Vector3 centre = Vector3::Zero();                          ///< of mass, m
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();  ///< from the coordinates of the piece
  Vector3 velocity = Vector3::Zero();                        ///< of the centre, m/s
  Vector3 angular_momentum = Vector3::Zero();                ///< about the centre, kg m2/s
};

/// A point of a piece hit a floor.
struct Landing {
  double time = 0.0;                  ///< s
  Vector3 at = Vector3::Zero();       ///< the point, in the coordinates of the piece, m
  Vector3 impulse = Vector3::Zero();  ///< on the piece, likewise, N s
  double speed = 0.0;                 ///< normal to the floor, before, m/s
  double mass = 0.0;                  ///< that the point has against an impulse along the normal, kg
};

/// Flights are exact parabolas. The angular momentum stays as it is; the midpoint rule turns the piece. A point that is
/// behind a floor and moves on into it gets the impulse of an impact with the restitution, and one of Coulomb friction,
/// which at most stops the point. Neither ever adds energy. Slow impacts do not rebound, and a piece that is slow all
/// over when it touches a floor comes to rest.
class FallingPiece {
 public:
  /// @param time  at which it begins, s
  FallingPiece(RigidPiece piece, const RigidState& begin, double time, Ground ground);

  /// Goes on as far as whole steps lead to a time, s.
  /// @return what hit floors since the last call, slow impacts left out
  std::vector<Landing> advance(double time);

  /// Its motion at a time, s, at most 0.1 s before the last advance(). What it will touch later is not known.
  [[nodiscard]] RigidState at(double time) const;

  /// From the coordinates of the piece to those of the room, likewise.
  [[nodiscard]] Eigen::Isometry3d pose(double time) const;

  /// rad/s
  [[nodiscard]] Vector3 spin(const RigidState& state) const;

  /// Kinetic and gravitational energy, J.
  [[nodiscard]] double energy(const RigidState& state) const;

  [[nodiscard]] bool rests() const { return rests_; }

 private:
  /// A point that moves into a floor.
  struct Approach {
    Vector3 normal;      ///< of the floor
    std::size_t point;   ///< of the piece
    double speed = 0.0;  ///< m/s
  };
  [[nodiscard]] double time_of_next() const;
  [[nodiscard]] Vector3 arm(const RigidState& state, std::size_t point) const;
  [[nodiscard]] Vector3 velocity_of(const RigidState& state, const Vector3& arm) const;
  /// 1/kg: the speed along a direction that an impulse of 1 N s along it gives to a point.
  [[nodiscard]] double mobility(const RigidState& state, const Vector3& arm, const Vector3& direction) const;
  static void push(RigidState& state, double mass, const Vector3& arm, const Vector3& impulse);
  [[nodiscard]] RigidState moved(const RigidState& state, double duration) const;
  [[nodiscard]] Approach fastest_approach(const RigidState& state) const;
  [[nodiscard]] Landing land(RigidState& state, const Approach& approach) const;
  [[nodiscard]] bool is_slow(const RigidState& state) const;

  RigidPiece piece_;
  Ground ground_;
  Eigen::Matrix3d inverse_inertia_;  ///< in the coordinates of the piece, 1/(kg m2)
  double begin_;                     ///< s
  double radius_ = 0.0;              ///< of the farthest point about the centre, m
  bool rests_ = false;
  std::deque<RigidState> states_;  ///< after the last steps
  std::int64_t dropped_ = 0;       ///< states before them
};

}  // namespace idiophone::voices
