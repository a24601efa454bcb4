#!/usr/bin/python3
"""Modal bodies in whole runs: contact times and sound against finite elements, the same bits, and wrong decks."""
import unittest

import numpy

import program

MODAL = "{type: modal, up_to: 10000}"
FEW = "{type: modal, count: 12}"


def settings(**models):
    return [word for body, model in models.items() for word in ("--set", f"bodies.{body}.model={model}")]


class ModalBodies(program.TestCase):
    def result(self, name, folder, *arguments, ranks=1):
        self.require_status(program.run(name, self.output / folder, *arguments, ranks=ranks), program.FINISHED)
        return program.contents(self.output / folder / f"{name}.h5")

    def contact_time(self, force):
        """Time in samples over which a hundredth of the peak force is exceeded, and the impulse."""
        size = numpy.linalg.norm(force, axis=1)
        faint = 0.01 * size.max()
        first, last = numpy.flatnonzero(size > faint)[[0, -1]]
        begin = first - (size[first] - faint) / (size[first] - size[first - 1])
        end = last + (size[last] - faint) / (size[last] - size[last + 1])
        return end - begin, size.sum()

    def test_impacts_last_as_long_as_between_finite_elements(self):
        expected, impulse = self.contact_time(self.result("struck", "elements")["contacts/strike/force"])
        for models in ({"plate": MODAL}, {"plate": MODAL, "weight": FEW}):
            with self.subTest(models=models):
                found = self.contact_time(self.result("struck", str(len(models)), *settings(**models))
                                          ["contacts/strike/force"])
                self.assertLess(abs(found[0] / expected - 1), 0.03)
                self.assertLess(abs(found[1] / impulse - 1), 0.03)

    def test_energy_and_momentum_pass_through_the_impact(self):
        found = self.result("struck", "modal", *settings(plate=MODAL, weight=FEW), "--set",
                            "materials.steel.damping={mass: 0}", "--set", "contacts.strike.damping=0", "--set",
                            "contacts.strike.friction=0")
        energy = found["energy"][:, :3].sum(axis=1)
        self.assertLess(abs(energy / energy[0] - 1).max(), 0.03)

    def test_same_bits_on_other_numbers_of_ranks_and_through_resume(self):
        models = settings(block=FEW)
        expected = self.result("touching", "one", *models)
        self.assertGreater(abs(expected["contacts/hit/force"]).max(), 0)
        for ranks in program.OTHER_RANKS:
            with self.subTest(ranks=ranks):
                self.result("touching", str(ranks), *models, ranks=ranks)
                self.require_same(self.output / str(ranks) / "touching.h5", expected)
        self.run_in_jobs("touching", self.output, *models, ranks=(3, 2, 1, 2, 3, 1, 2, 1))
        self.require_same(self.output / "touching.h5", expected)

    def test_same_bits_where_each_rank_has_a_modal_body(self):
        models = settings(plate=MODAL, weight=FEW)
        expected = self.result("struck", "one", *models)
        self.result("struck", "two", *models, ranks=2)
        self.require_same(self.output / "two" / "struck.h5", expected)

    def test_too_many_ranks_for_modal_bodies_are_refused(self):
        job = program.run("struck", self.output, *settings(plate=FEW, weight=FEW), ranks=3)
        self.require_status(job, program.FAILED)
        self.assertIn("since each modal body lies on one rank: run on at most 2", job.stderr)

    def test_wrong_models_are_refused_at_their_place(self):
        for setting, answer in (("{type: wrong}", "bodies.plate.model.type: must be one of finite_elements, modal"),
                                ("{type: modal, up_to: 100, count: 3}", "cannot stand beside up_to"),
                                ("{count: 3}", "has no meaning with type finite_elements"),
                                ("{type: modal, up_to: 1}", "has no modes up to 1 Hz"),
                                ("{type: modal, count: 9999}", "has no more than")):
            with self.subTest(setting=setting):
                job = program.run("struck", self.output, *settings(plate=setting))
                self.require_status(job, program.WRONG_DECK)
                self.assertIn("--set", job.stderr)
                self.assertIn(answer, job.stderr)

    def test_large_vibrations_are_warned_of(self):
        job = program.run("struck", self.output, *settings(plate=FEW), "--set", "bodies.weight.velocity=[0, 0, -30]",
                          "--set", "time.duration=0.001")
        self.assertIn("modes are right for small vibrations", job.stderr + job.stdout)


if __name__ == "__main__":
    unittest.main()
