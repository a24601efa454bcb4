#include "idiophone/solids/solid/consistent_mass.hpp"

#include <Eigen/LU>
#include <cmath>

#include "idiophone/foundation/element/lobatto.hpp"
#include "idiophone/foundation/element/reference.hpp"
#include "idiophone/foundation/element/tetrahedra.hpp"

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

/// The same number for each of the three directions.
Eigen::MatrixXd for_all_directions(const Eigen::MatrixXd& scalar) {
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(3 * scalar.rows(), 3 * scalar.cols());
  for (Eigen::Index a = 0; a < scalar.rows(); ++a) {
    for (Eigen::Index b = 0; b < scalar.cols(); ++b) {
      mass.block<3, 3>(3 * a, 3 * b).diagonal().setConstant(scalar(a, b));
    }
  }
  return mass;
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
  return for_all_directions(scalar);
}

/// By Gauss-Lobatto-Legendre rules two orders above the element's: N_a N_b of degree 2 p, times a Jacobian of degree 3.
Eigen::MatrixXd hexahedron_mass(element::Type type, double density, std::span<const Vector3> reference) {
  const auto n = static_cast<Eigen::Index>(reference.size());
  const Eigen::Map<const Eigen::Matrix3Xd> x(reference.front().data(), 3, n);
  const element::Lobatto& plane = element::lobatto(type.plane + 2);
  const element::Lobatto& thickness = element::lobatto(type.thickness + 2);
  Eigen::MatrixXd scalar = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < plane.nodes.size(); ++i) {
    for (Eigen::Index j = 0; j < plane.nodes.size(); ++j) {
      for (Eigen::Index k = 0; k < thickness.nodes.size(); ++k) {
        const Vector3 xi(plane.nodes[i], plane.nodes[j], thickness.nodes[k]);
        const Eigen::Matrix3d jacobian = x * element::shape_gradients(type, xi);
        const Eigen::VectorXd shape = element::shape_functions(type, xi);
        const double weight = plane.weights[i] * plane.weights[j] * thickness.weights[k];
        scalar.selfadjointView<Eigen::Lower>().rankUpdate(shape, weight * density * jacobian.determinant());
      }
    }
  }
  return for_all_directions(scalar.selfadjointView<Eigen::Lower>());
}

}  // namespace

Eigen::MatrixXd consistent_mass(element::Type type, double density, std::span<const Vector3> reference) {
  switch (type.kind) {
    case element::Kind::tet4:
      return mass_of<element::Tet4>(density, reference);
    case element::Kind::tet10:
      return mass_of<element::Tet10>(density, reference);
    case element::Kind::hex:
      return hexahedron_mass(type, density, reference);
  }
  element::unknown_kind();
}

}  // namespace idiophone::solid
