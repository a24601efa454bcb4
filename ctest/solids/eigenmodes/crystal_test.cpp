// Frequencies of a free block of a crystal that lies in it askew, against an expansion in polynomials.

#include <Eigen/Geometry>

#include "block_expansion.hpp"
#include "ranks.hpp"
#include "vibrating_body.hpp"

namespace idiophone::eigenmodes {
namespace {

/// Quartz: McSkimin, Andreatch and Thurston, Journal of Applied Physics 36, 1965.
scene::Material quartz() {
  scene::Material material{"quartz", 97e9, 0, 2648, {}, {}};
  material.crystal = {scene::Symmetry::trigonal, {86.8e9, 7.04e9, 11.91e9, -18.04e9, 105.75e9, 58.2e9, 0}};
  return material;
}

ON_RANKS(1);

TEST(Crystal, BlockThatLiesAskewHasTheFrequenciesOfAnExpansionInPolynomials) {
  const Vector3 size(0.03, 0.024, 0.017);
  VibratingBody body = block(element::hex(8, 8), size, {1, 1, 1});
  body.scene.materials[0] = quartz();
  body.scene.bodies[0].grain = Eigen::AngleAxisd(1.1, Vector3(1, 2, -1).normalized()).toRotationMatrix();
  const std::vector<double> expected = expansion(quartz(), body.scene.bodies[0].grain, size, 11);
  const Modes found = body.find({.count = 12, .mass = MassMatrix::consistent});
  EXPECT_EQ(found.rigid_motions, 6);
  for (std::size_t mode = 0; mode < 12; ++mode) {
    EXPECT_NEAR(found.modes[mode].frequency / expected[6 + mode], 1.0, 1e-4) << "mode " << mode;
  }
}

}  // namespace
}  // namespace idiophone::eigenmodes
