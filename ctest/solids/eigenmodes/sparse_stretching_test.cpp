// What makes numbers of stretching zero: aligned modes of one frequency, and terms with few pairs of modes.

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>
#include <numbers>

#include "double_modes.hpp"
#include "quartimax.hpp"
#include "ranks.hpp"

namespace idiophone::eigenmodes {
namespace {

/// Nodes around a ring; the one in the direction of x has number 5.
std::vector<Vector3> ring() {
  std::vector<Vector3> nodes;
  for (int i = -5; i < 15; ++i) {
    const double angle = i * std::numbers::pi / 10;
    nodes.emplace_back(0.2 + 0.1 * std::cos(angle), 0.1 * std::sin(angle), 0.3);
  }
  return nodes;
}

/// cos(n a) along z and sin(n a)/n around the axis, turned by an angle.
Eigenpair mode(int waves, double turned, double value) {
  Eigenpair pair{.value = value, .vector = {}};
  for (int i = -5; i < 15; ++i) {
    const double angle = i * std::numbers::pi / 10, phase = waves * angle - turned;
    const Vector3 moved(-std::sin(angle) * std::sin(phase) / waves, std::cos(angle) * std::sin(phase) / waves,
                        std::cos(phase));
    pair.vector.insert(pair.vector.end(), moved.begin(), moved.end());
  }
  return pair;
}

Eigen::Map<const Eigen::VectorXd> field(const Eigenpair& pair) {
  return {pair.vector.data(), std::ssize(pair.vector)};
}

ON_RANKS(1);

TEST(AlignDoubleModes, AreEvenAndOddAboutThePlaneOfTheFarthestNode) {
  constexpr double quarter = std::numbers::pi / 2;
  std::vector<Eigenpair> pairs = {mode(2, 0.3, 100), mode(2, 0.3 + quarter, 100 * (1 + 1e-6)), mode(3, 0.4, 200),
                                  mode(3, 0.4 + quarter, 200 * (1 + 1e-3))};
  const std::vector<Eigenpair> before = pairs;
  align_double_modes(pairs, ring());
  const Eigenpair even = mode(2, 0, 0), odd = mode(2, quarter, 0);
  EXPECT_NEAR(std::abs(field(pairs[0]).normalized().dot(field(even).normalized())), 1.0, 1e-12);
  EXPECT_NEAR(std::abs(field(pairs[1]).normalized().dot(field(odd).normalized())), 1.0, 1e-12);
  EXPECT_EQ(pairs[2].vector, before[2].vector) << "the frequencies differ";
  EXPECT_EQ(pairs[3].vector, before[3].vector);
}

TEST(Quartimax, FindsDirectionsAlongWhichMostNumbersAreZero) {
  constexpr Eigen::Index terms = 6;
  Eigen::MatrixXd sparse = Eigen::MatrixXd::Zero(5 * terms, terms);
  for (Eigen::Index row = 0; row < sparse.rows(); ++row) {
    sparse(row, row % terms) = std::cos(static_cast<double>(row * row)) + 1.5;
  }
  const Eigen::MatrixXd some = Eigen::MatrixXd::NullaryExpr(terms, terms, [](Eigen::Index row, Eigen::Index column) {
    return std::sin(1.7 * static_cast<double>(row * row + 3 * column + 1));
  });
  const Eigen::MatrixXd mixing = Eigen::HouseholderQR<Eigen::MatrixXd>(some).householderQ();
  const Eigen::MatrixXd found = quartimax(mixing, sparse * mixing);
  EXPECT_NEAR((found.transpose() * found - Eigen::MatrixXd::Identity(terms, terms)).norm(), 0.0, 1e-12);
  const Eigen::MatrixXd again = sparse * found;
  for (Eigen::Index row = 0; row < again.rows(); ++row) {
    EXPECT_NEAR(again.row(row).cwiseAbs().maxCoeff() / again.row(row).norm(), 1.0, 1e-5);
  }
}

}  // namespace
}  // namespace idiophone::eigenmodes
