#include "idiophone/solids/solid/relaxation.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace idiophone::solid {
namespace {

scene::LossFactor loss(double value, double low, double high, std::optional<int> mechanisms = {}) {
  return {value, {low, high}, mechanisms, {}};
}

TEST(Relaxation, KeepsTheLossFactorWithinFivePercentThroughoutTheBand) {
  for (const double value : {1e-5, 3e-4, 0.01, 0.1, 0.3}) {
    for (const double decades : {0.1, 0.5, 1.0, 1.7, 2.3, 3.0, 4.0, 6.0}) {
      const double high = 20 * std::pow(10, decades);
      const Relaxation relaxation = fit_relaxation(loss(value, 20, high));
      for (int i = 0; i <= 1000; ++i) {
        const auto m = relaxation.modulus(2 * std::numbers::pi * 20 * std::pow(10, decades * i / 1000));
        EXPECT_NEAR(m.imag() / m.real() / value, 1.0, 0.048) << value << ", " << decades << " decades";
      }
      EXPECT_NEAR(relaxation.modulus(2 * std::numbers::pi * std::sqrt(20 * high)).real(), 1.0, 1e-12);
      EXPECT_GT(relaxation.long_term, 0.0);
      for (const auto& [strength, rate] : relaxation.mechanisms) {
        EXPECT_GT(strength, 0.0);
      }
    }
  }
}

TEST(Relaxation, TakesAboutOneMechanismForADecadeAndOneMore) {
  EXPECT_EQ(fit_relaxation(loss(1e-3, 200, 400)).mechanisms.size(), 1U);
  EXPECT_EQ(fit_relaxation(loss(1e-3, 20, 200)).mechanisms.size(), 2U);
  EXPECT_EQ(fit_relaxation(loss(1e-3, 20, 2000)).mechanisms.size(), 3U);
  EXPECT_EQ(fit_relaxation(loss(1e-3, 20, 20000)).mechanisms.size(), 4U);
  EXPECT_EQ(fit_relaxation(loss(1e-3, 20, 20000, 6)).mechanisms.size(), 6U);
}

scene::LossFactor measured_loss(const std::vector<scene::LossFactor::Point>& curve) {
  scene::LossFactor measured = loss(0.0, curve.front().frequency, curve.back().frequency);
  measured.curve = curve;
  measured.value = std::ranges::max(curve, {}, &scene::LossFactor::Point::value).value;
  return measured;
}

/// The largest error of tan(phi), of itself.
double largest_error(const Relaxation& relaxation, const scene::LossFactor& measured) {
  double largest = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    const double frequency = measured.band[0] * std::pow(measured.band[1] / measured.band[0], i / 1000.0);
    const auto m = relaxation.modulus(2 * std::numbers::pi * frequency);
    largest = std::max(largest, std::abs(m.imag() / m.real() / measured.at(frequency) - 1));
  }
  return largest;
}

TEST(Relaxation, KeepsASmoothCurveWithinFivePercent) {
  for (const scene::LossFactor& measured :
       {measured_loss({{50, 0.006}, {500, 0.008}, {15000, 0.02}}), measured_loss({{200, 0.004}, {2000, 0.001}})}) {
    const Relaxation relaxation = fit_relaxation(measured);
    EXPECT_LT(largest_error(relaxation, measured), 0.048);
    EXPECT_LE(relaxation.mechanisms.size(), 4U);
  }
}

TEST(Relaxation, TellsHowFarACurveWithCornersIsKept) {
  const scene::LossFactor scattered =
      measured_loss({{100, 0.02}, {200, 0.024}, {400, 0.019}, {800, 0.026}, {1600, 0.02}});
  const Relaxation relaxation = fit_relaxation(scattered);
  EXPECT_NEAR(largest_error(relaxation, scattered), relaxation.deviation, 0.005);
  EXPECT_GT(relaxation.deviation, 0.08);
  EXPECT_LT(relaxation.deviation, 0.13);
  EXPECT_LE(relaxation.mechanisms.size(), 4U);
  for (const auto& [strength, rate] : relaxation.mechanisms) {
    EXPECT_GT(strength, 0.0);
  }
}

TEST(Relaxation, LimitsAreThoseOfItsSprings) {
  const Relaxation relaxation = fit_relaxation(loss(0.1, 20, 20000));
  EXPECT_NEAR(relaxation.modulus(1e-9).real(), relaxation.long_term, 1e-9);
  EXPECT_NEAR(relaxation.modulus(1e12).real(), relaxation.instantaneous(), 1e-9);
  const double high = 1e9;
  const auto m = relaxation.modulus(high);
  EXPECT_NEAR(m.imag() / m.real() * high / relaxation.instantaneous_damping(), 1.0, 1e-6);
}

TEST(Relaxation, CreepIsADashpotInSeries) {
  constexpr double rate = 7.0;
  for (const Relaxation& own : {Relaxation{}, fit_relaxation(loss(0.05, 100, 5000))}) {
    const Relaxation both = creeping(own, rate);
    EXPECT_EQ(both.long_term, 0.0);
    EXPECT_NEAR(both.instantaneous(), own.instantaneous(), 1e-12);
    for (const double w : {0.1, 7.0, 300.0, 1e4, 1e6}) {
      const std::complex<double> s(0, w);
      EXPECT_LT(std::abs(both.modulus(w) - own.modulus(w) * s / (s + rate)), 1e-12) << w;
    }
  }
}

std::string complaint(const scene::LossFactor& impossible) {
  try {
    (void)fit_relaxation(impossible);
  } catch (const deck::DeckError& error) {
    return error.what();
  }
  return "none";
}

TEST(Relaxation, RefusesNumbersOfMechanismsThatDoNotKeepIt) {
  EXPECT_THAT(complaint(loss(0.01, 20, 20000, 2)),
              testing::HasSubstr("2 mechanisms can't keep the loss factor 0.01 within 5 % from 20 to 20000 Hz: 4 can"));
  EXPECT_THAT(complaint(loss(0.01, 20, 30, 9)), testing::HasSubstr("9 mechanisms can't keep"));
  EXPECT_THAT(complaint(loss(0.01, 1e-9, 1e6)), testing::HasSubstr("make the band narrower"));
  EXPECT_THAT(
      complaint(measured_loss({{1000, 0.001}, {1100, 0.1}, {1200, 0.001}})),
      testing::HasSubstr("12 mechanisms can't keep the loss factor over the frequency within 25 %: make it rise "
                         "and fall more gently"));
}

}  // namespace
}  // namespace idiophone::solid
