#!/usr/bin/python3
"""The ledger's own arithmetic: references against published values, extrapolation, verdicts."""
import math
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from library.ledger import exact, levels, limits, steps, thin, waves
from library.ledger.ledger import AtMost, Row
from library.ledger.shallow_shell import ShallowShell, disc, square

STEEL = {"young": 2.0e11, "poisson": 0.3, "density": 7850}


class References(unittest.TestCase):
    def test_elastic_sphere_is_lambs(self):
        factor = 2 * math.pi * 0.05 / waves.shear_speed(STEEL)
        roots = {mode: frequency * factor for mode, frequency in exact.elastic_sphere(STEEL, 0.05)}
        for mode, root in ("1T2", 2.50113), ("1S2", 2.64622), ("1S1", 3.52999), ("1S0", 4.99551):
            self.assertAlmostEqual(roots[mode], root, places=5)

    def test_multiplets_are_complete(self):
        modes = [mode for mode, _ in exact.elastic_sphere(STEEL, 0.05)]
        self.assertEqual([modes.count(mode) for mode in ("1T2", "1S2", "1S1", "1T3")], [5, 5, 3, 7])

    def test_supported_plate_is_kirchhoffs_when_thin_and_lower_when_thick(self):
        for thickness, low, high in (0.001, 0.99998, 1), (0.1, 0.9, 0.97):
            (_, found), (_, theory) = (exact.supported_square_plate(STEEL, 1, thickness)[0],
                                       thin.square_plate(STEEL, "simply_supported", 1, thickness)[0])
            self.assertGreater(found / theory, low)
            self.assertLess(found / theory, high)

    def test_discs_are_leissas(self):
        factor = 2 * math.pi / waves.plate_factor(STEEL, 0.01)
        for edge, roots in ("clamped", [10.2158, 21.26, 21.26, 34.88]), ("free", [5.358, 5.358, 9.003, 12.44]):
            found = [frequency * factor for _, frequency in thin.circular_plate(STEEL, edge, 1, 0.01)]
            for value, root in zip(found, roots):
                self.assertAlmostEqual(value, root, delta=0.006)

    def test_a_square_bars_torsion_is_saint_venants(self):
        speed = thin.torsion_speed(STEEL, 0.01, 0.01)
        self.assertAlmostEqual(speed / waves.shear_speed(STEEL), math.sqrt(0.140577 * 6), places=5)

    def test_free_plates_are_leissas(self):
        for found, root in zip(ShallowShell(square(12), 0, 0.3, 8).frequencies, [13.468, 19.596, 24.271, 34.801, 34.801]):
            self.assertAlmostEqual(4 * found, root, delta=0.001 * root)

    def test_a_shallow_cap_begins_to_soften_where_touze_and_thomas_say(self):
        def bend(ratio):  # (radius^2/(radius of curvature * thickness))^2
            return ShallowShell(disc(16), ratio**0.5 / 2, 0.33, 8).bend_of(2, 20)
        self.assertGreater(bend(1.92), 0)
        self.assertLess(bend(1.94), 0)


class Arithmetic(unittest.TestCase):
    def test_extrapolation_finds_limit_and_order(self):
        sizes = [0.4, 0.2, 0.1333]
        limit, order = limits.extrapolated(sizes, [100 + 3 * size**2.5 for size in sizes])
        self.assertAlmostEqual(limit, 100, places=9)
        self.assertAlmostEqual(order, 2.5, places=6)

    def test_an_order_below_one_is_taken_for_one(self):
        limit, order = limits.extrapolated([3, 2, 1], [101.8, 101.2, 100.5])
        self.assertAlmostEqual(limit, 99.8)
        self.assertEqual(order, 1)

    def test_what_does_not_converge_has_no_order(self):
        self.assertEqual(limits.extrapolated([3, 2, 1], [100, 101, 100.5]), (100.5, None))

    def test_step_raises_the_pitch(self):
        w_dt = 0.1
        frequency = w_dt / (2 * math.pi * 1e-6)
        self.assertAlmostEqual(steps.stepped(frequency, math.inf, 1e-6) / frequency - 1, w_dt**2 / 24, delta=1e-6)

    def test_half_sine_has_its_area_and_its_null(self):
        self.assertAlmostEqual(levels.half_sine(1e-6, 1), 2 / math.pi, places=9)
        self.assertAlmostEqual(levels.half_sine(3 * math.pi, 1), 0, places=12)

    def test_verdicts(self):
        self.assertTrue(Row("", 100, 100.28, "Hz", 5).passed)
        self.assertFalse(Row("", 100, 100.30, "Hz", 5).passed)
        self.assertFalse(Row("", 100, None, "Hz", 5).passed)
        self.assertFalse(Row("", 2, 2.11, "s", 5).passed)
        self.assertFalse(Row("", -3, -3.2, "dB", 0.1).passed)
        self.assertEqual(Row("", 100, 200, "Hz").verdict, "shown")
        self.assertTrue(AtMost("", -30, -40, "dB", 0).passed)
        self.assertFalse(AtMost("", -30, -29, "dB", 0).passed)


if __name__ == "__main__":
    unittest.main()
