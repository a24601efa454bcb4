#!/usr/bin/python3
"""`idiophone mesh`: a run from mesh files has the bits of the run from the geometries, on any number of ranks."""
import subprocess
import unittest

import program

# What the decks say of the meshes, and what they say where the meshes are files.
LAYERS = ("layers: [{material: rubber, thickness: 0.004}, {material: foam, thickness: 0.01}, {material: rubber, thickness: 0.006}]",
          "materials: {1: rubber, 2: foam, 3: rubber}")
SHORT = "--set", "time.duration=0.004"


def sets(changes):
    return [argument for change in changes for argument in ("--set", change)]


def obstacle(mesh):
    """A rock of this mesh, which the mallet can touch."""
    return [f"obstacles.rock={{shape: surface, at: [0, 0, -1], mesh: {mesh}}}", "contacts.rest={between: [mallet, rock]}"]


class MeshFile(program.TestCase):
    def make(self, name, *arguments):
        path = self.output / f"{name}.mesh.h5"
        job = program.idiophone("mesh", program.deck("materials"), "--body", name, "-o", path, *arguments)
        self.require_status(job, program.FINISHED)
        return path

    def deck(self):
        """The deck of two bodies, one a wall of layers, one moved, with files for their meshes."""
        text = program.deck("materials").read_text()
        for old, new in (("square.geo", self.make("plate")), ("mallet.geo", self.make("mallet")), LAYERS):
            self.assertIn(old, text)
            text = text.replace(old, str(new))
        path = self.output / "materials.yaml"
        path.write_text(text)
        return path

    def test_a_run_has_the_same_bits(self):
        self.require_status(program.run("materials", self.output / "geometry", *SHORT), program.FINISHED)
        expected = program.contents(self.output / "geometry/materials.h5")
        self.assertGreater(abs(expected["audio/ear"]).max(), 0)
        sound = (self.output / "geometry/materials.wav").read_bytes()
        deck = self.deck()
        for ranks in 1, 2, 3:
            folder = self.output / f"file_{ranks}"
            job = program.idiophone("run", deck, *SHORT, "--output-folder", folder, ranks=ranks)
            self.require_status(job, program.FINISHED)
            self.assertEqual((folder / "materials.wav").read_bytes(), sound)
            self.require_same(folder / "materials.h5", {**expected, "deck": program.contents(folder / "materials.h5")["deck"]})

    def test_info_describes_and_verifies_it(self):
        path = self.make("mallet")
        told = program.idiophone("info", path)
        self.require_status(told, program.FINISHED)
        self.assertRegex(told.stdout, r"mesh of the body 'mallet' of the deck 'materials'.*, mesh [0-9a-f]{16}\n"
                                      r"  \d+ nodes, \d+ elements, \d+ surface triangles\n  element: tet10\n")
        self.assertIn("groups of elements: head, stick", told.stdout)
        self.require_status(program.idiophone("info", "--verify", path), program.FINISHED)
        content = bytearray(path.read_bytes())
        content[len(content) // 2] ^= 1
        path.write_bytes(content)
        self.require_status(program.idiophone("info", "--verify", path), program.FAILED)

    def test_what_can_not_be_is_refused(self):
        plate = self.make("plate")
        for arguments, why in (
                (("mesh", program.deck("materials"), "-o", self.output / "plate.msh"), "the name of a mesh must end in .h5"),
                (("mesh", program.deck("materials"), "--body", "bell"), "mallet"),
                (("mesh", program.deck("materials"), "--set", f"bodies.plate.mesh={plate}", "-o", plate), str(plate))):
            job = program.idiophone(*arguments)
            self.assertNotEqual(job.returncode, program.FINISHED)
            self.assertIn(why, job.stderr)
        deck = self.deck()
        for key in "parameters={size: 0.1}", "meshing={time_limit: 10}":
            job = program.idiophone("check", deck, "--set", f"bodies.plate.{key}")
            self.assertEqual(job.returncode, program.WRONG_DECK)
            self.assertIn("a .h5 file is a mesh already", job.stderr)
        job = program.idiophone("check", deck, "--set", "bodies.plate.order={plane: 3, thickness: 3}")
        self.assertEqual(job.returncode, program.WRONG_DECK)
        self.assertRegex(job.stderr, r"materials.yaml:\d+:\d+: .*plate.mesh.h5 has `element: hex, order")

    def test_no_mesh_of_the_deck_is_overwritten(self):
        plate = self.make("plate")
        before = plate.read_bytes()
        for change in [f"bodies.plate.mesh={plate}"], obstacle(plate):
            job = program.idiophone("mesh", program.deck("materials"), "--body", "mallet", "-o", plate, *sets(change))
            self.require_status(job, program.FAILED)
            self.assertIn("would be overwritten; give the mesh another name with --output", job.stderr)
            self.assertEqual(plate.read_bytes(), before)

    def test_an_obstacle_of_hexahedra_is_refused(self):
        job = program.idiophone("check", program.deck("materials"), *sets(obstacle(self.make("plate"))))
        self.assertEqual(job.returncode, program.WRONG_DECK)
        self.assertIn("make it from a body with element: tet4", job.stderr)
        self.assertIn("obstacles are always tet4", job.stderr)

    def test_the_file_is_called_after_the_body(self):
        job = subprocess.run([program.PROGRAM, "mesh", program.deck("materials"), "--body", "mallet"], cwd=self.output,
                             capture_output=True, text=True, timeout=program.TIMEOUT)
        self.require_status(job, program.FINISHED)
        self.assertTrue((self.output / "mallet.mesh.h5").is_file())


if __name__ == "__main__":
    unittest.main()
