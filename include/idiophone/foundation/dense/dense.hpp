#pragma once
// Decompositions of small dense matrices. Eigen's templates for them take a compiler seconds each, so they are compiled
// here once for all modules.

#include <Eigen/Core>
#include <span>

namespace idiophone::dense {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Eigenvalues, ascending, and orthonormal eigenvectors, one column each, of a symmetric matrix.
template <class Vector, class Matrix>
struct Eigenpairs {
  Vector values;
  Matrix vectors;
};

/// @param matrix  symmetric; only its lower triangle is read
[[nodiscard]] Eigenpairs<Eigen::VectorXd, Eigen::MatrixXd> eigenpairs(const Eigen::MatrixXd& matrix);
[[nodiscard]] Eigenpairs<Vector6, Matrix6> eigenpairs(const Matrix6& matrix);

/// A^(-1/2).
/// @param matrix  A: symmetric and positive definite; only its lower triangle is read
[[nodiscard]] Eigen::MatrixXd inverse_root(const Eigen::MatrixXd& matrix);

/// Unit vectors along the axes of inertia of points of equal weight, one column each. The points spread least along the
/// first one.
/// @param points  at least one, m
[[nodiscard]] Eigen::Matrix3d principal_axes(std::span<const Eigen::Vector3d> points);

/// x with the least |A x - b|, by a QR decomposition with pivots.
/// @param matrix  A [rows x unknowns]
/// @param right   b [rows]
[[nodiscard]] Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

}  // namespace idiophone::dense
