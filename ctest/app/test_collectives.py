#!/usr/bin/python3
"""Inside an audio block no rank waits for all the others: no collective MPI call."""
import re
import unittest

import program


class Collectives(program.TestCase):
    def check(self, name):
        job = program.run(name, self.output, ranks=2, environment=program.preload("COLLECTIVE_COUNTER"))
        self.require_status(job, program.FINISHED)
        counts = re.findall(r"rank \d: (\d+) blocks, (\d+) collective calls inside, (\d+) outside", job.stdout)
        self.assertEqual(len(counts), 2, job.stdout)
        for blocks, inside, outside in counts:
            self.assertGreater(int(blocks), 1)
            self.assertGreater(int(outside), 0)
            self.assertEqual(int(inside), 0)

    def test_none_inside_a_block_of_the_simple_deck(self):
        self.check("simple")

    def test_none_inside_a_block_of_the_rich_deck(self):
        self.check("rich")


if __name__ == "__main__":
    unittest.main()
