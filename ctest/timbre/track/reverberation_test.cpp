// The late sound of a room: its coherence at two places, and its level from near and far sources.

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <utility>
#include <vector>

#include "diffuse_field.hpp"
#include "idiophone/timbre/track/soundtrack.hpp"
#include "ranks.hpp"
#include "sounding.hpp"
#include "temporary_file.hpp"

namespace idiophone::timbre {

namespace {

using std::numbers::pi;

/// The tails of an impulse at some receivers, [receivers][samples].
std::vector<std::vector<double>> tails(const std::vector<scene::Receiver>& receivers, double decay) {
  DiffuseField field(receivers, decay, 343.0, 44100);
  std::vector<std::vector<double>> heard(receivers.size());
  std::vector<double> sounds(receivers.size());
  for (int i = 0; i < 44100; ++i) {
    field.step(i == 0 ? 1.0 : 0.0, sounds);
    for (std::size_t r = 0; r < sounds.size(); ++r) {
      heard[r].push_back(sounds[r]);
    }
  }
  return heard;
}

/// Cross spectrum over the power spectra of two sounds, of blocks of 512 samples, in a band of 400 Hz.
double coherence(const std::vector<double>& a, const std::vector<double>& b, double frequency) {
  constexpr std::size_t block = 512;
  std::complex<double> both;
  double first = 0.0, second = 0.0;
  for (std::size_t begin = 4096; begin + block <= a.size(); begin += block / 2) {
    for (const double offset : {-172.0, -86.0, 0.0, 86.0, 172.0}) {  // Hz
      std::complex<double> left, right;
      for (std::size_t i = 0; i < block; ++i) {
        const double phase = 2.0 * pi * static_cast<double>(i);
        const std::complex<double> wave =
            std::polar(0.5 - 0.5 * std::cos(phase / block), -phase * (frequency + offset) / 44100.0);
        left += a[begin + i] * wave;
        right += b[begin + i] * wave;
      }
      both += left * std::conj(right);
      first += std::norm(left);
      second += std::norm(right);
    }
  }
  return both.real() / std::sqrt(first * second);
}

std::vector<scene::Receiver> pair(const Vector3& apart) {
  return {{.channel = "left", .position = 0.5 * apart}, {.channel = "right", .position = -0.5 * apart}};
}

double energy(const std::vector<double>& sound, std::size_t begin, std::size_t end, std::size_t channels = 1) {
  double sum = 0.0;
  for (std::size_t i = begin * channels; i < end * channels; i += channels) {
    sum += sound[i] * sound[i];
  }
  return sum;
}

}  // namespace

ON_RANKS(1);

TEST(DiffuseFields, HaveTheCoherenceOfTheSincAtTwoPlaces) {
  for (const Vector3& apart : {Vector3(0.2, 0, 0), Vector3(0, 0.2, 0), Vector3(0, 0, 0.2)}) {
    const auto heard = tails(pair(apart), 2.0);
    double square = 0.0;
    const std::vector<double> frequencies = {200.0,  400.0,  600.0,  858.0,  1300.0,
                                             2500.0, 4000.0, 6500.0, 9000.0, 14000.0};
    for (const double frequency : frequencies) {
      const double kd = 2.0 * pi * frequency / 343.0 * 0.2;
      const double error = coherence(heard[0], heard[1], frequency) - std::sin(kd) / kd;
      EXPECT_NEAR(error, 0.0, 0.3) << frequency << " Hz along " << apart.transpose();
      square += error * error / static_cast<double>(frequencies.size());
    }
    EXPECT_LT(std::sqrt(square), 0.15) << " along " << apart.transpose();
  }
}

TEST(DiffuseFields, FallInTheDecayTimeAndAreAsLoudAsTheReverberatorsOfTrees) {
  const auto tail = tails({{}}, 0.8).front();
  const double slope = 10.0 * std::log10(energy(tail, 26460, 44100) / energy(tail, 8820, 44100)) / 0.4;  // dB/s
  EXPECT_NEAR(-60.0 / slope, 0.8, 0.05);
  const auto of_tree = sound_of("(reverberate (timer 0 0.00002 1) 0.8)", tail.size());
  EXPECT_NEAR(energy(tail, 0, tail.size()) / energy(of_tree, 0, tail.size()), 1.0, 0.15);
}

TEST(DiffuseFields, AreWeakerForADirectionalMicrophone) {  // a cardioid hears a third of the power
  const auto heard = tails({{}, {.channel = "cardioid", .axis = Vector3::UnitX(), .directivity = 0.5}}, 1.0);
  EXPECT_NEAR(energy(heard[1], 0, 44100) / energy(heard[0], 0, 44100), 1.0 / 3.0, 0.05);
}

/// Energies of a click from a distance: as it arrives, and later than 25 ms after that.
std::pair<double, double> direct_and_late(double distance) {
  const support::TemporaryFile tree("click.tt", "(timer 0 0.0002 1)");
  scene::Scene scene;
  scene.listeners.push_back({.name = "ears", .receivers = pair({0.2, 0, 0}), .path = {}, .head = {}, .where = {}});
  Soundtrack track(scene, 1);
  const Soundtrack::Path path = [distance](double) -> Vector3 { return {0, distance, 0}; };
  track.start_sound(track.instantiate_sound(track.timbre_tree(tree.path()), 1.0, path), 0.0, {});
  const auto sound = track.render(1.0, Reverberation{.decay = 0.5, .level = 0.2}).front().samples;
  const auto end = static_cast<std::size_t>((distance / 343.0 + 0.025) * 44100.0);
  return {energy(sound, 0, end, 2), energy(sound, end, sound.size() / 2, 2)};
}

TEST(LateSounds, HaveOneLevelWhileTheDirectSoundFallsWithTheDistance) {
  const auto near = direct_and_late(1.0), far = direct_and_late(8.0);
  EXPECT_NEAR(10.0 * std::log10(near.first / far.first), 20.0 * std::log10(8.0), 0.3);
  EXPECT_NEAR(10.0 * std::log10(near.second / far.second), 0.0, 0.1);
}

TEST(LateSounds, DoNotComeBeforeTheDirectSound) {
  const auto far = direct_and_late(34.3);  // 0.1 s
  EXPECT_GT(far.first, 0.0);
  EXPECT_NEAR(10.0 * std::log10(direct_and_late(1.0).first / far.first), 20.0 * std::log10(34.3), 0.3);
}

}  // namespace idiophone::timbre
