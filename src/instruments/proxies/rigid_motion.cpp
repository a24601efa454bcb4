#include "rigid_motion.hpp"

#include <Eigen/LU>

#include "idiophone/foundation/inertia_tensor.hpp"

namespace idiophone::proxies {

namespace {

RowLanes cross(const RowLanes& a, const RowLanes& b) {
  return __builtin_shufflevector(a, a, 1, 2, 0, 3) * __builtin_shufflevector(b, b, 2, 0, 1, 3) -
         __builtin_shufflevector(a, a, 2, 0, 1, 3) * __builtin_shufflevector(b, b, 1, 2, 0, 3);
}

}  // namespace

RigidMotion::RigidMotion(const Lattice& lattice) : mass_(lattice.inertia().mass) {
  const Eigen::Matrix3d& second = lattice.inertia().second;
  inverse_inertia_ = inertia_tensor(second).inverse();
  for (std::size_t i = 0; i < lattice.masses().size(); ++i) {
    arm_.push_back(row_of(lattice.mesh().nodes[i] - lattice.inertia().centre));
    masses_.push_back(static_cast<float>(lattice.masses()[i]));
  }
}

RigidMotion::Motion RigidMotion::motion_of(const RowLanes& momentum, const RowLanes& angular_momentum) const {
  return {.translation = row_of(vector_of({momentum}) / mass_).lanes,
          .rotation = row_of(inverse_inertia_ * vector_of({angular_momentum})).lanes};
}

void RigidMotion::remove_from_forces(Rows& force) const {
  RowLanes sum{}, torque{};
  for (std::size_t i = 0; i < arm_.size(); ++i) {
    sum += force[i].lanes;
    torque += cross(arm_[i].lanes, force[i].lanes);
  }
  const Motion acceleration = motion_of(sum, torque);
  for (std::size_t i = 0; i < arm_.size(); ++i) {
    force[i].lanes -= masses_[i] * (acceleration.translation + cross(acceleration.rotation, arm_[i].lanes));
  }
}

void RigidMotion::remove_from_motion(Rows& field) const {
  RowLanes momentum{}, angular_momentum{};
  for (std::size_t i = 0; i < arm_.size(); ++i) {
    const RowLanes of_mass = masses_[i] * field[i].lanes;
    momentum += of_mass;
    angular_momentum += cross(arm_[i].lanes, of_mass);
  }
  const Motion rigid = motion_of(momentum, angular_momentum);
  for (std::size_t i = 0; i < arm_.size(); ++i) {
    field[i].lanes -= rigid.translation + cross(rigid.rotation, arm_[i].lanes);
  }
}

}  // namespace idiophone::proxies
