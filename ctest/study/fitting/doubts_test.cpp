// When a fit is not accepted.

#include <gmock/gmock.h>

#include "bars.hpp"
#include "doubts.hpp"
#include "material_fit.hpp"
#include "ranks.hpp"

namespace idiophone::fitting {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The lines of a board that can only move by its 40 lowest modes.
struct Board {
  StrainedBody body;
  Measurements measured;
};

/// A board of spruce, whose deck has the grain along it.
/// @param degrees      by which its grain is turned about its normal
/// @param uncertainty  cents, that is stated for its exact lines
Board board_of(double degrees, double uncertainty) {
  scene::Scene scene = bar_scene({0.3, 0.12, 0.004}, 0.1, 4);
  scene.materials = {spruce()};
  Board board{StrainedBody(scene, eigenmodes::MassMatrix::consistent).reduced(40), {}};
  TurnedMaterial turned = spruce();
  turned.turns = {0, 0, degrees};
  StrainedBody body = board.body;
  const Eigen::VectorXd frequencies = body.lowest(turned, 15).frequencies(turned);
  for (const double frequency : frequencies.head(15)) {
    board.measured.lines.push_back({.frequency = frequency, .uncertainty = uncertainty});
  }
  return board;
}

Identification fit_of(const Board& board) {
  return identify(board.body, board.measured, {.constants = {"young_x", "young_y", "shear_xy", "turn_z"}});
}

/// A fit of ten lines and two constants that are all so far away.
Identification fit_with(double cents, double mesh_error) {
  Identification fit;
  fit.constants = {{.name = "young"}, {.name = "poisson"}};
  const AssignedLine line{.line = {.frequency = 440, .uncertainty = 3},
                          .first_mode = 1,
                          .modes = 1,
                          .computed = 440,
                          .cents = cents,
                          .mesh_error = mesh_error,
                          .is_fitted = true};
  fit.lines.assign(10, line);
  add_residuals(fit);
  add_doubts(50, fit);
  return fit;
}

ON_RANKS(1);

// 99.9 % of chi-squared with 8 degrees of freedom are below 26.12, so 10 (cents/3)^2 may be that.
TEST(Doubts, AreOfResidualsBeyondChance) {
  EXPECT_THAT(fit_with(4.8, 0).doubts, IsEmpty());
  const Identification beyond = fit_with(4.9, 0);
  EXPECT_EQ(beyond.freedom, 8);
  EXPECT_NEAR(beyond.chi_squared, 26.68, 0.01);
  ASSERT_EQ(beyond.doubts.size(), 1U);
  EXPECT_THAT(beyond.doubts[0], HasSubstr("4.9 cents away from their modes"));
  EXPECT_THAT(beyond.doubts[0], HasSubstr("8 degrees of freedom"));
  EXPECT_THAT(beyond.doubts[0],
              HasSubstr("uncertainties and errors of the mesh 1.8 times as large explain the distances"));
}

TEST(Doubts, AreNotOfResidualsThatTheMeshExplains) {
  EXPECT_THAT(fit_with(6, 3).doubts, IsEmpty());
  EXPECT_FALSE(fit_with(7, 3).doubts.empty());
}

TEST(Doubts, AreOfResidualsThatOnlyACoarseMeshExplains) {
  EXPECT_THAT(fit_with(8.9, 30).doubts, IsEmpty());
  const Identification hidden = fit_with(9.1, 30);
  EXPECT_LT(hidden.chi_squared, 2);
  ASSERT_EQ(hidden.doubts.size(), 1U);
  EXPECT_THAT(hidden.doubts[0], HasSubstr("9.1 cents away from their modes"));
  EXPECT_THAT(hidden.doubts[0], HasSubstr("The errors of the mesh, 30.0, may explain that"));
}

// The grain is turned so far that no start of the search leads there. The constants make up for it, but not well
// enough.
TEST(Doubts, AreOfAFitInAWrongMinimum) {
  const Identification right = fit_of(board_of(20, 5));
  EXPECT_THAT(right.doubts, IsEmpty());
  const Identification wrong = fit_of(board_of(70, 5));
  EXPECT_GT(std::abs(std::abs(wrong.constants.back().value) - 70), 20);
  EXPECT_LT(*wrong.fitted_rms, 3 * 5);
  EXPECT_THAT(wrong.doubts, Contains(HasSubstr("Chi-squared")));
}

}  // namespace
}  // namespace idiophone::fitting
