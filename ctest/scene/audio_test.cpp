#include <cmath>
#include <complex>
#include <numbers>

#include "deck_fixture.hpp"
#include "idiophone/scene/sections.hpp"

namespace idiophone::scene {

namespace {

/// |H| of pt_i = (1 - alpha) pt_{i-1} + (g_i - g_{i-1}) at a frequency, evaluated on the unit circle.
double dc_block_gain(double alpha, double frequency, double rate) {
  const std::complex<double> delay = std::polar(1.0, -2.0 * std::numbers::pi * frequency / rate);
  return std::abs((1.0 - delay) / (1.0 - (1.0 - alpha) * delay));
}

}  // namespace

TEST(DcLoss, IsThreeDecibelsDownAtTheCorner) {
  for (const double rate : {8000.0, 44100.0, 192000.0}) {
    for (const double corner : {1e-3, 1.0, 10.0, 738.0, 0.24 * rate}) {
      const double alpha = dc_loss_at(corner, rate);
      const double ratio = dc_block_gain(alpha, corner, rate) / dc_block_gain(alpha, 0.5 * rate, rate);
      EXPECT_NEAR(ratio, std::sqrt(0.5), 1e-9) << corner << " Hz at " << rate;
    }
  }
  EXPECT_EQ(dc_loss_at(0.0, 44100.0), 0.0);
}

TEST(DcLoss, ThePapersAlphaIsAbout700Hz) {
  EXPECT_NEAR(dc_loss_at(738.0, 44100.0), 0.1, 1e-4);
}

using AudioTest = DeckTest;

TEST_F(AudioTest, HasADcBlockAt10HzWhereTheDeckIsSilent) {
  EXPECT_EQ(read(plate).audio.dc_loss, dc_loss_at(10.0, 44100.0));
  EXPECT_EQ(read(plate + "audio: {rate: 48000}\n").audio.dc_loss, dc_loss_at(10.0, 48000.0));
  EXPECT_EQ(read(plate + "audio: {dc_corner: 20}\n").audio.dc_loss, dc_loss_at(20.0, 44100.0));
  EXPECT_EQ(read(plate + "audio: {dc_block: 0.1}\n").audio.dc_loss, 0.1);
}

/// Without the time derivative of a pressure, motion below hearing would be louder than any tone.
TEST_F(AudioTest, TheModelOfThePaperHasItsDcBlock) {
  const std::string huygens = plate + "radiation: {model: huygens}\n";
  EXPECT_EQ(read(huygens).audio.dc_loss, 0.1);
  EXPECT_EQ(read(plate, {"radiation.model=huygens"}).audio.dc_loss, 0.1);
  EXPECT_EQ(read(huygens + "audio: {rate: 8000}\n").audio.dc_loss, 0.1);
  EXPECT_EQ(read(huygens + "audio: {dc_corner: 20}\n").audio.dc_loss, dc_loss_at(20.0, 44100.0));
  EXPECT_EQ(read(huygens + "audio: {dc_block: 0.3}\n").audio.dc_loss, 0.3);
  EXPECT_EQ(read(plate + "radiation: {model: rayleigh}\n").audio.dc_loss, dc_loss_at(10.0, 44100.0));
}

TEST_F(AudioTest, NeverPassesMoreThanHalfTheRate) {
  EXPECT_EQ(read(plate + "audio: {rate: 8000}\n").audio.max_frequency, 4000.0);
  EXPECT_EQ(read(plate + "audio: {rate: 96000}\n").audio.max_frequency, 22050.0);
}

}  // namespace idiophone::scene
