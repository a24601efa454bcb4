#include "idiophone/instruments/resonators/bow.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "string_modes.hpp"
#include "touched_body.hpp"

namespace idiophone::resonators {

namespace {

score::Bow steady_bow(double speed, double load) {
  score::Bow bow;
  bow.speed.points = {{0.0, speed}};
  bow.load.points = {{0.0, load}};
  return bow;
}

constexpr double g3 = 196.0;          // Hz
constexpr double string_mass = 1e-3;  // kg

/// The amplitude around the mean grows as exp(growth t) from some samples to as many after them, 1/s.
double growth(const std::vector<double>& velocity, std::size_t begin, std::size_t length) {
  const auto power = [&](std::size_t from) {
    const auto first = velocity.begin() + static_cast<std::ptrdiff_t>(from),
               last = first + static_cast<std::ptrdiff_t>(length);
    const double mean = std::accumulate(first, last, 0.0) / static_cast<double>(length);
    return std::accumulate(first, last, 0.0, [mean](double sum, double v) { return sum + (v - mean) * (v - mean); });
  };
  return 0.5 * std::log(power(begin + length) / power(begin)) * rate / static_cast<double>(length);
}

/// Audio samples at which a velocity falls below a value.
std::vector<std::size_t> falls(const std::vector<double>& velocity, double below) {
  std::vector<std::size_t> found;
  for (std::size_t i = 1; i < velocity.size(); ++i) {
    if (velocity[i] < below && velocity[i - 1] >= below) {
      found.push_back(i);
    }
  }
  return found;
}

}  // namespace

TEST(Bow, GivesTheModesAsMuchAsItsForceDoes) {
  score::Bow drawn = steady_bow(0.2, 1.0);
  drawn.speed.points = {{0.0, 0.0}, {0.05, 0.5}, {0.1, -0.3}};
  drawn.load.points = {{0.0, 0.1}, {0.08, 3.0}, {0.2, 0.0}};
  drawn.friction.damping = 0.5;
  Bow bow(drawn, rate);
  TouchedBody body(string_modes(g3, string_mass, 0.13, {}, 60), bow);
  double largest = 0.0, total_work = 0.0;
  for (int i = 0; i < 12000; ++i) {
    const double before = body.energy(), stored = bow.friction().stored_energy();
    const double speed = bow.motion().speed;
    body.advance(1);
    const double after = body.energy(), force = body.force().back(), velocity = body.velocity().back();
    largest = std::max(largest, after);
    ASSERT_NEAR(force * velocity / rate, after - before, 1e-14 * largest) << i;
    const double lost = force * (speed - velocity) / rate + stored - bow.friction().stored_energy();
    ASSERT_GE(lost, -1e-14 * largest) << i;
    total_work += force * speed / rate;
  }
  EXPECT_GT(total_work, body.energy());
  EXPECT_GT(body.energy(), 1e-6);
}

TEST(Bow, StartsAModeWhereTheForceFallsFasterThanTheModeLoses) {
  constexpr double frequency = 300.0, decay = 5.0, mass = 0.02, speed = 0.1;
  const friction::Law law{.sticking = 0.8, .sliding = 0.3, .stribeck_speed = 0.1, .stiffness = 1e6};
  const double ratio = speed / law.stribeck_speed;
  const double slope = -2.0 * ratio / law.stribeck_speed * (law.sticking - law.sliding) * std::exp(-ratio * ratio);
  const double limit = -2.0 * decay * mass / slope;  // N: the load at which 2 decay + slope load/mass = 0
  const auto growth_at = [&](double load) {
    score::Bow drawn = steady_bow(speed, load);
    drawn.friction = law;
    Bow bow(drawn, rate);
    TouchedBody body({{frequency, decay, 1.0 / std::sqrt(mass)}}, bow);
    body.advance(30000);
    return growth(body.velocity(), 10000, 8000);
  };
  const double below = growth_at(0.9 * limit), above = growth_at(1.1 * limit);
  const double found = limit * (0.9 + 0.2 * below / (below - above));
  EXPECT_NEAR(found / limit, 1.0, 0.02);
}

TEST(Bow, MakesAStringMoveAsHelmholtzFound) {
  // The string sticks to the bow for all of a period but the share at which it is bowed. Then it flies back.
  constexpr double share = 0.125, speed = 0.2, fly_back = speed * (1.0 - 1.0 / share);
  constexpr std::size_t periods = 50;
  score::Bow drawn = steady_bow(speed, 1.0);
  drawn.speed.points = {{0.0, 0.0}, {0.3, speed}};
  Bow bow(drawn, rate);
  TouchedBody body(string_modes(g3, string_mass, share, {.lowest = 2.0, .rise = 0.02}, 110), bow);
  body.advance(72000);
  const std::vector<std::size_t> slips = falls(body.velocity(), 0.5 * (speed + fly_back));
  ASSERT_GT(slips.size(), periods);
  const std::size_t first = slips[slips.size() - 1 - periods], last = slips.back();
  const double frequency = periods * static_cast<double>(rate) / static_cast<double>(last - first);
  EXPECT_LT(std::abs(1200.0 * std::log2(frequency / g3)), 5.0);
  double flown = 0.0, way = 0.0;
  for (std::size_t i = first; i < last; ++i) {
    if (body.velocity()[i] < 0.5 * (speed + fly_back)) {
      flown += 1.0;
      way += body.velocity()[i];
    }
  }
  EXPECT_NEAR(flown / static_cast<double>(last - first), share, 0.05 * share);
  EXPECT_NEAR(way / flown, fly_back, -0.1 * fly_back);
}

TEST(Bow, OthersAtTheSamePointShareTheLoad) {
  const std::vector<TouchedMode> modes = string_modes(g3, string_mass, 0.125, {.lowest = 2.0, .rise = 0.02}, 40);
  score::Bow whole = steady_bow(0.2, 1.0), half = steady_bow(0.2, 0.5);
  half.friction.stiffness *= 0.5;
  Bow alone(whole, rate), first(half, rate), other(half, rate);
  TouchedBody one(modes, alone), two(modes, first);
  two.add(other);
  one.advance(2000);
  two.advance(2000);
  for (std::size_t i = 0; i < 2000; ++i) {
    ASSERT_NEAR(two.velocity()[i], one.velocity()[i], 1e-6) << i;
  }
}

}  // namespace idiophone::resonators
