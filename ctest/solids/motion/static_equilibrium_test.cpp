#include "static_equilibrium.hpp"

#include <gtest/gtest.h>

#include "laboratory.hpp"
#include "ranks.hpp"

namespace idiophone::motion {
namespace {

Laboratory plucked_bar(double force, double thickness = 0.05) {
  Laboratory lab(support::block_mesh(element::tet10, {1.0, thickness, thickness}, {20, 1, 1}));
  lab.scene.materials[0] = {"steel", 2e11, 0.0, 7850, {}, {}};
  lab.fix("x0");
  scene::Pluck pluck;
  pluck.force = {0, 0, force};
  lab.scene.plucks.push_back(pluck);
  const auto& tip = lab.mesh.groups.at("x1");
  lab.attachments.plucks.push_back({tip, std::vector(tip.size(), 1.0 / static_cast<double>(tip.size()))});
  return lab;
}

std::vector<double> equilibrium(const Laboratory& lab) {
  const FiniteElementDynamics dynamics(lab.scene, lab.part, lab.attachments);
  return static_equilibrium(lab.scene, lab.part, lab.attachments, dynamics);
}

double tip_deflection(const Laboratory& lab, const std::vector<double>& displacement) {
  double mean = 0.0;
  const auto& tip = lab.mesh.groups.at("x1");
  for (const Index node : tip) {
    mean += displacement[3 * static_cast<std::size_t>(node) + 2] / static_cast<double>(tip.size());
  }
  return mean;
}

ON_RANKS(1);

TEST(StaticEquilibrium, CantileverBendsAsTimoshenkoSays) {
  const double force = 100;
  const Laboratory lab = plucked_bar(force);
  const double inertia = std::pow(0.05, 4) / 12;
  const double shear = force / (5.0 / 6.0 * 1e11 * 0.05 * 0.05);  // shear modulus E/2 for nu = 0
  const double expected = force / (3 * 2e11 * inertia) + shear;
  EXPECT_NEAR(tip_deflection(lab, equilibrium(lab)) / expected, 1.0, 0.01);
}

TEST(StaticEquilibrium, LargeDeflectionFollowsTheElastica) {
  // F L^2/(E I) = 2: the tip sinks by 0.4935 L (Bisshopp and Drucker 1945).
  const Laboratory lab = plucked_bar(2 * 2e11 * std::pow(0.05, 4) / 12);
  EXPECT_NEAR(tip_deflection(lab, equilibrium(lab)), 0.4935, 0.4935 * 0.02);
}

TEST(StaticEquilibrium, IsFoundForASlenderBodyThatBendsFar) {
  // F L^2/(E I) = 10, the bar 200 times as long as thick: the tip sinks by 0.8106 L.
  const Laboratory lab = plucked_bar(10 * 2e11 * std::pow(0.005, 4) / 12, 0.005);
  EXPECT_NEAR(tip_deflection(lab, equilibrium(lab)), 0.8106, 0.8106 * 0.02);
}

TEST(StaticEquilibrium, ThePluckIsAllThatIsMissingWhenTheMotionBegins) {
  Laboratory lab = plucked_bar(100);
  const std::vector<double> displacement = equilibrium(lab);
  Motion& motion = lab.begin(1e-7, displacement);
  std::vector<NodeForce> force(lab.mesh.nodes.size());
  motion.dynamics().compute_force(0.0, motion.state(), force);
  Vector3 tip = Vector3::Zero();
  for (const Index node : lab.mesh.groups.at("x1")) {
    tip += Eigen::Map<const Vector3>(force[node].component);
  }
  EXPECT_LT((tip - Vector3(0, 0, -100)).norm(), 1e-4);
}

TEST(StaticEquilibrium, RefusesABodyThatNothingHolds) {
  Laboratory lab = plucked_bar(100);
  lab.scene.bodies[0].fixed.clear();
  lab.attachments.bodies[0].fixed.clear();
  EXPECT_THROW((void)equilibrium(lab), deck::DeckError);
}

}  // namespace
}  // namespace idiophone::motion
