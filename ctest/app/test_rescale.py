#!/usr/bin/python3
"""`idiophone map --rescale`: the map that a new solution gives, and what it refuses."""
import unittest

import numpy

import program

STIFFER = ("--set", "materials.rubber.young=8.0e7", "--set", "materials.rubber.damping={loss_factor: 0.01}")


class Rescale(program.TestCase):
    def map(self, folder, *arguments, ranks=None):
        job = program.idiophone("map", program.deck("tongue"), "--output-folder", self.output / folder, *arguments, ranks=ranks)
        return job, self.output / folder / "tongue_tongue.map.h5"

    def test_has_the_map_of_a_new_solution(self):
        job, old = self.map("old", "--modes", 4)
        self.require_status(job, program.FINISHED)
        job, new = self.map("new", "--rescale", old, *STIFFER, ranks=2)
        self.require_status(job, program.FINISHED)
        self.assertIn("the modes are those of", job.stdout + job.stderr)
        job, solved = self.map("solved", "--modes", 4, *STIFFER)
        self.require_status(job, program.FINISHED)
        made, expected = program.contents(new), program.contents(solved)
        self.assertEqual(made.keys(), expected.keys())
        for name, values in made.items():
            if name not in ("deck", "overrides", "resolved_deck") and values.dtype.kind == "f":
                numpy.testing.assert_allclose(values, expected[name], rtol=1e-5, atol=1e-5 * numpy.abs(expected[name]).max(),
                                              err_msg=name)
        self.require_status(program.idiophone("info", "--verify", new), program.FINISHED)

        job, damped = self.map("damped", "--rescale", old, "--set", "materials.rubber.damping={mass: 4}")
        self.require_status(job, program.FINISHED)
        self.assertIn("and so is their radiation", job.stdout + job.stderr)
        before, after = program.contents(old), program.contents(damped)
        for name in "sphere/pressure", "listeners/pressure", "modes/frequency", "modes/shape", "modes/radiation_decay":
            numpy.testing.assert_array_equal(after[name], before[name], name)
        numpy.testing.assert_allclose(after["modes/material_decay"], 2, rtol=1e-12)

        for arguments, said in (("old", STIFFER), "would be overwritten"), (("x", ("--modes", 3)), "--modes"), \
                (("x", ("--set", "materials.rubber.poisson=0.3")), "Poisson's ratio"):
            job, _ = self.map(arguments[0], "--rescale", old, *arguments[1])
            self.assertNotIn(job.returncode, (program.FINISHED, program.RESUMABLE), said)
            self.assertIn(said, job.stderr)


if __name__ == "__main__":
    unittest.main()
