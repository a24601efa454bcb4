// Springs and masses with values of their own (O'Morain 2005, sections 6.2 to 6.4).

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "bodies.hpp"
#include "idiophone/instruments/proxies/engine.hpp"
#include "idiophone/instruments/proxies/proxy.hpp"

namespace idiophone::proxies {
namespace {

constexpr Material undamped{.young = 1e6, .density = 1000.0, .damping = {}};

const Spring& spring_between(const Lattice& lattice, Index a, Index b) {
  return *std::ranges::find_if(lattice.springs(), [&](const Spring& spring) {
    return spring.a == std::min(a, b) && spring.b == std::max(a, b);
  });
}

/// Angular frequency that a proxy has when it begins in the shape of a mode, rad/s. The length of its steps, which
/// makes the frequency of symplectic Euler a little higher, is taken out.
/// @param expected  about it, rad/s
double frequency_in_shape(const std::shared_ptr<const Lattice>& lattice, const std::vector<Vector3>& shape,
                          double expected) {
  Proxy proxy(lattice, {.rate = expected, .significant_distance = 1e-30});  // a radian in each interval
  const auto coordinate = [&] {
    double sum = 0.0;
    for (std::size_t i = 0; i < shape.size(); ++i) {
      sum += lattice->masses()[i] * shape[i].dot(proxy.displacement(static_cast<Index>(i)));
    }
    return sum;
  };
  proxy.set_state(shape, std::vector<Vector3>(shape.size(), Vector3::Zero()));
  double before = coordinate(), products = 0.0, squares = 0.0;
  proxy.advance({});
  for (double present = coordinate(), sample = 0; sample < 500; ++sample) {
    proxy.advance({});
    const double next = coordinate();
    products += present * (before + next);  // 2 cos(w T) times the present one
    squares += present * present;
    before = std::exchange(present, next);
  }
  const double step = 1.0 / (expected * proxy.steps());
  const double heard = std::acos(0.5 * products / squares) * expected;
  return 2.0 / step * std::sin(0.5 * heard * step);
}

/// Compares the lowest modes of a free body with the eigenvalues of its matrices.
void expect_exact_eigenvalues(const std::shared_ptr<const Lattice>& lattice) {
  constexpr Index rigid = 6, compared = 4;
  const std::size_t count = lattice->masses().size();
  const Eigensystem modes = modes_of(*lattice);
  const double largest = modes.eigenvalues().maxCoeff();
  EXPECT_LT(modes.eigenvalues().head(rigid).cwiseAbs().maxCoeff(), 1e-9 * largest);
  EXPECT_LT(std::sqrt(largest), lattice->largest_angular_frequency());
  for (Index mode = rigid; mode < rigid + compared; ++mode) {
    std::vector<Vector3> shape;
    for (std::size_t i = 0; i < count; ++i) {
      shape.emplace_back(1e-3 * modes.eigenvectors().col(mode).segment<3>(3 * static_cast<Index>(i)));
    }
    const double exact = std::sqrt(modes.eigenvalues()[mode]);
    EXPECT_NEAR(frequency_in_shape(lattice, shape, exact) / exact, 1.0, 1e-5) << mode;
  }
}

TEST(OwnValues, TwoMassesOnASpringHaveTheExactFrequencies) {
  // Two masses on an axis, with a spring between them and three springs each to a pinned triangle around them.
  constexpr double height = 0.8;  // m
  TetrahedralMesh mesh;
  for (int corner = 0; corner < 3; ++corner) {
    const double angle = 2.0 * std::numbers::pi * corner / 3.0;
    mesh.nodes.emplace_back(std::cos(angle), std::sin(angle), 0.0);
  }
  mesh.nodes.insert(mesh.nodes.end(), {{0, 0, height}, {0, 0, -height}});
  mesh.tetrahedra = {{0, 1, 3, 4}, {1, 2, 3, 4}, {2, 0, 3, 4}};
  mesh.surface = exterior_triangles(mesh.nodes, mesh.tetrahedra);
  OwnValues own;
  own.stiffness = {2.5, 2.5, 2.5};
  own.masses = {1.0, 1.0, 1.0, 3.0, 7.0};
  const std::vector<Index> pinned = {0, 1, 2};
  const auto lattice = std::make_shared<Lattice>(mesh, undamped, pinned, own);
  const double between = spring_between(*lattice, 3, 4).stiffness;
  const double outside = 3.0 * spring_between(*lattice, 0, 3).stiffness * height * height / (1.0 + height * height);
  // (outside + between - m w^2)(outside + between - M w^2) = between^2
  const double sum = outside + between, m = own.masses[3], M = own.masses[4];
  const double root = std::sqrt(std::pow(sum * (m + M), 2) - 4.0 * m * M * (sum * sum - between * between));
  for (const double square : {(sum * (m + M) - root) / (2.0 * m * M), (sum * (m + M) + root) / (2.0 * m * M)}) {
    const double partner = (sum - m * square) / between;  // displacement of the second mass for that of the first
    std::vector<Vector3> shape(5, Vector3::Zero());
    shape[3] = {0, 0, 1e-3};
    shape[4] = {0, 0, 1e-3 * partner};
    const double exact = std::sqrt(square);
    EXPECT_NEAR(frequency_in_shape(lattice, shape, exact) / exact, 1.0, 1e-5);
  }
}

TEST(OwnValues, ChainOfChangingMassesAndSpringsHasTheEigenvaluesOfItsMatrices) {
  const TetrahedralMesh mesh = box({0.8, 0.1, 0.1}, {8, 1, 1}, 0.1);
  const Lattice plain(mesh, undamped);
  OwnValues own;
  for (const auto& tetrahedron : mesh.tetrahedra) {
    own.stiffness.push_back(1.0 + 10.0 * mesh.nodes[tetrahedron[0]].x());
  }
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    own.masses.push_back((1.0 + 5.0 * mesh.nodes[i].x()) * plain.masses()[i]);
  }
  expect_exact_eigenvalues(std::make_shared<Lattice>(mesh, undamped, std::vector<Index>{}, own));
}

/// A mass in the middle of a regular tetrahedron of pinned masses. @param length  natural, over that in the mesh
std::shared_ptr<const Lattice> hung_mass(double length) {
  TetrahedralMesh mesh = regular_tetrahedron();
  mesh.nodes.emplace_back(Vector3::Zero());
  mesh.tetrahedra = {{0, 1, 2, 4}, {0, 1, 3, 4}, {0, 2, 3, 4}, {1, 2, 3, 4}};
  OwnValues own;
  own.length.assign(4, length);
  const std::vector<Index> pinned = {0, 1, 2, 3};
  return std::make_shared<Lattice>(mesh, undamped, pinned, own);
}

TEST(OwnValues, SpringsUnderTensionRaiseTheFrequencyOfAMassAsTheoryHasIt) {
  for (const double length : {1.0, 0.8, 1.2}) {
    const auto lattice = hung_mass(length);
    EXPECT_LT(lattice->mesh().nodes[4].norm(), 1e-9);
    const double k = spring_between(*lattice, 0, 4).stiffness;
    // Four springs in regular directions: the sum of n n^T is 4/3; k along n, the tension over the length across it.
    const double exact = std::sqrt((4.0 / 3.0 * k + 8.0 / 3.0 * k * (1.0 - length)) / lattice->masses()[4]);
    std::vector<Vector3> shape(5, Vector3::Zero());
    shape[4] = {1e-3, 2e-3, -5e-4};
    EXPECT_NEAR(frequency_in_shape(lattice, shape, exact) / exact, 1.0, 1e-5) << length;
  }
  EXPECT_THROW((void)hung_mass(1.6), std::invalid_argument);  // the middle would buckle
}

TEST(OwnValues, BodyOfOtherNaturalLengthsComesToRestAndVibratesAboutIt) {
  const TetrahedralMesh mesh = box({0.4, 0.1, 0.1}, {4, 2, 2}, 0.1);
  OwnValues own;
  for (const auto& tetrahedron : mesh.tetrahedra) {  // the upper half is shorter: the bar bends
    double height = 0.0;
    for (const Index node : tetrahedron) {
      height += 0.25 * mesh.nodes[node].z();
    }
    own.length.push_back(height > 0.05 ? 0.9 : 1.02);
  }
  const auto lattice = std::make_shared<Lattice>(mesh, undamped, std::vector<Index>{}, own);
  std::vector<Vector3> forces(mesh.nodes.size(), Vector3::Zero());
  double largest = 0.0;
  for (const Spring& spring : lattice->springs()) {
    const Vector3 way = lattice->mesh().nodes[spring.b] - lattice->mesh().nodes[spring.a];
    EXPECT_NEAR(spring.tension, spring.stiffness * (way.norm() - spring.natural), 1e-9);
    forces[spring.a] += spring.tension * way.normalized();
    forces[spring.b] -= spring.tension * way.normalized();
    largest = std::max(largest, std::abs(spring.tension));
  }
  EXPECT_GT(largest, 1.0);
  for (const Vector3& force : forces) {
    EXPECT_LT(force.norm(), 1e-7 * largest);
  }
  EXPECT_LT((lattice->inertia().centre - lattice->body_inertia().centre).norm(), 1e-4);
  EXPECT_LT(lattice->mesh().nodes.back().x(), 0.39);  // an upper end
  expect_exact_eigenvalues(lattice);
}

TEST(OwnValues, SingleSpringsHaveFactorsOfTheirOwn) {
  const TetrahedralMesh mesh = box({0.2, 0.1, 0.1}, {2, 1, 1});
  const Material damped{.young = 1e6, .density = 1000.0, .damping = {.mass = 0.0, .stiffness = 1e-5}};
  const Lattice plain(mesh, damped);
  const auto& [a, b, c, d] = mesh.tetrahedra.front();
  OwnValues own;
  own.springs = {{.a = std::max(a, b), .b = std::min(a, b), .stiffness = 3.0, .damping = 0.5},
                 {.a = c, .b = d, .length = 1.001}};
  const Lattice changed(mesh, damped, {}, own);
  std::size_t others = 0;
  for (std::size_t i = 0; i < plain.springs().size(); ++i) {
    const Spring &before = plain.springs()[i], &after = changed.springs()[i];
    const bool is_first = before.a == std::min(a, b) && before.b == std::max(a, b);
    const bool is_second = before.a == std::min(c, d) && before.b == std::max(c, d);
    EXPECT_DOUBLE_EQ(after.stiffness, before.stiffness * (is_first ? 3.0 : 1.0));
    EXPECT_DOUBLE_EQ(after.damping, before.damping * (is_first ? 0.5 : 1.0));
    EXPECT_DOUBLE_EQ(after.natural, before.natural * (is_second ? 1.001 : 1.0));
    others += is_first || is_second ? 0 : 1;
  }
  EXPECT_EQ(others + 2, plain.springs().size());
  EXPECT_TRUE(changed.is_under_tension());
  EXPECT_FALSE(changed.is_damped_evenly());
  own.springs = {{.a = 0, .b = 0, .stiffness = 2.0}};
  EXPECT_THROW(Lattice(mesh, damped, {}, own), std::invalid_argument);
  own.springs = {{.a = a, .b = b, .stiffness = -2.0}};
  EXPECT_THROW(Lattice(mesh, damped, {}, own), std::invalid_argument);
}

TEST(OwnValues, RefusesSingleSpringsInBodiesThatShallBreak) {
  const TetrahedralMesh mesh = box({0.2, 0.1, 0.1}, {2, 1, 1});
  OwnValues own;
  own.springs = {{.a = mesh.tetrahedra.front()[0], .b = mesh.tetrahedra.front()[1], .stiffness = 2.0}};
  Engine engine({});
  EXPECT_THROW(engine.add({.name = "box",
                           .levels = {std::make_shared<Lattice>(mesh, undamped, std::vector<Index>{}, own)},
                           .strength = {.tensile = 1e6}}),
               std::invalid_argument);
}

TEST(OwnValues, RefusesLengthsThatTurnABodyInsideOutAndBodiesUnderTensionThatShallBreak) {
  const TetrahedralMesh mesh = box({0.2, 0.1, 0.1}, {2, 1, 1});
  OwnValues own;
  own.length.assign(mesh.tetrahedra.size(), 1.0);
  own.length.front() = 30.0;
  EXPECT_THROW(Lattice(mesh, undamped, {}, own), std::invalid_argument);
  own.length.front() = 1.01;
  Engine engine({});
  EXPECT_THROW(engine.add({.name = "box",
                           .levels = {std::make_shared<Lattice>(mesh, undamped, std::vector<Index>{}, own)},
                           .strength = {.tensile = 1e6}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace idiophone::proxies
