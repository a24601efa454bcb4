// Which edges of triangles sound bends around.

#include "idiophone/air/radiation/solid_edges.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace idiophone::radiation {
namespace {

using std::numbers::pi;

struct Triangles {
  std::vector<std::array<Index, 3>> corners;
  std::vector<float> positions;

  [[nodiscard]] TriangleView view() const { return {corners, positions}; }
  [[nodiscard]] std::vector<SolidEdge> edges() const {
    return find_solid_edges(view(), 0, static_cast<Index>(corners.size()));
  }
  Index add(const Vector3& place) {
    for (Index vertex = 0; vertex < static_cast<Index>(positions.size() / 3); ++vertex) {
      if ((Eigen::Vector3f::Map(&positions[3UL * vertex]) - place.cast<float>()).norm() < 1e-6F) {
        return vertex;
      }
    }
    positions.insert(positions.end(),
                     {static_cast<float>(place.x()), static_cast<float>(place.y()), static_cast<float>(place.z())});
    return static_cast<Index>(positions.size() / 3 - 1);
  }
  /// A rectangle of n x n squares, each of two triangles; along u x v is the outward normal.
  void add_face(const Vector3& corner, const Vector3& u, const Vector3& v, int n) {
    for (int i = 0; i < n; ++i) {
      for (int k = 0; k < n; ++k) {
        const auto at = [&](int a, int b) { return add(corner + (i + a) * u / n + (k + b) * v / n); };
        corners.push_back({at(0, 0), at(1, 0), at(1, 1)});
        corners.push_back({at(0, 0), at(1, 1), at(0, 1)});
      }
    }
  }
};

Triangles box(int n) {
  Triangles box;
  const Vector3 x(0.3, 0, 0), y(0, 0.2, 0), z(0, 0, 0.1);
  box.add_face(Vector3::Zero(), y, x, n);
  box.add_face(z, x, y, n);
  box.add_face(Vector3::Zero(), x, z, n);
  box.add_face(y, z, x, n);
  box.add_face(Vector3::Zero(), z, y, n);
  box.add_face(x, y, z, n);
  return box;
}

TEST(SolidEdges, OfABoxAreTwelveHoweverFineItsTrianglesAre) {
  for (const int n : {1, 2, 5}) {
    const Triangles triangles = box(n);
    const std::vector<SolidEdge> edges = triangles.edges();
    ASSERT_EQ(edges.size(), 12U) << n;
    double length = 0.0;
    for (const SolidEdge& edge : edges) {
      const DiffractingEdge here = placed(edge, triangles.view());
      EXPECT_NEAR(here.angle, 1.5 * pi, 1e-6);
      EXPECT_GT((here.begin - Vector3(0.15, 0.1, 0.05)).dot(here.outward()), 0.0);
      EXPECT_NEAR(here.face.dot(here.normal), 0.0, 1e-6);
      EXPECT_NEAR(here.face.dot(here.end - here.begin), 0.0, 1e-6);
      length += (here.end - here.begin).norm();
    }
    EXPECT_NEAR(length, 4 * 0.6, 1e-5);
  }
}

TEST(SolidEdges, FollowTheVertices) {
  Triangles triangles = box(2);
  const std::vector<SolidEdge> edges = triangles.edges();
  const DiffractingEdge before = placed(edges[0], triangles.view());
  const Eigen::AngleAxisd turn(0.4, Vector3(1, 2, 3).normalized());
  const Vector3 shift(1, 0, -2);
  for (std::size_t vertex = 0; vertex < triangles.positions.size() / 3; ++vertex) {
    auto place = Eigen::Vector3f::Map(&triangles.positions[3 * vertex]);
    place = (turn * place.cast<double>() + shift).cast<float>();
  }
  const DiffractingEdge after = placed(edges[0], triangles.view());
  EXPECT_LT((after.begin - (turn * before.begin + shift)).norm(), 1e-6);
  EXPECT_LT((after.end - (turn * before.end + shift)).norm(), 1e-6);
  EXPECT_LT((after.normal - turn * before.normal).norm(), 1e-5);
  EXPECT_LT((after.face - turn * before.face).norm(), 1e-5);
}

TEST(SolidEdges, OfAFlatSheetAreItsRims) {
  Triangles sheet;
  sheet.add_face(Vector3::Zero(), Vector3::UnitX(), Vector3::UnitY(), 3);
  const std::vector<SolidEdge> edges = sheet.edges();
  ASSERT_EQ(edges.size(), 4U);
  EXPECT_EQ(placed(edges[0], sheet.view()).angle, 2 * pi);
}

TEST(SolidEdges, OfACornerThatPointsInwardsAreNone) {
  Triangles corner;
  corner.add_face(Vector3::Zero(), Vector3::UnitX(), Vector3::UnitY(), 1);
  corner.add_face(Vector3::Zero(), Vector3::UnitY(), Vector3::UnitZ(), 1);  // its normal is x, so both see each other
  EXPECT_EQ(corner.edges().size(), 6U);                                     // all but the one between the faces
}

}  // namespace
}  // namespace idiophone::radiation
