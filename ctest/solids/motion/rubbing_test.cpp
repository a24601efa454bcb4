// Bodies that rub on each other with friction that has memory, against exact motions of one mass.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "heard_sound.hpp"
#include "laboratory.hpp"
#include "ranks.hpp"

namespace idiophone::motion {

namespace {

constexpr double step_of_rubbing = 1e-5;   // s
constexpr double gravity_of_rubbing = 10;  // m/s2
constexpr double layer = 3e7;              // Pa/m, stiffness of the contact
const Vector3 brick(0.1, 0.1, 0.01);       // m; 1 kg

mesh::Mesh brick_mesh() {
  return support::block_mesh(element::tet4, brick, {1, 1, 1});
}

friction::Law law_of_rubbing() {
  return {.sticking = 0.5, .sliding = 0.2, .stribeck_speed = 0.4, .stiffness = 1e5, .damping = 600.0};
}

/// A brick on a floor that is inclined along x.
/// @param slope     its tangent
/// @param velocity  at the beginning, along x, m/s
Laboratory sliding_brick(double slope, double velocity) {
  Laboratory lab(brick_mesh());
  lab.scene.materials = {{"stone", 1e8, 0.3, 1.0 / brick.prod(), {0, 0}, {}}};
  const double angle = std::atan(slope);
  lab.scene.gravity = gravity_of_rubbing * Vector3(std::sin(angle), 0, -std::cos(angle));
  lab.scene.obstacles.resize(1);
  scene::Contact contact;
  contact.obstacle = 0;
  contact.damping = 1e-3;
  contact.friction.memory = law_of_rubbing();
  lab.scene.contacts = {contact};
  lab.contact_surfaces = contact::find_contact_surfaces(lab.scene, {lab.mesh});
  lab.contact_surfaces.stiffness = {layer};
  lab.begin(step_of_rubbing);
  std::vector<double> rows;
  for (std::size_t node = 0; node < lab.mesh.nodes.size(); ++node) {
    rows.insert(rows.end(),
                {0, 0, -gravity_of_rubbing * std::cos(angle) / (layer * brick.x() * brick.y()), velocity, 0, 0});
  }
  lab.put(rows);
  return lab;
}

double coefficient_at(double speed) {
  const friction::Law law = law_of_rubbing();
  return law.sliding + (law.sticking - law.sliding) * std::exp(-std::pow(speed / law.stribeck_speed, 2));
}

}  // namespace

ON_RANKS(1);

TEST(Rubbing, BristlesHoldUpToTheirLargestForce) {
  const auto speed_on = [](double slope) {
    Laboratory lab = sliding_brick(slope, 0.0);
    lab.advance(30000);
    return lab.observe().velocity.x();
  };
  EXPECT_LT(std::abs(speed_on(0.49)), 1e-4);
  EXPECT_GT(speed_on(0.51), 1e-2);
}

TEST(Rubbing, AccelerationFollowsTheStribeckCurve) {
  const double angle = std::atan(0.8);
  Laboratory lab = sliding_brick(0.8, 0.1);
  lab.advance(4000);
  double before = lab.observe().velocity.x();
  for (int i = 0; i < 20; ++i) {
    constexpr int steps = 500;
    lab.advance(steps);
    const double now = lab.observe().velocity.x();
    const double expected = std::sin(angle) - coefficient_at((before + now) / 2) * std::cos(angle);
    EXPECT_NEAR((now - before) / (steps * step_of_rubbing) / (gravity_of_rubbing * expected), 1.0, 5e-3) << now;
    before = now;
  }
  EXPECT_GT(before, 0.45);
}

TEST(Rubbing, SlidesToRestOnTheWayThatTheCurveLeavesAndOnlyLosesEnergy) {
  constexpr double speed = 0.6;  // m/s
  Laboratory lab = sliding_brick(0.0, speed);
  double way = 0.0;  // integral v dv/(g coefficient)
  for (double v = speed / 2000; v < speed; v += speed / 1000) {
    way += speed / 1000 * v / (gravity_of_rubbing * coefficient_at(v));
  }
  const auto energy = [&] {
    const BodyMotion now = lab.observe();
    return now.kinetic + now.elastic + gravity_of_rubbing * now.centre.z() + lab.motion->contacts().energy(0);
  };
  const double start = lab.observe().centre.x();
  double last = energy();
  for (int i = 0; i < 600; ++i) {
    lab.advance(50);
    const double now = energy();
    ASSERT_LT(now, last + 1e-6) << i;  // of 0.18 J
    last = now;
  }
  EXPECT_LT(std::abs(lab.observe().velocity.x()), 1e-4);
  EXPECT_NEAR((lab.observe().centre.x() - start) / way, 1.0, 5e-3);
}

namespace {

constexpr double speed_of_plate = 0.02, decay = 2.0, hung_at = 160.0;  // m/s, 1/s, Hz

/// The brick hangs on springs, moves along x alone, and something rubs it.
struct HungBrick {
  explicit HungBrick(mesh::Mesh mesh) : nodes(static_cast<Index>(mesh.nodes.size())) {
    meshes.push_back(std::move(mesh));
  }

  void hang() {
    const double rate = 2.0 * std::numbers::pi * hung_at;
    scene.materials = {{"stone", 1e9, 0.3, 1.0 / brick.prod(), {0, 0}, {}}};
    scene.bodies.resize(meshes.size());
    attachments.bodies.resize(meshes.size());
    for (scene::Body& body : scene.bodies) {
      body.element = element::tet4;
    }
    scene.bodies[0].supports.push_back({"spring", {}, rate * rate, 2.0 * decay});
    attachments.bodies[0].supports.push_back(evenly_over_the_brick());
    let_move_along_x(0, {evenly_over_the_brick().nodes, {}});
  }

  void let_move_along_x(std::size_t body, const mesh::Patch& all) {
    scene.bodies[body].fixed.push_back({.group = "all", .axes = {false, true, true}, .hinge = false, .where = {}});
    attachments.bodies[body].fixed.push_back(all);
  }

  [[nodiscard]] mesh::Patch evenly_over_the_brick() const {
    mesh::Patch patch;
    for (Index node = 0; node < nodes; ++node) {
      patch.nodes.push_back(node);
    }
    patch.shares.assign(patch.nodes.size(), 1.0 / static_cast<double>(nodes));
    return patch;
  }

  /// Mean velocity of the brick along x from 0.4 s to 0.8 s, 2000 in a second, m/s.
  /// @param rows  displacements and velocities at the beginning: [6 x nodes]
  /// @param load  mean force of the contact along z in this time, N
  std::vector<double> velocity(const std::vector<double>& rows, double& load) {
    const mesh::Part part = mesh::distribute(meshes, MPI_COMM_SELF);
    Motion motion(scene, part, attachments, surfaces, step_of_rubbing, 16, MPI_COMM_SELF);
    motion.start(std::vector(meshes.size(), Vector3(Vector3::Zero())), {});
    support::MemoryArchive archive(MPI_COMM_SELF);
    motion.archive(archive, 0);
    archive.blocks.at("motion/nodes") = rows;
    archive.restore();
    motion.archive(archive, 0);
    std::vector<double> found;
    load = 0.0;
    for (int sample = 1; sample <= 1600; ++sample) {
      motion.advance_to(50 * sample);
      if (sample > 800) {
        double sum = 0.0;
        for (Index node = 0; node < nodes; ++node) {
          sum += motion.state()[node].velocity[0] / static_cast<double>(nodes);
        }
        found.push_back(sum);
        load += motion.contacts().count() > 0 ? motion.contacts().now(0).force.z() / 800 : 0.0;
      }
    }
    return found;
  }

  std::vector<mesh::Mesh> meshes;
  Index nodes;
  scene::Scene scene;
  Attachments attachments;
  contact::ContactSurfaces surfaces;
};

/// A heavy plate slides below it.
std::vector<double> rubbed_by_a_plate(const friction::Law& law, double& load) {
  constexpr double depth = 5e-5;  // m
  HungBrick lab(brick_mesh());
  mesh::Mesh plate = support::block_mesh(element::tet4, {0.4, 0.2, 0.02}, {1, 1, 1});
  for (Vector3& node : plate.nodes) {
    node -= Vector3(0.2, 0.05, 0.02 - depth);
  }
  lab.meshes.push_back(plate);
  lab.hang();
  lab.scene.materials.push_back({"lead", 1e12, 0.3, 1e6, {0, 0}, {}});
  lab.scene.bodies[1].material = 1;
  mesh::Patch all;
  std::vector<double> rows(6 * static_cast<std::size_t>(lab.nodes), 0.0);
  for (Index node = 0; node < static_cast<Index>(plate.nodes.size()); ++node) {
    all.nodes.push_back(lab.nodes + node);
    rows.insert(rows.end(), {0, 0, 0, speed_of_plate, 0, 0});
  }
  lab.let_move_along_x(1, all);
  scene::Contact contact;
  contact.body = 0;
  contact.other = 1;
  contact.friction.memory = law;
  lab.scene.contacts = {contact};
  lab.surfaces = contact::find_contact_surfaces(lab.scene, lab.meshes);
  lab.surfaces.stiffness = {layer};
  return lab.velocity(rows, load);
}

std::vector<double> rubbed_by_a_bow(const friction::Law& law, double load) {
  HungBrick lab(brick_mesh());
  lab.hang();
  scene::Bow bow;
  bow.direction = Vector3::UnitX();
  bow.speed = {.points = {{.time = 0.0, .value = speed_of_plate}}};
  bow.load = {.points = {{.time = 0.0, .value = load}}};
  bow.duration = 100.0;
  bow.friction = law;
  lab.scene.bows.push_back(bow);
  lab.attachments.bows.push_back(lab.evenly_over_the_brick());
  double none = 0.0;
  return lab.velocity(std::vector<double>(6 * static_cast<std::size_t>(lab.nodes), 0.0), none);
}

}  // namespace

TEST(Rubbing, ABodyThatSlidesAlongAnotherOneIsABow) {
  friction::Law law = law_of_rubbing();
  law.stribeck_speed = speed_of_plate;
  law.stiffness = 1e6;
  law.damping = 5.0;
  double load = 0.0;
  const std::vector<double> by_plate = rubbed_by_a_plate(law, load);
  const std::vector<double> by_bow = rubbed_by_a_bow(law, load);
  const auto pitch = [](const std::vector<double>& velocity) { return support::pitch(velocity, 140.0, 180.0, 2000.0); };
  const double level = support::root_mean_square(by_plate);
  EXPECT_GT(load, 1.0);
  EXPECT_GT(level, 0.3 * speed_of_plate);  // it sings
  EXPECT_LT(std::abs(20.0 * std::log10(level / support::root_mean_square(by_bow))), 1.0);
  EXPECT_LT(std::abs(1200.0 * std::log2(pitch(by_plate) / pitch(by_bow))), 3.0);
  std::printf("load %.3f N, %.3f and %.3f Hz, %.3f dB apart\n", load, pitch(by_plate), pitch(by_bow),
              20.0 * std::log10(level / support::root_mean_square(by_bow)));
}

}  // namespace idiophone::motion
