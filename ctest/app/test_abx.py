#!/usr/bin/python3
"""`idiophone abx`: the page of a blind listening test, its sounds, its levels and its count of right answers."""
import unittest

import h5py
import numpy
from scipy.io import wavfile
from scipy.stats import binom

import program
from web import in_browser

RATE = 22050


class Abx(program.TestCase):
    def setUp(self):
        super().setUp()
        time = numpy.arange(RATE // 10) / RATE
        self.tone = (0.5 * numpy.sin(2 * numpy.pi * 440 * time)).astype(numpy.float32)
        self.low = (0.1 * numpy.sin(2 * numpy.pi * 220 * time)).astype(numpy.float32)
        self.page = self.output / "abx.html"
        for name in ("tone", "low"):
            wavfile.write(self.output / f"{name}.wav", RATE, getattr(self, name))

    def abx(self, *arguments, status=program.FINISHED):
        job = program.idiophone("abx", *arguments, "-o", self.page)
        self.require_status(job, status)
        return job.stderr

    def sounds(self, seen):
        return [numpy.array(sound["channels"][0]) for sound in seen["sounds"]]

    def test_the_page_plays_and_counts(self):
        self.abx(self.output / "tone.wav", self.output / "low.wav", "--trials", 6)
        seen = in_browser("abx.mjs", self.page)
        self.assertEqual(seen["complaints"], [])
        self.assertTrue(seen["narrow"], "the page is wider than a phone")
        self.assertIn("tone.wav", seen["names"])
        tone, low = self.sounds(seen)
        self.assertEqual([sound["rate"] for sound in seen["sounds"]], [RATE, RATE])
        numpy.testing.assert_allclose(tone, 1.8 * self.tone, atol=1e-6)  # a peak of 0.9, and the ratio of the levels stays
        numpy.testing.assert_allclose(low, 1.8 * self.low, atol=1e-6)
        self.assertTrue(120 < sum(seen["tosses"]) < 280, "X is not by chance")
        numpy.testing.assert_allclose(seen["chances"], [binom.sf(right - 1, trials, 0.5) for right, trials in
                                                        ((16, 16), (12, 16), (0, 16), (5, 7))], rtol=1e-12)
        self.assertTrue(seen["early"] and seen["over"], "answers are possible before X was heard, or after the end")
        self.assertEqual(seen["told"], "", "the page tells before the end")
        self.assertIn("6 of 6 answers were right", seen["all"])
        self.assertIn("0.016", seen["all"])
        self.assertIn("You can tell the sounds apart", seen["all"])
        self.assertIn("4 of 6 answers were right", seen["most"])
        self.assertIn("does not show", seen["most"])

    def test_levels_of_a_result_and_a_recording_are_matched_on_request(self):
        job = program.run("simple", self.output, "--set", "time.duration=0.005")
        self.require_status(job, program.FINISHED)
        pair = (self.output / "simple.h5", self.output / "tone.wav")
        self.assertIn("use --match-levels", self.abx(*pair, status=program.FAILED))
        self.abx(*pair, "--match-levels", "--trials", 1)
        seen = in_browser("abx.mjs", self.page)
        self.assertEqual(seen["complaints"], [])
        result, tone = self.sounds(seen)
        with h5py.File(self.output / "simple.h5") as file:
            heard = file["audio/ear"][:].ravel()
        numpy.testing.assert_allclose(result / abs(result).max(), heard / abs(heard).max(), atol=1e-6)
        self.assertAlmostEqual((result ** 2).sum() / 8000 / ((tone ** 2).sum() / RATE), 1, places=4)
        self.assertAlmostEqual(max(abs(result).max(), abs(tone).max()), 0.9, places=5)

    def test_sounds_that_cannot_be_compared_are_refused(self):
        tone = self.output / "tone.wav"
        wavfile.write(self.output / "silent.wav", RATE, 0 * self.tone)
        wavfile.write(self.output / "three.wav", RATE, numpy.stack([self.tone] * 3, axis=1))
        wavfile.write(self.output / "nan.wav", RATE, numpy.where(self.tone > 0, numpy.float32("nan"), self.tone))
        for other, message in (("silent.wav", "silence"), ("nan.wav", "no numbers"), ("three.wav", "3 channels"), ("none.wav", "none.wav")):
            with self.subTest(other=other):
                self.assertIn(message, self.abx(tone, self.output / other, status=program.FAILED))


if __name__ == "__main__":
    unittest.main()
