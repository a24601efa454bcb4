#include "idiophone/solid/elements.hpp"

#include <gtest/gtest.h>

#include <random>

namespace idiophone::solid {
namespace {

template <class Element>
class Elements : public ::testing::Test {};
using Types = ::testing::Types<Tet4, Tet10>;
TYPED_TEST_SUITE(Elements, Types);

TYPED_TEST(Elements, GradientsOfAConstantVanishAndOfPositionAreTheIdentity) {
  constexpr double corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int q = 0; q < TypeParam::points; ++q) {
    for (int k = 0; k < 3; ++k) {
      double constant = 0.0;
      double position[3] = {};
      for (int a = 0; a < TypeParam::nodes; ++a) {
        constant += TypeParam::gradient(q, a, k);
        for (int i = 0; i < 3; ++i) {
          const double x = a < 4 ? corners[a][i]
                                 : (corners[Tet10::edges[static_cast<std::size_t>(a - 4)][0]][i] +
                                    corners[Tet10::edges[static_cast<std::size_t>(a - 4)][1]][i]) /
                                       2;
          position[i] += x * TypeParam::gradient(q, a, k);
        }
      }
      EXPECT_NEAR(constant, 0.0, 1e-15);
      for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(position[i], i == k ? 1.0 : 0.0, 1e-15);
      }
    }
  }
}

TYPED_TEST(Elements, DifferentiateAgreesWithTheGradientTableAndAssembleIsItsTranspose) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  double field[TypeParam::nodes];
  double flux[TypeParam::points][3];
  for (double& value : field) {
    value = uniform(random);
  }
  for (auto& point : flux) {
    for (double& value : point) {
      value = uniform(random);
    }
  }
  double slope[TypeParam::points][3];
  double nodal[TypeParam::nodes];
  TypeParam::differentiate(field, slope);
  TypeParam::assemble(flux, nodal);
  for (int q = 0; q < TypeParam::points; ++q) {
    for (int k = 0; k < 3; ++k) {
      double expected = 0.0;
      for (int a = 0; a < TypeParam::nodes; ++a) {
        expected += field[a] * TypeParam::gradient(q, a, k);
      }
      EXPECT_NEAR(slope[q][k], expected, 1e-14);
    }
  }
  for (int a = 0; a < TypeParam::nodes; ++a) {
    double expected = 0.0;
    for (int q = 0; q < TypeParam::points; ++q) {
      for (int k = 0; k < 3; ++k) {
        expected += flux[q][k] * TypeParam::gradient(q, a, k);
      }
    }
    EXPECT_NEAR(nodal[a], expected, 1e-14);
  }
}

TYPED_TEST(Elements, MassSharesAddUpToOne) {
  EXPECT_NEAR(4 * TypeParam::mass_share[0] + (TypeParam::nodes - 4) * TypeParam::mass_share[1], 1.0, 1e-15);
}

}  // namespace
}  // namespace idiophone::solid
