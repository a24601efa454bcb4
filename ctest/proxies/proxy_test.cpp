#include "idiophone/proxies/proxy.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

#include "bodies.hpp"
#include "oscillator_step.hpp"

namespace idiophone::proxies {
namespace {

constexpr Damping light{.mass = 20.0, .stiffness = 1e-7};

std::vector<Vector3> zeros(const Lattice& lattice) {
  return std::vector<Vector3>(lattice.masses().size(), Vector3::Zero());
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
    EXPECT_NEAR(proxy.displacement(2).dot(body.lattice->mesh().nodes[2]), state[0], 1e-14);
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
  EXPECT_LT(proxy.momentum().norm(), 1e-12 * blow.force.norm() / 44100);
  EXPECT_LT(proxy.angular_momentum().norm(), 1e-12 * blow.force.norm() / 44100);
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
  EXPECT_GT(proxy.unstable_masses(), 0);
  int samples = 0;
  while (!proxy.is_stable() && samples < 441000) {
    proxy.advance({});
    ++samples;
  }
  EXPECT_GT(samples, 441);
  EXPECT_LT(samples, 441000);
  EXPECT_EQ(proxy.unstable_masses(), 0);
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
  EXPECT_NEAR(proxy.deviation(), 3e-5 * 1e-3, 1e-15);
  EXPECT_NEAR(proxy.facing_volume_velocity(), 3e-5 * 1e-3, 1e-15);
  proxy.face({0.0, 0.0, 1.0});  // only the top face, at z = 0.1, counts
  EXPECT_NEAR(proxy.facing_volume_velocity(), 1e-5 * 1e-3, 1e-15);
}

TEST(Proxy, TensionChangesThePitchAndTheSteps) {
  const Breathing body(light);
  Proxy proxy = body.proxy(Integrator::symplectic_euler, 44100.0);
  proxy.set_tension(4.0);
  const Eigen::Matrix2d step =
      oscillator_step(Integrator::symplectic_euler, 2.0 * body.angular, light, 1.0 / (44100.0 * proxy.steps()));
  Eigen::Vector2d state(1e-4, 0.0);
  for (int i = 0; i < 10 * proxy.steps(); ++i) {
    state = step * state;
  }
  for (int sample = 0; sample < 10; ++sample) {
    proxy.advance({});
  }
  EXPECT_NEAR(proxy.displacement(1).dot(body.lattice->mesh().nodes[1]), state[0], 1e-14);
  EXPECT_THROW(proxy.set_tension(0.0), std::invalid_argument);
  Proxy cube(rubber_cube(4), {});
  const int before = cube.steps();
  cube.set_tension(1e6);
  EXPECT_GT(cube.steps(), 100 * before);
}

}  // namespace
}  // namespace idiophone::proxies
