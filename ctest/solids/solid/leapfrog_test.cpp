#include "idiophone/solids/solid/leapfrog.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace idiophone::solid {
namespace {

TEST(LeapfrogTest, VelocitiesFollowTheForcesAndDisplacementsStay) {
  const std::vector<double> inverse_mass = {2, 0.25};
  const std::vector<NodeForce> force = {{{1, 2, 3, 99}}, {{-4, 8, 12, 99}}};
  std::vector<NodeState> state = {{{1, 2, 3}, {10, 20, 30}, {}}, {{4, 5, 6}, {-1, 0, 1}, {}}};
  update_velocities({.keep = 0.5, .gain = 0.1, .gravity = {0, 1, -10}}, inverse_mass, force, state);
  for (std::size_t node = 0; node < state.size(); ++node) {
    const Vector3 gravity(0, 1, -10);
    const NodeState before = node == 0 ? NodeState{{1, 2, 3}, {10, 20, 30}, {}} : NodeState{{4, 5, 6}, {-1, 0, 1}, {}};
    for (int i = 0; i < 3; ++i) {
      const double acceleration = inverse_mass[node] * force[node].component[i] + gravity[i];
      EXPECT_DOUBLE_EQ(state[node].velocity[i], 0.5 * before.velocity[i] + 0.1 * acceleration);
      EXPECT_EQ(state[node].displacement[i], before.displacement[i]);
    }
  }
}

TEST(LeapfrogTest, DisplacementsFollowTheVelocitiesWhichStay) {
  std::vector<NodeState> state = {{{1, 2, 3}, {-0.0, 20, 30}, {}}};
  update_displacements(0.1, state);
  for (int i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(state[0].displacement[i], (Vector3(1, 2, 3) + 0.1 * Vector3(0, 20, 30))[i]);
  }
  EXPECT_TRUE(std::signbit(state[0].velocity[0]));
  EXPECT_EQ(state[0].velocity[1], 20);
  EXPECT_EQ(state[0].velocity[2], 30);
}

}  // namespace
}  // namespace idiophone::solid
