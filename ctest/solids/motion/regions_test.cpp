// Motion of a body of two materials: what is conserved of one material is conserved, and a saved state goes on.

#include "regions.hpp"

#include "laboratory.hpp"
#include "ranks.hpp"

namespace idiophone::motion {
namespace {

/// A block of rubber whose other half is stiffer and heavier.
Laboratory two_halves(element::Type type) {
  Laboratory lab(support::with_regions(support::block_mesh(type, {0.2, 0.1, 0.05}, {4, 2, 1}),
                                       [](const Vector3& centre) { return centre.x() < 0.1 ? 0 : 1; }));
  lab.scene.materials.push_back({"hard", 4e6, 0.2, 2000, {0, 0}, {}});
  lab.scene.bodies[0].regions = {{.name = "soft", .material = 0, .where = {}},
                                 {.name = "hard", .material = 1, .where = {}}};
  return lab;
}

class TwoMaterials : public ::testing::TestWithParam<element::Type> {
 protected:
  static constexpr double step = 5e-5;  // s
};

ON_RANKS(1);

TEST_P(TwoMaterials, HaveTheirMasses) {
  Laboratory lab = two_halves(GetParam());
  lab.begin(step);
  EXPECT_NEAR(lab.initial_state.masses[0], 0.1 * 0.1 * 0.05 * (1000 + 2000), 1e-12);
  EXPECT_NEAR(lab.initial_state.centres[0].x(), (0.05 * 1000 + 0.15 * 2000) / 3000, 1e-12);
}

TEST_P(TwoMaterials, ConserveEnergyAndMomentum) {
  Laboratory lab = two_halves(GetParam());
  lab.scene.bodies[0].spin = {0, 0, 20};
  lab.push("x1", {0, 3, 10}, 5e-3);
  lab.begin(step);
  lab.advance(120);
  const BodyMotion start = lab.observe();
  const double energy = start.kinetic + start.elastic;
  EXPECT_GT(start.elastic, 1e-3 * energy) << "it vibrates";
  for (int sample = 0; sample < 40; ++sample) {
    lab.advance(25);
    const BodyMotion now = lab.observe();
    EXPECT_NEAR((now.kinetic + now.elastic) / energy, 1.0, 1e-3);
    EXPECT_LT((now.velocity - start.velocity).norm(), 1e-12 * start.velocity.norm());
    EXPECT_LT((now.angular_momentum - start.angular_momentum).norm(), 1e-11 * start.angular_momentum.norm());
  }
}

TEST_P(TwoMaterials, GoOnFromASavedState) {
  Laboratory lab = two_halves(GetParam());
  lab.scene.materials[1].damping.loss = {0.1, {50, 2000}, {}, {}};
  lab.push("x1", {0, 3, 10}, 5e-3);
  expect_a_saved_state_to_go_on(lab, step, 30);
}

INSTANTIATE_TEST_SUITE_P(Elements, TwoMaterials, ::testing::Values(element::tet4, element::tet10, element::hex(2, 2)));

}  // namespace
}  // namespace idiophone::motion
