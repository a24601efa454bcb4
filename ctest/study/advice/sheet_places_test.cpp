// Sheets in the cells of waves.

#include "idiophone/study/advice/sheet_places.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "boxes.hpp"
#include "idiophone/foundation/parallel/communicator.hpp"
#include "ranks.hpp"

namespace idiophone::advice {
namespace {

constexpr double cell = 0.01;  // m

/// A plate of 200 x 200 mm above a block, which sets where the grid begins; a rank has every other triangle.
bodies::Preparation plate_over_block(double height, double thickness, double tilt = 0.0) {
  Surface sheet, block;
  add_box(sheet, {0, 0, height}, {0.2, 0.2, height + thickness}, 4);
  add_box(block, {0, 0, -0.1}, {0.05, 0.05, -0.05}, 2);
  const Eigen::AngleAxisd turn(tilt, Vector3::UnitX());
  bodies::Preparation ready;
  mesh::Part& part = ready.part;
  for (const Surface& surface : {sheet, block}) {
    const auto body = static_cast<Index>(ready.scene.bodies.size());
    const auto first = static_cast<Index>(part.reference.size());
    for (const Vector3& node : surface.nodes) {
      const auto vertex = static_cast<Index>(part.reference.size());
      part.reference.emplace_back(body == 0 ? Vector3(turn * node) : node);
      part.vertices.push_back(vertex);
      part.vertex_ids.push_back(vertex);
    }
    ready.offsets.triangles.push_back(part.global_triangles);
    for (const auto& [a, b, c] : surface.triangles) {
      if (part.global_triangles % parallel::size_of(MPI_COMM_WORLD) == parallel::rank_of(MPI_COMM_WORLD)) {
        part.surface.push_back({a + first, b + first, c + first});
        part.triangle_ids.push_back(part.global_triangles);
        part.triangle_body.push_back(body);
      }
      ++part.global_triangles;
    }
    ready.scene.bodies.emplace_back().name = body == 0 ? "plate" : "block";
  }
  ready.offsets.triangles.push_back(part.global_triangles);
  part.bodies.resize(ready.scene.bodies.size());
  part.global_vertices = static_cast<Index>(part.reference.size());
  ready.scene.radiation.model = scene::RadiationModel::waves;
  ready.scene.radiation.grid.cell = cell;
  return ready;
}

/// The grid begins 0.29 of a cell and whole cells below the block, at z = -0.1 m.
double at_place(double place) {
  return (place - 0.29) * cell;
}

std::string warning(const bodies::Preparation& ready) {
  const auto all = sheet_warnings(ready, MPI_COMM_WORLD);
  EXPECT_FALSE(all.at(1).has_value());  // a block is no sheet
  return all.at(0).value_or("");
}

ON_RANKS(1, 3);

TEST(Sheets, OutermostEighthsAreDoubted) {
  constexpr double film = 1e-4;
  for (const double place : {0.02, 0.11, 0.89, 0.98}) {
    EXPECT_THAT(warning(plate_over_block(at_place(place) - film / 2, film)),
                testing::HasSubstr("body plate: its sheet at z = "))
        << place;
  }
  for (const double place : {0.14, 0.5, 0.86}) {
    EXPECT_EQ(warning(plate_over_block(at_place(place) - film / 2, film)), "") << place;
  }
}

TEST(Sheets, ThickOnesReachTheOutermostEighthEarlier) {
  const double thick = 0.5 * cell;  // reaches 3/16 of a cell farther than the room of the thinnest sheet
  EXPECT_NE(warning(plate_over_block(at_place(0.30) - thick / 2, thick)), "");
  EXPECT_EQ(warning(plate_over_block(at_place(0.33) - thick / 2, thick)), "");
  EXPECT_EQ(warning(plate_over_block(at_place(0.05), 0.7 * cell)), "");  // no sheet
}

TEST(Sheets, WhatIsTiltedOrMovesOrIsHeardOtherwiseIsNotDoubted) {
  const double height = at_place(0.95);
  EXPECT_EQ(warning(plate_over_block(height, 1e-4, 0.1)), "");
  bodies::Preparation ready = plate_over_block(height, 1e-4);
  ready.scene.bodies[0].velocity = {0, 0, 1};
  EXPECT_EQ(warning(ready), "");
  ready = plate_over_block(height, 1e-4);
  ready.scene.gravity = {0, 0, -9.81};
  EXPECT_EQ(warning(ready), "");
  ready.scene.bodies[0].fixed.emplace_back();
  EXPECT_NE(warning(ready), "");
  ready.scene.radiation.model = scene::RadiationModel::kirchhoff;
  EXPECT_EQ(warning(ready), "");
}

TEST(Sheets, MoveInwardsAsTheWarningSays) {
  bodies::Preparation ready = plate_over_block(at_place(0.95), 1e-4);
  EXPECT_THAT(warning(ready), testing::HasSubstr("radiation.margin: 0.003125 moves it inwards"));
  ready.scene.radiation.grid.margin = 0.00313;
  EXPECT_EQ(warning(ready), "");
  ready = plate_over_block(0.0095, 1e-4);
  ready.scene.radiation.floor = scene::Floor{};
  ready.scene.radiation.floor->at = {0, 0, -0.1};  // the grid begins here: no margin moves it
  EXPECT_THAT(warning(ready), testing::HasSubstr("radiation.cell: "));
}

}  // namespace
}  // namespace idiophone::advice
