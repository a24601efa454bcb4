// Waves from edges, against the exact field of a point source beside a rigid wedge.

#include "idiophone/air/radiation/bend.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "wave_spectrum.hpp"

namespace idiophone::radiation {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

/// An edge along y from y = -50 m to 50 m. Angles are from the first face, which is x < 0 of the plane z = 0.
DiffractingEdge edge_of(double angle) {
  return {Vector3(0, -50, 0), Vector3(0, 50, 0), -Vector3::UnitX(), Vector3::UnitZ(), angle};
}

Vector3 place(double radius, double angle, double along) {
  return {-radius * std::cos(angle), along, radius * std::sin(angle)};
}

/// Sum of f(u) times exp(-u^2) over u > 0.
template <class Function>
Complex integral(const Function& f) {
  constexpr double step = 1e-3;
  Complex sum = 0.0;
  for (double u = 0.5 * step; u < 6.0; u += step) {
    sum += step * std::exp(-u * u) * f(u);
  }
  return sum;
}

/// What the exact wave from an edge is at an angular frequency, over that of the source at the distance by way of the
/// edge: Svensson, Fred and Vanderkooy 1999 along the path of steepest descent, ways = length - i u^2/wave_number.
Complex exact(double frequency, double air, double source_angle, double receiver_angle, double source_radius,
              double receiver_radius, double along) {
  const double index = pi / air, wave_number = 2 * pi * frequency / sound_speed;
  const double length = std::hypot(source_radius + receiver_radius, along);
  return -index / (2 * pi) * length * integral([&](double u) {
    const Complex way = length - Complex(0, u * u / wave_number);
    const Complex cosh =
        (way * way - source_radius * source_radius - receiver_radius * receiver_radius - along * along) /
        (2 * source_radius * receiver_radius);
    const Complex eta = std::acosh(cosh);
    Complex beta = 0.0;
    for (const double image : {source_angle, -source_angle}) {
      for (const double side : {1.0, -1.0}) {
        const double angle = index * (pi + side * (receiver_angle - image));
        beta += std::sin(angle) / (std::cosh(index * eta) - std::cos(angle));
      }
    }
    return beta * Complex(0, -2 * u / wave_number) / (source_radius * receiver_radius * std::sinh(eta));
  });
}

Bend find_bend(const DiffractingEdge& edge, const Vector3& source, const Vector3& receiver) {
  return radiation::find_bend(EdgesInTurn{.edges = {edge}}, source, receiver, sound_speed);
}

/// The largest error in the shadow, dB.
double largest_error(double air) {
  double largest = 0.0;
  for (const double source_angle : {0.1, 0.6, 1.2}) {
    for (const double beyond : {0.05, 0.3, 1.0}) {
      const double receiver_angle = source_angle + pi + beyond;
      for (const auto& [source_radius, receiver_radius, along] :
           {std::array{1.0, 0.7, 0.0}, std::array{0.1, 3.0, 1.5}, std::array{2.0, 2.0, 4.0}}) {
        const Bend bend = find_bend(edge_of(air), place(source_radius, source_angle, 0.0),
                                    place(receiver_radius, receiver_angle, along));
        for (const double frequency : {63.0, 250.0, 1000.0, 4000.0}) {
          if (receiver_angle < air) {
            EXPECT_GT(bend.gain, 0.0);
            const double ratio =
                std::abs(spectrum_of(bend, frequency)) /
                std::abs(exact(frequency, air, source_angle, receiver_angle, source_radius, receiver_radius, along));
            largest = std::max(largest, std::abs(20 * std::log10(ratio)));
          }
        }
      }
    }
  }
  return largest;
}

TEST(DiffractingEdge, OfAScreenHasTheExactLevels) {
  EXPECT_LT(largest_error(2 * pi), 0.6);
}

TEST(DiffractingEdge, OfAWedgeIsNearTheExactLevels) {
  EXPECT_LT(largest_error(1.5 * pi), 1.6);   // of a box
  EXPECT_LT(largest_error(1.75 * pi), 1.6);  // of a roof of 45 degrees
}

TEST(DiffractingEdge, IsContinuousWhereTheShadowBegins) {
  for (const double air : {1.5 * pi, 2 * pi}) {
    for (const double source_angle : {0.2, 1.0}) {
      const auto level = [&](double beyond) {
        const Vector3 source = place(1.0, source_angle, 0.0), receiver = place(2.0, source_angle + pi + beyond, 0.3);
        const Bend bend = find_bend(edge_of(air), source, receiver);
        return std::abs(spectrum_of(bend, 500.0) + (beyond < 0 ? 1.0 : 0.0));
      };
      EXPECT_NEAR(level(1e-8) / level(-1e-8), 1.0, 1e-2);
    }
  }
}

TEST(DiffractingEdge, ActsNeitherBesideItsEndsNorFarFromTheShadow) {
  const DiffractingEdge edge = edge_of(1.5 * pi);
  EXPECT_GT(find_bend(edge, place(1, 0.3, 49), place(1, 4, 49)).gain, 0.0);
  EXPECT_EQ(find_bend(edge, place(1, 0.3, 51), place(1, 4, 51)).gain, 0.0);
  EXPECT_EQ(find_bend(edge, place(1, 0.3, 0), place(1, 2.0, 0)).gain, 0.0);
}

TEST(DiffractingEdge, TurnedIsTheSame) {
  const DiffractingEdge edge = edge_of(1.6 * pi);
  const Bend one = find_bend(edge, place(1, 0.3, 0), place(2, 4, 1));
  const Bend other = find_bend(edge.turned(), place(1, 0.3, 0), place(2, 4, 1));
  ASSERT_GT(one.gain, 0.0);
  EXPECT_NEAR(one.waves[0][0].delay, other.waves[0][0].delay, 1e-12);
  EXPECT_NEAR(one.waves[0][0].gain, other.waves[0][0].gain, 1e-12);
}

}  // namespace
}  // namespace idiophone::radiation
