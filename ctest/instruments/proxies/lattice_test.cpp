#include "idiophone/instruments/proxies/lattice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "bodies.hpp"
#include "masses.hpp"

namespace idiophone::proxies {
namespace {

using Field = std::vector<Vector3>;  // [nodes]

/// Forces of the springs, N.
Field forces(const Lattice& lattice, const Field& displacement) {
  Field force(displacement.size(), Vector3::Zero());
  for (const Spring& spring : lattice.springs()) {
    const Vector3 n = (lattice.mesh().nodes[spring.b] - lattice.mesh().nodes[spring.a]).normalized();
    const Vector3 pull = spring.stiffness * n.dot(displacement[spring.b] - displacement[spring.a]) * n;
    force[spring.a] += pull;
    force[spring.b] -= pull;
  }
  return force;
}

double dot_of(const Field& a, const Field& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += a[i].dot(b[i]);
  }
  return sum;
}

/// Young's modulus of a box under tension along an axis, whose ends are held along the axis only: by the method of
/// conjugate gradients from a uniform stretch.
double stretched_young(const Lattice& lattice, const Vector3& size, Index axis) {
  constexpr double strain = 1e-3;
  const Field& nodes = lattice.mesh().nodes;
  const auto at_end = [&](std::size_t i, double end) { return std::abs(nodes[i][axis] / size[axis] - end) < 1e-9; };
  const auto released = [&](Field field) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      field[i][axis] *= at_end(i, 0.0) || at_end(i, 1.0) ? 0.0 : 1.0;
    }
    return field;
  };
  Field displacement(nodes.size(), Vector3::Zero());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    displacement[i][axis] = strain * nodes[i][axis];
  }
  Field rest = released(forces(lattice, displacement)), direction = rest;
  const double first = dot_of(rest, rest);
  for (double square = first; square > 1e-20 * first;) {
    const Field change = released(forces(lattice, direction));
    const double length = -square / dot_of(direction, change);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      displacement[i] += length * direction[i];
      rest[i] += length * change[i];
    }
    const double next = dot_of(rest, rest);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      direction[i] = rest[i] + next / square * direction[i];
    }
    square = next;
  }
  const Field force = forces(lattice, displacement);
  double pull = 0.0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    pull -= at_end(i, 1.0) ? force[i][axis] : 0.0;
  }
  return pull / (size.prod() / size[axis]) / strain;
}

TEST(Lattice, KeepsMassCentreAndInertia) {
  const Vector3 size(0.3, 0.2, 0.1);
  const Lattice lattice(box(size, {8, 6, 5}, 0.2), rubber);
  const Inertia &points = lattice.inertia(), &body = lattice.body_inertia();
  EXPECT_NEAR(points.mass, 6.0, 1e-12);
  EXPECT_LT((points.centre - 0.5 * size).norm(), 1e-12);
  EXPECT_LT((points.second - body.second).norm(), 1e-12 * body.second.norm());
  for (Index axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(body.second(axis, axis), 6.0 * size[axis] * size[axis] / 12.0, 1e-12);
  }
  EXPECT_GT(*std::ranges::min_element(lattice.masses()), 0.0);
}

TEST(Lattice, KeepsMassAndCentreWhereInertiaIsImpossible) {
  const Lattice lattice(box({1.0, 1.0, 1.0}, {1, 1, 1}), rubber);  // all masses are at corners
  EXPECT_NEAR(lattice.inertia().mass, 1000.0, 1e-9);
  EXPECT_LT((lattice.inertia().centre - Vector3::Constant(0.5)).norm(), 1e-12);
  EXPECT_GT(*std::ranges::min_element(lattice.masses()), 0.0);
}

TEST(Lattice, SpringsHaveYoungsModulusInAUniformStrain) {
  const Lattice lattice(box({0.3, 0.2, 0.1}, {6, 4, 3}, 0.2), rubber);
  double sum = 0.0;
  for (const Spring& spring : lattice.springs()) {
    sum += spring.stiffness * (lattice.mesh().nodes[spring.b] - lattice.mesh().nodes[spring.a]).squaredNorm();
  }
  EXPECT_NEAR(sum / (6.0 * 0.006), rubber.young, 1e-6 * rubber.young);
}

TEST(Lattice, HasYoungsModulusOnAverageWhenStretched) {
  const Vector3 size(0.1, 0.1, 0.1);
  const Lattice lattice(box(size, {5, 5, 5}, 0.2), rubber);
  double mean = 0.0;
  for (Index axis = 0; axis < 3; ++axis) {
    mean += stretched_young(lattice, size, axis) / 3.0;
  }
  RecordProperty("young", std::to_string(mean));
  EXPECT_NEAR(mean / rubber.young, 1.0, 0.1);
}

TEST(Lattice, BoundsTheFrequencies) {
  const Lattice lattice(box({0.2, 0.1, 0.1}, {3, 2, 2}, 0.2), rubber);
  Field shape(lattice.masses().size(), Vector3::Zero());
  shape[0] = Vector3(1.0, 0.5, 0.2);
  double largest = 0.0;
  for (int i = 0; i < 500; ++i) {  // power iteration
    Field next = forces(lattice, shape);
    for (std::size_t node = 0; node < next.size(); ++node) {
      next[node] /= -lattice.masses()[node];
    }
    largest = std::sqrt(dot_of(next, next) / dot_of(shape, shape));
    for (Vector3& vector : next) {
      vector /= largest;
    }
    shape = next;
  }
  EXPECT_GT(lattice.largest_angular_frequency(), std::sqrt(largest));
  EXPECT_LT(lattice.largest_angular_frequency(), 2.0 * std::sqrt(largest));
}

TEST(Lattice, SharesAForceInverselyToTheDistances) {
  const Lattice lattice(box({1.0, 1.0, 1.0}, {1, 1, 1}), rubber);
  const Contact contact = lattice.contact_at({2.0, 0.6, 0.7});  // outside: the ray leaves the body nearer to the centre
  const Vector3 surface_point(1.0, 0.5 + 0.1 / 3.0, 0.5 + 0.2 / 3.0);
  double sum = 0.0;
  const auto distance = [&](std::size_t i) { return (lattice.mesh().nodes[contact.masses[i]] - surface_point).norm(); };
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(lattice.mesh().nodes[contact.masses[i]][0], 1.0);
    EXPECT_NEAR(contact.shares[i] * distance(i), contact.shares[0] * distance(0), 1e-12);
    sum += contact.shares[i];
  }
  EXPECT_NEAR(sum, 1.0, 1e-15);
  const Contact corner = lattice.contact_at({0.0, 0.0, 0.0});
  EXPECT_NEAR(*std::ranges::max_element(corner.shares), 1.0, 1e-6);
}

/// A ray in the middle plane ends at the rim, which may be pinned: the impact would be lost.
TEST(Lattice, AForceInTheMiddlePlaneOfAPlateActsNearItsPoint) {
  const Lattice lattice(box({0.2, 0.2, 0.01}, {4, 4, 1}), rubber);
  for (const double along : {0.1, 0.101, 0.09}) {  // 0.1: the centre of mass, from which no ray has a direction
    const Contact contact = lattice.contact_at({along, 0.1, 0.005});
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_LT((lattice.mesh().nodes[contact.masses[i]] - Vector3(0.1, 0.1, 0.005)).norm(), 0.006) << along;
    }
  }
}

TEST(Lattice, DampingGivesTwoDecayTimes) {
  const Damping damping = damping_for({200.0, 2000.0}, {1.0, 0.1});
  for (const auto& [frequency, t60] : {std::pair(200.0, 1.0), std::pair(2000.0, 0.1)}) {
    const double angular = 2.0 * std::numbers::pi * frequency;
    EXPECT_NEAR(0.5 * (damping.mass + damping.stiffness * angular * angular) * t60, std::log(1000.0), 1e-9);
  }
  EXPECT_THROW((void)damping_for({200.0, 2000.0}, {0.1, 1.0}), std::invalid_argument);
}

TEST(Lattice, PartsHaveValuesOfTheirOwn) {
  // Two cubes side by side; the second is 4 times as stiff, 3 times as much damped, and its masses are twice as large.
  TetrahedralMesh mesh = box({0.2, 0.1, 0.1}, {2, 1, 1});
  const Lattice plain(mesh, rubber);
  OwnValues own;
  for (const auto& tetrahedron : mesh.tetrahedra) {
    double x = 0.0;
    for (const Index node : tetrahedron) {
      x += 0.25 * mesh.nodes[node].x();
    }
    own.stiffness.push_back(x > 0.1 ? 4.0 : 1.0);
    own.damping.push_back(x > 0.1 ? 3.0 : 1.0);
  }
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
    own.masses.push_back((mesh.nodes[node].x() > 0.15 ? 2.0 : 1.0) * plain.masses()[node]);
  }
  const Lattice lattice(mesh, rubber, {}, own);
  EXPECT_EQ(lattice.masses(), own.masses);
  for (std::size_t s = 0; s < lattice.springs().size(); ++s) {
    const Spring &spring = lattice.springs()[s], &before = plain.springs()[s];
    const double x = 0.5 * (mesh.nodes[spring.a].x() + mesh.nodes[spring.b].x());
    const bool is_between = std::abs(x - 0.1) < 1e-9;
    EXPECT_NEAR(spring.section, before.section, 1e-15);
    if (!is_between) {
      EXPECT_NEAR(spring.stiffness / before.stiffness, x > 0.1 ? 4.0 : 1.0, 1e-12);
      EXPECT_NEAR(spring.damping, (x > 0.1 ? 3.0 : 1.0) * rubber.damping.stiffness, 1e-18);
    } else {
      EXPECT_GT(spring.stiffness, before.stiffness);
    }
  }
  own.stiffness.pop_back();
  EXPECT_THROW(Lattice(mesh, rubber, {}, own), std::invalid_argument);
  own.stiffness.push_back(-1.0);
  EXPECT_THROW(Lattice(mesh, rubber, {}, own), std::invalid_argument);
}

TEST(Lattice, RefusesWhatCannotBeSimulated) {
  TetrahedralMesh flat = regular_tetrahedron();
  flat.nodes[3] = (flat.nodes[0] + flat.nodes[1] + flat.nodes[2]) / 3.0;
  EXPECT_THROW(Lattice(flat, rubber), std::invalid_argument);
  TetrahedralMesh lonely = regular_tetrahedron();
  lonely.nodes.emplace_back(Vector3::Zero());
  EXPECT_THROW(Lattice(lonely, rubber), std::invalid_argument);
  const std::vector<Index> one = {0};
  EXPECT_THROW(Lattice(regular_tetrahedron(), rubber, one), std::invalid_argument);
  EXPECT_THROW(Lattice(regular_tetrahedron(), Material{.young = -1.0, .density = 1.0, .damping = {}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace idiophone::proxies
