#include "idiophone/study/fitting/measurements.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <fstream>

#include "idiophone/foundation/deck/location.hpp"
#include "ranks.hpp"
#include "recordings.hpp"
#include "temporary_sound.hpp"

namespace idiophone::fitting {
namespace {

using support::TemporaryFile;
using support::TemporarySound;
using ::testing::HasSubstr;

Measurements read_text(const std::string& yaml) {
  const TemporaryFile file("measured.yaml", yaml);
  return read_measurements(file.path());
}

/// What is measured in a recording with these channels.
Measurements heard(int rate, const std::vector<std::vector<double>>& channels,
                   int format = SF_FORMAT_WAV | SF_FORMAT_FLOAT) {
  return read_measurements(TemporarySound(rate, channels, format).path());
}

std::string refusal(const std::string& text) {
  try {
    static_cast<void>(read_text(text));
  } catch (const deck::DeckError& error) {
    return error.what();
  }
  return "";
}

ON_RANKS(1);

TEST(Measurements, FromYaml) {
  const Measurements found =
      read_text("mass: 0.5\nuncertainty: 5\nlines:\n  - {frequency: 300, uncertainty: 1, decay_time: 2}\n  - 100\n");
  EXPECT_EQ(found.mass, 0.5);
  ASSERT_EQ(found.lines.size(), 2U);
  EXPECT_EQ(found.lines[0].frequency, 100);
  EXPECT_EQ(found.lines[0].uncertainty, 5);
  EXPECT_EQ(found.lines[1].uncertainty, 1);
  EXPECT_EQ(found.lines[1].decay_time, 2);
}

TEST(Measurements, MistakesHavePlaces) {
  EXPECT_THAT(refusal("lines: [100, -5]\n"), HasSubstr("measured.yaml:1:14"));
  EXPECT_THAT(refusal("lines: []\n"), HasSubstr("at least one frequency"));
  EXPECT_THAT(refusal("mass: 1\n"), HasSubstr("lines"));
  EXPECT_THAT(refusal("lines: [100]\nmas: 1\n"), HasSubstr("did you mean 'mass'"));
  EXPECT_THAT(refusal("lines: [{frequency: 100, decay: 1}]\n"), HasSubstr("decay"));
}

const std::vector<DampedSine> two_sines = {{440, 1}, {1234.5, 0.5}};

void expect_two_sines(const Measurements& found, double cents) {
  ASSERT_EQ(found.lines.size(), 2U);
  for (std::size_t l = 0; l < 2; ++l) {
    EXPECT_NEAR(1200 * std::log2(found.lines[l].frequency / two_sines[l].frequency), 0, cents);
    EXPECT_NEAR(found.lines[l].decay_time.value() / two_sines[l].decay_time, 1, 0.02);
    EXPECT_GE(found.lines[l].uncertainty, default_uncertainty);
  }
}

TEST(Measurements, FromRecordingsOfAnyRateAndFormat) {
  for (const int rate : {8000, 22050, 44100, 48000, 96000}) {
    for (const int format :
         {SF_FORMAT_WAV | SF_FORMAT_FLOAT, SF_FORMAT_WAV | SF_FORMAT_PCM_24, SF_FORMAT_FLAC | SF_FORMAT_PCM_16}) {
      SCOPED_TRACE(testing::Message() << rate << " Hz, format " << format);
      expect_two_sines(heard(rate, {struck(two_sines, rate, 1)}, format), 0.05);
    }
  }
}

TEST(Measurements, OfTheLouderChannelOfAStereoRecording) {
  const std::vector<double> near = struck(two_sines, 48000, 1);
  const std::vector<double> silence(near.size(), 0.0);
  expect_two_sines(heard(48000, {near, silence}), 0.05);
  expect_two_sines(heard(48000, {silence, near}), 0.05);
}

// The noise is 50 dB below the sines; a third sine is below the noise of its band.
TEST(Measurements, StandsNoise) {
  std::vector<DampedSine> sines = two_sines;
  sines.push_back({3000, 0.5, 3e-6});
  expect_two_sines(heard(48000, {struck(sines, 48000, 1, 1e-3)}), 0.5);
}

TEST(Measurements, RefusesSilenceAndNoise) {
  const std::vector<double> noise = struck({}, 16000, 1, 0.1);
  EXPECT_THROW(static_cast<void>(heard(16000, {noise})), std::runtime_error);
  EXPECT_THROW(static_cast<void>(heard(16000, {struck({}, 16000, 1)})), std::runtime_error);
}

// The longer and louder free part is that after the second click.
TEST(Measurements, StandsLoudClicksAfterTheBlow) {
  std::vector<double> samples = struck(two_sines, 48000, 0.7);
  samples[4800] = 30.0;
  samples[6000] = 10.0;
  expect_two_sines(heard(48000, {samples}), 0.5);
}

// Two seconds with a click before the blow; hum, noise 50 dB below the sines, two of which are 3 Hz apart.
TEST(Measurements, FindsTheBlowInARecordingAsItIs) {
  const int rate = 48000;
  std::vector<DampedSine> sines = two_sines;
  sines.push_back({1237.5, 0.5});
  const std::vector<double> blow = struck(sines, rate, 1.5);
  std::vector<double> samples = struck({{50, 1e4, 0.02}, {150, 1e4, 0.01}}, rate, 3.5, 1e-3);
  samples[rate] += 5.0;
  for (std::size_t n = 0; n < blow.size(); ++n) {
    samples[static_cast<std::size_t>(2 * rate) + n] += blow[n];
  }
  const Measurements found = heard(rate, {samples});
  ASSERT_EQ(found.lines.size(), 3U);
  for (std::size_t l = 0; l < 3; ++l) {
    const double frequency = std::array{440.0, 1234.5, 1237.5}.at(l);
    EXPECT_NEAR(1200 * std::log2(found.lines[l].frequency / frequency), 0, 1) << l;
    EXPECT_NEAR(found.lines[l].decay_time.value() / (l == 0 ? 1.0 : 0.5), 1, 0.05) << l;
  }
  ASSERT_EQ(found.hum.size(), 2U);
  EXPECT_NEAR(found.hum[0], 50, 0.1);
}

TEST(Measurements, RefusesWhatIsNoSound) {
  const TemporaryFile file("noise.wav", "not a sound");
  EXPECT_THROW(static_cast<void>(read_measurements(file.path())), std::runtime_error);
  EXPECT_THROW(static_cast<void>(read_measurements(file.path().string() + "x")), std::runtime_error);
}

}  // namespace
}  // namespace idiophone::fitting
