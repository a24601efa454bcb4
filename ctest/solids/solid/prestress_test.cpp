// Bodies that are stressed where they rest: their forces, energies and stiffness.

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "block_mesh.hpp"
#include "force_check.hpp"
#include "idiophone/foundation/dense/dense.hpp"
#include "idiophone/solids/solid/solid.hpp"
#include "idiophone/solids/solid/tangent_stiffness.hpp"

namespace idiophone::solid {
namespace {

/// Of the size of the shear modulus, so that its stiffness counts.
Eigen::Matrix3d pull() {
  Eigen::Matrix3d stress;
  stress << 3e5, 1e5, -4e4, 1e5, 2e5, 5e4, -4e4, 5e4, -1e5;
  return stress;
}

/// @param damping  may have a loss factor
OrientedMaterial stressed_rubber(const scene::Damping& damping = {}) {
  return {.material = {"rubber", 1e6, 0.3, 1000, damping, {}}, .stress = pull()};
}

class PrestressedTest : public ::testing::TestWithParam<element::Type> {
 protected:
  void displace(double largest) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-largest, largest);
    for (NodeState& node : state) {
      for (double& u : node.displacement) {
        u = uniform(random);
      }
    }
  }

  [[nodiscard]] Solid solid_of(const OrientedMaterial& material) const {
    return {part.bodies[0], part.reference, std::array{material}};
  }

  const Vector3 size{0.2, 0.1, 0.05};
  mesh::Mesh mesh = support::block_mesh(GetParam(), size, {2, 1, 1});
  mesh::Part part = support::whole_part(mesh);
  std::vector<NodeState> state{mesh.nodes.size()};
  std::vector<NodeForce> force{mesh.nodes.size()};
};

TEST_P(PrestressedTest, PullsOnItsFacesAtRest) {
  const scene::Damping none;
  scene::Damping by_stiffness;
  by_stiffness.stiffness = 1e-5;
  scene::Damping with_loss = by_stiffness;
  with_loss.loss = {0.2, {100, 10000}, {}, {}};
  for (const scene::Damping& damping : {none, by_stiffness, with_loss}) {
    Solid solid = solid_of(stressed_rubber(damping));
    for (const bool with_memory : {false, true}) {
      if (with_memory) {
        solid.begin_memory(1e-5);
      }
      std::ranges::fill(force, NodeForce{});
      solid.add_internal_force_and_remember(state, force);
      Vector3 on_face = Vector3::Zero();
      for (const Index node : mesh.groups.at("x1")) {
        on_face += Vector3(force[node].component);
      }
      const Vector3 expected = -pull().col(0) * size.y() * size.z();
      EXPECT_LT((on_face - expected).norm(), 1e-12 * expected.norm());
    }
  }
}

TEST_P(PrestressedTest, ForceIsMinusTheGradientOfTheEnergy) {
  const Solid solid = solid_of(stressed_rubber());
  displace(1e-3);
  solid.add_internal_force(state, force);
  const auto energy = [&] {
    std::vector<double> all(part.bodies[0].element_ids.size());
    solid.elastic_energy(state, all);
    return std::accumulate(all.begin(), all.end(), 0.0);
  };
  support::expect_minus_gradient(state, force, energy, {.stride = 7, .step = 1e-6, .tolerance = 1e-6});
}

TEST_P(PrestressedTest, TangentStiffnessIsTheForcesDerivative) {
  mesh::BodyPart one = part.bodies[0];
  one.element_ids.resize(1);
  one.elements.resize(static_cast<std::size_t>(element::node_count(mesh.element)));
  const Solid solid(one, part.reference, std::array{stressed_rubber()});
  displace(1e-3);
  std::vector<Vector3> reference;
  std::vector<Vector3> displacement;
  for (const Index node : one.elements) {
    reference.push_back(part.reference[node]);
    displacement.emplace_back(state[node].displacement);
  }
  const Eigen::MatrixXd k =
      tangent_stiffness(mesh.element, solid.elasticity(), reference, displacement, solid.initial_stress());
  support::expect_tangent(
      k, one.elements, state, [&](std::vector<NodeForce>& all) { solid.add_internal_force(state, all); },
      {.stride = 1 + static_cast<std::size_t>(k.cols()) / 20, .step = 1e-6, .tolerance = 1e-6 * k.norm()});
}

TEST_P(PrestressedTest, TheShareOfTheGeometricStiffnessIsABound) {
  constexpr double pull_everywhere = 2e5;  // Pa
  OrientedMaterial taut = stressed_rubber();
  taut.stress = pull_everywhere * Eigen::Matrix3d::Identity();
  const Solid solid = solid_of(taut);
  std::vector<Vector3> reference;
  for (const Index node : part.bodies[0].element_nodes(0)) {
    reference.push_back(part.reference[node]);
  }
  const std::vector<Vector3> at_rest(reference.size(), Vector3::Zero());
  const auto largest = [&](const Eigen::Matrix3d& stress) {
    return dense::eigenpairs(tangent_stiffness(mesh.element, solid.elasticity(), reference, at_rest, stress))
        .values.maxCoeff();
  };
  const double added = largest(taut.stress) / largest(Eigen::Matrix3d::Zero()) - 1;
  EXPECT_GT(added, 0.1 * solid.geometric_share());
  EXPECT_LT(added, solid.geometric_share());
  EXPECT_NEAR(solid.geometric_share(), pull_everywhere / (1e6 / 2.6), 1e-12);
  EXPECT_EQ(solid_of({.material = taut.material}).geometric_share(), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Elements, PrestressedTest,
                         ::testing::Values(element::tet4, element::tet10, element::hex(3, 2)));

}  // namespace
}  // namespace idiophone::solid
