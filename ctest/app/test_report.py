#!/usr/bin/python3
"""`idiophone report`: the page opens in Chromium without complaints and shows what is in the results."""
import functools
import json
import os
import pathlib
import re
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

    @staticmethod
    @functools.cache
    def see_first():
        """What the page of the first result shows."""
        test = Report()
        test.setUp()
        try:
            return test.see(Report.results[0])
        finally:
            test.doCleanups()

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
        seen = Report.see_first()
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
        self.assertGreater(len(seen["facts"]), 20)
        self.assertLess(seen["zoomed"], 0.6)
        self.assertTrue(seen["narrow"], "the page is wider than a phone")
        self.assertEqual(set(seen["scrolling"]), {"pan-y"}, "a finger on a plot does not scroll the page")
        self.assertEqual(seen["unlabelled"], 0)
        self.assertLess(max(seen["dark"][:3]), 80)
        self.assertGreater(min(seen["light"][:3]), 200)

    def test_keys_zoom_and_move(self):
        keys = Report.see_first()["byKeys"]
        self.assertLess(keys["size"], 0.75)
        self.assertGreater(keys["from"], 0.15)

    def test_facts_have_units(self):
        facts = dict(Report.see_first()["facts"])
        self.assertRegex(facts["step"], r"^[\d.e-]+ s$")
        self.assertRegex(facts["mass"], r"^[\d.]+ kg$")
        self.assertRegex(facts["jobs / 0 / stages / motion"], r"^[\d.e-]+ s$")
        without = {name.split(" / ")[-1] for name, value in facts.items() if re.fullmatch(r"\d*\.\d+(e-\d+)?", value)}
        self.assertLessEqual(without, {"worst_quality", "gain"})

    def test_the_spectrogram_shows_energy(self):
        pictures = Report.see_first()["pictures"]
        self.assertGreater(pictures["quietestClick"], -6, "a click between two columns is missing")
        self.assertLess(pictures["smear"], 3, "the cut at the end looks like a click")
        self.assertAlmostEqual(pictures["level"], 0, delta=2.5)

    def modes_beside(self, name, *overrides):
        """A copy of a result with modes of its first body, by another set of overrides."""
        folder = self.output / name
        folder.mkdir()
        shutil.copy(self.results[0], folder)
        job = program.idiophone("modes", program.deck("rich"), "--modes", "8", "--output-folder", folder,
                                "--set", "name=first", "--set", "materials.foam.young=2.0e7", *overrides)
        self.require_status(job, program.FINISHED)
        return folder / "first.h5"

    def test_shows_modes_of_its_own_bodies(self):
        seen = self.see(self.modes_beside("own", "--set", "time.duration=3"))
        self.assertEqual(seen["complaints"], [])
        self.assertEqual(seen["modesNote"], "")
        self.assertEqual(len(seen["modes"]), 8)
        self.assertEqual(len(seen["images"]), 8)
        self.assertGreater(min(seen["images"]), 100)
        self.assertRegex(seen["modes"][0], r"^\w+ 1: [\d.]+ Hz.*, mesh error \u2212?[\d.]+ cents$")

    def test_shows_modes_of_older_programs(self):
        result = self.modes_beside("older")
        seen = self.see(result)["modes"]
        path, = result.parent.glob("*_modes.h5")
        with h5py.File(path, "a") as file:
            for body in file["modes"].values():
                del body["kind"], body["kinetic_share"]
        self.assertEqual(self.see(result)["modes"], seen)

    def test_leaves_out_modes_of_another_deck_or_mesh(self):
        others = {"deck": ("materials.laminate.density=1200", "materials.laminate.density has another value"),
                  "mesh": ("bodies.bar.parameters.size=0.05", "they are of another mesh")}
        for name, (override, reason) in others.items():
            seen = self.see(self.modes_beside(name, "--set", override))
            self.assertEqual(seen["modes"], [])
            self.assertIn(reason, seen["modesNote"])

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
        self.assertIn("partials of 3 impacts", seen["partialsNote"])
        self.assertEqual(contacts, ("blow", "\u2013", "blow"))
        self.assertEqual(forces, ("12.0", "\u2013", "56.0"))
        for expected, found in zip((700, 2100, 5200), strongest):
            self.assertIn(f"{expected}.0", found)
        self.assertGreater(seen["highest"], 5200)
        self.assertAlmostEqual(seen["last"]["from"], 1.38, delta=0.011)
        self.assertIn("impact at 1.4", seen["last"]["note"])
        self.assertEqual(seen["last"]["pressed"], 1)
        self.assertTrue(any(abs(frequency - 5200) < 1 for frequency in seen["last"]["frequencies"]))

    def test_compares_two_results(self):
        seen = self.see(*self.results)
        self.assertEqual(seen["complaints"], [])
        self.assertEqual(seen["swapped"], "Heard: B")
        self.assertNotEqual(seen["pairs"], [])

    def test_sounds_of_different_units_are_not_compared(self):
        other = self.output / "other.h5"
        shutil.copy(self.results[1], other)
        with h5py.File(other, "a") as file:
            for sound in file["audio"].values():
                sound.attrs["unit"] = "Pa m"
        seen = self.see(self.results[0], other)
        self.assertEqual(seen["complaints"], [])
        self.assertEqual(seen["pairs"], [])

    def test_refuses_what_has_no_sound(self):
        job = program.idiophone("report", self.output / "none.h5", "-o", self.output / "page.html")
        self.require_status(job, program.FAILED)
        self.assertFalse((self.output / "page.html").exists())


if __name__ == "__main__":
    unittest.main()
