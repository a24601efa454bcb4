// Heads and absorbing air, heard by an ear.
#include "idiophone/air/receivers/ear.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "memory_archive.hpp"
#include "ranks.hpp"
#include "temporary_file.hpp"

namespace idiophone::receivers {
namespace {

using std::numbers::pi;
constexpr int rate = 44100;
constexpr const char* kemar = "/usr/share/libmysofa/MIT_KEMAR_normal_pinna.sofa";

std::shared_ptr<const HeadResponses> head() {
  static const auto responses = std::make_shared<const HeadResponses>(kemar, rate);
  return responses;
}

Ear make_ear(const std::shared_ptr<const HeadResponses>& head, std::optional<AbsorbingAir> air = {}) {
  return {
      Spreading::band_limited().first(), 1e6, Spreading::band_limited(), {.head = head, .air = air, .triangles = 1}};
}

/// A lone triangle's sound.
void hear(Ear& ear, std::int64_t sample, double sound, double delay, const Vector3& direction, double distance = 1.0) {
  ear.hear(sample, 0, {{sound, 0, 0, 0}, {}, {delay, 0, 0, 0}}, {distance, 0, 0, 0},
           [&](std::size_t) { return direction; });
}

/// All channels of an ear, from audio sample 0 on.
std::vector<std::vector<double>> listen(Ear& ear, std::size_t count) {
  const auto lead = static_cast<std::size_t>(-ear.bank().first());
  auto channels = ear.bank().take(lead + count, MPI_COMM_SELF);
  for (auto& channel : channels) {
    channel.erase(channel.begin(), channel.begin() + static_cast<std::ptrdiff_t>(lead));
  }
  return channels;
}

std::complex<double> spectrum(const std::vector<double>& sound, double frequency) {
  std::complex<double> sum;
  for (std::size_t i = 0; i < sound.size(); ++i) {
    sum += sound[i] * std::polar(1.0, -2.0 * pi * frequency / rate * static_cast<double>(i));
  }
  return sum;
}

/// First entry above a tenth of the largest.
double onset(const std::vector<double>& sound) {
  const auto louder = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const double loudest = std::abs(*std::ranges::max_element(sound, louder));
  const auto first = std::ranges::find_if(sound, [&](double value) { return std::abs(value) > 0.1 * loudest; });
  return static_cast<double>(first - sound.begin());
}

double decibels(double factor) {
  return 20.0 * std::log10(factor);
}

ON_RANKS(1);

TEST(Head, HearsASmallSourceByTheResponsesOfItsDirection) {
  for (const std::int64_t number : {0L, 100L, 260L, 500L, 709L}) {
    Ear microphone = make_ear(nullptr);
    Ear ears = make_ear(head());
    for (std::int64_t sample = 0; sample < 1000; ++sample) {
      const double sound = std::sin(0.001 * static_cast<double>(sample * sample));
      hear(microphone, sample, sound, 120.3, {});
      hear(ears, sample, sound, 120.3, 0.7 * head()->direction(number));
    }
    std::vector<double> line(head()->taps() - 1);
    const auto arrived = listen(microphone, 1500);
    line.insert(line.end(), arrived.at(0).begin(), arrived.at(0).end());
    const auto heard = listen(ears, 1500);
    ASSERT_EQ(heard.size(), 2U);
    for (std::size_t ear = 0; ear < 2; ++ear) {
      EXPECT_EQ(heard[ear], convolve(line, head()->responses(number)[ear])) << number;
    }
  }
}

TEST(Head, HearsTheSideFirstAndLouderAtTheNearerEar) {
  const Responses left = head()->responses(head()->nearest({0, 2, 0}));
  const double difference = (onset(left[1]) - onset(left[0])) / rate;
  EXPECT_GT(difference, 0.58e-3);
  EXPECT_LT(difference, 0.72e-3);
  EXPECT_GT(decibels(std::abs(spectrum(left[0], 4000)) / std::abs(spectrum(left[1], 4000))), 6.0);
  const Responses right = head()->responses(head()->nearest({0, -2, 0}));
  EXPECT_NEAR(onset(right[0]) - onset(right[1]), difference * rate, 2.0);
}

TEST(Head, HasTheLevelOfItsCentreForLowSoundsFromTheFront) {
  for (const int other_rate : {8000, 44100, 96000}) {
    const HeadResponses responses(kemar, other_rate);
    const Responses front = responses.responses(responses.nearest({1, 0, 0}));
    for (const double frequency : {250.0, 400.0, 550.0}) {
      std::complex<double> sum;
      for (std::size_t k = 0; k < front[0].size(); ++k) {
        sum += front[0][k] * std::polar(1.0, -2.0 * pi * frequency / other_rate * static_cast<double>(k));
      }
      EXPECT_NEAR(decibels(std::abs(sum)), 0.0, 1.0) << frequency << " Hz at " << other_rate;
    }
  }
}

TEST(Head, FindsTheNearestMeasuredDirection) {
  const Vector3 wanted = Vector3(0.3, -0.5, 0.4).normalized();
  const std::int64_t found = head()->nearest(100.0 * wanted);
  for (std::int64_t number = 0; number < static_cast<std::int64_t>(head()->count()); ++number) {
    EXPECT_LE(head()->direction(number).dot(wanted), head()->direction(found).dot(wanted) + 1e-6);
  }
  EXPECT_EQ(head()->nearest({0, 0, 0}), head()->nearest({1, 0, 0}));
}

TEST(Head, HearsASourceThatCirclesItWithoutAClick) {
  // 300 Hz once around the head in half a second: the second difference is that of the tone, not of a jump.
  Ear ears = make_ear(head());
  constexpr double step = 2.0 * pi * 300.0 / rate;
  for (std::int64_t sample = 0; sample < rate / 2; ++sample) {
    const double angle = 4.0 * pi * static_cast<double>(sample) / rate;
    hear(ears, sample, std::sin(step * static_cast<double>(sample)), 100.0, {std::cos(angle), std::sin(angle), 0});
  }
  for (const auto& sound : listen(ears, rate / 2)) {
    double sharpest = 0.0, loudest = 0.0;
    for (std::size_t i = 2000; i + 2 < sound.size(); ++i) {
      sharpest = std::max(sharpest, std::abs(sound[i + 1] - 2.0 * sound[i] + sound[i - 1]));
      loudest = std::max(loudest, std::abs(sound[i]));
    }
    EXPECT_LT(sharpest, 1.5 * step * step * loudest);
  }
}

TEST(Head, RefusesFilesWithoutResponses) {
  const support::TemporaryFile not_sofa("no.sofa", "nothing");
  const auto& file = not_sofa.path();
  const auto message = [](const char* text) {
    return testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr(text));
  };
  EXPECT_THAT([&] { const HeadResponses none(file, rate); }, message("not a SOFA file"));
  EXPECT_THAT([&] { const HeadResponses none(file.string() + "x", rate); }, message("has no head-related responses"));
}

TEST(AbsorbingAir, TakesWhatTheStandardSaysAndShiftsNothing) {
  const radiation::Atmosphere atmosphere;
  for (const double distance : {0.3, 1.0, 10.5, 47.25, 200.0}) {
    Ear clear = make_ear(nullptr);
    Ear absorbing = make_ear(nullptr, AbsorbingAir(atmosphere, rate));
    hear(clear, 0, 1.0, 200.0, {}, distance);
    hear(absorbing, 0, 1.0, 200.0, {}, distance);
    const auto before = listen(clear, 600).at(0);
    const auto after = listen(absorbing, 600).at(0);
    for (const double frequency : {125.0, 1000.0, 4000.0, 10000.0, 16000.0}) {
      const std::complex<double> ratio = spectrum(after, frequency) / spectrum(before, frequency);
      const double expected = std::exp(-atmosphere.attenuation(frequency) * distance);
      EXPECT_NEAR(std::abs(ratio), expected, 2e-3 * expected + 3e-5) << frequency << " Hz, " << distance << " m";
      EXPECT_NEAR(std::arg(ratio), 0.0, 1e-8) << frequency << " Hz, " << distance << " m";
    }
  }
}

TEST(AbsorbingAir, BeforeAHeadIsBothFiltersInOne) {
  const AbsorbingAir air({.temperature = 30.0, .humidity = 20.0}, rate);
  Ear both = make_ear(head(), air);
  Ear clear = make_ear(head());
  hear(both, 0, 1.0, 300.0, {1, 1, 0}, 20.0);
  hear(clear, 0, 1.0, 300.0, {1, 1, 0}, 20.0);
  const auto absorbed = listen(both, 1000);
  const auto unabsorbed = listen(clear, 1000);
  for (std::size_t ear = 0; ear < 2; ++ear) {
    const double ratio = std::abs(spectrum(absorbed[ear], 8000) / spectrum(unabsorbed[ear], 8000));
    const double expected = std::exp(-20.0 * radiation::Atmosphere{30.0, 20.0}.attenuation(8000));
    EXPECT_NEAR(decibels(ratio), decibels(expected), 0.02);
  }
}

TEST(Ear, GoesOnFromItsStateWithTheSameBits) {
  const auto ear_with_all = [] { return make_ear(head(), AbsorbingAir({}, rate)); };
  const auto play = [](Ear& ear, std::int64_t begin, std::int64_t end) {
    for (std::int64_t sample = begin; sample < end; ++sample) {
      const double t = 0.003 * static_cast<double>(sample);
      hear(ear, sample, std::sin(0.1 * static_cast<double>(sample)), 500.0 + 10.0 * t, {std::cos(t), std::sin(t), 0.1},
           4.0 + 0.1 * t);
    }
  };
  Ear whole = ear_with_all();
  play(whole, 0, 2000);
  const auto expected = listen(whole, 1800);

  Ear ear = ear_with_all();
  play(ear, 0, 901);
  const parallel::Rows rows(std::vector<Index>{0}, 1, MPI_COMM_SELF);
  support::MemoryArchive archive(MPI_COMM_SELF);
  const auto archive_all = [&](Ear& which) {
    archive.rows("directions", rows,
                 [&](std::size_t triangle, parallel::ArchiveRow& row) { which.archive(triangle, row); });
    which.bank().archive(archive, "bank");
  };
  archive_all(ear);
  archive.restore();
  Ear resumed = ear_with_all();
  archive_all(resumed);
  play(resumed, 901, 2000);
  EXPECT_EQ(listen(resumed, 1800), expected);
}

}  // namespace
}  // namespace idiophone::receivers
