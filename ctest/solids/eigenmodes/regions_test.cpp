// Modes of bodies of several materials against exact solutions.

#include "regions.hpp"

#include <cmath>
#include <functional>
#include <numbers>

#include "idiophone/solids/eigenmodes/mesh_errors.hpp"
#include "ranks.hpp"
#include "vibrating_body.hpp"

namespace idiophone::eigenmodes {
namespace {

double cents_above(double frequency, double reference) {
  return 1200 * std::log2(frequency / reference);
}

/// The body with a region for each of two materials.
VibratingBody of_two(const mesh::Mesh& mesh, const std::array<scene::Material, 2>& materials,
                     const std::function<Index(const Vector3& centre)>& region_of) {
  VibratingBody body(support::with_regions(mesh, region_of));
  body.scene.materials = {materials[0], materials[1]};
  body.scene.bodies[0].regions = {{.name = "first", .material = 0, .where = {}},
                                  {.name = "second", .material = 1, .where = {}}};
  return body;
}

// Without Poisson's ratio, waves along a bar that is guided at its sides keep sections plane: u(x) alone.
constexpr double length = 0.5;  // m
constexpr double joint = 0.2;   // m, where the first material ends
const std::array<scene::Material, 2> aluminium_and_maple = {
    scene::Material{"aluminium", 7e10, 0.0, 2700, {0, 2e-8}, {}}, {"maple", 1.2e10, 0.0, 640, {0, 3e-7}, {}}};

/// A free bar of two materials in series, guided at its sides.
VibratingBody bar_in_series(element::Type type) {
  mesh::Mesh mesh = support::block_mesh(type, {length, 0.02, 0.02}, {25, 1, 1});
  std::vector<Index>& all = mesh.groups["all"];
  for (Index node = 0; node < std::ssize(mesh.nodes); ++node) {
    all.push_back(node);
  }
  VibratingBody body =
      of_two(mesh, aluminium_and_maple, [](const Vector3& centre) { return centre.x() < joint ? 0 : 1; });
  body.fix("all", {false, true, true});
  return body;
}

double wave_number(const scene::Material& material, double w) {
  return w * std::sqrt(material.density / material.young);
}

/// Force at the joint of both parts, whose ends are free, over their displacement there: it vanishes at a mode,
/// sum of E k tan(k L) = 0; multiplied by both cosines, so that it has no poles.
double joint_force(double w) {
  const auto& [a, b] = aluminium_and_maple;
  const double ka = wave_number(a, w);
  const double kb = wave_number(b, w);
  return a.young * ka * std::sin(ka * joint) * std::cos(kb * (length - joint)) +
         b.young * kb * std::sin(kb * (length - joint)) * std::cos(ka * joint);
}

/// The roots of joint_force() above zero, ascending, rad/s.
std::vector<double> exact_frequencies(std::size_t count) {
  std::vector<double> roots;
  constexpr double interval = 50.0;
  for (double low = interval; roots.size() < count; low += interval) {
    double a = low;
    double b = low + interval;
    if (joint_force(a) * joint_force(b) > 0) {
      continue;
    }
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = (a + b) / 2;
      (joint_force(a) * joint_force(middle) <= 0 ? b : a) = middle;
    }
    roots.push_back(a);
  }
  return roots;
}

/// Share of a mode's strain energy in the first material. The displacement is cos(k x)/cos(k L) from either free end.
double first_share(double w) {
  const auto energy = [w](const scene::Material& material, double part) {
    const double k = wave_number(material, w);
    return material.young * k * k * (part / 2 - std::sin(2 * k * part) / (4 * k)) / std::pow(std::cos(k * part), 2);
  };
  const double first = energy(aluminium_and_maple[0], joint);
  return first / (first + energy(aluminium_and_maple[1], length - joint));
}

ON_RANKS(1, 3);

/// How far the mesh of a bar in series may err.
struct Tolerance {
  double cents;
  double damping;  ///< of its ratio, as a share
};

void expect_exact(element::Type type, MassMatrix mass, const Tolerance& tolerance) {
  const std::vector<double> exact = exact_frequencies(5);
  const Modes found = bar_in_series(type).find({.count = 5, .mass = mass});
  for (std::size_t mode = 0; mode < exact.size(); ++mode) {
    const double w = exact[mode];
    EXPECT_NEAR(cents_above(2 * std::numbers::pi * found.modes[mode].frequency, w), 0.0, tolerance.cents)
        << element::name(type) << " mode " << mode;
    const double share = first_share(w);
    const double expected =
        w / 2 *
        (share * aluminium_and_maple[0].damping.stiffness + (1 - share) * aluminium_and_maple[1].damping.stiffness);
    EXPECT_NEAR(found.modes[mode].damping_ratio / expected, 1.0, tolerance.damping)
        << element::name(type) << " mode " << mode;
  }
}

TEST(Regions, ABarInSeriesHasTheExactFrequenciesAndDamping) {
  expect_exact(element::hex(4, 2), MassMatrix::lumped, {.cents = 0.1, .damping = 1e-3});
  expect_exact(element::tet10, MassMatrix::consistent, {.cents = 1.5, .damping = 2e-3});
  expect_exact(element::tet10, MassMatrix::lumped, {.cents = 20.0, .damping = 1e-2});
}

TEST(Regions, LossFactorsDampByTheirSharesOfTheEnergy) {
  VibratingBody body = bar_in_series(element::hex(4, 2));
  const std::array<double, 2> loss = {0.002, 0.02};
  for (std::size_t region = 0; region < 2; ++region) {
    body.scene.materials[region].damping.stiffness = 0.0;
    body.scene.materials[region].damping.loss = {loss.at(region), {1000, 40000}, {}, {}};
  }
  const double w = exact_frequencies(1).front();
  const double share = first_share(w);
  const double expected = (share * loss[0] + (1 - share) * loss[1]) / 2;
  EXPECT_NEAR(body.find({.count = 1}).modes[0].damping_ratio / expected, 1.0, 0.05) << "as well as the band keeps it";
}

TEST(Regions, ABeamOfTwoLayersBendsAsLaminateTheorySays) {
  constexpr double span = 0.4;  // m
  constexpr double width = 0.01;
  constexpr std::array<double, 2> layers = {0.0016, 0.0024};
  constexpr double thickness = layers[0] + layers[1];
  const std::array<scene::Material, 2> materials = {scene::Material{"steel", 2e11, 0.0, 7850, {0, 0}, {}},
                                                    {"brass", 1e11, 0.0, 8500, {0, 0}, {}}};
  mesh::Mesh mesh = support::block_mesh(element::hex(4, 2), {span, width, thickness}, {12, 1, 2});
  for (Vector3& node : mesh.nodes) {  // the middle of the thickness to the joint of the layers
    const double z = node.z();
    const double half = thickness / 2;
    node.z() = z < half ? z / half * layers[0] : layers[0] + (z / half - 1) * layers[1];
  }
  std::vector<Index>& all = mesh.groups["all"];
  for (Index node = 0; node < std::ssize(mesh.nodes); ++node) {
    all.push_back(node);
  }
  VibratingBody body = of_two(mesh, materials, [&](const Vector3& centre) { return centre.z() < layers[0] ? 0 : 1; });
  body.fix("all", {false, true, false});  // it bends in its plane only

  // Stretching A, coupling B and bending D about the bottom, for a unit width (Jones, Mechanics of Composite Materials,
  // 1999, chapter 4); a beam that is free to stretch bends with D - B^2/A.
  double a = 0.0, b = 0.0, d = 0.0, mass = 0.0, bottom = 0.0;
  for (std::size_t layer = 0; layer < 2; ++layer) {
    const double top = bottom + layers.at(layer);
    const double young = materials.at(layer).young;
    a += young * (top - bottom);
    b += young * (top * top - bottom * bottom) / 2;
    d += young * (std::pow(top, 3) - std::pow(bottom, 3)) / 3;
    mass += materials.at(layer).density * (top - bottom);
    bottom = top;
  }
  const double free_free = 4.730040744862704;
  const double expected =
      free_free * free_free / (2 * std::numbers::pi * span * span) * std::sqrt((d - b * b / a) / mass);
  EXPECT_NEAR(cents_above(body.find({.count = 1}).modes[0].frequency, expected), 0.0, 2.0);
}

TEST(Regions, MeshErrorsAreEstimated) {
  VibratingBody body = bar_in_series(element::tet10);
  const Modes found = body.find({.count = 3}, MPI_COMM_SELF);
  std::vector<std::vector<double>> shapes;
  for (const Mode& mode : found.modes) {
    shapes.push_back(mode.shape);
  }
  const std::vector<double> exact = exact_frequencies(3);
  const std::vector<double> errors = mesh_errors(body.scene, {body.mesh}, MassMatrix::lumped, shapes);
  ASSERT_EQ(errors.size(), 3U);
  for (std::size_t mode = 0; mode < 3; ++mode) {
    const double share = errors[mode] / cents_above(2 * std::numbers::pi * found.modes[mode].frequency, exact[mode]);
    EXPECT_TRUE(share > 0.5 && share < 2.0) << "mode " << mode << ": " << share << " of the true error";
  }
}

}  // namespace
}  // namespace idiophone::eigenmodes
