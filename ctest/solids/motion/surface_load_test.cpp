#include "idiophone/solids/motion/surface_load.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "laboratory.hpp"
#include "ranks.hpp"

namespace idiophone::motion {
namespace {

/// All surfaces of a block, in an air that is not there.
class Loaded {
 public:
  explicit Loaded(element::Type type)
      : lab_(support::block_mesh(type, {0.3, 0.2, 0.1}, {3, 2, 1})),
        load_(loaded_triangles(mesh::distribute({lab_.mesh}, MPI_COMM_SELF), {true}, MPI_COMM_SELF),
              lab_.part.reference, 1.0),
        state_(lab_.mesh.nodes.size()) {}

  [[nodiscard]] double area(std::size_t triangle) const {
    const auto& [a, b, c] = load_.triangles().triangles[triangle].corners;
    const auto& nodes = lab_.mesh.nodes;
    return 0.5 * (nodes[b] - nodes[a]).cross(nodes[c] - nodes[a]).norm();
  }
  [[nodiscard]] std::size_t triangles() const { return load_.triangles().triangles.size(); }

  /// Velocities that no order of elements has exactly.
  void move() {
    for (std::size_t n = 0; n < state_.size(); ++n) {
      for (int i = 0; i < 3; ++i) {
        state_[n].velocity[i] = std::sin(40.0 * lab_.mesh.nodes[n][i] + static_cast<double>(n));
      }
    }
  }

  /// The forces for these at the corners, which do not depend on velocities.
  std::vector<solid::NodeForce> forces(const std::vector<double>& at_corners) {
    std::ranges::copy(at_corners, load_.force().begin());
    return forces();
  }
  /// The forces of dashpots on the triangles, with the same resistance on each area.
  std::vector<solid::NodeForce> dashpots(double resistance) {
    for (std::size_t i = 0; i < load_.resistance().size(); ++i) {
      load_.resistance()[i] = resistance * area(i / 3) / 3.0;
    }
    return forces();
  }

  Laboratory lab_;
  SurfaceLoad load_;
  std::vector<solid::NodeState> state_;

 private:
  std::vector<solid::NodeForce> forces() {
    load_.begin_interval(state_);
    load_.go_on();
    std::vector<solid::NodeForce> force(state_.size());
    load_.add(state_, force);
    return force;
  }
};

class SurfaceLoadTest : public ::testing::TestWithParam<element::Type> {};

ON_RANKS(1);

TEST_P(SurfaceLoadTest, WorksAsMuchOnTheNodesAsOnTheTriangles) {
  Loaded loaded(GetParam());
  loaded.load_.start(loaded.state_);
  std::vector<double> pushes, velocities(3 * loaded.triangles());
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    pushes.push_back(std::cos(3.0 * static_cast<double>(i)));
  }
  loaded.move();
  const std::vector<solid::NodeForce> force = loaded.forces(pushes);
  double on_nodes = 0.0, on_triangles = 0.0;
  for (std::size_t n = 0; n < force.size(); ++n) {
    for (int i = 0; i < 3; ++i) {
      on_nodes -= force[n].component[i] * loaded.state_[n].velocity[i];
      loaded.state_[n].displacement[i] = loaded.state_[n].velocity[i];  // after the interval of 1 s
    }
  }
  loaded.load_.end_interval(loaded.state_, velocities);
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    on_triangles += pushes[i] * velocities[i];
  }
  EXPECT_NEAR(on_nodes, on_triangles, 1e-10);
}

TEST_P(SurfaceLoadTest, OfAUniformPressureIsThatOfTheShapeFunctions) {
  Loaded loaded(GetParam());
  std::vector<double> pushes;
  for (std::size_t i = 0; i < 3 * loaded.triangles(); ++i) {
    pushes.push_back(loaded.area(i / 3) / 3.0);
  }
  const std::vector<solid::NodeForce> force = loaded.forces(pushes);
  const int power = std::min(element::orders(GetParam()).plane, 2);
  double moment = 0.0;  // of the end at x = 0.3 m
  for (std::size_t n = 0; n < force.size(); ++n) {
    const Vector3& place = loaded.lab_.mesh.nodes[n];
    moment += place[0] > 0.29 ? force[n].component[0] * std::pow(place[1], power) : 0.0;
  }
  EXPECT_NEAR(moment, -std::pow(0.2, power + 1) / (power + 1) * 0.1, 1e-12);
}

/// steps.hpp takes the mass of a node over its part of the area for the least one that a dashpot can meet.
TEST_P(SurfaceLoadTest, MeetsNoLessMassThanTheLightestNode) {
  Loaded loaded(GetParam());
  const FiniteElementDynamics dynamics(loaded.lab_.scene, loaded.lab_.part, loaded.lab_.attachments);
  const std::span<const double> masses = dynamics.model(0).masses();
  const std::vector<double> areas = mesh::nodal_areas(loaded.lab_.mesh.surface, loaded.lab_.mesh.nodes);
  double lightest = 1e9;
  for (std::size_t n = 0; n < areas.size(); ++n) {
    lightest = std::min(lightest, masses[n] / areas[n]);
  }
  loaded.move();
  double largest = 0.0;  // eigenvalue of dashpots over masses, by iteration
  for (int iteration = 0; iteration < 300; ++iteration) {
    const std::vector<solid::NodeForce> force = loaded.dashpots(1.0);
    double square = 0.0;
    for (std::size_t n = 0; n < force.size(); ++n) {
      for (int i = 0; i < 3; ++i) {
        loaded.state_[n].velocity[i] = -force[n].component[i] / masses[n];
        square += std::pow(loaded.state_[n].velocity[i], 2);
      }
    }
    largest = std::sqrt(square);
    for (auto& node : loaded.state_) {
      std::ranges::transform(node.velocity, node.velocity, [&](double velocity) { return velocity / largest; });
    }
  }
  EXPECT_LE(largest * lightest, 1.0 + 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Types, SurfaceLoadTest,
                         ::testing::Values(element::tet4, element::tet10, element::hex(2, 2), element::hex(4, 3)));

}  // namespace
}  // namespace idiophone::motion
