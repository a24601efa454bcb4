#!/usr/bin/python3
"""What `idiophone check` says about a mesh that is too coarse, or locks, and that it leaves others alone."""
import re
import unittest

import program

PLATE = """
name: plate
time: {{duration: 0.01}}
materials: {{steel: {{young: 2.0e11, poisson: 0.3, density: 7850}}}}
bodies:
  plate:
    mesh: {mesh}
    parameters: {{side: 0.3, thickness: 0.006, size: 0.0125}}
    element: tet10
    material: steel
listeners: {{ear: {{type: mono, position: [0, 0, 1]}}}}
"""
WAVE = 0.0514  # m: of 20 kHz in 6 mm of steel, by the Rayleigh-Lamb equation


class MeshNotes(program.TestCase):
    def check(self, *settings):
        deck = self.output / "plate.yaml"
        deck.write_text(PLATE.format(mesh=program.SOURCE / "meshes/square_plate.geo"))
        job = program.idiophone("check", deck, *(word for each in settings for word in ("--set", each)))
        self.require_status(job, program.FINISHED)
        return job.stdout + job.stderr

    def test_a_coarse_mesh_is_told_with_its_limit_and_a_cure(self):
        told = self.check("bodies.plate.parameters.size=0.025")
        limit, elements, size = (float(re.search(pattern, told)[1]) for pattern in (
            r"too coarse above (\d+) Hz", r"bending waves are ([\d.]+) elements long", r"Use elements of ([\d.]+) m"))
        self.assertLess(elements, 4)
        self.assertAlmostEqual(elements, WAVE / 0.025, delta=0.1)
        self.assertNotIn("too coarse", self.check(f"bodies.plate.parameters.size={0.9 * size}"))
        for part, verdict in (0.9, self.assertNotIn), (1.1, self.assertIn):
            verdict("too coarse", self.check("bodies.plate.parameters.size=0.025", f"audio.max_frequency={part * limit}"))

    def test_the_foretold_error_grows_with_frequency(self):
        found = re.search(r"5 cents up to (\d+) Hz, 50 cents up to (\d+) Hz", self.check())
        self.assertAlmostEqual(float(found[2]) / float(found[1]), 10, delta=1.5)  # the square of the wave's length

    def test_linear_elements_lock(self):
        told = self.check("bodies.plate.element=tet4")
        self.assertIn("lock", told)
        self.assertNotIn("cents", told)

    def test_a_body_that_is_held_rigid_has_no_pitch(self):
        told = self.check("bodies.plate.fixed=[body]", "time.steps_per_sample=4", "bodies.plate.parameters.size=0.03")
        self.assertNotIn("cents", told)
        self.assertNotIn("too coarse", told)


if __name__ == "__main__":
    unittest.main()
