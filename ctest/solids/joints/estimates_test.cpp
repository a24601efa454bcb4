// Estimated errors of the mesh of bodies on springs, hinges and shanks, against finer meshes whose joints hold the same
// parts of the bodies.

#include "idiophone/solids/eigenmodes/mesh_errors.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "assembly.hpp"
#include "block_mesh.hpp"
#include "idiophone/solids/mesh/refined.hpp"
#include "long_verification.hpp"
#include "ranks.hpp"

namespace idiophone::eigenmodes {
namespace {

constexpr int judged_modes = 6;

/// With the triangles of its group x0, which tet4 need.
mesh::Mesh bar(element::Type type, double length, std::array<int, 3> cells) {
  mesh::Mesh mesh = support::block_mesh(type, {length, 0.03, 0.01}, cells);
  std::ranges::copy_if(mesh.surface, std::back_inserter(mesh.group_triangles["x0"]),
                       [&](const mesh::Triangle& triangle) {
                         return std::ranges::all_of(triangle, [&](Index node) { return mesh.nodes[node].x() == 0; });
                       });
  return mesh;
}

/// Two bars of steel, 30 x 10 mm, one upon the other with a gap, that a joint ties near their ends.
Assembly two_bars(element::Type type, std::array<int, 3> cells) {
  Assembly bars;
  bars.add(bar(type, 0.2, cells), Vector3::Zero());
  bars.add(bar(type, 0.16, cells), {0, 0, 0.02});
  bars.join("x0", "x0", std::nullopt);
  return bars;
}

scene::Joint& joint_of(Assembly& bars) {
  return bars.scene.joints.front();
}

void put_spring(Assembly& bars) {
  joint_of(bars).type = scene::JointType::spring;
  joint_of(bars).stiffness = {4e7, 1e7};
}

/// Rigid, and resists turning.
void put_hinge(Assembly& bars) {
  joint_of(bars).type = scene::JointType::hinge;
  joint_of(bars).axis = {{0, 0.0, 0.015}, {0, 0.03, 0.015}};
  joint_of(bars).turning = scene::HingeTurning{2e3, 0.0};
}

void put_shank(Assembly& bars) {
  joint_of(bars).type = scene::JointType::bolt;
  joint_of(bars).axis = {{0, 0.015, 0.005}, {0, 0.015, 0.025}};
  joint_of(bars).shank = {.radius = 0.004, .washer = 0.02, .young = 2e11, .poisson = 0.3, .preload = 1e4};
}

/// The modes on meshes that are refined some times, with the same stiffness and parts of the bodies.
Modes find_refined(const Assembly& bars, int times) {
  std::vector<mesh::Mesh> meshes = bars.meshes;
  joints::HeldParts held = joints::held_parts(bars.scene, meshes);
  const std::vector<joints::MeshedJoint> given = joints::find_joints(bars.scene, meshes);
  for (int time = 0; time < times; ++time) {
    std::vector<mesh::RefinedMesh> refined;
    std::ranges::transform(meshes, std::back_inserter(refined), mesh::refined);
    held = joints::refined(held, bars.scene, meshes, refined);
    std::ranges::transform(refined, meshes.begin(), &mesh::RefinedMesh::mesh);
  }
  scene::Scene scene = bars.scene;
  for (std::size_t b = 0; b < meshes.size(); ++b) {
    scene.bodies[b].element = meshes[b].element;
  }
  motion::Attachments attachments = motion::attach(scene, meshes, held);
  for (std::size_t j = 0; j < given.size(); ++j) {
    attachments.joints[j].normal = given[j].normal;
    attachments.joints[j].tangential = given[j].tangential;
  }
  const mesh::Part part = mesh::distribute(meshes, MPI_COMM_SELF);
  return find_modes(scene, part, attachments, {.count = judged_modes}, MPI_COMM_SELF);
}

/// Requires what docs/method/modes.md says of most modes: of at least `at_least`, the error is at most twice the
/// estimate, and at least a fifth of it. Errors below 0.3 cents may be anything.
void expect_honest(const Assembly& bars, int refinements, int at_least) {
  constexpr double unheard = 0.3;
  const Modes found = bars.find(judged_modes);
  const Modes exact = find_refined(bars, refinements);
  std::vector<std::vector<double>> shapes;
  std::ranges::transform(found.modes, std::back_inserter(shapes), &Mode::shape);
  const std::vector<double> estimates = mesh_errors(bars.scene, bars.meshes, MassMatrix::lumped, shapes);
  int honest = 0;
  std::string judged;
  for (int mode = 0; mode < judged_modes; ++mode) {
    const double estimate = std::abs(estimates[mode]);
    const double error = 1200 * std::log2(found.modes[mode].frequency / exact.modes[mode].frequency);
    honest += std::abs(error) < 2 * estimate + unheard && std::abs(error) > 0.2 * estimate - unheard ? 1 : 0;
    judged += fmt::format("{:.1f} Hz: {:.2f}, in truth {:.2f}\n", found.modes[mode].frequency, estimates[mode], error);
  }
  EXPECT_GE(honest, at_least) << judged;
}

ON_RANKS(1);

struct Kind {
  void (*put)(Assembly&);
  const char* name;
};

class JointedEstimates : public testing::TestWithParam<Kind> {};

TEST_P(JointedEstimates, OfHexahedra) {
  Assembly bars = two_bars(element::hex(3, 2), {4, 1, 1});
  GetParam().put(bars);
  expect_honest(bars, 3, judged_modes - 1);
}

TEST_P(JointedEstimates, OfFewTetrahedra) {
  Assembly bars = two_bars(element::tet10, {4, 1, 1});
  GetParam().put(bars);
  expect_honest(bars, 2, judged_modes - 1);
}

TEST_P(JointedEstimates, OfTetrahedra) {
  LONG_VERIFICATION();
  Assembly bars = two_bars(element::tet10, {8, 2, 1});
  GetParam().put(bars);
  expect_honest(bars, 2, judged_modes - 1);
}

TEST_P(JointedEstimates, OfLinearTetrahedra) {
  LONG_VERIFICATION();
  Assembly bars = two_bars(element::tet4, {20, 3, 2});
  GetParam().put(bars);
  expect_honest(bars, 2, judged_modes - 1);
}

INSTANTIATE_TEST_SUITE_P(Joints, JointedEstimates,
                         testing::Values(Kind{put_spring, "Spring"}, Kind{put_hinge, "Hinge"},
                                         Kind{put_shank, "Shank"}),
                         [](const auto& kind) { return kind.param.name; });

}  // namespace
}  // namespace idiophone::eigenmodes
