// Spheres that pulsate and oscillate, against the exact sound.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ranks.hpp"
#include "ringing.hpp"

namespace idiophone::waves {
namespace {

constexpr double sphere_radius = 0.1;  // m
const Vector3 oblique_axis = Vector3(1, 2, 2).normalized();

/// Pressure of a sphere that moves as the Legendre polynomial of an order, with the time factor exp(i w t).
Complex exact(int order, double frequency, const Vector3& point) {
  const double k = 2.0 * std::numbers::pi * frequency / speed;
  const auto hankel = [](int l, double x) { return Complex(std::sph_bessel(l, x), -std::sph_neumann(l, x)); };
  const auto slope = [&](int l, double x) { return hankel(l, x) * (l / x) - hankel(l + 1, x); };
  return Complex(0.0, -impedance) * hankel(order, k * point.norm()) / slope(order, k * sphere_radius) *
         (order == 0 ? 1.0 : point.normalized().dot(oblique_axis));
}

std::vector<Vector3> places_around() {
  std::vector<Vector3> all;
  for (const Vector3& direction :
       {Vector3(oblique_axis), Vector3(1, 0, 0), Vector3(0, -1, 1), Vector3(-1, -1, -1), Vector3(0, 0, 1)}) {
    all.push_back(direction.normalized());
  }
  return all;
}

/// Largest error in mean square over the points, dB, of several frequencies.
std::vector<double> errors(int order, double cell, std::span<const double> frequencies) {
  const auto solid = radiation::icosphere(sphere_radius, 8);
  const Ringing ringing{.solid = solid, .cell = cell, .shape = [order](const Vector3&, const Vector3& normal) {
                          return order == 0 ? 1.0 : normal.dot(oblique_axis);
                        }};
  const auto places = places_around();
  const Responses heard = ring(ringing, frequencies, places);
  std::vector<double> all;
  for (std::size_t f = 0; f < frequencies.size(); ++f) {
    std::vector<Complex> right(places.size());
    std::ranges::transform(places, right.begin(),
                           [&](const Vector3& place) { return exact(order, frequencies[f], place); });
    all.push_back(level(heard[f], right));
  }
  return all;
}

class Sphere : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(, Sphere, testing::Values(0, 1));

ON_RANKS(1);

TEST_P(Sphere, IsHeardAsItPulsatesOrOscillates) {
  const std::array frequencies = {200.0, 1000.0, 2000.0, 4000.0};
  const auto coarse = errors(GetParam(), 0.016, std::span(frequencies).first(3));
  const auto fine = errors(GetParam(), 0.008, frequencies);
  for (const double error : coarse) {
    EXPECT_NEAR(error, 0.0, 0.15);
  }
  for (const double error : fine) {
    EXPECT_NEAR(error, 0.0, 0.15);
  }
  EXPECT_LT(std::abs(fine[2]), 0.6 * std::abs(coarse[2]));
}

}  // namespace
}  // namespace idiophone::waves
