#include "idiophone/solid/tangent_stiffness.hpp"

#include <Eigen/LU>

#include "idiophone/element/tetrahedra.hpp"

namespace idiophone::solid {

namespace {

using Vector6 = Eigen::Vector<double, 6>;

/// Second Piola-Kirchhoff stress of Green's strain.
Eigen::Matrix3d stress(const StiffnessMatrix& stiffness, const Eigen::Matrix3d& strain) {
  Vector6 e;
  for (int p = 0; p < 6; ++p) {
    e[p] = (p < 3 ? 1 : 2) * strain(direction_pairs[p][0], direction_pairs[p][1]);
  }
  const Vector6 s = stiffness * e;
  Eigen::Matrix3d full;
  for (int p = 0; p < 6; ++p) {
    full(direction_pairs[p][0], direction_pairs[p][1]) = full(direction_pairs[p][1], direction_pairs[p][0]) = s[p];
  }
  return full;
}

/// With g_a = grad N_a and B the derivative of strain (in StiffnessMatrix's order) by the nodes' displacements,
/// K = sum_q w [ B^T C B + (g_a S g_b) I at the block (a, b) ].
template <class Element>
Eigen::MatrixXd tangent(const StiffnessMatrix& stiffness, std::span<const Vector3> reference,
                        std::span<const Vector3> displacement) {
  constexpr Eigen::Index n = Element::nodes;
  Eigen::Matrix<double, 3, n> x;
  Eigen::Matrix<double, 3, n> u;
  for (Eigen::Index a = 0; a < n; ++a) {
    x.col(a) = reference[a];
    u.col(a) = displacement[a];
  }
  Eigen::MatrixXd tangent = Eigen::MatrixXd::Zero(3 * n, 3 * n);
  for (int q = 0; q < Element::points; ++q) {
    Eigen::Matrix<double, n, 3> slopes;
    for (Eigen::Index a = 0; a < n; ++a) {
      for (int k = 0; k < 3; ++k) {
        slopes(a, k) = Element::gradient(Element::places[q], static_cast<int>(a), k);
      }
    }
    const Eigen::Matrix3d jacobian = x * slopes;
    const double weight = Element::weights[q] * jacobian.determinant();
    const Eigen::Matrix<double, 3, n> g = (slopes * jacobian.inverse()).transpose();
    const Eigen::Matrix3d h = u * g.transpose();
    const Eigen::Matrix3d f = Eigen::Matrix3d::Identity() + h;
    Eigen::Matrix<double, 6, 3 * n> b;
    for (Eigen::Index a = 0; a < n; ++a) {
      for (int p = 0; p < 6; ++p) {
        const auto [i, j] = direction_pairs[p];
        b.template block<1, 3>(p, 3 * a) = p < 3 ? Eigen::RowVector3d(g(i, a) * f.col(i))
                                                 : Eigen::RowVector3d(g(i, a) * f.col(j) + g(j, a) * f.col(i));
      }
    }
    tangent += weight * b.transpose() * stiffness * b;
    const Eigen::Matrix3d s = stress(stiffness, (h + h.transpose() + h.transpose() * h) / 2);
    const Eigen::Matrix<double, n, n> geometric = weight * g.transpose() * s * g;
    for (Eigen::Index a = 0; a < n; ++a) {
      for (Eigen::Index c = 0; c < n; ++c) {
        tangent.block<3, 3>(3 * a, 3 * c).diagonal().array() += geometric(a, c);
      }
    }
  }
  return tangent;
}

}  // namespace

Eigen::MatrixXd tangent_stiffness(element::Type type, const Elasticity& elasticity, std::span<const Vector3> reference,
                                  std::span<const Vector3> displacement) {
  const StiffnessMatrix stiffness = stiffness_matrix(elasticity);
  switch (type.kind) {
    case element::Kind::tet4:
      return tangent<element::Tet4>(stiffness, reference, displacement);
    case element::Kind::tet10:
      return tangent<element::Tet10>(stiffness, reference, displacement);
  }
  element::unknown_kind();
}

}  // namespace idiophone::solid
