#!/usr/bin/python3
"""Inside an audio block no rank waits for all the others: no collective MPI call."""
import re
import unittest

import program


class Collectives(program.TestCase):
    def check(self, *arguments):
        job = program.idiophone(*arguments, "--output-folder", self.output, ranks=2,
                                environment=program.preload("COLLECTIVE_COUNTER"))
        self.require_status(job, program.FINISHED)
        counts = re.findall(r"rank \d: (\d+) blocks, (\d+) collective calls inside, (\d+) outside", job.stdout)
        self.assertEqual(len(counts), 2, job.stdout)
        for blocks, inside, outside in counts:
            self.assertGreater(int(blocks), 1)
            self.assertGreater(int(outside), 0)
            self.assertEqual(int(inside), 0)

    def test_none_inside_a_block_of_the_simple_deck(self):
        self.check("run", program.deck("simple"))

    def test_none_inside_a_block_of_the_rich_deck(self):
        self.check("run", program.deck("rich"))

    def test_none_inside_a_block_of_recording_and_listening(self):
        self.check("run", program.deck("simple"), "--set", "output.surface_motion=true")
        self.check("listen", self.output / "simple.h5")


if __name__ == "__main__":
    unittest.main()
