#include "idiophone/solids/solid/mass.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace idiophone::solid {
namespace {

/// The second body of three nodes, whose owned nodes are 1 and 2.
class MassTest : public ::testing::Test {
 protected:
  MassTest() {
    body.owned_begin = 1;
    body.owned_end = 3;
  }

  mesh::BodyPart body;
  const std::vector<double> masses = {5, 2, 4};  // kg
  std::vector<NodeState> state = std::vector<NodeState>(3);
};

TEST_F(MassTest, TakesTheLumpedMassesOfItsOwnNodes) {
  const Mass mass(body, masses);
  EXPECT_EQ(mass.lumped(2), 4.0);
  EXPECT_EQ(std::vector(mass.lumped().begin(), mass.lumped().end()), (std::vector<double>{2, 4}));
}

TEST_F(MassTest, SolveIsTheInverseOfMultiply) {
  const Mass mass(body, masses);
  const std::vector<Vector3> velocity = {{9, 9, 9}, {1, 2, 3}, {-4, 5, 0.5}};
  std::vector<NodeForce> force(3);
  mass.multiply(state, velocity, [&](Index node, const Vector3& momentum) {
    EXPECT_EQ(momentum, masses[node] * velocity[node]);
    std::copy_n(momentum.data(), 3, force[node].component);
  });
  std::map<Index, Vector3> found;
  mass.solve(state, 0.0, force, [&](Index node, const Vector3& a) { found[node] = a; });
  EXPECT_EQ(found, (std::map<Index, Vector3>{{1, velocity[1]}, {2, velocity[2]}}));
}

TEST_F(MassTest, ImposedVelocitiesTakeTheImpulseOfTheirChange) {
  const Mass mass(body, masses);
  state[2].velocity[0] = 7.0;
  state[2].velocity[1] = 1.0;
  const std::vector<Index> components = {7};  // y of node 2
  const std::vector<double> velocities = {3.0};
  std::vector<double> impulses(1);
  mass.impose(components, velocities, state, impulses);
  EXPECT_EQ(impulses[0], 4 * (3.0 - 1.0));
  EXPECT_EQ(state[2].velocity[0], 7.0);
  EXPECT_EQ(state[2].velocity[1], 3.0);
}

TEST_F(MassTest, FactorsMakeTheInverseOfItsEntries) {
  const Mass mass(body, masses);
  const std::vector<double> x = {1, 2, 3, 4, 5, 6};
  std::vector<double> inverted = x;  // L L^T x
  mass.apply_transposed_inverse_factor(inverted);
  mass.apply_inverse_factor(inverted);
  std::vector<double> product(6);
  std::map<Index, int> in_row;
  mass.for_each_entry([&](Index row, Index column, double value) {
    product[row - 3] += value * inverted[column - 3];
    EXPECT_LE(++in_row[row], mass.entries_per_row());
  });
  for (std::size_t i = 0; i < x.size(); ++i) {
    EXPECT_NEAR(product[i], x[i], 1e-14);
  }
}

}  // namespace
}  // namespace idiophone::solid
