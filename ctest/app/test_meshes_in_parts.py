#!/usr/bin/python3
"""Ranks that read parts of the mesh files give the bits of one rank that reads all of them."""
import functools
import itertools
import json
import pathlib
import tempfile
import unittest
import zlib

import h5py
import program

PARTS = {"PETSC_OPTIONS": "-meshes_in_parts yes"}
SAYS_SO = "each rank reads its part of the meshes"


@functools.cache
def mesh_file(name, body, *settings):
    """The content of a mesh file of a body of a deck."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "body.mesh.h5"
        job = program.idiophone("mesh", program.deck(name), "--body", body, "-o", path, *settings)
        assert job.returncode == program.FINISHED, job.stderr
        return path.read_bytes()


def flip(rows):
    rows[-1, 0] ^= 1


def exchange(rows):
    rows[[-1, -2]] = rows[[-2, -1]]


class DecksWithMeshFiles(program.TestCase):
    def mesh(self, name, body, *settings):
        """A mesh file of a body of a deck."""
        path = self.output / f"{body}.mesh.h5"
        path.write_bytes(mesh_file(name, body, *settings))
        return path

    def rich_deck(self):
        """The rich deck, which has a pluck, with mesh files and a prestress."""
        text = "\n".join(line.replace("tap.csv", str(program.deck("rich").parent / "tap.csv"))
                         for line in program.deck("rich").read_text().splitlines()
                         if not line.strip().startswith("parameters:"))
        text = text.replace("material: laminate", "material: laminate\n    prestress: {xx: 5000}")
        for body, geometry in ("bar", "bar"), ("ball", "sphere"):
            text = text.replace(f"../../../meshes/{geometry}.geo", str(self.mesh("rich", body)))
        path = self.output / "rich.yaml"
        path.write_text(text)
        return path

    def materials_deck(self):
        """A wall of hexahedra in three layers and a turned mallet of two materials, which hits it."""
        text = program.deck("materials").read_text()
        for old, new in (
                ("square.geo", str(self.mesh("materials", "plate"))), ("mallet.geo", str(self.mesh("materials", "mallet"))),
                ("layers: [{material: rubber, thickness: 0.004}, {material: foam, thickness: 0.01}, {material: rubber, thickness: 0.006}]",
                 "materials: {1: rubber, 2: foam, 3: rubber}"),
                ("position: [-0.07, 0, 0.0302]", "position: [-0.07, 0, 0.0302]\n    rotation: {axis: [0, 0, 1], degrees: 40}\n"
                                                 "    spin: [0, 30, 5]")):
            self.assertIn(old, text)
            text = text.replace(old, new)
        path = self.output / "materials.yaml"
        path.write_text(text)
        return path

    def joined_deck(self):
        """Two blocks with all kinds of joints. One has scaled masses; the ranges of three ranks divide some of its columns."""
        lines = program.deck("joined").read_text().splitlines()
        text = "\n".join(line for line in lines if not line.strip().startswith("parameters:"))
        fine = "--set", "bodies.right.parameters={length: 0.06, width: 0.03, thickness: 0.012, size: 0.02}"
        for path in self.mesh("joined", "left"), self.mesh("joined", "right", *fine):
            text = text.replace("../../../meshes/bar.geo", str(path), 1)
        text = text.replace("velocity: [0, 1, 0]", "velocity: [0, 1, 0]\n    mass_scaling: {shift: 5}")
        text = text.replace("joints:\n", """joints:
  coil: {type: spring, between: [left.clamp, right.tip], stiffness: {axial: 200, lateral: 100}}
  pin: {type: hinge, between: [left.tip, right.clamp], axis: [[0.0603, -0.01, 0], [0.0603, 0.01, 0]]}
  stud: {type: bolt, between: [left.clamp, right.tip], axis: [[0, 0, 0], [0.1205, 0, 0]], radius: 0.02, shank: 0.003,
         material: rubber}
""")
        path = self.output / "joined.yaml"
        path.write_text(text)
        return path

    def run_deck(self, deck, folder, *arguments, ranks, environment=PARTS):
        return program.idiophone("run", deck, "--output-folder", self.output / folder, *arguments, ranks=ranks, environment=environment)


class MeshesInParts(DecksWithMeshFiles):
    def require_same_on_any_ranks(self, deck, channel):
        """@return what the run from whole meshes gives"""
        whole = self.run_deck(deck, "whole", ranks=1, environment={})
        self.require_status(whole, program.FINISHED)
        self.assertNotIn(SAYS_SO, whole.stdout + whole.stderr)
        expected = program.contents(self.output / f"whole/{deck.stem}.h5")
        self.assertGreater(abs(expected[channel]).max(), 0)
        for ranks in 1, 2, 3:
            job = self.run_deck(deck, f"parts_{ranks}", ranks=ranks)
            self.require_status(job, program.FINISHED)
            self.assertIn(SAYS_SO, job.stdout + job.stderr)
            self.require_same(self.output / f"parts_{ranks}/{deck.stem}.h5", expected)
        return expected

    def test_any_number_of_ranks_and_jobs_gives_the_bits_of_whole_meshes(self):
        deck = self.rich_deck()
        expected = self.require_same_on_any_ranks(deck, "audio/side")
        for number, ranks in enumerate(itertools.cycle((3, 1, 2)), start=1):  # the last job but one has whole meshes
            job = self.run_deck(deck, "jobs", "--set", "time.wall_clock_limit=1e-6", "--resume", ranks=ranks,
                                environment={} if number == 3 else PARTS)
            if job.returncode == program.FINISHED:
                break
            self.require_status(job, program.RESUMABLE)
        self.assertGreater(number, 3)
        self.require_same(self.output / "jobs/rich.h5", expected)

    def test_materials_hexahedra_and_places_give_the_bits_of_whole_meshes(self):
        self.require_same_on_any_ranks(self.materials_deck(), "contacts/hit/force")

    def test_joints_and_scaled_masses_give_the_bits_of_whole_meshes(self):
        self.require_same_on_any_ranks(self.joined_deck(), "audio/ear")

    def test_check_says_the_same_of_parts(self):
        deck = self.materials_deck()

        def facts(ranks, environment):
            job = program.idiophone("check", "--json", deck, ranks=ranks, environment=environment)
            self.require_status(job, program.FINISHED)
            self.assertEqual(SAYS_SO in job.stdout + job.stderr, environment is PARTS)
            return json.loads(job.stdout[job.stdout.index("{"):])["bodies"]

        whole = facts(1, {})
        for body in whole.values():
            body.pop("lowest_modes", None)  # need the elements
        for ranks in 1, 3:
            in_parts = facts(ranks, PARTS)
            for name, expected in whole.items():
                self.assertEqual(sorted(in_parts[name]), sorted(expected))
                for key, value in expected.items():
                    if key == "volume":
                        self.assertAlmostEqual(in_parts[name][key] / value, 1, delta=1e-12)
                    elif key != "regions":
                        self.assertEqual(in_parts[name][key], value, key)
                for number, region in expected["regions"].items():
                    self.assertAlmostEqual(in_parts[name]["regions"][number]["mass"] / region["mass"], 1, delta=1e-12)


    def test_check_predicts_the_parts_of_more_ranks_than_processes(self):
        deck = self.joined_deck()
        run = self.run_deck(deck, "run", ranks=3)
        self.require_status(run, program.FINISHED)
        job = program.idiophone("info", "--json", self.output / "run/joined.h5")
        jobs = json.loads(job.stdout)["run"]["jobs"]
        largest_part = jobs[0]["largest_part"]
        self.assertGreater(largest_part["ghost_nodes"], 0)
        for processes in 1, 2:
            job = program.idiophone("check", "--json", deck, "--ranks", 3, ranks=processes, environment=PARTS)
            self.require_status(job, program.FINISHED)
            self.assertIn(SAYS_SO, job.stdout + job.stderr)
            prediction = json.loads(job.stdout[job.stdout.index("{"):])["prediction"]
            self.assertEqual(prediction["largest_part"], largest_part)
            self.assertTrue(0 < prediction["speed_up"] <= 3, prediction)
            for memory in () if program.SANITIZED or processes > 1 else ("memory_bytes", "root_memory_bytes"):
                self.assertAlmostEqual(prediction[memory] / jobs[0][memory], 1, delta=0.25, msg=memory)
        job = program.idiophone("check", deck, "--ranks", 1, ranks=2, environment=PARTS)
        self.require_status(job, program.FAILED)
        self.assertIn("2 processes are too many for the parts of 1 ranks: use at most 1", job.stderr)
        self.assertNotIn(SAYS_SO, job.stdout + job.stderr)  # before anything is read
        job = program.idiophone("check", deck, "--ranks", 3, ranks=2)
        self.require_status(job, program.FAILED)
        self.assertIn("needs one process where meshes are read whole: start it without mpirun. Meshes are read in parts "
                      "from 4 million elements of .h5 files on", job.stderr)
        self.assertNotIn("body ", job.stdout + job.stderr)

    def test_what_needs_whole_meshes_reads_them(self):
        lines = program.deck("breaking").read_text().splitlines()
        text = "\n".join(line for line in lines if not line.strip().startswith("parameters:"))
        breaking = text.replace("seam.geo", str(self.mesh("breaking", "bar")))
        fracture = "fracture: [{surface: seam, strength: 5.0e4}]"
        self.assertIn(fracture, breaking)
        deck = self.output / "bar.yaml"
        for content in breaking, breaking.replace(fracture, "model: {type: modal, count: 1}"):
            deck.write_text(content)
            job = program.idiophone("run", deck, "--output-folder", self.output, "--set", "time.duration=1e-3", environment=PARTS)
            self.require_status(job, program.FINISHED)
            self.assertNotIn(SAYS_SO, job.stdout + job.stderr)


class FaultsOfMeshesInParts(DecksWithMeshFiles):
    def change(self, path, dataset, change, *, checksum=True):
        with h5py.File(path, "r+") as file:
            rows = file[dataset][()]
            change(rows)
            file[dataset][...] = rows
            if checksum:
                file[dataset].attrs.modify("crc32", zlib.crc32(rows.tobytes()))

    def require_refused(self, deck, body, why):
        job = self.run_deck(deck, "refused", ranks=3)
        self.assertEqual(job.returncode, program.WRONG_DECK, job.stderr)
        self.assertRegex(job.stderr, rf"{deck.name}:\d+:\d+: the mesh of body '{body}'.*{body}\.mesh\.h5")
        self.assertIn(why, job.stderr)

    def require_all_refused(self, deck, body, dataset, faults):
        """@param faults  of the body's file, one at a time: (change of the rows, whether the checksum follows, what is said)"""
        path = self.output / f"{body}.mesh.h5"
        content = path.read_bytes()
        for change, checksum, why in faults:
            path.write_bytes(content)
            self.change(path, dataset, change, checksum=checksum)
            self.require_refused(deck, body, why)

    def test_damaged_and_changed_elements_are_refused_by_all_ranks(self):
        def spoil(rows):
            rows[-1, 0] = -5

        self.require_all_refused(self.rich_deck(), "ball", "elements", (
            (flip, False, "/elements does not match its checksum: the file is damaged"),
            (exchange, True, "the file was changed"),
            (spoil, True, "/elements has the number -5")))

    def test_damaged_and_changed_groups_of_elements_are_refused_by_all_ranks(self):
        self.require_all_refused(self.materials_deck(), "mallet", "element_groups/members", (
            (flip, False, "/element_groups/members does not match its checksum: the file is damaged"),
            (exchange, True, "/element_groups has the list 'stick', which does not ascend")))


if __name__ == "__main__":
    unittest.main()
