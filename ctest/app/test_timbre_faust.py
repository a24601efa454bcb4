#!/usr/bin/python3
"""Timbre trees as programs in Faust."""
import shutil
import subprocess
import unittest

import numpy
import scipy.io.wavfile
import test_map

import program
from timbre_case import INPUTS, RATE, TimbreCase, band


@unittest.skipUnless(shutil.which("faust"), "needs Debian's faust")
class Faust(TimbreCase):
    MODES = """(parameter amp 0.5)
(define f (rvector 8 300 3000))
(* amp (combine (* (damp f 0.002) (sine f (* 0.1 amp))) (lowpass (tanh (vector 1 2 3 4 5 6 7 8)) 500)))"""
    WAVES = """(define f (+ 500 (* 300 (keyframe cubic 0 0 0.02 1 0.05 -0.5 0.09 1))))
(define wave (+ (sawtooth f 0.3) (sawtooth (- f 600)) (triangle (* 2 f)) (square (* 0.7 f) (keyframe linear 0.01 0.2 0.06 0.8))))
(define filtered (+ (bandpass wave f 5) (highpass wave 2000) (biquad wave 0.2 0.1 0 -0.5 0.1) (transmit wave 3) (fir wave (vector 1 0 -1))))
(+ filtered (delay wave (+ 0.004 (* 0.001 (sine 20)))) (delay wave 0.003) (reverberate (timer 0.01 0.011 wave) 0.3)
   (select (- 0.05 time) (mod (+ f 0.1) 777) (less wave (keyframe hold 0 0.1 0.04 -0.2))) (clip wave -0.5 (decibels -3)) (sign wave))"""
    NOISES = "(+ (white) (white 2) (* 0.2 (pink)) (perlin 200) (markov 300 0.4))"

    def export(self, text, status=program.FINISHED):
        tree = self.output / "tree.tt"
        tree.write_text(text)
        job = program.idiophone("export", tree, "--faust", self.output / "tree.dsp")
        self.require_status(job, status)
        return job.stderr

    def played(self, text, samples):
        """The sound of a tree's program in Faust."""
        self.export(text)
        (self.output / "driver.cpp").write_text("#include <cstdlib>\n" + test_map.DRIVER)
        subprocess.run(["faust", "-double", "-a", self.output / "driver.cpp", self.output / "tree.dsp", "-o",
                        self.output / "tree.cpp"], check=True)
        subprocess.run(["c++", "-O0", self.output / "tree.cpp", "-o", self.output / "tree"], check=True)
        answer = subprocess.run([self.output / "tree", str(samples), "0"], check=True, capture_output=True, text=True)
        return numpy.array([float(line) for line in answer.stdout.split()])

    def rendered(self, samples):
        scene = f"name: s\nduration: {samples / RATE}\nclasses: {{a: tree.tt}}\nsounds: {{a: {{class: a}}}}\n"
        return self.timbre(self.scene(scene))

    def test_sounds_the_same_without_noise(self):
        for tree in self.MODES, self.WAVES:
            played = self.played(tree, 4410)
            difference = numpy.linalg.norm(played - self.rendered(4410)) / numpy.linalg.norm(played)
            self.assertLess(20 * numpy.log10(difference), -60, tree)

    def test_noises_have_the_same_spectra(self):
        played = self.played(self.NOISES, RATE)
        rendered = self.rendered(RATE)
        for lowest in 100, 250, 1000, 8000:
            self.assertAlmostEqual(20 * numpy.log10(band(played, lowest, 2 * lowest) / band(rendered, lowest, 2 * lowest)),
                                   0, delta=2)

    def test_the_papers_trees_can_be_exported(self):
        for tree in INPUTS.glob("*.tt"):
            if tree.name != "coin.tt":  # needs a recording
                self.export(tree.read_text())

    def test_says_which_node_faust_does_not_have(self):
        said = self.export('(+ (sine 440)\n (sample "a.wav"))', program.WRONG_DECK)
        self.assertRegex(said, r"tree\.tt:2:2: .*a\.wav")
        scipy.io.wavfile.write(self.output / "a.wav", RATE, numpy.zeros(10, dtype=numpy.float32))
        said = self.export('(+ (sine 440)\n (sample "a.wav"))', program.WRONG_DECK)
        self.assertIn("tree.tt:2:2: (sample ...) can't be written in Faust", said)


if __name__ == "__main__":
    unittest.main()
