// The lists of pairs of cells that may overlap, while the partners move: no overlap is missed.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "near_pairs.hpp"
#include "overlapping_blocks.hpp"
#include "ranks.hpp"
#include "side_cell.hpp"

namespace idiophone::contact {
namespace {

constexpr double wide = 5.0;  // m: all cells are candidates

Block shaken(double z) {
  return Block(element::tet4, {1, 1, 0.5}, {3, 3, 1},
               [z, shake = Shaker(0.02)](const Vector3& x) mutable { return Vector3(shake(x) + Vector3(0, 0, z)); });
}

Overlaps overlaps_of(const NearPairs& pairs, const Side& first, const Side& second) {
  Overlaps overlaps;
  for (const auto& [a, b] : pairs.found()) {
    overlaps.add(SideCell(first, a).view(), SideCell(second, b).view());
  }
  return overlaps;
}

/// Overlaps of all cells with all others.
Overlaps overlaps_of_all(const Block& first, const Block& second) {
  Overlaps overlaps;
  for (const Index a : first.cells()) {
    for (const Index b : second.cells()) {
      overlaps.add(SideCell(first.side, a).view(), SideCell(second.side, b).view());
    }
  }
  return overlaps;
}

ON_RANKS(1);

TEST(NearPairs, MissNoOverlapOfSidesThatMove) {
  Block lower = shaken(0.0), upper = shaken(0.7);
  NearPairs pairs(lower.side, &upper.side, nullptr);
  pairs.choose_candidates(lower.cells(), upper.cells(), wide);
  std::size_t most = 0;
  const Vector3 flight(0.3, 0.2, 0.1);      // of both at each move, far compared with their cells
  for (int move = 0; move < 120; ++move) {  // the upper one passes through the lower one and turns
    for (Vector3& x : upper.side.position) {
      const Vector3 before = x - move * flight;
      x += flight + Vector3(0.002, -0.002 * before.x(), -0.01 + 0.005 * before.y());
    }
    for (Vector3& x : lower.side.position) {
      x += flight;
    }
    pairs.find();
    const Overlaps found = overlaps_of(pairs, lower.side, upper.side);
    const Overlaps all = overlaps_of_all(lower, upper);
    ASSERT_EQ(found.cells().size(), all.cells().size()) << move;
    ASSERT_EQ(found.faces().size(), all.faces().size()) << move;
    for (std::size_t i = 0; i < all.cells().size(); ++i) {
      ASSERT_EQ(found.cells()[i].cell, all.cells()[i].cell) << move;
      ASSERT_EQ(found.cells()[i].overlap, all.cells()[i].overlap) << move;
    }
    most = std::max(most, all.cells().size());
  }
  EXPECT_GT(most, 50U);
}

/// One tetrahedron.
struct Single {
  explicit Single(const std::array<Vector3, 4>& corners)
      : skin{.nodes = {0, 1, 2, 3},
             .areas = std::vector<double>(4, 1.0),
             .cells = {{0, 1, 2, 3}},
             .exterior = {{1, 1, 1, 1}},
             .thinnest = 0.2},
        side(skin) {
    std::ranges::copy(corners, side.position.begin());
  }
  Skin skin;
  Side side;
};

TEST(NearPairs, MissNoCornerThatMovesInsideOfItsCellsBox) {
  const Vector3 up = Vector3(1, -1, 1), aside(1, 1, 0), across = up.cross(aside) / 3;
  Single still({0.45 * up, 0.25 * up + 0.1 * aside, 0.25 * up - 0.1 * aside + 0.1 * across,
                0.25 * up - 0.1 * aside - 0.1 * across});
  Single moving({0.05 * up, Vector3(-1, -1, 0), Vector3(1, 0, -1), Vector3(0, 1, 1)});  // three corners span the box
  for (Single* one : {&still, &moving}) {
    if (one->side.tetrahedron(0).volume < 0) {
      std::swap(one->side.position[2], one->side.position[3]);
    }
  }
  NearPairs pairs(still.side, &moving.side, nullptr);
  pairs.choose_candidates({0}, {0}, wide);
  pairs.find();
  EXPECT_TRUE(pairs.found().empty()) << "the planes of their faces keep them apart";
  const Box before = moving.side.box(0);
  moving.side.position[0] = 0.4 * up;
  ASSERT_TRUE(moving.side.box(0).isApprox(before));
  pairs.find();
  EXPECT_EQ(pairs.found().size(), 1U);
  EXPECT_GT(overlaps_of(pairs, still.side, moving.side).volume(), 0.0);
}

TEST(NearPairs, OfABodyWithItselfLeaveOutCellsThatItsElementsKeepApart) {
  Block plate(element::tet4, {8, 8, 1}, {8, 8, 1}, [](const Vector3& x) { return x; });
  NearPairs pairs(plate.side, &plate.side, nullptr);
  pairs.choose_candidates(plate.cells(), plate.cells(), wide);
  EXPECT_TRUE(pairs.any_candidates());
  pairs.find();
  EXPECT_TRUE(pairs.found().empty()) << "cells that are flat in one plane are apart";
}

TEST(NearPairs, AreForgotten) {
  Block lower = shaken(0.0), upper = shaken(0.2);
  NearPairs pairs(lower.side, &upper.side, nullptr);
  pairs.choose_candidates(lower.cells(), upper.cells(), wide);
  pairs.find();
  EXPECT_FALSE(pairs.found().empty());
  pairs.clear();
  EXPECT_TRUE(pairs.found().empty());
  pairs.find();
  EXPECT_FALSE(pairs.found().empty());
  pairs.clear_all();
  EXPECT_FALSE(pairs.any_candidates());
  EXPECT_TRUE(pairs.found().empty());
}

}  // namespace
}  // namespace idiophone::contact
