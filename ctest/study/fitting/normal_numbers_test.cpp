// Random numbers with a normal distribution.

#include <gtest/gtest.h>

#include <cmath>

#include "idiophone/foundation/random_numbers.hpp"
#include "ranks.hpp"

namespace idiophone {
namespace {

ON_RANKS(1);

/// The generator is that of the standard, whose numbers are the same everywhere; these come from it by the polar
/// method.
TEST(NormalNumbers, AreTheSameEverywhere) {
  NormalNumbers numbers;
  for (const double expected : {-0.687125849028184, 0.789845949116994, 0.201126154863234, 0.094861313337630}) {
    EXPECT_NEAR(numbers.next(), expected, 1e-14);
  }
}

TEST(NormalNumbers, HaveTheMomentsOfTheNormalDistribution) {
  constexpr int count = 100'000;
  NormalNumbers numbers;
  double mean = 0.0, square = 0.0, fourth = 0.0;
  for (int i = 0; i < count; ++i) {
    const double number = numbers.next();
    mean += number / count;
    square += number * number / count;
    fourth += std::pow(number, 4) / count;
  }
  EXPECT_NEAR(mean, 0, 0.015);
  EXPECT_NEAR(square, 1, 0.02);
  EXPECT_NEAR(fourth, 3, 0.15);
}

}  // namespace
}  // namespace idiophone
