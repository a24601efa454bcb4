#!/usr/bin/python3
"""`idiophone radiate` of bodies that a joint ties together, against the same body in one piece."""
import json
import unittest

import h5py
import numpy

import program

LAYERS = program.deck("bar_of_layers")
BOLT = "--set", ("joints={bolt: {type: bolt, between: [upper.bottom, lower.top], at: [0.12, 0, 0], radius: 0.2, "
                 "stiffness: {normal: 1.0e15, tangential: 1.0e15}}}")
APART = ("--set", "bodies.lower.position=[0, 0, -0.0225]", "--set",
         "joints={coil: {type: spring, between: [upper.tip, lower.tip], stiffness: {axial: 1.0e6, lateral: 2.0e5}}, "
         "pin: {type: hinge, between: [upper.clamp, lower.clamp], axis: [[0, -0.01, -0.01], [0, 0.01, -0.01]]}}")
STUDS = ("--set", "bodies.lower.position=[0, 0, -0.0225]", "--set", "joints={" + ", ".join(
    f"stud_{number}: {{type: bolt, between: [upper.bottom, lower.top], axis: [[{x}, 0, 0], [{x}, 0, -0.02]], radius: 0.005, "
    "shank: 0.002, material: steel, preload: 1000}" for number, x in enumerate((0.04, 0.2))) + "}")
BAR = """\
name: bar
time: {duration: 0.1}
materials:
  steel: {young: 2.0e11, poisson: 0.3, density: 7850, damping: {mass: 2.0}}
bodies:
  bar:
    mesh: MESHES/bar.geo
    parameters: {length: 0.24, width: 0.03, thickness: 0.01, size: 0.08, layers: 2}
    element: hex
    order: {plane: 4, thickness: 2}
    material: steel
listeners:
  above: {type: mono, position: [0.1, 0.05, 0.3]}
  beside: {type: mono, position: [0.4, 0.1, -0.05]}
"""


class RadiateJoined(program.TestCase):
    def setUp(self):
        super().setUp()
        self.bar = self.output / "bar.yaml"
        self.bar.write_text(BAR.replace("MESHES", str(program.SOURCE / "meshes")))

    def radiate(self, deck, *arguments, ranks=None):
        return program.idiophone("radiate", deck, "--output-folder", self.output, "--tolerance", 0, *arguments, ranks=ranks)

    def sounds(self, deck, *arguments):
        job = self.radiate(deck, "--json", *arguments)
        self.require_status(job, program.FINISHED)
        return json.loads(job.stdout)["sounds"]

    def test_the_modes_of_glued_layers_sound_as_those_of_one_piece(self):
        whole = self.sounds(self.bar, "--modes", 2)
        self.require_alike(self.sounds(LAYERS, "--modes", 2), whole)
        self.require_alike(self.sounds(LAYERS, "--modes", 1, *BOLT), whole[:1])

    def require_alike(self, joined, whole):
        self.assertEqual(len(joined), len(whole))
        for one, other in zip(joined, whole):
            self.assertAlmostEqual(1200 * numpy.log2(one["frequency"] / other["frequency"]), 0, delta=0.5)
            self.assertAlmostEqual(10 * numpy.log10(one["power"] / other["power"]), 0, delta=0.05)
            for listener in "above", "beside":
                level = [20 * numpy.log10(abs(complex(*sound["listeners"][listener]))) for sound in (one, other)]
                self.assertAlmostEqual(*level, delta=0.05, msg=f"{one['motion']} {listener}")

    def test_bars_on_a_spring_and_a_hinge_sound_as_their_map(self):
        self.require_as_map(APART)

    def test_bars_between_studs_sound_as_their_map(self):
        self.require_as_map(STUDS)

    def require_as_map(self, joints):
        sounds = self.sounds(LAYERS, "--modes", 2, *joints)
        self.require_status(program.idiophone("map", LAYERS, *joints, "--modes", 2, "--radiation", "boundary_elements",
                                              "--output-folder", self.output), program.FINISHED)
        path, = self.output.glob("*.map.h5")
        with h5py.File(path) as made:
            numpy.testing.assert_allclose([sound["frequency"] for sound in sounds], made["modes/frequency"], rtol=1e-9)
            of_map = numpy.linalg.norm(made["listeners/pressure"], axis=-1)
        found = [[abs(complex(*sound["listeners"][name])) for name in ("above", "beside")] for sound in sounds]
        # A map takes the middle of each triangle. In such elements that is worth 1.3 dB for the bar in one piece, too.
        self.assertLess(abs(20 * numpy.log10(found / of_map)).max(), 1.5)

    def test_all_that_joints_tie_to_a_body_moves_with_it(self):
        job = self.radiate(LAYERS, "--body", "lower", "--modes", 1)
        self.require_status(job, program.FINISHED)
        alone = program.contents(self.output / "layers_radiation.h5")
        with h5py.File(self.output / "layers_radiation.h5") as file:
            self.assertEqual(file["surface/parts"].asstr()[:].tolist(), ["upper"])
            self.assertEqual(file.attrs["bodies"], 1)
        self.require_status(self.radiate(LAYERS, "--modes", 1, ranks=2), program.FINISHED)
        self.require_same(self.output / "layers_radiation.h5", alone)

    def beside_a_pebble(self):
        """A deck in which the joined bodies are not the first ones. The pebble is small and far away."""
        pebble = ("bodies:\n  pebble: {mesh: MESHES/sphere.geo, parameters: {radius: 0.003, size: 0.003}, element: tet4, "
                  "position: [0, 0, -1], material: steel}\n")
        path = self.output / "beside.yaml"
        path.write_text(LAYERS.read_text().replace("bodies:\n", pebble).replace("../../../meshes", "MESHES")
                        .replace("MESHES", str(program.SOURCE / "meshes")))
        return path

    def test_joined_bodies_need_not_be_the_first_ones(self):
        beside = self.beside_a_pebble()
        for moved in ("--modes", 1), ("--frequencies", 800):
            with self.subTest(moved=moved):
                alone, = self.sounds(LAYERS, *moved)[:1]
                found, = self.sounds(beside, "--body", "lower", *moved)[:1]
                self.assertAlmostEqual(10 * numpy.log10(found["power"] / alone["power"]), 0, delta=0.01)
        with h5py.File(self.output / "layers_upper_radiation.h5") as file:
            self.assertEqual(file["surface/parts"].asstr()[:].tolist(), ["pebble", "upper"])
            self.assertEqual(file.attrs["bodies"], 2)

    def test_a_surface_that_is_open_at_a_joint_is_refused(self):
        job = self.radiate(program.deck("joined"), "--modes", 2)
        self.assertEqual(job.returncode, program.WRONG_DECK)
        self.assertIn("joined.yaml:21:3: joints.glue: boundary elements need a closed surface, and that of left and the bodies "
                      "joined to it is open", job.stderr)


if __name__ == "__main__":
    unittest.main()
