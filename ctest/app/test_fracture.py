#!/usr/bin/python3
"""A bar that breaks in the middle: its sound, the faces that appear, energy and momentum."""
import unittest

import h5py
import numpy

import program

AREA = 0.03 ** 2  # m2, of the seam
WHOLE = "bodies.bar.fracture.0.strength=1e12"


class Fracture(program.TestCase):
    def compute(self, folder, *settings):
        output = self.output / folder
        overrides = [word for text in settings for word in ("--set", text)]
        self.job = program.run("breaking", output, *overrides)
        self.require_status(self.job, program.FINISHED)
        return program.contents(output / "breaking.h5"), output / "breaking_surface.h5"

    def test_a_body_that_does_not_break_sounds_as_an_undivided_one(self):
        whole, _ = self.compute("whole", "bodies.bar.fracture=null", "time.steps_per_sample=60")
        divided, surface = self.compute("divided", WHOLE, "time.steps_per_sample=60")
        self.assertEqual(divided["motion/bar/broken_area"].max(), 0)
        self.assertIn("body bar: did not break", self.job.stdout + self.job.stderr)
        for name in ("audio/ear", "motion/bar/centre_of_mass", "motion/bar/energy"):
            largest = abs(whole[name]).max()
            self.assertLess(abs(divided[name] - whole[name]).max(), 1e-8 * largest, name)
        with h5py.File(surface) as file:
            inner = file["pressure"][:, -self.inner_triangles(file):]
        self.assertEqual(abs(inner).max(), 0)

    @staticmethod
    def inner_triangles(file):
        """Triangles of both sides of the seam; they are the last ones."""
        reference, triangles = file["reference"][()], file["triangles"][()]
        inside = numpy.all(abs(reference[triangles][:, :, 0] - 0.1) < 1e-9, axis=1)
        count = int(inside.sum())
        assert inside[-count:].all() and count % 8 == 0
        return count

    def test_new_faces_sound_when_they_appear(self):
        result, surface = self.compute("broken")
        area = result["motion/bar/broken_area"][:, 0]
        self.assertTrue((numpy.diff(area) >= 0).all())
        self.assertAlmostEqual(area[-1] / AREA, 1, places=9)
        self.assertIn("body bar: broken along 0.0009 m2", self.job.stdout + self.job.stderr)
        first = int(numpy.argmax(area > 0))
        self.assertGreater(first, 8)
        with h5py.File(surface) as file:
            inner = file["pressure"][:, -self.inner_triangles(file):]
            start = int(file.attrs.get("first_sample", 0))
        latency = 8  # samples: the low-pass spreads what it gets over its own length
        self.assertEqual(abs(inner[:first - latency - start]).max(), 0)
        self.assertGreater(abs(inner[first + latency:]).max(), 1)

    def test_breaking_costs_no_energy(self):
        result, _ = self.compute("broken", "time.steps_per_sample=120")
        hit = int(numpy.argmax(result["contacts/hit/overlap"][:, 0] > 0))  # friction takes energy from then on
        kinetic, elastic, contact, gravitational, work = result["energy"][:hit].T
        balance = kinetic + elastic + contact + gravitational - work
        self.assertLess(abs(balance).max(), 5e-4 * work.max())
        self.assertAlmostEqual(result["motion/bar/broken_area"][hit // 2, 0] / AREA, 1, places=9)

    def test_breaking_takes_its_fracture_energy(self):
        result, _ = self.compute("cohesive", "bodies.bar.fracture.0.energy=20", "time.steps_per_sample=120")
        hit = int(numpy.argmax(result["contacts/hit/overlap"][:, 0] > 0))
        kinetic, elastic, contact, gravitational, work = result["energy"][:hit].T
        taken = result["motion/bar/fracture_energy"][:hit, 0]
        self.assertLess(abs(kinetic + elastic + contact + gravitational + taken - work).max(), 1e-3 * work.max())
        self.assertAlmostEqual(taken[-1] / (20 * AREA), 1, places=6)
        self.assertGreater(taken[-1], 0.05 * work.max())

    def test_each_piece_has_its_motion(self):
        """The free half flies with the momentum that it had at the break, until it hits the wall."""
        result, _ = self.compute("broken", "time.steps_per_sample=120")
        joined = result["motion/bar/joined_pieces"]
        self.assertEqual(joined[0].tolist(), [1, 1])
        self.assertEqual(joined[-1].tolist(), [1, 2])
        apart = int(numpy.argmax(joined[:, 1] == 2))
        self.assertAlmostEqual(result["motion/bar/broken_area"][apart, 0] / AREA, 1, places=9)
        centres = [result[f"motion/bar.{piece}/centre_of_mass"] for piece in (1, 2)]
        free = int(numpy.argmax([centre[0, 0] for centre in centres])) + 1  # the half that is not held
        whole = result["motion/bar/centre_of_mass"]
        self.assertLess(abs((centres[0] + centres[1]) / 2 - whole).max(), 1e-9)
        hit = int(numpy.argmax(result["contacts/hit/overlap"][:, 0] > 0))
        pulled = 80  # rows: the pull lasts 10 ms
        self.assertLess(apart, hit)
        rate = 8000  # rows per second
        velocity = result[f"motion/bar.{free}/velocity"][:, 0]
        moved = numpy.diff(result[f"motion/bar.{free}/centre_of_mass"][:, 0]) * rate
        error = abs(moved - (velocity[1:] + velocity[:-1]) / 2)[:hit - 1]
        self.assertLess(numpy.delete(error, apart - 1).max(), 3e-4 * velocity.max())  # but where the force jumps
        mass = 1100 * 0.1 * AREA  # kg
        times = numpy.arange(apart, min(hit, pulled)) / rate
        impulse = 60 * 1e-2 / numpy.pi * (1 - numpy.cos(numpy.pi * times / 1e-2))  # N s, of the pull so far
        gained = mass * (velocity[apart:min(hit, pulled)] - velocity[apart])
        self.assertLess(abs(gained - (impulse - impulse[0])).max(), 0.02 * impulse.max())

    def test_elements_of_all_kinds_break(self):
        for element in ("tet4", "hex"):
            with self.subTest(element=element):
                setting = f"bodies.bar.element={element}"
                result, _ = self.compute(element, setting)
                self.assertAlmostEqual(result["motion/bar/broken_area"][-1, 0] / AREA, 1, places=9)
                self.assertGreater(result["contacts/hit/overlap"].max(), 0)
                output = self.output / f"{element}_on_2"
                job = program.run("breaking", output, "--set", setting, ranks=2)
                self.require_status(job, program.FINISHED)
                self.require_same(output / "breaking.h5", result)

    def test_the_piece_that_breaks_off_hits_the_wall(self):
        result, _ = self.compute("broken")
        overlap, area = result["contacts/hit/overlap"][:, 0], result["motion/bar/broken_area"][:, 0]
        self.assertGreater(overlap.max(), 0)
        self.assertGreater(numpy.argmax(overlap > 0), numpy.argmax(area > 0))

    def test_mistakes(self):
        for setting, message in (
                ("bodies.bar.fracture.0.surface=seem", "the mesh has no group 'seem'; did you mean 'seam'?"),
                ("bodies.bar.fracture.0.surface=left", "the surface 'left' has faces on the outside of the body"),
                ("bodies.bar.model={type: modal}", "has no meaning with a modal body"),
                ("radiation={model: waves, cell: 0.05, box: {low: [-1, -1, -1], high: [1, 1, 1]}}",
                 "the radiation model `waves` does not know surfaces that appear during a run")):
            job = program.run("breaking", self.output, "--set", setting)
            self.require_status(job, program.WRONG_DECK)
            self.assertIn(message, job.stderr)


if __name__ == "__main__":
    unittest.main()
