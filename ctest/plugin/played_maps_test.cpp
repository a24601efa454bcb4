#include "played_maps.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "controls.hpp"
#include "ranks.hpp"
#include "sheet_map.hpp"

namespace idiophone::plugin {

namespace {

constexpr int audio_rate = 48000;

/// A sheet whose only mode has this frequency, Hz.
std::shared_ptr<const sound_maps::SoundMap> tone(double frequency) {
  auto map = std::make_shared<sound_maps::SoundMap>(sound_maps::sheet());
  map->frequency.resize(1);
  map->frequency.front() = frequency;
  map->material_decay = {2.0};
  map->radiation_decay = {0.0};
  map->shape.resize(3 * map->vertices.size());
  map->sphere.pressure.resize(map->sphere.direction.size());
  return map;
}

/// Left channel of a key that is struck at once.
std::vector<double> sound_of(PlayedMaps& maps, int key, int velocity = 100) {
  maps.take({.kind = drivers::MidiMessage::Kind::press, .number = key, .value = velocity}, maps.stage().now());
  std::vector<double> left;
  for (int block = 0; block < 40; ++block) {
    std::vector<double> sound(2 * 512UL);
    maps.stage().render(sound, 0);
    maps.attend();
    for (std::size_t i = 0; i < sound.size(); i += 2) {
      left.push_back(sound[i]);
    }
  }
  return left;
}

/// By its upward zero crossings after the blow, Hz.
double pitch_of(const std::vector<double>& sound) {
  double first = 0.0, last = 0.0;
  int count = -1;
  for (std::size_t i = 2000; i < sound.size(); ++i) {
    if (sound[i - 1] < 0.0 && sound[i] >= 0.0) {
      last = static_cast<double>(i) - sound[i] / (sound[i] - sound[i - 1]);
      first = count < 0 ? last : first;
      ++count;
    }
  }
  return audio_rate * count / (last - first);
}

double peak_of(const std::vector<double>& sound) {
  double peak = 0.0;
  for (const double sample : sound) {
    peak = std::max(peak, std::abs(sample));
  }
  return peak;
}

Controls with_keyboard(Keyboard keyboard) {
  Controls controls = controls_of(usual_values());
  controls.keyboard = keyboard;
  return controls;
}

}  // namespace

ON_RANKS(1);

TEST(PlayedMaps, LargeAmplitudesRaiseThePitchOfStrongBlows) {
  auto stretched = std::make_shared<sound_maps::SoundMap>(*tone(440.0));
  stretched->stretching = {.linear = {0.0}, .quadratic = {3e7}, .rotation = {0.0}};
  const auto cents_of = [&](const std::shared_ptr<const sound_maps::SoundMap>& map, int velocity) {
    PlayedMaps maps({map}, with_keyboard(Keyboard::bodies), audio_rate);
    return 1200 * std::log2(pitch_of(sound_of(maps, 60, velocity)) / 440.0);
  };
  EXPECT_NEAR(cents_of(stretched, 1), 0.0, 1.0);
  EXPECT_GT(cents_of(stretched, 127), 20.0);
  EXPECT_NEAR(cents_of(tone(440.0), 127), 0.0, 1.0);
}

TEST(PlayedMaps, TunedBodiesHaveThePitchesOfTheirKeys) {
  PlayedMaps maps({tone(1234.0)}, with_keyboard(Keyboard::tuned), audio_rate);
  EXPECT_NEAR(pitch_of(sound_of(maps, 69)), 440.0, 0.5);
  PlayedMaps others({tone(1234.0)}, with_keyboard(Keyboard::tuned), audio_rate);
  EXPECT_NEAR(pitch_of(sound_of(others, 81)), 880.0, 1.0);
}

TEST(PlayedMaps, ScaledBodiesKeepTheirPitchAtTheMiddleKey) {
  PlayedMaps maps({tone(500.0)}, with_keyboard(Keyboard::scaled), audio_rate);
  EXPECT_NEAR(pitch_of(sound_of(maps, 60)), 500.0, 0.5);
  PlayedMaps others({tone(500.0)}, with_keyboard(Keyboard::scaled), audio_rate);
  EXPECT_NEAR(pitch_of(sound_of(others, 72)), 1000.0, 1.0);
}

TEST(PlayedMaps, KeysStrikeOneMapAfterTheOther) {
  for (const auto& [key, pitch] : {std::pair{60, 500.0}, {61, 700.0}, {62, 500.0}, {59, 700.0}, {0, 500.0}}) {
    PlayedMaps maps({tone(500.0), tone(700.0)}, with_keyboard(Keyboard::bodies), audio_rate);
    EXPECT_NEAR(pitch_of(sound_of(maps, key)), pitch, 1.0) << key;
  }
}

TEST(PlayedMaps, ControlsChangeWhatSounds) {
  const Controls usual = with_keyboard(Keyboard::bodies);
  const auto sound_with = [&](const std::function<void(Controls&)>& set) {
    PlayedMaps maps({tone(500.0)}, usual, audio_rate);
    Controls controls = usual;
    set(controls);
    maps.change(controls, 64);
    sound_of(maps, 1, 1);  // until the listener is where it went
    return sound_of(maps, 60);
  };
  const double peak = peak_of(sound_with([](Controls&) {}));
  EXPECT_NEAR(peak_of(sound_with([](Controls& controls) { controls.listener.z() = 2.0; })), peak / 2.0, 0.05 * peak);
  EXPECT_NEAR(pitch_of(sound_with([](Controls& controls) { controls.size = 2.0; })), 250.0, 0.5);
  EXPECT_GT(peak_of(sound_with([](Controls& controls) { controls.hammer.mass *= 1.5; })), 1.1 * peak);
  EXPECT_LT(peak_of(sound_with([](Controls& controls) { controls.hammer.hardness = 1e5; })), 0.9 * peak);
  EXPECT_NE(peak_of(sound_with([](Controls& controls) { controls.place.x() = -0.7; })), peak);
  const std::vector<double> damped = sound_with([](Controls& controls) { controls.friction = 50.0; });
  EXPECT_LT(std::abs(*std::max_element(damped.end() - 2000, damped.end())), 1e-6 * peak);
}

}  // namespace idiophone::plugin
