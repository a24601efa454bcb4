#!/usr/bin/python3
"""Steel balls against Hertz's theory of impact (Johnson, Contact Mechanics, section 11.4): Short for every day, Long for
the convergence, whose table stands in docs/method/contact.md."""
import math
import unittest

import h5py
import numpy

import program

YOUNG, POISSON, DENSITY, RADIUS, SPEED = 2.1e11, 0.3, 7850.0, 0.01, 1.0  # Pa, 1, kg/m3, m, m/s
FAINT = 0.01  # part of the peak force; a contact's time is that above it, since its very first touch is one facet's


HEXAHEDRA = "parameters.hexahedra=1", "element=hex", "order={plane: 2, thickness: 2}"


class Impact:
    """A deck and what Hertz says of it."""

    def __init__(self, name, bodies, modulus, radius, mass):
        self.name = name
        self.bodies = bodies
        deepest = (15 * mass * SPEED**2 / (16 * modulus * math.sqrt(radius)))**0.4  # m
        self.force = 4 / 3 * modulus * math.sqrt(radius) * deepest**1.5             # N
        self.time = (2.9432 - 2 * FAINT**(2 / 3)) * deepest / SPEED                 # s


MODULUS = YOUNG / (1 - POISSON**2)  # of a contact with something rigid
MASS = 4 / 3 * math.pi * RADIUS**3 * DENSITY
FLOOR = Impact("hertz_floor", ["ball"], MODULUS, RADIUS, MASS)
BALLS = Impact("hertz_balls", ["upper", "lower"], MODULUS / 2, RADIUS / 2, MASS / 2)


class Hertz(program.TestCase):
    def errors(self, impact, size, *others):
        """Relative errors of the peak force and of the contact time on a mesh of this size (m) at the pole. `others` are
        settings of the bodies."""
        settings = [word for body in impact.bodies for setting in (f"parameters.pole_size={size}", *others)
                    for word in ("--set", f"bodies.{body}.{setting}")]
        self.require_status(program.run(impact.name, self.output, *settings), program.FINISHED)
        with h5py.File(self.output / f"{impact.name}.h5") as file:
            force = file["contacts/impact/force"][:, 2]
            rate = file["contacts/impact/force"].attrs["rate"]
        # Row i is the mean over the sample before it: of the time i - 1/2.
        faint = FAINT * force.max()
        first, last = numpy.flatnonzero(force > faint)[[0, -1]]
        self.assertLess(last + 1, len(force))
        begin = first - (force[first] - faint) / (force[first] - force[first - 1])
        end = last + (force[last] - faint) / (force[last] - force[last + 1])
        return force.max() / impact.force - 1, (end - begin) / rate / impact.time - 1


class Short(Hertz):
    @program.long_verification
    def test_a_ball_on_a_floor(self):
        for error in self.errors(FLOOR, 0.2e-3):
            self.assertLess(abs(error), 0.05)

    def test_a_ball_of_hexahedra_on_a_floor(self):
        for error in self.errors(FLOOR, 0.6e-3, *HEXAHEDRA, "parameters.size=0.006"):
            self.assertLess(abs(error), 0.015)

    @program.long_verification
    def test_two_balls(self):
        for error in self.errors(BALLS, 0.3e-3):
            self.assertLess(abs(error), 0.05)


@program.long_verification
class Long(Hertz):
    def check_convergence(self, impact):
        table = {size: self.errors(impact, size) for size in (0.4e-3, 0.2e-3, 0.1e-3)}
        for size, (force, time) in table.items():
            print(f"{impact.name}, {size:g} m at the pole: peak force {force:+.1%}, contact time {time:+.1%}")
        for which in range(2):
            coarse, fine, finest = (abs(errors[which]) for errors in table.values())
            self.assertGreater(coarse, 1.5 * fine)
            self.assertGreater(fine, 1.5 * finest)
            self.assertLess(finest, 0.02)

    def test_a_ball_on_a_floor_converges(self):
        self.check_convergence(FLOOR)

    def test_hexahedra_are_accurate_with_0_4_mm_at_the_pole(self):
        for impact in (FLOOR, BALLS):
            errors = self.errors(impact, 0.4e-3, *HEXAHEDRA)
            print(f"{impact.name}, hexahedra: peak force {errors[0]:+.2%}, contact time {errors[1]:+.2%}")
            for error in errors:
                self.assertLess(abs(error), 0.01)

    def test_two_balls_converge(self):
        self.check_convergence(BALLS)


if __name__ == "__main__":
    unittest.main()
