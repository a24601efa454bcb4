// A bow on rigid blocks against exact motions of one mass.

#include "idiophone/solids/motion/bow_load.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "laboratory.hpp"
#include "ranks.hpp"

namespace idiophone::motion {

namespace {

constexpr double block_mass = 1.0;         // kg, of the block
constexpr double step_of_block = 2e-5;     // s
const Vector3 block_edges(0.1, 0.1, 0.1);  // m

mesh::Patch even_patch(const std::vector<Index>& nodes) {
  return {nodes, std::vector(nodes.size(), 1.0 / static_cast<double>(nodes.size()))};
}

/// Pulls a stiff block of 1 kg along x.
Laboratory bowed_block(const scene::Bow& bow) {
  Laboratory lab(support::block_mesh(element::tet4, block_edges, {1, 1, 1}));
  lab.scene.materials = {{"stone", 1e9, 0.3, block_mass / block_edges.prod(), {0, 0}, {}}};
  lab.scene.bows.push_back(bow);
  lab.attachments.bows.push_back(even_patch(lab.mesh.groups.at("x1")));
  return lab;
}

scene::Bow bow_along_x(const scene::Course& speed, const scene::Course& load) {
  scene::Bow bow;
  bow.direction = Vector3::UnitX();
  bow.speed = speed;
  bow.load = load;
  bow.duration = 100.0;
  return bow;
}

scene::Course always_at(double value) {
  return {.points = {{.time = 0.0, .value = value}}};
}

}  // namespace

ON_RANKS(1, 3);

TEST(BowLoad, GivesTheSameBitsOnAnyNumberOfRanks) {
  const mesh::Mesh block = support::block_mesh(element::tet4, {0.4, 0.1, 0.1}, {8, 2, 2});
  scene::Scene scene;
  scene.materials = {{"stone", 1e9, 0.3, 1000, {0, 0}, {}}};
  scene.bodies.resize(1);
  scene.bodies[0].element = block.element;
  scene.bows.push_back(bow_along_x(always_at(0.1), always_at(5.0)));
  scene.bows[0].direction = Vector3(0.6, 0.0, 0.8);
  Attachments attachments;
  attachments.bodies.resize(1);
  attachments.bows.push_back(even_patch(block.groups.at("rim")));  // on all ranks
  const contact::ContactSurfaces no_surfaces;
  const auto final_state = [&](const mesh::Part& part, MPI_Comm communicator) {
    Motion motion(scene, part, attachments, no_surfaces, step_of_block, 16, communicator);
    motion.start({Vector3::Zero()}, {});
    motion.advance_to(600);
    return motion.state();
  };
  const mesh::Part part = mesh::distribute({block}, MPI_COMM_WORLD, coupled_nodes(attachments));
  const std::vector<NodeState> together = final_state(part, MPI_COMM_WORLD);
  const std::vector<NodeState> alone = final_state(support::whole_part(block), MPI_COMM_SELF);
  EXPECT_GT(std::abs(alone[0].velocity[2]), 1e-3);
  for (Index node = 0; node < part.owned_nodes; ++node) {
    for (int i = 0; i < 3; ++i) {
      ASSERT_EQ(together[node].velocity[i], alone[part.node_ids[node]].velocity[i]) << node;
      ASSERT_EQ(together[node].displacement[i], alone[part.node_ids[node]].displacement[i]) << node;
    }
  }
}

ON_RANKS(1);

TEST(BowLoad, ThatSticksPullsLikeASpring) {
  constexpr double begin = 0.02, ramp = 0.01, speed = 0.01, rate = 100.0;  // s, s, m/s, rad/s
  scene::Bow bow = bow_along_x({.points = {{begin, 0.0}, {begin + ramp, speed}}}, always_at(100.0));
  bow.friction.stiffness = block_mass * rate * rate;
  Laboratory lab = bowed_block(bow);
  lab.begin(step_of_block);
  // Velocity of the mass if that of the end of the spring grows evenly from a time on: by Duhamel's integral.
  const auto after = [&](double time) {
    return time < 0.0 ? 0.0 : speed / ramp * (time - std::sin(rate * time) / rate);
  };
  for (int i = 0; i < 20; ++i) {
    lab.advance(250);
    const double time = lab.motion->time();
    EXPECT_NEAR(lab.observe().velocity.x(), after(time - begin) - after(time - begin - ramp), 3e-3 * speed) << time;
  }
}

TEST(BowLoad, ThatSlidesPullsWithItsLoadTimesTheCoefficient) {
  constexpr double start = 0.01, duration = 0.04, ramp = 0.01;  // s
  scene::Bow bow = bow_along_x(always_at(2.0), always_at(3.0));
  bow.start = start;
  bow.duration = duration;
  bow.friction.sliding = 0.25;
  Laboratory lab = bowed_block(bow);
  lab.begin(step_of_block);
  lab.advance(static_cast<int>(std::lround((start + duration + 0.005) / step_of_block)));
  const BodyMotion end = lab.observe();
  EXPECT_NEAR(block_mass * end.velocity.x() / (3.0 * 0.25 * (duration - ramp)), 1.0, 2e-3);
  EXPECT_NEAR(lab.motion->work().value() / (end.kinetic + end.elastic), 1.0, 1e-3);
}

TEST(BowLoad, StartsAVibrationWhereTheForceFallsFasterThanTheBodyLoses) {
  // The block hangs on a spring with a dashpot; linear theory: 2 decay + slope load/mass = 0.
  constexpr double frequency = 40.0, decay = 20.0, speed = 0.1, ramp = 0.3;  // Hz, 1/s, m/s, s
  constexpr double slope = -2.0 / 0.1 * (0.8 - 0.3) / std::numbers::e;  // of the coefficient at stribeck_speed, s/m
  constexpr double limit = -2.0 * decay * block_mass / slope;           // N
  const auto growth_at = [&](double load) {
    scene::Bow bow = bow_along_x(always_at(speed), {.points = {{0.0, 0.0}, {ramp, load}}});
    bow.friction = {.sticking = 0.8, .sliding = 0.3, .stribeck_speed = speed, .stiffness = 1e6};
    Laboratory lab = bowed_block(bow);
    const double rate = 2.0 * std::numbers::pi * frequency;
    lab.scene.bodies[0].supports.push_back({});
    lab.scene.bodies[0].supports[0].stiffness = block_mass * rate * rate;
    lab.scene.bodies[0].supports[0].damping = 2.0 * decay * block_mass;
    lab.attachments.bodies[0].supports.push_back(even_patch(lab.mesh.groups.at("x0")));
    lab.begin(step_of_block);
    const auto power_until = [&](double end) {
      double sum = 0.0;
      while (lab.motion->time() < end) {
        lab.advance(10);
        const double velocity = lab.motion->state()[0].velocity[0];
        sum += velocity * velocity;
      }
      return sum;
    };
    constexpr double length = 8.0 / frequency;
    power_until(ramp + 0.05);
    const double first = power_until(ramp + 0.05 + length), second = power_until(ramp + 0.05 + 2.0 * length);
    return 0.5 * std::log(second / first) / length;
  };
  const double below = growth_at(0.9 * limit), above = growth_at(1.1 * limit);
  EXPECT_NEAR(0.9 + 0.2 * below / (below - above), 1.0, 0.02);
}

TEST(BowLoad, ASavedStateGoesOn) {
  Laboratory lab = bowed_block(bow_along_x(always_at(0.1), always_at(5.0)));
  expect_a_saved_state_to_go_on(lab, step_of_block, 700);
}

}  // namespace idiophone::motion
