#pragma once
// The rigid part of what the masses of a free body do. It belongs to the physics, not to the proxy.

#include "idiophone/instruments/proxies/lattice.hpp"
#include "spring_rows.hpp"

namespace idiophone::proxies {

class RigidMotion {
 public:
  explicit RigidMotion(const Lattice& lattice);

  /// Subtracts from forces those that would move the body as a rigid body. @param force  [masses] N
  void remove_from_forces(Rows& force) const;

  /// Subtracts translation and rotation from displacements or velocities. @param field  [masses]
  void remove_from_motion(Rows& field) const;

 private:
  /// A translation and a small rotation about the centre of mass.
  struct Motion {
    RowLanes translation{}, rotation{};
  };
  [[nodiscard]] Motion motion_of(const RowLanes& momentum, const RowLanes& angular_momentum) const;

  double mass_;                      // kg
  Eigen::Matrix3d inverse_inertia_;  // 1/(kg m2)
  Rows arm_;                         // [masses] from the centre of mass, m
  std::vector<float> masses_;        // kg
};

}  // namespace idiophone::proxies
