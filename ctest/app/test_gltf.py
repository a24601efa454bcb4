#!/usr/bin/python3
"""`idiophone export --gltf`: the validator of Khronos accepts every export, and a body comes back from its export as it was."""
import json
import unittest

import program
import web

DECK = """name: %s
time: {duration: 0.001}
materials: {china: {young: 7.0e10, poisson: 0.2, density: 2400, damping: {mass: 20, stiffness: 1.0e-7}}}
bodies: {%s: {%s}}
listeners: {ear: {type: mono, position: [0, 0, 1]}}
"""


class Gltf(program.TestCase):
    def deck(self, name, body, keys):
        path = self.output / f"{name}.yaml"
        path.write_text(DECK % (name, body, keys))
        return path

    def export(self, deck, map_name):
        """The path of the glTF file of a map."""
        job = program.idiophone("map", deck, "--modes", 3, "--output-folder", self.output)
        self.require_status(job, program.FINISHED)
        path = self.output / f"{map_name}.gltf"
        self.require_status(program.idiophone("export", self.output / f"{map_name}.map.h5", "--gltf", path), program.FINISHED)
        return path

    def facts(self, deck):
        job = program.idiophone("check", deck, "--json")
        self.require_status(job, program.FINISHED)
        return json.loads(job.stdout), job.stdout + job.stderr

    def test_exports_are_valid_and_come_back(self):
        bar = f"mesh: {program.SOURCE}/meshes/bar.geo, parameters: {{length: 0.1, size: 0.02}}, material: china"
        made = self.deck("made", "bar", bar)
        path = self.export(made, "made_bar")
        drum = self.export(program.SOURCE / "inputs/ideal/drums.yaml", "drums_tabla")
        for report in web.in_browser("gltf.mjs", path, drum):
            self.assertEqual((report["errors"], report["warnings"]), (0, 0), report)

        extension = json.loads(path.read_text())["extensions"]["KHR_audio_rigid_bodies"]
        self.assertAlmostEqual(extension["acousticMaterials"][0]["alpha"], 20, delta=1e-3)
        self.assertAlmostEqual(extension["acousticMaterials"][0]["beta"], 1e-7, delta=1e-12)
        mass = extension["modalModels"][0]["massProperties"]
        sides = 0.1, 0.03, 0.01
        expected = sorted(mass["mass"] / 12 * (sum(s * s for s in sides) - side * side) for side in sides)
        for moment, exact in zip(mass["inertiaDiagonal"], expected):
            self.assertAlmostEqual(moment, exact, delta=1e-4 * exact)

        back, messages = self.facts(self.deck("back", "bar", f"mesh: {path}, parameters: {{size: 0.02}}"))
        first, _ = self.facts(made)
        self.assertAlmostEqual(back["mass"], first["mass"], delta=1e-6 * first["mass"])
        self.assertIn("which it has with the density 2400 kg/m3 of its material", messages)


if __name__ == "__main__":
    unittest.main()
