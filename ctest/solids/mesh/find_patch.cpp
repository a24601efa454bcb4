#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "idiophone/solids/mesh/faces.hpp"
#include "ranks.hpp"
#include "samples.hpp"

namespace idiophone::mesh {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Mesh unit_tetrahedron() {
  Mesh mesh;
  mesh.element = element::tet4;
  mesh.nodes = unit_corners();
  mesh.elements = {0, 1, 2, 3};
  mesh.surface = exterior_triangles(mesh);
  return mesh;
}

scene::PatchPlace place(const Vector3& at, double radius = 0.0) {
  return {.at = at, .radius = radius, .where = {.file = "deck.yaml", .line = 3, .column = 4}};
}

ON_RANKS(1);

TEST(FindPatch, APointHasTheLinearWeightsOfItsTriangle) {
  const Mesh mesh = unit_tetrahedron();
  const Patch patch = find_patch(mesh, place({0.5, 0.2, -0.05}));  // below the face z = 0
  ASSERT_THAT(patch.nodes, ElementsAre(0, 1, 2));
  EXPECT_NEAR(patch.shares[0], 0.3, 1e-14);
  EXPECT_NEAR(patch.shares[1], 0.5, 1e-14);
  EXPECT_NEAR(patch.shares[2], 0.2, 1e-14);
}

TEST(FindPatch, APointAtANodeOrOnAnEdgeTakesNoOthers) {
  const Mesh mesh = unit_tetrahedron();
  EXPECT_THAT(find_patch(mesh, place({0, 1.05, 0})).nodes, ElementsAre(2));
  const Patch edge = find_patch(mesh, place({0.25, 0.75, 0}));
  EXPECT_THAT(edge.nodes, ElementsAre(1, 2));
  EXPECT_NEAR(edge.shares[0], 0.25, 1e-14);
}

TEST(FindPatch, ARadiusWeighsNodesByTheAreaAroundThem) {
  const Patch patch = find_patch(unit_tetrahedron(), place({0, 0, 0}, 1.0));
  EXPECT_THAT(patch.nodes, ElementsAre(0, 1, 2, 3));
  const double around_origin = 1.5;
  const double around_others = 1.0 + std::sqrt(3.0) / 2.0;
  EXPECT_NEAR(patch.shares[0], around_origin / (around_origin + 3 * around_others), 1e-14);
  EXPECT_NEAR(std::accumulate(patch.shares.begin(), patch.shares.end(), 0.0), 1.0, 1e-14);
}

TEST(FindPatch, OnAPlateTheSharesAddUpAndCentreOnThePoint) {
  const Mesh plate = read_mesh(shipped("square_plate.geo", element::tet10, {{"size", 0.05}}));
  const Vector3 at(0.075, 0.05, 0.003);
  const Patch patch = find_patch(plate, place(at));
  Vector3 centre = Vector3::Zero();
  for (std::size_t i = 0; i < patch.nodes.size(); ++i) {
    centre += patch.shares[i] * plate.nodes[patch.nodes[i]];
  }
  EXPECT_NEAR((centre - at).norm(), 0.0, 1e-14);
}

TEST(FindPatch, RefusesAPointOffTheSurfaceAndSaysTheNearest) {
  try {
    static_cast<void>(find_patch(unit_tetrahedron(), place({0.2, 0.3, -0.5})));
    FAIL() << "a point far from the surface was taken";
  } catch (const deck::DeckError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("deck.yaml:3:4:"), HasSubstr("0.5 m away, is [0.2, 0.3, 0]")));
  }
}

TEST(FindPatch, RefusesARadiusThatHoldsNoNode) {
  EXPECT_THROW(static_cast<void>(find_patch(unit_tetrahedron(), place({0.3, 0.3, 0}, 0.1))), deck::DeckError);
}

}  // namespace
}  // namespace idiophone::mesh
