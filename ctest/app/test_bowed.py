#!/usr/bin/python3
"""A bowed vibraphone bar: in time, by finite elements and by modes, it sings as its sound map does in `play`."""
import unittest

import h5py
import numpy

import hearing
import program

DECK = program.SOURCE / "inputs/bowed/vibraphone_bar.yaml"
RATE = 44100
SCORE = """
duration: {duration}
wav_full_scale: 1
events:
  - {{time: 0, type: bow, at: [0.18, 0, -0.0065], direction: [0, 0, 1], speed: [[0, 0], [0.05, 0.1]], load: 2}}
"""


class Bowed(program.TestCase):
    def run_bar(self, *settings):
        """The sound of the run, [samples]."""
        self.require_status(program.idiophone("run", DECK, "--output-folder", self.output, *settings), program.FINISHED)
        with h5py.File(self.output / "bowed_vibraphone_bar.h5") as file:
            return file["audio/ear"][:, 0]

    def play_bar(self, duration, *settings):
        """The sound of the bar's map, [samples]."""
        self.require_status(program.idiophone("map", DECK, "--up-to", 6000, "--radiation", "kirchhoff", "--no-estimate",
                                              "--output-folder", self.output, *settings), program.FINISHED)
        score, wav = self.output / "score.yaml", self.output / "played.wav"
        score.write_text(SCORE.format(duration=duration))
        self.require_status(program.idiophone("play", self.output / "bowed_vibraphone_bar_bar.map.h5", "--score", score,
                                              "--output", wav, "--rate", RATE), program.FINISHED)
        return program.wav_samples(wav).astype(float)

    def require_as_played(self, kind, ran, played):
        """The last part of both sounds has the same pitch within 3 cents and the same level within 1 dB."""
        length = RATE // 3
        (f_ran, level_ran), (f_played, level_played) = (
            hearing.loudest_between(sound[len(ran) - length:len(ran)], RATE, 100, 400) for sound in (ran, played))
        cents = 1200 * numpy.log2(f_ran / f_played)
        print(f"{kind}: {f_ran:.2f} Hz, played {f_played:.2f} Hz: {cents:.2f} cents, {level_ran - level_played:.2f} dB apart")
        self.assertLess(abs(cents), 3)
        self.assertLess(abs(level_ran - level_played), 1)

    def test_modes_in_time_sound_as_the_map(self):
        self.require_as_played("modes", self.run_bar(), self.play_bar(1.5))

    @program.long_verification
    def test_finite_elements_sound_as_the_map(self):
        self.require_as_played("finite elements", self.run_bar("--set", "bodies.bar.model={type: finite_elements}"),
                               self.play_bar(1.5))


if __name__ == "__main__":
    unittest.main()
