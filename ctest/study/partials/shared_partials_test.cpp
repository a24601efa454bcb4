// Partials that recordings of blows at several points share.

#include "idiophone/study/partials/shared_partials.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sounds.hpp"

namespace idiophone::partials {
namespace {

constexpr double thousand = 6.907755278982137;  // ln 1000

/// Two partials half a width apart, and one alone, with amplitudes of each recording: a body struck at three points.
std::vector<std::vector<double>> struck(double noise) {
  const std::vector<std::array<double, 3>> amplitudes = {{1.0, 0.02, 0.3}, {-0.01, 0.8, 0.1}, {0.4, -0.6, -0.2}};
  std::vector<std::vector<double>> recordings;
  for (const auto& [first, second, third] : amplitudes) {
    const std::vector<Planted> planted = {{.frequency = 500.0, .amplitude = first, .decay_time = 0.5},
                                          {.frequency = 503.0, .amplitude = second, .decay_time = 0.6},
                                          {.frequency = 1740.0, .amplitude = third, .decay_time = 0.3}};
    recordings.push_back(sound(planted, 0.8, {.noise = noise, .seed = static_cast<unsigned>(recordings.size())}));
  }
  return recordings;
}

TEST(SharedPartials, HaveOneFrequencyAndASignInEachRecording) {
  const std::vector<SharedPartial> found = find_shared_partials(struck(1e-3), rate);
  ASSERT_EQ(found.size(), 3);
  const std::array frequencies = {500.0, 503.0, 1740.0};
  const std::array decay_times = {0.5, 0.6, 0.3};
  for (std::size_t n = 0; n < 3; ++n) {
    EXPECT_NEAR(found[n].frequency, frequencies[n], 0.01) << n;
    EXPECT_NEAR(found[n].decay, thousand / decay_times[n], 0.1) << n;
  }
  const std::complex<double> turn = std::polar(1.0, Planted{}.phase);
  EXPECT_NEAR(std::abs(found[0].amplitude[1] + 0.01 * turn), 0, 2e-3) << "40 dB below the partial beside it";
  EXPECT_NEAR(std::abs(found[1].amplitude[2] + 0.6 * turn), 0, 2e-3);
  EXPECT_NEAR(std::abs(found[2].amplitude[2] + 0.2 * turn), 0, 2e-3);
}

TEST(SharedPartials, AreBetterThanThoseOfOneRecording) {
  const std::vector<std::vector<double>> recordings = struck(0.05);
  const std::vector<SharedPartial> found = find_shared_partials(recordings, rate);
  ASSERT_EQ(found.size(), 3);
  EXPECT_NEAR(found[0].frequency, 500.0, 0.05);
  EXPECT_NEAR(found[1].frequency, 503.0, 0.05);
  EXPECT_LT(find_partials(recordings[0], rate).found.size(), 3) << "the second one is in its noise";
}

TEST(SharedPartials, LeaveHumOut) {
  std::vector<std::vector<double>> recordings = struck(1e-3);
  for (std::vector<double>& samples : recordings) {
    for (std::size_t n = 0; n < samples.size(); ++n) {
      samples[n] += 0.1 * std::sin(2 * std::numbers::pi * 50.0 * static_cast<double>(n) / rate);
    }
  }
  EXPECT_EQ(find_shared_partials(recordings, rate).size(), 3);
}

TEST(SharedPartials, NeedOneLength) {
  std::vector<std::vector<double>> recordings = struck(1e-3);
  recordings.back().pop_back();
  EXPECT_THROW((void)find_shared_partials(recordings, rate), std::invalid_argument);
}

}  // namespace
}  // namespace idiophone::partials
