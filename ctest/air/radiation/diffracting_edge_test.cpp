// Waves from edges, against the exact field of a point source beside a rigid wedge.

#include "idiophone/air/radiation/diffracting_edge.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace idiophone::radiation {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

constexpr double sound_speed = 343.0;

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

/// The same of a wave of this program: the response sqrt(d)/(2 pi (t + d) sqrt(t)) at times t = -i d tan(x)^2.
Complex spectrum(double delay, double frequency) {
  constexpr double step = 1e-4;
  Complex sum = 0.0;
  for (double x = 0.5 * step; x < 0.5 * pi; x += step) {
    const double square = std::pow(std::tan(x), 2);
    sum += step * (1.0 + square) * std::exp(-2 * pi * frequency * delay * square) / Complex(1.0, -square);
  }
  return sum / pi * std::sqrt(Complex(0, -1));
}

Complex of_bend(const Bend& bend, double frequency) {
  return bend.direct.gain * spectrum(bend.direct.delay, frequency) +
         bend.mirrored.gain * spectrum(bend.mirrored.delay, frequency);
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
                                    place(receiver_radius, receiver_angle, along), sound_speed);
        for (const double frequency : {63.0, 250.0, 1000.0, 4000.0}) {
          if (receiver_angle < air) {
            EXPECT_TRUE(bend.exists);
            const double ratio =
                std::abs(of_bend(bend, frequency)) /
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
        const Bend bend = find_bend(edge_of(air), source, receiver, sound_speed);
        return std::abs(of_bend(bend, 500.0) + (beyond < 0 ? 1.0 : 0.0));
      };
      EXPECT_NEAR(level(1e-8) / level(-1e-8), 1.0, 1e-2);
    }
  }
}

TEST(DiffractingEdge, ActsNeitherBesideItsEndsNorFarFromTheShadow) {
  const DiffractingEdge edge = edge_of(1.5 * pi);
  EXPECT_TRUE(find_bend(edge, place(1, 0.3, 49), place(1, 4, 49), sound_speed).exists);
  EXPECT_FALSE(find_bend(edge, place(1, 0.3, 51), place(1, 4, 51), sound_speed).exists);
  EXPECT_FALSE(find_bend(edge, place(1, 0.3, 0), place(1, 2.0, 0), sound_speed).exists);
}

TEST(DiffractingEdge, TurnedIsTheSame) {
  const DiffractingEdge edge = edge_of(1.6 * pi);
  const Bend one = find_bend(edge, place(1, 0.3, 0), place(2, 4, 1), sound_speed);
  const Bend other = find_bend(edge.turned(), place(1, 0.3, 0), place(2, 4, 1), sound_speed);
  ASSERT_TRUE(one.exists && other.exists);
  EXPECT_NEAR(one.direct.delay, other.direct.delay, 1e-12);
  EXPECT_NEAR(one.direct.gain, other.direct.gain, 1e-12);
}

/// The two upper edges of a wall, which is `thickness` m thick and stands below z = 0.
std::array<DiffractingEdge, 2> thick_wall(double thickness) {
  const Vector3 behind(thickness, 0, 0);
  const DiffractingEdge near{Vector3(0, -50, 0), Vector3(0, 50, 0), Vector3::UnitX(), Vector3::UnitZ(), 1.5 * pi};
  return {near, {near.begin + behind, near.end + behind, -Vector3::UnitX(), Vector3::UnitZ(), 1.5 * pi}};
}

TEST(TwoEdges, AreCrossedOnTheShortestWay) {
  const auto [near, far] = thick_wall(0.5);
  const Vector3 source(-1.0, 0.0, -2.0), receiver(1.1, 1.0, -0.7);
  const DoubleBend bend = find_double_bend(near, far, source, receiver, sound_speed);
  ASSERT_TRUE(bend.exists);
  const auto length = [&](double first, double last) {
    return (Vector3(0, first, 0) - source).norm() + Vector3(0.5, last - first, 0).norm() +
           (receiver - Vector3(0.5, last, 0)).norm();
  };
  const double first = bend.apexes[0].y(), last = bend.apexes[1].y();
  EXPECT_NEAR(bend.apexes[0].x(), 0.0, 1e-12);
  EXPECT_NEAR(bend.apexes[1].x(), 0.5, 1e-12);
  for (const double step : {-0.01, 0.01}) {
    EXPECT_LT(length(first, last), length(first + step, last));
    EXPECT_LT(length(first, last), length(first, last + step));
  }
}

TEST(TwoEdges, AreReciprocal) {
  const auto [near, far] = thick_wall(0.5);
  const Vector3 source(-1.0, 0.0, -2.0), receiver(1.1, 1.0, -0.7);
  const DoubleBend there = find_double_bend(near, far, source, receiver, sound_speed);
  const DoubleBend back = find_double_bend(far, near, receiver, source, sound_speed);
  EXPECT_NEAR(there.gain, back.gain, 1e-12);
  EXPECT_NEAR(there.delays[0], back.delays[1], 1e-12);
  EXPECT_NEAR(there.delays[1], back.delays[0], 1e-12);
}

/// Behind the second edge its wave takes over from that of the first one alone.
TEST(TwoEdges, GoOnFromOneEdge) {
  const auto [near, far] = thick_wall(0.5);
  const Vector3 source(-1.0, 0.0, -1.0);
  const auto level = [&](double height) {
    const Vector3 receiver(2.0, 0.0, height);  // the first edge is in sight above 0
    const DoubleBend both = find_double_bend(near, far, source, receiver, sound_speed);
    EXPECT_TRUE(both.exists);
    const Complex two = both.gain * spectrum(both.delays[0], 1000.0) * spectrum(both.delays[1], 1000.0);
    return std::abs(two + (height > 0 ? of_bend(find_bend(near, source, receiver, sound_speed), 1000.0) : 0.0));
  };
  EXPECT_NEAR(level(-1e-8) / level(1e-8), 1.0, 0.01);
}

}  // namespace
}  // namespace idiophone::radiation
