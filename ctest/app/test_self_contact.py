#!/usr/bin/python3
"""Tines of a fork that hit and rub each other: friction, modal bodies, and the same bits on any ranks and through resume."""
import unittest

import numpy

import program

RUB = ("loads.left.force=[1.5, 0.5, 0]", "loads.right.force=[-1.5, -0.5, 0]")  # N: tines pass each other as they hit
COULOMB = "{sticking: 0.5, sliding: 0.4}"
BRISTLES = "{type: elasto_plastic, sticking: 0.5, sliding: 0.4, stiffness: 1e4, damping: 1, viscosity: 0.1}"
MODAL = "bodies.fork.model={type: modal, up_to: 8000}"
RATE = 8000  # Hz
AFTER_PULSES = 1.5e-3  # s


def friction(law):
    return f"contacts.clack.friction={law}"


class SelfContact(program.TestCase):
    def result(self, folder, *settings, ranks=1):
        arguments = (word for setting in settings for word in ("--set", setting))
        self.require_status(program.run("fork", self.output / folder, *arguments, ranks=ranks), program.FINISHED)
        return program.contents(self.output / folder / "fork.h5")

    @staticmethod
    def free_flight(found, path):
        """A motion series after the pulses."""
        series = found[path]
        duration = len(found["contacts/clack/force"]) / RATE
        return series[round(AFTER_PULSES / duration * (len(series) - 1)) + 1:]

    def check_momenta(self, found):
        velocity = found["motion/fork/velocity"]
        self.assertLess(abs(velocity - velocity[0]).max(), 1e-12)
        spin = self.free_flight(found, "motion/fork/angular_momentum")
        self.assertLess(abs(spin - spin[0]).max(), 1e-12 * abs(spin).max())

    def test_friction_takes_energy_and_keeps_both_momenta(self):
        for law in (COULOMB, BRISTLES):
            with self.subTest(friction=law):
                found = self.result("friction", *RUB, friction(law))
                self.check_momenta(found)
                energy = self.free_flight(found, "energy")[:, :4].sum(axis=1)
                self.assertLess(numpy.diff(energy).max(), 1e-4 * energy[0])
                self.assertLess(energy[-1], 0.99 * energy[0])

    def test_friction_pulls_with_its_part_of_the_pressure(self):
        """Less where bonds hold, and towards where they were stretched from; in all, against the motion."""
        for law in (COULOMB, "{type: elasto_plastic, sticking: 0.5, sliding: 0.4, stiffness: 1e4}"):
            with self.subTest(friction=law):
                found = self.result("friction", *RUB, friction(law))
                force, normal, slip = (found[f"contacts/clack/{name}"] for name in ("force", "normal", "slip"))
                pressing = (force * normal).sum(axis=1)
                rubbing = force - pressing[:, None] * normal
                touching = pressing > 0.01 * pressing.max()
                part = numpy.linalg.norm(rubbing[touching], axis=1) / pressing[touching]
                self.assertLess(part.max(), 0.55)  # directions are means over a sample
                self.assertGreater(part.max(), 0.39)
                self.assertLess((rubbing * slip).sum(), -0.5)  # W

    def check_bits_on_three_ranks_and_through_resume(self, *settings):
        """Jobs end after blocks of 16 samples, the third one while the tines touch."""
        late = [f"loads.{load}.start={11 / RATE}" for load in ("left", "right")]
        settings = (*RUB, *late, "contacts.clack.damping=1e-5", "time.duration=0.0075", *settings)
        expected = self.result("one", *settings)
        self.assertGreater(min(expected["contacts/clack/overlap"][47:49]), 0)
        self.result("three", *settings, ranks=3)
        self.require_same(self.output / "three/fork.h5", expected)
        arguments = [word for setting in settings for word in ("--set", setting)]
        self.assertGreaterEqual(self.run_in_jobs("fork", self.output, *arguments, ranks=2 * (3, 1, 2, 3)), 4)
        self.require_same(self.output / "fork.h5", expected)

    def test_same_bits_on_three_ranks_and_through_resume(self):
        self.check_bits_on_three_ranks_and_through_resume(friction(COULOMB))

    def test_same_bits_with_friction_with_memory(self):
        self.check_bits_on_three_ranks_and_through_resume(friction(BRISTLES))

    def test_same_bits_of_a_modal_body(self):
        """A second body lets the job have more ranks than the modal one has."""
        block = ("{mesh: ../../../meshes/bar.geo, parameters: {length: 0.04, width: 0.02, thickness: 0.01, size: 0.01}, "
                 "material: rubber, position: [0.1, 0, 0]}")
        self.check_bits_on_three_ranks_and_through_resume(friction(COULOMB), MODAL, f"bodies.block={block}")

    def test_modal_tines_hit_each_other_as_finite_elements_do(self):
        def first_clack(found):
            force = found["contacts/clack/force"][:16, 0]
            return force.sum() / RATE, (force * numpy.arange(16)).sum() / force.sum()

        expected_impulse, expected_moment = first_clack(self.result("elements"))
        found = self.result("modal", MODAL)
        impulse, moment = first_clack(found)
        self.assertLess(abs(impulse / expected_impulse - 1), 0.01)
        self.assertLess(abs(moment - expected_moment), 0.1)
        self.check_momenta(found)
        energy = self.free_flight(found, "energy")[:, :4].sum(axis=1)
        self.assertLess(numpy.diff(energy).max(), 1e-4 * energy[0])
        self.assertGreater(energy[-1], 0.99 * energy[0])


if __name__ == "__main__":
    unittest.main()
