#!/usr/bin/python3
"""`idiophone modes`: its table, its files, the same on any ranks, and answers to wrong options."""
import re
import subprocess
import unittest

import h5py
import numpy

import program


class Modes(program.TestCase):
    def modes(self, name, *arguments, ranks=None):
        return program.idiophone("modes", program.deck(name), "--output-folder", self.output, *arguments, ranks=ranks)

    def found(self, name="simple", body="plate"):
        with h5py.File(self.output / f"{name}_modes.h5") as file:
            return {key: values[()] for key, values in file[f"modes/{body}"].items()}

    def test_table_and_file_agree(self):
        job = self.modes("simple", "--modes", "5", "--references", "1.5,900")
        self.require_status(job, program.FINISHED)
        self.assertIn("0 rigid motions", job.stdout)
        rows = [row.split() for row in job.stdout.splitlines() if re.match(r" +\d+  ", row)]
        found = self.found()
        self.assertEqual([int(row[0]) for row in rows], [1, 2, 3, 4, 5])
        for column, key, digits in (1, "frequency", 4e-5), (2, "damping_ratio", 1e-3), (3, "decay_time", 1e-2):
            numpy.testing.assert_allclose([float(row[column]) for row in rows], found[key], rtol=1e-3, atol=digits)
        omega = 2 * numpy.pi * found["frequency"]
        numpy.testing.assert_allclose(found["damping_ratio"], 20 / (2 * omega) + 1e-7 * omega / 2, rtol=1e-9)
        for row, frequency in zip(rows, found["frequency"]):
            cents = 1200 * numpy.log2(frequency / 900)
            self.assertEqual(row[4], f"{cents:+.1f}" if abs(cents) <= 100 else "-")

    def test_ranks_agree(self):
        self.require_status(self.modes("simple", "--modes", "4"), program.FINISHED)
        alone = self.found()
        self.require_status(self.modes("simple", "--modes", "4", ranks=3), program.FINISHED)
        together = self.found()
        numpy.testing.assert_allclose(together["frequency"], alone["frequency"], rtol=1e-9)
        self.assertEqual(together["shape"].shape, alone["shape"].shape)
        numpy.testing.assert_allclose(together["shape"][0], alone["shape"][0], atol=1e-6 * alone["shape"][0].max())

    def test_a_sound_has_the_frequencies_of_its_modes(self):
        self.require_status(self.modes("simple", "--modes", "1"), program.FINISHED)
        self.require_status(program.run("simple", self.output, "--set", "time.duration=0.2"), program.FINISHED)
        found = program.idiophone("analyze", self.output / "simple.h5", "--range", "30")
        first = float(re.search(r"(?m)^ +(\d+\.\d\d) ", found.stdout)[1])
        self.assertAlmostEqual(first / self.found()["frequency"][0], 1, delta=1e-3)
        picture = subprocess.run([program.SOURCE / "scripts/spectrum", self.output / "simple.h5", "--modes",
                                  self.output / "simple_modes.h5"], capture_output=True, text=True)
        self.require_status(picture, 0)
        picture = subprocess.run([program.SOURCE / "scripts/spectrum", self.output / "simple.h5", "--modes",
                                  self.output / "simple.h5"], capture_output=True, text=True)
        self.assertEqual(picture.returncode, 1)
        self.assertIn("has no modes", picture.stderr)

    def test_shapes_open(self):
        for body, cells in ("bar", "tetra10"), ("ball", "tetra"):
            self.require_status(self.modes("rich", "--body", body, "--modes", "3", ranks=2), program.FINISHED)
            check = subprocess.run([program.SOURCE / "tools/check_xdmf", self.output / f"rich_{body}_modes.xdmf"],
                                   capture_output=True, text=True)
            self.require_status(check, 0)
            self.assertEqual([line.split()[:3] for line in check.stdout.splitlines()],
                             [[f"{mode}.000000", body, cells] for mode in (1, 2, 3)])
            last = [float(value) for value in check.stdout.splitlines()[-1].split()[-3:]]
            numpy.testing.assert_allclose(last, self.found(f"rich_{body}", body)["shape"][2, -1], atol=1e-6)
            told = program.idiophone("info", self.output / f"rich_{body}_modes.h5")
            self.assertIn(f"/modes/{body}/shape ", told.stdout)

    def test_free_body_and_consistent_mass(self):
        job = self.modes("free", "--modes", "1", "--mass", "consistent", "--shift", "5")
        self.require_status(job, program.FINISHED)
        self.assertIn("consistent mass, 6 rigid motions", job.stdout)
        consistent = self.found("free", "ball")
        self.assertTrue(numpy.isinf(consistent["decay_time"][0]))
        self.require_status(self.modes("free", "--modes", "1"), program.FINISHED)
        self.assertLess(self.found("free", "ball")["frequency"][0], consistent["frequency"][0])

    def test_wrong_options(self):
        for ranks, arguments, *messages in (
                (None, ["--modes", "0"], "--modes must be at least 1"),
                (2, ["--modes", "100000"], "has no more than"),
                (None, ["--shift", "-3"], "--shift must be 0 Hz or above"),
                (None, ["--shift", "nan"], "--shift must be 0 Hz or above"),
                (None, ["--references", "100,0"], "--references must be frequencies above 0 Hz"),
                (None, ["--tolerance", "0"], "--tolerance must be above 0 cents"),
                (2, ["--body", "plaet"], "there is no body 'plaet'", "plate"),
                (None, ["--set", "bodies.plate.fixed=[]", "--shift", "0"], "can move rigidly in 6 ways"),
                (None, ["--set", "bodies.plate.fixed=[body]"], "all of it is held")):
            with self.subTest(arguments=arguments):
                job = self.modes("simple", *arguments, ranks=ranks)
                self.require_status(job, program.FAILED)
                for message in messages:
                    self.assertIn(message, job.stderr)
        self.assertGreater(self.modes("simple", "--mass", "heavy").returncode, 100)
        self.assertGreater(self.modes("simple", "--references", "high").returncode, 100)


if __name__ == "__main__":
    unittest.main()
