// Obstacles as convex parts.

#include "idiophone/solids/contact/rigid_shape.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "idiophone/foundation/deck/location.hpp"
#include "ranks.hpp"

namespace idiophone::contact {
namespace {

using Shape = scene::Obstacle::Shape;

scene::Obstacle obstacle_of(Shape shape) {
  scene::Obstacle obstacle;
  obstacle.shape = shape;
  obstacle.at = {3, -1, 2};
  obstacle.size = {0.1, 0.2, 0.3};
  obstacle.rotation = {0, 0, std::numbers::pi / 2};
  obstacle.radius = 0.2;
  obstacle.length = 0.5;
  obstacle.direction = Vector3(1, 2, 2) / 3;
  return obstacle;
}

/// How far a point is outside of a part; negative inside.
double outside(const RigidShape& shape, const Vector3& x, std::size_t part = 0) {
  double farthest = -1e300;
  for (Index plane = shape.first_plane[part]; plane < shape.first_plane[part + 1]; ++plane) {
    farthest = std::max(farthest, shape.planes[plane].distance(x));
  }
  return farthest;
}

/// Directions all around.
std::vector<Vector3> directions() {
  std::vector<Vector3> all;
  for (int i = 0; i < 500; ++i) {
    const double z = (i + 0.5) / 250.0 - 1, angle = 2.4 * i;
    all.emplace_back(std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z);
  }
  return all;
}

ON_RANKS(1);

TEST(RigidShapes, OfAHalfSpaceAreOnePlaneWithoutBounds) {
  const RigidShape shape = make_shape(obstacle_of(Shape::half_space));
  ASSERT_EQ(shape.planes.size(), 1U);
  EXPECT_NEAR(outside(shape, Vector3(3, -1, 2) + 0.4 * Vector3(1, 2, 2) / 3), 0.4, 1e-14);
  EXPECT_NEAR(outside(shape, Vector3(3, -1, 2) - 1e3 * Vector3(1, 2, 2) / 3), -1e3, 1e-9);
  EXPECT_TRUE(shape.boxes.at(0).contains(Vector3(1e9, 1e9, -1e9)));
}

TEST(RigidShapes, OfABoxAreItsSixTurnedFaces) {
  const RigidShape shape = make_shape(obstacle_of(Shape::box));
  ASSERT_EQ(shape.planes.size(), 6U);
  const Vector3 at(3, -1, 2);  // a quarter turn about z: its edges are 0.2, 0.1 and 0.3 along x, y and z
  EXPECT_NEAR(outside(shape, at), -0.05, 1e-15);
  EXPECT_NEAR(outside(shape, at + Vector3(0.1, 0, 0)), 0.0, 1e-15);
  EXPECT_NEAR(outside(shape, at + Vector3(0, 0.06, 0)), 0.01, 1e-15);
  EXPECT_NEAR(outside(shape, at + Vector3(0, 0, 0.25)), 0.10, 1e-15);
  EXPECT_TRUE(shape.boxes.at(0).contains(at + Vector3(0.0999, 0.0499, 0.1499)));
}

TEST(RigidShapes, OfASphereAreRoundToThreePerMille) {
  const RigidShape shape = make_shape(obstacle_of(Shape::sphere));
  EXPECT_EQ(shape.planes.size(), static_cast<std::size_t>(sphere_facets));
  for (const Vector3& direction : directions()) {
    EXPECT_LT(std::abs(outside(shape, Vector3(3, -1, 2) + 0.2 * direction)), 3e-3 * 0.2);
    EXPECT_TRUE(shape.boxes.at(0).contains(Vector3(3, -1, 2) + 0.2 * direction));
  }
}

TEST(RigidShapes, OfACylinderHaveFlatEndsAndARoundMantle) {
  const RigidShape shape = make_shape(obstacle_of(Shape::cylinder));
  EXPECT_EQ(shape.planes.size(), static_cast<std::size_t>(cylinder_facets) + 2U);
  const Vector3 axis = Vector3(1, 2, 2) / 3, at(3, -1, 2);
  EXPECT_NEAR(outside(shape, at + 0.25 * axis), 0.0, 1e-14);
  EXPECT_NEAR(outside(shape, at - 0.3 * axis), 0.05, 1e-14);
  for (const Vector3& direction : directions()) {
    const Vector3 across = direction.cross(axis).normalized();
    EXPECT_LT(std::abs(outside(shape, at + 0.1 * axis + 0.2 * across)), 1e-3 * 0.2);
    EXPECT_TRUE(shape.boxes.at(0).contains(at + 0.2499 * axis + 0.2 * across));
  }
}

TEST(RigidShapes, OfASurfaceAreTheCellsUnderIt) {
  scene::Obstacle obstacle = obstacle_of(Shape::surface);
  obstacle.mesh = IDIOPHONE_SOURCE_DIR "/meshes/bar.geo";
  obstacle.parameters = {{"length", 0.2}, {"width", 0.04}, {"thickness", 0.02}, {"size", 0.03}};
  const RigidShape shape = make_shape(obstacle);
  ASSERT_EQ(shape.planes.size(), 4 * shape.boxes.size());
  EXPECT_EQ(shape.first_plane.size(), shape.boxes.size() + 1);
  Box whole;
  for (std::size_t part = 0; part < shape.boxes.size(); ++part) {
    EXPECT_LT(outside(shape, shape.boxes[part].center(), part), shape.boxes[part].diagonal().norm());
    whole.extend(shape.boxes[part]);
  }
  EXPECT_LT((whole.sizes() - Vector3(0.2, 0.04, 0.02)).norm(), 1e-9);
  EXPECT_NEAR(whole.center().y(), -1.0, 1e-9);  // where the obstacle is
}

TEST(RigidShapes, PointAtTheMeshThatIsNotThere) {
  scene::Obstacle obstacle = obstacle_of(Shape::surface);
  obstacle.mesh = "nothing.stl";
  obstacle.mesh_where = {"deck.yaml", 7, 3};
  try {
    static_cast<void>(make_shape(obstacle));
    FAIL();
  } catch (const deck::DeckError& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("deck.yaml:7:3: "));
    EXPECT_THAT(error.what(), testing::HasSubstr("nothing.stl"));
  }
}

ON_RANKS(1, 3);

TEST(RigidShapes, AreTheSameOnAllRanks) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  const RigidShape whole = make_shape(obstacle_of(Shape::cylinder));
  const RigidShape shape = broadcast(rank == 0 ? whole : RigidShape{}, MPI_COMM_WORLD);
  ASSERT_EQ(shape.planes.size(), whole.planes.size());
  for (std::size_t i = 0; i < whole.planes.size(); ++i) {
    EXPECT_EQ(shape.planes[i].normal, whole.planes[i].normal);
    EXPECT_EQ(shape.planes[i].point, whole.planes[i].point);
  }
  EXPECT_EQ(shape.exterior, whole.exterior);
  EXPECT_EQ(shape.first_plane, whole.first_plane);
  EXPECT_EQ(shape.boxes.at(0).min(), whole.boxes.at(0).min());
  EXPECT_EQ(shape.boxes.at(0).max(), whole.boxes.at(0).max());
}

}  // namespace
}  // namespace idiophone::contact
