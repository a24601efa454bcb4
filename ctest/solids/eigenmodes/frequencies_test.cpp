// Frequencies of bars and balls that are known in closed form.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ranks.hpp"
#include "vibrating_body.hpp"

namespace idiophone::eigenmodes {
namespace {

constexpr element::Type tet10 = element::tet10;

/// (beta L)^2/(2 pi L^2) sqrt(E I/(rho A)) of the steel bar where it bends in the plane of `depth`, Hz.
double thin_bar(double beta_length, double depth) {
  return beta_length * beta_length / (2 * std::numbers::pi * 0.5 * 0.5) * depth / std::sqrt(12.0) *
         std::sqrt(2e11 / 7850);
}

/// Requires some mode within a part of a frequency.
void expect_mode(const Modes& found, double frequency, double tolerance) {
  const auto distance = [&](const Mode& mode) { return std::abs(mode.frequency / frequency - 1); };
  EXPECT_LT(distance(*std::ranges::min_element(found.modes, {}, distance)), tolerance) << frequency;
}

ON_RANKS(1);

// Theirs is a thin bar, without shear and rotary inertia: at these lengths they lower frequencies by up to 1 %.
TEST(Frequencies, FreeBarOfEulerAndBernoulli) {
  const Modes found = bar().find({.count = 6});
  EXPECT_EQ(found.rigid_motions, 6);
  EXPECT_NEAR(found.modes[0].frequency / thin_bar(4.73004, 0.01), 1, 0.005);
  expect_mode(found, thin_bar(7.85320, 0.01), 0.005);
  expect_mode(found, thin_bar(10.99561, 0.01), 0.01);
  expect_mode(found, thin_bar(4.73004, 0.02), 0.01);
}

TEST(Frequencies, ClampedBarOfEulerAndBernoulli) {
  VibratingBody clamped = bar();
  clamped.fix("x0");
  const Modes found = clamped.find({.count = 6});
  EXPECT_EQ(found.rigid_motions, 0);
  EXPECT_NEAR(found.modes[0].frequency / thin_bar(1.87510, 0.01), 1, 0.01);
  expect_mode(found, thin_bar(4.69409, 0.01), 0.01);
  expect_mode(found, thin_bar(7.85476, 0.01), 0.01);
  expect_mode(found, thin_bar(1.87510, 0.02), 0.01);
}

// Goens and Hearmon: the thin bar's first frequency over sqrt(1 + I/(A L^2) (49.48 + 12.30 E/(5/6 G))) for rotary
// inertia and shear, which wood yields to easily.
TEST(Frequencies, WoodenBarAlongAndAcrossTheGrain) {
  VibratingBody board = bar();
  scene::Material& spruce = board.scene.materials[0];
  spruce.density = 450;
  spruce.orthotropy = {{11.9e9, 0.93e9, 0.51e9}, {0.372, 0.435, 0.467}, {0.76e9, 0.036e9, 0.73e9}};
  spruce.young = 11.9e9;
  const auto expected = [&](double young, double shear) {
    const double slenderness = 0.01 * 0.01 / 12 / (0.5 * 0.5);
    return thin_bar(4.73004, 0.01) * std::sqrt(young / 2e11 * 7850 / 450) /
           std::sqrt(1 + slenderness * (49.48 + 12.30 * young / (shear * 5 / 6)));
  };
  EXPECT_NEAR(board.find({.count = 1}).modes[0].frequency / expected(11.9e9, 0.73e9), 1, 0.005);
  board.scene.bodies[0].grain << Vector3::UnitY(), Vector3::UnitX(), -Vector3::UnitZ();
  EXPECT_NEAR(board.find({.count = 1}).modes[0].frequency / expected(0.93e9, 0.036e9), 1, 0.005);
  board.scene.bodies[0].rotation = {0, 0, std::numbers::pi / 2};  // of the material only: the mesh is made here
  EXPECT_NEAR(board.find({.count = 1}).modes[0].frequency / expected(11.9e9, 0.73e9), 1, 0.005);
}

// A bar that moves only along x and does not contract sideways: (2 k - 1) c/(4 L), c^2 = E/rho, exactly.
TEST(Frequencies, LumpedAndConsistentMassBracketTheTruth) {
  const double exact = std::sqrt(2e11 / 7850) / 4;
  double above = 0.0;
  for (const int cells : {1, 2}) {
    VibratingBody rod = block(tet10, {1.0, 0.2, 0.2}, {5 * cells, cells, cells});
    rod.scene.materials[0].poisson = 0.0;
    for (Index node = 0; node < static_cast<Index>(rod.mesh.nodes.size()); ++node) {
      rod.mesh.groups["all"].push_back(node);
    }
    rod.fix("x0");
    rod.fix("all", {false, true, true});
    const auto error = [&](MassMatrix mass, int mode) {
      return rod.find({.count = 2, .mass = mass}).modes[mode].frequency / ((2 * mode + 1) * exact) - 1;
    };
    EXPECT_LT(error(MassMatrix::lumped, 0), 0);
    EXPECT_LT(error(MassMatrix::lumped, 1), 0);
    EXPECT_GT(error(MassMatrix::consistent, 0), 0);
    const double second = error(MassMatrix::consistent, 1);
    EXPECT_GT(second, 0);
    if (cells == 2) {
      EXPECT_GT(std::log2(above / second), 3.4) << "towards the fourth order of quadratic elements";
    }
    above = second;
  }
}

// Lamb 1882; x = w a/c_s: torsional and spheroidal modes with l = 2, five of each. Two elements to the radius are few
// for the lumped mass.
TEST(Frequencies, FreeSphere) {
  scene::Body body;
  body.mesh = std::filesystem::path(IDIOPHONE_SOURCE_DIR) / "meshes/sphere.geo";
  body.parameters = {{"radius", 0.05}, {"size", 0.025}};
  body.element = tet10;
  VibratingBody ball(mesh::read_mesh(body));
  const double shear_speed = std::sqrt(2e11 / 2.6 / 7850);
  for (const auto& [mass, tolerance] : {std::pair{MassMatrix::lumped, 0.04}, {MassMatrix::consistent, 0.005}}) {
    const Modes found = ball.find({.count = 10, .mass = mass});
    EXPECT_EQ(found.rigid_motions, 6);
    for (std::size_t mode = 0; mode < 10; ++mode) {
      const double x = 2 * std::numbers::pi * found.modes[mode].frequency * 0.05 / shear_speed;
      EXPECT_NEAR(x / (mode < 5 ? 2.50113 : 2.64622), 1, tolerance) << "mode " << mode;
    }
  }
}

}  // namespace
}  // namespace idiophone::eigenmodes
