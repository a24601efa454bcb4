// Derivatives of frequencies by elastic constants against modes that are computed again.

#include "frequency_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bars.hpp"
#include "fit_names.hpp"
#include "idiophone/study/partials/compare.hpp"
#include "ranks.hpp"
#include "strained_body.hpp"

namespace idiophone::fitting {
namespace {

/// Compares the slopes with central differences of the eigenfrequencies.
void expect_exact_slopes(const TurnedMaterial& material, const ElasticConstants& constants, double highest) {
  StrainedBody body(bar_scene({0.06, 0.025, 0.02}, 0.03, 4), eigenmodes::MassMatrix::consistent);
  const FrequencyModel model = body.model(material, highest);
  const Eigen::MatrixXd slopes = model.cents_slopes(constants, material);
  const Eigen::VectorXd here = unknowns(constants, material);
  ASSERT_GE(slopes.rows(), 3);
  for (Eigen::Index k = 0; k < here.size(); ++k) {
    constexpr double h = 1e-3;
    const auto at = [&](double change) {
      const auto other = with_unknowns(constants, material, here + change * Eigen::VectorXd::Unit(here.size(), k));
      return body.model(other, highest).frequencies(other);
    };
    const Eigen::VectorXd above = at(h);
    const Eigen::VectorXd below = at(-h);
    for (Eigen::Index m = 0; m < 3; ++m) {
      const double difference = partials::cents(above[m], below[m]) / (2 * h);
      EXPECT_NEAR(slopes(m, k), difference, 0.05 + 1e-3 * std::abs(difference)) << constants[k].name << ", mode " << m;
    }
  }
}

ON_RANKS(1);

TEST(FrequencyModel, IsotropicSlopesAreExact) {
  const scene::Material aluminium = bar_scene({1, 1, 1}, 1, 2).materials[0];
  expect_exact_slopes(aluminium, elastic_constants(aluminium), 40e3);
}

TEST(FrequencyModel, OrthotropicSlopesAreExact) {
  expect_exact_slopes(spruce(), elastic_constants(spruce()), 12e3);
}

TEST(FrequencyModel, SlopesByTurnsAreExact) {
  TurnedMaterial askew = spruce();
  askew.turns = {10, 20, 30};
  ElasticConstants turns = constants_and_turns(askew, {"turn_x", "turn_y", "turn_z"});
  std::erase_if(turns, [](const ElasticConstant& constant) { return constant.kind != ConstantKind::turn; });
  ASSERT_EQ(turns.size(), 3U);
  expect_exact_slopes(askew, turns, 12e3);
}

TEST(FrequencyModel, StrainEnergyIsThatOfTheMode) {
  const scene::Scene scene = bar_scene({0.06, 0.025, 0.02}, 0.03, 4);
  StrainedBody body(scene, eigenmodes::MassMatrix::lumped);
  EXPECT_NEAR(body.volume(), 0.06 * 0.025 * 0.02, 1e-12);
  const scene::Material& material = scene.materials[0];
  const auto stiffness = solid::stiffness_matrix(solid::elasticity(material));
  const FrequencyModel model = body.model(material, 60e3);
  for (const Multiplet& multiplet : model.multiplets()) {
    EXPECT_NEAR(stiffness.cwiseProduct(multiplet.strain).sum() / multiplet.square, 1, 1e-8);
  }
}

TEST(FrequencyModel, AllModuliScaleAllFrequencies) {
  const scene::Scene scene = bar_scene({0.06, 0.025, 0.02}, 0.03, 4);
  StrainedBody body(scene, eigenmodes::MassMatrix::consistent);
  const FrequencyModel model = body.model(scene.materials[0], 60e3);
  scene::Material stiffer = scene.materials[0];
  stiffer.young *= 2;
  const Eigen::VectorXd ratios = model.frequencies(stiffer).cwiseQuotient(model.frequencies(scene.materials[0]));
  EXPECT_NEAR((ratios.array() - std::numbers::sqrt2).abs().maxCoeff(), 0, 1e-9);
}

// Shapes change with the material. The first order alone is 6 cents away.
TEST(FrequencyModel, ModesOfASimilarMaterialAreCombinedOfThoseThatAreSolved) {
  StrainedBody body(bar_scene({0.06, 0.025, 0.02}, 0.03, 4), eigenmodes::MassMatrix::consistent);
  scene::Material other = spruce();
  other.orthotropy->young[1] *= 0.9;
  other.orthotropy->shear[0] *= 1.1;
  constexpr int compared = 10;
  const FrequencyModel solved = body.lowest(spruce(), 3 * compared);
  const Eigen::VectorXd first_order = solved.frequencies(other);
  const Eigen::VectorXd combined = body.nearby(other).frequencies(other);
  const Eigen::VectorXd exact = body.lowest(other, compared).frequencies(other);
  double of_first_order = 0.0;
  double of_combined = 0.0;
  for (Eigen::Index m = 0; m < compared; ++m) {
    const double error = partials::cents(combined[m], exact[m]);
    EXPECT_GT(error, -1e-6) << "Ritz values are upper bounds";
    of_combined = std::max(of_combined, error);
    of_first_order = std::max(of_first_order, std::abs(partials::cents(first_order[m], exact[m])));
  }
  EXPECT_LT(of_combined, of_first_order / 2);
}

TEST(FrequencyModel, TheTwoBendingsOfASquareBarAreOnePair) {
  StrainedBody body(bar_scene({0.08, 0.02, 0.02}, 0.04, 4), eigenmodes::MassMatrix::consistent);
  const scene::Material aluminium = bar_scene({1, 1, 1}, 1, 2).materials[0];
  const FrequencyModel model = body.model(aluminium, 20e3);
  EXPECT_EQ(model.multiplets()[0].count, 2);
  const auto& strain = model.multiplets()[0].strain;  // of any basis of the pair, the mean is the same along y and z
  EXPECT_NEAR(strain(1, 1) / strain(2, 2), 1, 1e-6);
  EXPECT_NEAR(strain(4, 4) / strain(5, 5), 1, 1e-6);
}

// The bar is square, so that multiplets and modes are counted differently.
TEST(FrequencyModel, ErrorsOfTheMeshAreEstimated) {
  const auto square_bar = [](int order) { return bar_scene({0.08, 0.02, 0.02}, 0.04, order); };
  const scene::Scene scene = square_bar(4);
  const scene::Material& material = scene.materials[0];
  constexpr int modes = 8;
  StrainedBody body(scene, eigenmodes::MassMatrix::consistent);
  const FrequencyModel model = body.lowest(material, modes);
  const std::vector<double> estimates = body.mesh_errors(model);
  const Eigen::VectorXd found = model.frequencies(material);
  const Eigen::VectorXd converged =
      StrainedBody(square_bar(7), eigenmodes::MassMatrix::consistent).lowest(material, modes).frequencies(material);
  ASSERT_EQ(estimates.size(), model.multiplets().size());
  ASSERT_EQ(found.size(), converged.size());
  ASSERT_LT(found.size(), modes);
  for (Eigen::Index m = 0; m < found.size(); ++m) {
    constexpr double negligible = 0.3;  // cents
    const double error = partials::cents(found[m], converged[m]);
    EXPECT_LT(error, 2 * estimates[m] + negligible) << "multiplet " << m;
    EXPECT_GT(error, 0.2 * estimates[m] - negligible) << "multiplet " << m;
  }
}

TEST(FrequencyModel, UnstableMaterials) {
  scene::Material material = spruce();
  EXPECT_TRUE(is_stable(material));
  material.orthotropy->poisson[0] = 4;
  EXPECT_FALSE(is_stable(material));
  EXPECT_FALSE(is_stable({"rubber", 1e6, 0.49999, 1000, {}, {}}));
}

}  // namespace
}  // namespace idiophone::fitting
