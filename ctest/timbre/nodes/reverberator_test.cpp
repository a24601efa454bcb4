// The late sound of a room, echo by echo.

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "measured.hpp"
#include "ranks.hpp"
#include "reverberator.hpp"

namespace idiophone::timbre {

ON_RANKS(1);

TEST(Reverberators, FallBy60DecibelsInItsDecayTime) {
  const auto sound = sound_of("(reverberate (timer 0 0.00002 1) 0.8)", 44100);
  const auto energy_after = [&](double time) {
    return std::accumulate(sound.begin() + static_cast<std::ptrdiff_t>(time * 44100), sound.end(), 0.0,
                           [](double sum, double sample) { return sum + sample * sample; });
  };
  const double slope = 10.0 * std::log10(energy_after(0.6) / energy_after(0.2)) / 0.4;  // Schroeder's integral, dB/s
  EXPECT_NEAR(-60.0 / slope, 0.8, 0.04);
}

TEST(Reverberators, BeginWithOneEchoOfEachLine) {
  constexpr double decay = 0.7;
  Reverberator room(decay, 44100);
  std::vector<double> sound(2600);
  for (std::size_t i = 0; i < sound.size(); ++i) {
    sound[i] = room.step(i == 0 ? 1.0 : 0.0);
  }
  std::vector<double> expected(sound.size());
  double sign = 1.0;
  for (const int length : {1311, 1465, 1637, 1813, 2001, 2239, 2481}) {  // samples, odd
    expected[length] = sign * std::pow(10.0, -3.0 * length / (44100 * decay)) / std::sqrt(8.0);
    sign = -sign;
  }
  for (std::size_t i = 0; i < sound.size(); ++i) {
    ASSERT_NEAR(sound[i], expected[i], 1e-15) << i;
  }
}

TEST(Reverberators, ReflectEachLineIntoAllOthers) {  // x - sum(x)/4
  Reverberator room(0.7, 44100);
  std::vector<double> sound(2777);
  for (std::size_t i = 0; i < sound.size(); ++i) {
    sound[i] = room.step(i == 0 ? 1.0 : 0.0);
  }
  const double first = std::pow(10.0, -3.0 * 1311 / (44100 * 0.7)),
               second = std::pow(10.0, -3.0 * 1465 / (44100 * 0.7));
  EXPECT_NEAR(sound[1311 + 1311], 0.75 * first * first / std::sqrt(8.0), 1e-15);
  // The second line gives -1/4 of the first one's echo to itself, and takes -1/4 of its own into the first.
  EXPECT_NEAR(sound[1311 + 1465], (0.25 + -0.25) * first * second / std::sqrt(8.0), 1e-15);
}

TEST(Reverberators, KeepTheEnergyOfASoundThatHardlyDecays) {
  Reverberator room(100.0, 8000);
  double early = 0.0, late = 0.0;
  for (int i = 0; i < 40000; ++i) {
    const double sample = room.step(i == 0 ? 1.0 : 0.0);
    (i < 20000 ? early : late) += sample * sample;
  }
  EXPECT_NEAR(late / early, std::pow(10.0, -6.0 * 2.5 / 100.0), 0.02);  // 2.5 s later
}

}  // namespace idiophone::timbre
