// Bars that break against exact waves in one dimension, and bodies that do not break against undivided ones.

#include "idiophone/solids/motion/body_fracture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>

#include "laboratory.hpp"
#include "ranks.hpp"

namespace idiophone::motion {
namespace {

constexpr double bar_young = 1e6, bar_density = 1000;  // Pa, kg/m3
const double bar_speed = std::sqrt(bar_young / bar_density);
constexpr double never = 1e15;  // Pa

using Inside = std::function<bool(const Vector3&)>;

Inside across_x(double place) {
  return [place](const Vector3& node) { return std::abs(node.x() - place) < 1e-9; };
}
Inside across_y(double place) {
  return [place](const Vector3& node) { return std::abs(node.y() - place) < 1e-9; };
}

/// @param strength  Pa
scene::FractureSurface brittle(double strength) {
  scene::FractureSurface law;
  law.strength = strength;
  return law;
}

/// A block of rubber that breaks along surfaces by one law.
Laboratory breakable(mesh::Mesh mesh, const std::vector<Inside>& surfaces, const scene::FractureSurface& law) {
  scene::Body body;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    const std::string name = "surface" + std::to_string(s);
    body.fracture.push_back(law);
    body.fracture.back().group = name;
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
      if (surfaces[s](mesh.nodes[node])) {
        mesh.groups[name].push_back(static_cast<Index>(node));
      }
    }
  }
  Laboratory lab(surfaces.empty() ? mesh : mesh::divide(mesh, body));
  lab.scene.bodies[0].fracture = body.fracture;
  lab.attachments.bodies[0].fracture = lab.mesh.fracture_faces;
  return lab;
}

constexpr double cell = 0.005;            // m, of a bar, as wide as one cell
constexpr double bar_area = cell * cell;  // m2
constexpr double bar_step = 5e-6;         // s: a third of the stable step

/// A bar along x without lateral contraction, so that its waves are those of one dimension.
Laboratory bar(double length, double break_at, const scene::FractureSurface& law) {
  const int cells = static_cast<int>(std::lround(length / cell));
  Laboratory lab =
      breakable(support::block_mesh(element::tet10, {length, cell, cell}, {cells, 1, 1}), {across_x(break_at)}, law);
  lab.scene.materials[0].poisson = 0.0;
  return lab;
}

/// Displacement, m, and velocity, m/s, along x at a place.
using Wave = std::function<std::array<double, 2>(double)>;

std::vector<double> rows_of(const Laboratory& lab, const Wave& wave) {
  std::vector<double> rows;
  for (const Vector3& node : lab.mesh.nodes) {
    const auto [u, v] = wave(node.x());
    rows.insert(rows.end(), {u, 0, 0, v, 0, 0});
  }
  return rows;
}

double broken_area(const Laboratory& lab) {
  return lab.motion->dynamics().fractures()[0].broken_area();
}

/// [nodes] Whether they belong to elements beyond a place.
std::vector<char> nodes_beyond(const Laboratory& lab, double place) {
  std::vector<char> beyond(lab.mesh.nodes.size());
  for (Index element = 0; element < lab.mesh.element_count(); ++element) {
    double middle = 0.0;
    for (const Index node : lab.mesh.element_nodes(element)) {
      middle += lab.mesh.nodes[node].x() / 10;
    }
    for (const Index node : lab.mesh.element_nodes(element)) {
      beyond[node] = middle > place ? 1 : beyond[node];
    }
  }
  return beyond;
}

/// Of these nodes, along x, kg m/s.
double momentum_beyond(const Laboratory& lab, double place) {
  const std::vector<char> beyond = nodes_beyond(lab, place);
  const auto masses = lab.motion->dynamics().model(0).masses();
  double sum = 0.0;
  for (std::size_t node = 0; node < beyond.size(); ++node) {
    sum += beyond[node] != 0 ? masses[node] * lab.motion->state()[node].velocity[0] : 0.0;
  }
  return sum;
}

/// Steps until a part of the area is broken.
int steps_until(const Laboratory& lab, double broken) {
  int steps = 0;
  while (broken_area(lab) < broken && steps < 10000) {
    lab.advance(1);
    ++steps;
  }
  return steps;
}

double energy_of(const Laboratory& lab) {
  const BodyMotion motion = lab.observe();
  return motion.kinetic + motion.elastic;
}

ON_RANKS(1);

// u = -(V/w) cos(pi x/L) sin(w t): the stress in the middle is density c V sin(w t).
TEST(BodyFracture, ABarThatIsPulledBreaksAtTheExactTimeAndStress) {
  constexpr double length = 0.2, fastest = 1e-3;
  const double rate = std::numbers::pi * bar_speed / length;
  const double strength = 0.5 * bar_density * bar_speed * fastest;
  Laboratory lab = bar(length, length / 2, brittle(strength));
  lab.begin(bar_step);
  lab.put(rows_of(lab, [&](double x) { return std::array{0.0, -fastest * std::cos(std::numbers::pi * x / length)}; }));
  const double before = energy_of(lab);
  const double expected = std::asin(0.5) / rate;
  EXPECT_NEAR(steps_until(lab, 0.01 * bar_area) * bar_step, expected, 0.01 * expected);
  EXPECT_LT(steps_until(lab, 0.99 * bar_area) * bar_step, 0.01 * expected);
  EXPECT_NEAR(broken_area(lab), bar_area, 1e-12 * bar_area);
  const double momentum = bar_density * bar_area * fastest * std::cos(std::asin(0.5)) * length / std::numbers::pi;
  const double kept = momentum_beyond(lab, length / 2);
  EXPECT_NEAR(kept, momentum, 0.01 * momentum);
  lab.advance(2000);
  EXPECT_NEAR(momentum_beyond(lab, length / 2), kept, 1e-12 * momentum);
  EXPECT_NEAR(momentum_beyond(lab, -1.0), 0.0, 1e-12 * momentum);
  EXPECT_NEAR(energy_of(lab), before, 2e-3 * before);
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
  const auto block = [] { return support::block_mesh(element::tet10, {0.1, 0.06, 0.04}, {4, 2, 2}); };
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

TEST(BodyFracture, CrossingSurfacesBreakIntoFourPieces) {
  Laboratory lab = breakable(support::block_mesh(element::tet10, {0.08, 0.08, 0.02}, {4, 4, 1}),
                             {across_x(0.04), across_y(0.04)}, brittle(10.0));
  lab.begin(bar_step);
  std::vector<double> rows;
  for (const Vector3& node : lab.mesh.nodes) {
    const Vector3 velocity = Vector3(0.1, 0.1, 0).cwiseProduct(node - Vector3(0.04, 0.04, 0)) / 0.04;
    rows.insert(rows.end(), {0, 0, 0, velocity.x(), velocity.y(), 0});
  }
  lab.put(rows);
  lab.advance(1000);
  EXPECT_NEAR(broken_area(lab), 2 * 0.08 * 0.02, 1e-12);
  for (const mesh::FractureFace& face : lab.mesh.fracture_faces) {
    for (std::size_t k = 0; k < 6; ++k) {
      EXPECT_GT((lab.displacement(face.nodes[0].at(k)) - lab.displacement(face.nodes[1].at(k))).norm(), 1e-4);
    }
  }
}

double taken_energy(const Laboratory& lab) {
  return lab.motion->dynamics().fractures()[0].taken_energy();
}

TEST(BodyFracture, BreakingTakesItsEnergyFromTheMotion) {
  constexpr double length = 0.2, fastest = 1e-3;
  scene::FractureSurface law = brittle(0.5 * bar_density * bar_speed * fastest);
  law.energy = 0.1 * 0.25 * bar_density * fastest * fastest * length;  // J/m2: a tenth of the energy of the vibration
  Laboratory lab = bar(length, length / 2, law);
  lab.begin(bar_step);
  lab.put(rows_of(lab, [&](double x) { return std::array{0.0, -fastest * std::cos(std::numbers::pi * x / length)}; }));
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

TEST(BodyFracture, CohesionThatIsNotSpentPullsThePiecesBack) {
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
TEST(BodyFracture, ShearBreaksFacesWhoseShearStrengthItPasses) {
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
TEST(BodyFracture, PiecesThatMeetAgainPushEachOtherBack) {
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
