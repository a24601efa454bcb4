// Groups that turn, hinges, and bodies held whole.

#include "idiophone/solids/motion/constraints.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "idiophone/solids/motion/stable_step.hpp"
#include "laboratory.hpp"
#include "ranks.hpp"

namespace idiophone::motion {
namespace {

using std::numbers::pi;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr double block_step = 5e-5;  // well inside the stable one, as in motion_test.cpp

Laboratory block() {
  Laboratory lab(support::block_mesh(element::tet10, {0.2, 0.1, 0.05}, {4, 2, 1}));
  auto& body = lab.mesh.groups["body"];
  body.resize(lab.mesh.nodes.size());
  std::iota(body.begin(), body.end(), 0);
  return lab;
}

scene::Signal sine(double frequency) {
  return {scene::Signal::Shape::sine, 0.0, std::numeric_limits<double>::infinity(), frequency, {}};
}

/// Turns a group about the y axis through (0.1, 0, 0.2) by up to `angle` (rad), and shifts it along y by up to 1 mm.
void drive(Laboratory& lab, const std::string& group, double angle, const scene::Signal& signal) {
  scene::DrivenGroup driven;
  driven.group = group;
  driven.rotation = {0, angle, 0};
  driven.pivot = {0.1, 0, 0.2};
  driven.displacement = {0, 1e-3, 0};
  driven.signal = signal;
  lab.scene.bodies[0].driven.push_back(driven);
  lab.attachments.bodies[0].driven.push_back({lab.mesh.groups.at(group), {}});
}

double energy(const Laboratory& lab) {
  const BodyMotion body = lab.observe();
  return body.kinetic + body.elastic;
}

ON_RANKS(1);

TEST(DrivenRotation, MovesEachNodeOnItsCircle) {
  Laboratory lab = block();
  drive(lab, "x1", 2.0, sine(100));
  lab.begin(block_step);
  for (int i = 0; i < 5; ++i) {
    lab.advance(7);
    const double s = std::sin(2 * pi * 100 * lab.motion->time());
    for (const Index node : lab.mesh.groups.at("x1")) {
      const Vector3 start = lab.mesh.nodes[node];
      const Vector3 now = start + lab.displacement(static_cast<std::size_t>(node));
      const double radius = std::hypot(start.x() - 0.1, start.z() - 0.2);
      const double angle = std::atan2(start.x() - 0.1, start.z() - 0.2) + 2.0 * s;  // from z to x, right-handed about y
      EXPECT_NEAR(now.x(), 0.1 + radius * std::sin(angle), 1e-15);
      EXPECT_NEAR(now.y(), start.y() + 1e-3 * s, 1e-15);
      EXPECT_NEAR(now.z(), 0.2 + radius * std::cos(angle), 1e-15);
    }
  }
}

TEST(DrivenRotation, PutsIntoTheBodyWhatItHolds) {
  Laboratory lab = block();
  lab.fix("x0");
  drive(lab, "x1", 0.01, sine(50));
  lab.begin(block_step / 10);  // the sum of the work is of first order in the step
  lab.advance(770);
  EXPECT_NEAR(lab.motion->work().value() / energy(lab), 1.0, 0.02);
}

TEST(DrivenRotation, GoesOnFromASavedStateToTheBit) {
  Laboratory lab = block();
  drive(lab, "x1", 0.5, sine(100));
  expect_a_saved_state_to_go_on(lab, block_step, 30);
}

TEST(HeldBody, StandsStillAndLimitsNoStep) {
  Laboratory lab = block();
  lab.scene.gravity = {0, 0, -9.81};
  lab.fix("body");
  lab.push("x1", {0, 3, 10}, 5e-3);
  lab.begin(1.0);
  lab.advance(10);
  EXPECT_EQ(energy(lab), 0.0);
  EXPECT_EQ(lab.motion->work().value(), 0.0);
  const StableStep limit = find_stable_steps(lab.part, lab.motion->dynamics())[0];
  EXPECT_FALSE(limit.is_limited());
  EXPECT_THROW((void)choose_steps_per_sample(lab.scene.time, lab.scene.audio, limit.step, limit.highest_loss),
               std::runtime_error);
  lab.scene.time.steps_per_sample = 3;
  EXPECT_EQ(choose_steps_per_sample(lab.scene.time, lab.scene.audio, limit.step, limit.highest_loss), 3);
}

TEST(HeldBody, TurnsAsAWholeWithTheEnergyOfARigidBody) {
  Laboratory lab = block();
  constexpr double angle = 0.3;
  constexpr double frequency = 20;
  drive(lab, "body", angle, sine(frequency));
  lab.scene.bodies[0].driven[0].displacement.setZero();
  lab.begin(block_step);
  EXPECT_FALSE(find_stable_steps(lab.part, lab.motion->dynamics())[0].is_limited());
  lab.advance(40);
  double inertia = 0.0;  // about the axis
  for (std::size_t node = 0; node < lab.mesh.nodes.size(); ++node) {
    const Vector3 arm = lab.mesh.nodes[node] - lab.scene.bodies[0].driven[0].pivot;
    inertia += lab.motion->dynamics().model(0).masses()[node] * (arm.x() * arm.x() + arm.z() * arm.z());
  }
  const double at = lab.motion->time() - block_step / 2;  // the velocity that it arrived with
  const double spin = angle * 2 * pi * frequency * std::cos(2 * pi * frequency * at);
  const BodyMotion body = lab.observe();
  EXPECT_NEAR(body.kinetic / (inertia * spin * spin / 2), 1.0, 1e-4);
  EXPECT_LT(body.elastic, 1e-12 * body.kinetic);
  EXPECT_NEAR(lab.motion->work().value() / body.kinetic, 1.0, 1e-9);
}

/// Arithmetic-geometric mean.
double agm(double a, double b) {
  while (std::abs(a - b) > 1e-14 * a) {
    std::tie(a, b) = std::pair((a + b) / 2, std::sqrt(a * b));
  }
  return a;
}

TEST(Hinge, ABarSwingsFromItAsACompoundPendulum) {
  // Let go 60 degrees from where it would hang. Stiff: its own weight stretches it by 2e-5 of its length.
  const Vector3 size(0.2, 0.02, 0.02);
  constexpr double weight = 100;  // m/s2
  Laboratory lab(support::block_mesh(element::tet10, size, {6, 1, 1}));
  lab.scene.materials[0].young = 1e9;
  lab.scene.bodies[0].fixed.push_back({.group = "axle", .axes = {true, true, true}, .hinge = true, .where = {}});
  auto& axle = lab.attachments.bodies[0].fixed.emplace_back().nodes;
  for (std::size_t node = 0; node < lab.mesh.nodes.size(); ++node) {
    if (lab.mesh.nodes[node].x() == 0.0 && lab.mesh.nodes[node].z() == 0.0) {
      axle.push_back(static_cast<Index>(node));
    }
  }
  const double start = pi / 3;
  const double tilt = std::atan2(size.z(), size.x());  // of the centre of mass, seen from the axle
  lab.scene.gravity = weight * Vector3(std::cos(tilt - start), 0, std::sin(tilt - start));
  const StableStep limit = find_stable_steps(lab.part, FiniteElementDynamics(lab.scene, lab.part, lab.attachments))[0];
  const double dt = 0.9 * limit.step;
  lab.begin(dt);
  const auto angle = [&] {  // from where it would hang, rad
    const Vector3 centre = lab.observe().centre;
    const Vector3& g = lab.scene.gravity;
    return std::atan2(g.x() * centre.z() - g.z() * centre.x(), g.x() * centre.x() + g.z() * centre.z());
  };
  EXPECT_NEAR(angle(), start, 1e-3);
  std::vector<double> crossings;
  for (double before = angle(); crossings.size() < 2 && lab.motion->time() < 1.0;) {
    lab.advance(10);
    const double now = angle();
    if (before * now < 0) {
      crossings.push_back(lab.motion->time() - 10 * dt * now / (now - before));
    }
    before = now;
  }
  ASSERT_EQ(crossings.size(), 2U);
  const double diagonal = std::hypot(size.x(), size.z());
  const double inertia = diagonal * diagonal / 3;  // about the edge, of unit mass
  const double period = 2 * pi * std::sqrt(inertia / (weight * diagonal / 2)) / agm(1, std::cos(start / 2));
  RecordProperty("period", std::to_string(2 * (crossings[1] - crossings[0]) / period));
  EXPECT_NEAR(2 * (crossings[1] - crossings[0]) / period, 1.0, 0.01);
}

/// What attach says to a hinge of these nodes, held at deck.yaml:3:4.
std::string refusal(const std::vector<Index>& nodes) {
  Laboratory lab = block();
  lab.mesh.groups["axle"] = nodes;
  lab.scene.bodies[0].fixed.push_back(
      {.group = "axle", .axes = {true, true, true}, .hinge = true, .where = {"deck.yaml", 3, 4}});
  try {
    static_cast<void>(attach(lab.scene, {lab.mesh}));
    return "";
  } catch (const deck::DeckError& error) {
    return error.what();
  }
}

TEST(Hinge, MustBeStraight) {
  const mesh::Mesh mesh = block().mesh;
  std::vector<Index> edge;  // along x
  Index corner = 0;
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
    if (mesh.nodes[node].y() == 0.0 && mesh.nodes[node].z() == 0.0) {
      edge.push_back(static_cast<Index>(node));
    }
    if (mesh.nodes[node].isApprox(Vector3(0.1, 0.1, 0.05))) {
      corner = static_cast<Index>(node);
    }
  }
  EXPECT_EQ(edge.size(), 9U);
  EXPECT_EQ(refusal(edge), "");
  EXPECT_EQ(refusal({edge[0], edge[3]}), "");
  EXPECT_THAT(refusal({edge[0]}), AllOf(StartsWith("deck.yaml:3:4: "), HasSubstr("has 1 node; it needs 2 or more")));
  edge.push_back(corner);
  EXPECT_THAT(refusal(edge), AllOf(StartsWith("deck.yaml:3:4: the hinge 'axle' is not straight: its node at "),
                                   HasSubstr("m off the line from "), HasSubstr("Physical Curve(\"axle\")")));
}

}  // namespace
}  // namespace idiophone::motion
