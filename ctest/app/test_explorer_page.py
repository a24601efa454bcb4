#!/usr/bin/python3
"""The Sonic Explorer in use: its first view, clicks beside thin bodies, every control over its range, and its signs."""
import pathlib
import shutil
import unittest

import program
from web import in_browser

DECK = """
name: room
ideal_bodies:
  string: {type: string, length: 0.65, width: 0.001, tension: 6000, density: 0.004, friction: 0.002}
  plate: {type: plate, length: 0.3, width: 0.2, stiffness: 2000, density: 8, friction: 0.003, position: [0.1, 0.1, 0]}
listeners:
  ears: {type: stereo, position: [0.3, -0.3, 0.5], look: [0, 1, -1], up: [0, 0, 1], separation: 0.2}
"""


class ExplorerPage(program.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = pathlib.Path(program.tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, folder)
        deck, page = folder / "room.yaml", folder / "explorer.html"
        deck.write_text(DECK)
        job = program.idiophone("map", deck, "--up-to", 20000, "--output-folder", folder)
        assert job.returncode == program.FINISHED, job.stdout + job.stderr
        maps = [folder / f"room_{body}.map.h5" for body in ("string", "plate")]
        job = program.idiophone("explore", *maps, "-o", page)
        assert job.returncode == program.FINISHED, job.stdout + job.stderr
        cls.seen = in_browser("controls.mjs", page, folder / "page.png", "bar,membrane")

    def test_the_first_view_shows_all_bodies(self):
        for width, reach in self.seen["first"].items():
            self.assertLess(reach, 1, f"a {width} window crops the bodies")
            self.assertGreater(reach, 0.7, f"the bodies are small in a {width} window")

    def test_a_click_near_a_thin_body_strikes_it(self):
        self.assertEqual(self.seen["clicked"], ["string", "plate"])

    def test_it_sounds_with_every_control_anywhere(self):
        self.assertEqual(self.seen["complaints"], [])
        made = {f"made-{name}" for name in ("length", "tension", "stiffness", "density", "friction")}
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


if __name__ == "__main__":
    unittest.main()
