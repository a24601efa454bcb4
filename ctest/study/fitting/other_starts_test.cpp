// Constants that a search finds only from other materials than the deck's.

#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "bars.hpp"
#include "idiophone/study/fitting/identification.hpp"
#include "long_verification.hpp"
#include "material_fit.hpp"
#include "ranks.hpp"
#include "shared_folder.hpp"

namespace idiophone::fitting {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A tetragonal crystal, along the axes of its block.
/// @param constants  c11, c12, c13, c33, c44, c66, c16, GPa
scene::Material tetragonal(std::vector<double> constants) {
  scene::Material material{"crystal", 0, 0, 3979, {}, {}};
  for (double& constant : constants) {
    constant *= 1e9;
  }
  material.crystal = {scene::Symmetry::tetragonal, constants};
  return material;
}

ON_RANKS(1);

// The constants of a crystal of LiYF4 and its first lines. The block can only move by its 150 lowest modes, so that the
// fits take some seconds. From the deck alone the search ends with other constants.
TEST(OtherStarts, FindConstantsThatAreFarFromTheDeck) {
  LONG_VERIFICATION();
  scene::Scene scene = bar_scene({0.0079244, 0.009952, 0.0086042}, 0.005, 4);
  scene.materials = {tetragonal({103.303, 69.3635, 58.592, 140.716, 40.8253, 17.3424, -8.16691})};
  const StrainedBody block = StrainedBody(scene, eigenmodes::MassMatrix::consistent).reduced(150);
  const TurnedMaterial truth = tetragonal({122.0, 52.9, 61.4, 171.6, 41.06, 22.97, -12.93});
  StrainedBody measured_block = block;
  const Eigen::VectorXd frequencies = measured_block.lowest(truth, 60).frequencies(truth);
  Measurements measured;
  for (const double frequency : frequencies.head(60)) {
    measured.lines.push_back({.frequency = frequency});
  }
  const Identification found = identify(block, measured, {});
  EXPECT_THAT(found.doubts, IsEmpty());
  ASSERT_EQ(found.constants.size(), 7);
  for (std::size_t k = 0; k < found.constants.size(); ++k) {
    EXPECT_NEAR(found.constants[k].value / truth.crystal->constants[k], 1, 0.002) << found.constants[k].name;
  }
  constexpr int from_the_deck = 20;
  EXPECT_GT(found.solves, from_the_deck);
}

TEST(OtherStarts, FarLinesAreComparedWithTheModesOfTheDeck) {
  scene::Scene scene = bar_scene({0.06, 0.04, 0.01}, 0.03, 2);
  scene.materials = {spruce()};
  Measurements measured;
  for (const double frequency : {8.0e5, 9.0e5, 10.0e5}) {
    measured.lines.push_back({.frequency = frequency});
  }
  const auto refusal = [&](const std::vector<std::string>& constants) {
    return support::error_of([&] { (void)identify(scene, measured, {.constants = constants}); });
  };
  const std::string expected = refusal({"constants"});
  EXPECT_THAT(expected, HasSubstr("the lowest 11 modes of the body from"));
  EXPECT_EQ(refusal({"constants", "turn_z"}), expected);
}

}  // namespace
}  // namespace idiophone::fitting
