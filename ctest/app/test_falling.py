#!/usr/bin/python3
"""The solver of the Sonic Explorer for bodies that fall and touch: conserved quantities, and formulas of mechanics."""
import math
import unittest

import numpy

import program
from web import in_browser

GRAVITY = 9.81
STEP = 1 / 240  # s


class Falling(program.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.seen = in_browser("falling.mjs")

    def test_a_box_has_its_moments_of_inertia(self):
        exact = [2 / 12 * (0.2 ** 2 + 0.1 ** 2), 2 / 12 * (0.3 ** 2 + 0.1 ** 2), 2 / 12 * (0.3 ** 2 + 0.2 ** 2)]
        numpy.testing.assert_allclose(self.seen["inertia"], numpy.diag(exact), rtol=0.01, atol=1e-9)

    def test_a_hull_has_the_faces_of_a_box_that_lies_askew(self):
        self.assertAlmostEqual(self.seen["entered"], 1 - 0.05 - 0.01, places=6)

    def test_a_collision_keeps_both_momenta_and_makes_no_energy(self):
        hit = self.seen["hit"]
        self.assertGreater(hit["events"], 0)
        numpy.testing.assert_allclose(hit["after"], hit["before"], atol=1e-12)
        self.assertLess(hit["grown"], 1e-6)

    def test_a_central_collision_has_the_speeds_of_the_coefficient_of_restitution(self):
        expected = [2 * (1 - 0.5 * 3) / (1 + 3), 2 * (1 + 0.5) / (1 + 3)]  # m/s, of 1 and 3 kg
        numpy.testing.assert_allclose(self.seen["headOn"], [[speed, 0, 0] for speed in expected], atol=1e-6)

    def test_a_free_body_keeps_its_angular_momentum_and_energy(self):
        spun = self.seen["spun"]
        numpy.testing.assert_allclose(spun["after"], spun["before"], rtol=1e-9)
        self.assertAlmostEqual(spun["energy"], 1, delta=1e-3)

    def test_a_box_comes_to_rest_on_a_face_and_gains_no_energy(self):
        for box in self.seen["settled"]:
            self.assertTrue(box["rests"])
            self.assertLess(box["seconds"], 4)
            self.assertGreater(box["upright"], 0.9999)
            self.assertAlmostEqual(box["height"], box["half"], delta=5e-4)
            self.assertLess(box["grown"], 1e-6)
            self.assertLess(box["deepest"], 2e-3)

    def test_friction_stops_what_slides(self):
        slid = self.seen["slid"]
        self.assertTrue(slid["rests"])
        self.assertAlmostEqual(slid["way"] / (1.5 ** 2 / (2 * 0.3 * GRAVITY)), 1, delta=0.02)

    def test_what_slides_does_not_roll(self):
        events = self.seen["slid"]["events"]
        self.assertEqual(len({event["contact"] for event in events}), 4)  # corners
        for event in events:
            self.assertLess(event["roll"], 0.01 * event["slip"])

    def test_a_ball_that_rolls_has_one_contact_and_its_speed(self):
        steps = self.seen["rolled"]["steps"]
        events = [event for step in steps for event in step]
        self.assertGreater(len([step for step in steps if step]), 15)
        self.assertEqual(len({event["contact"] for event in events}), 1)
        for event in events:
            self.assertGreater(event["roll"], 10 * event["slip"])
        self.assertAlmostEqual(events[0]["roll"], 1, delta=0.01)  # m/s

    def test_a_second_drop_begins_where_the_bodies_lie(self):
        twice = self.seen["twice"]
        self.assertGreater(min(twice["fallen"]), 0.1)
        self.assertGreater(twice["raised"][0], 0.1)
        self.assertLess(twice["raised"][0], 0.3)  # 0.2 m up, and turned by 0.2 rad at most about each axis
        self.assertLess(twice["raised"][1], 1e-6)
        self.assertLess(twice["landed"][1], 1e-3)

    def test_a_box_bounces_as_high_as_it_should(self):
        self.assertAlmostEqual(self.seen["bounced"] / (0.6 ** 2 * 0.5), 1, delta=0.05)

    def test_nothing_flies_through_a_thin_plate(self):
        self.assertEqual(len(self.seen["tunnelled"]), 9)
        for height in self.seen["tunnelled"]:
            self.assertGreater(height, 0)

    def test_a_heap_comes_to_rest_above_the_ground(self):
        heap = self.seen["heap"]
        print(f"a step of seven bodies takes {heap['milliseconds']:.2f} ms")
        self.assertTrue(heap["rests"])
        self.assertLess(heap["seconds"], 10)
        self.assertGreater(heap["lowest"], 0.0149)  # half the thickness of the thinnest
        self.assertLess(heap["grown"], 1e-3)
        self.assertLess(heap["deepest"], 0.02)

    def test_an_impact_has_its_impulse_and_its_moment(self):
        impacts = self.seen["impacts"]
        fall = 0.2
        speed = math.sqrt(2 * GRAVITY * fall)
        self.assertAlmostEqual(impacts["time"], speed / GRAVITY, delta=STEP)
        self.assertEqual(len(impacts["events"]), 4)  # corners
        self.assertEqual(len({event["contact"] for event in impacts["events"]}), 4)
        self.assertAlmostEqual(sum(event["impulse"] for event in impacts["events"]) / (2 * speed * 1.5), 1, delta=0.02)


if __name__ == "__main__":
    unittest.main()
