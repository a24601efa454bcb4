#!/usr/bin/python3
"""`idiophone explore`: the page opens in Chromium, bodies sound when they are struck, and sound as `play` has them."""
import json
import pathlib
import shutil
import unittest

import numpy

import program
from web import in_browser

RATE = 44100
BLOW = {"mass": 0.01, "hardness": 1e8, "speed": 1}
SCORE = """
duration: 0.3
events:
  - {time: 0.01, at: [0.021, 0.013, 0.01], direction: [0, 0, -1], mass: 0.01, hardness: 1e8, speed: 1}
"""


class Explore(program.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(program.tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        job = program.idiophone("map", program.deck("simple"), "--modes", 30, "--radiation", "kirchhoff",
                                "--output-folder", cls.folder)
        assert job.returncode == program.FINISHED, job.stdout + job.stderr
        cls.map, = cls.folder.glob("*.map.h5")
        cls.page = cls.folder / "explorer.html"
        job = program.idiophone("explore", cls.map, "-o", cls.page, "--proxies", program.deck("simple"), "--levels", 2)
        assert job.returncode == program.FINISHED, job.stdout + job.stderr
        ray = {"time": 0.01, "body": 0, "origin": [0.021, 0.013, 1], "direction": [0, 0, -1], "hammer": BLOW}
        blows = {"blows": [ray], "duration": 0.3, "rate": RATE}
        cls.seen = in_browser("explorer.mjs", cls.page, json.dumps(blows), cls.folder / "page.png")
        cls.views = in_browser("views.mjs", cls.page)
        cls.moved = in_browser("controls.mjs", cls.page, cls.folder / "controls.png")

    def test_the_page_opens_and_answers_to_clicks_and_keys(self):
        self.assertEqual(self.seen["complaints"], [])
        self.assertRegex(self.seen["said"], r"^plate struck at .* N for .* ms$")
        self.assertRegex(self.seen["mode"], r"^1: \d+\.\d Hz")
        self.assertTrue(self.seen["narrow"], "the page is wider than a phone")

    def test_a_room_of_200_000_triangles_moves_with_fewer_of_them(self):
        rate = self.seen["rate"]
        for state in ("still", "moving"):
            print(f"{state}: {rate[state]['all']:.1f} ms a picture of {rate['triangles']:.0f} triangles, "
                  f"{rate[state]['script']:.2f} ms of them in the script")
        self.assertTrue(rate["level"] > 0 or rate["moving"]["all"] < 1000 / 30, "slow pictures keep all their triangles")

    def test_it_sounds_with_every_control_of_modes_and_proxies_anywhere(self):
        self.assertEqual(self.moved["complaints"], [])
        self.assertLessEqual({"tension", "size", "friction", "model"}, set(self.moved["moved"]))
        self.assertEqual(self.moved["silent"], [])

    def test_views_show_the_proxies_from_three_sides_in_the_colour_of_their_level(self):
        self.assertEqual(self.views["complaints"], [])
        self.assertEqual([view["legend"] for view in self.views["levels"]],
                         ["plate: modes, priority 1", "plate: level 0, priority 1", "plate: level 1, priority 1"])
        colours = [view["colour"] for view in self.views["levels"]]
        self.assertTrue(abs(colours[0][0] - colours[0][1]) < 30)     # grey
        self.assertGreater(colours[1][1], colours[1][0] + 30)        # green
        self.assertGreater(colours[2][0], colours[2][2] + 30)        # brown
        drawn = self.views["drawn"]
        for what in ("springs", "masses", "surface"):
            self.assertGreater(min(drawn[what]), 20, f"{what} are missing in a view")
        self.assertGreater(drawn["surface"][0], drawn["springs"][0])
        self.assertGreater(drawn["springs"][0], drawn["masses"][0])
        self.assertGreater(drawn["surface"][0], drawn["surface"][1])  # the plate is larger from the top

    def test_a_click_on_a_view_strikes(self):
        self.assertRegex(self.views["said"], r"^plate struck at ")

    def test_the_waveform_has_the_last_two_seconds(self):
        waveform = self.views["waveform"]
        self.assertGreater(waveform["green"], 10)
        self.assertGreater(waveform["red"], 10)
        self.assertAlmostEqual(waveform["seconds"], 2, delta=0.05)
        self.assertEqual(waveform["before"], 0)

    def require_alike(self, wav, heard):
        """Up to their scales: a WAV file has a full scale."""
        expected = program.wav_samples(wav).astype(float)
        self.assertEqual(len(heard), len(expected))
        expected *= numpy.dot(expected, heard) / numpy.dot(expected, expected)
        difference = numpy.linalg.norm(heard - expected) / numpy.linalg.norm(heard)
        self.assertLess(20 * numpy.log10(difference), -60)

    def test_a_blow_sounds_as_play_has_it(self):
        score, wav = self.output / "score.yaml", self.output / "sound.wav"
        score.write_text(SCORE)
        job = program.idiophone("play", self.map, "--score", score, "--output", wav, "--rate", RATE)
        self.require_status(job, program.FINISHED)
        self.require_alike(wav, numpy.array(self.seen["sound"][0]))
        self.require_alike(wav, numpy.array(self.seen["javascript"][0]))

    def test_a_proxy_sounds_as_proxies_has_it(self):
        score, wav = self.output / "score.yaml", self.output / "sound.wav"
        score.write_text(SCORE + f"  - {{type: tune, time: 0, tension: 2, friction: {10 ** 0.5}}}\n")
        job = program.idiophone("proxies", program.deck("simple"), "--score", score, "--output", wav, "--set", f"audio.rate={RATE}",
                                "--set", "bodies.plate.parameters.size=0.1")
        self.require_status(job, program.FINISHED)
        self.require_alike(wav, numpy.array(self.seen["proxy"][0]))

    def test_options_of_proxies_need_proxies(self):
        for option in (("--springs", "fitted"), ("--levels", 2), ("--set", "time.duration=1")):
            job = program.idiophone("explore", self.map, "-o", self.output / "page.html", *option)
            self.assertNotEqual(job.returncode, program.FINISHED)
            self.assertIn(f"{option[0]} requires --proxies", job.stderr)
            self.assertFalse((self.output / "page.html").exists())

    def test_maps_of_different_decks_are_refused(self):
        job = program.idiophone("map", program.deck("simple"), "--modes", 2, "--output-folder", self.output,
                                "--set", "listeners.ear.position=[0, 0, 0.5]")
        self.require_status(job, program.FINISHED)
        other, = self.output.glob("*.map.h5")
        job = program.idiophone("explore", self.map, other, "-o", self.output / "page.html")
        self.require_status(job, program.FAILED)
        self.assertIn("different listeners; take maps of one deck", job.stdout + job.stderr)


if __name__ == "__main__":
    unittest.main()
