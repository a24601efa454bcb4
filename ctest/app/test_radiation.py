#!/usr/bin/python3
"""Two steel balls collide: the sound against that of two rigid spheres that move as the balls' centres do."""
import unittest

import h5py
import numpy

import program

IMPEDANCE, SPEED = 1.21 * 343, 343.0  # Pa s/m, m/s
RADIUS, CENTRE = 0.01, 0.01004        # m
MAX_FREQUENCY = 40e3                  # Hz, of the deck
FINE = 20                             # steps of the velocity that a sample is cut into


def low_passed(series, rate):
    """By the paper's eqs. 6 to 8, as the surface's motion is."""
    width = 3 / MAX_FREQUENCY
    time = numpy.arange(-int(width * rate), int(width * rate) + 1) / rate
    kernel = numpy.sinc(2 * MAX_FREQUENCY * time) * (1 + numpy.cos(numpy.pi * time / width))
    lasting = numpy.pad(series, len(time) // 2, mode="edge")
    return numpy.convolve(lasting, kernel / kernel.sum(), mode="valid")


def rigid_sphere(velocity, rate, receiver):
    """Pressure, Pa, of a sphere that moves along z: a step of 1 m/s sends, with x = r/a and T = (t - (r - a)/c) c/a,
    z cos(theta)/x exp(-T) (cos T + (1/x - 1) sin T)."""
    distance = numpy.linalg.norm(receiver)
    x = distance / RADIUS
    sample = numpy.arange(len(velocity))
    begin = numpy.arange(len(velocity) * FINE) / FINE  # of small steps, samples: what a step sends sets in at once
    changes = numpy.diff(numpy.interp(begin, sample, velocity), append=velocity[-1])
    sound = numpy.zeros(len(velocity))
    for change, middle in zip(changes, (begin + 0.5 / FINE) / rate):
        if change != 0:
            passed = sample / rate - (distance - RADIUS) / SPEED - middle
            decayed = numpy.maximum(passed, 0) * SPEED / RADIUS
            step = numpy.exp(-decayed) * (numpy.cos(decayed) + (1 / x - 1) * numpy.sin(decayed))
            sound += change * numpy.where(passed > 0, step, 0)
    return IMPEDANCE * receiver[2] / distance / x * sound


class Balls(program.TestCase):
    @program.long_verification
    def test_collide_as_rigid_spheres(self):
        self.require_status(program.run("colliding_balls", self.output, ranks=2), program.FINISHED)
        with h5py.File(self.output / "colliding_balls.h5") as file:
            for name, listener in file["audio"].items():
                self.assertEqual(listener.attrs["unit"], b"Pa")
                rate, sound = listener.attrs["rate"], listener[:, 0]
                expected = sum(rigid_sphere(low_passed(file[f"motion/{ball}/velocity"][:len(sound), 2], rate), rate,
                                            listener.attrs["positions"][0] - (0, 0, side * CENTRE))
                               for ball, side in (("upper", 1), ("lower", -1)))
                level = 20 * numpy.log10(abs(sound).max() / abs(expected).max())
                correlation = sound @ expected / numpy.sqrt(sound @ sound * (expected @ expected))
                print(f"{name}: {abs(sound).max():.3g} Pa, {level:+.2f} dB, correlation {correlation:.4f}")
                # Beside the point of contact both dipoles are almost silent, and the balls' own bending is heard too.
                self.assertLess(abs(level), 1.0 if name == "beside" else 0.3)
                self.assertGreater(correlation, 0.99 if name == "beside" else 0.999)


if __name__ == "__main__":
    unittest.main()
