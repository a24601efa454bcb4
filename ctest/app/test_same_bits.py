#!/usr/bin/python3
"""One deck gives the same bits on any number of ranks, however often it is interrupted in between."""
import sys
import typing
import unittest

import program

sys.path.append(str(program.SOURCE / "scripts"))
from library import touching_cubes


class SameBits(program.TestCase):
    references: typing.ClassVar = {}  # contents by the name of the deck

    def reference(self, name):
        """The contents on one rank, which several tests compare with."""
        if name not in self.references:
            self.require_status(program.run(name, self.output / "one"), program.FINISHED)
            expected = program.contents(self.output / "one" / f"{name}.h5")
            for path, values in expected.items():
                if path.startswith("audio/"):
                    self.assertGreater(abs(values).max(), 0, f"{path} is silent: it tests nothing")
            self.references[name] = expected
        return self.references[name]

    def check_ranks(self, name):
        expected = self.reference(name)
        self.require_status(program.run(name, self.output, ranks=3), program.FINISHED)
        self.require_same(self.output / f"{name}.h5", expected)

    def check_interruptions(self, name):
        """Each job on another number of ranks, from one to four, computes a part."""
        expected = self.reference(name)
        jobs = self.run_in_jobs(name, self.output, ranks=2 * (4, 2, 1, 3, 2, 3))  # blocks have 16 samples
        self.assertGreaterEqual(jobs, 4)
        self.require_same(self.output / f"{name}.h5", expected)
        return expected

    @program.long_verification
    def test_simple_deck_on_three_ranks(self):
        self.check_ranks("simple")

    @program.long_verification
    def test_rich_deck_on_three_ranks(self):
        self.check_ranks("rich")

    @program.long_verification
    def test_simple_deck_interrupted_and_resumed_on_other_numbers_of_ranks(self):
        self.check_interruptions("simple")

    def test_rich_deck_interrupted_and_resumed_on_other_numbers_of_ranks(self):
        self.check_interruptions("rich")

    def test_hexahedra_on_three_ranks(self):
        self.check_ranks("hexahedra")

    @program.long_verification
    def test_hexahedra_interrupted_and_resumed_on_other_numbers_of_ranks(self):
        self.check_interruptions("hexahedra")

    @program.long_verification
    def test_several_materials_interrupted_and_resumed_on_other_numbers_of_ranks(self):
        overlap = self.check_interruptions("materials")["contacts/hit/overlap"]
        self.assertGreater(max(overlap), 0)

    @program.long_verification
    def test_taut_strings_interrupted_and_resumed_on_other_numbers_of_ranks(self):
        self.check_interruptions("taut")

    def test_joined_bodies_on_three_ranks(self):
        self.check_ranks("joined")

    @program.long_verification
    def test_joined_bodies_interrupted_and_resumed_on_other_numbers_of_ranks(self):
        self.check_interruptions("joined")

    @program.long_verification
    def test_touching_deck_on_three_ranks(self):
        self.check_ranks("touching")

    def test_touching_deck_interrupted_in_mid_contact_and_resumed_on_other_numbers_of_ranks(self):
        expected = self.check_interruptions("touching")
        for contact in ("hit", "rest"):
            overlap = expected[f"contacts/{contact}/overlap"]
            for sample in (16, 32, 48):
                self.assertGreater(min(overlap[sample - 1:sample + 1]), 0, f"{contact} is interrupted while apart")

    @program.long_verification
    def test_breaking_deck_on_three_ranks(self):
        self.check_ranks("breaking")

    def test_breaking_deck_interrupted_before_and_after_the_break(self):
        area = self.check_interruptions("breaking")["motion/bar/broken_area"]
        self.assertEqual(area[16], 0)  # the first interruption
        self.assertGreater(area[80], area[16])

    def test_ghosts_by_messages(self):
        """They travel while forces are computed: the surface is read in every eighth step only."""
        steps = "--set", "time.steps_per_sample=48", "--set", "time.duration=0.0005"
        for name in ("simple", "touching") if program.LONG else ("touching",):
            with self.subTest(deck=name):
                self.require_status(program.run(name, self.output / "1", *steps), program.FINISHED)
                job = program.run(name, self.output / "2", *steps, ranks=2,
                                  environment={"PETSC_OPTIONS": "-ghosts_by_messages"})
                self.require_status(job, program.FINISHED)
                self.require_same(self.output / f"2/{name}.h5", program.contents(self.output / f"1/{name}.h5"))

    @program.long_verification
    def test_touching_cubes_on_other_numbers_of_ranks(self):
        deck = self.output / "cubes.yaml"
        deck.write_text(touching_cubes.deck(2, duration=0.001))
        self.require_status(program.idiophone("run", deck, "--output-folder", self.output / "1"), program.FINISHED)
        expected = program.contents(self.output / "1/touching_cubes.h5")
        for contact in ("cube_000_cube_001", "cube_000_cube_010", "cube_000_cube_100", "cube_000_floor"):
            self.assertGreater(max(expected[f"contacts/{contact}/overlap"]), 0)
        for ranks in (2, 3):
            job = program.idiophone("run", deck, "--output-folder", self.output / str(ranks), ranks=ranks)
            self.require_status(job, program.FINISHED)
            self.require_same(self.output / f"{ranks}/touching_cubes.h5", expected)


if __name__ == "__main__":
    unittest.main()
