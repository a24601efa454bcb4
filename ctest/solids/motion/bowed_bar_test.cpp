// The same bow on the same bar: on finite elements in time, and on the bar's modes as in `play`.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "heard_sound.hpp"
#include "idiophone/instruments/resonators/bow.hpp"
#include "laboratory.hpp"
#include "long_verification.hpp"
#include "mesh_modes.hpp"
#include "ranks.hpp"
#include "touched_body.hpp"

namespace idiophone::motion {

ON_RANKS(1);

namespace {

struct Bar {
  Vector3 size;  // m
  std::array<int, 3> cells;
  double young, density;  // Pa, kg/m3
  double damping;         // 1/s, proportional to mass: twice the decay of all modes
  double cords;           // N/m, of each of the two that it lies on
};

/// A bow rubs the end of the bar upwards.
Laboratory bowed_bar(const Bar& bar, const scene::Bow& bow) {
  Laboratory lab(support::block_mesh(element::hex(2, 2), bar.size, bar.cells));
  lab.scene.materials = {{"metal", bar.young, 0.33, bar.density, {bar.damping, 0}, {}}};
  const std::vector<Index>& end = lab.mesh.groups.at("x1");
  lab.scene.bows.push_back(bow);
  lab.attachments.bows.push_back({end, std::vector(end.size(), 1.0 / static_cast<double>(end.size()))});
  for (const double place : {0.224, 0.776}) {
    mesh::Patch patch;
    const double reach = 0.3 * bar.size.x() / bar.cells[0];  // more than half the distance of nodes
    for (std::size_t node = 0; node < lab.mesh.nodes.size(); ++node) {
      if (std::abs(lab.mesh.nodes[node].x() - place * bar.size.x()) < reach && lab.mesh.nodes[node].z() == 0.0) {
        patch.nodes.push_back(static_cast<Index>(node));
      }
    }
    patch.shares.assign(patch.nodes.size(), 1.0 / static_cast<double>(patch.nodes.size()));
    lab.scene.bodies[0].supports.push_back({.name = "cord", .place = {}, .stiffness = bar.cords, .damping = 0.0});
    lab.attachments.bodies[0].supports.push_back(patch);
  }
  return lab;
}

/// The modes below 20 kHz as the bow's patch moves along z.
std::vector<resonators::TouchedMode> audible(const Modes& modes, const mesh::Patch& patch, double decay) {
  std::vector<resonators::TouchedMode> found;
  for (Eigen::Index mode = 0; mode < modes.frequencies.size(); ++mode) {
    const double frequency = modes.frequencies[mode] / (2.0 * std::numbers::pi);
    double participation = 0.0;
    for (std::size_t n = 0; n < patch.nodes.size(); ++n) {
      participation += patch.shares[n] * modes.shapes(3 * patch.nodes[n] + 2, mode);
    }
    if (frequency > 1.0 && frequency < 20000.0) {
      found.push_back({frequency, decay, participation});
    }
  }
  return found;
}

/// Velocity of the bow's patch along z, 1/rate apart, m/s.
std::vector<double> velocity_in_time(Laboratory& lab, double highest, double duration) {
  const int steps = static_cast<int>(std::ceil(highest / (1.6 * resonators::rate)));
  lab.begin(1.0 / (resonators::rate * steps));
  std::vector<double> velocity;
  while (velocity.size() < static_cast<std::size_t>(duration * resonators::rate)) {
    lab.advance(steps);
    double sum = 0.0;
    for (const Index node : lab.attachments.bows[0].nodes) {
      sum += lab.motion->state()[node].velocity[2];
    }
    velocity.push_back(sum / static_cast<double>(lab.attachments.bows[0].nodes.size()));
  }
  return velocity;
}

/// Compares the last part of both motions.
/// @param low, high  between which its pitch is, Hz
void expect_the_same_motion(const Bar& bar, double load, double duration, double low, double high) {
  scene::Bow bow;
  bow.direction = Vector3::UnitZ();
  bow.speed.points = {{0.0, 0.0}, {0.05, 0.1}};
  bow.load.points = {{0.0, load}};
  bow.duration = 100.0;
  Laboratory lab = bowed_bar(bar, bow);
  const FiniteElementDynamics dynamics(lab.scene, lab.part, lab.attachments);
  std::vector<double> springs(lab.mesh.nodes.size());
  dynamics.loads().add_support_stiffness(springs);
  const Modes all = modes(lab, dynamics.mass(0).lumped(), springs);

  score::Bow as_played;
  static_cast<scene::Bowing&>(as_played) = bow;
  resonators::Bow played(as_played, resonators::rate);
  resonators::TouchedBody body(audible(all, lab.attachments.bows[0], bar.damping / 2.0), played);
  body.advance(static_cast<std::size_t>(duration * resonators::rate));
  const std::vector<double> in_time = velocity_in_time(lab, all.frequencies.maxCoeff(), duration);

  const auto last = [&](const std::vector<double>& velocity) { return std::span(velocity).last(in_time.size() / 3); };
  const auto pitch = [&](const std::vector<double>& velocity) {
    return support::pitch(last(velocity), low, high, resonators::rate);
  };
  const double level = support::root_mean_square(last(in_time));
  EXPECT_GT(level, 0.02);  // it sings
  EXPECT_LT(std::abs(20.0 * std::log10(level / support::root_mean_square(last(body.velocity())))), 0.05);
  EXPECT_LT(std::abs(1200.0 * std::log2(pitch(in_time) / pitch(body.velocity()))), 1.0);  // steps of 0.1 Hz
  std::printf("%.1f Hz in time, %.1f Hz as played, %.3f dB apart\n", pitch(in_time), pitch(body.velocity()),
              20.0 * std::log10(level / support::root_mean_square(last(body.velocity()))));
}

}  // namespace

TEST(BowedBar, SingsInTimeAsInPlay) {
  const Bar nylon{
      .size = {0.2, 0.02, 0.01}, .cells = {6, 1, 1}, .young = 4.0e9, .density = 1150.0, .damping = 30.0, .cords = 1e3};
  expect_the_same_motion(nylon, 0.5, 0.3, 400.0, 560.0);
}

TEST(BowedBar, OfAVibraphoneSingsInTimeAsInPlay) {
  LONG_VERIFICATION();
  const Bar aluminium{.size = {0.36, 0.05, 0.009},
                      .cells = {9, 2, 1},
                      .young = 7.0e10,
                      .density = 2700.0,
                      .damping = 5.0,
                      .cords = 4.0e3};
  expect_the_same_motion(aluminium, 2.0, 1.5, 250.0, 450.0);
}

}  // namespace idiophone::motion
