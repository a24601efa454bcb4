#include "idiophone/fitting/measurements.hpp"

#include <gmock/gmock.h>
#include <sndfile.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "idiophone/deck/location.hpp"

namespace idiophone::fitting {
namespace {

using ::testing::HasSubstr;

std::filesystem::path file_of(const std::string& name) {
  return std::filesystem::path(::testing::TempDir()) / name;
}

std::filesystem::path yaml_with(const std::string& text) {
  const auto path = file_of("measured.yaml");
  std::ofstream(path) << text;
  return path;
}

std::string refusal(const std::string& text) {
  try {
    static_cast<void>(read_measurements(yaml_with(text)));
  } catch (const deck::DeckError& error) {
    return error.what();
  }
  return "";
}

TEST(Measurements, FromYaml) {
  const Measurements found = read_measurements(
      yaml_with("mass: 0.5\nuncertainty: 5\nlines:\n  - {frequency: 300, uncertainty: 1, decay_time: 2}\n  - 100\n"));
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

TEST(Measurements, FromARecording) {
  const auto path = file_of("recording.wav");
  SF_INFO info = {};
  info.samplerate = 48000;
  info.channels = 1;
  info.format = SF_FORMAT_WAV | SF_FORMAT_FLOAT;
  SNDFILE* file = sf_open(path.c_str(), SFM_WRITE, &info);
  std::vector<double> samples(48000);
  for (std::size_t i = 4800; i < samples.size(); ++i) {  // silence before the blow
    const double t = static_cast<double>(i - 4800) / 48000;
    for (const auto& [frequency, decay] : {std::pair{440.0, 1.0}, {1234.5, 0.5}}) {
      samples[i] += 0.3 * std::exp(-t * std::log(1000.0) / decay) * std::sin(2 * std::numbers::pi * frequency * t);
    }
  }
  sf_write_double(file, samples.data(), static_cast<sf_count_t>(samples.size()));
  sf_close(file);
  const Measurements found = read_measurements(path);
  ASSERT_EQ(found.lines.size(), 2U);
  EXPECT_NEAR(found.lines[0].frequency, 440, 0.01);
  EXPECT_NEAR(found.lines[1].frequency, 1234.5, 0.01);
  EXPECT_NEAR(found.lines[0].decay_time.value(), 1, 0.01);
  EXPECT_NEAR(found.lines[1].decay_time.value(), 0.5, 0.01);
  EXPECT_GE(found.lines[0].uncertainty, default_uncertainty);
}

TEST(Measurements, RefusesWhatIsNoSound) {
  const auto path = file_of("noise.wav");
  std::ofstream(path) << "not a sound";
  EXPECT_THROW(static_cast<void>(read_measurements(path)), std::runtime_error);
  EXPECT_THROW(static_cast<void>(read_measurements(file_of("absent.wav"))), std::runtime_error);
}

}  // namespace
}  // namespace idiophone::fitting
