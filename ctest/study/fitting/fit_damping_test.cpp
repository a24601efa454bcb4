#include "fit_damping.hpp"
#include "ranks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace idiophone::fitting {
namespace {

/// Decays of a material at some frequencies.
std::vector<Decay> decays_of(double mass, double stiffness, double loss, const std::vector<double>& frequencies) {
  std::vector<Decay> decays;
  for (const double frequency : frequencies) {
    const double w = 2 * std::numbers::pi * frequency;
    decays.push_back({frequency, 2 * std::log(1000.0) / (mass + stiffness * w * w + loss * w)});
  }
  return decays;
}

ON_RANKS(1);

TEST(FitDamping, FindsAllThree) {
  const auto found = fit_damping(decays_of(3, 1e-8, 1e-3, {100, 300, 1000, 3000, 8000, 15000}));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->mass, 3, 1e-6);
  EXPECT_NEAR(found->stiffness / 1e-8, 1, 1e-6);
  EXPECT_NEAR(found->loss.value().value, 1e-3, 1e-9);
}

TEST(FitDamping, NoneIsBelowZero) {
  const auto found = fit_damping(decays_of(0, 2e-8, 0, {100, 300, 1000, 3000, 8000, 15000}));
  EXPECT_EQ(found->mass, 0);
  EXPECT_NEAR(found->stiffness, 2e-8, 1e-12);
  EXPECT_FALSE(found->loss);
}

TEST(FitDamping, OneDecayGivesOneNumber) {
  const auto found = fit_damping(decays_of(0, 0, 5e-3, {150e3}));
  EXPECT_EQ(found->mass, 0);
  EXPECT_EQ(found->stiffness, 0);
  EXPECT_NEAR(found->loss.value().value, 5e-3, 1e-9);
  EXPECT_GT(found->loss->band[1], 150e3);
  EXPECT_FALSE(fit_damping({}));
}

}  // namespace
}  // namespace idiophone::fitting
