#include "modal_inertia.hpp"

#include <Eigen/LU>
#include <cmath>

#include "idiophone/foundation/cross_matrix.hpp"
#include "idiophone/foundation/dense/dense.hpp"
#include "idiophone/foundation/inertia_tensor.hpp"

namespace idiophone::modal_bodies {

ModalInertia::ModalInertia(std::span<const double> masses, std::span<const Vector3> reference,
                           const ModalShapes& shapes)
    : masses_(masses.begin(), masses.end()) {
  Vector3 centre = Vector3::Zero();
  for (std::size_t node = 0; node < masses_.size(); ++node) {
    mass_ += masses_[node];
    centre += masses_[node] * reference[node];
  }
  centre /= mass_;
  moments_.assign(shapes.modes(), {Vector3::Zero(), Vector3::Zero(), Eigen::Matrix3d::Zero()});
  for (std::size_t node = 0; node < masses_.size(); ++node) {
    const Vector3 arm = arms_.emplace_back(reference[node] - centre);
    moment_ += masses_[node] * arm * arm.transpose();
    for (std::size_t mode = 0; mode < moments_.size(); ++mode) {
      const Vector3 weighted = masses_[node] * shapes.at(mode, node);
      moments_[mode].momentum += weighted;
      moments_[mode].angular += arm.cross(weighted);
      moments_[mode].cross += weighted * arm.transpose();
    }
  }
  changes_.resize(6, static_cast<Eigen::Index>(moments_.size()));
  for (std::size_t mode = 0; mode < moments_.size(); ++mode) {
    const Eigen::Matrix3d change = moments_[mode].cross + moments_[mode].cross.transpose();
    changes_.col(static_cast<Eigen::Index>(mode)) << change(0, 0), change(1, 1), change(2, 2), change(1, 2),
        change(0, 2), change(0, 1);
  }
}

Eigen::Matrix3d ModalInertia::inverse_inertia() const {
  const Eigen::Matrix3d inertia = inertia_tensor(moment_);
  return inertia.inverse();
}

Eigen::Matrix3d ModalInertia::change_of_moment(const Eigen::ArrayXd& places) const {
  const Eigen::Vector<double, 6> change = changes_ * places.matrix();
  Eigen::Matrix3d matrix;
  matrix << change[0], change[5], change[4], change[5], change[1], change[3], change[4], change[3], change[2];
  return matrix;
}

void ModalInertia::add_weight(const Vector3& gravity, Eigen::ArrayXd& modal) const {
  for (std::size_t mode = 0; mode < moments_.size() && !gravity.isZero(0.0); ++mode) {
    modal[static_cast<Eigen::Index>(mode)] += moments_[mode].momentum.dot(gravity);
  }
}

void ModalInertia::add_centrifugal(const Vector3& spin, Eigen::ArrayXd& modal) const {
  if (spin.isZero(0.0)) {
    return;
  }
  // trace(cross) spin^2 - spin . cross spin
  Eigen::Vector<double, 6> weights;
  weights << (spin[1] * spin[1] + spin[2] * spin[2]) / 2, (spin[0] * spin[0] + spin[2] * spin[2]) / 2,
      (spin[0] * spin[0] + spin[1] * spin[1]) / 2, -spin[1] * spin[2], -spin[0] * spin[2], -spin[0] * spin[1];
  modal += (changes_.transpose() * weights).array();
}

std::vector<Eigen::Matrix3d> ModalInertia::mobilities(const ModalShapes& shapes, bool is_free) const {
  const Eigen::Matrix3d inverse = inverse_inertia();
  std::vector<Eigen::Matrix3d> mobilities;
  mobilities.reserve(masses_.size());
  for (std::size_t node = 0; node < masses_.size(); ++node) {
    Eigen::Matrix3d& mobility = mobilities.emplace_back(Eigen::Matrix3d::Zero());
    if (is_free) {
      const Eigen::Matrix3d arm = cross_matrix(arms_[node]);
      mobility = Eigen::Matrix3d::Identity() / mass_ + arm * inverse * arm.transpose();
    }
    for (std::size_t mode = 0; mode < moments_.size(); ++mode) {
      const Vector3 shape = shapes.at(mode, node);
      mobility += shape * shape.transpose();
    }
  }
  return mobilities;
}

double ModalInertia::largest_eigenvalue(const ModalShapes& shapes, bool is_free,
                                        std::span<const double> springs) const {
  const Eigen::Index rigid = is_free ? 6 : 0;
  const auto size = rigid + std::ssize(moments_);
  const Eigen::Matrix3d turn = dense::inverse_root(inertia_tensor(moment_));
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
  Eigen::MatrixXd at_node(3, size);  // what coordinates of unit mass do there, kg^-1/2
  for (std::size_t node = 0; node < masses_.size(); ++node) {
    if (springs[node] == 0.0) {
      continue;
    }
    if (is_free) {
      at_node.leftCols<3>() = Eigen::Matrix3d::Identity() / std::sqrt(mass_);
      at_node.middleCols<3>(3) = cross_matrix(arms_[node]) * turn;
    }
    for (std::size_t mode = 0; mode < moments_.size(); ++mode) {
      at_node.col(rigid + static_cast<Eigen::Index>(mode)) = shapes.at(mode, node);
    }
    matrix += springs[node] * at_node.transpose() * at_node;
  }
  return size == 0 || matrix.isZero(0.0) ? 0.0 : dense::eigenpairs(matrix).values.tail(1)[0];
}

}  // namespace idiophone::modal_bodies
