#include "page_body.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "heard_sound.hpp"

namespace idiophone::page_sound {

namespace {

constexpr int rate = 44100;

/// A string of 20 harmonics that is heard by the velocity of its modes.
struct String {
  std::vector<double> frequency, decay, pressure;
  Participation place;

  /// @param lowest  Hz
  explicit String(double lowest) {
    for (int n = 1; n <= 20; ++n) {
      frequency.push_back(n * lowest);
      decay.push_back(2.0 + 0.1 * n * n);
      pressure.insert(pressure.end(), {1.0, 0.0});
      place.push_back(40.0 * std::sin(n * std::numbers::pi / 7.0));
    }
  }

  [[nodiscard]] PageBody body() const {
    PageBody body(frequency.size(), 1, rate);
    body.tune({.frequency = frequency, .decay = decay, .pressure = pressure});
    return body;
  }
};

std::vector<double> rendered(PageBody& body, std::int64_t first, std::size_t samples) {
  std::vector<double> sound(samples);
  EXPECT_TRUE(body.render(first, sound));
  return sound;
}

}  // namespace

TEST(PageBody, BowedStringSingsAtItsPitchUntilTheBowIsLifted) {
  const String string(196.0);
  PageBody body = string.body();
  body.put_bow(1, {}, string.place);
  body.lead_bow(1, {.speed = 0.2, .load = 0.3}, string.place);
  (void)rendered(body, 0, rate / 2);
  const std::vector<double> singing = rendered(body, rate / 2, rate / 2);
  const std::span<const double> all(singing);
  EXPECT_NEAR(support::root_mean_square(all.first(rate / 4)) / support::root_mean_square(all.last(rate / 4)), 1.0,
              0.05);
  EXPECT_NEAR(1200.0 * std::log2(support::pitch(singing, 192.6, 199.4, rate) / 196.0), 0.0, 10.0);

  body.lift_bow(1);
  (void)rendered(body, rate, rate / 2);  // the other modes have faded then
  const double before = support::root_mean_square(rendered(body, rate * 3 / 2, rate / 4));
  const double after = support::root_mean_square(rendered(body, rate * 7 / 4, rate / 4));
  EXPECT_NEAR(std::log(before / after) / 0.25, string.decay.front(), 0.1 * string.decay.front());
}

TEST(PageBody, IsSilentUntilItIsStruckAndAfterItHasFaded) {
  const String string(196.0);
  PageBody body = string.body();
  std::vector<double> sound(128, 7.0);
  EXPECT_FALSE(body.render(0, sound));
  EXPECT_EQ(sound.front(), 7.0);
  body.strike(128, resonators::ForceCurve(10, resonators::linear_piece(1.0, 1.0)), string.place);
  EXPECT_GT(support::root_mean_square(rendered(body, 128, 4096)), 0.0);
  (void)rendered(body, 4096 + 128, 50 * rate);
  EXPECT_FALSE(body.render(4096 + 128 + 50 * rate, sound));
}

}  // namespace idiophone::page_sound
