#!/usr/bin/python3
"""Bodies that the Sonic Explorer makes in the browser, against the sound maps of ideal bodies and against exact frequencies."""
import json
import math
import pathlib
import shutil
import unittest

import h5py
import numpy

import program
from web import in_browser

MODES = 12
SQUARE = [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]]
BODIES = {
    "string": {"type": "string", "length": 0.6, "width": 0.002, "tension": 80, "density": 0.005, "friction": 0.003},
    "bar": {"type": "bar", "length": 0.3, "width": 0.03, "stiffness": 50, "density": 1.1, "friction": 0.002, "ends": "free"},
    "arm": {"type": "bar", "length": 0.2, "width": 0.03, "stiffness": 50, "density": 1.1, "friction": 0.002, "ends": "clamped_free"},
    "beam": {"type": "bar", "length": 0.2, "width": 0.03, "stiffness": 50, "tension": 500, "density": 1.1, "friction": 0,
             "ends": "supported"},
    "plate": {"type": "plate", "length": 0.3, "width": 0.21, "stiffness": 90, "tension": 200, "density": 12, "friction": 0.004},
    "square": {"type": "membrane", "polygon": [[0.15 * x / 0.5, 0.15 * y / 0.5] for x, y in SQUARE], "tension": 1500, "density": 0.3,
               "friction": 0.01},
    "disc": {"type": "membrane", "radius": 0.15, "tension": 1500, "density": 0.3, "friction": 0.01},
}
POSITION = [0.1, 0.2, 0.05]
LISTENER = [0.3, -0.4, 0.6]
BESSEL = [2.404826, 3.831706, 3.831706, 5.135622, 5.135622, 5.520078]  # zeros of J0, J1, J1, J2, J2, J0


def recipe(body):
    """As the page has it."""
    made = {"tension": 0, "stiffness": 0, "ends": "supported", **body, "kind": body["type"], "position": POSITION, "modes": MODES}
    if body["type"] == "membrane":
        disc = [[0.5 * math.cos(math.pi * n / 60), 0.5 * math.sin(math.pi * n / 60)] for n in range(120)]
        made.update(length=0.3, outline=SQUARE if "polygon" in body else disc)
    return made


def complex_pressure(numbers):
    parts = numpy.asarray(numbers, dtype=float).reshape(-1, 2)
    return parts[:, 0] + 1j * parts[:, 1]


class MadeBodies(program.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(program.tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        deck, page = cls.folder / "ideal.yaml", cls.folder / "explorer.html"
        bodies = {name: {**body, "position": POSITION} for name, body in BODIES.items()}
        deck.write_text(json.dumps({"name": "ideal", "ideal_bodies": bodies,
                                    "listeners": {"ear": {"type": "mono", "position": LISTENER}}}))  # JSON is YAML
        job = program.idiophone("map", deck, "--modes", MODES, "--output-folder", cls.folder)
        assert job.returncode == program.FINISHED, job.stdout + job.stderr
        job = program.idiophone("explore", "-o", page)
        assert job.returncode == program.FINISHED, job.stdout + job.stderr
        page.write_text(page.read_text().replace("[0.3,-0.5,0.5]", json.dumps(LISTENER)))  # its listener
        cls.seen = in_browser("made.mjs", page, json.dumps({name: recipe(body) for name, body in BODIES.items()}), cls.folder / "page.png")

    def pairs(self):
        """Name, body as the page makes it, and its sound map."""
        for made in self.seen["made"]:
            with h5py.File(self.folder / f"ideal_{made['name']}.map.h5") as file:
                yield made["name"], made, file

    def test_a_page_without_maps_begins_with_a_string(self):
        self.assertEqual(self.seen["complaints"], [])
        self.assertEqual(self.seen["begins"], ["string"])

    def test_frequencies_and_decays_are_those_of_the_map(self):
        for name, made, file in self.pairs():
            tolerance = 2e-3 if BODIES[name]["type"] == "membrane" else 1e-9  # finite elements here and there
            numpy.testing.assert_allclose(made["frequency"], file["modes/frequency"], rtol=tolerance, err_msg=name)
            numpy.testing.assert_allclose(made["materialDecay"], file["modes/material_decay"], rtol=tolerance, err_msg=name)

    def test_radiation_is_that_of_the_map(self):
        for name, made, file in self.pairs():
            frequency = file["modes/frequency"][:]
            modes = [0, 5] if name == "disc" else [0] if name == "square" else frequency < 8000  # others are pairs, mixed at will
            here, there = complex_pressure(made["pressure"])[modes], complex_pressure(file["listeners/pressure"][:, 0])[modes]
            self.assertAlmostEqual(made["delay"], file["listeners/delay"][0], places=6)
            difference = numpy.minimum(abs(here - there), abs(here + there))
            self.assertLess(max(difference / abs(there).max()), 0.01, name)
            decay = file["modes/radiation_decay"][:]
            numpy.testing.assert_allclose(numpy.array(made["radiationDecay"])[modes], decay[modes], rtol=0.03, atol=1e-3 * decay.max(),
                                          err_msg=name)

    def test_a_drawn_square_and_a_circle_have_the_exact_frequencies(self):
        wave = math.sqrt(2000 / 0.26)  # m/s, of the membrane that the button makes, 0.3 m wide
        square = [wave / 0.6 * math.hypot(m, n) for m, n in ((1, 1), (1, 2), (2, 1), (2, 2), (1, 3), (3, 1))]
        circle = [wave * root / (2 * math.pi * 0.15) for root in BESSEL]
        numpy.testing.assert_allclose(self.seen["square"]["frequency"], square, rtol=0.01)
        numpy.testing.assert_allclose(self.seen["circle"]["frequency"], circle, rtol=0.01)
        self.assertEqual(self.seen["circle"]["error"], "")

    def test_an_outline_that_crosses_itself_is_refused(self):
        self.assertIn("crosses itself", self.seen["eight"]["error"])
        self.assertEqual(self.seen["eight"]["frequency"], self.seen["square"]["frequency"])

    def test_the_drawn_membrane_sounds_at_its_first_frequency(self):
        self.assertGreater(self.seen["heard"]["first"], 3 * self.seen["heard"]["between"])


if __name__ == "__main__":
    unittest.main()
