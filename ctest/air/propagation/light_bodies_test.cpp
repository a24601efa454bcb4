// Spheres on springs that oscillate in air: frequency and decay with the air's mass and resistance are known exactly.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "block_mesh.hpp"
#include "coupled_system.hpp"
#include "long_verification.hpp"
#include "ranks.hpp"

namespace idiophone::propagation {
namespace {

using namespace support;
using Complex = std::complex<double>;

constexpr double radius = 0.05;             // m
constexpr double sphere_frequency = 500.0;  // about, in air, Hz

/// The cells of a cube, its surface blown up to a sphere around the origin.
mesh::Mesh sphere_mesh() {
  mesh::Mesh mesh = support::block_mesh(element::tet10, Vector3::Constant(2.0), {4, 4, 4});
  for (Vector3& node : mesh.nodes) {
    node -= Vector3::Ones();
    const double length = node.norm();
    node *= length > 0.0 ? radius * node.cwiseAbs().maxCoeff() / length : 0.0;
  }
  return mesh;
}

/// Half of the air that a sphere displaces.
double added_mass(const scene::AirProperties& air) {
  return 2.0 / 3.0 * std::numbers::pi * std::pow(radius, 3) * air.density;
}

/// Force of the air over the velocity of a sphere that moves as exp(s t), N s/m (Morse and Ingard, Theoretical
/// Acoustics, section 7.2).
Complex impedance(const scene::AirProperties& air, const Complex& s) {
  const Complex x = s * radius / air.speed;
  return 4.0 / 3.0 * std::numbers::pi * radius * radius * air.impedance() * x * (1.0 + x) / (2.0 + 2.0 * x + x * x);
}

/// s of a sphere that moves as exp(s t) on a spring in air, by Newton's method.
Complex exact_motion(const scene::AirProperties& air, double mass, double stiffness) {
  Complex s(0.0, 2.0 * std::numbers::pi * sphere_frequency);
  const auto residual = [&](const Complex& at) { return mass * at * at + stiffness + at * impedance(air, at); };
  for (int i = 0; i < 50; ++i) {
    const Complex step = 1e-6 * s;
    s -= residual(s) / ((residual(s + step) - residual(s)) / step);
  }
  return s;
}

/// s of the damped oscillation x_{n+1} = a x_n - b x_{n-1} that fits best.
Complex fitted_motion(const std::vector<double>& x, double period) {
  Eigen::MatrixX2d matrix(std::ssize(x) - 2, 2);
  Eigen::VectorXd next(matrix.rows());
  for (Eigen::Index n = 0; n < matrix.rows(); ++n) {
    matrix.row(n) << x[n + 1], -x[n];
    next[n] = x[n + 2];
  }
  const Eigen::Vector2d fit = matrix.colPivHouseholderQr().solve(next);
  const Complex half(fit[0] / 2.0);
  return std::log(half + std::sqrt(half * half - fit[1])) / period;
}

scene::Scene sphere_on_springs(double density) {
  scene::Scene scene;
  scene.name = "sphere";
  scene.materials = {{"foam", std::max(density, 1.0) * 1e6, 0.2, density, {}, {}}};
  scene.audio.rate = 22050;
  scene.audio.max_frequency = 10000.0;
  scene.radiation.model = scene::RadiationModel::waves;
  scene.radiation.grid = {.cell = 0.01, .margin = 0.005, .back = true};
  scene.radiation.visibility.reset();
  const scene::PatchPlace everywhere = {.at = Vector3(0.0, 0.0, radius), .radius = 1.0, .where = {}};
  const double moved = density * 4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3) + added_mass(scene.radiation.air);
  const double angular = 2.0 * std::numbers::pi * sphere_frequency;
  scene::Body& body = scene.bodies.emplace_back();
  body.name = "sphere";
  body.element = element::tet10;
  body.supports.push_back({.name = "springs", .place = everywhere, .stiffness = moved * angular * angular});
  scene::ForcePulse& blow = scene.pulses.emplace_back();
  blow.place = everywhere;
  blow.force = Vector3(0.0, 0.0, moved * 1000.0);
  blow.signal.duration = 2e-4;
  scene::Listener& listener = scene.listeners.emplace_back();
  listener.name = "ear";
  listener.receivers.push_back({.channel = "ear", .position = Vector3(0.5, 0.3, 0.2)});
  return scene;
}

struct Case {
  double density;  // kg/m3
  int modes;       // none: finite elements
};

class LightSphere : public ::testing::TestWithParam<Case> {};

ON_RANKS(1);

TEST_P(LightSphere, OscillatesWithTheMassAndResistanceOfTheAir) {
  if (GetParam().density < 0.1) {  // lighter than air: many small steps
    LONG_VERIFICATION();
  }
  scene::Scene scene = sphere_on_springs(GetParam().density);
  mesh::Mesh mesh = sphere_mesh();
  if (GetParam().modes > 0) {
    scene.bodies.front().modal = {.up_to = {}, .count = GetParam().modes, .where = {}};
    mesh.indivisible = true;
  }
  System system(scene, {mesh}, MPI_COMM_SELF);
  system.start();
  std::vector<double> heights;
  for (int sample = 0; sample < 250; ++sample) {
    system.advance(1);
    if (sample > 20) {
      heights.push_back(system.source().observe_now().bodies.front().centre.z());
    }
  }
  const Complex expected = exact_motion(scene.radiation.air, system.ready().initial_state.masses.front(),
                                        scene.bodies.front().supports.front().stiffness);
  const Complex found = fitted_motion(heights, 1.0 / scene.audio.rate);
  EXPECT_NEAR(found.imag() / expected.imag(), 1.0, 0.03);
  EXPECT_NEAR(found.real() / expected.real(), 1.0, 0.15);
}

INSTANTIATE_TEST_SUITE_P(Densities, LightSphere,
                         ::testing::Values(Case{15.0, 0}, Case{1.2, 0}, Case{0.3, 0}, Case{0.008, 4}));

}  // namespace
}  // namespace idiophone::propagation
