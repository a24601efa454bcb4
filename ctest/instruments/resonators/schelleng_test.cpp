// The loads between which a bowed string moves as Helmholtz found, against J. C. Schelleng, The bowed string and the
// player, J. Acoust. Soc. Am. 53, 1973.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "idiophone/instruments/resonators/bow.hpp"
#include "string_modes.hpp"
#include "touched_body.hpp"

namespace idiophone::resonators {

namespace {

constexpr std::size_t period = 245;                           // audio samples
constexpr double pitch = static_cast<double>(rate) / period;  // Hz
constexpr double mass = 1e-3;                                 // kg
constexpr double impedance = 2.0 * mass * pitch;              // N s/m
constexpr int mode_count = 60;

struct Bowed {
  double share;        ///< of the string's length at which it is bowed
  double speed;        ///< of the bow, m/s
  double decay = 2.0;  ///< of all modes, 1/s; a bridge of the resistance 2 impedance pitch/decay gives as much
  friction::Law friction{.sticking = 0.8, .sliding = 0.3, .stribeck_speed = 0.1, .stiffness = 7e5};

  /// The largest load, N: the corner of the string makes it slip.
  [[nodiscard]] double schelleng_largest() const {
    return 2.0 * impedance * speed / (share * (friction.sticking - friction.sliding));
  }
  /// The smallest load, N: the string does not slip before the corner comes, although the bridge gives way.
  [[nodiscard]] double schelleng_smallest() const {
    const double resistance = 2.0 * impedance * pitch / decay;
    return impedance * impedance * speed / (2.0 * resistance * share * share * (friction.sticking - friction.sliding));
  }
};

/// States of the modes in Helmholtz motion, in the middle of sticking.
std::vector<Complex> helmholtz_motion(const Bowed& bowed) {
  std::vector<Complex> states;
  for (int n = 1; n <= mode_count; ++n) {
    const double velocity = 2.0 * bowed.speed / (bowed.share * std::numbers::pi * n) * (n % 2 == 1 ? 1.0 : -1.0);
    states.emplace_back(velocity * std::sqrt(mass / 2.0));
  }
  return states;
}

/// How the string moves after the load has changed slowly from one at which it moves as Helmholtz found.
struct Found {
  double similarity;  ///< correlation of the velocity with that one period before
  double slips;       ///< in a period
};

Found motion_at(const Bowed& bowed, double load) {
  constexpr double warm = 100.0 / pitch, changes = 300.0 / pitch;  // s
  constexpr std::size_t judged = 40;                               // periods
  const double from = std::sqrt(bowed.schelleng_largest() * bowed.schelleng_smallest());
  score::Bow drawn;
  drawn.friction = bowed.friction;
  drawn.speed.points = {{0.0, bowed.speed}};
  drawn.load.points = {{0.0, from}};
  constexpr int steps = 30;
  for (int i = 0; i <= steps; ++i) {
    const double part = static_cast<double>(i) / steps;
    drawn.load.points.push_back({warm + part * changes, from * std::pow(load / from, part)});
  }
  Bow bow(drawn, rate);
  TouchedBody body(string_modes(pitch, mass, bowed.share, {.lowest = bowed.decay}, mode_count), bow);
  body.start(helmholtz_motion(bowed));
  body.advance(500 * period);
  const std::span<const double> velocity = std::span(body.velocity()).last(judged * period);
  const double slipping = bowed.speed - 0.2 * bowed.speed / bowed.share;
  double product = 0.0, square = 0.0;
  std::size_t slips = 0;
  for (std::size_t i = period; i < velocity.size(); ++i) {  // the mean is 0, as the string stays where it is
    product += velocity[i] * velocity[i - period];
    square += velocity[i] * velocity[i];
    slips += velocity[i] < slipping && velocity[i - 1] >= slipping ? 1 : 0;
  }
  return {product / square, static_cast<double>(slips) / (judged - 1)};
}

/// Between these loads, and not 20 % outside of them, the string moves as Helmholtz found.
void expect_limits(const Bowed& bowed) {
  EXPECT_GT(motion_at(bowed, 0.8 * bowed.schelleng_largest()).similarity, 0.9);
  EXPECT_LT(motion_at(bowed, 1.2 * bowed.schelleng_largest()).similarity, 0.9);
  EXPECT_LT(motion_at(bowed, 1.2 * bowed.schelleng_smallest()).slips, 1.05);
  EXPECT_GT(motion_at(bowed, 0.8 * bowed.schelleng_smallest()).slips, 1.5);
}

}  // namespace

TEST(BowedString, MovesAsHelmholtzFoundBetweenTheLoadsOfSchelleng) {
  for (const double share : {0.07, 0.1, 0.14}) {
    expect_limits({.share = share, .speed = 0.1});
  }
}

TEST(BowedString, KeepsHelmholtzMotionUnderLargerLoadsWithSoftBristles) {
  Bowed bowed{.share = 0.1, .speed = 0.1};
  bowed.friction.stiffness = 2e5;
  EXPECT_GT(motion_at(bowed, 1.5 * bowed.schelleng_largest()).similarity, 0.9);
}

}  // namespace idiophone::resonators
