#include "modal_shapes.hpp"

#include <algorithm>

namespace idiophone::modal_bodies {

ModalShapes::ModalShapes(const ModalBasis& basis)
    : rows_(Eigen::Map<const Eigen::ArrayXXd>(basis.shapes.data(), static_cast<Eigen::Index>(3 * basis.nodes()),
                                              static_cast<Eigen::Index>(basis.modes()))
                .transpose()) {}

Vector3 ModalShapes::at(std::size_t mode, std::size_t node) const {
  return rows_.block<1, 3>(static_cast<Eigen::Index>(mode), static_cast<Eigen::Index>(3 * node)).matrix().transpose();
}

void ModalShapes::add_products(std::size_t node, const Vector3& force, Eigen::ArrayXd& sums) const {
  const auto first = static_cast<Eigen::Index>(3 * node);
  sums += force[0] * rows_.col(first) + force[1] * rows_.col(first + 1) + force[2] * rows_.col(first + 2);
}

Eigen::MatrixXd ModalShapes::mass_products(std::span<const double> masses) const {
  const Eigen::Map<const Eigen::VectorXd> of_nodes(masses.data(), std::ssize(masses));
  const Eigen::VectorXd of_components = of_nodes.transpose().replicate<3, 1>().reshaped();
  return rows_.matrix() * of_components.asDiagonal() * rows_.matrix().transpose();
}

NodeGroup::NodeGroup(const ModalShapes& shapes, std::span<const Vector3> arms, std::vector<std::size_t> nodes)
    : modes_(shapes.modes()),
      nodes_(std::move(nodes)),
      arms_((nodes_.size() + solid::lanes - 1) / solid::lanes),
      shapes_(arms_.size() * modes_) {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const std::size_t pack = i / solid::lanes;
    const std::size_t lane = i % solid::lanes;
    const auto put = [lane](const Vector3& vector, PackVector& vectors) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        vectors.at(axis)[lane] = vector[static_cast<Eigen::Index>(axis)];
      }
    };
    put(arms[nodes_[i]], arms_[pack]);
    for (std::size_t mode = 0; mode < modes_; ++mode) {
      put(shapes.at(mode, nodes_[i]), shapes_[pack * modes_ + mode]);
    }
  }
}

std::span<const std::size_t> NodeGroup::nodes(std::size_t pack) const {
  const std::size_t first = pack * solid::lanes;
  return std::span(nodes_).subspan(first, std::min<std::size_t>(solid::lanes, nodes_.size() - first));
}

NodeGroup::Vibration NodeGroup::vibration(std::size_t pack, const Eigen::ArrayXd& places,
                                          const Eigen::ArrayXd& rates) const {
  Pack x = {}, y = {}, z = {}, u = {}, v = {}, w = {};  // in registers
  const PackVector* shape = &shapes_[pack * modes_];
  const double* place = places.data();
  const double* rate = rates.data();
  for (std::size_t mode = 0; mode < modes_; ++mode) {
    const auto& [a, b, c] = shape[mode];
    x += place[mode] * a;
    y += place[mode] * b;
    z += place[mode] * c;
    u += rate[mode] * a;
    v += rate[mode] * b;
    w += rate[mode] * c;
  }
  return {{x, y, z}, {u, v, w}};
}

}  // namespace idiophone::modal_bodies
