// Mass scaling of columns: it conserves what is to be conserved, and does to pitch and step what it says.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <map>
#include <numbers>
#include <numeric>
#include <random>
#include <set>

#include "block_mesh.hpp"
#include "idiophone/solids/solid/elasticity.hpp"
#include "idiophone/solids/solid/mass.hpp"
#include "idiophone/solids/solid/packed_hexahedra.hpp"
#include "laws.hpp"

namespace idiophone::solid {
namespace {

constexpr double thickness = 0.004;
const scene::Material steel{"steel", 2e11, 0.3, 7850, {}, {}};
const MassScaling strong{.stretch = 15, .bow = 12, .rotation = 0.7, .plane_bow = 5};

class AddedMassTest : public ::testing::Test {
 protected:
  AddedMassTest()
      : part(support::whole_part(support::block_mesh(element::hex(3, 2), {0.06, 0.05, thickness}, {2, 2, 1}))),
        elements(part.bodies[0], part.reference),
        lumped(part.reference.size()),
        state(part.reference.size()),
        force(part.reference.size()) {
    elements.add_mass(steel.density, lumped);
  }

  [[nodiscard]] Mass mass(const MassScaling& scaling, const std::vector<Index>& held = {}) const {
    return {part.bodies[0], lumped,
            AddedMass(part.bodies[0], part.reference, lumped, held, [&](double) { return scaling; })};
  }
  static Vector3 random_vector() {
    static std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-1, 1);
    return {uniform(random), uniform(random), uniform(random)};
  }
  void displace_at_random(double size) {
    for (NodeState& node : state) {
      Eigen::Map<Vector3>(node.displacement) = size * random_vector();
    }
  }
  [[nodiscard]] std::vector<Vector3> momenta(const Mass& of, const std::vector<Vector3>& velocity) const {
    std::vector<Vector3> found(velocity.size(), Vector3::Zero());
    of.multiply(state, velocity, [&](Index node, const Vector3& momentum) { found[node] = momentum; });
    return found;
  }
  void add_elastic_force() {
    std::ranges::fill(force, NodeForce{});
    elements.add_internal_force(law, state, force);
  }

  const Undamped<IsotropicElasticity> law{std::get<IsotropicElasticity>(elasticity(steel))};
  mesh::Part part;
  PackedHexahedra elements;
  std::vector<double> lumped;
  std::vector<NodeState> state;
  std::vector<NodeForce> force;
};

TEST_F(AddedMassTest, ResistsNoTranslation) {
  displace_at_random(1e-4);
  const std::vector<Vector3> velocity(state.size(), Vector3(1, -2, 3));
  const std::vector<Vector3> found = momenta(mass(strong), velocity);
  for (std::size_t node = 0; node < found.size(); ++node) {
    EXPECT_LT((found[node] - lumped[node] * velocity[node]).norm(), 1e-12 * found[node].norm());
  }
}

TEST_F(AddedMassTest, SolveIsTheInverseOfMultiplyInAnyPose) {
  displace_at_random(3e-4);
  const Mass scaled = mass(strong);
  std::vector<Vector3> velocity(state.size());
  std::ranges::generate(velocity, random_vector);
  const std::vector<Vector3> momentum = momenta(scaled, velocity);
  for (std::size_t node = 0; node < force.size(); ++node) {
    Eigen::Map<Vector3>(force[node].component) = momentum[node];
    EXPECT_GT((momentum[node] - lumped[node] * velocity[node]).norm(), 0.01 * momentum[node].norm());
  }
  std::size_t visited = 0;
  scaled.solve(state, 0.0, force, [&](Index node, const Vector3& a) {
    EXPECT_LT((a - velocity[node]).norm(), 1e-11) << node;
    ++visited;
  });
  EXPECT_EQ(visited, state.size());
}

TEST_F(AddedMassTest, FactorsMakeTheInverseOfItsEntries) {
  const Mass scaled = mass(strong);
  std::vector<double> x(3 * state.size());
  std::iota(x.begin(), x.end(), 1.0);
  std::vector<double> inverted = x;
  scaled.apply_transposed_inverse_factor(inverted);
  scaled.apply_inverse_factor(inverted);
  std::vector<double> product(x.size());
  std::map<Index, std::set<Index>> columns;
  scaled.for_each_entry([&](Index row, Index column, double value) {
    product[row] += value * inverted[column];
    columns[row].insert(column);
  });
  for (std::size_t i = 0; i < x.size(); ++i) {
    EXPECT_NEAR(product[i] / x[i], 1.0, 1e-11);
    EXPECT_LE(std::ssize(columns[static_cast<Index>(i)]), scaled.entries_per_row());
  }
}

/// Components of the nodes whose x is 0: all of one column, an axle at the lower face, and z elsewhere.
std::vector<Index> held_components(const mesh::Part& part) {
  std::vector<Index> held;
  for (Index node = 0; node < std::ssize(part.reference); ++node) {
    const Vector3& x = part.reference[node];
    const bool whole = x[1] < 1e-9;
    const bool axle = x[1] < 0.026 && x[2] < 1e-9;
    for (Index axis = 0; axis < 3; ++axis) {
      if (x[0] < 1e-9 && (whole || axle || axis == 2)) {
        held.push_back(3 * node + axis);
      }
    }
  }
  return held;
}

TEST_F(AddedMassTest, LeavesColumnsThatAreHeldAsAWholeAsTheyAre) {
  const Mass scaled = mass(strong, held_components(part));
  std::vector<Vector3> velocity(state.size());
  std::ranges::generate(velocity, random_vector);
  const std::vector<Vector3> found = momenta(scaled, velocity);
  for (std::size_t node = 0; node < found.size(); ++node) {
    const bool in_column = part.reference[node].head<2>().norm() < 1e-9;
    EXPECT_EQ(found[node] == lumped[node] * velocity[node], in_column) << node;
  }
}

TEST_F(AddedMassTest, ImposedVelocitiesChangeTheMomentaOfHeldComponentsAlone) {
  displace_at_random(3e-4);
  const std::vector<Index> held = held_components(part);
  const Mass scaled = mass(strong, held);
  const auto moving = [&] {
    std::vector<Vector3> velocity(state.size());
    std::ranges::transform(state, velocity.begin(), [](const NodeState& node) { return Vector3(node.velocity); });
    return velocity;
  };
  for (NodeState& node : state) {
    Eigen::Map<Vector3>(node.velocity) = random_vector();
  }
  std::vector<double> wanted(held.size());
  std::ranges::generate(wanted, [] { return random_vector()[0]; });
  std::vector<Vector3> before = momenta(scaled, moving());
  std::vector<double> impulses(held.size());
  scaled.impose(held, wanted, state, impulses);
  const std::vector<Vector3> after = momenta(scaled, moving());
  for (std::size_t c = 0; c < held.size(); ++c) {
    EXPECT_EQ(state[held[c] / 3].velocity[held[c] % 3], wanted[c]);
    before[held[c] / 3][held[c] % 3] += impulses[c];
  }
  const double largest = std::ranges::max(after, {}, [](const Vector3& p) { return p.norm(); }).norm();
  for (std::size_t node = 0; node < state.size(); ++node) {
    EXPECT_LT((after[node] - before[node]).norm(), 1e-12 * largest) << node;
  }
}

TEST_F(AddedMassTest, FactorsInvertTheMassOfFreeComponents) {
  const std::vector<Index> held = held_components(part);
  const Mass scaled = mass(strong, held);
  const auto leave_out_held = [&](std::vector<double>& values) {
    for (const Index component : held) {
      values[component] = 0.0;
    }
  };
  std::vector<double> x(3 * state.size());
  std::iota(x.begin(), x.end(), 1.0);
  leave_out_held(x);
  std::vector<double> inverted = x;
  scaled.apply_transposed_inverse_factor(inverted);
  scaled.apply_inverse_factor(inverted);
  leave_out_held(inverted);
  std::vector<double> product(x.size());
  scaled.for_each_entry([&](Index row, Index column, double value) { product[row] += value * inverted[column]; });
  leave_out_held(product);
  for (std::size_t i = 0; i < x.size(); ++i) {
    EXPECT_NEAR(product[i], x[i], 1e-9);
  }
}

TEST_F(AddedMassTest, AFreeBodyThatSpinsAndFlexesKeepsEnergyAndMomenta) {
  const Mass scaled = mass(strong);
  const Vector3 spin(400, 900, 200);
  for (std::size_t node = 0; node < state.size(); ++node) {
    const Vector3& x = part.reference[node];
    const Vector3 v = spin.cross(x) + Vector3(0, 0, 2 * std::sin(80 * x[0]) * std::cos(60 * x[1]) + 400 * x[2] * x[0]);
    Eigen::Map<Vector3>(state[node].velocity) = v;
  }
  /// Energy, momentum and angular momentum at a whole step.
  struct Motion {
    double energy = 0.0;
    Vector3 momentum = Vector3::Zero();
    Vector3 angular = Vector3::Zero();
  };
  const auto measure = [&](double step) {
    add_elastic_force();
    std::vector<Vector3> velocity(state.size());
    scaled.solve(state, step / 2, force, [&](Index node, const Vector3& a) {
      velocity[node] = Eigen::Map<const Vector3>(state[node].velocity) + step / 2 * a;
    });
    const std::vector<Vector3> momentum = momenta(scaled, velocity);
    Motion now;
    std::vector<double> energy(part.bodies[0].element_ids.size());
    elements.elastic_energy(law, state, energy);
    now.energy = std::accumulate(energy.begin(), energy.end(), 0.0);
    for (std::size_t node = 0; node < state.size(); ++node) {
      const Vector3 place = part.reference[node] + Eigen::Map<const Vector3>(state[node].displacement);
      now.energy += velocity[node].dot(momentum[node]) / 2;
      now.momentum += momentum[node];
      now.angular += place.cross(momentum[node]);
    }
    return now;
  };
  const auto deviation = [&](double step) {
    const std::vector<NodeState> start = state;
    std::vector<Vector3> acceleration(state.size());
    Motion first;
    double largest = 0.0;
    const int steps = static_cast<int>(std::lround(2e-4 / step));
    for (int n = 0; n < steps; ++n) {
      if (n == 1) {
        first = measure(step);
      } else if (n > 1 && n % 20 == 0) {
        const Motion now = measure(step);
        largest = std::max(largest, std::abs(now.energy / first.energy - 1));
        EXPECT_LT((now.momentum - first.momentum).norm(), 1e-11 * first.momentum.norm());
        EXPECT_LT((now.angular - first.angular).norm(), 1e-12 * first.angular.norm());
      }
      add_elastic_force();
      scaled.solve(state, n == 0 ? 0.0 : step / 2, force,
                   [&](Index node, const Vector3& a) { acceleration[node] = a; });
      for (std::size_t node = 0; node < state.size(); ++node) {
        const Eigen::Map<Vector3> velocity(state[node].velocity);
        Eigen::Map<Vector3>(state[node].velocity) += (n == 0 ? step / 2 : step) * acceleration[node];
        Eigen::Map<Vector3>(state[node].displacement) += step * velocity;
      }
    }
    state = start;
    return largest;
  };
  const double coarse = deviation(2e-7);
  const double fine = deviation(1e-7);
  EXPECT_LT(coarse, 1e-2);
  EXPECT_LT(fine, coarse / 3);  // second order
}

TEST_F(AddedMassTest, LowersPitchAsPredictedAndTheHighestFrequencyByMuch) {
  const auto frequencies = [&](const Mass& of) {
    const auto size = static_cast<Eigen::Index>(3 * state.size());
    Eigen::MatrixXd matrix(size, size);
    for (Eigen::Index column = 0; column < size; ++column) {
      std::vector<double> x(size);
      x[column] = 1.0;
      of.apply_inverse_factor(x);
      for (std::size_t c = 0; c < x.size(); ++c) {
        state[c / 3].velocity[c % 3] = x[c];
      }
      std::ranges::fill(force, NodeForce{});
      elements.add_internal_force(KelvinVoigt<IsotropicElasticity>{law.elasticity, 1.0}, state, force);
      for (std::size_t c = 0; c < x.size(); ++c) {
        x[c] = -force[c / 3].component[c % 3];
      }
      of.apply_transposed_inverse_factor(x);
      matrix.col(column) = Eigen::Map<Eigen::VectorXd>(x.data(), size);
    }
    const Eigen::VectorXd squares =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
    return Eigen::VectorXd(squares.tail(size - 6).cwiseSqrt() / (2 * std::numbers::pi));
  };
  constexpr double shift = 5;
  const Eigen::VectorXd plain = frequencies(mass({}));
  const MassScaling chosen = choose_scaling(steel, thickness, plain[0], shift);
  const Eigen::VectorXd scaled = frequencies(mass(chosen));
  EXPECT_GT(plain[plain.size() - 1], 1.7 * scaled[scaled.size() - 1]);
  const double predicted = predicted_shift(chosen, steel, thickness, plain[0]);
  const double measured = 1200 * std::log2(plain[0] / scaled[0]);
  EXPECT_LE(predicted, shift + 1e-9);
  EXPECT_LT(measured, shift);
  EXPECT_GT(measured, predicted / 4);
}

TEST_F(AddedMassTest, IsChosenSoThatNoWaveMovesByMore) {
  for (const double h : {1e-3, 5e-3, 2e-2}) {
    for (const double shift : {1.0, 10.0}) {
      const MassScaling chosen = choose_scaling(steel, h, 20e3, shift);
      EXPECT_LE(predicted_shift(chosen, steel, h, 20e3), shift + 1e-9);
      EXPECT_GT(chosen.stretch, 0.0);
      EXPECT_GT(chosen.bow, chosen.rotation);
    }
  }
}

TEST_F(AddedMassTest, RefusesSeveralLayers) {
  const mesh::Part layers = support::whole_part(support::block_mesh(element::hex(2, 2), {1, 1, 1}, {1, 1, 2}));
  const std::vector<double> masses(layers.reference.size(), 1.0);
  EXPECT_THROW(AddedMass(layers.bodies[0], layers.reference, masses, {}, [](double) { return strong; }),
               std::runtime_error);
}

}  // namespace
}  // namespace idiophone::solid
