// Frequencies of spectral hexahedra against limits of refined meshes and exact solutions, and the shift by mass
// scaling.

#include <array>
#include <cmath>
#include <numbers>

#include "idiophone/solids/solid/mass_scaling.hpp"
#include "ranks.hpp"
#include "vibrating_body.hpp"

namespace idiophone::eigenmodes {
namespace {

double cents(double frequency, double reference) {
  return 1200 * std::log2(frequency / reference);
}

// Bending in both planes and torsion, Hz: verification/limits/free_bar_limits.yaml.
constexpr std::array free_bar = {574.403,  1573.218, 1671.320, 2936.485, 3055.588,
                                 4353.259, 4989.819, 5895.428, 7343.787, 7953.643};

/// Requires the first frequencies of a free steel bar of 300 x 30 x 10 mm within a tolerance, cents.
void expect_bar(element::Type type, const std::array<int, 3>& cells, double tolerance) {
  const Modes found = block(type, {0.3, 0.03, 0.01}, cells).find({.count = free_bar.size()});
  EXPECT_EQ(found.rigid_motions, 6);
  for (std::size_t mode = 0; mode < free_bar.size(); ++mode) {
    EXPECT_NEAR(cents(found.modes[mode].frequency, free_bar[mode]), 0, tolerance) << "mode " << mode;
  }
}

ON_RANKS(1, 3);

TEST(Hexahedra, FreeBarWithTorsionOfOrderFive) {
  expect_bar(element::hex(5, 3), {6, 1, 1}, 5);
}

TEST(Hexahedra, FreeBarWithTorsionOfOrderSix) {
  expect_bar(element::hex(6, 3), {4, 1, 1}, 2);
}

// Lamb 1882: x = w a/c_s of the torsional and spheroidal modes with l = 2, five of each.
TEST(Hexahedra, FreeBall) {
  scene::Body body;
  body.mesh = std::filesystem::path(IDIOPHONE_SOURCE_DIR) / "meshes/sphere.geo";
  body.parameters = {{"radius", 0.05}, {"size", 0.1}};
  body.element = element::hex(6, 6);
  const Modes found = VibratingBody(mesh::read_mesh(body)).find({.count = 10});
  const double unit = std::sqrt(2e11 / 2.6 / 7850) / (2 * std::numbers::pi * 0.05);
  for (std::size_t mode = 0; mode < 10; ++mode) {
    EXPECT_NEAR(cents(found.modes[mode].frequency, unit * (mode < 5 ? 2.50113 : 2.64622)), 0, 1.5) << "mode " << mode;
  }
}

// The prediction is for waves far from edges. The lowest mode of a free plate twists: its
// nodes rotate twice as much.
TEST(Hexahedra, MassScalingLowersThePitchAsPredicted) {
  constexpr double shift = 20;  // cents, at the highest audible frequency
  VibratingBody plate = block(element::hex(5, 2), {0.1, 0.1, 0.004}, {2, 2, 1});
  const Modes without = plate.find({.count = 12});
  plate.scene.bodies[0].mass_scaling = scene::MassScalingLimit{shift};
  const Modes with = plate.find({.count = 12});
  const auto& material = plate.scene.materials[0];
  const auto scaling = solid::choose_scaling(material, 0.004, solid::highest_audible, shift);
  for (std::size_t mode = 0; mode < 12; ++mode) {
    const double frequency = without.modes[mode].frequency;
    const double predicted = solid::predicted_shift(scaling, material, 0.004, frequency);
    const double measured = -cents(with.modes[mode].frequency, frequency);
    EXPECT_LT(measured, 2.1 * predicted) << frequency << " Hz";
    EXPECT_GT(measured, 0.4 * predicted) << frequency << " Hz";
  }
}

}  // namespace
}  // namespace idiophone::eigenmodes
