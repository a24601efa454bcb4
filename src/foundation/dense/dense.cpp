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

Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  return matrix.colPivHouseholderQr().solve(right);
}

}  // namespace idiophone::dense
