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

/// A strip of two layers, of which the upper one grows with the temperature, held at one end.
Laboratory bimetal_strip(double growth) {
  Laboratory lab(support::block_mesh(element::tet10, {1.0, 0.05, 0.05}, {20, 1, 2}));
  lab.scene.materials[0] = {"invar", 2e11, 0.0, 7850, {}, {}};
  lab.scene.materials.push_back(lab.scene.materials[0]);
  lab.scene.materials[0].expansion = 0.0;
  lab.scene.materials[1].expansion = growth;
  lab.scene.bodies[0].regions.resize(2);
  lab.scene.bodies[0].regions[1].material = 1;
  lab.scene.bodies[0].prestress.emplace().temperature = 1.0;
  mesh::BodyPart& body = lab.part.bodies[0];
  for (std::size_t element = 0; element < body.element_ids.size(); ++element) {
    double highest = 0.0;
    for (const Index node : body.element_nodes(element)) {
      highest = std::max(highest, lab.mesh.nodes[node].z());
    }
    body.regions.push_back(highest > 0.026 ? 1 : 0);
  }
  lab.fix("x0");
  return lab;
}

/// S. Timoshenko, Analysis of bi-metal thermostats, Journal of the Optical Society of America 11, 1925: the curvature
/// of two layers of the same stiffness and thickness is 3/2 of the difference of growths over the whole thickness.
TEST(StaticEquilibrium, ABimetalStripBendsAsTimoshenkoSays) {
  constexpr double growth = 1e-5;
  const Laboratory lab = bimetal_strip(growth);
  EXPECT_NEAR(tip_deflection(lab, equilibrium(lab)) / (-1.5 * growth / 0.05 / 2), 1.0, 0.01);
}

TEST(StaticEquilibrium, AWarmStripStaysAtRest) {
  Laboratory lab = bimetal_strip(1e-3);
  lab.begin(5e-7, equilibrium(lab));
  const double elastic = lab.observe().elastic;
  lab.advance(200);
  EXPECT_LT(elastic, 0.0) << "it gave energy when it bent";
  EXPECT_LT(lab.observe().kinetic, -1e-12 * elastic);
}

}  // namespace
}  // namespace idiophone::motion
