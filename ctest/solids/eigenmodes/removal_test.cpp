// Slopes of frequencies by removed material against exact solutions and against solutions of thinner bodies.

#include "idiophone/solids/eigenmodes/removal.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

#include "long_verification.hpp"
#include "mapped_block.hpp"
#include "ranks.hpp"
#include "regions.hpp"

namespace idiophone::eigenmodes {
namespace {

const Vector3 size = {0.3, 0.05, 0.02};  // m
constexpr double height = 0.02;          // m, of the block

/// An arch that is not symmetric, cut from below. m for a depth of 1 m
double arch(const Vector3& point) {
  const double x = point.x() / size.x();
  const double y = point.y() / size.y();
  return std::pow(std::sin(std::numbers::pi * x), 2) * (1 + 0.5 * x - 0.3 * y);
}

/// The block with an arch of some depth (m) cut from it.
MappedBlock cut_block(double depth) {
  return {.name = "cut", .size = size, .place = [depth](const Vector3& point) {
            return Vector3(point.x(), point.y(), point.z() + depth * arch(point) * (1 - point.z() / height));
          }};
}

scene::Material rosewood() {
  scene::Material material{"rosewood", 13.5e9, 0, 850, {}, {}};
  material.orthotropy = {{13.5e9, 1.9e9, 0.95e9}, {0.36, 0.44, 0.47}, {1.5e9, 0.28e9, 1.1e9}};
  return material;
}

using Change = std::function<void(VibratingBody&)>;

/// Requires that the slopes predict what shallow arches, cut and filled, do to the lowest modes.
void expect_slopes(element::Type type, const std::array<int, 3>& cells, double tolerance, const Change& change = {}) {
  constexpr double depth = 1e-4;
  constexpr int count = 4;
  const auto made = [&](double cut) {
    VibratingBody body = cut_block(cut).body(type, cells);
    if (change) {
      change(body);
    }
    return body;
  };
  const auto modes_at = [&](double cut) {
    return made(cut).find({.count = count, .mass = MassMatrix::consistent}, MPI_COMM_SELF).modes;
  };
  VibratingBody body = made(0.0);
  const Modes found = body.find({.count = count, .mass = MassMatrix::consistent}, MPI_COMM_SELF);
  const RemovalSlopes removal = removal_slopes(body.scene, body.mesh, body.attachments, found.modes);
  const auto thinner = modes_at(depth), thicker = modes_at(-depth);
  for (std::size_t mode = 0; mode < count; ++mode) {
    double predicted = 0.0;
    for (std::size_t i = 0; i < removal.nodes.size(); ++i) {
      const Vector3& node = body.mesh.nodes[removal.nodes[i]];
      predicted += node.z() < 1e-9 ? -depth * arch(node) * removal.areas[i].z() * removal.slopes[mode][i] : 0.0;
    }
    const double solved = 600 * std::log2(thinner[mode].frequency / thicker[mode].frequency);
    EXPECT_NEAR(predicted, solved, tolerance * std::abs(solved)) << "mode " << mode;
  }
}

ON_RANKS(1);

TEST(Removal, AgreesWithThinnerBodies) {
  expect_slopes(element::hex(4, 4), {5, 1, 1}, 0.01);
}

// Their strains at the surface are less exact.
TEST(Removal, OfTetrahedra) {
  LONG_VERIFICATION();
  expect_slopes(element::tet10, {20, 4, 2}, 0.035);
}

// Strains have a singularity where the materials meet at the surface.
TEST(Removal, OfTwoMaterialsOneWithALossFactor) {
  expect_slopes(element::hex(4, 4), {5, 1, 1}, 0.015, [](VibratingBody& body) {
    body.mesh = support::with_regions(body.mesh, [](const Vector3& centre) { return centre.x() < 0.1 ? 0 : 1; });
    body.scene.materials = {rosewood(), {"aluminium", 7e10, 0.33, 2700, {}, {}}};
    body.scene.materials[0].damping.loss = scene::LossFactor{.value = 0.02, .mechanisms = {}, .where = {}};
    body.scene.bodies[0].regions = {{.name = "first", .material = 0, .where = {}},
                                    {.name = "second", .material = 1, .where = {}}};
  });
}

TEST(Removal, OfAClampedBodyLeavesOutWhatIsHeld) {
  VibratingBody body = cut_block(0.0).body(element::hex(4, 4), {6, 1, 1});
  body.fix("x0");
  const Modes found = body.find({.count = 1}, MPI_COMM_SELF);
  const RemovalSlopes removal = removal_slopes(body.scene, body.mesh, body.attachments, found.modes);
  const Vector3 open = std::accumulate(removal.areas.begin(), removal.areas.end(), Vector3(0, 0, 0));
  EXPECT_NEAR((open - Vector3(size.y() * size.z(), 0, 0)).norm(), 0, 1e-12) << "of a closed surface it is zero";
}

// A ball keeps its shape when it shrinks: each frequency is as 1/radius. Lamb's lowest modes come in fives, so the mean
// of their slopes counts.
TEST(Removal, OfABallThatShrinks) {
  constexpr double radius = 0.05;
  scene::Body ball;
  ball.mesh = std::filesystem::path(IDIOPHONE_SOURCE_DIR) / "meshes/sphere.geo";
  ball.parameters = {{"radius", radius}, {"size", 0.1}};
  ball.element = element::hex(5, 5);
  VibratingBody body(mesh::read_mesh(ball));
  const Modes found = body.find({.count = 10, .mass = MassMatrix::consistent}, MPI_COMM_SELF);
  const RemovalSlopes removal = removal_slopes(body.scene, body.mesh, body.attachments, found.modes);
  for (std::size_t first : {0U, 5U}) {
    double mean = 0.0;
    for (std::size_t mode = first; mode < first + 5; ++mode) {
      for (std::size_t i = 0; i < removal.nodes.size(); ++i) {
        mean += removal.areas[i].norm() * removal.slopes[mode][i] / 5;
      }
    }
    EXPECT_NEAR(mean * radius * std::numbers::ln2 / 1200, 1.0, 0.005);
  }
}

TEST(Removal, RefusesAPrestress) {
  VibratingBody body = cut_block(0.0).body(element::hex(2, 2), {2, 1, 1});
  const Modes found = body.find({.count = 1}, MPI_COMM_SELF);
  body.scene.bodies[0].prestress.emplace();
  EXPECT_THROW((void)removal_slopes(body.scene, body.mesh, body.attachments, found.modes), deck::DeckError);
}

}  // namespace
}  // namespace idiophone::eigenmodes
