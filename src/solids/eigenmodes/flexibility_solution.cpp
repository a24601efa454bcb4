#include "flexibility_solution.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>

#include "idiophone/foundation/inertia_tensor.hpp"

namespace idiophone::eigenmodes {

namespace {

/// How a force accelerates a free body at a node, along it, 1/kg.
class RigidMobility {
 public:
  RigidMobility(const modal_bodies::ModalBasis& basis, const mesh::Part& part) {
    for (std::size_t node = 0; node < basis.nodes(); ++node) {
      mass_ += basis.masses[node];
      centre_ += basis.masses[node] * part.reference[node];
    }
    centre_ /= mass_;
    Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
    for (std::size_t node = 0; node < basis.nodes(); ++node) {
      const Vector3 arm = part.reference[node] - centre_;
      moment += basis.masses[node] * arm * arm.transpose();
    }
    inverse_inertia_ = inertia_tensor(moment).inverse();
  }

  [[nodiscard]] double at(const Vector3& place, const Vector3& direction) const {
    const Vector3 torque = (place - centre_).cross(direction);
    return 1 / mass_ + torque.dot(inverse_inertia_ * torque);
  }

 private:
  double mass_ = 0.0;
  Vector3 centre_ = Vector3::Zero();
  Eigen::Matrix3d inverse_inertia_;
};

}  // namespace

std::vector<double> residual_flexibility(const ShiftedStiffness& stiffness, const mesh::Part& part,
                                         const modal_bodies::ModalBasis& basis, std::span<const Index> nodes,
                                         std::span<const Vector3> directions) {
  constexpr std::size_t at_once = 128;
  const RigidMobility rigid(basis, part);
  std::vector<double> residual(basis.nodes());
  std::vector<double> whole;
  for (std::size_t i = 0; i < nodes.size(); i += at_once) {
    const std::size_t count = std::min(at_once, nodes.size() - i);
    std::ranges::copy(stiffness.flexibilities(nodes.subspan(i, count), directions.subspan(i, count)),
                      std::back_inserter(whole));
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Index node = nodes[i];
    const Vector3& direction = directions[i];
    double left = whole[i];
    left -= basis.is_free ? rigid.at(part.reference[node], direction) / stiffness.shift() : 0.0;
    for (std::size_t mode = 0; mode < basis.modes(); ++mode) {
      const double along = direction.dot(Vector3::Map(&basis.shapes[3 * (mode * basis.nodes() + node)]));
      left -= along * along / (basis.frequencies[mode] * basis.frequencies[mode] + stiffness.shift());
    }
    residual[node] = std::max(0.0, left);
  }
  return residual;
}

}  // namespace idiophone::eigenmodes
