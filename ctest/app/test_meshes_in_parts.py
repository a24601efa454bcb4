#!/usr/bin/python3
"""Ranks that read parts of the mesh files give the bits of one rank that reads all of them."""
import itertools
import unittest
import zlib

import h5py
import program

PARTS = {"PETSC_OPTIONS": "-meshes_in_parts yes"}
SAYS_SO = "each rank reads its part of the meshes"


class MeshesInParts(program.TestCase):
    def setUp(self):
        super().setUp()
        self.deck = self.make_deck()

    def make_deck(self):
        """The rich deck with mesh files, without its pluck: a static equilibrium needs whole bodies."""
        lines = [line for line in program.deck("rich").read_text().splitlines() if "type: pluck" not in line]
        text = "\n".join(line.replace("tap.csv", str(program.deck("rich").parent / "tap.csv")) for line in lines
                         if not line.strip().startswith("parameters:"))
        for body, geometry in ("bar", "bar"), ("ball", "sphere"):
            path = self.output / f"{body}.mesh.h5"
            self.require_status(program.idiophone("mesh", program.deck("rich"), "--body", body, "-o", path), program.FINISHED)
            text = text.replace(f"../../../meshes/{geometry}.geo", str(path))
        path = self.output / "rich.yaml"
        path.write_text(text)
        return path

    def run_deck(self, folder, *arguments, ranks, environment=PARTS):
        return program.idiophone("run", self.deck, "--output-folder", self.output / folder, *arguments, ranks=ranks,
                                 environment=environment)

    def test_any_number_of_ranks_and_jobs_gives_the_bits_of_whole_meshes(self):
        whole = self.run_deck("whole", ranks=1, environment={})
        self.require_status(whole, program.FINISHED)
        self.assertNotIn(SAYS_SO, whole.stdout + whole.stderr)
        expected = program.contents(self.output / "whole/rich.h5")
        self.assertGreater(abs(expected["audio/side"]).max(), 0)
        for ranks in 1, 2, 3:
            job = self.run_deck(f"parts_{ranks}", ranks=ranks)
            self.require_status(job, program.FINISHED)
            self.assertIn(SAYS_SO, job.stdout + job.stderr)
            self.require_same(self.output / f"parts_{ranks}/rich.h5", expected)
        for number, ranks in enumerate(itertools.cycle((3, 1, 2)), start=1):  # the last job but one has whole meshes
            job = self.run_deck("jobs", "--set", "time.wall_clock_limit=1e-6", "--resume", ranks=ranks,
                                environment={} if number == 3 else PARTS)
            if job.returncode == program.FINISHED:
                break
            self.require_status(job, program.RESUMABLE)
        self.assertGreater(number, 3)
        self.require_same(self.output / "jobs/rich.h5", expected)

    def require_refused(self, why):
        for ranks in 1, 3:
            job = self.run_deck("refused", ranks=ranks)
            self.assertEqual(job.returncode, program.WRONG_DECK, job.stderr)
            self.assertRegex(job.stderr, r"rich.yaml:\d+:\d+: the mesh of body 'ball'.*ball\.mesh\.h5")
            self.assertIn(why, job.stderr)

    def change(self, change, *, checksum):
        """Changes the elements of the ball."""
        with h5py.File(self.output / "ball.mesh.h5", "r+") as file:
            elements = file["elements"]
            rows = elements[()]
            change(rows)
            elements[...] = rows
            if checksum:
                elements.attrs.modify("crc32", zlib.crc32(rows.tobytes()))

    def test_a_damaged_file_is_refused_by_all_ranks(self):
        def damage(rows):
            rows[-1, 0] ^= 1
        self.change(damage, checksum=False)
        self.require_refused("/elements does not match its checksum: the file is damaged")

    def test_a_changed_file_is_refused_by_all_ranks(self):
        def exchange(rows):
            rows[[-1, -2]] = rows[[-2, -1]]
        self.change(exchange, checksum=True)
        self.require_refused("the file was changed")

    def test_elements_of_nodes_that_there_are_not_are_refused_by_all_ranks(self):
        def spoil(rows):
            rows[-1, 0] = -5
        self.change(spoil, checksum=True)
        self.require_refused("/elements has the number -5")


if __name__ == "__main__":
    unittest.main()
