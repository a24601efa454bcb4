#include "stretching_force.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace idiophone::modal_bodies {

StretchingForce::StretchingForce(const Stretching& stretching) {
  if (!stretching.exists()) {
    return;
  }
  const auto modes = static_cast<Eigen::Index>(std::lround(std::sqrt(std::ssize(stretching.rotation))));
  terms_ = std::ssize(stretching.linear) / modes;
  linear_ = Eigen::Map<const Eigen::MatrixXd>(stretching.linear.data(), modes, terms_);
  quadratic_ = Eigen::Map<const Eigen::MatrixXd>(stretching.quadratic.data(), modes, modes * terms_);
  linear_square_ = linear_ * linear_.transpose();
}

Eigen::MatrixXd StretchingForce::products(const Eigen::ArrayXd& places) const {
  return (quadratic_.transpose() * places.matrix()).reshaped(places.size(), terms_);
}

Eigen::ArrayXd StretchingForce::at(const Eigen::ArrayXd& places) const {
  const Eigen::MatrixXd y = products(places);
  const Eigen::VectorXd z = y.transpose() * places.matrix();
  const Eigen::VectorXd a = linear_.transpose() * places.matrix();
  return -(2 * y * (a + z) + linear_ * z).array();
}

double StretchingForce::energy(const Eigen::ArrayXd& places) const {
  const Eigen::VectorXd z = products(places).transpose() * places.matrix();
  const Eigen::VectorXd a = linear_.transpose() * places.matrix();
  return z.dot(a + z / 2);
}

Eigen::ArrayXd StretchingForce::change_of_end(const ModalStep& step) const {
  // The force is linear in the end of the step: force(end + d) = force(end) - slope d.
  const Eigen::MatrixXd y = products(step.now);
  const Eigen::VectorXd z = y.transpose() * ((step.before + step.end) / 2).matrix();
  const Eigen::VectorXd a = linear_.transpose() * ((step.before + 2 * step.now + step.end) / 4).matrix();
  const Eigen::VectorXd force = -(2 * y * (a + z) + linear_ * z);
  // slope = sum y y^T + (y A^T + A y^T)/2, as squares
  const Eigen::MatrixXd p = y + linear_ / 2;
  Eigen::MatrixXd matrix = linear_square_ / -4;
  matrix.diagonal() += step.stiffness.matrix();
  matrix.selfadjointView<Eigen::Lower>().rankUpdate(p);
  return matrix.llt().solve(force).array();
}

std::size_t StretchingForce::bytes() const {
  return static_cast<std::size_t>(linear_.size() + quadratic_.size() + linear_square_.size()) * sizeof(double);
}

}  // namespace idiophone::modal_bodies
