// The turns of a material's axes in its body, from lines that the program computed with them.

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>
#include <string_view>

#include "axis_symmetries.hpp"
#include "bars.hpp"
#include "fit_names.hpp"
#include "idiophone/study/fitting/identification.hpp"
#include "idiophone/study/partials/compare.hpp"
#include "long_verification.hpp"
#include "material_fit.hpp"
#include "ranks.hpp"
#include "strained_body.hpp"

namespace idiophone::fitting {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A crystal whose axes are those of its mesh.
scene::Material crystal(scene::Symmetry symmetry, const std::vector<double>& constants) {
  scene::Material material{"crystal", 0, 0, 2330, {}, {}};
  material.crystal = {symmetry, constants};
  material.young = scene::constants_along_axes(material)->young.maxCoeff();
  return material;
}

const scene::Material silicon = crystal(scene::Symmetry::cubic, {165.7e9, 63.9e9, 79.6e9});
const scene::Material magnesium = crystal(scene::Symmetry::hexagonal, {59.7e9, 26.2e9, 21.7e9, 61.7e9, 16.4e9});
const scene::Material fibres = crystal(scene::Symmetry::hexagonal, {14e9, 7e9, 6e9, 140e9, 5e9});

/// A block of three different sides.
scene::Scene turned_block_of(const scene::Material& material) {
  scene::Scene scene = bar_scene({0.03, 0.025, 0.02}, 0.03, 4);
  scene.materials = {material};
  return scene;
}

/// A quarter-sawn plate.
scene::Scene board_of(const scene::Material& material) {
  scene::Scene scene = bar_scene({0.3, 0.12, 0.004}, 0.1, 4);
  scene.materials = {material};
  return scene;
}

TurnedMaterial turned(const scene::Material& material, const Vector3& turns) {
  TurnedMaterial result = material;
  result.turns = turns;
  return result;
}

/// A material whose constants differ from those of another by up to a tenth.
scene::Material tenth_off(const scene::Material& material) {
  TurnedMaterial guess = material;
  double factor = 0.93;
  for (const ElasticConstant& constant : elastic_constants(material)) {
    constant.in(guess) *= factor;
    factor = factor < 1 ? 1.08 : 0.93;
  }
  return guess;
}

/// The lowest lines as if measured: each is moved by up to a cent, to and fro.
Measurements lines_of_turned(StrainedBody body, const TurnedMaterial& material, Eigen::Index count, double cents = 1) {
  constexpr int pairs = 5;  // at most, of modes that are one line
  const Eigen::VectorXd frequencies =
      body.lowest(material, static_cast<int>(count) + pairs).frequencies(material).head(count);
  Measurements measured;
  for (Eigen::Index m = 0; m < count; ++m) {
    const double moved = cents * std::sin(1.7 * static_cast<double>(m * m));
    measured.lines.push_back({.frequency = frequencies[m] * std::exp2(moved / 1200), .uncertainty = 2});
  }
  return measured;
}

StrainedBody free_body(const scene::Scene& scene) {
  return {scene, eigenmodes::MassMatrix::consistent};
}

const IdentifiedConstant& named(const Identification& found, std::string_view name) {
  return *std::ranges::find(found.constants, name, &IdentifiedConstant::name);
}

Vector3 turns_found(const Identification& found) {
  return {named(found, "turn_x").value, named(found, "turn_y").value, named(found, "turn_z").value};
}

/// Requires that the fit of a body of such a material has no doubts, and that the intervals hold the truth.
void expect_constants(const Identification& found, const TurnedMaterial& material) {
  EXPECT_THAT(found.doubts, ::testing::IsEmpty());
  TurnedMaterial truth = material;
  for (const ElasticConstant& constant : elastic_constants(material)) {
    const IdentifiedConstant& value = named(found, constant.name);
    EXPECT_NEAR(value.value, constant.in(truth), value.half_width) << constant.name;
  }
}

/// Fits a body of such a material.
Identification identify_turned(const scene::Scene& scene, const TurnedMaterial& material, Eigen::Index lines,
                               const std::vector<std::string>& fit) {
  scene::Scene deck = scene;
  deck.materials = {tenth_off(material)};
  Identification found = identify(deck, lines_of_turned(free_body(scene), material, lines), {.constants = fit});
  expect_constants(found, material);
  return found;
}

/// A quarter-sawn plate of spruce that can only move by its lowest modes: it is fitted in a second.
StrainedBody reduced_board(const scene::Material& material) {
  return free_body(board_of(material)).reduced(80);
}

/// Requires that the turns, or their equivalents in a block, are those.
void expect_turns(const Identification& found, const Vector3& truth) {
  const Vector3 widths{named(found, "turn_x").half_width, named(found, "turn_y").half_width,
                       named(found, "turn_z").half_width};
  std::vector<Vector3> all = found.equivalent_turns;
  all.push_back(turns_found(found));
  EXPECT_TRUE(std::ranges::any_of(
      all, [&](const Vector3& turns) { return ((turns - truth).array().abs() <= widths.array()).all(); }))
      << "found " << turns_found(found).transpose() << " +- " << widths.transpose();
  EXPECT_LT(widths.maxCoeff(), 6);
}

ON_RANKS(1);

TEST(TurnedMaterial, TurnsAreAboutItsOwnAxes) {
  const Vector3 turns{20, -35, 50};
  EXPECT_LT((turns_of(turned(silicon, turns).turn()) - turns).norm(), 1e-12);
  const Eigen::Matrix3d first = turned(silicon, {20, -35, 0}).turn();
  const Eigen::AngleAxisd about_own_z(50 * std::numbers::pi / 180, first.col(2));
  EXPECT_LT((turned(silicon, turns).turn() - about_own_z * first).norm(), 1e-12);
}

TEST(AxisSymmetries, AreThoseOfTheCrystalSystems) {
  EXPECT_EQ(symmetries_of(silicon).size(), 24U);
  EXPECT_EQ(symmetries_of(spruce()).size(), 4U);
  EXPECT_EQ(symmetries_of(magnesium).size(), 16U) << "8 by quarters and 12 by sixths, of which 4 are both";
  EXPECT_EQ(symmetries_of(crystal(scene::Symmetry::trigonal, {87e9, 7e9, 12e9, -18e9, 106e9, 58e9, 0})).size(), 6U);
  EXPECT_TRUE(is_round_about(2, turned(magnesium, {10, 20, 30})));
  EXPECT_FALSE(is_round_about(1, turned(magnesium, {10, 20, 30})));
  EXPECT_FALSE(is_round_about(2, silicon));
}

TEST(AxisSymmetries, AreThoseOfABox) {
  const Eigen::Matrix3d askew = turned(silicon, {10, 20, 30}).turn();
  EXPECT_EQ(symmetries_of_box(askew, {3, 2, 1}).size(), 4U);
  EXPECT_EQ(symmetries_of_box(askew, {3, 2, 2}).size(), 8U);
  EXPECT_EQ(symmetries_of_box(askew, {2, 2, 2}).size(), 24U);
  for (const Eigen::Matrix3d& rotation : symmetries_of_box(askew, {3, 2, 1})) {
    EXPECT_NEAR(std::abs(askew.col(0).dot(rotation * askew.col(0))), 1, 1e-12);
  }
}

TEST(FitNames, StandForConstantsAndTurns) {
  EXPECT_THAT(names_to_fit(silicon, {}), ElementsAre("c11", "c12", "c44"));
  EXPECT_THAT(names_to_fit(silicon, {"c44", "turns"}), ElementsAre("c44", "turn_x", "turn_y", "turn_z"));
  EXPECT_THAT(names_to_fit(silicon, {"constants", "turn_y"}), ElementsAre("c11", "c12", "c44", "turn_y"));
  const auto refusal = [](const scene::Material& material, const std::string& name) -> std::string {
    try {
      static_cast<void>(names_to_fit(material, {name}));
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_THAT(refusal(silicon, "trun_x"), HasSubstr("did you mean 'turn_x'"));
  EXPECT_THAT(refusal({"steel", 2e11, 0.3, 7850, {}, {}}, "turn_x"), HasSubstr("steel is the same in all directions"));
}

TEST(Turns, OfACubicCrystalAboutOneAxis) {
  const Identification found =
      identify_turned(turned_block_of(silicon), turned(silicon, {0, 0, 20}), 15, {"constants", "turn_z"});
  const IdentifiedConstant& turn = named(found, "turn_z");
  EXPECT_NEAR(std::abs(turn.value), 20, turn.half_width);
  EXPECT_LT(turn.half_width, 1.5);
  ASSERT_EQ(found.equivalent_turns.size(), 1U);
  EXPECT_LT((found.equivalent_turns[0] - Vector3(0, 0, -turn.value)).norm(), 1e-9);
  EXPECT_LT((*found.grain - turned(silicon, {0, 0, turn.value}).turn()).norm(), 1e-12);
}

TEST(Turns, OfTheGrainOfASpruceBoard) {
  const TurnedMaterial truth = turned(spruce(), {0, 0, 20});
  const StrainedBody board = reduced_board(tenth_off(spruce()));
  const Identification found =
      identify(board, lines_of_turned(board, truth, 12), {.constants = {"constants", "turn_z"}});
  expect_constants(found, truth);
  EXPECT_NEAR(std::abs(named(found, "turn_z").value), 20, named(found, "turn_z").half_width);
  EXPECT_LT(named(found, "turn_z").half_width, 3);
}

TEST(Turns, OfACubicCrystalAboutThreeAxes) {
  LONG_VERIFICATION();
  for (const Vector3& turns : {Vector3(5, -8, 12), Vector3(20, 5, -15)}) {
    expect_turns(identify_turned(turned_block_of(silicon), turned(silicon, turns), 25, {"constants", "turns"}), turns);
  }
}

// A turn about the fibres cannot be heard.
TEST(Turns, OfFibres) {
  LONG_VERIFICATION();
  const Identification found =
      identify_turned(turned_block_of(fibres), turned(fibres, {15, 10, 0}), 25, {"constants", "turns"});
  const IdentifiedConstant& about_fibres = named(found, "turn_z");
  EXPECT_TRUE(about_fibres.has_no_effect);
  EXPECT_FALSE(about_fibres.determined);
  EXPECT_EQ(about_fibres.value, 0);
  for (const auto& [name, truth] : {std::pair{"turn_x", 15}, {"turn_y", 10}}) {
    EXPECT_TRUE(named(found, name).determined);
    EXPECT_NEAR(std::abs(named(found, name).value), truth, named(found, name).half_width);
  }
}

// The derivatives by the turn are zero there. At an end of the interval the lines are so far away that it is beyond
// chance.
TEST(Turns, IntervalOfAxesThatLieAlongTheBody) {
  StrainedBody body = reduced_board(spruce());
  const Identification found = identify(body, lines_of_turned(body, spruce(), 12, 0), {.constants = {"turn_z"}});
  const IdentifiedConstant& turn = named(found, "turn_z");
  EXPECT_TRUE(turn.determined);
  EXPECT_LT(std::abs(turn.value), turn.half_width);
  EXPECT_LT(turn.half_width, 5);
  const auto squares = [&](double degrees) {
    const TurnedMaterial there = turned(spruce(), {0, 0, degrees});
    const Eigen::VectorXd now = body.lowest(there, 12).frequencies(there);
    const Eigen::VectorXd aligned = body.lowest(spruce(), 12).frequencies(spruce());
    double sum = 0;
    for (Eigen::Index m = 0; m < 12; ++m) {
      sum += std::pow(partials::cents(now[m], aligned[m]) / 2, 2);
    }
    return sum;
  };
  EXPECT_GT(squares(turn.value + turn.half_width), 3.84) << "with the constants held, lines are farther away";
  EXPECT_LT(squares(0.2 * turn.half_width), 1);
}

// By the symmetry of the block: half turns about its axes.
TEST(Turns, EquivalentsSoundTheSame) {
  const scene::Scene block = turned_block_of(silicon);
  StrainedBody body = free_body(block);
  const Identification found =
      identify(block, lines_of_turned(body, turned(silicon, {6, -9, 12}), 15), {.constants = {"turns"}});
  ASSERT_EQ(found.equivalent_turns.size(), 3U);
  const TurnedMaterial one = turned(silicon, turns_found(found));
  const Eigen::VectorXd frequencies = body.lowest(one, 15).frequencies(one);
  for (const Vector3& turns : found.equivalent_turns) {
    EXPECT_LT((turns.cwiseAbs() - one.turns.cwiseAbs()).norm(), 1e-9);
    EXPECT_GT(turns.prod() * one.turns.prod(), 0) << "two signs change";
    const TurnedMaterial other = turned(silicon, turns);
    EXPECT_LT((body.lowest(other, 15).frequencies(other) - frequencies).cwiseQuotient(frequencies).norm(), 1e-7);
  }
}

/// Spruce with other moduli and axes, by chance.
TurnedMaterial some_spruce(std::mt19937& generator) {
  std::uniform_real_distribution<double> factor(0.9, 1.1), angle(-25, 25);
  TurnedMaterial wood = spruce();
  for (const ElasticConstant& constant : elastic_constants(wood)) {
    constant.in(wood) *= constant.kind == ConstantKind::modulus ? factor(generator) : 1;
  }
  for (double& turn : wood.turns) {
    turn = angle(generator);
  }
  return wood;
}

/// Forty lines that are wrong by a standard deviation of 2 cents.
Measurements noisy_lines_of(const StrainedBody& body, const TurnedMaterial& wood, std::mt19937& generator) {
  std::normal_distribution<double> error(0, 2);
  Measurements measured = lines_of_turned(body, wood, 40, 0);
  for (Line& line : measured.lines) {
    line.frequency *= std::exp2(error(generator) / 1200);
  }
  std::ranges::sort(measured.lines, {}, &Line::frequency);
  return measured;
}

// Nine constants and three turns are much for one body: many fits end in wrong minima. Signs are those of an
// equivalent.
TEST(Turns, NoFitOfWoodIsWrongWithoutADoubt) {
  LONG_VERIFICATION();
  constexpr int bodies = 20;
  std::mt19937 generator(1);
  const StrainedBody body = free_body(turned_block_of(spruce())).reduced(120);
  int accepted = 0;
  for (int n = 0; n < bodies; ++n) {
    const TurnedMaterial wood = some_spruce(generator);
    const Measurements measured = noisy_lines_of(body, wood, generator);
    const Identification found = identify(body, measured, {.constants = {"constants", "turns"}});
    const bool is_right = (turns_found(found).cwiseAbs() - wood.turns.cwiseAbs()).lpNorm<Eigen::Infinity>() < 1;
    EXPECT_TRUE(is_right || !found.doubts.empty()) << "body " << n;
    accepted += found.doubts.empty() ? 1 : 0;
    std::printf("%d: %d solves, chi-squared %.1f of %d\n", n, found.solves, found.chi_squared, found.freedom);
  }
  std::printf("%d of %d fits of wood are accepted\n", accepted, bodies);
  EXPECT_GE(accepted, bodies / 2);
}

// Lines of three modes tell little of three turns, so what is expected counts.
TEST(Turns, AreExpectedToBeAsSmallAsTheUserSays) {
  const StrainedBody body = free_body(turned_block_of(silicon)).reduced(60);
  const Measurements measured = lines_of_turned(body, turned(silicon, {1, -1, 1}), 3);
  const auto widest = [&](std::optional<double> deviation) {
    const Identification found = identify(body, measured, {.constants = {"turns"}, .turn_deviation = deviation});
    return std::ranges::max(found.constants, {}, &IdentifiedConstant::half_width).half_width;
  };
  constexpr double degree = std::numbers::pi / 180;
  EXPECT_LT(widest(2 * degree), 4.0) << "1.96 standard deviations of 2 degrees";
  EXPECT_GT(widest(std::nullopt), 8.0);
}

// Of the same eight bodies, five fits are accepted if turns are expected within 17 degrees.
TEST(Turns, OfWoodThatAreExpectedToBeSmallEndInFewerWrongMinima) {
  LONG_VERIFICATION();
  constexpr int bodies = 8;
  std::mt19937 generator(1);
  const StrainedBody body = free_body(turned_block_of(spruce())).reduced(120);
  int accepted = 0;
  for (int n = 0; n < bodies; ++n) {
    TurnedMaterial wood = some_spruce(generator);
    wood.turns /= 5;
    const Measurements measured = noisy_lines_of(body, wood, generator);
    const Identification found =
        identify(body, measured, {.constants = {"constants", "turns"}, .turn_deviation = 0.07});
    const bool is_right = (turns_found(found).cwiseAbs() - wood.turns.cwiseAbs()).lpNorm<Eigen::Infinity>() < 1;
    EXPECT_TRUE(is_right || !found.doubts.empty()) << "body " << n;
    accepted += found.doubts.empty() ? 1 : 0;
  }
  EXPECT_GE(accepted, 7);
}

// Each is as likely as the other three, so the nearest counts.
TEST(Turns, IntervalsHoldTheTruth) {
  LONG_VERIFICATION();
  constexpr int bodies = 100;
  std::mt19937 generator(37);
  std::normal_distribution<double> error(0, 5);
  std::uniform_real_distribution<double> angle(-25, 25);
  scene::Scene scene = turned_block_of(silicon);
  const StrainedBody body = free_body(scene).reduced(60);
  int inside = 0, of_modulus = 0;
  for (int n = 0; n < bodies; ++n) {
    const double truth = angle(generator);
    Measurements measured = lines_of_turned(body, turned(silicon, {0, 0, truth}), 15, 0);
    for (Line& line : measured.lines) {
      line.frequency *= std::exp2(error(generator) / 1200);
      line.uncertainty = 5;
    }
    std::ranges::sort(measured.lines, {}, &Line::frequency);
    const Identification found = identify(body, measured, {.constants = {"constants", "turn_z"}});
    const IdentifiedConstant& turn = named(found, "turn_z");
    inside += std::abs(std::abs(turn.value) - std::abs(truth)) <= turn.half_width ? 1 : 0;
    of_modulus += std::abs(named(found, "c44").value - 79.6e9) <= named(found, "c44").half_width ? 1 : 0;
  }
  std::printf("the intervals hold the turn in %d and c44 in %d of %d bodies\n", inside, of_modulus, bodies);
  EXPECT_NEAR(inside, 95, 5);
  EXPECT_NEAR(of_modulus, 95, 5);
}

}  // namespace
}  // namespace idiophone::fitting
