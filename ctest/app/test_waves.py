#!/usr/bin/python3
"""Waves on a grid: the same bits on any ranks, and from checkpoints; what the check reports."""
import unittest

import program

WAVES = ("--set", "radiation={model: waves, cell: 0.03}", "--set", "time.duration=0.006")


class Waves(program.TestCase):
    def run_waves(self, folder, ranks=1):
        self.require_status(program.run("simple", self.output / folder, *WAVES, ranks=ranks), program.FINISHED)
        return self.output / folder / "simple.h5"

    def test_the_same_bits_on_any_ranks_and_after_a_stop(self):
        expected = program.contents(self.run_waves("one"))
        sounds = [path for path in expected if path.startswith("audio/")]
        self.assertTrue(sounds)
        for path in sounds:
            self.assertGreater(abs(expected[path]).max(), 0, path)
        self.require_same(self.run_waves("two", ranks=2), expected)
        limit = "--set", "time.wall_clock_limit=1e-6"  # stops at the end of the first block of each job
        for ranks in 5 * (2, 1):
            job = program.run("simple", self.output / "stopped", *WAVES, *limit, "--resume", ranks=ranks)
            if job.returncode == program.FINISHED:
                break
            self.require_status(job, program.RESUMABLE)
        self.require_status(job, program.FINISHED)
        self.require_same(self.output / "stopped" / "simple.h5", expected)

    def test_the_check_reports_the_grid(self):
        job = program.idiophone("check", program.deck("simple"), *WAVES)
        self.require_status(job, program.FINISHED)
        self.assertRegex(job.stdout + job.stderr, r"waves: \d+ x \d+ x \d+ cells of 0.03 m, \d+ steps")
        self.assertRegex(job.stdout + job.stderr, r"waves: levels hold up to 1143 Hz")

    def test_keys_that_other_models_do_not_have(self):
        for radiation, answer in (("{model: waves}", "the key 'cell' is missing"),
                                  ("{model: kirchhoff, cell: 0.01}", "only model waves uses it"),
                                  ("{model: waves, cell: 0.01, visibility: off}", "bend around bodies")):
            job = program.idiophone("check", program.deck("simple"), "--set", f"radiation={radiation}")
            self.require_status(job, program.WRONG_DECK)
            self.assertIn(answer, job.stderr)


if __name__ == "__main__":
    unittest.main()
