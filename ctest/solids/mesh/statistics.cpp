#include "idiophone/solids/mesh/statistics.hpp"

#include <gtest/gtest.h>

#include "idiophone/solids/mesh/faces.hpp"
#include "ranks.hpp"
#include "samples.hpp"

namespace idiophone::mesh {
namespace {

ON_RANKS(1);

TEST(Statistics, OfTwoElementsNamesTheWorse) {
  Mesh mesh;
  mesh.element = element::tet4;
  mesh.nodes = unit_corners();
  mesh.nodes.emplace_back(0.1, 0.1, -0.01);
  mesh.elements = {0, 1, 2, 3, 0, 2, 1, 4};
  mesh.surface = exterior_triangles(mesh);
  const Statistics found = statistics(mesh);
  EXPECT_EQ(found.nodes, 5);
  EXPECT_EQ(found.elements, 2);
  EXPECT_EQ(found.triangles, 6);
  EXPECT_NEAR(found.smallest_edge, std::sqrt(0.0201), 1e-15);
  EXPECT_NEAR(found.largest_edge, std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(found.volume, 1.01 / 6.0, 1e-15);
  EXPECT_EQ(found.worst_element, 1);
  const double mean_square = (1 + 1 + 2 + 0.0201 + 2 * 0.8201) / 6;  // of edge lengths: (0.9^2 + 0.1^2 + 0.01^2) twice
  EXPECT_NEAR(found.worst_quality, 6 * std::sqrt(2.0) * (0.01 / 6) / std::pow(mean_square, 1.5), 1e-14);
}

TEST(NodalAreas, OfAUnitTetrahedron) {
  const std::vector<Vector3> nodes = unit_corners();
  const std::vector<Triangle> faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  const std::vector<double> areas = nodal_areas(faces, nodes);
  const double slanted = std::sqrt(3.0) / 2;
  EXPECT_NEAR(areas[0], 3 * 0.5 / 3, 1e-15);
  for (const std::size_t node : {1, 2, 3}) {
    EXPECT_NEAR(areas[node], (2 * 0.5 + slanted) / 3, 1e-15);
  }
}

}  // namespace
}  // namespace idiophone::mesh
