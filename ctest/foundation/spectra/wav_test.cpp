#include "idiophone/foundation/spectra/wav.hpp"

#include <gtest/gtest.h>
#include <sndfile.h>

#include <array>
#include <cmath>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "temporary_file.hpp"

namespace idiophone::spectra {
namespace {

class Wav : public testing::Test {
 protected:
  [[nodiscard]] std::vector<double> read(SF_INFO& info) const {
    const std::unique_ptr<SNDFILE, int (*)(SNDFILE*)> file(sf_open(path.c_str(), SFM_READ, &info), &sf_close);
    std::vector<double> samples(static_cast<std::size_t>(info.frames * info.channels));
    sf_read_double(file.get(), samples.data(), static_cast<sf_count_t>(samples.size()));
    return samples;
  }

  support::TemporaryFile file_{"sound.wav"};
  const std::filesystem::path path = file_.path();
};

const std::vector<double> sound = {0.0, 1.0, -2.0, 0.5, 3.0, -4.0};

TEST_F(Wav, ScalesFullScaleToOneInEveryFormat) {
  const std::array<std::pair<SampleFormat, double>, 3> formats = {
      {{SampleFormat::float32, 1e-7}, {SampleFormat::pcm24, 3e-7}, {SampleFormat::pcm16, 7e-5}}};
  for (const auto& [format, tolerance] : formats) {
    EXPECT_EQ(write_wav(path, sound, {.rate = 48000, .channels = 2, .format = format, .full_scale = 4.0}), 0U);
    SF_INFO info{};
    const auto samples = read(info);
    EXPECT_EQ(info.samplerate, 48000);
    EXPECT_EQ(info.channels, 2);
    ASSERT_EQ(samples.size(), sound.size());
    for (std::size_t i = 0; i < sound.size(); ++i) {
      EXPECT_NEAR(samples[i], sound[i] / 4.0, tolerance);
    }
  }
  EXPECT_FALSE(std::filesystem::exists(path.string() + ".part"));
}

TEST_F(Wav, CountsAndClipsWhatExceedsFullScale) {
  EXPECT_EQ(write_wav(path, sound, {.format = SampleFormat::pcm16, .full_scale = 2.0}), 2U);
  SF_INFO info{};
  EXPECT_NEAR(read(info)[5], -1.0, 1e-4);
  EXPECT_EQ(write_wav(path, sound, {.format = SampleFormat::float32, .full_scale = 2.0}), 2U);
  EXPECT_NEAR(read(info)[5], -2.0, 1e-7);
}

TEST_F(Wav, IsTheSameFileEachTime) {
  const auto bytes = [&] {
    write_wav(path, sound, {});
    std::ifstream file(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  EXPECT_EQ(bytes(), bytes());
  EXPECT_EQ(bytes().find("PEAK"), std::string::npos);  // a chunk with the time of day
}

TEST_F(Wav, RefusesWhatIsWrong) {
  EXPECT_THROW(write_wav(path, sound, {.channels = 4}), std::invalid_argument);
  EXPECT_THROW(write_wav(path, sound, {.full_scale = 0.0}), std::invalid_argument);
  EXPECT_THROW(write_wav(path, std::vector<double>{std::nan("")}, {}), std::invalid_argument);
  EXPECT_THROW(write_wav(path, sound, {.full_scale = 1e-300}), std::invalid_argument);  // infinite in 32 bits
  EXPECT_THROW(write_wav("/no/such/folder/sound.wav", sound, {}), std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace idiophone::spectra
