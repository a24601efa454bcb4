// Constants that are known, from frequencies that the program computed with them.

#include "idiophone/study/fitting/identification.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "bars.hpp"
#include "long_verification.hpp"
#include "ranks.hpp"
#include "recordings.hpp"
#include "strained_body.hpp"
#include "temporary_sound.hpp"

namespace idiophone::fitting {
namespace {

using ::testing::Each;
using ::testing::Field;

constexpr int solves_for_sizes = 12;

const Vector3 block_sides{0.06, 0.025, 0.02};

scene::Scene block_of(const scene::Material& material) {
  scene::Scene scene = bar_scene(block_sides, 0.03, 4);
  scene.materials = {material};
  return scene;
}

/// The lowest lines of a body as if measured: each is moved by a few cents, to and fro.
Measurements lines_of(const scene::Scene& scene, std::size_t count, double cents, double up_to) {
  StrainedBody body(scene, eigenmodes::MassMatrix::consistent);
  const FrequencyModel model = body.model(scene.materials[0], up_to);
  const Eigen::VectorXd frequencies = model.frequencies(scene.materials[0]);
  Measurements measured;
  for (Eigen::Index m = 0; m < frequencies.size() && measured.lines.size() < count; ++m) {
    const double moved = cents * std::sin(1.7 * static_cast<double>(m * m));
    measured.lines.push_back({.frequency = frequencies[m] * std::exp2(moved / 1200), .uncertainty = 2});
  }
  return measured;
}

const scene::Material aluminium{"aluminium", 7.1e10, 0.34, 2700, {}, {}};

ON_RANKS(1);

TEST(Identify, FindsYoungsModulusAndPoissonsRatioFromFarAway) {
  const Measurements measured = lines_of(block_of(aluminium), 12, 0, 1e5);
  const Identification found = identify(block_of({"guess", 1.1e11, 0.28, 2700, {}, {}}), measured, {});
  EXPECT_NEAR(found.material.young / 7.1e10, 1, 1e-5);
  EXPECT_NEAR(found.material.poisson, 0.34, 1e-5);
  EXPECT_NEAR(found.fitted_rms.value(), 0, 1e-2);
  EXPECT_TRUE(found.missing.empty());
  EXPECT_THAT(found.constants, Each(Field(&IdentifiedConstant::determined, true)));
  EXPECT_EQ(found.constants[0].start, 1.1e11);
}

// 1000 cents are a factor of 3.2 of the moduli.
TEST(Identify, FindsAMaterialWhoseFrequenciesAreAThousandCentsAway) {
  const Measurements measured = lines_of(block_of(aluminium), 12, 1, 1e5);
  for (const double factor : {3.1, 1 / 3.1}) {
    const Identification found = identify(block_of({"guess", factor * 7.1e10, 0.3, 2700, {}, {}}), measured, {});
    EXPECT_NEAR(found.material.young / 7.1e10, 1, 3e-3) << factor;
    EXPECT_TRUE(found.doubts.empty());
  }
}

/// Rosewood, and what a table says of it.
scene::Scene wooden_bar(const scene::Orthotropy& constants) {
  scene::Scene scene = bar_scene({0.38, 0.042, 0.02}, 0.05, 4);
  scene.materials = {{"rosewood", constants.young[0], 0, 840, {}, {}}};
  scene.materials[0].orthotropy = constants;
  return scene;
}

const scene::Orthotropy rosewood{{16.1e9, 2.2e9, 1.1e9}, {0.38, 0.65, 0.45}, {1.7e9, 0.31e9, 1.25e9}};
const scene::Orthotropy table{{13.5e9, 1.9e9, 0.95e9}, {0.38, 0.65, 0.45}, {1.5e9, 0.28e9, 1.1e9}};

TEST(Identify, ABarOfWoodWithTwoFalseLines) {
  LONG_VERIFICATION();
  Measurements measured = lines_of(wooden_bar(rosewood), 16, 2, 1e4);
  measured.lines.erase(measured.lines.begin() + 5);
  for (const double frequency : {2100.0, 5000.0}) {
    measured.lines.push_back({.frequency = frequency});
  }
  std::ranges::sort(measured.lines, {}, &Line::frequency);
  const Identification found = identify(wooden_bar(table), measured, {});
  const ElasticConstants constants = elastic_constants(found.material);
  TurnedMaterial truth = wooden_bar(rosewood).materials[0];
  for (std::size_t k = 0; k < constants.size(); ++k) {
    EXPECT_NEAR(found.constants[k].value, constants[k].in(truth), found.constants[k].half_width) << constants[k].name;
  }
  EXPECT_TRUE(found.constants[0].determined);
  EXPECT_NEAR(found.constants[6].value / 1.7e9, 1, 0.02) << "shear_xy";
  EXPECT_FALSE(found.constants[4].determined) << "no mode of a bar depends on poisson_yz";
  EXPECT_EQ(std::ranges::count(found.lines, 0, &AssignedLine::modes), 2);
  ASSERT_EQ(found.doubts.size(), 1U);
  EXPECT_THAT(found.doubts[0], ::testing::HasSubstr("2 of 17 lines are no mode of the body within 50 cents"));
  EXPECT_LE(found.solves, 12 + solves_for_sizes);
}

TEST(Identify, SaysThatLinesAreFartherAwayThanTheyCanBe) {
  const Measurements measured = lines_of(block_of(aluminium), 12, 30, 1e5);
  const Identification found = identify(block_of(aluminium), measured, {});
  ASSERT_FALSE(found.doubts.empty());
  EXPECT_THAT(found.doubts.back(), ::testing::HasSubstr("cents away from their modes"));
}

TEST(Identify, NamesTheSecondLineOfAModeThatIsSplit) {
  Measurements measured = lines_of(block_of(aluminium), 12, 1, 1e5);
  measured.lines.push_back({.frequency = 1.002 * measured.lines[4].frequency});
  std::ranges::sort(measured.lines, {}, &Line::frequency);
  const Identification found = identify(block_of({"guess", 6e10, 0.3, 2700, {}, {}}), measured, {});
  EXPECT_EQ(std::ranges::count(found.lines, true, &AssignedLine::is_split), 1);
  EXPECT_TRUE(found.doubts.empty());
}

TEST(Identify, StopsWithTheBestValues) {
  const Measurements measured = lines_of(block_of(aluminium), 12, 0, 1e5);
  std::vector<std::string> told;
  const auto watch = [&](const SearchState& state) {
    told.push_back(state.best);
    EXPECT_GT(state.expected, state.solves);
    return state.solves < 3;
  };
  const Identification found = identify(block_of({"guess", 1.1e11, 0.28, 2700, {}, {}}), measured, {.watch = watch});
  EXPECT_TRUE(found.stopped);
  EXPECT_EQ(found.solves, 3);
  EXPECT_NEAR(found.material.young / 7.1e10, 1, 0.02) << "from the first two solves";
  EXPECT_THAT(found.doubts[0], ::testing::HasSubstr("stopped after 3"));
  EXPECT_THAT(told.back(), ::testing::HasSubstr("young 7"));
}

TEST(Identify, StandsMissingModesAndFalseLines) {
  Measurements measured = lines_of(block_of(aluminium), 14, 3, 1e5);
  auto& lines = measured.lines;
  const double false_line = 1.04 * lines[5].frequency;
  lines.erase(lines.begin() + 8);
  lines.erase(lines.begin() + 2);
  lines.push_back({.frequency = false_line});
  std::ranges::sort(lines, {}, &Line::frequency);
  const Identification found = identify(block_of({"guess", 6e10, 0.3, 2700, {}, {}}), measured, {.tolerance = 20});
  for (const IdentifiedConstant& constant : found.constants) {
    const double truth = constant.name == "young" ? 7.1e10 : 0.34;
    EXPECT_NEAR(constant.value, truth, constant.half_width) << constant.name;
    EXPECT_LT(constant.half_width, 0.06 * truth) << constant.name;
  }
  EXPECT_EQ(found.missing.size(), 2U);
  EXPECT_EQ(std::ranges::count(found.lines, 0, &AssignedLine::modes), 1);
  EXPECT_EQ(std::ranges::find(found.lines, 0, &AssignedLine::modes)->line.frequency, false_line);
}

TEST(Identify, PredictsTheLinesThatItDoesNotFit) {
  const Measurements measured = lines_of(block_of(aluminium), 14, 2, 1e5);
  const Identification found = identify(block_of({"guess", 6e10, 0.3, 2700, {}, {}}), measured, {.lines = 8});
  EXPECT_EQ(std::ranges::count(found.lines, true, &AssignedLine::is_fitted), 8);
  EXPECT_LT(found.tested_rms.value(), 4);
}

/// Of the block of aluminium, by hexahedra of order 6 whose own error is below 0.1 cents; Hz.
const std::vector<double> converged{22340.389, 23349.045, 25368.644, 42107.535, 45568.060, 46372.661, 47199.783};

TEST(Identify, IntervalsContainTheErrorOfTheMesh) {
  Measurements measured;
  for (const double frequency : converged) {
    measured.lines.push_back({.frequency = frequency, .uncertainty = 1});
  }
  scene::Scene tetrahedra = bar_scene(block_sides, 0.01, 2);
  tetrahedra.bodies[0].element = element::tet10;
  tetrahedra.bodies[0].parameters["layers"] = 3;
  for (scene::Scene scene : {block_of(aluminium), tetrahedra}) {
    scene.materials = {{"guess", 6.2e10, 0.3, 2700, {}, {}}};
    const Identification found = identify(scene, measured, {});
    for (const IdentifiedConstant& constant : found.constants) {
      const double truth = constant.name == "young" ? aluminium.young : aluminium.poisson;
      EXPECT_NEAR(constant.value, truth, constant.half_width) << constant.name;
    }
    EXPECT_LT(found.constants[0].half_width, 0.03 * aluminium.young);
  }
}

// All five bend the bar one way or the other: Poisson's ratio hardly moves them.
TEST(Identify, FiveLinesOfABarDoNotDeterminePoissonsRatio) {
  scene::Scene slender = bar_scene({0.6, 0.022, 0.02}, 0.1, 4);
  slender.materials = {aluminium};
  const Measurements measured = lines_of(slender, 5, 1, 4e3);
  slender.materials = {{"guess", 6e10, 0.3, 2700, {}, {}}};
  const Identification found = identify(slender, measured, {});
  EXPECT_TRUE(found.constants[0].determined);
  EXPECT_FALSE(found.constants[1].determined);
  EXPECT_EQ(found.material.poisson, 0.3) << "it keeps the deck's value";
  EXPECT_GT(found.constants[1].half_width, 0.1);
  EXPECT_NEAR(found.material.young / 7.1e10, 1, 0.01);
}

// The five lowest modes of the bar bend it. Its first torsion, farther up, tells the shear modulus.
TEST(Identify, AFurtherLineDeterminesWhatItIsNamedFor) {
  scene::Scene slender = bar_scene({0.3, 0.022, 0.02}, 0.1, 3);
  slender.materials = {aluminium};
  Measurements measured = lines_of(slender, 2, 0, 4e3);
  const Measurements all = lines_of(slender, 12, 0, 4e4);
  slender.materials = {{"guess", 6.9e10, 0.3, 2700, {}, {}}};
  const Identification few = identify(slender, measured, {});
  ASSERT_FALSE(few.constants[1].determined);
  ASSERT_EQ(few.further.size(), 1U);
  const FurtherLine& line = few.further.front();
  EXPECT_EQ(line.constant, "poisson");
  EXPECT_GT(line.frequency, measured.lines.back().frequency);
  EXPECT_NEAR(line.direction.norm(), 1, 1e-12);
  EXPECT_NEAR(std::abs(line.direction.x()), 0, 0.1) << "torsion moves across the bar";
  measured.lines.push_back(all.lines[line.first_mode - 1]);
  const Identification more = identify(slender, measured, {});
  EXPECT_TRUE(more.constants[1].determined);
  EXPECT_NEAR(more.constants[1].half_width / line.half_width, 1, 0.5);
  EXPECT_NEAR(more.material.poisson, 0.34, more.constants[1].half_width);
  EXPECT_TRUE(more.further.empty());
}

// The median of all lines would be theirs.
TEST(Identify, AFurtherLineIsNotAsUncertainAsFalseLines) {
  const scene::Scene slender = bar_scene({0.3, 0.022, 0.02}, 0.1, 3);
  Measurements measured = lines_of(slender, 2, 0, 4e3);
  const Identification clean = identify(slender, measured, {});
  const double first = measured.lines[0].frequency;
  for (const double lower : {0.2, 0.25, 0.3}) {
    measured.lines.push_back({.frequency = lower * first, .uncertainty = 90});
  }
  std::ranges::sort(measured.lines, {}, &Line::frequency);
  const Identification with_false_lines = identify(slender, measured, {});
  ASSERT_EQ(clean.further.size(), 1U);
  ASSERT_EQ(with_false_lines.further.size(), 1U);
  EXPECT_NEAR(with_false_lines.further[0].half_width / clean.further[0].half_width, 1, 1e-3);
}

TEST(Identify, OneLineAndAPair) {
  scene::Scene square = bar_scene({0.08, 0.02, 0.02}, 0.04, 4);
  square.materials = {aluminium};
  Measurements measured = lines_of(square, 8, 0, 1e5);
  const double first = measured.lines[0].frequency;
  measured.lines.push_back({.frequency = 1.0002 * first});  // both bendings, split by an imperfection of the body
  std::ranges::sort(measured.lines, {}, &Line::frequency);
  square.materials = {{"guess", 6e10, 0.3, 2700, {}, {}}};
  const Identification found = identify(square, measured, {});
  EXPECT_EQ(found.lines[0].modes, 2);
  EXPECT_EQ(found.lines[1].first_mode, 1);
  EXPECT_EQ(found.lines[1].modes, 2);
  EXPECT_NEAR(found.material.young / 7.1e10, 1, 1e-3);
}

TEST(Identify, OrthotropicConstants) {
  const Measurements measured = lines_of(block_of(spruce()), 40, 0, 6e4);
  ASSERT_EQ(measured.lines.size(), 40U);
  scene::Material guess = spruce();
  guess.orthotropy->young = {11e9, 0.98e9, 0.53e9};
  guess.orthotropy->shear = {0.72e9, 0.038e9, 0.7e9};
  const Identification found = identify(block_of(guess), measured, {});
  const ElasticConstants constants = elastic_constants(guess);
  for (std::size_t k = 0; k < constants.size(); ++k) {
    TurnedMaterial truth = spruce();
    const double value = constants[k].in(truth);
    if (found.constants[k].determined) {
      EXPECT_NEAR(found.constants[k].value, value, std::max(found.constants[k].half_width, 1e-3 * value))
          << constants[k].name;
    }
  }
  EXPECT_GE(std::ranges::count(found.constants, true, &IdentifiedConstant::determined), 6);
  EXPECT_LE(found.solves, 10 + solves_for_sizes);
}

/// A crystal in the orientation of the block.
scene::Material crystal_of(scene::Symmetry symmetry, const std::vector<double>& constants) {
  scene::Material material{"crystal", 0, 0, 2330, {}, {}};
  material.crystal = {symmetry, constants};
  material.young = scene::constants_along_axes(material)->young.maxCoeff();
  return material;
}

/// Fits 15 lines of a crystal from constants that are too large or small by a tenth.
Identification identify_crystal(scene::Symmetry symmetry, const std::vector<double>& truth) {
  const Measurements measured = lines_of(block_of(crystal_of(symmetry, truth)), 15, 1, 3e5);
  std::vector<double> guess = truth;
  for (std::size_t k = 0; k < guess.size(); ++k) {
    guess[k] *= k % 2 == 0 ? 0.93 : 1.08;
  }
  Identification found = identify(block_of(crystal_of(symmetry, guess)), measured, {});
  EXPECT_TRUE(found.doubts.empty());
  for (std::size_t k = 0; k < truth.size(); ++k) {
    const IdentifiedConstant& constant = found.constants.at(k);
    EXPECT_NEAR(constant.value, truth[k], constant.half_width) << constant.name;
    EXPECT_EQ(constant.value, found.material.crystal->constants[k]);
  }
  return found;
}

TEST(Identify, ConstantsOfACubicCrystal) {
  const Identification silicon = identify_crystal(scene::Symmetry::cubic, {165.7e9, 63.9e9, 79.6e9});
  for (const IdentifiedConstant& constant : silicon.constants) {
    EXPECT_TRUE(constant.determined) << constant.name;
    EXPECT_LT(constant.half_width, 0.15 * constant.value) << constant.name;
  }
}

// On this coarse mesh the lines do not determine all five constants.
TEST(Identify, ConstantsOfAMaterialThatIsTransverselyIsotropic) {
  LONG_VERIFICATION();
  const Identification magnesium =
      identify_crystal(scene::Symmetry::hexagonal, {59.7e9, 26.2e9, 21.7e9, 61.7e9, 16.4e9});
  EXPECT_GE(std::ranges::count(magnesium.constants, true, &IdentifiedConstant::determined), 3);
}

TEST(Identify, MassGivesTheDensity) {
  Measurements measured = lines_of(block_of(aluminium), 12, 0, 1e5);
  measured.mass = 1.1 * 2700 * block_sides.prod();
  const Identification found = identify(block_of(aluminium), measured, {});
  EXPECT_NEAR(found.material.density, 1.1 * 2700, 1e-6);
  EXPECT_NEAR(found.material.young, 1.1 * 7.1e10, 1e5) << "frequencies give the ratio of modulus and density";
}

TEST(Identify, DecayTimesGiveTheDamping) {
  Measurements measured = lines_of(block_of(aluminium), 12, 0, 1e5);
  for (Line& line : measured.lines) {
    line.decay_time = 2.2 / (line.frequency * 1e-3);  // T60 pi f loss_factor = ln(1000)
  }
  const Identification found = identify(block_of(aluminium), measured, {});
  EXPECT_TRUE(found.has_damping);
  EXPECT_NEAR(found.material.damping.loss.value().value, std::log(1000.0) / (std::numbers::pi * 2200), 1e-6);
}

// A stroke at a place where two modes have a node, in a room with hum, recorded with noise 50 dB below the partials.
TEST(Identify, FromANoisyRecordingWithoutSomePartials) {
  const auto large = [](const scene::Material& material) {
    scene::Scene scene = bar_scene({0.36, 0.15, 0.12}, 0.18, 4);
    scene.materials = {material};
    return scene;
  };
  const std::vector<Line> modes = lines_of(large(aluminium), 12, 0, 2e4).lines;
  std::vector<DampedSine> sines = {{100, 60}};
  for (std::size_t m = 0; m < modes.size(); ++m) {
    if (m != 3 && m != 7) {
      sines.push_back({modes[m].frequency, 2000 / modes[m].frequency, 0.05 + 0.02 * static_cast<double>(m % 3)});
    }
  }
  const support::TemporarySound recording(48000, {struck(sines, 48000, 1.5, 3e-4)});
  const Measurements measured = read_measurements(recording.path());
  EXPECT_EQ(measured.hum.size(), 1U);
  const Identification found = identify(large({"guess", 6.2e10, 0.3, 2700, {}, {}}), measured, {});
  EXPECT_NEAR(found.material.young / 7.1e10, 1, 2e-3);
  EXPECT_NEAR(found.material.poisson, 0.34, 5e-3);
  EXPECT_TRUE(found.doubts.empty());
  EXPECT_EQ(found.missing.size(), 2U);
  ASSERT_TRUE(found.has_damping);
  EXPECT_NEAR(found.material.damping.loss.value().value, std::log(1000.0) / (std::numbers::pi * 2000), 1e-5);
}

TEST(Identify, RefusesWhatDoesNotFit) {
  const Measurements measured = lines_of(block_of(aluminium), 6, 0, 1e5);
  EXPECT_THROW(static_cast<void>(identify(block_of(aluminium), measured, {.constants = {"shear_xy"}})),
               std::runtime_error);
  Measurements low;
  low.lines = {{.frequency = 100}};
  const auto fit = [&] { static_cast<void>(identify(block_of(aluminium), low, {})); };
  EXPECT_THAT(fit,
              ::testing::ThrowsMessage<std::runtime_error>(::testing::HasSubstr("the mass in kg, and lines in Hz")));
}

}  // namespace
}  // namespace idiophone::fitting
