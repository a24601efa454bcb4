// Fracture surfaces along which no body can break.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "breakable_block.hpp"
#include "ranks.hpp"

namespace idiophone::mesh {
namespace {

ON_RANKS(1);

TEST(Divide, RefusesWhatIsNoSurfaceInside) {
  Breakable block({on_x});
  block.name("nowhere");
  EXPECT_EQ(block.refusal().find("deck.yaml:9:5: the mesh has no group 'nowhere'"), 0U) << block.refusal();
  block.body.fracture.pop_back();
  block.name("x0");
  EXPECT_EQ(
      block.refusal(),
      "deck.yaml:9:5: bodies.block.fracture: the surface 'x0' has faces on the outside of the body, where nothing "
      "joins");
  block.body.fracture.pop_back();
  block.mesh.groups["line"] = {block.mesh.groups.at("0")[0], block.mesh.groups.at("0")[1]};
  block.name("line");
  EXPECT_EQ(block.refusal(),
            "deck.yaml:9:5: bodies.block.fracture: the surface 'line' has no faces inside the body: name a Physical "
            "Surface of gmsh that is embedded in the volume, or lies between two volumes");
  block.body.fracture.pop_back();
  block.mesh.groups["again"] = block.mesh.groups.at("0");
  block.name("again");
  EXPECT_EQ(block.refusal(), "deck.yaml:9:5: bodies.block.fracture: the surface 'again' shares faces with '0'");
}

TEST(Divide, RefusesASurfaceThatDividesNothing) {
  Breakable block({on_x});
  const Mesh whole = divide(block.mesh, block.body);
  const auto is_inside = [&](Index node) {
    const Vector3& place = whole.nodes[node];
    return std::min(place.y(), place.z()) > 1e-9 && std::max(place.y(), place.z()) < block_size.y() - 1e-9;
  };
  // One face all of whose edges are inside the body: all of it is its rim.
  const auto face = std::ranges::find_if(whole.fracture_faces, [&](const FractureFace& each) {
    return std::all_of(each.nodes[0].begin() + 3, each.nodes[0].end(), is_inside);
  });
  ASSERT_NE(face, whole.fracture_faces.end());
  const auto of_face = [&](Index node) {
    return std::ranges::any_of(face->nodes[0], [&](Index k) { return whole.nodes[k] == block.mesh.nodes[node]; });
  };
  std::erase_if(block.mesh.groups.at("0"), [&](Index node) { return !of_face(node); });
  EXPECT_EQ(
      block.refusal(),
      "deck.yaml:9:5: bodies.block.fracture: the surface '0' divides nothing: all its nodes are on its rim inside "
      "the body. Make it finer");
}

TEST(Divide, RefusesAFaceWithCrossingsAtAllEdges) {
  const auto is_outside = [](const Vector3& node) {
    return node.minCoeff() < 1e-9 || (block_size - node).minCoeff() < 1e-9;
  };
  const auto is_corner = [](const Vector3& node) {
    return (node / 0.1 - (node / 0.1).array().round().matrix()).norm() < 1e-9;
  };
  // All faces inside the body that have no edge on its outside.
  const Breakable block({[&](const Vector3& node) { return is_corner(node) || !is_outside(node); }});
  EXPECT_NE(block.refusal().find("the surface '0' is too coarse at"), std::string::npos) << block.refusal();
}

}  // namespace
}  // namespace idiophone::mesh
