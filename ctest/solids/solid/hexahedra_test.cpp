// Spectral hexahedra, straight and curved: exact solutions, conserved quantities, and convergence in the order.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cstring>
#include <numbers>
#include <numeric>
#include <random>

#include "block_mesh.hpp"
#include "force_check.hpp"
#include "idiophone/solids/solid/elasticity.hpp"
#include "idiophone/solids/solid/packed_hexahedra.hpp"
#include "idiophone/solids/solid/tangent_stiffness.hpp"
#include "laws.hpp"

namespace idiophone::solid {
namespace {

using Eigen::Matrix3d;

const IsotropicElasticity steel_elasticity{1.2e11, 8e10};
constexpr double damping_time = 1e-7;
const KelvinVoigt<IsotropicElasticity> damped{steel_elasticity, damping_time};
const Undamped<IsotropicElasticity> undamped{steel_elasticity};
const Vector3 block_size(0.3, 0.2, 0.1);
const std::array<int, 3> block_cells = {3, 3, 2};

/// Moves the corners of the inner cells at random, and all that is between them trilinearly.
class StraightDistortion {
 public:
  StraightDistortion() {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-0.01, 0.01);
    for (int k = 0; k <= block_cells[2]; ++k) {
      for (int j = 0; j <= block_cells[1]; ++j) {
        for (int i = 0; i <= block_cells[0]; ++i) {
          const bool inside = i % block_cells[0] != 0 && j % block_cells[1] != 0 && k % block_cells[2] != 0;
          shift_[i][j][k] = (inside ? 1.0 : 0.0) * Vector3(uniform(random), uniform(random), uniform(random));
        }
      }
    }
  }

  [[nodiscard]] Vector3 operator()(const Vector3& x) const {
    int cell[3];
    double part[3];
    for (int d = 0; d < 3; ++d) {
      const double place = x[d] / block_size[d] * block_cells[d];
      cell[d] = std::min(static_cast<int>(place), block_cells[d] - 1);
      part[d] = place - cell[d];
    }
    Vector3 moved = x;
    for (int corner = 0; corner < 8; ++corner) {
      double share = 1.0;
      int at[3];
      for (int d = 0; d < 3; ++d) {
        const int upper = corner >> d & 1;
        at[d] = cell[d] + upper;
        share *= upper == 1 ? part[d] : 1 - part[d];
      }
      moved += share * shift_[at[0]][at[1]][at[2]];
    }
    return moved;
  }

 private:
  Vector3 shift_[4][4][3];  ///< [corner of the grid]
};

/// Bends everything inside; the surface stays.
Vector3 curved_distortion(const Vector3& x) {
  const Eigen::Array3d part = std::numbers::pi * x.array() / block_size.array();
  return x + 0.01 * part.sin().prod() * Vector3(1.0, -0.7, 0.4);
}

struct Case {
  element::Type type;
  bool curved;
};

class HexahedraTest : public ::testing::TestWithParam<Case> {
 protected:
  HexahedraTest()
      : part(distorted_block()),
        elements(part.bodies[0], part.reference),
        state(part.reference.size()),
        force(part.reference.size()) {}

  static mesh::Part distorted_block() {
    const StraightDistortion straight;
    mesh::Part part = support::whole_part(support::block_mesh(GetParam().type, block_size, block_cells));
    for (Vector3& x : part.reference) {
      x = GetParam().curved ? curved_distortion(x) : straight(x);
    }
    return part;
  }

  /// Quadrature of curved elements' volume isn't exact.
  [[nodiscard]] static double round_off() { return GetParam().curved ? 3e-3 : 1e-12; }

  template <class Field>
  void displace(Field field) {
    for (std::size_t node = 0; node < state.size(); ++node) {
      Eigen::Map<Vector3>(state[node].displacement) = field(part.reference[node]);
    }
  }
  template <class Field>
  void move(Field field) {
    for (std::size_t node = 0; node < state.size(); ++node) {
      Eigen::Map<Vector3>(state[node].velocity) = field(part.reference[node]);
    }
  }
  void move_at_random(double displacement, double velocity) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto vector = [&] { return Vector3(uniform(random), uniform(random), uniform(random)); };
    displace([&](const Vector3&) -> Vector3 { return displacement * vector(); });
    move([&](const Vector3&) -> Vector3 { return velocity * vector(); });
  }
  [[nodiscard]] double largest_force() const { return support::largest_component(force); }
  [[nodiscard]] double energy() const {
    std::vector<double> each(part.bodies[0].element_ids.size());
    elements.elastic_energy(undamped, state, each);
    return std::accumulate(each.begin(), each.end(), 0.0);
  }
  static bool is_inside(const Vector3& x) {
    return (x.array() > 1e-9).all() && (x.array() < block_size.array() - 1e-9).all();
  }

  mesh::Part part;
  PackedHexahedra elements;
  std::vector<NodeState> state;
  std::vector<NodeForce> force;
};

TEST_P(HexahedraTest, PatchTestUniformStrainLeavesInnerNodesWithoutForce) {
  Matrix3d h;
  h << 1e-3, 2e-4, -3e-4, 4e-4, -5e-4, 6e-4, 1e-4, -2e-4, 3e-4;
  displace([&](const Vector3& x) -> Vector3 { return h * x; });
  elements.add_internal_force(damped, state, force);
  const double scale = largest_force();
  ASSERT_GT(scale, 0.0);
  for (std::size_t node = 0; node < state.size(); ++node) {
    if (is_inside(part.reference[node])) {
      EXPECT_LT(Eigen::Map<const Vector3>(force[node].component).norm() / scale, round_off());
    }
  }
  const Matrix3d strain = (h + h.transpose() + h.transpose() * h) / 2;
  const double energy_density =
      steel_elasticity.lambda / 2 * strain.trace() * strain.trace() + steel_elasticity.mu * strain.squaredNorm();
  EXPECT_NEAR(energy() / (energy_density * block_size.prod()), 1.0, round_off());
}

TEST_P(HexahedraTest, RigidRotationGivesNoForce) {
  const Matrix3d rotation = Eigen::AngleAxisd(0.5, Vector3(1, 2, 3).normalized()).toRotationMatrix();
  displace([&](const Vector3& x) -> Vector3 { return rotation * x - x + Vector3(1, 2, 3); });
  elements.add_internal_force(damped, state, force);
  EXPECT_LT(largest_force(), 1e-11 * steel_elasticity.mu * block_size.squaredNorm());
}

TEST_P(HexahedraTest, SmallStrainSurvivesALargeRotation) {
  const Matrix3d stretch = Matrix3d::Identity() + 1e-7 * Matrix3d(Vector3(1, -0.3, 0.5).asDiagonal());
  const Matrix3d rotation = Eigen::AngleAxisd(std::numbers::pi / 6, Vector3(1, 2, 3).normalized()).toRotationMatrix();
  displace([&](const Vector3& x) -> Vector3 { return (stretch - Matrix3d::Identity()) * x; });
  elements.add_internal_force(undamped, state, force);
  const double scale = largest_force();
  std::vector<NodeForce> turned(force.size());
  displace([&](const Vector3& x) -> Vector3 { return rotation * stretch * x - x; });
  elements.add_internal_force(undamped, state, turned);
  for (std::size_t node = 0; node < force.size(); ++node) {
    const Vector3 expected = rotation * Eigen::Map<const Vector3>(force[node].component);
    EXPECT_LT((Eigen::Map<const Vector3>(turned[node].component) - expected).norm(), 1e-6 * scale);
  }
}

TEST_P(HexahedraTest, RigidSpinGivesNoDampingForce) {
  const Vector3 spin(100, 200, -300);
  move([&](const Vector3& x) -> Vector3 { return spin.cross(x); });
  elements.add_internal_force(damped, state, force);
  EXPECT_LT(largest_force(), 1e-12 * steel_elasticity.lambda * damping_time * spin.norm() * block_size.squaredNorm());
}

TEST_P(HexahedraTest, ForcesChangeNeitherMomentumNorAngularMomentum) {
  move_at_random(2e-3, 1e3);
  elements.add_internal_force(damped, state, force);
  Vector3 sum = Vector3::Zero();
  Vector3 torque = Vector3::Zero();
  for (std::size_t node = 0; node < state.size(); ++node) {
    const Vector3 f = Eigen::Map<const Vector3>(force[node].component);
    sum += f;
    torque += (part.reference[node] + Eigen::Map<const Vector3>(state[node].displacement)).cross(f);
  }
  EXPECT_LT(sum.norm(), 1e-12 * largest_force());
  EXPECT_LT(torque.norm(), 1e-12 * largest_force());
}

TEST_P(HexahedraTest, ForceIsMinusTheGradientOfTheEnergy) {
  move_at_random(2e-4, 0.0);
  elements.add_internal_force(damped, state, force);
  support::expect_minus_gradient(state, force, [&] { return energy(); },
                                 {.stride = state.size() / 20, .step = 1e-8, .tolerance = 1e-5});
}

TEST_P(HexahedraTest, TangentStiffnessIsTheForcesDerivative) {
  move_at_random(2e-4, 0.0);
  const auto nodes = part.bodies[0].element_nodes(0);
  mesh::BodyPart one = part.bodies[0];
  one.element_ids.resize(1);
  one.elements.assign(nodes.begin(), nodes.end());
  const PackedHexahedra element(one, part.reference);
  std::vector<Vector3> reference;
  std::vector<Vector3> displacement;
  for (const Index node : nodes) {
    reference.push_back(part.reference[node]);
    displacement.emplace_back(Eigen::Map<const Vector3>(state[node].displacement));
  }
  const Eigen::MatrixXd k = tangent_stiffness(one.element, Elasticity(steel_elasticity), reference, displacement);
  EXPECT_LT((k - k.transpose()).norm(), 1e-12 * k.norm());
  support::expect_tangent(k, nodes, state,
                          [&](std::vector<NodeForce>& all) { element.add_internal_force(undamped, state, all); },
                          {.stride = 1 + static_cast<std::size_t>(k.cols()) / 20,
                           .step = 1e-8,
                           .tolerance = 1e-6 * k.colwise().norm().maxCoeff()});
}

TEST_P(HexahedraTest, WithoutDampingIsKelvinVoigtWithNone) {
  move_at_random(2e-3, 1e3);
  elements.add_internal_force(undamped, state, force);
  std::vector<NodeForce> other(force.size());
  elements.add_internal_force(KelvinVoigt<IsotropicElasticity>{steel_elasticity, 0.0}, state, other);
  const double scale = largest_force();
  for (std::size_t node = 0; node < force.size(); ++node) {
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(force[node].component[i] / scale, other[node].component[i] / scale, 1e-13);
    }
  }
}

TEST_P(HexahedraTest, MassesArePositiveAndAddUpToTheBodysMassAndCentre) {
  std::vector<double> mass(state.size());
  elements.add_mass(7850, mass);
  double sum = 0.0;
  Vector3 moment = Vector3::Zero();
  for (std::size_t node = 0; node < mass.size(); ++node) {
    EXPECT_GT(mass[node], 0.0);
    sum += mass[node];
    moment += mass[node] * part.reference[node];
  }
  EXPECT_NEAR(sum / (7850 * block_size.prod()), 1.0, round_off());
  EXPECT_LT((moment / sum - block_size / 2).norm() / block_size.norm(), round_off());
}

TEST_P(HexahedraTest, AnElementsForceDoesNotDependOnItsPackOrLane) {
  move_at_random(1e-4, 1.0);
  std::vector<NodeForce> whole(force.size());
  elements.add_internal_force(damped, state, whole);
  for (Index e = 0; e < elements.element_count(); ++e) {
    const auto nodes = part.bodies[0].element_nodes(e);
    mesh::BodyPart one = part.bodies[0];
    one.element_ids = {e};
    one.elements.assign(nodes.begin(), nodes.end());
    PackedHexahedra(one, part.reference).add_internal_force(damped, state, force);
  }
  EXPECT_EQ(std::memcmp(whole.data(), force.data(), sizeof(NodeForce) * force.size()), 0);
}

TEST_P(HexahedraTest, RefusesAnInvertedElement) {
  for (Vector3& x : part.reference) {
    x[0] = -x[0];
  }
  EXPECT_THROW(PackedHexahedra(part.bodies[0], part.reference), std::runtime_error);
}

INSTANTIATE_TEST_SUITE_P(Orders, HexahedraTest,
                         ::testing::Values(Case{element::hex(2, 2), false}, Case{element::hex(4, 2), false},
                                           Case{element::hex(5, 3), false}, Case{element::hex(3, 8), false},
                                           Case{element::hex(4, 4), true}, Case{element::hex(8, 8), true}),
                         [](const auto& test) {
                           const element::Type type = test.param.type;
                           return "p" + std::to_string(type.plane) + "q" + std::to_string(type.thickness) +
                                  (test.param.curved ? "curved" : "");
                         });

/// Relative error of a bar's first longitudinal frequency, c/(4 L), c^2 = E/rho. One end is held; the sides are, too,
/// so that it only moves along itself. Two elements along the bar, unequal and with nodes that are not where the
/// Jacobian would be uniform.
double frequency_error(int order) {
  mesh::Part part = support::whole_part(support::block_mesh(element::hex(order, 2), {1.0, 0.2, 0.2}, {2, 1, 1}));
  for (Vector3& x : part.reference) {
    x[0] += 0.2 * x[0] * (1 - x[0]);
  }
  const auto size = static_cast<Eigen::Index>(part.reference.size());
  const PackedHexahedra elements(part.bodies[0], part.reference);
  std::vector<double> mass(part.reference.size());
  elements.add_mass(1.0, mass);
  std::vector<NodeState> state(part.reference.size());
  Eigen::MatrixXd matrix(size, size);
  const auto inverse_root = [&](Eigen::Index node) {
    const auto a = static_cast<std::size_t>(node);
    return part.reference[a][0] == 0.0 ? 0.0 : 1 / std::sqrt(mass[a]);
  };
  for (Eigen::Index column = 0; column < size; ++column) {
    std::vector<NodeForce> force(state.size());
    state[column].velocity[0] = 1.0;  // at rest the damping force is -beta K v
    elements.add_internal_force(KelvinVoigt<IsotropicElasticity>{{0.0, 0.5}, 1.0}, state, force);
    state[column].velocity[0] = 0.0;
    for (Eigen::Index row = 0; row < size; ++row) {
      matrix(row, column) = -force[row].component[0] * inverse_root(row) * inverse_root(column);
    }
  }
  const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
  const auto held = std::ranges::count_if(part.reference, [](const Vector3& x) { return x[0] == 0.0; });
  return std::abs(std::sqrt(values[held]) / (std::numbers::pi / 2) - 1);
}

TEST(Hexahedra, FrequenciesConvergeExponentiallyInTheOrder) {
  double before = frequency_error(2);
  EXPECT_LT(before, 0.05);
  for (int order = 3; order <= 6; ++order) {
    const double error = frequency_error(order);
    EXPECT_LT(error, before / 8) << "order " << order;
    before = error;
  }
  EXPECT_LT(before, 1e-8);
}

}  // namespace
}  // namespace idiophone::solid
