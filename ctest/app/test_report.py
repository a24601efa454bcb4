#!/usr/bin/python3
"""`idiophone report`: the page opens in Chromium without complaints and shows what is in the results."""
import json
import os
import pathlib
import shutil
import subprocess
import unittest

import h5py

import program
from web import MODULES, install_modules


class Report(program.TestCase):
    @classmethod
    def setUpClass(cls):
        install_modules()
        cls.folder = pathlib.Path(program.tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.results = []
        for name, young in ("first", 2.0e7), ("second", 2.1e7):
            job = program.run("rich", cls.folder / name, "--set", "time.duration=0.02", "--set", f"name={name}",
                              "--set", f"materials.foam.young={young}")
            assert job.returncode == program.FINISHED, job.stdout + job.stderr
            cls.results.append(cls.folder / name / f"{name}.h5")

    def see(self, *results):
        """What the page of some results shows."""
        page = self.output / "report.html"
        self.require_status(program.idiophone("report", *results, "-o", page), program.FINISHED)
        answer = subprocess.run(["node", program.SOURCE / "ctest/web/report.mjs", page, self.output / "report.png"],
                                env={**os.environ, "WEB_MODULES": str(MODULES)}, capture_output=True, text=True,
                                timeout=program.TIMEOUT)
        self.assertEqual(answer.returncode, 0, answer.stdout + answer.stderr)
        return json.loads(answer.stdout)

    def test_shows_one_result(self):
        seen = self.see(self.results[0])
        self.assertEqual(seen["complaints"], [])
        with h5py.File(self.results[0]) as file:
            sounds = list(file["audio"].values())
            self.assertEqual(seen["players"], len(sounds))
            for duration, sound in zip(sorted(seen["audio"]), sorted(len(sound) / sound.attrs["rate"] for sound in sounds)):
                self.assertAlmostEqual(duration, sound, places=3)
            self.assertEqual(seen["frames"], len(file["frames/time"]))
            self.assertEqual(seen["deck"].strip(), file["run/deck"][0].decode().strip())
            self.assertEqual(seen["plots"], 1 + len(file.get("contacts", [])))
            self.assertEqual(len(seen["accuracy"]), len(file["run/bodies"]))
        self.assertGreater(seen["facts"], 20)
        self.assertLess(seen["zoomed"], 0.6)
        self.assertTrue(seen["narrow"], "the page is wider than a phone")

    def test_compares_two_results(self):
        seen = self.see(*self.results)
        self.assertEqual(seen["complaints"], [])
        self.assertEqual(seen["swapped"], "Heard: B")

    def test_refuses_what_has_no_sound(self):
        job = program.idiophone("report", self.output / "none.h5", "-o", self.output / "page.html")
        self.require_status(job, program.FAILED)
        self.assertFalse((self.output / "page.html").exists())


if __name__ == "__main__":
    unittest.main()
