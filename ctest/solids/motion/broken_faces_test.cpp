// What acts between the sides of broken faces, and shear that breaks them.

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "breakable.hpp"
#include "ranks.hpp"

namespace idiophone::motion {
namespace {

ON_RANKS(1);

double taken_energy(const Laboratory& lab) {
  return lab.motion->dynamics().fractures()[0].taken_energy();
}

TEST(BrokenFaces, BreakingTakesItsEnergyFromTheMotion) {
  constexpr double length = 0.2, fastest = 1e-3;
  scene::FractureSurface law = brittle(0.5 * bar_density * bar_speed * fastest);
  law.energy = 0.1 * 0.25 * bar_density * fastest * fastest * length;  // J/m2: a tenth of the energy of the vibration
  for (const element::Type element : all_elements) {
    SCOPED_TRACE(element::name(element));
    Laboratory lab = bar(length, length / 2, law, element);
    lab.begin(bar_step);
    lab.put(rows_of(lab, [&](double x) {
      return std::array{0.0, -fastest * std::cos(std::numbers::pi * x / length)};
    }));
    const double before = energy_of(lab);
    steps_until(lab, 0.99 * bar_area);
    EXPECT_GT(broken_area(lab), 0.99 * bar_area);
    EXPECT_LT(taken_energy(lab), 0.1 * law.energy * bar_area);
    for (int part = 0; part < 20; ++part) {
      lab.advance(10);
      EXPECT_NEAR(energy_of(lab) + taken_energy(lab), before, 4e-3 * before);
    }
    EXPECT_GT(taken_energy(lab), 0.3 * law.energy * bar_area);
    lab.advance(2000);
    EXPECT_NEAR(taken_energy(lab), law.energy * bar_area, 1e-9 * law.energy * bar_area);
    EXPECT_NEAR(before - energy_of(lab), law.energy * bar_area, 0.04 * law.energy * bar_area);
  }
}

TEST(BrokenFaces, CohesionThatIsNotSpentPullsThePiecesBack) {
  constexpr double length = 0.2, fastest = 1e-3;
  scene::FractureSurface law = brittle(0.5 * bar_density * bar_speed * fastest);
  law.energy = 10.0 * 0.25 * bar_density * fastest * fastest * length;  // more than there is
  Laboratory lab = bar(length, length / 2, law);
  lab.begin(bar_step);
  lab.put(rows_of(lab, [&](double x) { return std::array{0.0, -fastest * std::cos(std::numbers::pi * x / length)}; }));
  const double before = energy_of(lab);
  lab.advance(2000);
  EXPECT_NEAR(broken_area(lab), bar_area, 1e-12);
  EXPECT_LT(momentum_beyond(lab, length / 2), 0.5 * bar_density * bar_area * fastest * length / std::numbers::pi);
  EXPECT_NEAR(energy_of(lab) + taken_energy(lab), before, 4e-3 * before);
  Laboratory saved = bar(length, length / 2, law);
  saved.fix("x0");
  saved.push("x1", {2e-3, 0, 0}, 2e-3);
  expect_a_saved_state_to_go_on(saved, bar_step, 900);
}

// Simple shear of 1e-3 makes a shear stress of 500 Pa in a block without lateral contraction.
TEST(BrokenFaces, ShearBreaksFacesWhoseShearStrengthItPasses) {
  const auto broken_by_shear = [](double shear_strength) {
    scene::FractureSurface law = brittle(1e3);
    law.shear_strength = shear_strength;
    Laboratory lab =
        breakable(support::block_mesh(element::tet10, {0.04, 0.04, 0.04}, {4, 4, 4}), {across_x(0.02)}, law);
    lab.scene.materials[0].poisson = 0.0;
    lab.begin(bar_step);
    std::vector<double> rows;
    for (const Vector3& node : lab.mesh.nodes) {
      rows.insert(rows.end(), {0, 1e-3 * node.x(), 0, 0, 0, 0});
    }
    lab.put(rows);
    lab.advance(2);
    return broken_area(lab);
  };
  EXPECT_GT(broken_by_shear(490), 0.9 * 0.04 * 0.04);
  EXPECT_EQ(broken_by_shear(600), 0.0);
  EXPECT_EQ(broken_by_shear(std::numeric_limits<double>::infinity()), 0.0);
}

// Both halves of a broken bar meet with the velocities V and -V. Waves turn them back after 2 (L/2)/c.
TEST(BrokenFaces, PiecesThatMeetAgainPushEachOtherBack) {
  constexpr double length = 0.2, fastest = 1e-3, gap = 1e-6;
  const double momentum = bar_density * bar_area * length / 2 * fastest;
  for (const bool contact : {true, false}) {
    scene::FractureSurface law = brittle(1.0);
    law.contact = contact;
    Laboratory lab = bar(length, length / 2, law);
    lab.begin(bar_step);
    lab.put(rows_of(lab, [&](double x) { return std::array{0.0, fastest * (x - length / 2)}; }));
    steps_until(lab, 0.99 * bar_area);
    std::vector<double> rows;
    for (const char is_right : nodes_beyond(lab, length / 2)) {
      rows.insert(rows.end(), {is_right != 0 ? gap : 0.0, 0, 0, is_right != 0 ? -fastest : fastest, 0, 0});
    }
    lab.put(rows);
    const double duration = gap / (2 * fastest) + length / bar_speed;
    lab.advance(static_cast<int>(0.5 * duration / bar_step));
    EXPECT_NEAR(momentum_beyond(lab, length / 2), contact ? 0.0 : -momentum, 0.1 * momentum);
    lab.advance(static_cast<int>(1.0 * duration / bar_step));
    EXPECT_NEAR(momentum_beyond(lab, length / 2), contact ? momentum : -momentum, 0.05 * momentum);
    EXPECT_NEAR(momentum_beyond(lab, -1.0), 0.0, 1e-10 * momentum);
  }
}

}  // namespace
}  // namespace idiophone::motion
