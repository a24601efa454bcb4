// Subdomains of a grid, and cells that are computed in any of them.

#include "idiophone/air/waves/division.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "cell_update.hpp"
#include "idiophone/air/waves/wave_field.hpp"
#include "ranks.hpp"

namespace idiophone::waves {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// The cells of the largest subdomain over those of each if all had as many.
double fullness(const Division& division) {
  std::size_t largest = 0;
  for (int rank = 0; rank < division.ranks(); ++rank) {
    largest = std::max(largest, division.cells(rank).size());
  }
  return static_cast<double>(largest * division.ranks()) / static_cast<double>(division.grid().all().size());
}

ON_RANKS(1);

TEST(Division, GivesEachCellToOneRank) {
  const Grid grid{.cells = {96, 21, 13}};
  for (const int ranks : {1, 2, 3, 7, 64, 97, 96 / 16 * 21 * 13}) {
    const Division division(grid, ranks);
    std::vector<int> owners(grid.all().size());
    for (int rank = 0; rank < ranks; ++rank) {
      const CellBox& cells = division.cells(rank);
      EXPECT_FALSE(cells.is_empty());
      EXPECT_EQ(cells.from[0] % Grid::row_multiple + cells.to[0] % Grid::row_multiple, 0);
      for_each_cell(cells, [&](const std::array<int, 3>& cell) { ++owners[grid.all().place(cell)]; });
    }
    EXPECT_TRUE(std::ranges::all_of(owners, [](int count) { return count == 1; })) << ranks;
  }
}

TEST(Division, IsEvenAndHasShortFaces) {
  const Grid grid{.cells = {96, 84, 53}};
  for (const int ranks : {2, 3, 4, 7, 16, 31, 64, 97}) {
    EXPECT_LT(fullness(Division(grid, ranks)), 1.12) << ranks;
  }
  const CellBox cells = Division(grid, 64).cells(0);
  EXPECT_THAT((std::array{cells.width(0), cells.width(1), cells.width(2)}), testing::ElementsAre(96, 11, 7));
}

TEST(Division, EachFaceIsThatOfBothNeighbours) {
  const Grid grid{.cells = {96, 21, 13}};
  const Division division(grid, 97);
  for (int rank = 0; rank < division.ranks(); ++rank) {
    const CellBox& own = division.cells(rank);
    std::size_t inside = 0;  // sides of its cells at another rank's
    for (const Face& face : division.faces(rank)) {
      inside += face.ghost_cells.size();
      for_each_cell(face.ghost_cells, [&](const std::array<int, 3>& cell) {
        EXPECT_TRUE(division.cells(face.neighbour).contains(cell));
      });
      const std::vector<Face> back = division.faces(face.neighbour);
      EXPECT_EQ(std::ranges::count_if(back,
                                      [&](const Face& other) {
                                        return other.neighbour == rank && other.axis == face.axis &&
                                               other.direction == -face.direction &&
                                               other.ghost_cells.size() == face.ghost_cells.size();
                                      }),
                1);
    }
    std::size_t sides = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t side = own.size() / own.width(axis);
      sides += side * ((own.from.at(axis) > 0) + (own.to.at(axis) < grid.cells.at(axis)));
    }
    EXPECT_EQ(inside, sides);
  }
}

TEST(Division, RefusesMoreRanksThanItCanUse) {
  const Grid grid{.cells = {32, 3, 2}};
  EXPECT_EQ(Division(grid, 12).ranks(), 12);
  EXPECT_THAT(([&] { static_cast<void>(Division(grid, 13)); }),
              ThrowsMessage<std::runtime_error>(HasSubstr("32 x 3 x 2 cells cannot be shared by 13 ranks")));
}

TEST(CellUpdate, HasTheSameBitsInAnyBoxes) {
  const Grid grid{.cells = {64, 50, 45}, .layer = 20};  // layers that are cut along all axes
  const Subdomain all(grid, grid.all());
  constexpr auto largest = static_cast<float>(WaveField::largest_courant);
  CellUpdate whole(all, grid.all(), largest);
  std::vector<CellUpdate> parts;
  const Division division(grid, 300);
  for (int rank = 0; rank < division.ranks(); ++rank) {
    parts.emplace_back(all, division.cells(rank), largest);
  }
  std::vector<float> pressure(all.length()), expected(all.length()), found(all.length());
  std::mt19937 random(1);
  for (int step = 0; step < 4; ++step) {
    for_each_cell(grid.all(), [&](const std::array<int, 3>& cell) {
      pressure[all.number(cell)] = std::uniform_real_distribution(-1.0F, 1.0F)(random);
    });
    for (int z = 0; z < grid.cells[2]; ++z) {
      whole.add_rates(z, pressure, expected);
    }
    for (CellUpdate& part : parts) {
      for (int z = part.cells().from[2]; z < part.cells().to[2]; ++z) {
        part.add_rates(z, pressure, found);
      }
    }
    ASSERT_EQ(found, expected) << step;
  }
}

}  // namespace
}  // namespace idiophone::waves
