#include "idiophone/solids/solid/tangent_stiffness.hpp"

#include <Eigen/LU>
#include <vector>

#include "idiophone/foundation/element/reference.hpp"
#include "idiophone/foundation/element/tetrahedra.hpp"

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

/// Where the stress of a body at rest comes from.
struct Rest {
  Eigen::Matrix3d initial;    ///< stress without displacement, Pa
  StiffnessMatrix stiffness;  ///< against the displacement, Pa
};

/// Adds what a quadrature point contributes to K: with g_a = grad N_a and B the derivative of strain (in
/// StiffnessMatrix's order) by the nodes' displacements, w [ B^T C B + (g_a S g_b) I at the block (a, b) ].
/// @tparam n  nodes, or Eigen::Dynamic
/// @param x       [3 x nodes] X, m
/// @param u       [3 x nodes] displacement, m
/// @param slopes  [nodes x 3] dN_a/dxi_k
/// @param weight  in the reference element
template <int n>
void add_point(const StiffnessMatrix& stiffness, const Eigen::Matrix<double, 3, n>& x,
               const Eigen::Matrix<double, 3, n>& u, const Eigen::Matrix<double, n, 3>& slopes, double weight,
               const Rest& rest, Eigen::MatrixXd& tangent) {
  constexpr int components = n == Eigen::Dynamic ? Eigen::Dynamic : 3 * n;
  const Eigen::Matrix3d jacobian = x * slopes;
  const double volume = weight * jacobian.determinant();
  const Eigen::Matrix<double, 3, n> g = (slopes * jacobian.inverse()).transpose();
  const Eigen::Matrix3d h = u * g.transpose();
  const Eigen::Matrix3d f = Eigen::Matrix3d::Identity() + h;
  Eigen::Matrix<double, 6, components> b(6, 3 * x.cols());
  for (Eigen::Index a = 0; a < x.cols(); ++a) {
    for (int p = 0; p < 6; ++p) {
      const auto [i, j] = direction_pairs[p];
      b.template block<1, 3>(p, 3 * a) =
          p < 3 ? Eigen::RowVector3d(g(i, a) * f.col(i)) : Eigen::RowVector3d(g(i, a) * f.col(j) + g(j, a) * f.col(i));
    }
  }
  tangent += volume * b.transpose() * stiffness * b;
  const Eigen::Matrix3d s = rest.initial + stress(rest.stiffness, (h + h.transpose() + h.transpose() * h) / 2);
  const Eigen::Matrix<double, n, n> geometric = volume * g.transpose() * s * g;
  for (Eigen::Index a = 0; a < x.cols(); ++a) {
    for (Eigen::Index c = 0; c < x.cols(); ++c) {
      tangent.block<3, 3>(3 * a, 3 * c).diagonal().array() += geometric(a, c);
    }
  }
}

template <class Element>
Eigen::MatrixXd tangent(const StiffnessMatrix& stiffness, std::span<const Vector3> reference,
                        std::span<const Vector3> displacement, const Rest& rest) {
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
    add_point<n>(stiffness, x, u, slopes, Element::weights[q], rest, tangent);
  }
  return tangent;
}

/// Only the nodes on the three lines through a quadrature point have a gradient there.
Eigen::MatrixXd hexahedron_tangent(element::Type type, const StiffnessMatrix& stiffness,
                                   std::span<const Vector3> reference, std::span<const Vector3> displacement,
                                   const Rest& rest) {
  const auto n = static_cast<Eigen::Index>(reference.size());
  const Eigen::Map<const Eigen::Matrix3Xd> x(reference.front().data(), 3, n);
  const Eigen::Map<const Eigen::Matrix3Xd> u(displacement.front().data(), 3, n);
  Eigen::MatrixXd tangent = Eigen::MatrixXd::Zero(3 * n, 3 * n);
  for (const element::QuadraturePoint& point : element::reference(type).quadrature) {
    std::vector<Eigen::Index> nodes;
    std::vector<Eigen::Index> components;
    for (Eigen::Index a = 0; a < n; ++a) {
      if (!point.gradient.row(a).isZero(0.0)) {
        nodes.push_back(a);
        components.insert(components.end(), {3 * a, 3 * a + 1, 3 * a + 2});
      }
    }
    const auto size = static_cast<Eigen::Index>(components.size());
    Eigen::MatrixXd contribution = Eigen::MatrixXd::Zero(size, size);
    add_point<Eigen::Dynamic>(stiffness, x(Eigen::all, nodes), u(Eigen::all, nodes), point.gradient(nodes, Eigen::all),
                              point.weight, rest, contribution);
    tangent(components, components) += contribution;
  }
  return tangent;
}

}  // namespace

Eigen::MatrixXd tangent_stiffness(element::Type type, const Elasticity& elasticity, std::span<const Vector3> reference,
                                  std::span<const Vector3> displacement, const Eigen::Matrix3d& initial) {
  return tangent_stiffness(type, elasticity, elasticity, reference, displacement, initial);
}

Eigen::MatrixXd tangent_stiffness(element::Type type, const Elasticity& elasticity, const Elasticity& relaxed,
                                  std::span<const Vector3> reference, std::span<const Vector3> displacement,
                                  const Eigen::Matrix3d& initial) {
  const StiffnessMatrix stiffness = stiffness_matrix(elasticity);
  const Rest rest{initial, stiffness_matrix(relaxed)};
  switch (type.kind) {
    case element::Kind::tet4:
      return tangent<element::Tet4>(stiffness, reference, displacement, rest);
    case element::Kind::tet10:
      return tangent<element::Tet10>(stiffness, reference, displacement, rest);
    case element::Kind::hex:
      return hexahedron_tangent(type, stiffness, reference, displacement, rest);
  }
  element::unknown_kind();
}

}  // namespace idiophone::solid
