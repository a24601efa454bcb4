// Loss factors of wood from decays that the modes of a plate would have with them.

#include "fit_directional_loss.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "bars.hpp"
#include "idiophone/solids/solid/directional_loss.hpp"
#include "ranks.hpp"
#include "strained_body.hpp"

namespace idiophone::fitting {
namespace {

const scene::DirectionalLoss plate_losses = {{0.0051, 0.0216, 0.0216}, {0.0164, 0.0216, 0.0164}};

scene::Scene spruce_plate() {
  scene::Scene scene = bar_scene({0.3, 0.2, 0.004}, 0.1, 4);
  scene::Material& wood = scene.materials.front();
  wood = {"spruce", 13.2e9, 0, 420, {}, {}};
  wood.orthotropy = {{13.2e9, 1.01e9, 0.6e9}, {0.372, 0.435, 0.467}, {0.69e9, 0.036e9, 0.73e9}};
  return scene;
}

/// Decays of the lowest modes with these loss factors, each wrong by a random part.
std::vector<StrainedDecay> decays_of(const scene::Material& material, const FrequencyModel& model,
                                     const scene::DirectionalLoss& losses, std::size_t count, double noise) {
  solid::OrientedMaterial oriented{.material = material, .axes = Eigen::Matrix3d::Identity()};
  oriented.material.damping.loss = scene::LossFactor{.value = 0.0216, .mechanisms = {}, .where = {}};
  oriented.material.damping.loss->directions = losses;
  const solid::StiffnessMatrix whole = solid::stiffness_matrix(solid::elasticity(material));
  const solid::StiffnessMatrix relaxing = solid::stiffness_matrix(solid::relaxing_elasticity(oriented));
  std::mt19937 random(1);
  std::normal_distribution<double> error(1.0, noise);
  std::vector<StrainedDecay> decays;
  for (const Multiplet& each : std::span(model.multiplets()).first(count)) {
    const double loss =
        0.0216 * relaxing.cwiseProduct(each.strain).sum() / whole.cwiseProduct(each.strain).sum() * error(random);
    const double frequency = std::sqrt(each.square) / (2 * std::numbers::pi);
    decays.push_back({{frequency, std::log(1000.0) / (std::numbers::pi * frequency * loss)}, each.strain});
  }
  return decays;
}

class FitDirectionalLoss : public ::testing::Test {
 protected:
  FitDirectionalLoss()
      : scene(spruce_plate()),
        material(scene.materials.front()),
        model(StrainedBody(scene, eigenmodes::MassMatrix::consistent).model(material, 1500)) {}

  scene::Scene scene;
  scene::Material material;
  FrequencyModel model;
};

ON_RANKS(1);

TEST_F(FitDirectionalLoss, FindsThoseOfThePlane) {
  const auto found =
      fit_directional_loss(material, Eigen::Matrix3d::Identity(), decays_of(material, model, plate_losses, 12, 0.03));
  ASSERT_TRUE(found);
  const scene::DirectionalLoss& directions = found->loss.directions.value();
  EXPECT_NEAR(directions.young[0] / plate_losses.young[0], 1.0, 0.1);
  EXPECT_NEAR(directions.young[1] / plate_losses.young[1], 1.0, 0.1);
  EXPECT_NEAR(directions.shear[0] / plate_losses.shear[0], 1.0, 0.1);
  EXPECT_LT(std::sqrt(found->squares / 12), 0.04);
}

TEST_F(FitDirectionalLoss, OneForAllIsNotDivided) {
  const Vector3 all = Vector3::Constant(0.0216);
  for (const std::size_t count : {4, 8, 12}) {
    const auto decays = decays_of(material, model, {all, all}, count, 0.05);
    EXPECT_FALSE(fit_directional_loss(material, Eigen::Matrix3d::Identity(), decays)) << count;
  }
  EXPECT_FALSE(
      fit_directional_loss(material, Eigen::Matrix3d::Identity(), decays_of(material, model, {all, all}, 12, 0)));
}

TEST_F(FitDirectionalLoss, ThreeDecaysAreTooFewForTwoNumbers) {
  const auto decays = decays_of(material, model, plate_losses, 3, 0);
  EXPECT_FALSE(fit_directional_loss(material, Eigen::Matrix3d::Identity(), decays));
}

}  // namespace
}  // namespace idiophone::fitting
