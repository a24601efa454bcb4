#!/usr/bin/python3
"""`idiophone report`: the page opens in Chromium without complaints and shows what is in the results."""
import json
import os
import pathlib
import shutil
import subprocess
import unittest

import h5py
import numpy

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
        answer = subprocess.run(["node", program.SOURCE / "ctest/web/report.mjs", page, page.with_suffix(".png")],
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

    def struck_three_times(self):
        """A result with two blows by a contact and one that only the sound tells, each with a tone of its own."""
        path = self.output / "blows.h5"
        rate = 16000
        time = numpy.arange(2 * rate) / rate
        sound, force = 0.5 * numpy.sin(2 * numpy.pi * 9 * time), numpy.zeros((len(time), 3))
        for begin, tone, by_contact in (0.3, 700.0, True), (0.8, 2100.0, False), (1.4, 5200.0, True):
            since = numpy.maximum(time - begin, 0)
            sound += (time >= begin) * numpy.exp(-since / 0.05) * numpy.sin(2 * numpy.pi * tone * since)
            force[(since > 0) & (since < 0.001) & by_contact, 2] = 40.0 * begin
        shutil.copy(self.results[0], path)
        with h5py.File(path, "a") as file:
            for group in "audio", "contacts", "frames", "motion", "energy":
                if group in file:
                    del file[group]
            for name, rows, unit in ("audio/ear", sound[:, None], "Pa"), ("contacts/blow/force", force, "N"):
                series = file.create_dataset(name, data=rows)
                columns = ["x", "y", "z"] if rows.shape[1] == 3 else ["ear"]
                series.attrs.update({"rate": float(rate), "unit": unit, "description": name, "columns": columns})
        return path

    def test_shows_each_impact(self):
        seen = self.see(self.struck_three_times())
        self.assertEqual(seen["complaints"], [])
        self.assertTrue(seen["impactsShown"])
        times, contacts, forces, _, _, strongest = zip(*seen["impacts"])
        numpy.testing.assert_allclose(list(map(float, times)), [0.3, 0.8, 1.4], atol=0.011)
        self.assertEqual(contacts, ("blow", "\u2013", "blow"))
        self.assertEqual(forces, ("12.0", "\u2013", "56.0"))
        for expected, found in zip((700, 2100, 5200), strongest):
            self.assertIn(f"{expected}.0", found)
        self.assertGreater(seen["highest"], 5200)
        self.assertAlmostEqual(seen["last"]["from"], 1.38, delta=0.011)
        self.assertIn("impact at 1.4", seen["last"]["note"])
        self.assertTrue(any(abs(frequency - 5200) < 1 for frequency in seen["last"]["frequencies"]))

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
