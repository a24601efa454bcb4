// A material with a loss factor: its response to an oscillation is that of its complex modulus, it turns with the body,
// and it remembers only when it is told to.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <complex>
#include <cstring>
#include <numbers>
#include <numeric>

#include "block_mesh.hpp"
#include "idiophone/solids/solid/solid.hpp"

namespace idiophone::solid {
namespace {

scene::Material lossy(double value, double stiffness_damping = 0.0) {
  scene::Material material{"lossy", 1e9, 0.3, 1000, {0, stiffness_damping}, {}};
  material.damping.loss = {value, {100, 10000}, {}, {}};
  return material;
}

/// [numbers of an element x elements]
std::vector<double> saved_memory(Solid& solid) {
  std::vector<double> all;
  for (Index element = 0; element < solid.element_count(); ++element) {
    parallel::ArchiveRow counted(parallel::ArchiveRow::Action::count);
    solid.archive_memory(element, counted);
    all.resize(all.size() + counted.count());
    parallel::ArchiveRow row(parallel::ArchiveRow::Action::save, std::span(all).last(counted.count()));
    solid.archive_memory(element, row);
  }
  return all;
}

class MemoryTest : public ::testing::TestWithParam<element::Type> {
 protected:
  static constexpr double step = 1e-5;  // w dt = 0.63 at the band's upper end

  MemoryTest()
      : mesh(support::block_mesh(GetParam(), {0.3, 0.2, 0.1}, {2, 2, 1})),
        part(support::whole_part(mesh)),
        solid(part.bodies[0], part.reference, lossy(0.1)),
        state(mesh.nodes.size()) {
    solid.begin_memory(step);
  }

  /// Goes to positions x = deform(X) in one step.
  template <class Deformation>
  void move(Deformation deform) {
    for (std::size_t node = 0; node < state.size(); ++node) {
      const Vector3 u = deform(mesh.nodes[node]) - mesh.nodes[node];
      for (int i = 0; i < 3; ++i) {
        state[node].velocity[i] = (u[i] - state[node].displacement[i]) / step;
        state[node].displacement[i] = u[i];
      }
    }
  }
  std::vector<NodeForce> remember(Solid& body) {
    std::vector<NodeForce> force(state.size());
    body.add_internal_force_and_remember(state, force);
    return force;
  }
  [[nodiscard]] static double norm(const std::vector<NodeForce>& force) {
    double square = 0.0;
    for (const NodeForce& f : force) {
      square += Eigen::Map<const Vector3>(f.component).squaredNorm();
    }
    return std::sqrt(square);
  }
  [[nodiscard]] double energy(const Solid& body) const {
    std::vector<double> each(body.element_count());
    body.elastic_energy(state, each);
    return std::accumulate(each.begin(), each.end(), 0.0);
  }

  /// Virial of the forces, minus the sum of f X, J: proportional to the stress where that is uniform.
  [[nodiscard]] double virial(const std::vector<NodeForce>& force) const {
    double sum = 0.0;
    for (std::size_t node = 0; node < force.size(); ++node) {
      sum -= mesh.nodes[node].dot(Eigen::Map<const Vector3>(force[node].component));
    }
    return sum;
  }

  /// Complex modulus, J, of the virial over the strain of the body stretched to and fro.
  /// @param frequency  Hz; its period is a whole number of steps
  std::complex<double> measured_modulus(Solid& body, double frequency) {
    const double w = 2 * std::numbers::pi * frequency;
    const int settling = 2000;
    const int steps = static_cast<int>(std::lround(1 / (frequency * step)));
    std::complex<double> sum = 0.0;
    for (int n = 0; n < settling + steps; ++n) {
      const double t = n * step;
      move([&](const Vector3& x) { return Vector3(x * (1 + 1e-7 * std::sin(w * t))); });
      const double response = virial(remember(body));
      if (n >= settling) {
        sum += response * std::exp(std::complex<double>(0, -w * t));
      }
    }
    return sum * std::complex<double>(0, 2.0 / steps) / 1e-7;
  }

  mesh::Mesh mesh;
  mesh::Part part;
  Solid solid;
  std::vector<NodeState> state;
};

TEST_P(MemoryTest, RespondsToAnOscillationAsItsComplexModulusSays) {
  const Relaxation relaxation = fit_relaxation(*lossy(0.1).damping.loss);
  Solid elastic(part.bodies[0], part.reference, {"elastic", 1e9, 0.3, 1000, {}, {}});
  const double unit = measured_modulus(elastic, 1000).real();
  for (const double frequency : {100.0, 250.0, 1000.0, 2500.0, 10000.0}) {
    Solid fresh(part.bodies[0], part.reference, lossy(0.1));
    fresh.begin_memory(step);
    const std::complex<double> found = measured_modulus(fresh, frequency) / unit;
    const std::complex<double> expected = relaxation.modulus(2 * std::numbers::pi * frequency);
    const double allowed =
        1e-3 + std::pow(2 * std::numbers::pi * frequency * step, 2) / 10;  // second order in the step
    EXPECT_NEAR(found.real() / expected.real(), 1.0, allowed / 5) << frequency;
    EXPECT_NEAR(found.imag() / expected.imag(), 1.0, allowed) << frequency;
  }
}

TEST_P(MemoryTest, StiffnessDampingAddsToTheLossFactor) {
  constexpr double beta = 1e-5;
  Solid both(part.bodies[0], part.reference, lossy(0.1, beta));
  both.begin_memory(step);
  const double alone = measured_modulus(solid, 500).imag();
  Solid elastic(part.bodies[0], part.reference, {"elastic", 1e9, 0.3, 1000, {}, {}});
  const double added = (measured_modulus(both, 500).imag() - alone) / measured_modulus(elastic, 500).real();
  EXPECT_NEAR(added / (2 * std::numbers::pi * 500 * beta), 1.0, 1e-2);
}

TEST_P(MemoryTest, RigidRotationGivesNoForceAndIsNotRemembered) {
  for (int n = 0; n < 50; ++n) {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.05 * n, Vector3(1, 2, 3).normalized()).toRotationMatrix();
    move([&](const Vector3& x) { return Vector3(turn * x + Vector3(0.01 * n, 0, 0)); });
    if (n == 0) {
      state.assign(state.size(), {});  // it has been turning for ever
      continue;
    }
    EXPECT_LT(norm(remember(solid)), 1e-12 * 1e9 * 0.06);
  }
  EXPECT_LT(energy(solid), 1e-20 * 1e9);
}

TEST_P(MemoryTest, StressTurnsWithTheBody) {
  Eigen::Matrix3d stretch = Eigen::Matrix3d::Identity();
  stretch.diagonal() << 1.01, 0.99, 1.02;
  stretch(0, 1) = 0.005;
  move([&](const Vector3& x) { return Vector3(stretch * x); });
  Solid turned = solid;
  const std::vector<NodeForce> before = remember(solid);
  remember(turned);
  std::vector<NodeForce> straight;
  std::vector<NodeForce> after;
  const std::vector<NodeState> start = state;
  Eigen::Matrix3d turn;
  for (int n = 1; n <= 20; ++n) {
    turn = Eigen::AngleAxisd(0.1 * n, Vector3(1, -1, 2).normalized()).toRotationMatrix();
    move([&](const Vector3& x) { return Vector3(turn * (stretch * x)); });
    after = remember(turned);
  }
  state = start;
  for (int n = 1; n <= 20; ++n) {
    move([&](const Vector3& x) { return Vector3(stretch * x); });
    straight = remember(solid);
  }
  EXPECT_LT(norm(straight), 0.99 * norm(before));  // it creeps meanwhile
  for (std::size_t node = 0; node < state.size(); ++node) {
    const Vector3 expected = turn * Eigen::Map<const Vector3>(straight[node].component);
    EXPECT_LT((Eigen::Map<const Vector3>(after[node].component) - expected).norm(), 1e-11 * norm(straight));
  }
}

TEST_P(MemoryTest, LookingChangesNothingAndSeesWhatIsRemembered) {
  move([](const Vector3& x) { return Vector3(1.001 * x); });
  remember(solid);
  move([](const Vector3& x) { return Vector3(1.002 * x); });
  const std::vector<double> before = saved_memory(solid);
  std::vector<NodeForce> looked(state.size());
  solid.add_internal_force(state, looked);
  (void)energy(solid);
  EXPECT_EQ(saved_memory(solid), before);
  const std::vector<NodeForce> remembered = remember(solid);
  EXPECT_EQ(std::memcmp(looked.data(), remembered.data(), sizeof(NodeForce) * looked.size()), 0);
  EXPECT_NE(saved_memory(solid), before);
}

TEST_P(MemoryTest, RowsOfElementsFitAnyPartOfTheBody) {
  for (int n = 1; n < 5; ++n) {
    move([&](const Vector3& x) { return Vector3(x + 1e-3 * n * Vector3(x[1] * x[0], x[2], x[0] * x[0])); });
    remember(solid);
  }
  // The elements from the fourth on, in other packs and lanes.
  const std::size_t skipped = 3;
  const auto nodes = static_cast<std::ptrdiff_t>(skipped) * element::node_count(mesh.element);
  mesh::BodyPart rest = part.bodies[0];
  rest.element_ids.erase(rest.element_ids.begin(), rest.element_ids.begin() + skipped);
  rest.elements.erase(rest.elements.begin(), rest.elements.begin() + nodes);
  Solid other(rest, part.reference, lossy(0.1));
  other.begin_memory(step);
  std::vector<double> rows = saved_memory(solid);
  const std::size_t width = rows.size() / solid.element_count();
  for (std::size_t element = 0; element < rest.element_ids.size(); ++element) {
    parallel::ArchiveRow row(parallel::ArchiveRow::Action::restore,
                             std::span(rows).subspan((skipped + element) * width, width));
    other.archive_memory(element, row);
  }
  move([](const Vector3& x) { return x; });
  remember(solid);
  remember(other);
  const std::vector<double> whole = saved_memory(solid);
  const std::vector<double> some = saved_memory(other);
  EXPECT_EQ(std::memcmp(&whole[skipped * width], some.data(), sizeof(double) * some.size()), 0);
}

TEST_P(MemoryTest, RestsSoftAndIsStruckHard) {
  const Relaxation relaxation = fit_relaxation(*lossy(0.1).damping.loss);
  const Solid before_time(part.bodies[0], part.reference, lossy(0.1));
  const Solid elastic(part.bodies[0], part.reference, {"elastic", 1e9, 0.3, 1000, {}, {}});
  const auto force = [&](const Solid& body) {
    std::vector<NodeForce> all(state.size());
    body.add_internal_force(state, all);
    return norm(all);
  };
  move([](const Vector3& x) { return Vector3((1 + 1e-9) * x); });
  // Against a blow, or nearly: the springs creep a little within the step.
  double stress = relaxation.long_term;
  double stored = relaxation.long_term;
  for (const auto& [strength, rate] : relaxation.mechanisms) {
    const double mean = -std::expm1(-rate * step) / (rate * step);
    stress += strength * mean;
    stored += strength * mean * mean;
  }
  EXPECT_GT(stress, 0.9 * relaxation.instantaneous());
  EXPECT_NEAR(force(solid) / force(elastic), stress, 1e-6);
  EXPECT_NEAR(energy(solid) / energy(elastic), stored, 1e-6);
  for (NodeState& node : state) {
    std::fill_n(node.velocity, 3, 0.0);
  }
  EXPECT_NEAR(force(before_time) / force(elastic), relaxation.long_term, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Types, MemoryTest, ::testing::Values(element::tet4, element::tet10, element::hex(3, 2)),
                         [](const auto& test) { return std::string(element::name(test.param)); });

}  // namespace
}  // namespace idiophone::solid
