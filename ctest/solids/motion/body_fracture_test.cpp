// Bars that break against exact waves in one dimension, and bodies that do not break against undivided ones.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "breakable.hpp"
#include "ranks.hpp"

namespace idiophone::motion {
namespace {

ON_RANKS(1);

// u = -(V/w) cos(pi x/L) sin(w t): the stress in the middle is density c V sin(w t).
TEST(BodyFracture, ABarThatIsPulledBreaksAtTheExactTimeAndStress) {
  constexpr double length = 0.2, fastest = 1e-3;
  const double rate = std::numbers::pi * bar_speed / length;
  const double strength = 0.5 * bar_density * bar_speed * fastest;
  const double expected = std::asin(0.5) / rate;
  const double momentum = bar_density * bar_area * fastest * std::cos(std::asin(0.5)) * length / std::numbers::pi;
  for (const element::Type element : all_elements) {
    SCOPED_TRACE(element::name(element));
    Laboratory lab = bar(length, length / 2, brittle(strength), element);
    lab.begin(bar_step);
    lab.put(rows_of(lab, [&](double x) {
      return std::array{0.0, -fastest * std::cos(std::numbers::pi * x / length)};
    }));
    const double before = energy_of(lab);
    EXPECT_NEAR(steps_until(lab, 0.01 * bar_area) * bar_step, expected, 0.011 * expected);
    EXPECT_LT(steps_until(lab, 0.99 * bar_area) * bar_step, 0.011 * expected);
    EXPECT_NEAR(broken_area(lab), bar_area, 1e-12 * bar_area);
    const double kept = momentum_beyond(lab, length / 2);
    EXPECT_NEAR(kept, momentum, 0.01 * momentum);
    lab.advance(1000);
    EXPECT_NEAR(momentum_beyond(lab, length / 2), kept, 1e-12 * momentum);
    EXPECT_NEAR(momentum_beyond(lab, -1.0), 0.0, 1e-12 * momentum);
    EXPECT_NEAR(energy_of(lab), before, 2e-3 * before);
  }
}

// A pulse of pressure s(x - c t) runs to the free end of the bar at L and comes back as tension: at L - d the stress is
// s(L - d - c t) - s(L + d - c t).
TEST(BodyFracture, APulseOfPressureSplitsOffAPieceAtTheFreeEnd) {
  constexpr double length = 0.4, begin = 0.05, width = 0.15, place = 0.32, pressure = 50;
  const auto pulse = [](double x) {
    return x < begin || x > begin + width ? 0.0
                                          : -pressure * std::pow(std::sin(std::numbers::pi * (x - begin) / width), 2);
  };
  const auto stress = [&](double time) {
    return pulse(place - bar_speed * time) - pulse(2 * length - place - bar_speed * time);
  };
  const double strength = 0.6 * pressure;
  double expected = 0.0, impulse = 0.0;  // Pa s
  for (; stress(expected) < strength; expected += 1e-7) {
    impulse -= 1e-7 * stress(expected);
  }
  Laboratory lab = bar(length, place, brittle(strength));
  lab.begin(bar_step);
  lab.put(rows_of(lab, [&](double x) {
    double strain = 0.0;
    constexpr int points = 2000;
    for (int i = 0; i < points; ++i) {
      strain += pulse(x * (i + 0.5) / points) / bar_young / points;
    }
    return std::array{x * strain, -pulse(x) / (bar_density * bar_speed)};
  }));
  const double before = energy_of(lab);
  const int steps = steps_until(lab, 0.01 * bar_area);
  EXPECT_NEAR(steps * bar_step, expected, 0.01 * expected);
  EXPECT_LT(steps_until(lab, 0.99 * bar_area) * bar_step, 0.01 * expected);
  const double kept = momentum_beyond(lab, place);
  EXPECT_NEAR(kept, bar_area * impulse, 0.02 * bar_area * impulse);
  lab.advance(2000);
  EXPECT_NEAR(momentum_beyond(lab, place), kept, 1e-12 * kept);
  EXPECT_NEAR(energy_of(lab), before, 2e-3 * before);
}

TEST(BodyFracture, PressureBreaksNothing) {
  constexpr double length = 0.2, fastest = 1e-3;
  Laboratory lab = bar(length, length / 2, brittle(0.1 * bar_density * bar_speed * fastest));
  lab.begin(bar_step);
  lab.put(rows_of(lab, [&](double x) { return std::array{0.0, fastest * std::cos(std::numbers::pi * x / length)}; }));
  lab.advance(1000);  // a quarter of a period is 632 steps
  EXPECT_EQ(broken_area(lab), 0.0);
}

/// Displacements by place after some steps of a block that spins, stretches and is held at its rim.
std::map<std::array<double, 3>, Vector3> motion_of(Laboratory& lab) {
  lab.fix("x0");
  lab.scene.bodies[0].spin = {10, -20, 30};
  lab.scene.bodies[0].velocity = {0.3, 0.2, 0.1};
  lab.scene.materials[0].damping.stiffness = 1e-6;
  lab.scene.materials[0].damping.mass = 5.0;
  lab.scene.gravity = {0, 0, -9.81};
  lab.begin(bar_step);
  lab.advance(400);
  std::map<std::array<double, 3>, Vector3> displacements;
  for (std::size_t node = 0; node < lab.mesh.nodes.size(); ++node) {
    const Vector3& place = lab.mesh.nodes[node];
    const auto [known, fresh] = displacements.try_emplace({place.x(), place.y(), place.z()}, lab.displacement(node));
    EXPECT_EQ(known->second, lab.displacement(node));  // nodes in one place move as one, to the bit
  }
  return displacements;
}

TEST(BodyFracture, AnUnbrokenBodyMovesAsAnUndividedOne) {
  for (const element::Type element : all_elements) {
    SCOPED_TRACE(element::name(element));
    const auto block = [&] { return support::block_mesh(element, {0.1, 0.06, 0.04}, {4, 2, 2}); };
    Laboratory whole = breakable(block(), {}, brittle(never));
    Laboratory divided = breakable(block(), {across_x(0.05), across_y(0.03)}, brittle(never));
    EXPECT_GT(divided.mesh.nodes.size(), whole.mesh.nodes.size());
    const auto expected = motion_of(whole);
    const auto found = motion_of(divided);
    ASSERT_EQ(found.size(), expected.size());
    double largest = 0.0;
    for (const auto& [place, displacement] : expected) {
      largest = std::max(largest, displacement.norm());
    }
    for (const auto& [place, displacement] : expected) {
      EXPECT_LT((found.at(place) - displacement).norm(), 1e-10 * largest);
    }
    const BodyMotion a = whole.observe();
    const BodyMotion b = divided.observe();
    EXPECT_NEAR(b.kinetic, a.kinetic, 1e-10 * a.kinetic);
    EXPECT_NEAR(b.elastic, a.elastic, 1e-10 * a.elastic);
  }
}

TEST(BodyFracture, ASavedStateGoesOnAcrossTheBreak) {
  constexpr double length = 0.2;
  const auto pulled = [] {
    Laboratory lab = bar(length, length / 2, brittle(0.01 * bar_young));
    lab.fix("x0");
    lab.push("x1", {0.6, 0, 0}, 2e-3);
    return lab;
  };
  constexpr int before = 600, after = 800;  // the pull reaches the middle after 632 steps
  Laboratory lab = pulled();
  lab.begin(bar_step);
  lab.advance(before);
  EXPECT_EQ(broken_area(lab), 0.0);
  lab.advance(after - before);
  EXPECT_NEAR(broken_area(lab), bar_area, 1e-12 * bar_area);
  for (const int steps : {before, after}) {
    Laboratory saved = pulled();
    expect_a_saved_state_to_go_on(saved, bar_step, steps);
    EXPECT_NEAR(broken_area(saved), bar_area, 1e-12 * bar_area);
  }
}

}  // namespace
}  // namespace idiophone::motion
