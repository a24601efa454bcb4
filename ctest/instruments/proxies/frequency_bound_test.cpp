#include "frequency_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bodies.hpp"
#include "stiffness_limit.hpp"

namespace idiophone::proxies {
namespace {

/// rad/s
double bound_of(const Lattice& lattice, int rounds) {
  return std::sqrt(std::ranges::max(
      frequency_bounds(lattice.mesh().nodes, lattice.springs(), lattice.masses(), lattice.pinned(), rounds).squares));
}

Lattice thin_plate() {
  return {box({0.2, 0.2, 0.01}, {6, 6, 1}, 0.3), rubber};
}

Lattice tight_bar() {
  OwnValues own;
  const TetrahedralMesh bar = box({0.2, 0.05, 0.05}, {6, 2, 2}, 0.2);
  own.length.assign(bar.tetrahedra.size(), 0.9);
  std::vector<Index> ends;
  for (std::size_t i = 0; i < bar.nodes.size(); ++i) {
    if (bar.nodes[i].x() < 1e-9 || bar.nodes[i].x() > 0.2 - 1e-9) {
      ends.push_back(static_cast<Index>(i));
    }
  }
  return {bar, rubber, ends, own};
}

TEST(FrequencyBound, IsAboveTheLargestFrequencyAndNearIt) {
  for (const Lattice& lattice : {*rubber_cube(3), thin_plate()}) {
    const double largest = std::sqrt(modes_of(lattice).eigenvalues().maxCoeff());
    EXPECT_GT(bound_of(lattice, enough_rounds), largest);
    EXPECT_LT(bound_of(lattice, enough_rounds), 1.03 * largest);
    EXPECT_GT(bound_of(lattice, 0), 1.1 * largest);
    EXPECT_EQ(lattice.largest_angular_frequency(), bound_of(lattice, enough_rounds));
  }
}

TEST(FrequencyBound, KnowsPinnedMassesAndTension) {
  const Lattice lattice = tight_bar();
  std::vector<Index> moving;
  for (Index i = 0; i < std::ssize(lattice.masses()); ++i) {
    for (Index axis = 0; axis < 3 && !lattice.pinned()[i]; ++axis) {
      moving.push_back(3 * i + axis);
    }
  }
  Eigen::VectorXd inverse_roots(std::ssize(moving));
  std::ranges::transform(moving, inverse_roots.begin(),
                         [&](Index unknown) { return 1.0 / std::sqrt(lattice.masses()[unknown / 3]); });
  const Eigen::MatrixXd stiffness = stiffness_of(lattice)(moving, moving);
  const Eigen::MatrixXd scaled = inverse_roots.asDiagonal() * stiffness * inverse_roots.asDiagonal();
  const double largest = std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled).eigenvalues().maxCoeff());
  EXPECT_GT(bound_of(lattice, enough_rounds), largest);
  EXPECT_LT(bound_of(lattice, enough_rounds), 1.03 * largest);
}

Eigen::VectorXd stiffness_of_springs(const Lattice& lattice) {
  Eigen::VectorXd stiffness(std::ssize(lattice.springs()));
  std::ranges::transform(lattice.springs(), stiffness.begin(), &Spring::stiffness);
  return stiffness;
}

TEST(StiffnessLimit, SoftensSpringsOfMassesAboveIt) {
  const Lattice lattice = thin_plate();
  const StiffnessLimit limit(lattice);
  const Eigen::VectorXd plain = stiffness_of_springs(lattice);
  EXPECT_EQ(limit.held(plain), plain);
  Eigen::VectorXd stiff = plain;
  stiff.head(20) *= 5.0;  // of the first masses
  EXPECT_EQ(limit.excess(plain).values.size(), 0);
  EXPECT_GT(limit.excess(stiff).values.size(), 0);
  const Eigen::VectorXd held = limit.held(stiff);
  std::vector<Spring> springs = lattice.springs();
  for (std::size_t s = 0; s < springs.size(); ++s) {
    springs[s].stiffness = held[static_cast<Eigen::Index>(s)];
  }
  const FrequencyBounds bounds =
      frequency_bounds(lattice.mesh().nodes, springs, lattice.masses(), lattice.pinned(), enough_rounds);
  EXPECT_LE(std::sqrt(std::ranges::max(bounds.squares)), (1.0 + 1e-12) * bound_of(lattice, 0));
  EXPECT_EQ(held.tail(20), plain.tail(20));  // far from there
}

TEST(StiffnessLimit, KnowsHowTheExcessChanges) {
  const Lattice lattice = thin_plate();
  const StiffnessLimit limit(lattice);
  Eigen::VectorXd stiffness = stiffness_of_springs(lattice);
  stiffness.head(20) *= 5.0;
  const Misfit before = limit.excess(stiffness);
  constexpr double change = 1e-4;  // of all logarithms: weights stay as they are
  const Misfit after = limit.excess(std::exp(change) * stiffness);
  ASSERT_EQ(before.values.size(), after.values.size());
  const Eigen::VectorXd expected = before.slopes.colwise().sum();
  EXPECT_LT(((after.values - before.values) / change - expected).norm(), 1e-3 * expected.norm());
}

}  // namespace
}  // namespace idiophone::proxies
