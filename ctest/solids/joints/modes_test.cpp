// Modes of bodies that joints tie together.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "assembly.hpp"
#include "block_mesh.hpp"
#include "idiophone/solids/eigenmodes/mesh_errors.hpp"
#include "ranks.hpp"

namespace idiophone::eigenmodes {
namespace {

constexpr double turn = 2 * std::numbers::pi;

/// The nodes of the top or the bottom of a block, as a group.
void add_level(mesh::Mesh& mesh, const std::string& group, double z) {
  for (Index node = 0; node < std::ssize(mesh.nodes); ++node) {
    if (std::abs(mesh.nodes[node].z() - z) < 1e-9) {
      mesh.groups[group].push_back(node);
    }
  }
}

constexpr double height = 0.0025;  // m, of a strip

/// A strip of 300 x 20 mm.
mesh::Mesh strip() {
  mesh::Mesh mesh = support::block_mesh(element::hex(4, 2), {0.3, 0.02, height}, {5, 1, 1});
  add_level(mesh, "bottom", 0.0);
  add_level(mesh, "top", height);
  return mesh;
}

/// Two strips, one upon the other.
Assembly two_strips(const scene::JointStiffness& layer, double damping = 0.0) {
  Assembly strips;
  strips.add(strip(), Vector3::Zero());
  strips.add(strip(), {0, 0, height});
  strips.join("top", "bottom", layer, damping);
  return strips;
}

/// Cents from a frequency to the nearest mode.
double cents_to_nearest(const Modes& modes, double frequency) {
  double nearest = 1e9;
  for (const Mode& mode : modes.modes) {
    nearest = std::min(nearest, std::abs(1200 * std::log2(mode.frequency / frequency)));
  }
  return nearest;
}

// The layer is soft beside the strips, so that they keep their thickness.
constexpr double normal_stiffness = 2.5e8;  // Pa/m
constexpr double area_density = 7850 * height;

ON_RANKS(1);

TEST(JointedModes, ABarThatIsCutAndTiedKeepsItsFrequencies) {
  Assembly whole;
  whole.add(support::block_mesh(element::hex(4, 4), {0.4, 0.02, 0.01}, {8, 2, 1}), Vector3::Zero());
  Assembly halves;
  halves.add(support::block_mesh(element::hex(4, 4), {0.15, 0.02, 0.01}, {3, 2, 1}), Vector3::Zero());
  halves.add(support::block_mesh(element::hex(4, 4), {0.25, 0.02, 0.01}, {5, 3, 1}), {0.15, 0, 0});
  halves.join("x1", "x0", std::nullopt);
  const Modes expected = whole.find(8);
  const Modes tied = halves.find(8);
  EXPECT_EQ(tied.rigid_motions, 6);
  for (std::size_t mode = 0; mode < expected.modes.size(); ++mode) {
    EXPECT_LT(std::abs(1200 * std::log2(tied.modes[mode].frequency / expected.modes[mode].frequency)), 1.0) << mode;
  }
}

TEST(JointedModes, StripsOnAnElasticLayerBendInPhaseOrAgainstEachOther) {
  Assembly single;
  single.add(strip(), Vector3::Zero());
  const Modes alone = single.find(2);  // both bend across the strip
  const Modes joined = two_strips({normal_stiffness, 1e-3 * normal_stiffness}).find(12);
  const double layer = std::sqrt(2 * normal_stiffness / area_density) / turn;
  EXPECT_EQ(joined.rigid_motions, 6);
  EXPECT_LT(cents_to_nearest(joined, layer), 1.0);
  for (const Mode& mode : alone.modes) {
    EXPECT_LT(cents_to_nearest(joined, mode.frequency), 1.0);
    EXPECT_LT(cents_to_nearest(joined, std::hypot(mode.frequency, layer)), 1.0);
  }
}

TEST(JointedModes, ALayerDampsTheMotionAcrossIt) {
  constexpr double relaxation = 1e-6;  // s
  const Modes joined = two_strips({normal_stiffness, normal_stiffness / 4}, relaxation).find(8);
  const double layer = std::sqrt(2 * normal_stiffness / area_density);  // of strips that move against each other, rad/s
  const auto bounce = std::ranges::min_element(
      joined.modes, {}, [&](const Mode& mode) { return std::abs(turn * mode.frequency - layer); });
  EXPECT_NEAR(bounce->damping_ratio, relaxation * layer / 2, 1e-3 * relaxation * layer);
}

/// Two bars that glue ties end to end.
Assembly tied_bars(element::Type type) {
  Assembly bars;
  bars.add(support::block_mesh(type, {0.15, 0.03, 0.01}, {3, 1, 1}), Vector3::Zero());
  bars.add(support::block_mesh(type, {0.25, 0.03, 0.01}, {5, 1, 1}), {0.15, 0, 0});
  bars.join("x1", "x0", scene::JointStiffness{1e15, 4e14});
  return bars;
}

TEST(JointedModes, HaveAnErrorOfTheMesh) {
  constexpr int count = 5;
  const Modes exact = tied_bars(element::hex(6, 4)).find(count);
  const Assembly bars = tied_bars(element::hex(3, 2));
  const Modes found = bars.find(count);
  std::vector<std::vector<double>> shapes;
  std::ranges::transform(found.modes, std::back_inserter(shapes), &Mode::shape);
  const std::vector<double> estimates = mesh_errors(bars.scene, bars.meshes, MassMatrix::lumped, shapes);
  for (std::size_t mode = 0; mode < count; ++mode) {
    const double error = 1200 * std::log2(found.modes[mode].frequency / exact.modes[mode].frequency);
    EXPECT_LT(error, 0.7 * estimates[mode]) << mode;
    EXPECT_GT(error, 0.4 * estimates[mode]) << mode;
  }
}

/// Two blocks with a gap between them, joined by glue.
Assembly blocks_with_gap(double gap) {
  Assembly blocks;
  blocks.add(support::block_mesh(element::tet10, {0.1, 0.03, 0.02}, {3, 1, 1}), Vector3::Zero());
  blocks.add(support::block_mesh(element::tet10, {0.08, 0.03, 0.02}, {2, 1, 1}), {0.1 + gap, 0, 0});
  blocks.join("x1", "x0", scene::JointStiffness{1e13, 4e12});
  return blocks;
}

const double face_width = std::sqrt(0.03 * 0.02 / 2);  // m, of two triangles

MeshErrors estimates_of(const Assembly& blocks, const Assembly& modes_of) {
  std::vector<std::vector<double>> shapes;
  std::ranges::transform(modes_of.find(3).modes, std::back_inserter(shapes), &Mode::shape);
  return mesh_errors(blocks.scene, blocks.meshes, MassMatrix::lumped, shapes, Estimates::all);
}

/// The refined faces are half as wide, so that the reach they would choose is below the gap.
TEST(JointedModes, HaveAnErrorOfTheMeshAcrossAGap) {
  const Assembly apart = blocks_with_gap(0.07 * face_width);
  const Assembly close = blocks_with_gap(0.01 * face_width);
  const std::vector<double> found = estimates_of(apart, apart).cents, expected = estimates_of(close, close).cents;
  for (std::size_t mode = 0; mode < expected.size(); ++mode) {
    EXPECT_NEAR(found[mode], expected[mode], 0.02 * std::abs(expected[mode])) << mode;
  }
}

TEST(JointedModes, HaveNoErrorOfTheMeshWhereTheSurfacesDoNotMeet) {
  const Assembly close = blocks_with_gap(0.01 * face_width);
  const auto [estimates, why] = estimates_of(blocks_with_gap(0.11 * face_width), close);
  EXPECT_EQ(std::ranges::count_if(estimates, [](double error) { return std::isnan(error); }), 3);
  EXPECT_NE(left_out(estimates, 3, Estimates::all, why).find("no part of the two surfaces faces the other"),
            std::string::npos);
}

TEST(JointedModes, HaveNoErrorOfTheMeshOnWashersOfBoltsOrWithElementsOfTwoKinds) {
  Assembly blocks = blocks_with_gap(0.0);
  EXPECT_EQ(why_no_estimates(blocks.scene), "");
  scene::Joint& joint = blocks.scene.joints.front();
  joint.type = scene::JointType::bolt;
  EXPECT_NE(why_no_estimates(blocks.scene).find("joints.joint is a bolt without a shank"), std::string::npos);
  joint.shank = scene::Shank{};
  EXPECT_EQ(why_no_estimates(blocks.scene), "");
  blocks = tied_bars(element::hex(3, 2));
  blocks.scene.bodies.back().element = element::hex(4, 2);
  EXPECT_EQ(why_no_estimates(blocks.scene), "");
  blocks.scene.bodies.back().element = element::tet10;
  EXPECT_NE(why_no_estimates(blocks.scene).find("are hex, and those of 'block' tet10"), std::string::npos);
}

constexpr double wire_length = 0.65, cell = wire_length / 13, cooled = 200;  // m, m, K

/// A piece of steel wire of 0.5 x 0.4 mm along z that was cooled down.
void add_wire(Assembly& wires, double begin, double length, double by, const std::string& held) {
  const int cells = static_cast<int>(std::round(length / cell));
  mesh::Mesh mesh = support::block_mesh(element::hex(2, 6), {0.0005, 0.0004, length}, {1, 1, cells});
  add_level(mesh, "near", 0.0);
  add_level(mesh, "far", length);
  wires.add(std::move(mesh), {0, 0, begin});
  scene::Body& wire = wires.scene.bodies.back();
  wires.scene.materials[0].expansion = 1.2e-5;
  wire.prestress.emplace().temperature = -by;
  for (const char* group : {"near", "far"}) {
    if (held == group || held == "both") {
      wire.fixed.push_back({.group = group, .axes = {true, true, true}, .hinge = false, .where = {}});
    }
  }
}

Modes of_one_wire(double by) {
  Assembly wire;
  add_wire(wire, 0, wire_length, by, "both");
  return wire.find(4);
}

/// Of two wires that pull at each other.
Modes of_two_wires(std::optional<scene::JointStiffness> joint, std::array<double, 2> by) {
  Assembly wires;
  add_wire(wires, 0, 6 * cell, by[0], "near");
  add_wire(wires, 6 * cell, 7 * cell, by[1], "far");
  wires.join("far", "near", joint);
  return wires.find(4);
}

void expect_same_frequencies(const Modes& found, const Modes& expected, double most_cents) {
  for (std::size_t mode = 0; mode < expected.modes.size(); ++mode) {
    EXPECT_NEAR(1200 * std::log2(found.modes[mode].frequency / expected.modes[mode].frequency), 0, most_cents) << mode;
  }
}

ON_RANKS(1, 3);

TEST(JointedModes, WiresThatPullAtEachOtherAreTautAsOneWire) {
  expect_same_frequencies(of_two_wires(std::nullopt, {cooled, cooled}), of_one_wire(cooled), 0.5);
}

ON_RANKS(1);

/// Their pull stretches both alike.
TEST(JointedModes, AWireThatCoolsDownPullsTheOtherOneTaut) {
  const double mean = cooled * 6 / 13;
  expect_same_frequencies(of_two_wires(std::nullopt, {cooled, 0.0}), of_one_wire(mean), 1.0);
}

/// The layer gives way as much as the wires do, so that it takes half of their pull. They bend there more easily, too.
TEST(JointedModes, ALayerThatGivesWayTakesTensionOffTheWires) {
  const scene::JointStiffness layer{2e11 / wire_length, 1e15};
  expect_same_frequencies(of_two_wires(layer, {cooled, cooled}), of_one_wire(cooled / 2), 1.5);
}

ON_RANKS(2);

TEST(JointedModes, AreTheSameOnAnyNumberOfRanks) {
  const Assembly strips = two_strips({normal_stiffness, normal_stiffness});
  const Modes shared = strips.find(5);
  const Modes alone = strips.find(5, MPI_COMM_SELF);
  for (std::size_t mode = 0; mode < alone.modes.size(); ++mode) {
    EXPECT_NEAR(shared.modes[mode].frequency, alone.modes[mode].frequency, 1e-8 * alone.modes[mode].frequency);
  }
}

}  // namespace
}  // namespace idiophone::eigenmodes
