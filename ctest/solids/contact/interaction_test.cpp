#include <gtest/gtest.h>

#include <cmath>

#include "idiophone/foundation/friction/elasto_plastic_friction.hpp"
#include "overlapping_blocks.hpp"
#include "ranks.hpp"

namespace idiophone::contact {
namespace {

using element::Type;

constexpr double stiffness = 1e6;  // Pa/m
constexpr double step = 1e-5;      // s

scene::Contact frictionless() {
  return {};
}

/// Two shaken blocks, a corner region of the upper one inside the lower one.
struct Pair {
  explicit Pair(element::Type element, const scene::Contact& contact = frictionless())
      : lower(element, {1, 1, 0.5}, {2, 2, 1}, Shaker(0.02)),
        upper(
            element, {0.7, 0.8, 0.5}, {2, 1, 1},
            [shake = Shaker(0.02)](const Vector3& x) mutable { return Vector3(shake(x) + Vector3(0.33, 0.41, 0.45)); }),
        interaction(contact, stiffness, step, upper.side, lower.side) {
    interaction.choose_candidates(upper.cells(), lower.cells(), 1.0);
    compute(interaction);
  }
  Block lower;
  Block upper;
  Interaction interaction;
};

class Elements : public testing::TestWithParam<element::Type> {};
INSTANTIATE_TEST_SUITE_P(Elements, Elements, testing::Values(element::tet4, element::tet10));

ON_RANKS(1);

TEST_P(Elements, ForceIsTheGradientOfTheEnergy) {
  Pair pair(GetParam());
  ASSERT_GT(pair.interaction.energy(), 0.0);
  for (Side* side : {&pair.upper.side, &pair.lower.side}) {
    const std::vector<Index> touched = side->touched;
    const std::vector<Vector3> force = side->force;
    double largest = 0.0;
    for (const Index node : touched) {
      largest = std::max(largest, force[node].norm());
    }
    for (const Index node : touched) {
      Vector3& x = side->position[node];
      for (int axis = 0; axis < 3; ++axis) {
        constexpr double small = 1e-6;
        const double before = x[axis];
        x[axis] = before + small;
        compute(pair.interaction);
        const double above = pair.interaction.energy();
        x[axis] = before - small;
        compute(pair.interaction);
        const double below = pair.interaction.energy();
        x[axis] = before;
        EXPECT_NEAR(force[node][axis], -(above - below) / (2 * small), 1e-6 * largest);
      }
    }
  }
}

TEST_P(Elements, ForcesBalanceInSumAndMoment) {
  scene::Contact contact;
  contact.friction = {0.5, 0.4};
  contact.damping = 1e-4;
  Pair pair(GetParam(), contact);
  for (std::size_t i = 0; i < pair.upper.side.velocity.size(); ++i) {
    pair.upper.side.velocity[i] = Vector3(1, 2, -1) + 0.1 * pair.upper.side.position[i];
  }
  compute(pair.interaction, BondUpdate::stretch);
  Vector3 sum = Vector3::Zero();
  Vector3 moment = Vector3::Zero();
  double scale = 0.0;
  for (const Side* side : {&pair.upper.side, &pair.lower.side}) {
    for (const Index node : side->touched) {
      const Vector3& force = side->force[node];
      sum += force;
      moment += side->position[node].cross(force);
      scale += force.norm();
    }
  }
  ASSERT_GT(scale, 0.0);
  EXPECT_LT(sum.norm(), 1e-13 * scale);
  EXPECT_LT(moment.norm(), 1e-13 * scale);
}

TEST_P(Elements, GrowthOfTheVolumesFollowsTheVelocities) {
  Pair pair(GetParam());
  Shaker shake(1.0);
  for (Side* side : {&pair.upper.side, &pair.lower.side}) {
    for (Vector3& velocity : side->velocity) {
      velocity = shake(Vector3::Zero());
    }
  }
  compute(pair.interaction);
  const std::vector<Touch> now = pair.upper.side.touch;
  const auto volumes_after = [&](double time) {
    for (Side* side : {&pair.upper.side, &pair.lower.side}) {
      for (std::size_t i = 0; i < side->position.size(); ++i) {
        side->position[i] += time * side->velocity[i];
      }
    }
    compute(pair.interaction);
    return pair.upper.side.touch;
  };
  constexpr double small = 1e-6;
  const std::vector<Touch> after = volumes_after(small);
  const std::vector<Touch> before = volumes_after(-2 * small);
  for (std::size_t i = 0; i < now.size(); ++i) {
    EXPECT_NEAR(now[i].growth, (after[i].volume - before[i].volume) / (2 * small), 1e-8);
  }
}

TEST_P(Elements, PortionsOfTheOverlapsAreTheWholeToTheBit) {
  Pair pair(GetParam());
  const std::vector<Vector3> force = pair.upper.side.force;
  const double volume = pair.interaction.overlaps().volume();
  pair.interaction.find_near_pairs();
  Overlaps joined;
  for (const std::size_t number : {0U, 1U, 2U}) {
    pair.interaction.overlaps().clear();
    pair.interaction.find_overlaps({number, 3});
    EXPECT_GT(pair.interaction.overlaps().cells().size(), 0U);
    joined.append(pair.interaction.overlaps().cells(), pair.interaction.overlaps().faces());
  }
  pair.interaction.overlaps() = joined;
  pair.interaction.compute_forces(BondUpdate::keep);
  EXPECT_EQ(pair.interaction.overlaps().volume(), volume);
  EXPECT_EQ(pair.upper.side.force, force);
}

TEST_P(Elements, FlatBlockPressesEvenlyAndAsHardAsItIsDeep) {
  constexpr double depth = 1e-3;
  Block block(GetParam(), {1, 1, 0.5}, {3, 3, 2}, [=](const Vector3& x) { return Vector3(x - Vector3(0, 0, depth)); });
  scene::Obstacle floor;
  const RigidShape shape = make_shape(floor);
  Interaction interaction(frictionless(), stiffness, step, block.side, shape);
  interaction.choose_candidates(block.cells(), {0}, 0.1);
  compute(interaction);
  const ContactMotion motion = interaction.motion();
  EXPECT_NEAR(motion.overlap, depth, 1e-12);
  for (std::size_t i = 0; i < block.skin.nodes.size(); ++i) {
    const Vector3& x = block.side.position[i];
    if (x.z() < 0 && std::max(std::abs(x.x() - 0.5), std::abs(x.y() - 0.5)) < 0.2) {
      // Away from the edges, whose nodes belong to other faces, too. The nodes below the surface have a little of it.
      EXPECT_NEAR(block.side.touch[i].pressure, stiffness * depth, 0.01 * stiffness * depth);
    }
  }
  EXPECT_GT(motion.force.z(), 0.7 * stiffness * depth);
  EXPECT_LT(motion.force.z(), stiffness * depth);
  EXPECT_NEAR(motion.point.x(), 0.5, 0.02);
  EXPECT_NEAR(motion.spread(0, 0), 1.0 / 12, 0.02);  // of a unit square; the edges press less
  EXPECT_NEAR(motion.spread(1, 1), motion.spread(0, 0), 0.01);
  EXPECT_LT(motion.spread(2, 2), depth * depth);
  EXPECT_NEAR(motion.normal.z(), 1.0, 1e-12);
  EXPECT_NEAR(interaction.deepest(), depth, 0.02 * depth);
}

/// Of the patch where a ball presses into the one face below a block, both at a place; as wide as the disc that is cut.
Eigen::Matrix3d spread_of_a_small_patch(Type element, const Vector3& place, double width) {
  constexpr double radius = 0.2;
  Block block(element, {1, 1, 0.5}, {1, 1, 1}, [&](const Vector3& x) { return Vector3(x + place); });
  scene::Obstacle ball;
  ball.shape = scene::Obstacle::Shape::sphere;
  ball.radius = radius;
  ball.at = place + Vector3(0.3, 0.4, width * width / (2 * radius) - radius);
  const RigidShape shape = make_shape(ball);
  Interaction interaction(frictionless(), stiffness, step, block.side, shape);
  interaction.choose_candidates(block.cells(), {0}, 0.1);
  compute(interaction);
  return interaction.motion().spread;
}

TEST_P(Elements, APatchInALargeFaceIsSmallWhereverTheBodyIs) {
  constexpr double width = 0.05;
  const Eigen::Matrix3d here = spread_of_a_small_patch(GetParam(), {0, 0, 0}, width);
  const Eigen::Matrix3d far = spread_of_a_small_patch(GetParam(), {20, -30, 40}, width);
  EXPECT_LT((far - here).norm(), 1e-6 * here.norm());
  EXPECT_GT(here(0, 0), 0.5 * width * width / 4);  // of a disc
  EXPECT_LT(here(0, 0), 2 * width * width / 4);
}

TEST(Interaction, FrictionHoldsUpToItsLimitAndSlidesBelowIt) {
  scene::Contact contact;
  contact.friction = {0.5, 0.3};
  constexpr double depth = 1e-3;
  Block block(element::tet4, {1, 1, 0.5}, {2, 2, 1},
              [=](const Vector3& x) { return Vector3(x - Vector3(0, 0, depth)); });
  const RigidShape shape = make_shape(scene::Obstacle{});
  Interaction interaction(contact, stiffness, step, block.side, shape);
  interaction.choose_candidates(block.cells(), {0}, 0.1);
  compute(interaction);
  const double pressing = interaction.motion().force.z();
  double most = 0.0;
  double last = 0.0;
  constexpr double speed = 1e-4;  // m/s; the bond holds for half the depth
  for (int i = 0; i < 600000 && last > -0.6 * pressing; ++i) {
    for (Vector3& velocity : block.side.velocity) {
      velocity = {speed * 1000, 0, 0};
    }
    compute(interaction, BondUpdate::stretch);
    last = interaction.motion().force.x();
    most = std::min(most, last);
    if (i == 100) {
      EXPECT_NEAR(interaction.motion().slip.x(), speed * 1000, 1e-9);
    }
    if (i > 1000) {
      break;
    }
  }
  EXPECT_NEAR(most, -0.5 * pressing, 0.01 * pressing);
  EXPECT_NEAR(last, -0.3 * pressing, 0.001 * pressing);
}

/// A contact whose friction has memory.
scene::Contact with_memory() {
  scene::Contact contact;
  contact.friction.memory =
      friction::Law{.sticking = 0.8, .sliding = 0.3, .stiffness = 1e7, .damping = 5, .viscosity = 2};
  return contact;
}

/// Slips as a whole, sticks, turns round, and rubs as one bow under the whole load does, within a
/// share of the load. Returns what the bow stores, J.
double expect_the_friction_of_a_bow(Interaction& interaction, Side& side, const friction::Law& law, double share) {
  friction::ElastoPlasticFriction bow(law, step, friction::Deflection::end);
  double largest = 0.0;
  for (int i = 0; i < 600; ++i) {
    const double velocity = 0.1 * std::sin(0.02 * i) * std::exp(-0.002 * i);
    std::ranges::fill(side.velocity, Vector3(0, velocity, 0));
    compute(interaction, BondUpdate::stretch);
    const double load = interaction.motion().force.z();
    const double force = bow.force(velocity, load);
    bow.advance(velocity, load);
    EXPECT_NEAR(interaction.motion().force.y(), -force, share * load) << i;
    largest = std::max(largest, force / load);
  }
  EXPECT_GT(largest, 0.5);
  return bow.stored_energy();
}

TEST_P(Elements, FrictionWithMemoryRubsAsABowUnderTheWholeLoad) {
  const auto above = [](double depth) { return [=](const Vector3& x) { return Vector3(x - Vector3(0, 0, depth)); }; };
  const scene::Contact contact = with_memory();
  Block block(GetParam(), {1, 1, 0.5}, {2, 2, 1}, above(1e-3));
  const RigidShape shape = make_shape(scene::Obstacle{});
  Interaction on_floor(contact, stiffness, step, block.side, shape);
  on_floor.choose_candidates(block.cells(), {0}, 0.1);
  const double stored = expect_the_friction_of_a_bow(on_floor, block.side, *contact.friction.memory, 1e-9);
  const double with_bristles = on_floor.energy();
  std::ranges::fill(block.side.bond, Bond{});
  compute(on_floor);
  EXPECT_GT(stored, 1e-6);
  EXPECT_NEAR(with_bristles - on_floor.energy(), stored, 1e-9 * with_bristles);

  Block lower(GetParam(), {1, 1, 0.5}, {3, 3, 1}, above(0.5));
  Interaction of_two(contact, stiffness, step, block.side, lower.side);
  of_two.choose_candidates(block.cells(), lower.cells(), 0.1);
  (void)expect_the_friction_of_a_bow(of_two, block.side, *contact.friction.memory, 1e-3);  // edges are uneven
}

/// A block that lies on a floor, rocks from its left edge (y = 0) to its right one and back, and turns a little on it.
class RockingBlock {
 public:
  RockingBlock()
      : block_(element::tet4, {1, 1, 0.5}, {2, 4, 1}, [](const Vector3& x) { return x; }),
        shape_(make_shape(scene::Obstacle{})),
        interaction_(with_memory(), stiffness, step, block_.side, shape_) {
    interaction_.choose_candidates(block_.cells(), {0}, 0.1);
    lean(0);
  }

  /// Leans to the left (-1) or to the right (1), most by a hair: all of the block stays on the floor.
  void lean(double side) {
    for (std::size_t i = 0; i < block_.side.position.size(); ++i) {
      Vector3& x = block_.side.position[i];
      x = block_.mesh.nodes[block_.skin.nodes[i]];
      x.z() -= 1e-3 * (1 + 0.99 * side * (2 * x.y() - 1));
    }
  }

  /// Slips for some steps along x, at its left and at its right edge with these speeds (m/s).
  /// @return  the work of friction on the block, J
  double slip(double left, double right, int steps) {
    for (std::size_t i = 0; i < block_.side.position.size(); ++i) {
      block_.side.velocity[i] = Vector3(std::lerp(left, right, block_.side.position[i].y()), 0, 0);
    }
    double work = 0.0;
    for (int i = 0; i < steps; ++i) {
      compute(interaction_, BondUpdate::stretch);
      for (const Index node : block_.side.touched) {
        work += step * block_.side.force[node].dot(block_.side.velocity[node]);
      }
    }
    return work;
  }

  [[nodiscard]] const Interaction& interaction() const { return interaction_; }

 private:
  Block block_;
  RigidShape shape_;
  Interaction interaction_;
};

TEST(Interaction, RockingBlockGetsNoEnergyFromBristles) {
  RockingBlock block;
  double work = 0.0, largest = 0.0;
  for (int cycle = 0; cycle < 3; ++cycle) {
    // The right edge slips while it has little load, and slips back under the whole load.
    block.lean(-1);
    work += block.slip(0, 0.02, 20);
    block.lean(1);
    work += block.slip(0, 0, 1);
    EXPECT_LT(block.interaction().motion().force.x(), -0.5);
    work += block.slip(0, -0.02, 20);
    EXPECT_LT(work, 0) << cycle;
    largest = std::max(largest, -work);
  }
  EXPECT_GT(largest, 1e-6);
}

TEST(Interaction, RockingBlockDoesNotCreepOnItsBristles) {
  RockingBlock block;
  block.slip(0.02, 0.02, 20);
  const auto force_after_rocking = [&] {
    for (const double side : {-1.0, 1.0, 0.0}) {
      block.lean(side);
      block.slip(0, 0, 1);
    }
    return block.interaction().motion().force.x();
  };
  const double straight = block.interaction().motion().force.x(), first = force_after_rocking();
  EXPECT_LT(first, 0.3 * straight);
  for (int cycle = 0; cycle < 100; ++cycle) {
    EXPECT_NEAR(force_after_rocking(), first, 1e-12 * std::abs(first));
  }
}

TEST(Interaction, BristlesThatNoLongerTouchForgetWhatWas) {
  Block block(element::tet4, {1, 1, 0.5}, {2, 2, 1}, [](const Vector3& x) { return Vector3(x - Vector3(0, 0, 1e-3)); });
  const RigidShape shape = make_shape(scene::Obstacle{});
  Interaction interaction(with_memory(), stiffness, step, block.side, shape);
  interaction.choose_candidates(block.cells(), {0}, 0.1);
  std::ranges::fill(block.side.velocity, Vector3(1, 0, 0));
  compute(interaction, BondUpdate::stretch);
  std::ranges::fill(block.side.velocity, Vector3::Zero());
  compute(interaction, BondUpdate::stretch);
  EXPECT_LT(interaction.motion().force.x(), -1.0);
  const auto lift = [&](double height) {
    for (Vector3& x : block.side.position) {
      x.z() += height;
    }
    compute(interaction, BondUpdate::stretch);
  };
  lift(2e-3);
  EXPECT_EQ(interaction.motion().force, Vector3::Zero());
  lift(-2e-3);
  EXPECT_GT(interaction.motion().force.z(), 1.0);
  EXPECT_NEAR(interaction.motion().force.x(), 0.0, 1e-12);
}

}  // namespace
}  // namespace idiophone::contact
