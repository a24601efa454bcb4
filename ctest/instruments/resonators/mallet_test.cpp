#include "idiophone/instruments/resonators/mallet.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "touched_body.hpp"

namespace idiophone::resonators {

namespace {

constexpr score::Hammer hammer{.mass = 0.02, .hardness = 1e6, .speed = 1.0};  // 1.4 ms on a rigid body

/// A mode that is too slow to swing while something touches it: a mass that is free to move.
TouchedMode free_mass(double mass) {
  return {.frequency = 0.01, .decay = 0.0, .participation = 1.0 / std::sqrt(mass)};
}

/// How long a force acts, s.
double duration(const std::vector<double>& force) {
  return static_cast<double>(std::ranges::count_if(force, [](double f) { return f > 0.0; })) / rate;
}

}  // namespace

TEST(Mallet, TouchesARigidBodyAsLongAsHertzFound) {
  Mallet mallet(hammer, 0.0, rate);
  TouchedBody body({free_mass(1e12)}, mallet);
  body.advance(500);
  EXPECT_NEAR(duration(body.force()), hammer.contact_duration(), 1.0 / rate);
  const double deepest = std::pow(1.25 * hammer.mass * hammer.speed * hammer.speed / hammer.hardness, 0.4);
  EXPECT_NEAR(*std::ranges::max_element(body.force()) / (hammer.hardness * std::pow(deepest, 1.5)), 1.0, 2e-3);
  EXPECT_NEAR(mallet.speed(), -hammer.speed, 1e-9);
  EXPECT_TRUE(mallet.is_over());
}

TEST(Mallet, SharesItsMomentumWithABodyThatIsFree) {
  constexpr double mass = 0.03;
  Mallet mallet(hammer, 0.0, rate);
  TouchedBody body({free_mass(mass)}, mallet);
  body.advance(500);
  const double sum = hammer.mass + mass;
  EXPECT_NEAR(mallet.speed(), (hammer.mass - mass) / sum, 1e-5);
  EXPECT_NEAR(body.velocity().back(), 2.0 * hammer.mass / sum, 1e-3);
  score::Hammer reduced = hammer;
  reduced.mass = hammer.mass * mass / sum;
  EXPECT_NEAR(duration(body.force()), reduced.contact_duration(), 1.0 / rate);
}

TEST(Mallet, LosesWhatHuntAndCrossleySay) {
  // For small losses the speed of return is 1 - 2/3 loss speed of that before (K. H. Hunt, F. R. E. Crossley).
  const auto returned = [](double loss) {
    Mallet mallet(hammer, loss, rate);
    TouchedBody body({free_mass(1e12)}, mallet);
    body.advance(500);
    return -mallet.speed();
  };
  EXPECT_NEAR(1.0 - returned(0.01), 0.01 * 2.0 / 3.0, 2e-4);
  EXPECT_LT(returned(0.5), returned(0.1));
  EXPECT_GT(returned(0.5), 0.0);
}

TEST(Mallet, GivesTheModesWhatItLoses) {
  std::vector<TouchedMode> modes;
  for (int n = 1; n < 40; ++n) {
    modes.push_back({.frequency = 90.0 * n * std::sqrt(n), .decay = 0.0, .participation = 6.0 * std::cos(n)});
  }
  for (const double loss : {0.0, 0.3}) {
    Mallet mallet(hammer, loss, rate);
    TouchedBody body(modes, mallet);
    const auto energy = [&] {
      return 0.5 * hammer.mass * mallet.speed() * mallet.speed() + mallet.stored_energy() + body.energy();
    };
    const double whole = energy();
    double before = whole;
    for (int i = 0; i < 3000; ++i) {
      body.advance(1);
      ASSERT_LE(energy(), before + 1e-14 * whole) << i;
      before = energy();
    }
    EXPECT_GT(body.energy(), 0.05 * whole);
    if (loss == 0.0) {
      EXPECT_NEAR(energy(), whole, 1e-12 * whole);
    }
  }
}

}  // namespace idiophone::resonators
