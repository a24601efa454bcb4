#!/usr/bin/python3
"""Bodies from damaged surfaces have the frequencies of whole ones, and say their volume. Prints a table."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy

from damaged_surfaces import ball, box, cylinder, with_fins, with_holes, write_obj

MESHES = pathlib.Path(__file__).resolve().parents[3] / "meshes"
DECK = """name: part
time: {duration: 0.001}
bodies: {part: {mesh: %s, material: steel, %s}}
listeners: {ear: {type: mono, position: [0, 0, 1]}}
"""
CYLINDER = """SetFactory("OpenCASCADE");
Cylinder(1) = {0, 0, -0.05, 0, 0, 0.1, 0.03};
Mesh.MeshSizeMax = 0.006;
Physical Volume("body") = {1};
"""
HEX = "element: hex, order: {plane: 4, thickness: 4}"
BALL, BOX, ROD = ball(.05), box((-.05, -.04, -.03), (.05, .04, .03)), cylinder(.03, -.05, .05)
SHELLS = {
    "ball": [BALL, ball(.04, 30)],  # one within the other
    "box": [box((-.05, -.04, -.03), (.02, .04, .03)), box((-.02, -.04, -.03), (.05, .04, .03), 20)],
    "cylinder": [cylinder(.03, -.05, .02), cylinder(.03, -.02, .05, along=25)],
}


class RepairedModes(unittest.TestCase):
    def setUp(self):
        self.random = numpy.random.default_rng(2)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def modes(self, mesh, keys):
        """The first eight frequencies of the body (Hz), and what is said about its mesh."""
        deck = self.folder / "deck.yaml"
        deck.write_text(DECK % (mesh, keys))
        job = subprocess.run([os.environ["IDIOPHONE"], "modes", deck, "--modes", "8", "--no-estimate", "--mass", "consistent", "--json",
                              "--output-folder", self.folder],
                             capture_output=True, text=True, timeout=600)
        self.assertEqual(job.returncode, 0, job.stderr)
        return numpy.array([mode["frequency"] for mode in json.loads(job.stdout)["modes"]]), job.stderr

    def compare(self, name, size, exact, whole):
        """Cents, for each damage, between the repaired body and the exact one."""
        damaged = {"holes": with_holes(whole, self.random), "fins": with_fins(whole, self.random),
                   "shells": numpy.concatenate(SHELLS[name])}
        for damage, triangles in damaged.items():
            file = self.folder / f"{damage}.obj"
            write_obj(file, triangles)
            found, notes = self.modes(file, f"parameters: {{size: {size}}}, meshing: {{repair: wrap}}")
            cents = 1200 * numpy.log2(found / exact)
            print(f"{name:9} {damage:7} {cents.min():+5.1f} to {cents.max():+5.1f} cents", flush=True)
            self.assertLess(numpy.abs(cents).max(), 5, damage)
            self.assertRegex(notes, r"encloses [\d.e-]+ m3")

    def test_ball(self):
        self.compare("ball", .01, self.modes(MESHES / "sphere.geo", "parameters: {radius: 0.05, size: 0.02}, " + HEX)[0], BALL)

    def test_box(self):
        keys = "parameters: {length: 0.1, width: 0.08, thickness: 0.06, size: 0.02, layers: 3}, " + HEX
        self.compare("box", .01, self.modes(MESHES / "bar.geo", keys)[0], BOX)

    def test_cylinder(self):
        geometry = self.folder / "cylinder.geo"
        geometry.write_text(CYLINDER)
        self.compare("cylinder", .008, self.modes(geometry, "element: tet10")[0], ROD)


if __name__ == "__main__":
    unittest.main()
