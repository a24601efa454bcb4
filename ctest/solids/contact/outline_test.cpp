// The triangles of obstacles: closed surfaces of the right size that face outwards.

#include "idiophone/solids/contact/outline.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "ranks.hpp"

namespace idiophone::contact {
namespace {

struct Measures {
  Vector3 area = Vector3::Zero();  ///< of all triangles as vectors: zero for a closed surface
  double size = 0.0;               ///< of the surface, m2
  double volume = 0.0;             ///< m3, positive where normals point outwards
};

Measures measure(const scene::Obstacle& obstacle) {
  Measures sum;
  for (const auto& [a, b, c] : outline(make_shape(obstacle))) {
    const Vector3 area = (b - a).cross(c - a) / 2;
    sum.area += area;
    sum.size += area.norm();
    sum.volume += area.dot(a) / 3;
  }
  return sum;
}

scene::Obstacle obstacle(scene::Obstacle::Shape shape) {
  scene::Obstacle result;
  result.shape = shape;
  result.at = {3, -1, 2};
  result.size = {0.1, 0.2, 0.3};
  result.rotation = {0.3, -0.2, 0.7};
  result.radius = 0.2;
  result.length = 0.5;
  result.direction = Vector3(1, 2, 2) / 3;
  return result;
}

void expect(const Measures& found, double size, double volume, double tolerance) {
  EXPECT_LT(found.area.norm(), 1e-9 * size);
  EXPECT_NEAR(found.size / size, 1.0, tolerance);
  EXPECT_NEAR(found.volume / volume, 1.0, tolerance);
}

ON_RANKS(1);

TEST(Outline, OfABoxIsItsFaces) {
  expect(measure(obstacle(scene::Obstacle::Shape::box)), 2 * (0.02 + 0.06 + 0.03), 0.006, 1e-12);
}

TEST(Outline, OfASphereIsClosed) {
  constexpr double pi = std::numbers::pi;
  expect(measure(obstacle(scene::Obstacle::Shape::sphere)), 4 * pi * 0.04, 4 * pi / 3 * 0.008, 2e-3);
}

TEST(Outline, OfACylinderIsClosed) {
  constexpr double pi = std::numbers::pi;
  expect(measure(obstacle(scene::Obstacle::Shape::cylinder)), 2 * pi * 0.2 * 0.7, pi * 0.04 * 0.5, 1e-3);
}

TEST(Outline, OfASurfaceIsItsSkinAlone) {
  scene::Obstacle block = obstacle(scene::Obstacle::Shape::surface);
  block.mesh = IDIOPHONE_SOURCE_DIR "/meshes/bar.geo";
  block.parameters = {{"length", 0.2}, {"width", 0.04}, {"thickness", 0.02}, {"size", 0.03}};
  expect(measure(block), 2 * (0.2 * 0.04 + 0.2 * 0.02 + 0.04 * 0.02), 0.2 * 0.04 * 0.02, 1e-9);
}

TEST(Outline, OfAHalfSpaceIsEmpty) {
  EXPECT_TRUE(outline(make_shape(obstacle(scene::Obstacle::Shape::half_space))).empty());
}

}  // namespace
}  // namespace idiophone::contact
