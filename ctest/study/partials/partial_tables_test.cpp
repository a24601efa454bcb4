// The CSV files of `idiophone analyze`.
#include "idiophone/study/partials/partial_tables.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "temporary_file.hpp"

namespace idiophone::partials {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

/// Two channels of 4096 samples: a sine at bin 64 of the spectrum, and silence.
spectra::Sound tone_and_silence() {
  spectra::Sound sound{.name = "ear", .rate = 4096.0, .unit = "Pa", .channels = {"left", "right"}, .samples = {}};
  sound.samples.assign(2, std::vector<double>(4096, 0.0));
  for (std::size_t i = 0; i < 4096; ++i) {
    sound.samples[0][i] = std::sin(2 * std::numbers::pi * 64.0 * static_cast<double>(i) / 4096.0);
  }
  return sound;
}

std::vector<std::string> lines_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    lines.push_back(line);
  }
  return lines;
}

TEST(PartialTables, PartialsNameTheirChannelAndLeaveUnknownDecaysEmpty) {
  const support::TemporaryFile file("partials.csv");
  Partials of_left, of_right;
  of_left.found = {{.frequency = 440.5, .level = -3.25, .decay_time = 1.5}, {.frequency = 880.0, .level = -20.0}};
  write_partials(file.path(), tone_and_silence(), {of_left, of_right});
  EXPECT_THAT(lines_of(file.path()),
              ElementsAre("channel,frequency_Hz,level_dB,decay_time_s", "left,440.5,-3.25,1.5", "left,880,-20,"));
}

TEST(PartialTables, TheSpectrumHasAColumnForEachChannel) {
  const support::TemporaryFile file("spectrum.csv");
  write_spectrum(file.path(), tone_and_silence());
  const auto lines = lines_of(file.path());
  ASSERT_THAT(lines, SizeIs(1 + 2049));
  EXPECT_EQ(lines[0], "frequency_Hz,left_dB,right_dB");
  EXPECT_THAT(lines[65], StartsWith("64,"));
  EXPECT_NEAR(std::stod(lines[65].substr(3)), 0.0, 0.01);
  EXPECT_THAT(lines[65], HasSubstr(",-400"));
}

TEST(PartialTables, TheSpectrogramIsThatOfTheFirstChannel) {
  const support::TemporaryFile file("spectrogram.csv");
  write_spectrogram(file.path(), tone_and_silence());
  const auto lines = lines_of(file.path());
  ASSERT_THAT(lines, SizeIs(1 + 5 * 1025));
  EXPECT_EQ(lines[0], "time_s,frequency_Hz,level_dB");
  EXPECT_THAT(lines[33], StartsWith("0.25,64,"));
  EXPECT_NEAR(std::stod(lines[33].substr(8)), 0.0, 0.01);
}

}  // namespace
}  // namespace idiophone::partials
