#!/usr/bin/python3
"""Joined bodies with large amplitudes, which have the modes of their assembly in common: whole runs, check and map."""
import unittest

import program

ELEMENTS = tuple(word for body in ("left", "right") for word in ("--set", f"bodies.{body}.model={{type: finite_elements}}"))


class CommonModes(program.TestCase):
    def result(self, folder, *arguments, ranks=1):
        self.require_status(program.run("glued_strips", self.output / folder, *arguments, ranks=ranks), program.FINISHED)
        return program.contents(self.output / folder / "glued_strips.h5")

    def test_they_move_as_finite_elements_and_keep_energy(self):
        found, expected = self.result("modes"), self.result("elements", *ELEMENTS)
        self.assertGreater(abs(expected["contacts/fall/force"]).max(), 0)
        for body in ("left", "right"):
            way, right = (result[f"motion/{body}/centre_of_mass"] - result[f"motion/{body}/centre_of_mass"][0]
                          for result in (found, expected))
            self.assertGreater(abs(right).max(), 1e-3)
            self.assertLess(abs(way - right).max() / abs(right).max(), 0.02)
        for column in (0, 1):  # of both strips together: kinetic, elastic
            of_strips, right = ((result["motion/left/energy"] + result["motion/right/energy"])[:, column]
                                for result in (found, expected))
            self.assertLess(abs(of_strips - right).max() / right.max(), 0.05)
        right = expected["motion/right/energy"][:, 0]
        self.assertLess(abs(found["motion/right/energy"][:, 0] - right).max() / right.max(), 0.05)
        energy = found["energy"]
        self.assertEqual(abs(energy[:, 5]).max(), 0)  # that of the joint is in the modes
        total = energy[:, :3].sum(axis=1) - energy[:, 4]
        self.assertLess(abs(total - total[0]).max() / energy[:, 4].max(), 0.005)

    def test_same_bits_on_two_ranks_and_through_resume(self):
        half = "--set", "time.duration=0.0025"  # the block has hit them
        expected = self.result("one", *half)
        self.result("two", *half, ranks=2)
        self.require_same(self.output / "two" / "glued_strips.h5", expected)
        self.run_in_jobs("glued_strips", self.output, *half, ranks=(2, 1, 1) * 5)
        self.require_same(self.output / "glued_strips.h5", expected)

    def test_check_says_whose_modes_they_are(self):
        job = program.idiophone("check", program.deck("glued_strips"))
        self.require_status(job, program.FINISHED)
        self.assertIn("held, 20 modes from", job.stdout)
        self.assertIn("moves by the modes of body left, which joints tie to it", job.stdout)


if __name__ == "__main__":
    unittest.main()
