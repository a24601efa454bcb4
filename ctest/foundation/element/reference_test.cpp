#include "idiophone/foundation/element/reference.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>

#include "idiophone/foundation/element/tetrahedra.hpp"

namespace idiophone::element {
namespace {

const Vector3 inside(0.1, 0.2, 0.3);

class ReferenceTest : public ::testing::TestWithParam<Type> {
 protected:
  const Type type = GetParam();
  const ReferenceElement& table = reference(type);

  [[nodiscard]] Vector3 place(int node) const { return table.nodes[node]; }
  /// Twice the area vector of a triangle, along its normal.
  [[nodiscard]] Vector3 normal(int a, int b, int c) const { return (place(b) - place(a)).cross(place(c) - place(a)); }
  [[nodiscard]] Vector3 centre() const {
    Vector3 sum = Vector3::Zero();
    for (const int corner : table.corners) {
      sum += place(corner);
    }
    return sum / static_cast<double>(table.corners.size());
  }
  [[nodiscard]] bool is_hexahedron() const { return type.kind == Kind::hex; }
  [[nodiscard]] double reference_volume() const { return is_hexahedron() ? 8.0 : 1.0 / 6; }
  /// Round-off of sums of many terms of both signs.
  [[nodiscard]] double round_off() const { return is_hexahedron() ? 1e-12 : 1e-15; }
  /// By the straight tetrahedra.
  [[nodiscard]] double volume() const {
    double sum = 0.0;
    for (const auto& [a, b, c, d] : table.straight_tetrahedra) {
      sum += normal(a, b, c).dot(place(d) - place(a)) / 6;
    }
    return sum;
  }
};

TEST_P(ReferenceTest, HasAllItsNodes) {
  EXPECT_EQ(table.type, type);
  EXPECT_EQ(std::ssize(table.nodes), node_count(type));
}

TEST_P(ReferenceTest, ShapeFunctionsAreOneAtTheirNodeAndZeroAtOthers) {
  for (int node = 0; node < node_count(type); ++node) {
    const Eigen::VectorXd expected = Eigen::VectorXd::Unit(node_count(type), node);
    EXPECT_LT((shape_functions(type, place(node)) - expected).norm(), round_off());
  }
}

TEST_P(ReferenceTest, ShapeFunctionsAddUpToOneAndReproducePlaces) {
  const Eigen::VectorXd shape = shape_functions(type, inside);
  EXPECT_NEAR(shape.sum(), 1.0, round_off());
  Vector3 interpolated = Vector3::Zero();
  for (int node = 0; node < node_count(type); ++node) {
    interpolated += shape[node] * place(node);
  }
  EXPECT_LT((interpolated - inside).norm(), round_off());
}

TEST_P(ReferenceTest, GradientsAreTheSlopesOfTheShapeFunctions) {
  const Eigen::MatrixX3d gradients = shape_gradients(type, inside);
  const double small = 1e-5;
  for (int k = 0; k < 3; ++k) {
    const Vector3 shift = small * Vector3::Unit(k);
    const Eigen::VectorXd slope =
        (shape_functions(type, inside + shift) - shape_functions(type, inside - shift)) / (2 * small);
    EXPECT_LT((gradients.col(k) - slope).norm(), 1e-8) << k;
  }
}

TEST_P(ReferenceTest, TabledGradientsAreThoseOfTheirPlaces) {
  for (const QuadraturePoint& point : table.quadrature) {
    EXPECT_LT((point.gradient - shape_gradients(type, point.place)).norm(), 1e-14);
  }
  ASSERT_EQ(table.corner_gradients.size(), table.corners.size());
  for (std::size_t i = 0; i < table.corners.size(); ++i) {
    EXPECT_LT((table.corner_gradients[i] - shape_gradients(type, place(table.corners[i]))).norm(), 1e-14);
  }
}

TEST_P(ReferenceTest, QuadratureIntegratesTheVolume) {
  double sum = 0.0;
  for (const QuadraturePoint& point : table.quadrature) {
    sum += point.weight;
  }
  EXPECT_NEAR(sum, reference_volume(), 1e-13);
}

TEST_P(ReferenceTest, StraightTetrahedraFillIt) {
  for (const auto& [a, b, c, d] : table.straight_tetrahedra) {
    EXPECT_GT(normal(a, b, c).dot(place(d) - place(a)), 0.0);
  }
  EXPECT_NEAR(volume(), reference_volume(), round_off());
}

TEST_P(ReferenceTest, FacesAndTheirTrianglesFaceOutwardAndEncloseTheVolume) {
  Vector3 closed = Vector3::Zero();
  double enclosed = 0.0;  // by Gauss's theorem
  for (const Face& face : table.faces) {
    const Vector3 outward = normal(face.corners[0], face.corners[1], face.corners[2]);
    EXPECT_GT(outward.dot(place(face.corners[0]) - centre()), 0.0);
    for (const auto& [a, b, c] : face.triangles) {
      EXPECT_GT(normal(a, b, c).dot(outward), 0.0);
      closed += normal(a, b, c);
      enclosed += normal(a, b, c).dot(place(a)) / 6;
    }
  }
  EXPECT_LT(closed.norm(), round_off());
  EXPECT_NEAR(enclosed, volume(), round_off());
}

TEST_P(ReferenceTest, TrianglesOfTheFacesAreThoseOfTheStraightTetrahedra) {
  std::multiset<std::set<int>> of_tetrahedra;
  for (const auto& [a, b, c, d] : table.straight_tetrahedra) {
    for (const std::set<int>& side : {std::set{a, b, c}, {a, b, d}, {a, c, d}, {b, c, d}}) {
      of_tetrahedra.insert(side);
    }
  }
  std::size_t single = 0;
  for (const std::set<int>& side : of_tetrahedra) {
    single += of_tetrahedra.count(side) == 1 ? 1 : 0;
  }
  std::size_t triangles = 0;
  for (const Face& face : table.faces) {
    triangles += face.triangles.size();
    for (const auto& [a, b, c] : face.triangles) {
      EXPECT_EQ(of_tetrahedra.count({a, b, c}), 1);
    }
  }
  EXPECT_EQ(triangles, single);
}

TEST_P(ReferenceTest, FacesListAllTheirNodes) {
  for (const Face& face : table.faces) {
    const Vector3 normal = this->normal(face.corners[0], face.corners[1], face.corners[2]);
    std::set<int> expected;
    for (int node = 0; node < node_count(type); ++node) {
      if (std::abs(normal.dot(place(node) - place(face.corners[0]))) < 1e-12) {
        expected.insert(node);
      }
    }
    EXPECT_EQ(std::set<int>(face.nodes.begin(), face.nodes.end()), expected);
    EXPECT_TRUE(std::equal(face.corners.begin(), face.corners.end(), face.nodes.begin()));
  }
}

TEST_P(ReferenceTest, EdgesJoinEachPairOfCornersOnce) {
  std::set<std::set<int>> pairs;
  for (const auto& [i, j] : table.edges) {
    pairs.insert({i, j});
  }
  EXPECT_EQ(pairs.size(), is_hexahedron() ? 12 : 6);
  EXPECT_EQ(table.edges.size(), pairs.size());
}

TEST_P(ReferenceTest, RegularElementHasItsJacobian) {
  if (is_hexahedron()) {
    EXPECT_EQ(table.regular_jacobian, 1.0 / 8);  // a cube with edges of length 1, not 2
    return;
  }
  // Corners of a cube of edge 1/sqrt(2) that are no neighbours: a regular tetrahedron with edges of length 1.
  const std::vector<Vector3> corners = {{1, 1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, 1}};
  Eigen::Matrix3d jacobian;
  for (int k = 0; k < 3; ++k) {
    jacobian.col(k) = (corners[k + 1] - corners[0]) / std::sqrt(8.0);
  }
  EXPECT_NEAR(table.regular_jacobian, jacobian.determinant(), 1e-15);
}

/// Checks a numbering against the edges whose middles come after the corners.
void expect_middles(const std::vector<Vector3>& nodes, const std::vector<std::array<int, 2>>& edges) {
  for (std::size_t i = 4; i < nodes.size(); ++i) {
    const auto [a, b] = edges[i - 4];
    EXPECT_EQ(nodes[i], (nodes[a] + nodes[b]) / 2) << i;
  }
}

class TetrahedronTest : public ReferenceTest {};

TEST_P(TetrahedronTest, QuadratureIntegratesProductsOfGradientsExactly) {
  // Gradients are of degree order - 1, so their products are of degree 2 (order - 1).
  const int degree = std::max(1, 2 * (table.gmsh.order - 1));
  for (int i = 0; i <= degree; ++i) {
    for (int j = 0; i + j <= degree; ++j) {
      for (int k = 0; i + j + k <= degree; ++k) {
        double sum = 0.0;
        for (const QuadraturePoint& point : table.quadrature) {
          sum +=
              point.weight * std::pow(point.place.x(), i) * std::pow(point.place.y(), j) * std::pow(point.place.z(), k);
        }
        // i! j! k!/(i + j + k + 3)! (Dirichlet)
        const double exact = std::tgamma(i + 1) * std::tgamma(j + 1) * std::tgamma(k + 1) / std::tgamma(i + j + k + 4);
        EXPECT_NEAR(sum, exact, 1e-15) << i << j << k;
      }
    }
  }
}

TEST_P(TetrahedronTest, NumbersItsNodesForGmshAsItsManualSays) {
  EXPECT_EQ(table.gmsh.family, "tetrahedron");
  std::vector<Vector3> nodes(table.nodes.size());
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    nodes[table.gmsh.nodes[a]] = table.nodes[a];
  }
  EXPECT_EQ(nodes[3], Vector3::UnitZ());
  expect_middles(nodes, {{0, 1}, {1, 2}, {2, 0}, {3, 0}, {2, 3}, {1, 3}});  // "Node ordering", Tetrahedron10
}

TEST_P(TetrahedronTest, NumbersItsNodesForVtkAsItsDocumentationSays) {
  std::vector<Vector3> nodes;
  for (const int node : table.drawn.cells.front()) {
    nodes.push_back(table.nodes[node]);
  }
  expect_middles(nodes, {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}});  // vtkQuadraticTetra
  EXPECT_EQ(table.drawn.vtk_cell, type == tet4 ? 10 : 24);                  // VTK_TETRA, VTK_QUADRATIC_TETRA
  EXPECT_EQ(table.drawn.topology, type == tet4 ? "Tetrahedron" : "Tetrahedron_10");
}

class HexahedronTest : public ReferenceTest {};

TEST_P(HexahedronTest, QuadratureIsExactUpToDegreeTwiceTheOrderMinusOneAlongEachEdge) {
  const auto integral = [](int degree) { return degree % 2 == 0 ? 2.0 / (degree + 1) : 0.0; };
  const auto degrees = [](int order) { return std::set<int>{0, 1, 2 * order - 2, 2 * order - 1}; };
  for (const int i : degrees(type.plane)) {
    for (const int j : degrees(type.plane)) {
      for (const int k : degrees(type.thickness)) {
        double sum = 0.0;
        for (const QuadraturePoint& point : table.quadrature) {
          sum +=
              point.weight * std::pow(point.place.x(), i) * std::pow(point.place.y(), j) * std::pow(point.place.z(), k);
        }
        EXPECT_NEAR(sum, integral(i) * integral(j) * integral(k), 1e-13) << i << " " << j << " " << k;
      }
    }
  }
}

TEST_P(HexahedronTest, IsDrawnAsCubesThatFillIt) {
  EXPECT_EQ(table.drawn.topology, "Hexahedron");
  EXPECT_EQ(table.drawn.vtk_cell, 12);
  double sum = 0.0;
  for (const std::vector<int>& cell : table.drawn.cells) {  // vtkHexahedron: around the bottom, then around the top
    ASSERT_EQ(cell.size(), 8);
    const Vector3 edges[3] = {place(cell[1]) - place(cell[0]), place(cell[3]) - place(cell[0]),
                              place(cell[4]) - place(cell[0])};
    for (int d = 0; d < 3; ++d) {
      EXPECT_NEAR(edges[d].normalized()[d], 1.0, 1e-15);
    }
    EXPECT_LT((place(cell[6]) - place(cell[0]) - edges[0] - edges[1] - edges[2]).norm(), 1e-14);
    sum += edges[0].cross(edges[1]).dot(edges[2]);
  }
  EXPECT_NEAR(sum, reference_volume(), 1e-13);
}

TEST_P(HexahedronTest, NodesRunFirstAlongTheFirstDirection) {
  EXPECT_EQ(place(0), Vector3(-1, -1, -1));
  EXPECT_EQ(place(type.plane), Vector3(1, -1, -1));
  EXPECT_EQ(place(node_count(type) - 1), Vector3(1, 1, 1));
}

std::string label(const ::testing::TestParamInfo<Type>& instance) {
  const Type type = instance.param;
  std::string text(name(type));
  return type.kind == Kind::hex ? text + std::to_string(type.plane) + std::to_string(type.thickness) : text;
}

INSTANTIATE_TEST_SUITE_P(, TetrahedronTest, ::testing::Values(tet4, tet10), label);
INSTANTIATE_TEST_SUITE_P(, HexahedronTest, ::testing::Values(hex(2, 2), hex(4, 2), hex(3, 5), hex(8, 8)), label);
INSTANTIATE_TEST_SUITE_P(, ReferenceTest, ::testing::Values(tet4, tet10, hex(2, 2), hex(4, 2), hex(3, 5), hex(8, 8)),
                         label);

TEST(Drawn, TopologyFollowsFromTheNodesOfACell) {
  for (const Type type : {tet4, tet10, hex(4, 2)}) {
    EXPECT_EQ(drawn_with(reference(type).drawn.nodes_per_cell()).topology, reference(type).drawn.topology);
  }
  EXPECT_THROW((void)drawn_with(5), std::runtime_error);
}

TEST(Drawn, FacesOfACellEncloseItsVolume) {
  for (const Type type : {tet4, tet10, hex(2, 2), hex(4, 2)}) {
    const ReferenceElement& row = reference(type);
    double volume = 0.0;
    double expected = 0.0;
    for (const auto& cell : row.drawn.cells) {
      for (const auto& face : row.drawn.faces) {
        for (const auto& [a, b, c] : face) {
          volume += row.nodes[cell[a]].dot(row.nodes[cell[b]].cross(row.nodes[cell[c]])) / 6;
        }
      }
    }
    for (const QuadraturePoint& point : row.quadrature) {
      expected += point.weight;
    }
    EXPECT_NEAR(volume, expected, 1e-12) << name(type);
  }
}

template <class Element>
class Tetrahedra : public ::testing::Test {};
using Constants = ::testing::Types<Tet4, Tet10>;
TYPED_TEST_SUITE(Tetrahedra, Constants);

TYPED_TEST(Tetrahedra, MassSharesArePositiveAndAddUpToOne) {
  double sum = 0.0;
  for (const double share : TypeParam::mass_shares) {
    EXPECT_GT(share, 0.0);
    sum += share;
  }
  EXPECT_NEAR(sum, 1.0, 1e-15);
}

}  // namespace
}  // namespace idiophone::element
