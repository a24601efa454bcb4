// Mistakes in what is heard and written: listeners and settings.

#include "mistaken.hpp"

namespace idiophone::scene {

using MistakenSound = Mistaken;

TEST_F(MistakenSound, Listeners) {
  expect({
      {"mono", "stereo",
       "deck.yaml:10:8: listeners.ear: the key 'look' is missing\ndeck.yaml:10:8: listeners.ear: the key 'up' is "
       "missing"},
      {"mono", "mono, up: [0, 0, 1]",
       "deck.yaml:10:21: listeners.ear.up: unknown key, known here: type, position, path, attached, pattern, look"},
      {"mono", "stereo, look: [0, 0, 0], up: [0, 1, 0]",
       "deck.yaml:10:29: listeners.ear.look: is zero; it must be a direction, e.g. [0, 0, -1]"},
      {"mono", "stereo, look: [0, 1, 0], up: [0, 0, 0]",
       "deck.yaml:10:44: listeners.ear.up: is zero; it must be a direction, e.g. [0, 0, -1]"},
      {"mono", "stereo, look: [0, 0, -1], up: [0, 0, 2]",
       "deck.yaml:10:45: listeners.ear.up: is parallel to look; the ears' direction, look x up, is undefined"},
      {"mono", "stereo, look: [0, 0, -1], up: [0, 1, 0], separation: -1",
       "deck.yaml:10:68: listeners.ear.separation: must be at least 0 and at most 1000 m, found -1"},
      {"mono", "mono, attached: platte",
       "deck.yaml:10:3: listeners.ear.attached: there is no body 'platte' (did you mean 'plate'?)"},
      {"type: mono, ", "", "deck.yaml:10:8: listeners.ear: the key 'type' is missing"},
  });
}

TEST_F(MistakenSound, ListenersToWavesAreNotAttached) {
  const std::string deck = replaced(plate, "mono", "mono, attached: plate");
  EXPECT_EQ(mistakes(deck), "no mistakes");
  EXPECT_THAT(mistakes(deck + "radiation: {model: waves}\n"),
              testing::HasSubstr("listeners.ear.attached: listeners to"));
}

TEST_F(MistakenSound, Settings) {
  expect_after({
      {"audio: {rate: 44100.5}",
       "deck.yaml:11:15: audio.rate: expected a whole number (samples per second), found '44100.5'"},
      {"audio: {rate: 1e12}",
       "deck.yaml:11:15: audio.rate: must be at least 2000 and at most 1000000 samples per second, found 1e12"},
      {"audio: {rate: 8000, max_frequency: 4001}",
       "deck.yaml:11:36: audio.max_frequency: must be at least 80 and at most 4000 Hz, found 4001"},
      {"audio: {rate: fast, max_frequency: 4e4}",
       "deck.yaml:11:15: audio.rate: expected a number (samples per second), found 'fast'"},
      {"audio: {dc_block: 1}", "deck.yaml:11:19: audio.dc_block: must be at least 0 and below 1, found 1"},
      {"audio: {dc_block: 0.1, dc_corner: 10}",
       "deck.yaml:11:24: audio.dc_corner: dc_block is given already; give one of the two"},
      {"audio: {dc_corner: 11025}",
       "deck.yaml:11:20: audio.dc_corner: must be at least 0 and below 11025 Hz, found 11025"},
      {"audio: {kernel_wavelengths: 0}",
       "deck.yaml:11:29: audio.kernel_wavelengths: must be at least 1 and at most 32, found 0"},
      {"radiation: {visibility: on}", "deck.yaml:11:25: radiation.visibility: must be one of off, found 'on'"},
      {"radiation: {visibility: {rate: 44101}}",
       "deck.yaml:11:32: radiation.visibility.rate: must be at least 0.01 and at most 44100 per second, found 44101"},
      {"radiation: {visibility: {rate: 0, often: 1}}",
       "deck.yaml:11:32: radiation.visibility.rate: must be at least 0.01 and at most 44100 per second, found 0\n"
       "deck.yaml:11:35: radiation.visibility.often: unknown key, known here: rate"},
      {"radiation: {visibility: off, screens: {wall: {corners: [[0, 0, 0], [1, 0, 0]]}}}",
       "deck.yaml:11:56: radiation.screens.wall.corners: a screen has at least three corners"},
      {"radiation: {visibility: off, screens: {wall: {corners: [[0, 0, 0], [1, 0, 0], [0, 1, 0]]}}}",
       "deck.yaml:11:39: radiation.screens: screens need visibility, which is off"},
      {"radiation: {visibility: off, diffraction: true}",
       "deck.yaml:11:43: radiation.diffraction: diffraction needs visibility, which is off"},
      {"radiation: {model: waves, cell: 0.1, diffraction: true}",
       "deck.yaml:11:38: radiation.diffraction: waves bend around bodies by themselves"},
      {"radiation: {model: huygen, air: {density: 0, speed: -3}}",
       "deck.yaml:11:20: radiation.model: must be one of huygens, rayleigh, kirchhoff, waves, found 'huygen' (did you "
       "mean "
       "'huygens'?)\n"
       "deck.yaml:11:43: radiation.air.density: must be at least 1e-06 and at most 10000 kg/m3, found 0\n"
       "deck.yaml:11:53: radiation.air.speed: must be at least 50 and at most 100000 m/s, found -3"},
      {"radiation: {model: kirchhoff, surface_pressure: plane}",
       "deck.yaml:11:49: radiation.surface_pressure: must be one of plane_wave, pulsating, oscillating, found 'plane' "
       "(did you mean 'plane_wave'?)"},
      {"radiation: {model: rayleigh, surface_pressure: plane_wave}",
       "deck.yaml:11:30: radiation.surface_pressure: only model kirchhoff uses it"},
      {"output: {frames_per_second: -1, wav: mp3, wav_full_scale: 0}",
       "deck.yaml:11:29: output.frames_per_second: must be at least 0 and at most 44100 per second, found -1\n"
       "deck.yaml:11:38: output.wav: must be one of float32, pcm24, pcm16, found 'mp3'\n"
       "deck.yaml:11:59: output.wav_full_scale: must be at least 1e-20 and at most 1e+12 Pa, found 0"},
      {"output: {checkpoint: {every_minutes: -1, keep: 0, kep: 1}}",
       "deck.yaml:11:38: output.checkpoint.every_minutes: must be at least 0 and at most 1000000 min, found -1\n"
       "deck.yaml:11:48: output.checkpoint.keep: must be at least 1 and at most 1000000, found 0\n"
       "deck.yaml:11:51: output.checkpoint.kep: unknown key (did you mean 'keep'?), known here: every_minutes, keep"},
      {"references: {a: 3, b: [], c: [440, -1]}",
       "deck.yaml:11:17: references.a: expected a list of frequencies (Hz), found '3'\n"
       "deck.yaml:11:23: references.b: expected a list of frequencies (Hz), found a list of 0\n"
       "deck.yaml:11:36: references.c.1: must be above 0 and at most 1e+09 Hz, found -1"},
      {"references: [440]",
       "deck.yaml:11:13: references: expected a map {NAME: [frequencies in Hz]}, found a list of 1"},
      {"gravity: 9.81", "deck.yaml:11:10: gravity: expected a list of 3 numbers (m/s2), e.g. [0, 0, 1], found '9.81'"},
  });
}

}  // namespace idiophone::scene
