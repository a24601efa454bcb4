// Forces that are begun before the motion of the ghosts is known have the bits of those that are computed at once.

#include "idiophone/solids/solid/pack_division.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>

#include "block_mesh.hpp"
#include "idiophone/solids/mesh/part_size.hpp"
#include "idiophone/solids/solid/solid.hpp"

namespace idiophone::solid {
namespace {

constexpr int ranks = 3;
constexpr double step = 1e-5;  // s

scene::Material steel_with_loss(double loss) {
  scene::Material material{"steel", 2.0e11, 0.3, 7850, {0, 1e-7}, {}};
  if (loss > 0) {
    material.damping.loss = {loss, {100, 10000}, {}, {}};
  }
  return material;
}

void move(std::mt19937& random, std::span<NodeState> state) {
  std::uniform_real_distribution<double> uniform(-1e-4, 1e-4);
  for (NodeState& node : state) {
    std::ranges::generate(node.displacement, [&] { return uniform(random); });
    std::ranges::generate(node.velocity, [&] { return uniform(random) / step; });
  }
}

/// Velocities and displacements that nobody may use.
std::vector<NodeState> with_unknown_ghosts(std::vector<NodeState> state, Index owned) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  for (NodeState& ghost : std::span(state).subspan(owned)) {
    std::ranges::fill(ghost.displacement, unknown);
    std::ranges::fill(ghost.velocity, unknown);
  }
  return state;
}

void expect_same_bits(std::span<const NodeForce> forces, std::span<const NodeForce> expected) {
  for (std::size_t node = 0; node < forces.size(); ++node) {
    for (int i = 0; i < 3; ++i) {
      ASSERT_EQ(forces[node].component[i], expected[node].component[i]) << "node " << node;
    }
  }
}

class PackDivisionTest : public ::testing::TestWithParam<element::Type> {
 protected:
  /// Calls visit(part) with the part of each rank.
  template <class Visitor>
  void for_each_part(Visitor visit) const {
    mesh::for_each_part({support::block_mesh(GetParam(), {0.6, 0.2, 0.1}, {24, 4, 2})}, ranks, visit);
  }
};

TEST_P(PackDivisionTest, ForcesBegunWithoutGhostsHaveTheSameBits) {
  for (const double loss : {0.0, 0.1}) {
    for_each_part([&](const mesh::Part& part) {
      Solid whole(part.bodies[0], part.reference, steel_with_loss(loss));
      Solid divided(part.bodies[0], part.reference, steel_with_loss(loss));
      divided.divide(part.bodies[0]);
      whole.begin_memory(step);
      divided.begin_memory(step);
      std::mt19937 random(5);
      std::vector<NodeState> state(part.node_ids.size());
      for (int time = 0; time < 3; ++time) {
        move(random, state);
        std::vector<NodeForce> expected(state.size());
        std::vector<NodeForce> force(state.size());
        whole.add_internal_force_and_remember(state, expected);
        divided.begin_internal_force(with_unknown_ghosts(state, part.owned_nodes), force);
        divided.finish_internal_force(state, force);
        expect_same_bits(std::span(force).first(part.owned_nodes), std::span(expected).first(part.owned_nodes));
      }
    });
  }
}

TEST_P(PackDivisionTest, EachPackIsEitherAnInnerOrABorderOne) {
  for_each_part([](const mesh::Part& part) {
    const PackDivision division = PackDivision::by_ghosts(part.bodies[0]);
    ASSERT_FALSE(division.border.empty());
    std::vector<int> times((part.bodies[0].element_ids.size() + lanes - 1) / lanes);
    for (const auto& ranges : {division.inner, division.border}) {
      for (const PackRange& range : ranges) {
        std::for_each(times.begin() + static_cast<std::ptrdiff_t>(range.begin),
                      times.begin() + static_cast<std::ptrdiff_t>(range.end), [](int& count) { ++count; });
      }
    }
    EXPECT_EQ(std::ranges::count(times, 1), std::ssize(times));
  });
}

TEST(PackDivision, ABodyWithoutGhostsHoldsNoForces) {
  const mesh::Mesh mesh = support::block_mesh(element::tet4, {1, 1, 1}, {3, 3, 3});
  const PackDivision division = PackDivision::by_ghosts(support::whole_part(mesh).bodies[0]);
  EXPECT_TRUE(division.border.empty());
  ASSERT_EQ(division.inner.size(), 1U);
  EXPECT_EQ(division.inner[0].end, (mesh.element_count() + lanes - 1) / lanes);
  EXPECT_EQ(division.held.slots(0), nullptr);
}

INSTANTIATE_TEST_SUITE_P(Elements, PackDivisionTest,
                         ::testing::Values(element::tet4, element::tet10, element::hex(2, 2)));

}  // namespace
}  // namespace idiophone::solid
