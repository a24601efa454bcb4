#include "idiophone/solids/solid/consistent_mass.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "idiophone/foundation/element/reference.hpp"
#include "idiophone/foundation/element/tetrahedra.hpp"

namespace idiophone::solid {
namespace {

constexpr double density = 3.0;

/// The reference tetrahedron, its tet10 nodes moved by a map.
template <class Map>
std::vector<Vector3> nodes(int count, Map map) {
  std::vector<Vector3> places = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const auto& [i, j] : element::tetrahedron_edges) {
    const Vector3 middle = (places[i] + places[j]) / 2;
    places.push_back(middle);
  }
  places.resize(count);
  std::ranges::transform(places, places.begin(), map);
  return places;
}

Vector3 itself(const Vector3& x) {
  return x;
}

TEST(ConsistentMass, LinearTetrahedron) {
  const Eigen::MatrixXd mass = consistent_mass(element::tet4, density, nodes(4, itself));
  for (int row = 0; row < 12; ++row) {
    for (int column = 0; column < 12; ++column) {
      const double expected = row % 3 != column % 3 ? 0.0 : (row == column ? 2 : 1) * density / 6 / 20;
      EXPECT_NEAR(mass(row, column), expected, 1e-15) << row << " " << column;
    }
  }
}

// Zienkiewicz and Taylor: the integrals of barycentric coordinates, 6 V a! b! c! d!/(a + b + c + d + 3)!.
TEST(ConsistentMass, QuadraticTetrahedron) {
  const Eigen::MatrixXd mass = consistent_mass(element::tet10, density, nodes(10, itself));
  const double unit = density / 6 / 420;
  const auto at = [&](int a, int b) { return mass(3 * a + 1, 3 * b + 1) / unit; };
  EXPECT_NEAR(at(0, 0), 6, 1e-12);
  EXPECT_NEAR(at(0, 1), 1, 1e-12);
  EXPECT_NEAR(at(0, 4), -4, 1e-12) << "the edge's own corner";
  EXPECT_NEAR(at(0, 5), -6, 1e-12) << "an edge of the opposite face";
  EXPECT_NEAR(at(4, 4), 32, 1e-12);
  EXPECT_NEAR(at(4, 5), 16, 1e-12) << "edges that share a corner";
  EXPECT_NEAR(at(4, 9), 8, 1e-12) << "opposite edges";
}

TEST(ConsistentMass, CurvedTetrahedra) {
  const auto sheared = [](const Vector3& x) {
    return Vector3(x[0] + 0.3 * x[1] * x[1], x[1], x[2] - 0.4 * x[0] * x[1]);
  };
  const Eigen::MatrixXd straight = consistent_mass(element::tet10, density, nodes(10, itself));
  EXPECT_LT((consistent_mass(element::tet10, density, nodes(10, sheared)) - straight).norm(), 1e-14)
      << "a map of Jacobian 1";
  const auto stretched = [](const Vector3& x) {
    return Vector3(x[0] + 0.2 * x[0] * x[0], x[1] + 0.2 * x[1] * x[1], x[2] + 0.2 * x[2] * x[2]);
  };
  // The integral of (1 + 0.4 xi_1)(1 + 0.4 xi_2)(1 + 0.4 xi_3): of degree 3.
  const double volume = 1.0 / 6 + 3 * 0.4 / 24 + 3 * 0.16 / 120 + 0.064 / 720;
  EXPECT_NEAR(consistent_mass(element::tet10, density, nodes(10, stretched)).sum(), 3 * density * volume, 1e-14);
}

/// A field's values at the nodes, and its kinetic energy's double under the mass: the integral of density times its
/// square.
template <class Field>
double moment(const Eigen::MatrixXd& mass, const std::vector<Vector3>& places, Field field) {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(mass.rows());
  for (std::size_t a = 0; a < places.size(); ++a) {
    values.segment<3>(static_cast<Eigen::Index>(3 * a)) = field(places[a]);
  }
  return values.dot(mass * values);
}

std::vector<Vector3> hexahedron(element::Type type, Vector3 (*map)(const Vector3&)) {
  std::vector<Vector3> places = element::reference(type).nodes;
  std::ranges::transform(places, places.begin(), map);
  return places;
}

TEST(ConsistentMass, HexahedraOfABlock) {
  constexpr double a = 0.5, b = 0.25, c = 0.125;  // half the edges
  const auto block = [](const Vector3& xi) { return Vector3(a * xi[0], b * xi[1], c * xi[2]); };
  const double whole = density * 8 * a * b * c;
  for (const element::Type type : {element::hex(2, 2), element::hex(4, 2), element::hex(3, 5)}) {
    const auto places = hexahedron(type, block);
    const Eigen::MatrixXd mass = consistent_mass(type, density, places);
    EXPECT_NEAR(mass.sum(), 3 * whole, 1e-14);
    EXPECT_LT((mass - mass.transpose()).norm(), 1e-15);
    const auto spin = [](const Vector3& x) -> Vector3 { return Vector3(0.3, -0.7, 1.1).cross(x); };
    const Vector3 inertia = whole / 3 * Vector3(b * b + c * c, a * a + c * c, a * a + b * b);
    EXPECT_NEAR(moment(mass, places, spin), inertia.dot(Vector3(0.09, 0.49, 1.21)), 1e-15);
    const int p = type.plane, q = type.thickness;
    const auto highest = [&](const Vector3& x) -> Vector3 {
      return Vector3::UnitY() * std::pow(x[0], p) * std::pow(x[1], p) * std::pow(x[2], q);
    };
    const double exact = density * 8 * std::pow(a, 2 * p + 1) * std::pow(b, 2 * p + 1) * std::pow(c, 2 * q + 1) /
                         ((2 * p + 1) * (2 * p + 1) * (2 * q + 1));
    EXPECT_NEAR(moment(mass, places, highest) / exact, 1, 1e-11) << "polynomials of the element's orders";
  }
}

TEST(ConsistentMass, CurvedHexahedron) {
  const auto bulge = [](const Vector3& xi) {
    return Vector3(xi[0] + 0.1 * xi[0] * xi[0], xi[1], xi[2] * (1 + 0.2 * xi[0] * xi[1] + 0.1 * xi[1] * xi[1]));
  };
  const element::Type type = element::hex(3, 2);
  const auto places = hexahedron(type, bulge);
  // The integral of (1 + 0.2 xi_1)(1 + 0.2 xi_1 xi_2 + 0.1 xi_2^2).
  EXPECT_NEAR(consistent_mass(type, density, places).sum(), 3 * density * (8 + 0.8 / 3), 1e-12);
}

}  // namespace
}  // namespace idiophone::solid
