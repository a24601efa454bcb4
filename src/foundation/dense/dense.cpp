#include "idiophone/foundation/dense/dense.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace idiophone::dense {

Eigenpairs<Eigen::VectorXd, Eigen::MatrixXd> eigenpairs(const Eigen::MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigenpairs<Vector6, Matrix6> eigenpairs(const Matrix6& matrix) {
  const Eigen::SelfAdjointEigenSolver<Matrix6> solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::MatrixXd inverse_root(const Eigen::MatrixXd& matrix) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).operatorInverseSqrt();
}

Eigen::Matrix3d principal_axes(std::span<const Eigen::Vector3d> points) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points) {
    mean += point / static_cast<double>(points.size());
  }
  Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(3, 3);
  for (const Eigen::Vector3d& point : points) {
    spread += (point - mean) * (point - mean).transpose();
  }
  return eigenpairs(spread).vectors;
}

Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  return matrix.colPivHouseholderQr().solve(right);
}

}  // namespace idiophone::dense
