// The outer layer of a body, on the whole and on each rank.

#include "idiophone/solids/contact/skin.hpp"

#include <gtest/gtest.h>

#include <set>

#include "block_mesh.hpp"
#include "local_skin.hpp"
#include "overlapping_blocks.hpp"
#include "ranks.hpp"

namespace idiophone::contact {
namespace {

ON_RANKS(1);

TEST(Skin, OfAQuadraticBlockFillsItWithStraightTetrahedra) {
  for (const element::Type element : {element::tet4, element::tet10}) {
    Block block(element, {1, 1, 1}, {1, 1, 1}, [](const Vector3& x) { return x; });
    double volume = 0.0;
    double surface = 0.0;
    for (const Index cell : block.cells()) {
      const Tetrahedron shape = block.side.tetrahedron(cell);
      EXPECT_GT(shape.volume, 0.0);
      volume += shape.volume;
    }
    for (const double area : block.skin.areas) {
      surface += area;
    }
    EXPECT_NEAR(volume, 1, 1e-14);
    EXPECT_NEAR(surface, 6, 1e-14);
    int exterior = 0;
    for (const auto& faces : block.skin.exterior) {
      exterior += faces[0] + faces[1] + faces[2] + faces[3];
    }
    EXPECT_EQ(exterior, element == element::tet4 ? 12 : 48);
  }
}

TEST(Skin, LeavesOutTheInsideOfABody) {
  const mesh::Mesh mesh = support::block_mesh(element::tet4, {5, 5, 5}, {5, 5, 5});
  const Skin skin = make_skin(mesh, 0);
  EXPECT_EQ(skin.cells.size(), 6U * (125U - 27U));  // six for each cube of the outer layer
  EXPECT_EQ(skin.nodes.size(), 216U - 8U);          // all corners of these cubes: the others are the innermost cube's
}

TEST(Skin, HasTheSmallestHeightOfItsCells) {
  const mesh::Mesh mesh = support::block_mesh(element::tet4, {3, 3, 0.3}, {3, 3, 1});
  // Cubes of 1 x 1 x 0.3, cut along their diagonals: the flattest height is that above a face through two of them.
  double least = 1e300;
  for (Index e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.element_nodes(e);
    const auto at = [&](int i) { return mesh.nodes[nodes[i]]; };
    const double volume = std::abs((at(1) - at(0)).dot((at(2) - at(0)).cross(at(3) - at(0)))) / 6;
    for (int i = 0; i < 4; ++i) {
      const Vector3 a = at((i + 1) % 4), b = at((i + 2) % 4), c = at((i + 3) % 4);
      least = std::min(least, 3 * volume / ((b - a).cross(c - a).norm() / 2));
    }
  }
  EXPECT_NEAR(make_skin(mesh, 0).thinnest, least, 1e-14);
}

TEST(Skin, NumbersItsNodesFromTheBodysFirstOne) {
  const mesh::Mesh mesh = support::block_mesh(element::tet4, {1, 1, 1}, {2, 2, 2});
  const Skin first = make_skin(mesh, 0), later = make_skin(mesh, 1000);
  ASSERT_EQ(first.nodes.size(), later.nodes.size());
  for (std::size_t i = 0; i < first.nodes.size(); ++i) {
    EXPECT_EQ(later.nodes[i], first.nodes[i] + 1000);
  }
  EXPECT_EQ(first.cells, later.cells);
}

/// The part of a mesh whose nodes in the given range are owned; the others are ghosts.
mesh::Part part_of(const mesh::Mesh& mesh, Index begin, Index end) {
  mesh::Part part;
  part.owned_nodes = end - begin;
  for (Index node = begin; node < end; ++node) {
    part.node_ids.push_back(node);
  }
  for (Index node = 0; node < static_cast<Index>(mesh.nodes.size()); ++node) {
    if (node < begin || node >= end) {
      part.node_ids.push_back(node);
    }
  }
  return part;
}

TEST(LocalSkins, OwnEachNodeOnceAndHaveAllNodesOfTheirCells) {
  const mesh::Mesh mesh = support::block_mesh(element::tet10, {1, 1, 1}, {2, 2, 2});
  const Skin skin = make_skin(mesh, 0);
  const auto nodes = static_cast<Index>(mesh.nodes.size());
  std::multiset<Index> owned;
  std::set<Index> cells;
  for (const auto& [begin, end] : {std::pair<Index, Index>{0, nodes / 3}, {nodes / 3, nodes - 5}, {nodes - 5, nodes}}) {
    const mesh::Part part = part_of(mesh, begin, end);
    const LocalSkin local = find_local_skin(skin, part);
    std::set<Index> here;
    for (const SkinNode& node : local.nodes) {
      EXPECT_EQ(part.node_ids[node.node], skin.nodes[node.place]);
      here.insert(node.place);
    }
    for (const SkinNode& node : local.owned) {
      EXPECT_LT(node.node, part.owned_nodes);
      EXPECT_TRUE(here.contains(node.place));
      owned.insert(node.place);
    }
    for (const Index cell : local.cells) {
      cells.insert(cell);
      for (const Index place : skin.cells[cell]) {
        EXPECT_TRUE(here.contains(place));
      }
    }
  }
  EXPECT_EQ(owned.size(), skin.nodes.size());
  EXPECT_EQ(std::set<Index>(owned.begin(), owned.end()).size(), skin.nodes.size());
  EXPECT_EQ(cells.size(), skin.cells.size());
}

TEST(LocalSkins, TakeTheStatesOfTheirNodes) {
  const mesh::Mesh mesh = support::block_mesh(element::tet4, {1, 1, 1}, {1, 1, 1});
  const Skin skin = make_skin(mesh, 0);
  Side side(skin);
  side.reference[3] = {1, 2, 3};
  std::vector<solid::NodeState> state(8);
  state[5] = {.displacement = {0.1, 0.2, 0.3}, .velocity = {4, 5, 6}};
  update({3, 5}, state, side);
  EXPECT_LT((side.position[3] - Vector3(1.1, 2.2, 3.3)).norm(), 1e-15);
  EXPECT_EQ(side.velocity[3], Vector3(4, 5, 6));
}

}  // namespace
}  // namespace idiophone::contact
