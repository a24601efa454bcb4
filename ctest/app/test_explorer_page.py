#!/usr/bin/python3
"""The Sonic Explorer in use: its first view, clicks beside thin bodies, every control over its range, and its signs."""
import json
import pathlib
import shutil
import unittest

import numpy

import program
from roughness import expected_level, level
from web import in_browser, page_of_room

DECK = """
name: room
ideal_bodies:
  string: {type: string, length: 0.65, width: 0.001, tension: 6000, density: 0.004, friction: 0.002}
  plate: {type: plate, length: 0.3, width: 0.2, stiffness: 2000, density: 8, friction: 0.003, position: [0.1, 0.1, 0]}
listeners:
  ears: {type: stereo, position: [0.3, -0.3, 0.5], look: [0, 1, -1], up: [0, 0, 1], separation: 0.2}
"""

TOOL = {"mass": 0.05, "hardness": 1e10, "height": 1e-7, "load": 2, "size": 2e-4, "rate": 44100, "speeds": [0.2, 0.5],
        "bow": {"speed": 0.2, "load": 10},
        "roughness": {"exponent": 1, "longest": 5e-3, "shortest": 2e-5}}


class ExplorerPage(program.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = pathlib.Path(program.tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, folder)
        page, _ = page_of_room(folder, DECK, ["string", "plate"], 20000)
        cls.seen = in_browser("controls.mjs", page, folder / "page.png", "membrane")
        cls.stroked = in_browser("strokes.mjs", page, json.dumps(TOOL), folder / "strokes.png")

    def test_the_first_view_shows_all_bodies(self):
        for width, reach in self.seen["first"].items():
            self.assertLess(reach, 1, f"a {width} window crops the bodies")
            self.assertGreater(reach, 0.7, f"the bodies are small in a {width} window")

    def test_a_click_near_a_thin_body_strikes_it(self):
        self.assertEqual(self.seen["clicked"], ["string", "plate"])

    def test_it_sounds_with_every_control_anywhere(self):
        self.assertEqual(self.seen["complaints"], [])
        made = {f"made-{name}" for name in ("length", "tension", "density", "friction")}
        self.assertEqual(set(self.seen["moved"]), {"speed", "mass", "hardness", "friction", "size", "mode", "volume"} | made)
        self.assertEqual(self.seen["silent"], [])

    def test_a_body_that_was_small_gets_all_its_modes_back(self):
        regrown = self.seen["regrown"]
        self.assertGreater(regrown["fresh"], 0)
        self.assertAlmostEqual(regrown["grown"] / regrown["fresh"], 1, places=6)

    def test_it_says_when_the_sound_is_cut_off(self):
        self.assertTrue(self.seen["clipped"])

    def test_it_says_when_the_audio_thread_ends_and_starts_it_again(self):
        self.assertIn("audio thread", self.seen["ended"])
        self.assertTrue(self.seen["again"])

    def test_the_force_of_a_stroke_has_the_spectrum_of_the_roughness(self):
        forces = self.stroked["forces"]
        for name, speed in zip(("slow", "fast"), TOOL["speeds"], strict=True):
            for low, high in ((100, 300), (300, 600), (600, 1000)):
                heard, expected = level(forces[name], TOOL["rate"], low, high), expected_level(TOOL, speed, low, high)
                self.assertLess(abs(20 * numpy.log10(heard / expected)), 1.5, f"{speed} m/s, {low} to {high} Hz")
            self.assertAlmostEqual(numpy.mean(forces[name]), TOOL["load"], places=4)
        numpy.testing.assert_allclose(forces["rest"][-100:], TOOL["load"], atol=1e-3)

    def test_a_bowed_string_sounds_at_its_lowest_mode_until_the_bow_leaves(self):
        bowed, rate = self.stroked["bowed"], TOOL["rate"]
        if not bowed:
            self.skipTest("the program was built without WebAssembly")
        sound = numpy.array(bowed["sound"])

        def loudness(begin, end):
            return numpy.sqrt(numpy.mean(sound[int(begin * rate):int(end * rate)] ** 2))
        self.assertLess(abs(20 * numpy.log10(loudness(0.8, 1) / loudness(0.5, 0.7))), 0.5, "the string does not sing evenly")
        steady = sound[rate // 2:rate]
        spectrum = abs(numpy.fft.rfft(steady * numpy.hanning(len(steady)), 16 * len(steady)))
        loudest = numpy.argmax(spectrum) * rate / (16 * len(steady))
        self.assertLess(abs(1200 * numpy.log2(loudest / bowed["frequency"])), 10)  # cents
        fallen = numpy.log(loudness(1.4, 1.6) / loudness(1.7, 1.9))  # by the free decay of the lowest mode
        self.assertAlmostEqual(fallen / (0.3 * bowed["decay"]), 1, delta=0.02)

    def test_the_pointer_scrapes_rolls_and_bows(self):
        self.assertEqual(self.stroked["complaints"], [])
        drags = self.stroked["drags"]
        for name in drags.keys() - {"beside"}:
            self.assertGreater(drags[name]["loudest"], 1e-6, name)
            self.assertEqual(drags[name]["turned"], 0, "the room turns while the pointer scrapes")
            self.assertRegex(drags[name]["told"], r"^plate: [\d.e-]+ m/s, 1.0 N$")
            self.assertEqual(drags[name]["strokes"], 0, "the tool is not lifted off")
        self.assertNotEqual(drags["beside"]["turned"], 0)
        self.assertEqual(self.stroked["loads"], [1, 0.5, 2, 1])  # N, of mouse, pen and fingers for a slider of 1 N


if __name__ == "__main__":
    unittest.main()
