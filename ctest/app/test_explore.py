#!/usr/bin/python3
"""`idiophone explore`: the page opens in Chromium, bodies sound when they are struck, and sound as `play` has them."""
import json
import os
import pathlib
import shutil
import subprocess
import unittest

import numpy

import program
from web import MODULES, install_modules

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
        install_modules()
        cls.folder = pathlib.Path(program.tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        job = program.idiophone("map", program.deck("simple"), "--count", 30, "--output", cls.folder)
        assert job.returncode == program.FINISHED, job.stdout + job.stderr
        cls.map, = cls.folder.glob("*.map.h5")
        cls.page = cls.folder / "explorer.html"
        job = program.idiophone("explore", cls.map, "-o", cls.page)
        assert job.returncode == program.FINISHED, job.stdout + job.stderr
        ray = {"time": 0.01, "body": 0, "origin": [0.021, 0.013, 1], "direction": [0, 0, -1], "hammer": BLOW}
        answer = subprocess.run(
            ["node", program.SOURCE / "ctest/web/explorer.mjs", cls.page,
             json.dumps({"blows": [ray], "duration": 0.3, "rate": RATE}), cls.folder / "page.png"],
            env={**os.environ, "WEB_MODULES": str(MODULES)}, capture_output=True, text=True, timeout=program.TIMEOUT)
        assert answer.returncode == 0, answer.stdout + answer.stderr
        cls.seen = json.loads(answer.stdout)

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

    def test_a_blow_sounds_as_play_has_it(self):
        score, wav = self.output / "score.yaml", self.output / "sound.wav"
        score.write_text(SCORE)
        job = program.idiophone("play", self.map, "--score", score, "--output", wav, "--rate", RATE)
        self.require_status(job, program.FINISHED)
        raw = wav.read_bytes()
        expected = numpy.frombuffer(raw[raw.index(b"data") + 8:], dtype="<f4").astype(float)
        heard = numpy.array(self.seen["sound"][0])
        self.assertEqual(len(heard), len(expected))
        expected *= numpy.dot(expected, heard) / numpy.dot(expected, expected)  # full scale
        difference = numpy.linalg.norm(heard - expected) / numpy.linalg.norm(heard)
        self.assertLess(20 * numpy.log10(difference), -60)

    def test_maps_of_different_decks_are_refused(self):
        job = program.idiophone("map", program.deck("simple"), "--count", 2, "--output", self.output,
                                "--set", "listeners.ear.position=[0, 0, 0.5]")
        self.require_status(job, program.FINISHED)
        other, = self.output.glob("*.map.h5")
        job = program.idiophone("explore", self.map, other, "-o", self.output / "page.html")
        self.require_status(job, program.FAILED)
        self.assertIn("different listeners; take maps of one deck", job.stdout + job.stderr)


if __name__ == "__main__":
    unittest.main()
