#include "idiophone/air/waves/cut_cells.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "ranks.hpp"
#include "ringing.hpp"
#include "sub_voxels.hpp"

namespace idiophone::waves {
namespace {

/// 32 x 32 x 32 cells of 1 cm about the origin.
Subdomain whole() {
  const Grid grid{.corner = Vector3::Constant(-0.16), .cell = 0.01, .cells = {32, 32, 32}, .layer = 4};
  return {grid, grid.all()};
}

CutCells cells_of(const radiation::Solid& solid, const Vector3& shift) {
  const auto positions = positions_of(solid, shift);
  return {whole(), {solid.triangles, positions}, WaveField::largest_courant};
}

/// Volume of the cells that are no air, in cells.
double solid_volume(const CutCells& cells) {
  double volume = 0.0;
  for (const SolidRun& run : cells.solids()) {
    volume += run.length;
  }
  std::map<std::array<int, 3>, int> air;
  for (const Node& node : cells.nodes()) {
    air[node.cell] += count(node.mask);
  }
  for (const auto& [cell, voxels] : air) {
    volume += 1.0 - voxels / 512.0;
  }
  return volume;
}

ON_RANKS(1);

TEST(SubVoxels, AreConnectedByFaces) {
  Mask two{};
  two[0] = 0b11;
  two[1] = 0b10;
  two[2] = 0b01;  // touches by an edge only
  EXPECT_EQ(count(connected(first_voxel(two), two)), 3);
  EXPECT_EQ(count(connected(first_voxel(full_mask), full_mask)), 512);
}

TEST(SubVoxels, HaveLayersAlongEachAxis) {
  Mask one{};
  one[2] = std::uint64_t{1} << (8 * 3 + 5);  // x 5, y 3, z 2
  EXPECT_NE(layers_along(one, 0)[5], 0U);
  EXPECT_NE(layers_along(one, 1)[3], 0U);
  EXPECT_NE(layers_along(one, 2)[2], 0U);
}

TEST(CutCells, HaveTheVolumeOfTheSolid) {
  const auto sphere = radiation::icosphere(0.1, 16);
  const double volume = 4.0 / 3.0 * std::numbers::pi * 1000.0;  // in cells of 1 cm
  for (const Vector3& shift : {Vector3(0, 0, 0), Vector3(0.0037, 0.0011, -0.0042)}) {
    EXPECT_NEAR(solid_volume(cells_of(sphere, shift)) / volume, 1.0, 2e-3);
  }
  const auto cube = radiation::box(Vector3(0.1, 0.08, 0.06), {2, 2, 2});  // its faces lie in planes of the grid
  EXPECT_NEAR(solid_volume(cells_of(cube, Vector3::Zero())), 480.0, 1e-9);
}

TEST(CutCells, HaveLinksThatGoBothWays) {
  const CutCells cells = cells_of(radiation::icosphere(0.1, 16), Vector3(0.001, 0.002, 0.003));
  std::map<std::pair<Index, Index>, float> areas;
  for (Index node = 0; node < static_cast<Index>(cells.nodes().size()); ++node) {
    const auto [first, last] = cells.links_of(node);
    for (Index link = first; link < last; ++link) {
      const Index to = cells.links()[link].to - whole().length();
      if (to >= 0) {
        areas[{node, to}] = cells.links()[link].area;
      } else {
        EXPECT_EQ(cells.links()[link].area, 1.0F);  // open air is not cut
      }
    }
  }
  EXPECT_GT(areas.size(), 100U);
  for (const auto& [ends, area] : areas) {
    EXPECT_EQ((areas[{ends.second, ends.first}]), area);
  }
}

TEST(CutCells, HaveTwoNodesWhereASheetDividesThem) {
  const auto sheet = radiation::box(Vector3(0.2, 0.2, 0.002), {2, 2, 1});
  const CutCells cells = cells_of(sheet, Vector3(0.0, 0.0, 0.005));
  const auto [first, last] = cells.nodes_of({16, 16, 16});
  EXPECT_EQ(last - first, 2);
  // No way leads through it: nodes on one side are linked with nodes on that side alone.
  for (Index node = first; node < last; ++node) {
    const bool below = node == first;
    const auto [from, to] = cells.links_of(node);
    EXPECT_EQ(to - from, 5);
    for (Index link = from; link < to; ++link) {
      const Index other = cells.links()[link].to - whole().length();
      ASSERT_GE(other, 0);
      const auto& there = cells.nodes()[other];
      EXPECT_TRUE(below ? contains(there.mask, {4, 4, 0}) : contains(there.mask, {4, 4, 7}));
    }
  }
}

/// A hollow sphere about the origin.
radiation::Solid shell(double radius, double thickness) {
  radiation::Solid shell = radiation::icosphere(radius, 16);
  const radiation::Solid inner = radiation::icosphere(radius - thickness, 16);
  const auto first = static_cast<Index>(shell.vertices.size());
  shell.vertices.insert(shell.vertices.end(), inner.vertices.begin(), inner.vertices.end());
  for (const auto& [a, b, c] : inner.triangles) {
    shell.triangles.push_back({first + a, first + c, first + b});
  }
  return shell;
}

TEST(CutCells, KeepAirInAShellThatIsThinnerThanASubVoxel) {
  WaveField field(Division(whole().grid(), 1), WaveField::largest_courant, MPI_COMM_SELF);
  field.set_surfaces(cells_of(shell(0.1, 1e-5), Vector3(0.001, 0.002, 0.003)));
  const Index centre = whole().number({16, 16, 16});
  field.set_pressure(centre, 1.0F);
  const std::vector<float> still(field.cut_cells().nodes().size());
  for (int step = 0; step < 60; ++step) {
    field.step(still);
  }
  EXPECT_NE(field.pressure(centre), 0.0F);
  for_each_cell(whole().cells(), [&](const std::array<int, 3>& cell) {
    const Vector3 place = whole().grid().corner + 0.01 * Vector3(cell[0] + 0.5, cell[1] + 0.5, cell[2] + 0.5);
    if (place.norm() > 0.12) {
      ASSERT_EQ(field.pressure(whole().number(cell)), 0.0F) << place.transpose();
    }
  });
}

TEST(CutCells, KeepTheirSidesWhereASheetIsThinnerThanASubVoxel) {
  for (const double height : {0.0049, 0.005, 0.0055, 0.0061}) {  // between centres and on them
    const CutCells cells = cells_of(radiation::box(Vector3(0.2, 0.2, 1e-5), {2, 2, 1}), Vector3(0.0, 0.0, height));
    const auto [first, last] = cells.nodes_of({16, 16, 16});
    ASSERT_EQ(last - first, 2) << height;
    EXPECT_EQ(count(cells.nodes()[first].mask) + count(cells.nodes()[first + 1].mask), 7 * 64) << height;
  }
}

}  // namespace
}  // namespace idiophone::waves
