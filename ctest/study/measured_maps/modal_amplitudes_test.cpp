#include "modal_amplitudes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "force_transform.hpp"

namespace idiophone::measured_maps {
namespace {

using Complex = std::complex<double>;

constexpr std::array frequency = {310.0, 870.0, 1730.0, 2950.0, 4100.0};
constexpr std::size_t blows = 6;

/// Modes of real shapes, at two microphones.
std::vector<Heard> heard_by_two() {
  std::vector<Heard> heard(frequency.size(), Heard(blows));
  for (std::size_t mode = 0; mode < heard.size(); ++mode) {
    for (std::size_t blow = 0; blow < blows; ++blow) {
      const double shape = std::cos(1.0 + static_cast<double>((mode + 1) * blow));
      heard[mode][blow] = {shape * std::polar(1.0, 0.4 * static_cast<double>(mode)), shape * Complex(0.3, -0.5)};
    }
  }
  return heard;
}

TEST(ModalAmplitudes, AreAlignedThoughTheTimesOfBlowsAreWrong) {
  const std::vector<Heard> right = heard_by_two();
  std::vector<Heard> heard = right;
  constexpr std::array late = {0.0, 4e-4, -3e-4, 1e-4, 7e-4, -5e-4};  // s
  for (std::size_t mode = 0; mode < heard.size(); ++mode) {
    for (std::size_t blow = 0; blow < blows; ++blow) {
      for (Complex& number : heard[mode][blow]) {
        number *= std::polar(1.0, -2 * std::numbers::pi * frequency[mode] * late[blow]);
      }
    }
  }
  align(heard, frequency, std::vector<bool>(blows, false));
  for (std::size_t mode = 0; mode < heard.size(); ++mode) {
    const SeparatedMode found = separate(heard[mode]), expected = separate(right[mode]);
    const double sign = found.strength[0] * expected.strength[0] > 0 ? 1.0 : -1.0;
    for (std::size_t blow = 0; blow < blows; ++blow) {
      EXPECT_NEAR(sign * found.strength[blow], expected.strength[blow], 0.1) << mode << " " << blow;
    }
  }
}

TEST(ModalAmplitudes, AreProductsOfStrengthAndPressure) {
  for (const Heard& mode : heard_by_two()) {
    const SeparatedMode separated = separate(mode);
    double square = 0.0;
    for (std::size_t blow = 0; blow < blows; ++blow) {
      square += std::pow(separated.strength[blow], 2) / blows;
      for (const std::size_t m : {0, 1}) {
        EXPECT_NEAR(std::abs(separated.strength[blow] * separated.pressure[m] - mode[blow][m]), 0, 1e-9);
      }
    }
    EXPECT_NEAR(square, 1, 1e-9);
  }
}

TEST(ForceTransform, OfAHalfSineIsThatOfItsTable) {
  RecordedBlow half_sine;
  half_sine.impulse = 0.02;
  half_sine.contact = 1e-3;
  RecordedBlow table;
  for (int i = 0; i <= 400; ++i) {
    const double time = 1e-3 * i / 400;
    table.force.push_back({time, 10 * std::numbers::pi * std::sin(std::numbers::pi * time / 1e-3)});
  }
  for (const double hertz : {0.0, 600.0, 1000.0, 2100.0}) {
    const Complex exponent(-20, 2 * std::numbers::pi * hertz);
    const double x = 2 * std::numbers::pi * hertz * 1e-3;
    const double exact =
        std::abs(std::pow(std::numbers::pi, 2) * 2 * std::cos(x / 2) / (std::pow(std::numbers::pi, 2) - x * x)) * 0.01;
    EXPECT_NEAR(std::abs(force_transform(half_sine, exponent)), exact, 3e-4) << hertz;
    EXPECT_NEAR(std::abs(force_transform(half_sine, exponent) - force_transform(table, exponent)), 0, 1e-6) << hertz;
  }
  EXPECT_NEAR(std::abs(force_transform(half_sine, Complex(0, 2 * std::numbers::pi * 1500))), 4e-4, 1e-6)
      << "a blow that does not drive the mode";
}

}  // namespace
}  // namespace idiophone::measured_maps
