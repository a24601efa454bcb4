#!/usr/bin/python3
"""Bodies that fall in the Sonic Explorer: they sound as `play` has their impacts, and come to rest on the ground."""
import json
import pathlib
import shutil
import unittest

import numpy

import program
from roughness import expected_level, level
from web import in_browser, page_of_room

RATE = 44100
STEP = 0.01  # s
DECK = """
name: room
ideal_bodies:
  plate: {type: plate, length: 0.3, width: 0.2, stiffness: 2000, density: 8, friction: 0.003}
  tile: {type: plate, length: 0.2, width: 0.15, stiffness: 900, density: 6, friction: 0.002, position: [0.05, 0.03, 0.01]}
listeners:
  ear: {type: mono, position: [0.3, -0.3, 0.5]}
"""
STONE = {"young": 5e10, "poisson": 0.2, "radius": 1e3, "height": 1e-5, "friction": 0.4}
STEEL = {"young": 2e11, "poisson": 0.3, "radius": 5e-3, "height": 1e-6, "friction": 0.4}
POLISHED = {**STEEL, "height": 5e-8}
SURFACES = [STONE, STEEL, STEEL, POLISHED, POLISHED]  # of the ground, of both bodies, and of what slides
NAMES = ["plate", "tile"]


def event(contact, pair, point, normal, impulse, **more):
    return {"contact": contact, "bodies": pair, "surfaces": [body + 1 for body in pair], "point": point, "normal": normal,
            "impulse": impulse, "slip": [0, 0, 0], "roll": 0, "mass": 0.02, "moment": 0, **more}


IMPACTS = {  # by the step
    1: [event(1, [0, -1], [0.081, 0.063, 0], [0, 0, 1], 0.05, moment=100 / 441)],
    3: [event(2, [1, -1], [0.1, 0.071, 0.01], [0, 0, 1], 0.02), event(3, [0, 1], [0.113, 0.089, 0.005], [0, 0.6, -0.8], 0.06, mass=0.2)],
    9: [event(1, [0, -1], [0.24, 0.043, 0], [0, 0, 1], 0.15, moment=400 / 441)],
}
SLIDE = event(5, [0, -1], [0.1, 0.1, 0], [0, 0, 1], 0.02, slip=[0.5, 0, 0], mass=0.05, surfaces=[3, 4])  # a load of 2 N


def hardness(first, second):
    """By Hertz' law, N/m^(3/2)."""
    compliance = sum((1 - side["poisson"] ** 2) / side["young"] for side in (first, second))
    return 4 / 3 / compliance / numpy.sqrt(1 / first["radius"] + 1 / second["radius"])


def used(contact, step):
    """To what impulse a contact is used since its impacts before: that falls by a factor of e in 0.1 s."""
    before = [(there, one["impulse"]) for there, events in IMPACTS.items() for one in events if there < step and one["contact"] == contact]
    return max((impulse * numpy.exp((there - step) * STEP / 0.1) for there, impulse in before), default=0)


def score():
    """The blows of `play` that the impacts are."""
    blows = []
    for step, events in IMPACTS.items():
        for one in events:
            impulse = one["impulse"] - used(one["contact"], step)
            for side, body in enumerate(one["bodies"]):
                if body >= 0:
                    direction = [part * (-1 if side else 1) for part in one["normal"]]
                    stiff = hardness(*(SURFACES[number] for number in one["surfaces"]))
                    blows.append({"time": (step + one["moment"]) * STEP, "body": NAMES[body], "at": one["point"], "direction": direction,
                                  "mass": one["mass"], "hardness": stiff, "speed": impulse / (2 * one["mass"])})
    return {"duration": 0.4, "events": blows}


TOOL = {"mass": SLIDE["mass"], "hardness": hardness(POLISHED, POLISHED), "load": SLIDE["impulse"] / STEP, "size": 1e-4,
        "height": numpy.sqrt(2) * POLISHED["height"],  # both surfaces are rough
        "roughness": {"exponent": 1, "longest": 5e-3, "shortest": 2e-5}}


class Drop(program.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(program.tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        page, cls.maps = page_of_room(cls.folder, DECK, NAMES, 8000)
        given = {"surfaces": SURFACES, "steps": [IMPACTS.get(step, []) for step in range(40)], "step": STEP, "rate": RATE, "seconds": 0.4,
                 "slide": SLIDE}
        cls.seen = in_browser("drop.mjs", page, json.dumps(given), cls.folder / "drop.png")

    def setUp(self):
        super().setUp()
        self.assertEqual(self.seen["isThere"], self.seen["isCompiled"])
        if not self.seen["isCompiled"]:
            self.skipTest("the program was built without WebAssembly")

    def test_impacts_sound_as_play_has_them(self):
        path, wav = self.output / "score.yaml", self.output / "sound.wav"
        path.write_text(json.dumps(score()))
        job = program.idiophone("play", *self.maps, "--score", path, "--output", wav, "--rate", RATE)
        self.require_status(job, program.FINISHED)
        expected = program.wav_samples(wav).astype(float)
        heard = numpy.array(self.seen["sound"][0])
        self.assertEqual(len(heard), len(expected))
        expected *= numpy.dot(expected, heard) / numpy.dot(expected, expected)  # a WAV file has a full scale
        difference = 20 * numpy.log10(numpy.linalg.norm(heard - expected) / numpy.linalg.norm(heard))
        print(f"the page and play differ by {difference:.1f} dB")
        self.assertLess(difference, -60)

    def test_sliding_has_the_load_and_the_spectrum_of_the_roughness(self):
        force = numpy.array(self.seen["slid"])
        self.assertAlmostEqual(force.mean(), SLIDE["impulse"] / STEP, delta=0.01)
        for low, high in ((200, 600), (600, 1200), (1200, 2400)):
            heard, expected = level(force, RATE, low, high), expected_level(TOOL, SLIDE["slip"][0], low, high)
            self.assertLess(abs(20 * numpy.log10(heard / expected)), 1.5, f"{low} to {high} Hz")

    def test_bodies_fall_sound_and_lie_on_the_ground(self):
        fallen = self.seen["fallen"]
        self.assertEqual(self.seen["complaints"], [])
        self.assertFalse(fallen["ended"], "the audio thread ended")
        self.assertGreater(fallen["loudest"], 1e-4)
        for body in fallen["lying"]:
            self.assertTrue(body["moved"])
            self.assertLess(abs(body["height"]), 0.05)
        self.assertLess(min(abs(body["height"]) for body in fallen["lying"]), 2e-3)

    def test_a_click_strikes_a_body_where_it_lies(self):
        self.assertRegex(self.seen["fallen"]["struck"], r"^(plate|tile) struck at ")
        self.assertLess(self.seen["fallen"]["missed"], 1)  # pixels
        self.assertEqual(self.seen["fallen"]["back"], [False, False])


if __name__ == "__main__":
    unittest.main()
