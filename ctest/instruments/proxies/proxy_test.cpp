#include "idiophone/instruments/proxies/proxy.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <stdexcept>

#include "bodies.hpp"
#include "oscillator_step.hpp"

namespace idiophone::proxies {
namespace {

constexpr Damping light{.mass = 20.0, .stiffness = 1e-7};

std::vector<Vector3> zeros(const Lattice& lattice) {
  std::vector<Vector3> all(lattice.masses().size(), Vector3::Zero());
  return all;
}

/// A regular tetrahedron of four masses m and six springs k breathes at the angular frequency 2 sqrt(k/m).
struct Breathing {
  std::shared_ptr<const Lattice> lattice;
  double angular;

  explicit Breathing(const Damping& damping)
      : lattice(std::make_shared<Lattice>(regular_tetrahedron(),
                                          Material{.young = 1e10, .density = 1000.0, .damping = damping})),
        angular(2.0 * std::sqrt(lattice->springs()[0].stiffness / lattice->masses()[0])) {}

  [[nodiscard]] Proxy proxy(Integrator integrator, double rate) const {
    Proxy proxy(lattice, {.integrator = integrator, .rate = rate});
    std::vector<Vector3> outward;
    for (const Vector3& node : lattice->mesh().nodes) {
      outward.emplace_back(1e-4 * node);
    }
    proxy.set_state(outward, zeros(*lattice));
    return proxy;
  }
};

class Integrators : public testing::TestWithParam<Integrator> {};
INSTANTIATE_TEST_SUITE_P(Proxy, Integrators, testing::Values(Integrator::symplectic_euler, Integrator::improved_euler));

TEST_P(Integrators, StepAnOscillatorExactlyAsItsMatrixSays) {
  const Breathing body(light);
  Proxy proxy = body.proxy(GetParam(), 2000.0);
  const Eigen::Matrix2d step = oscillator_step(GetParam(), body.angular, light, 1.0 / (2000.0 * proxy.steps()));
  Eigen::Vector2d state(1e-4, 0.0);
  for (int sample = 0; sample < 300; ++sample) {
    proxy.advance({});
    for (int i = 0; i < proxy.steps(); ++i) {
      state = step * state;
    }
    EXPECT_NEAR(proxy.displacement(2).dot(body.lattice->mesh().nodes[2]), state[0], 5e-8);  // single precision
  }
}

TEST_P(Integrators, DecayAsTheDampingSays) {
  const Breathing body(light);
  constexpr double rate = 1.4e6;  // fine enough that the energy does not waver
  Proxy proxy = body.proxy(GetParam(), rate);
  const double energy = proxy.elastic_energy();
  constexpr int samples = 70000;
  for (int sample = 0; sample < samples; ++sample) {
    proxy.advance({});
  }
  const double decay = 0.5 * (light.mass + light.stiffness * body.angular * body.angular);
  EXPECT_NEAR((proxy.kinetic_energy() + proxy.elastic_energy()) / energy, std::exp(-2.0 * decay * samples / rate),
              3e-3);
}

TEST(Proxy, KeepsItsEnergyWithoutDamping) {
  const auto lattice = rubber_cube(4, 0.1, {});
  Proxy proxy(lattice, {.rate = 44100.0});
  std::vector<Vector3> bent = zeros(*lattice);
  for (std::size_t i = 0; i < bent.size(); ++i) {
    bent[i] = Vector3(0.0, 0.0, 1e-4 * std::sin(31.4 * lattice->mesh().nodes[i][0]));
  }
  proxy.set_state(bent, zeros(*lattice));
  const double energy = proxy.elastic_energy();
  for (int sample = 0; sample < 20000; ++sample) {
    proxy.advance({});
  }
  EXPECT_NEAR((proxy.kinetic_energy() + proxy.elastic_energy()) / energy, 1.0, 0.03);
}

TEST(Proxy, FreeBodyTakesNoMomentum) {
  const auto lattice = rubber_cube(4);
  Proxy proxy(lattice, {});
  const PointForce blow{.contact = lattice->contact_at({0.1, 0.08, 0.07}), .force = {3.0, -2.0, 1.0}};
  proxy.advance({&blow, 1});
  EXPECT_GT(proxy.kinetic_energy(), 0.0);
  for (int sample = 0; sample < 100; ++sample) {
    proxy.advance({});
  }
  EXPECT_LT(proxy.momentum().norm(), 1e-5 * blow.force.norm() / 44100);
  EXPECT_LT(proxy.angular_momentum().norm(), 1e-6 * blow.force.norm() / 44100);
}

/// Rounding must not move the body little by little.
TEST(Proxy, FreeBodyDoesNotDrift) {
  const auto lattice = rubber_cube(3, 0.1, {.mass = 0.0, .stiffness = 1e-7});
  Proxy proxy(lattice, {});
  const PointForce blow{.contact = lattice->contact_at({0.1, 0.08, 0.07}), .force = {3.0, -2.0, 1.0}};
  proxy.advance({&blow, 1});
  for (int sample = 0; sample < 100 * 256; ++sample) {
    proxy.advance({});
  }
  Vector3 mean = Vector3::Zero(), largest = Vector3::Zero();
  for (std::size_t i = 0; i < lattice->masses().size(); ++i) {
    const Vector3 displacement = proxy.displacement(static_cast<Index>(i));
    mean += lattice->masses()[i] / lattice->inertia().mass * displacement;
    largest = largest.cwiseMax(displacement.cwiseAbs());
  }
  EXPECT_GT(largest.minCoeff(), 0.0);
  EXPECT_LT(mean.norm(), 1e-5 * largest.norm());
}

/// As modes of finite elements with the same damping do.
TEST(Proxy, ModesDecayAsRayleighDampingSays) {
  constexpr Damping damping{.mass = 10.0, .stiffness = 2e-5};
  constexpr double rate = 176400.0, duration = 0.05;
  const auto lattice = rubber_cube(3, 0.1, damping);
  const auto modes = modes_of(*lattice);
  for (const Index mode : {6, 8, 20}) {
    std::vector<Vector3> shape;
    for (std::size_t i = 0; i < lattice->masses().size(); ++i) {
      shape.emplace_back(1e-5 * modes.eigenvectors().col(mode).segment<3>(3 * static_cast<Eigen::Index>(i)));
    }
    Proxy proxy(lattice, {.rate = rate});
    proxy.set_state(shape, zeros(*lattice));
    const double energy = proxy.elastic_energy();
    EXPECT_NEAR(energy, 0.5e-10 * modes.eigenvalues()[mode], 1e-4 * energy);
    for (int sample = 0; sample < duration * rate; ++sample) {
      proxy.advance({});
    }
    const double decay = 0.5 * (damping.mass + damping.stiffness * modes.eigenvalues()[mode]);
    EXPECT_NEAR(0.5 * std::log(energy / (proxy.kinetic_energy() + proxy.elastic_energy())) / duration, decay,
                0.02 * decay);
  }
}

/// Kinetic and elastic energy after some time, of a state in which the masses move at random.
double energy_after(const std::shared_ptr<const Lattice>& lattice, int intervals) {
  Proxy proxy(lattice, {});
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::vector<Vector3> rest(lattice->masses().size(), Vector3::Zero()), velocity;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    velocity.emplace_back(1e-2 * normal(random), 1e-2 * normal(random), 1e-2 * normal(random));
  }
  proxy.set_state(rest, velocity);
  for (int i = 0; i < intervals; ++i) {
    proxy.advance({});
  }
  return proxy.kinetic_energy() + proxy.elastic_energy();
}

TEST(Proxy, SpringsHaveDampersOfTheirOwn) {
  const TetrahedralMesh mesh = box({0.1, 0.1, 0.1}, {3, 3, 3}, 0.2);
  const auto damped = [&](double stiffness, std::vector<double> own) {
    return std::make_shared<Lattice>(
        mesh,
        Material{.young = rubber.young, .density = rubber.density, .damping = {.mass = 1.0, .stiffness = stiffness}},
        std::vector<Index>{},
        OwnValues{.stiffness = {}, .damping = std::move(own), .length = {}, .edges = {}, .masses = {}, .springs = {}});
  };
  // All alike: twice the damper of each spring is twice that of the material.
  const double expected = energy_after(damped(2e-5, {}), 400);
  EXPECT_NEAR(energy_after(damped(1e-5, std::vector<double>(mesh.tetrahedra.size(), 2.0)), 400), expected,
              1e-3 * expected);
  // Dampers in one half only: the energy is between that without and that with all of them.
  std::vector<double> half(mesh.tetrahedra.size(), 0.0);
  std::fill(half.begin(), half.begin() + static_cast<std::ptrdiff_t>(half.size() / 2), 2.0);
  const double some = energy_after(damped(1e-5, half), 400);
  EXPECT_GT(some, 1.1 * expected);
  EXPECT_LT(some, 0.9 * energy_after(damped(0.0, {}), 400));
}

TEST(Proxy, PinnedMassesStay) {
  TetrahedralMesh mesh = box({0.1, 0.1, 0.1}, {3, 3, 3});
  std::vector<Index> pinned;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    if (mesh.nodes[i][2] == 0.0) {
      pinned.push_back(static_cast<Index>(i));
    }
  }
  const auto lattice = std::make_shared<Lattice>(mesh, rubber, pinned);
  Proxy proxy(lattice, {});
  const PointForce blow{.contact = lattice->contact_at({0.05, 0.05, 0.1}), .force = {0.0, 0.0, -1.0}};
  proxy.advance({&blow, 1});
  EXPECT_NEAR(proxy.momentum()[2], -1.0 / 44100, 1e-2 / 44100);  // the springs act during the interval, too
  for (int sample = 0; sample < 100; ++sample) {
    proxy.advance({});
  }
  EXPECT_EQ(proxy.displacement(pinned[5]).norm(), 0.0);
  EXPECT_LT(proxy.deviation(), 0.0);  // it is still pressed in
}

TEST(Proxy, BecomesStableAndThenDoesNothing) {
  const auto lattice = rubber_cube(3);
  Proxy proxy(lattice, {.significant_distance = 1e-8});
  EXPECT_TRUE(proxy.is_stable());
  const PointForce blow{.contact = lattice->contact_at({0.1, 0.08, 0.07}), .force = {1.0, 0.0, 0.0}};
  proxy.advance({&blow, 1});
  EXPECT_FALSE(proxy.is_stable());
  int samples = 0;
  while (!proxy.is_stable() && samples < 441000) {
    proxy.advance({});
    ++samples;
  }
  EXPECT_GT(samples, 441);
  EXPECT_LT(samples, 441000);
  EXPECT_EQ(proxy.kinetic_energy() + proxy.elastic_energy(), 0.0);
}

TEST(Proxy, NeedsFiveQuietIntervalsToBecomeStable) {
  const auto lattice = rubber_cube(2);
  Proxy proxy(lattice, {.significant_distance = 1e3});  // nothing is significant
  const PointForce blow{.contact = lattice->contact_at({0.1, 0.08, 0.07}), .force = {1.0, 0.0, 0.0}};
  Proxy moved(lattice, {.significant_distance = 1e-5});
  std::vector<Vector3> start = zeros(*lattice);
  moved.set_state(start, start);  // counts as movement, then rests
  int intervals = 0;
  while (!moved.is_stable()) {
    moved.advance({});
    ++intervals;
  }
  EXPECT_EQ(intervals, 5);
  proxy.advance({&blow, 1});
  proxy.advance({});
  EXPECT_TRUE(proxy.is_stable());
}

TEST(Proxy, DeviationIsTheChangeOfVolume) {
  const auto lattice = rubber_cube(3);
  Proxy proxy(lattice, {});
  std::vector<Vector3> swollen;
  for (const Vector3& node : lattice->mesh().nodes) {
    swollen.emplace_back(1e-5 * node);
  }
  proxy.set_state(swollen, swollen);
  EXPECT_NEAR(proxy.deviation(), 3e-5 * 1e-3, 1e-13);
  EXPECT_NEAR(proxy.facing_volume_velocity(), 3e-5 * 1e-3, 1e-13);
  proxy.face({0.0, 0.0, 1.0});  // only the top face, at z = 0.1, counts
  EXPECT_NEAR(proxy.facing_volume_velocity(), 1e-5 * 1e-3, 1e-13);
}

TEST(Proxy, TensionChangesThePitchAndTheSteps) {
  const Breathing body(light);
  Proxy proxy = body.proxy(Integrator::symplectic_euler, 44100.0);
  proxy.tune(4.0, light);
  const Eigen::Matrix2d step =
      oscillator_step(Integrator::symplectic_euler, 2.0 * body.angular, light, 1.0 / (44100.0 * proxy.steps()));
  Eigen::Vector2d state(1e-4, 0.0);
  for (int i = 0; i < 10 * proxy.steps(); ++i) {
    state = step * state;
  }
  for (int sample = 0; sample < 10; ++sample) {
    proxy.advance({});
  }
  EXPECT_NEAR(proxy.displacement(1).dot(body.lattice->mesh().nodes[1]), state[0], 5e-8);
  EXPECT_THROW(proxy.tune(0.0, light), std::invalid_argument);
  Proxy cube(rubber_cube(4), {});
  const int before = cube.steps();
  cube.tune(1e6, rubber.damping);
  EXPECT_GT(cube.steps(), 100 * before);
}

}  // namespace
}  // namespace idiophone::proxies
