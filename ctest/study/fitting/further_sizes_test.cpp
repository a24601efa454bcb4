// What lines of specimens of other sizes would tell, beside what they tell.

#include "further_sizes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "bars.hpp"
#include "long_verification.hpp"
#include "material_fit.hpp"
#include "ranks.hpp"

namespace idiophone::fitting {
namespace {

const Vector3 plate_sides{0.12, 0.08, 0.002};

scene::Scene wooden(const Vector3& sides) {
  scene::Scene scene = bar_scene(sides, 0.06, 4);
  scene.materials = {spruce()};
  return scene;
}

StrainedBody strained(const scene::Scene& scene) {
  return {scene, eigenmodes::MassMatrix::consistent};
}

ON_RANKS(1);

// The mesh of a plate that is half as thick again has as many cells.
TEST(FurtherSizes, AStretchedBodyIsTheBodyOfThatSize) {
  StrainedBody stretched = strained(wooden(plate_sides)).stretched(2, 1.5);
  StrainedBody meshed = strained(wooden({0.12, 0.08, 0.003}));
  const Eigen::VectorXd some = stretched.lowest(spruce(), 6).frequencies(spruce());
  const Eigen::VectorXd same = meshed.lowest(spruce(), 6).frequencies(spruce());
  EXPECT_LT((some.cwiseQuotient(same).array() - 1).abs().maxCoeff(), 1e-7);
  EXPECT_NEAR(stretched.extents()[2], 0.003, 1e-12);
  EXPECT_NEAR(stretched.volume(), meshed.volume(), 1e-12);
}

// The deck's mesh of a lower order would be that of the body before.
TEST(FurtherSizes, AStretchedBodyHasNoCoarserMesh) {
  scene::Scene scene = wooden(plate_sides);
  scene.bodies[0].element = element::hex(5, 5);
  const StrainedBody body = strained(scene);
  EXPECT_TRUE(body.coarser().has_value());
  EXPECT_FALSE(body.stretched(2, 1.5).coarser().has_value());
}

/// The unknowns of spruce as a deck has them.
Expectation expected_of(const ElasticConstants& constants) {
  Expectation expected{unknowns(constants, spruce()), Eigen::VectorXd(constants.size())};
  std::ranges::transform(constants, expected.deviation.begin(), [](const ElasticConstant& constant) {
    return constant.kind == ConstantKind::modulus ? 0.2 : 0.1;
  });
  return expected;
}

constexpr ResidualSpread by_chance{1.0, 1.96};
constexpr double plate_uncertainty = 2.0;  // cents
constexpr int plate_lines = 12;

/// What the specimens of other sizes tell of the shear through the thickness of a thin plate, if its lines tell
/// nothing.
FurtherSize size_for_the_shear() {
  const ElasticConstants constants = elastic_constants(spruce());
  const Expectation expected = expected_of(constants);
  const StrainedBody body = strained(wooden(plate_sides));
  const Eigen::VectorXd widths = 1.96 * 0.2 * Eigen::VectorXd::Unit(9, 8);
  const std::vector<FurtherSize> sizes =
      further_sizes({body, spruce(), constants, expected, by_chance, plate_uncertainty, plate_lines}, widths,
                    [](int /*solves*/) {})
          .named;
  EXPECT_EQ(sizes.size(), 1U);
  return sizes.empty() ? FurtherSize{} : sizes.front();
}

/// Sides of the plate with one of them changed.
Vector3 sides_of(const FurtherSize& size) {
  Vector3 sides = plate_sides;
  Eigen::Index side = 0;
  size.along.maxCoeff(&side);
  sides[side] *= size.factor;
  return sides;
}

TEST(FurtherSizes, AThinPlateNeedsAnotherSizeForItsShear) {
  const FurtherSize size = size_for_the_shear();
  EXPECT_EQ(size.constant, "shear_xz");
  Vector3 sides = sides_of(size);
  EXPECT_GT(sides[2] / std::min(sides[0], sides[1]), plate_sides[2] / plate_sides[1]) << "it is more compact";
  StrainedBody body = strained(wooden(sides));
  const FrequencyModel model = body.lowest(spruce(), plate_lines);
  const ElasticConstants constants = elastic_constants(spruce());
  const Evidence evidence = imagined_lines(model, constants, spruce(), plate_uncertainty, body.mesh_errors(model));
  const Eigen::MatrixXd slopes = value_slopes(constants, spruce()).row(8);
  EXPECT_NEAR(size.half_width / half_widths(evidence, by_chance, expected_of(constants), slopes)[0], 1, 0.05);
  EXPECT_LT(size.half_width, 0.5 * 1.96 * 0.2 * spruce().orthotropy->shear[2]);
  EXPECT_EQ(size.lines, static_cast<int>(model.multiplets().size()));
  EXPECT_NEAR(size.highest / model.frequencies(spruce()).tail(1)[0], 1, 1e-3);
}

// The fit begins with moduli that are wrong by a twentieth.
TEST(FurtherSizes, AFitOfASpecimenOfTheNamedSizeIsAsGoodAsPromised) {
  LONG_VERIFICATION();
  const FurtherSize size = size_for_the_shear();
  scene::Scene specimen = wooden(sides_of(size));
  StrainedBody body = strained(specimen);
  Measurements measured;
  for (const double frequency : body.lowest(spruce(), plate_lines).frequencies(spruce())) {
    measured.lines.push_back({.frequency = frequency, .uncertainty = plate_uncertainty});
  }
  specimen.materials[0].orthotropy->young *= 1.05;
  specimen.materials[0].orthotropy->shear *= 1.05;
  const Identification found = identify(strained(specimen), measured, {});
  const auto constant = std::ranges::find(found.constants, "shear_xz", &IdentifiedConstant::name);
  EXPECT_GT(constant->half_width, 0.5 * size.half_width);
  EXPECT_LT(constant->half_width, 2.0 * size.half_width);
  EXPECT_NEAR(constant->value, spruce().orthotropy->shear[2], constant->half_width);
}

TEST(FurtherSizes, NothingIsNamedForConstantsThatAreKnownBetter) {
  const ElasticConstants constants = elastic_constants(spruce());
  const Expectation expected{unknowns(constants, spruce()), Eigen::VectorXd::Constant(constants.size(), 0.2)};
  const StrainedBody body = strained(wooden(plate_sides));
  int solves = 0;
  const auto named = [&](double width) {
    return further_sizes({body, spruce(), constants, expected, {1.0, 1.96}, 2.0, 6},
                         Eigen::VectorXd::Constant(constants.size(), width), [&](int now) { solves += now; });
  };
  EXPECT_TRUE(named(1e-6).named.empty());
  EXPECT_EQ(solves, 12);
  EXPECT_TRUE(named(0).named.empty());
  EXPECT_EQ(solves, 12);
}

// A sphere that is stretched along a side is none.
TEST(FurtherSizes, NothingIsNamedForABodyThatDoesNotFillItsBox) {
  scene::Scene scene = wooden(plate_sides);
  scene.bodies[0].mesh.replace_filename("sphere.geo");
  scene.bodies[0].parameters = {{"radius", 0.02}, {"size", 0.02}};
  const ElasticConstants constants = elastic_constants(spruce());
  const StrainedBody body = strained(scene);
  int solves = 0;
  const FurtherSizes sizes = further_sizes({body, spruce(), constants, expected_of(constants), by_chance, 2.0, 6},
                                           Eigen::VectorXd::Ones(9), [&](int now) { solves += now; });
  EXPECT_TRUE(sizes.named.empty());
  EXPECT_EQ(solves, 0);
}

}  // namespace
}  // namespace idiophone::fitting
