#include "nodal_gradient.hpp"

#include <gtest/gtest.h>

#include <random>

namespace idiophone::solid {
namespace {

template <class Element>
class NodalGradients : public ::testing::Test {};
using Types = ::testing::Types<element::Tet4, element::Tet10>;
TYPED_TEST_SUITE(NodalGradients, Types);

TYPED_TEST(NodalGradients, DifferentiateAgreesWithTheGradientTableAndAssembleIsItsTranspose) {
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
  NodalGradient<TypeParam>::differentiate(field, slope);
  NodalGradient<TypeParam>::assemble(flux, nodal);
  for (int q = 0; q < TypeParam::points; ++q) {
    for (int k = 0; k < 3; ++k) {
      double expected = 0.0;
      for (int a = 0; a < TypeParam::nodes; ++a) {
        expected += field[a] * TypeParam::gradient(TypeParam::places[q], a, k);
      }
      EXPECT_NEAR(slope[q][k], expected, 1e-14);
    }
  }
  for (int a = 0; a < TypeParam::nodes; ++a) {
    double expected = 0.0;
    for (int q = 0; q < TypeParam::points; ++q) {
      for (int k = 0; k < 3; ++k) {
        expected += flux[q][k] * TypeParam::gradient(TypeParam::places[q], a, k);
      }
    }
    EXPECT_NEAR(nodal[a], expected, 1e-14);
  }
}

}  // namespace
}  // namespace idiophone::solid
