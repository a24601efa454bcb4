#pragma once
// Frequencies of a free block by an expansion in polynomials (Visscher, Migliori, Bell and Reinert, Journal of the
// Acoustical Society of America 90, 1991).

#include <cmath>
#include <numbers>
#include <vector>

#include "idiophone/foundation/dense/dense.hpp"
#include "idiophone/scene/material.hpp"
#include "idiophone/solids/solid/elasticity.hpp"

namespace idiophone::eigenmodes {

/// Products of orthonormal Legendre polynomials along x, y and z, of a degree in all; and integrals of two of them and
/// their derivatives over the block.
class Polynomials {
 public:
  Polynomials(int degree, const Vector3& size) {
    for (int i = 0; i <= degree; ++i) {
      for (int j = 0; i + j <= degree; ++j) {
        for (int k = 0; i + j + k <= degree; ++k) {
          orders_.push_back({i, j, k});
        }
      }
    }
    for (int axis = 0; axis < 3; ++axis) {
      Eigen::MatrixXd slope = Eigen::MatrixXd::Zero(degree + 1, degree + 1);  // integral of p_i' p_j
      for (int i = 0; i <= degree; ++i) {
        for (int j = i - 1; j >= 0; j -= 2) {
          slope(i, j) = 2 * std::sqrt((2 * i + 1) * (2 * j + 1)) / size[axis];
        }
      }
      const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(degree + 1, degree + 1);
      along_[axis] = {one, slope, slope.transpose(), slope * slope.transpose()};
    }
  }

  [[nodiscard]] Eigen::Index count() const { return std::ssize(orders_); }

  /// Of the derivative of one along m and of the other along n.
  [[nodiscard]] double integral(Eigen::Index first, Eigen::Index second, int m, int n) const {
    double product = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
      product *= along_[axis][(axis == m ? 1 : 0) + (axis == n ? 2 : 0)](orders_[first][axis], orders_[second][axis]);
    }
    return product;
  }

 private:
  std::vector<std::array<int, 3>> orders_;
  std::array<std::array<Eigen::MatrixXd, 4>, 3> along_;  // without derivatives, of the first, of the second, of both
};

/// Frequencies of a free block, Hz, ascending; the first six are 0.
inline std::vector<double> expansion(const scene::Material& material, const Eigen::Matrix3d& axes, const Vector3& size,
                                     int degree) {
  const solid::StiffnessMatrix c = solid::stiffness_matrix(solid::elasticity(material, axes));
  const auto number = [](int i, int j) { return i == j ? i : 6 - i - j; };
  const Polynomials polynomials(degree, size);
  Eigen::MatrixXd stiffness(3 * polynomials.count(), 3 * polynomials.count());
  for (Eigen::Index p = 0; p < polynomials.count(); ++p) {
    for (Eigen::Index q = 0; q < polynomials.count(); ++q) {
      Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
      for (int m = 0; m < 3; ++m) {
        for (int n = 0; n < 3; ++n) {
          const double integral = polynomials.integral(p, q, m, n);
          for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
              block(i, j) += c(number(i, m), number(j, n)) * integral;
            }
          }
        }
      }
      stiffness.block<3, 3>(3 * p, 3 * q) = block;
    }
  }
  stiffness /= material.density;
  const Eigen::VectorXd values = dense::eigenpairs(stiffness).values;
  std::vector<double> frequencies;
  for (const double value : values) {
    frequencies.push_back(std::sqrt(std::max(0.0, value)) / (2 * std::numbers::pi));
  }
  return frequencies;
}

}  // namespace idiophone::eigenmodes
