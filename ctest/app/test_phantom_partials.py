#!/usr/bin/python3
"""Phantom partials of a string: bending stretches it, so that its longitudinal motion has sums of the frequencies of its
partials (H. A. Conklin, J. Acoust. Soc. Am. 105, 1999, 536; B. Bank and L. Sujbert, J. Acoust. Soc. Am. 117, 2005, 2268)."""
import json
import unittest

import h5py
import numpy
from scipy.linalg import eig_banded

import hearing
import program

# As in the deck, in SI units.
YOUNG, DENSITY, STRESS, LENGTH, FORCE, PLACE = 2e11, 7850, 8.9127e8, 0.4, 28, 0.0433333333
CELLS = 1200  # of the finite differences


def bending_shapes(section, count):
    """The lowest shapes of a clamped stiff string, [CELLS + 1 x count] 1/sqrt(kg), by finite differences."""
    step = LENGTH / CELLS
    tension = STRESS * section
    stiffness = YOUNG * section**2 / (4 * numpy.pi)
    middle = 6 * stiffness / step**4 + 2 * tension / step**2
    next_one = -4 * stiffness / step**4 - tension / step**2
    bands = numpy.zeros((3, CELLS - 1))
    bands[0], bands[1], bands[2] = middle, next_one, stiffness / step**4
    bands[0, [0, -1]] += stiffness / step**4  # clamped: beyond the end, the string is its own mirror image
    shapes = numpy.zeros((CELLS + 1, count))
    shapes[1:-1] = eig_banded(bands, lower=True, select="i", select_range=(0, count - 1))[1]
    return shapes / numpy.sqrt(DENSITY * section * step)


def longitudinal_velocity(first, second, frequency, longitudinal, section):
    """Amplitude of the mean velocity along the string at the sum of two frequencies, m/s.

    Two bending motions with the slopes `first` and `second` stretch the string by half the square of the whole slope. This drives
    the longitudinal modes, whose frequencies are the multiples of `longitudinal` (Bank and Sujbert, section III).
    """
    x = numpy.linspace(0, LENGTH, CELLS + 1)
    step, omega = LENGTH / CELLS, 2 * numpy.pi * frequency
    velocity = 0.0
    for mode in range(1, 60, 2):  # those of even numbers have no mean
        wave_number = mode * numpy.pi / LENGTH
        force = YOUNG * section * wave_number / 2 * numpy.sum(first * second * numpy.cos(wave_number * x)) * step
        compliance = 1 / (DENSITY * section * LENGTH / 2) / ((2 * numpy.pi * mode * longitudinal)**2 - omega**2)
        velocity += 2 / (mode * numpy.pi) * omega * compliance * force
    return abs(velocity)


class PhantomPartials(program.TestCase):
    def ask(self, command, *arguments):
        answer = program.idiophone(command, program.deck("hard_pluck"), *arguments, "--json")
        self.require_status(answer, program.FINISHED)
        return json.loads(answer.stdout)

    @program.long_verification
    def test_the_motion_along_a_string_has_sums_of_its_partials(self):
        section = self.ask("check")["bodies"]["string"]["mass"] / (DENSITY * LENGTH)
        modes = {mode["kind"]: mode["frequency"] for mode in self.ask("modes", "--modes", 30, "--no-estimate")["modes"]}
        bending = numpy.array([modes[f"bending {number} along z"] for number in range(1, 9)])
        shapes = bending_shapes(section, len(bending))
        slopes = numpy.gradient(shapes, LENGTH / CELLS, axis=0)
        slopes *= FORCE * shapes[round(PLACE / LENGTH * CELLS)] / (2 * numpy.pi * bending)**2
        self.require_status(program.run("hard_pluck", self.output), program.FINISHED)
        with h5py.File(self.output / "hard_pluck.h5") as file:
            velocity = file["motion/string/velocity"]
            along, rate = velocity[:, 0], velocity.attrs["rate"]
        for first in range(6):
            expected = bending[first] + bending[first + 1]
            found, level = hearing.loudest_between(along, rate, expected - 12, expected + 12)
            reference = longitudinal_velocity(slopes[:, first], slopes[:, first + 1], expected, modes["longitudinal 1"], section)
            cents, difference = 1200 * numpy.log2(found / expected), level - 20 * numpy.log10(reference)
            print(f"partials {first + 1} and {first + 2}: {expected:.1f} Hz, {cents:.2f} cents, {difference:.2f} dB")
            self.assertLess(abs(cents), 1)
            self.assertLess(abs(difference), 0.3)
            harmonic = 1200 * numpy.log2(expected / ((2 * first + 3) * bending[0]))
            self.assertGreater(harmonic, 5)  # so that it is not a multiple of the lowest partial


if __name__ == "__main__":
    unittest.main()
