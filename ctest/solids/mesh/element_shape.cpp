#include "element_shape.hpp"
#include "ranks.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

namespace idiophone::mesh {
namespace {

/// The regular tetrahedron of edge sqrt(8), volume 8/3, with straight edges.
ElementShape regular(element::Type type) {
  ElementShape shape{.type = type, .nodes = std::vector<Vector3>(10)};
  auto& x = shape.nodes;
  x[0] = {1, 1, 1}, x[1] = {-1, 1, -1}, x[2] = {1, -1, -1}, x[3] = {-1, -1, 1};
  x[4] = (x[0] + x[1]) / 2, x[5] = (x[1] + x[2]) / 2, x[6] = (x[0] + x[2]) / 2;
  x[7] = (x[0] + x[3]) / 2, x[8] = (x[1] + x[3]) / 2, x[9] = (x[2] + x[3]) / 2;
  x.resize(element::node_count(type));
  return shape;
}

ON_RANKS(1);

TEST(ElementShape, KnowsARegularTetrahedron) {
  for (const auto type : {element::tet4, element::tet10}) {
    const auto shape = regular(type);
    EXPECT_NEAR(volume_of(shape), 8.0 / 3.0, 1e-14);
    EXPECT_NEAR(quality_of(shape), 1.0, 1e-14);
    EXPECT_NEAR(centre_of(shape).norm(), 0.0, 1e-15);
    for (const double length : edge_lengths(shape)) {
      EXPECT_NEAR(length, std::sqrt(8.0), 1e-15);
    }
  }
}

TEST(ElementShape, QualityDoesNotDependOnSizeButVolumeDoes) {
  auto shape = regular(element::tet10);
  for (auto& node : shape.nodes) {
    node = 1e-4 * node + Vector3(3, 2, 1);
  }
  EXPECT_NEAR(quality_of(shape), 1.0, 1e-9);
  EXPECT_NEAR(volume_of(shape), 8.0 / 3.0 * 1e-12, 1e-20);
}

TEST(ElementShape, AMirroredElementIsNegative) {
  auto shape = regular(element::tet4);
  std::swap(shape.nodes[0], shape.nodes[1]);
  EXPECT_NEAR(volume_of(shape), -8.0 / 3.0, 1e-14);
  EXPECT_NEAR(quality_of(shape), -1.0, 1e-14);
}

TEST(ElementShape, AMidNodeTooNearACornerInvertsThere) {
  auto shape = regular(element::tet10);
  shape.nodes[4] = 0.8 * shape.nodes[0] + 0.2 * shape.nodes[1];  // the limit is at a quarter of the edge
  EXPECT_GT(volume_of(shape), 0.0);
  EXPECT_LT(quality_of(shape), 0.0);
}

TEST(ElementShape, ABulgingFaceAddsItsVolume) {
  // Moving the middle of edge 01 by d adds the integral of 4 L0 L1 d . n over the two faces at the edge: A/3 each,
  // exactly, as long as the quadratic terms vanish for one moved node.
  auto shape = regular(element::tet10);
  const Vector3 outward = Vector3(0, 1, 0);
  shape.nodes[4] += 0.01 * outward;
  const auto& x = shape.nodes;
  const Vector3 areas = ((x[2] - x[0]).cross(x[1] - x[0]) + (x[1] - x[0]).cross(x[3] - x[0])) / 2.0;
  EXPECT_NEAR(volume_of(shape), 8.0 / 3.0 + 0.01 * outward.dot(areas) / 3.0, 1e-14);
}

}  // namespace
}  // namespace idiophone::mesh
