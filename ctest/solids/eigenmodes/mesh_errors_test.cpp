// Estimated errors of frequencies against solutions of high order.

#include "idiophone/solids/eigenmodes/mesh_errors.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "idiophone/solids/eigenmodes/spread_mesh_errors.hpp"
#include "long_verification.hpp"
#include "mapped_block.hpp"
#include "ranks.hpp"
#include "refined_problem.hpp"
#include "refined_values.hpp"
#include "samples.hpp"

namespace idiophone::eigenmodes {
namespace {

/// Requires what docs/method/modes.md says of each mode: the error is at most twice the estimate, and at least a tenth.
/// Errors below `unheard` cents may be anything.
void expect_honest(const std::vector<Judged>& modes, std::size_t at_least, double unheard = 0.3) {
  EXPECT_GE(modes.size(), at_least);
  for (const auto& [frequency, estimate, error] : modes) {
    EXPECT_LT(std::abs(error), 2 * std::abs(estimate) + unheard) << frequency << " Hz: " << estimate;
    EXPECT_GT(std::abs(error), 0.1 * std::abs(estimate) - unheard) << frequency << " Hz: " << estimate;
  }
}

MappedBlock long_bar() {
  return {.name = "bar", .size = {0.3, 0.03, 0.01}, .exact_cells = {6, 1, 1}, .exact_type = element::hex(6, 4)};
}

/// Half as thick in the middle as at the ends.
MappedBlock undercut_bar() {
  MappedBlock bar = long_bar();
  bar.name = "undercut bar";
  bar.place = [](const Vector3& point) -> Vector3 {
    const double along = 2 * point[0] / 0.3 - 1;
    return {point[0], point[1], 0.01 - (0.01 - point[2]) * (0.4 + 0.6 * along * along)};
  };
  return bar;
}

MappedBlock plate() {
  return {.name = "plate", .size = {0.2, 0.16, 0.004}, .exact_cells = {4, 4, 1}, .exact_type = element::hex(6, 3)};
}

ON_RANKS(1);

TEST(MeshErrors, BarThatBendsAndTwists) {
  LONG_VERIFICATION();
  const MappedBlock bar = long_bar();
  const ExactModes exact(bar, 12);
  expect_honest(judged(bar, exact, element::tet10, {15, 2, 1}, 8), 7);
  expect_honest(judged(bar, exact, element::tet10, {15, 2, 1}, 8, MassMatrix::consistent), 7);
  expect_honest(judged(bar, exact, element::hex(2, 2), {12, 2, 1}, 8), 8);
  expect_honest(judged(bar, exact, element::hex(4, 2), {3, 1, 1}, 8), 8);
}

TEST(MeshErrors, LinearTetrahedraThatLock) {
  const MappedBlock bar = long_bar();
  expect_honest(judged(bar, ExactModes(bar, 12), element::tet4, {30, 3, 2}, 5), 5);
}

TEST(MeshErrors, UndercutBar) {
  LONG_VERIFICATION();
  const MappedBlock bar = undercut_bar();
  const ExactModes exact(bar, 12);
  expect_honest(judged(bar, exact, element::tet10, {15, 2, 1}, 8), 7);
  expect_honest(judged(bar, exact, element::hex(4, 2), {4, 1, 1}, 8), 8);
}

TEST(MeshErrors, FreeAndClampedPlate) {
  LONG_VERIFICATION();
  MappedBlock square = plate();
  expect_honest(judged(square, ExactModes(square, 12), element::tet10, {8, 7, 1}, 8), 7);
  square.is_clamped = true;
  const ExactModes exact(square, 12);
  expect_honest(judged(square, exact, element::tet10, {8, 7, 1}, 8), 7);
  expect_honest(judged(square, exact, element::hex(4, 2), {2, 2, 1}, 8), 7);
}

/// Modes of a wall made from a surface, judged by those of a finer mesh, one by one.
std::vector<Judged> judged_wall(scene::Body body, scene::Body fine, const std::string& held, int count) {
  const auto found = [&](scene::Body& wall) {
    VibratingBody result(mesh::read_mesh(wall));
    result.fix(held);
    return result;
  };
  VibratingBody coarse = found(body);
  const Modes modes = coarse.find({.count = count});
  const Modes exact = found(fine).find({.count = count});
  const std::vector<double> errors = estimates(coarse, modes, MassMatrix::lumped);
  std::vector<Judged> result;
  for (int mode = 0; mode < count; ++mode) {
    const double frequency = modes.modes[mode].frequency;
    result.push_back({frequency, errors[mode], 1200 * std::log2(frequency / exact.modes[mode].frequency)});
  }
  return result;
}

TEST(MeshErrors, Cup) {
  const mesh::TemporaryFile file("cup.geo",
                                 "SetFactory(\"OpenCASCADE\"); DefineConstant[n = 3];"
                                 "Circle(1) = {0, 0, 0, 0.04, 0, Pi}; Circle(2) = {0, 0, 0, 0.04, Pi, 2 * Pi};"
                                 "Extrude {0, 0, 0.09} { Curve{1, 2}; Layers{Round(n / 1.5)}; Recombine; } Coherence;"
                                 "Transfinite Curve {1, 2} = n + 1;"
                                 "Physical Surface(\"wall\") = Surface{:}; Physical Curve(\"bottom\") = {1, 2};");
  scene::Body cup = mesh::body_of(file.path(), element::hex(4, 2), {{"n", 3}});
  cup.thickness = 0.001;
  scene::Body fine = mesh::body_of(file.path(), element::hex(6, 2), {{"n", 3}});
  fine.thickness = 0.001;
  expect_honest(judged_wall(cup, fine, "bottom", 4), 4);
}

TEST(MeshErrors, Bell) {
  LONG_VERIFICATION();
  scene::Body bell = mesh::shipped("bell.geo", element::hex(4, 2));
  bell.thickness = 0.003;
  scene::Body fine = mesh::shipped("bell.geo", element::hex(7, 2));
  fine.thickness = 0.003;
  const std::vector<Judged> modes = judged_wall(bell, fine, "crown", 6);
  expect_honest(modes, 6);
  EXPECT_GT(modes[0].error, 150);  // (2, 0)
  EXPECT_GT(modes[2].error, 100);  // (1, 0), which (3, 1) passes on finer meshes
}

TEST(MeshErrors, AreLeftOutWhereTheyTakeLong) {
  const VibratingBody large = block(element::hex(7, 7), {1, 1, 1}, {5, 5, 4});
  const std::vector<std::vector<double>> shapes(3);
  const std::vector<double> errors =
      mesh_errors(large.scene, {large.mesh}, MassMatrix::lumped, shapes, Estimates::quick).cents;
  EXPECT_TRUE(errors.empty());
  EXPECT_THAT(left_out(errors, 3, Estimates::quick), ::testing::HasSubstr("for none of 3 modes"));
  EXPECT_THAT(left_out(std::vector{1.0, std::nan("")}, 2, Estimates::quick),
              ::testing::HasSubstr("for the lowest 1 of 2 modes"));
  EXPECT_EQ(left_out(std::vector{1.0, 2.0}, 2, Estimates::quick), "");
  EXPECT_THAT(left_out(std::vector{std::nan("")}, 1, Estimates::all), ::testing::HasSubstr("turns inside out"));
  EXPECT_EQ(left_out(errors, 3, Estimates::none), "");
}

TEST(MeshErrors, StoppedByAWatchTheyAreThoseOfTheLowestModes) {
  VibratingBody body = bar();
  const Modes modes = body.find({.count = 20}, MPI_COMM_SELF);
  std::vector<std::vector<double>> shapes;
  std::ranges::transform(modes.modes, std::back_inserter(shapes), &Mode::shape);
  std::size_t told = 0;
  const auto stop = [&](std::size_t done, std::size_t expected) {
    EXPECT_EQ(expected, shapes.size());
    told = done;
    return false;
  };
  const auto all = mesh_errors(body.scene, {body.mesh}, MassMatrix::lumped, shapes, Estimates::all).cents;
  const auto some = mesh_errors(body.scene, {body.mesh}, MassMatrix::lumped, shapes, Estimates::all, stop).cents;
  ASSERT_EQ(some.size(), shapes.size());
  EXPECT_LT(told, shapes.size());
  for (std::size_t mode = 0; mode < some.size(); ++mode) {
    if (mode < told) {
      EXPECT_EQ(some[mode], all[mode]) << mode;
    } else {
      EXPECT_TRUE(std::isnan(some[mode])) << mode;
    }
  }
}

TEST(MeshErrors, SomeModesGainAsMuchAsWithAllBelowThem) {
  VibratingBody body = bar();
  const Modes modes = body.find({.count = 12}, MPI_COMM_SELF);
  std::vector<std::vector<double>> shapes;
  std::ranges::transform(modes.modes, std::back_inserter(shapes), &Mode::shape);
  const RefinedProblem problem(body.scene, {body.mesh}, MassMatrix::lumped, shapes.front());
  const std::vector<std::size_t> numbers = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  const std::vector<std::size_t> chosen = {2, 7, 11};
  const std::vector<RefinedValue> all = refined_values(problem, shapes, numbers, {});
  const std::vector<RefinedValue> some = refined_values(problem, shapes, chosen, {});
  ASSERT_EQ(some.size(), chosen.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const RefinedValue& expected = all[chosen[i]];
    const double gained = expected.interpolated - expected.improved;
    EXPECT_NEAR(some[i].interpolated - some[i].improved, gained, 0.15 * gained) << chosen[i];
  }
}

/// Twice as many modes as a quick estimate has.
TEST(MeshErrors, SpreadOverTheModesTheyAreThoseOfAll) {
  LONG_VERIFICATION();
  VibratingBody cube = block(element::hex(4, 4), {1, 0.9, 0.8}, {3, 3, 3});
  const Modes modes = cube.find({.count = 70, .mass = MassMatrix::consistent}, MPI_COMM_SELF);
  std::vector<std::vector<double>> shapes;
  std::ranges::transform(modes.modes, std::back_inserter(shapes), &Mode::shape);
  const std::vector<double> all = mesh_errors(cube.scene, {cube.mesh}, MassMatrix::consistent, shapes);
  const std::vector<double> some = spread_mesh_errors(cube.scene, {cube.mesh}, MassMatrix::consistent, shapes);
  ASSERT_EQ(some.size(), all.size());
  EXPECT_FALSE(std::isnan(some.front()));
  EXPECT_FALSE(std::isnan(some.back()));
  EXPECT_GT(std::ranges::count_if(some, [](double error) { return std::isnan(error); }), 20);
  for (std::size_t mode = 0; mode < all.size(); ++mode) {
    if (!std::isnan(some[mode])) {
      EXPECT_NEAR(some[mode], all[mode], 0.25 * all[mode] + 0.01) << mode;
    }
  }
}

TEST(MeshErrors, NoModesHaveNoErrors) {
  const VibratingBody body = bar();
  EXPECT_TRUE(mesh_errors(body.scene, {body.mesh}, MassMatrix::lumped, {}).empty());
}

}  // namespace
}  // namespace idiophone::eigenmodes
