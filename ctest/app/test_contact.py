#!/usr/bin/python3
"""What touches, against mechanics: bounces, collisions, friction, rolling, thin sheets."""
import math
import re
import unittest

import h5py
import numpy

import program

G = 9.81  # m/s2


def incline(tangent):
    """The setting that turns gravity as a plane of this slope would."""
    angle = math.atan(tangent)
    return f"gravity=[{G * math.sin(angle)!r}, 0, {-G * math.cos(angle)!r}]"


class Contact(program.TestCase):
    def run_deck(self, name, *settings):
        """Runs a deck and returns its series by their paths and what it said."""
        arguments = [word for setting in settings for word in ("--set", setting)]
        job = program.run(name, self.output, *arguments)
        self.require_status(job, program.FINISHED)
        with h5py.File(self.output / f"{name}.h5") as file:
            self.rate = file["energy"].attrs["rate"]
        return program.contents(self.output / f"{name}.h5"), job.stdout + job.stderr

    def mass(self, name, body, velocity):
        """Of a body that is made to start with a velocity and no spin, kg."""
        found, _ = self.run_deck(name, f"bodies.{body}.velocity={velocity}", f"bodies.{body}.spin=[0, 0, 0]",
                                 "time.duration=1e-3")
        return 2 * found[f"motion/{body}/energy"][0, 0] / numpy.dot(velocity, velocity)

    @staticmethod
    def touches(force):
        """How often a contact begins."""
        on = numpy.linalg.norm(force, axis=1) > 0
        return numpy.count_nonzero(on[1:] & ~on[:-1])

    def check_energy_of_bounces(self, contacts, *settings):
        found, _ = self.run_deck("bounce", *settings)
        self.assertGreaterEqual(sum(self.touches(found[f"contacts/{name}/force"]) for name in contacts), 10)
        kinetic, elastic, contact, gravitational, _ = found["energy"].T
        total = kinetic + elastic + contact + gravitational
        error = abs(total - total[0]) / (kinetic + gravitational - gravitational.min())[0]
        self.assertLess(error.max(), 1e-3)
        self.assertLess(error[contact == 0].max(), 1e-4)

    def test_ten_bounces_between_two_walls_keep_the_energy(self):
        for element in ("tet4", "tet10"):
            with self.subTest(element=element):
                self.check_energy_of_bounces(("left", "right"), f"bodies.ball.element={element}")

    def test_tines_that_hit_each_other_keep_energy_and_momentum_with_the_same_bits_on_any_ranks(self):
        found, said = self.run_deck("fork")
        force = found["contacts/clack/force"]
        self.assertGreaterEqual(self.touches(force), 1)
        self.assertGreaterEqual(force[:, 0].min(), 0)  # on the right tine
        total = found["energy"][:, :4].sum(axis=1)
        after = total[numpy.arange(len(total)) / self.rate > 1.5e-3]  # the pulses are over
        self.assertLess(abs(after / after[0] - 1).max(), 1e-3)
        velocity = found["motion/fork/velocity"]
        self.assertLess(abs(velocity - velocity[0]).max(), 1e-12)
        self.assertLess(float(re.search(r"clack: deepest penetration (\S+) m", said)[1]), 5e-4)
        job = program.idiophone("analyze", self.output / "fork.h5", "--start", 0)
        self.assertRegex(job.stdout + job.stderr, r"forces act in this part \(.*contact clack, heard until 0\.0\d* s")
        self.require_status(program.run("fork", self.output, ranks=3), program.FINISHED)
        self.require_same(self.output / "fork.h5", found)

    def test_ten_bounces_under_gravity_keep_the_energy(self):
        self.check_energy_of_bounces(("left",), "bodies.ball.velocity=[0, 0, 0]", "gravity=[-9.81, 0, 0]",
                                     "time.duration=1.6")

    def test_two_bodies_that_collide_keep_their_momenta(self):
        bodies = {"large": [1, 0, 0], "small": [-2, 0.3, 0]}  # m/s, as in the deck
        masses = {body: self.mass("collision", body, velocity) for body, velocity in bodies.items()}
        for friction in (0, 0.5, "{sticking: 0.6, sliding: 0.4}", "{type: elasto_plastic, stiffness: 1e4}"):
            for damping in (0, 1e-4):
                with self.subTest(friction=friction, damping=damping):
                    found, _ = self.run_deck("collision", f"contacts.crash.friction={friction}",
                                             f"contacts.crash.damping={damping}")
                    self.check_momenta(found, masses)
                    energy = found["energy"][:, :3].sum(axis=1)
                    if friction == 0 and damping == 0:
                        numpy.testing.assert_allclose(energy, energy[0], rtol=1e-4)
                    else:
                        self.assertLess(energy[-1], 0.99 * energy[0])

    def check_momenta(self, found, masses):
        self.assertEqual(self.touches(found["contacts/crash/force"]), 1)
        linear = angular = scale = 0
        for body, mass in masses.items():
            motion = {name: found[f"motion/{body}/{name}"]
                      for name in ("velocity", "centre_of_mass", "angular_momentum")}
            before, after = motion["velocity"][[0, -1]]
            self.assertGreater(numpy.linalg.norm(after - before), 0.3)
            linear = linear + mass * motion["velocity"]
            angular = (angular + motion["angular_momentum"]
                       + mass * numpy.cross(motion["centre_of_mass"], motion["velocity"]))
            scale += mass * numpy.linalg.norm(before)
        radius = 0.04  # m
        self.assertLess(abs(linear - linear[0]).max(), 1e-13 * scale)
        self.assertLess(abs(angular - angular[0]).max(), 1e-13 * radius * scale)

    def test_a_block_sticks_without_creep_up_to_the_angle_of_friction(self):
        for element, duration in (("tet4", 0.5), ("tet10", 0.2)):
            with self.subTest(element=element):
                found, _ = self.run_deck("incline", incline(0.398), f"bodies.block.element={element}",
                                         f"time.duration={duration}")
                centre = found["motion/block/centre_of_mass"]
                half, whole = centre[round(duration / 2 * self.rate)], centre[round(duration * self.rate)]
                self.assertGreater(whole[0] - centre[0, 0], 1e-7)
                numpy.testing.assert_array_less(abs(whole - half), 1e-12)

    def check_slide(self, tangent, sliding, *settings):
        found, _ = self.run_deck("incline", incline(tangent), *settings)
        velocity = found["motion/block/velocity"][round(0.25 * self.rate):, 0]
        angle = math.atan(tangent)
        expected = G * (math.sin(angle) - sliding * math.cos(angle))
        numpy.testing.assert_allclose(numpy.diff(velocity) * self.rate, expected, rtol=1e-6, atol=1e-6)

    def test_a_block_slides_with_the_acceleration_that_friction_leaves(self):
        for tangent in (0.402, 1.0):
            with self.subTest(tangent=tangent):
                self.check_slide(tangent, 0.4)

    def test_a_block_that_slides_is_held_by_sliding_friction_alone(self):
        coefficients = "contacts.rest.friction={sticking: 0.4, sliding: 0.2}"
        self.check_slide(0.3, 0.2, coefficients, "bodies.block.velocity=[0.05, 0, 0]")
        # From rest, sticking friction holds it on the same slope.
        found, _ = self.run_deck("incline", incline(0.3), coefficients)
        velocity = found["motion/block/velocity"]
        self.assertLess(abs(velocity[round(0.25 * self.rate):]).max(), 1e-9)

    def run_with_memory(self, tangent, *settings):
        """A block on bristles that let go at 0.5 of the load and slide with 0.2 of it."""
        law = "{type: elasto_plastic, sticking: 0.5, sliding: 0.2, stribeck_speed: 0.4, stiffness: 2e4, damping: 2}"
        return self.run_deck("incline", incline(tangent), f"contacts.rest.friction={law}", *settings)[0]

    def test_a_block_slides_along_the_stribeck_curve(self):
        found = self.run_with_memory(0.8, "bodies.block.velocity=[0.2, 0, 0]")
        velocity = found["motion/block/velocity"][round(0.1 * self.rate):, 0]
        middle = (velocity[1:] + velocity[:-1]) / 2
        angle = math.atan(0.8)
        coefficient = 0.2 + 0.3 * numpy.exp(-(middle / 0.4)**2)
        self.assertLess(middle[0], 0.8)  # where the curve is steep
        expected = G * (math.sin(angle) - coefficient * math.cos(angle))
        numpy.testing.assert_allclose(numpy.diff(velocity) * self.rate, expected, rtol=2e-3)

    @program.long_verification
    def test_a_ball_rolls(self):
        found, _ = self.run_deck("rolling")
        centre = found["motion/ball/centre_of_mass"][:, 0]
        turn = found["motion/ball/angular_velocity"][:, 1]
        angle = (turn[1:] + turn[:-1]).sum() / 2 / self.rate
        way, time = centre[-1] - centre[0], (len(centre) - 1) / self.rate
        self.assertAlmostEqual(way / (0.04 * angle), 1, delta=0.03)
        self.assertAlmostEqual(2 * way / time**2 / (5 / 7 * 0.3 * G), 1, delta=0.03)

    @program.long_verification
    def test_a_fast_ball_does_not_get_through_a_thin_sheet(self):
        for material, duration in (("steel", 1e-3), ("rubber", 5e-3)):
            for element, size in (("tet4", 0.005), ("tet10", 0.0075)):
                with self.subTest(material=material, element=element):
                    found, said = self.run_deck("sheet", f"bodies.sheet.material={material}",
                                                f"bodies.sheet.element={element}", f"bodies.sheet.parameters.size={size}",
                                                f"time.duration={duration}")
                    depth = float(re.search(r"contact blow: deepest penetration (\S+) m", said)[1])
                    self.assertLess(depth, 0.2e-3)
                    self.assertGreater(found["motion/ball/velocity"][-1, 2], 5)
                    energy = found["energy"][:, :3].sum(axis=1)
                    self.assertLess(energy.max(), 1.001 * energy[0])

    def test_bodies_that_overlap_at_the_start_are_named(self):
        _, said = self.run_deck("bounce", "obstacles.left.at=[-0.035, 0, 0]", "time.duration=1e-3")
        self.assertRegex(said, r"left: the two overlap at the start, .* m3 around \(-0.03")
        self.assertNotIn("right: the two overlap", said)

    def test_bodies_that_would_crush_each_other_at_the_start_are_refused(self):
        for command in "run", "check":
            job = program.idiophone(command, program.SOURCE / "ctest/app/decks/bounce.yaml", "--set", "obstacles.left.at=[-0.02, 0, 0]",
                                    *(("--output-folder", self.output) if command == "run" else ()))
            self.require_status(job, program.FAILED)
            self.assertRegex(job.stderr, r"left: the two overlap at the start, .* Pa, more than Young's modulus of 5e\+06 Pa; move them")

    def test_parts_of_a_body_that_overlap_at_the_start_are_named(self):
        mesh = self.output / "ring.geo"  # of more than one turn
        mesh.write_text("""
            Point(1) = {1, 0, 0}; Point(2) = {1.3, 0, 0}; Point(3) = {1.3, 0, 0.3}; Point(4) = {1, 0, 0.3};
            Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
            Curve Loop(1) = {1:4}; Plane Surface(1) = {1}; end = 1; all[] = {}; Mesh.MeshSizeMax = 0.3;
            For turn In {1:4}
              part[] = Extrude {{0, 0, 1}, {0, 0, 0}, 1.7} { Surface{end}; Layers{5}; };
              end = part[0]; all[] += {part[1]};
            EndFor
            Physical Volume("body") = {all[]};""")
        _, said = self.run_deck("fork", f"bodies.fork={{mesh: {mesh}, material: rubber}}", "loads={}",
                                "time.duration=1e-3")
        self.assertRegex(said, r"clack: parts of fork overlap at the start, .* m3 around \(1\.")

    def test_what_contacts_do_to_a_step_is_named(self):
        stiff = "contacts.rest.stiffness=1e24"
        law = "contacts.rest.friction={type: elasto_plastic, stiffness: 1e12}"
        for settings, named in (((stiff,), "The stiffness or the damping of contacts.rest"),
                                ((stiff, "time.steps_per_sample=10"), "The stiffness or the damping of contacts.rest"),
                                ((law, "time.steps_per_sample=10"), "The bristles of contacts.rest")):
            with self.subTest(settings=settings):
                job = program.run("incline", self.output, *(word for setting in settings for word in ("--set", setting)))
                self.assertNotEqual(job.returncode, program.FINISHED)
                self.assertIn(named, job.stdout + job.stderr)


if __name__ == "__main__":
    unittest.main()
