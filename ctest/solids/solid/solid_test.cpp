#include "idiophone/solids/solid/solid.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstring>
#include <numeric>
#include <random>

#include "block_mesh.hpp"
#include "force_check.hpp"
#include "idiophone/foundation/element/tetrahedra.hpp"
#include "idiophone/solids/solid/tangent_stiffness.hpp"

namespace idiophone::solid {
namespace {

const scene::Material damped_steel{"steel", 2.0e11, 0.3, 7850, {0, 1e-7}, {}};
const Vector3 brick_size(0.3, 0.2, 0.1);

/// A block whose inner nodes are moved about, so that no element is regular. Tet10's sides stay straight unless curved.
mesh::Mesh distorted_block(element::Type type, bool curved) {
  mesh::Mesh mesh = support::block_mesh(type, brick_size, {3, 2, 2});
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-0.008, 0.008);
  const auto inside = [](const Vector3& x) {
    return (x.array() > 1e-9).all() && (x.array() < brick_size.array() - 1e-9).all();
  };
  std::vector<char> corner(mesh.nodes.size());
  for (Index e = 0; e < mesh.element_count(); ++e) {
    for (std::size_t a = 0; a < 4; ++a) {
      corner[mesh.element_nodes(e)[a]] = 1;
    }
  }
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
    if (inside(mesh.nodes[node]) && (corner[node] != 0 || curved)) {
      const double scale = corner[node] != 0 ? 1.0 : 0.3;
      mesh.nodes[node] += scale * Vector3(uniform(random), uniform(random), uniform(random));
    }
  }
  if (type == element::tet10 && !curved) {
    for (Index e = 0; e < mesh.element_count(); ++e) {
      const auto nodes = mesh.element_nodes(e);
      for (std::size_t edge = 0; edge < 6; ++edge) {
        const auto [i, j] = element::tetrahedron_edges[edge];
        mesh.nodes[nodes[4 + edge]] = (mesh.nodes[nodes[i]] + mesh.nodes[nodes[j]]) / 2;
      }
    }
  }
  return mesh;
}

struct SolidCase {
  element::Type type;
  bool curved;
};

class SolidTest : public ::testing::TestWithParam<SolidCase> {
 protected:
  SolidTest()
      : mesh(distorted_block(GetParam().type, GetParam().curved)),
        part(support::whole_part(mesh)),
        solid(part.bodies[0], part.reference, damped_steel),
        state(mesh.nodes.size()),
        force(mesh.nodes.size()) {}

  /// Four Gauss points integrate a curved element's volume (of degree 3 in xi) only nearly: here to 1e-3 of an element.
  [[nodiscard]] static double round_off() { return GetParam().curved ? 1e-3 : 1e-12; }

  template <class Field>
  void displace(Field field) {
    for (std::size_t node = 0; node < state.size(); ++node) {
      const Vector3 u = field(mesh.nodes[node]);
      std::copy_n(u.data(), 3, state[node].displacement);
    }
  }
  [[nodiscard]] double largest_force() const { return support::largest_component(force); }
  [[nodiscard]] double energy() const {
    std::vector<double> each(solid.element_count());
    solid.elastic_energy(state, each);
    return std::accumulate(each.begin(), each.end(), 0.0);
  }

  mesh::Mesh mesh;
  mesh::Part part;
  Solid solid;
  std::vector<NodeState> state;
  std::vector<NodeForce> force;
};

TEST_P(SolidTest, PatchTestUniformStrainLeavesInnerNodesWithoutForce) {
  Eigen::Matrix3d h;
  h << 1e-3, 2e-4, -3e-4, 4e-4, -5e-4, 6e-4, 1e-4, -2e-4, 3e-4;
  displace([&](const Vector3& x) -> Vector3 { return h * x; });
  solid.add_internal_force(state, force);
  const double scale = largest_force();
  ASSERT_GT(scale, 0.0);
  for (std::size_t node = 0; node < state.size(); ++node) {
    const auto& x = mesh.nodes[node].array();
    if ((x > 1e-9).all() && (x < brick_size.array() - 1e-9).all()) {
      for (const double component : force[node].component) {
        EXPECT_NEAR(component / scale, 0.0, round_off());
      }
    }
  }
  // The energy is that of the exact uniform strain.
  const Eigen::Matrix3d strain = (h + h.transpose() + h.transpose() * h) / 2;
  const auto [lambda, mu] = std::get<IsotropicElasticity>(elasticity(damped_steel));
  const double energy_density = lambda / 2 * strain.trace() * strain.trace() + mu * strain.squaredNorm();
  EXPECT_NEAR(energy() / (energy_density * brick_size.prod()), 1.0, round_off());
}

TEST_P(SolidTest, RigidRotationGivesNoForce) {
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(0.5, Vector3(1, 2, 3).normalized()).toRotationMatrix();
  displace([&](const Vector3& x) -> Vector3 { return rotation * x - x + Vector3(1, 2, 3); });
  solid.add_internal_force(state, force);
  EXPECT_LT(largest_force(), 1e-12 * damped_steel.young * brick_size.squaredNorm());
}

TEST_P(SolidTest, RigidSpinGivesNoDampingForce) {
  const Vector3 spin(100, 200, -300);
  for (std::size_t node = 0; node < state.size(); ++node) {
    const Vector3 v = spin.cross(mesh.nodes[node]);
    std::copy_n(v.data(), 3, state[node].velocity);
  }
  solid.add_internal_force(state, force);
  EXPECT_LT(largest_force(),
            1e-12 * damped_steel.young * damped_steel.damping.stiffness * spin.norm() * brick_size.squaredNorm());
}

TEST_P(SolidTest, ForceIsMinusTheGradientOfTheEnergy) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  displace([&](const Vector3&) { return Vector3(2e-4 * Vector3(uniform(random), uniform(random), uniform(random))); });
  solid.add_internal_force(state, force);
  support::expect_minus_gradient(state, force, [&] { return energy(); },
                                 {.stride = 13, .step = 1e-7, .tolerance = 1e-6});
}

TEST_P(SolidTest, TangentStiffnessIsTheForcesDerivative) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-2e-3, 2e-3);
  displace([&](const Vector3&) { return Vector3(uniform(random), uniform(random), uniform(random)); });
  const auto width = static_cast<std::size_t>(element::node_count(mesh.element));
  mesh::BodyPart one = part.bodies[0];
  one.element_ids.resize(1);
  one.elements.resize(width);
  const Solid element(one, part.reference, damped_steel);
  std::vector<Vector3> reference(width);
  std::vector<Vector3> displacement(width);
  for (std::size_t a = 0; a < width; ++a) {
    const auto node = static_cast<std::size_t>(one.elements[a]);
    reference[a] = mesh.nodes[node];
    displacement[a] = Eigen::Map<const Vector3>(state[node].displacement);
  }
  const Eigen::MatrixXd k = tangent_stiffness(mesh.element, elasticity(damped_steel), reference, displacement);
  const double small = 1e-8;
  const double scale = k.cwiseAbs().maxCoeff();
  for (std::size_t column = 0; column < 3 * width; ++column) {
    double& u = state[static_cast<std::size_t>(one.elements[column / 3])].displacement[column % 3];
    const double here = u;
    std::vector<NodeForce> above(force.size());
    std::vector<NodeForce> below(force.size());
    u = here + small;
    element.add_internal_force(state, above);
    u = here - small;
    element.add_internal_force(state, below);
    u = here;
    for (std::size_t row = 0; row < 3 * width; ++row) {
      const auto node = static_cast<std::size_t>(one.elements[row / 3]);
      const double slope = -(above[node].component[row % 3] - below[node].component[row % 3]) / (2 * small);
      EXPECT_NEAR(k(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) / scale, slope / scale, 1e-6);
    }
  }
}

TEST_P(SolidTest, LumpedMassesAddUpToTheBodys) {
  std::vector<double> mass(mesh.nodes.size());
  solid.add_mass(mass);
  EXPECT_NEAR(std::accumulate(mass.begin(), mass.end(), 0.0) / (damped_steel.density * brick_size.prod()), 1.0,
              round_off());
  EXPECT_GT(*std::ranges::min_element(mass), 0.0);
}

TEST_P(SolidTest, AnElementsForceDoesNotDependOnItsPackOrLane) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1e-4, 1e-4);
  displace([&](const Vector3&) { return Vector3(uniform(random), uniform(random), uniform(random)); });
  const auto width = static_cast<std::ptrdiff_t>(element::node_count(mesh.element));
  std::vector<NodeForce> whole(force.size());
  solid.add_internal_force(state, whole);
  // The same sum, with every element alone in a pack of its own.
  for (Index e = 0; e < mesh.element_count(); ++e) {
    mesh::BodyPart one = part.bodies[0];
    one.element_ids = {e};
    one.elements.assign(part.bodies[0].elements.begin() + e * width, part.bodies[0].elements.begin() + (e + 1) * width);
    Solid(one, part.reference, damped_steel).add_internal_force(state, force);
  }
  EXPECT_EQ(std::memcmp(whole.data(), force.data(), sizeof(NodeForce) * force.size()), 0);
}

TEST_P(SolidTest, RefusesAnInvertedElement) {
  for (Vector3& x : part.reference) {
    x[0] = -x[0];
  }
  EXPECT_THROW(Solid(part.bodies[0], part.reference, damped_steel), std::runtime_error);
}

INSTANTIATE_TEST_SUITE_P(Types, SolidTest,
                         ::testing::Values(SolidCase{element::tet4, false}, SolidCase{element::tet10, false},
                                           SolidCase{element::tet10, true}),
                         [](const auto& test) {
                           return std::string(test.param.type == element::tet4 ? "tet4" : "tet10") +
                                  (test.param.curved ? "curved" : "");
                         });

}  // namespace
}  // namespace idiophone::solid
