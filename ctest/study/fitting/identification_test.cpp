// Constants that are known, from frequencies that the program computed with them.

#include "idiophone/study/fitting/identification.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "bars.hpp"
#include "ranks.hpp"
#include "recordings.hpp"
#include "strained_body.hpp"
#include "temporary_sound.hpp"

namespace idiophone::fitting {
namespace {

using ::testing::Each;
using ::testing::Field;

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
  EXPECT_NEAR(found.material.young / 7.1e10, 1, 1e-6);
  EXPECT_NEAR(found.material.poisson, 0.34, 1e-6);
  EXPECT_NEAR(found.fitted_rms.value(), 0, 1e-3);
  EXPECT_TRUE(found.missing.empty());
  EXPECT_THAT(found.constants, Each(Field(&IdentifiedConstant::determined, true)));
  EXPECT_EQ(found.constants[0].start, 1.1e11);
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
    EXPECT_LT(constant.half_width, 0.03 * truth) << constant.name;
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
  const ElasticConstants constants = elastic_constants(guess, {});
  for (std::size_t k = 0; k < constants.size(); ++k) {
    scene::Material truth = spruce();
    const double value = constants[k].in(truth);
    if (found.constants[k].determined) {
      EXPECT_NEAR(found.constants[k].value, value, std::max(found.constants[k].half_width, 1e-3 * value))
          << constants[k].name;
    }
  }
  EXPECT_GE(std::ranges::count(found.constants, true, &IdentifiedConstant::determined), 6);
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
  const Identification found =
      identify(large({"guess", 6.2e10, 0.3, 2700, {}, {}}), read_measurements(recording.path()), {});
  EXPECT_NEAR(found.material.young / 7.1e10, 1, 2e-3);
  EXPECT_NEAR(found.material.poisson, 0.34, 5e-3);
  EXPECT_EQ(found.lines.front().modes, 0) << "the hum is a false line";
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
  EXPECT_THROW(static_cast<void>(identify(block_of(aluminium), low, {})), std::runtime_error);
}

}  // namespace
}  // namespace idiophone::fitting
