#!/usr/bin/python3
"""A bowed vibraphone bar: in time, by finite elements and by modes, it sings as its sound map does in `play`. One that another
body rubs sings alike by finite elements and by modes, and as with a bow."""
import unittest

import h5py
import numpy

import hearing
import program

DECK = program.SOURCE / "inputs/bowed/vibraphone_bar.yaml"
RUBBED = program.SOURCE / "inputs/bowed/rubbed_bar.yaml"
FINITE_ELEMENTS = "bodies.bar.model={type: finite_elements}"
RATE = 44100
SCORE = """
duration: {duration}
wav_full_scale: 1
events:
  - {{time: 0, type: bow, at: [0.18, 0, -0.0065], direction: [0, 0, 1], speed: [[0, 0], [0.05, 0.1]], load: 2}}
"""


class Bowed(program.TestCase):
    def run_deck(self, deck, kind, *settings):
        """The sound, [samples], and the result of the run, in a folder for its kind."""
        folder = self.output / kind
        self.require_status(program.idiophone("run", deck, "--output-folder", folder, *settings), program.FINISHED)
        result, = folder.glob("*.h5")
        with h5py.File(result) as file:
            return file["audio/ear"][:, 0], result

    def play_bar(self, duration, *settings):
        """The sound of the bar's map, [samples]."""
        self.require_status(program.idiophone("map", DECK, "--up-to", 6000, "--radiation", "kirchhoff", "--no-estimate",
                                              "--output-folder", self.output, *settings), program.FINISHED)
        score, wav = self.output / "score.yaml", self.output / "played.wav"
        score.write_text(SCORE.format(duration=duration))
        self.require_status(program.idiophone("play", self.output / "bowed_vibraphone_bar_bar.map.h5", "--score", score,
                                              "--output", wav, "--rate", RATE), program.FINISHED)
        return program.wav_samples(wav).astype(float)

    def require_alike(self, kind, sound, reference):
        """The last part of the sound, and that of the reference then, have the same pitch within 3 cents and the same level
        within 1 dB."""
        last = slice(len(sound) - RATE // 3, len(sound))
        (f, level), (f_reference, level_reference) = (
            hearing.loudest_between(whole[last], RATE, 100, 400) for whole in (sound, reference))
        cents = 1200 * numpy.log2(f / f_reference)
        print(f"{kind}: {f:.2f} Hz, reference {f_reference:.2f} Hz: {cents:.2f} cents, {level - level_reference:.2f} dB apart")
        self.assertLess(abs(cents), 3)
        self.assertLess(abs(level - level_reference), 1)

    def test_modes_in_time_sound_as_the_map(self):
        self.require_alike("modes", self.run_deck(DECK, "modes")[0], self.play_bar(1.5))

    @program.long_verification
    def test_finite_elements_sound_as_the_map(self):
        elements, _ = self.run_deck(DECK, "elements", "--set", FINITE_ELEMENTS)
        self.require_alike("finite elements", elements, self.play_bar(1.5))

    @program.long_verification
    def test_a_bar_that_a_body_rubs_sounds_as_with_a_bow_and_the_same_by_finite_elements(self):
        modes, result = self.run_deck(RUBBED, "modes")
        elements, _ = self.run_deck(RUBBED, "elements", "--set", FINITE_ELEMENTS)
        self.require_alike("finite elements", elements, modes)
        with h5py.File(result) as file:
            load = numpy.mean(-file["contacts/rub/force"][RATE // 2:, 0])
        settings = {"bodies.bar.supports.left.damping": 10, "bodies.bar.supports.right.damping": 10, "loads.bow.load": load,
                    "time.duration": 1.0, "bodies.bar.order": "{plane: 4, thickness: 2}",
                    "listeners.ear.position": "[-0.2, 0, 0.5]"}
        bowed, _ = self.run_deck(DECK, "bow", *(word for key, value in settings.items() for word in ("--set", f"{key}={value}")))
        self.require_alike("a bow", bowed, modes)


if __name__ == "__main__":
    unittest.main()
