#!/usr/bin/python3
"""Finite elements on an accelerator sound as on the processor."""
import unittest

import program

ACCELERATOR = ("--accelerator", "0")  # any OpenCL device; pocl-opencl-icd is one without hardware


class Accelerator(program.TestCase):
    def setUp(self):
        super().setUp()
        job = program.run("simple", self.output / "none", "--accelerator", "no such device")
        self.require_status(job, program.FAILED)
        if "no such device" not in job.stderr:
            self.skipTest(job.stderr)

    def run_deck(self, name, folder, *arguments, ranks=1):
        job = program.run(name, self.output / folder, *arguments, ranks=ranks)
        self.require_status(job, program.FINISHED)
        return program.contents(self.output / folder / f"{name}.h5")

    def require_alike(self, found, expected, tolerance):
        for path in expected:
            if path.startswith(("audio/", "energy", "motion/")) and abs(expected[path]).max() > 0:
                error = abs(found[path] - expected[path]).max() / abs(expected[path]).max()
                self.assertLess(error, tolerance, path)

    def test_a_struck_plate_sounds_the_same_with_the_same_bits_on_any_ranks(self):
        expected = self.run_deck("simple", "processor")
        found = self.run_deck("simple", "one", *ACCELERATOR)
        self.require_alike(found, expected, 1e-8)
        on_ranks = self.run_deck("simple", "three", *ACCELERATOR, ranks=3)
        for path in found:
            if path.startswith("audio/"):
                self.assertEqual(on_ranks[path].tobytes(), found[path].tobytes(), path)

    def test_a_body_that_bounces_and_remembers_its_strain(self):
        settings = ("--set", "time.duration=0.02",
                    "--set", "materials.rubber.damping={loss_factor: 0.05, band: [100, 1000]}")
        expected = self.run_deck("bounce", "processor", *settings)
        self.require_alike(self.run_deck("bounce", "device", *settings, *ACCELERATOR), expected, 1e-6)

    def test_joined_bodies_on_two_ranks_move_as_on_the_processor(self):
        spring = "--set", ("joints.coil={type: spring, between: [left.clamp, right.clamp], stiffness: {axial: 200, lateral: 100}, "
                           "at: [0, 0, 0], radius: 1, damping: 1.0e-4}")
        expected = self.run_deck("joined", "processor", *spring)
        self.require_alike(self.run_deck("joined", "device", *spring, *ACCELERATOR, ranks=2), expected, 1e-8)

    def test_a_run_goes_on_on_the_other_side(self):
        settings = "--set", "time.duration=0.006"
        expected = self.run_deck("simple", "whole", *settings)
        self.run_in_jobs("simple", self.output / "turns", *settings, ranks=5 * (2, 1), options=(ACCELERATOR, ()))
        self.require_alike(program.contents(self.output / "turns" / "simple.h5"), expected, 1e-8)

    def test_what_a_device_cannot_do_is_refused(self):
        job = program.run("hexahedra", self.output, *ACCELERATOR)
        self.require_status(job, program.FAILED)
        self.assertIn("mass_scaling", job.stderr)
        job = program.run("simple", self.output, "--accelerate", "elements")
        self.assertNotEqual(job.returncode, program.FINISHED)
        self.assertIn("--accelerate requires --accelerator", job.stderr)


if __name__ == "__main__":
    unittest.main()
