#include "idiophone/solid/consistent_mass.hpp"

#include <Eigen/LU>
#include <cmath>

#include "idiophone/element/tetrahedra.hpp"

namespace idiophone::solid {

namespace {

/// Gauss and Legendre's five points of [0, 1]: exact for polynomials of degree 9.
struct Gauss {
  static constexpr int count = 5;
  double place[count];
  double weight[count];

  Gauss() {
    const double inner = std::sqrt(5 - 2 * std::sqrt(10.0 / 7)) / 3;
    const double outer = std::sqrt(5 + 2 * std::sqrt(10.0 / 7)) / 3;
    const double places[count] = {-outer, -inner, 0.0, inner, outer};
    const double root = 13 * std::sqrt(70.0);
    const double weights[count] = {(322 - root) / 900, (322 + root) / 900, 128.0 / 225, (322 + root) / 900,
                                   (322 - root) / 900};
    for (int i = 0; i < count; ++i) {
      place[i] = (1 + places[i]) / 2;
      weight[i] = weights[i] / 2;
    }
  }
};

/// Calls visit(place, weight) at points that integrate polynomials of degree 7 over the reference tetrahedron exactly,
/// as many as a curved tet10 has: N_a N_b of degree 4, times a Jacobian of degree 3. The tetrahedron is a cube two of
/// whose faces have collapsed (Stroud's conical product), which adds two degrees.
template <class Visitor>
void for_each_point(Visitor visit) {
  static const Gauss gauss;
  for (int i = 0; i < Gauss::count; ++i) {
    for (int j = 0; j < Gauss::count; ++j) {
      for (int k = 0; k < Gauss::count; ++k) {
        const double r = gauss.place[i];
        const double s = gauss.place[j] * (1 - r);
        const double t = gauss.place[k] * (1 - gauss.place[j]) * (1 - r);
        const double collapse = (1 - r) * (1 - r) * (1 - gauss.place[j]);
        visit(element::Barycentric{1 - r - s - t, r, s, t},
              gauss.weight[i] * gauss.weight[j] * gauss.weight[k] * collapse);
      }
    }
  }
}

template <class Element>
Eigen::MatrixXd mass_of(double density, std::span<const Vector3> reference) {
  constexpr Eigen::Index n = Element::nodes;
  Eigen::Matrix<double, n, n> scalar = Eigen::Matrix<double, n, n>::Zero();
  for_each_point([&](const element::Barycentric& place, double weight) {
    Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
    Eigen::Matrix<double, n, 1> shape;
    for (int a = 0; a < Element::nodes; ++a) {
      shape[a] = Element::shape(place, a);
      for (int k = 0; k < 3; ++k) {
        jacobian.col(k) += Element::gradient(place, a, k) * reference[a];
      }
    }
    scalar += weight * density * jacobian.determinant() * shape * shape.transpose();
  });
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(3 * n, 3 * n);
  for (Eigen::Index a = 0; a < n; ++a) {
    for (Eigen::Index b = 0; b < n; ++b) {
      mass.block<3, 3>(3 * a, 3 * b).diagonal().setConstant(scalar(a, b));
    }
  }
  return mass;
}

}  // namespace

Eigen::MatrixXd consistent_mass(element::Type type, double density, std::span<const Vector3> reference) {
  switch (type.kind) {
    case element::Kind::tet4:
      return mass_of<element::Tet4>(density, reference);
    case element::Kind::tet10:
      return mass_of<element::Tet10>(density, reference);
  }
  element::unknown_kind();
}

}  // namespace idiophone::solid
