// Modes of wood with loss factors by direction: each mode has the loss of the modulus that it strains.

#include <cmath>
#include <numbers>

#include "ranks.hpp"
#include "vibrating_body.hpp"

namespace idiophone::eigenmodes {
namespace {

const scene::DirectionalLoss losses_of_wood = {{0.005, 0.02, 0.03}, {0.016, 0.04, 0.01}};

/// Sitka spruce without Poisson's ratios.
scene::Material lossy_wood() {
  scene::Material wood{"wood", 11.9e9, 0.0, 450, {}, {}};
  wood.orthotropy = {{11.9e9, 0.93e9, 0.51e9}, Vector3::Zero(), {0.76e9, 0.036e9, 0.73e9}};
  wood.damping.loss = {0.04, {100, 20000}, {}, {}, {}, losses_of_wood};
  return wood;
}

/// A bar along x whose wood has its own x, y and z in the columns.
VibratingBody bar_of_wood(const Eigen::Matrix3d& grain) {
  VibratingBody body = block(element::hex(4, 2), {0.5, 0.02, 0.02}, {12, 1, 1});
  body.scene.materials = {lossy_wood()};
  body.scene.bodies[0].grain = grain;
  return body;
}

Eigen::Matrix3d axis_along_x(int axis) {
  Eigen::Matrix3d grain = Eigen::Matrix3d::Zero();
  for (int k = 0; k < 3; ++k) {
    grain(k, (axis + k) % 3) = 1;
  }
  return grain;
}

/// Loss factor of a mode over the one that is expected.
double share(const Mode& mode, double loss) {
  return 2 * mode.damping_ratio / loss;
}

ON_RANKS(1, 3);

constexpr double band_tolerance = 0.05;  // the band keeps loss factors within so much of themselves

TEST(DirectionalLoss, ABarIsPulledWithTheLossOfItsDirection) {
  for (int axis = 0; axis < 3; ++axis) {
    VibratingBody body = bar_of_wood(axis_along_x(axis));
    std::vector<Index>& all = body.mesh.groups["all"];
    for (Index node = 0; node < std::ssize(body.mesh.nodes); ++node) {
      all.push_back(node);
    }
    body.fix("all", {false, true, true});  // it moves along x only
    const Mode first = body.find({.count = 1}).modes[0];
    EXPECT_NEAR(first.frequency, std::sqrt(lossy_wood().orthotropy->young[axis] / 450) / (2 * 0.5),
                0.03 * first.frequency);
    EXPECT_NEAR(share(first, losses_of_wood.young[axis]), 1.0, band_tolerance) << axis;
  }
}

TEST(DirectionalLoss, ABarBendsWithLossesByTheirSharesOfTheEnergy) {
  // Rayleigh: of the lowest mode of a slender free bar, bending has all of the energy but that of shear,
  // E I/(5/6 G A L^2) times 49.48 - 12.30 (the factor of Goens' formula without rotary inertia).
  const auto [young, poisson, shear] = *lossy_wood().orthotropy;
  VibratingBody body = bar_of_wood(Eigen::Matrix3d::Identity());
  const Modes found = body.find({.count = 2});
  const double slenderness = 0.02 * 0.02 / 12 / (0.5 * 0.5);
  for (std::size_t mode = 0; mode < 2; ++mode) {  // in the planes xy and xz
    const std::size_t plane = mode == 0 ? 2 : 0;  // the softer one is lower
    const double of_shear = 12.30 * slenderness * young[0] / (5.0 / 6 * shear[static_cast<int>(plane)]);
    const double part = of_shear / (1 + of_shear);
    const double expected = (1 - part) * losses_of_wood.young[0] + part * losses_of_wood.shear[static_cast<int>(plane)];
    EXPECT_NEAR(share(found.modes[mode], expected), 1.0, band_tolerance) << mode;
  }
}

TEST(DirectionalLoss, TheSameInAllDirectionsIsALossFactor) {
  VibratingBody by_direction = bar_of_wood(axis_along_x(1));
  const Vector3 all = Vector3::Constant(0.04);
  by_direction.scene.materials[0].damping.loss->directions = {all, all};
  VibratingBody by_one = bar_of_wood(axis_along_x(1));
  by_one.scene.materials[0].damping.loss->directions.reset();
  const Modes found = by_direction.find({.count = 6});
  const Modes expected = by_one.find({.count = 6});
  for (std::size_t mode = 0; mode < 6; ++mode) {
    EXPECT_NEAR(found.modes[mode].frequency / expected.modes[mode].frequency, 1.0, 1e-9);
    EXPECT_NEAR(found.modes[mode].decay_time / expected.modes[mode].decay_time, 1.0, 1e-6);
  }
}

}  // namespace
}  // namespace idiophone::eigenmodes
