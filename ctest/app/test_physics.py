#!/usr/bin/python3
"""Whole runs against mechanics: a falling ball, a spinning one, one on a spring."""
import math
import unittest

import h5py
import numpy

import program


def product(a, b):
    """Of two quaternions (w, x, y, z): the rotation b, then a."""
    return numpy.array([a[0] * b[0] - a[1:] @ b[1:], *(a[0] * b[1:] + b[0] * a[1:] + numpy.cross(a[1:], b[1:]))])


class Physics(program.TestCase):
    def motion(self, *settings, channel):
        """Runs the free ball and returns the times and values of one of its motion channels."""
        arguments = [word for setting in settings for word in ("--set", setting)]
        self.require_status(program.run("free", self.output, *arguments), program.FINISHED)
        with h5py.File(self.output / "free.h5") as file:
            series = file[channel]
            return numpy.arange(len(series)) / series.attrs["rate"], series[()]

    def test_a_falling_ball_falls_half_g_t_squared(self):
        time, centre = self.motion("gravity=[0, 0, -9.81]", channel="motion/ball/centre_of_mass")
        self.assertGreaterEqual(time[-1], 0.05)
        numpy.testing.assert_allclose(centre[:, 2] - centre[0, 2], -9.81 * time**2 / 2, rtol=1e-10, atol=1e-15)
        numpy.testing.assert_allclose(centre[:, :2] - centre[0, :2], 0, atol=1e-15)

    def test_a_spinning_ball_keeps_its_angular_momentum(self):
        _, momentum = self.motion("bodies.ball.spin=[3, -20, 50]", channel="motion/ball/angular_momentum")
        self.assertGreater(numpy.linalg.norm(momentum[0]), 1e-3)
        numpy.testing.assert_allclose(momentum, numpy.broadcast_to(momentum[0], momentum.shape),
                                      atol=1e-6 * numpy.linalg.norm(momentum[0]))

    def test_a_tumbling_bar_turns_by_its_angular_velocity(self):
        mesh = program.SOURCE / "meshes" / "bar.geo"
        size = "length: 0.2, width: 0.06, thickness: 0.04, size: 0.06"
        time, orientation = self.motion(f"bodies.ball.mesh={mesh}", f"bodies.ball.parameters={{{size}}}",
                                        "materials.rubber.young=1e9", "bodies.ball.spin=[60, 30, 120]",
                                        "audio.rate=8000", "audio.max_frequency=4000", "output.motion_per_second=8000",
                                        channel="motion/ball/orientation")
        with h5py.File(self.output / "free.h5") as file:
            velocity = file["motion/ball/angular_velocity"][()]
        self.assertGreater(numpy.linalg.norm(velocity - velocity[0], axis=1).max(), 50)  # no principal axis
        integral = orientation[0]
        for row in range(1, len(time)):
            turn = (velocity[row] + velocity[row - 1]) / 2 * (time[row] - time[row - 1])
            angle = numpy.linalg.norm(turn)
            integral = product(numpy.array([math.cos(angle / 2), *(math.sin(angle / 2) * turn / angle)]), integral)
            numpy.testing.assert_allclose(orientation[row], integral, atol=2e-4)
        self.assertLess(orientation[:, 0].min(), -0.5)  # more than half a turn, without a change of sign

    def test_a_ball_on_a_spring_swings_at_its_frequency(self):
        stiffness = 4000.0  # N/m; the patch is the whole surface, so that nothing turns or bends
        time, centre = self.motion("bodies.ball.velocity=[0.1, 0, 0]", "materials.rubber.young=1e8",
                                   f"bodies.ball.supports.spring={{at: [0, 0, 0.04], radius: 1, stiffness: {stiffness}}}",
                                   channel="motion/ball/centre_of_mass")
        with h5py.File(self.output / "free.h5") as file:
            mass = 2 * file["motion/ball/energy"][0, 0] / 0.1**2
        omega = math.sqrt(stiffness / mass)
        amplitude = 0.1 / omega
        self.assertGreater(omega * time[-1], math.pi)  # at least half a period
        numpy.testing.assert_allclose(centre[:, 0] - centre[0, 0], amplitude * numpy.sin(omega * time),
                                      atol=0.01 * amplitude)

    def test_an_undamped_free_ball_keeps_its_energy(self):
        _, energy = self.motion(
            "loads={tap: {at: [0, 0, 0.04], radius: 0.03, force: [0, 0, -2], duration: 2e-3}}",
            "time.steps_per_sample=20", channel="energy")
        total = energy[:, :-1].sum(axis=1)
        after = total[20:]  # 10 ms: the tap is over
        self.assertGreater(after[0], 1e-7)
        self.assertLess(after.max() - after.min(), 0.01 * after.mean())
        half = len(after) // 2
        self.assertLess(abs(after[:half].mean() - after[half:].mean()), 1e-3 * after.mean())
        numpy.testing.assert_allclose(after.mean(), energy[-1, -1], rtol=0.005)  # what the tap did is there

    def test_a_body_driven_whole_moves_as_a_rigid_one(self):
        turn = "{axis: [0, 3, 0], degrees: 90, pivot: [0, 0, 0.1]}"  # rad: pi/2
        settings = (f"bodies.ball.driven=[{{group: body, rotation: {turn}, shape: sine, frequency: 20}}]",
                    "time.steps_per_sample=20")
        time, centre = self.motion(*settings, channel="motion/ball/centre_of_mass")
        angle = math.pi / 2 * numpy.sin(2 * math.pi * 20 * time)
        arm = centre[0] - (0, 0, 0.1)
        expected = numpy.stack([arm[0] * numpy.cos(angle) + arm[2] * numpy.sin(angle), numpy.full_like(time, arm[1]),
                                arm[2] * numpy.cos(angle) - arm[0] * numpy.sin(angle)], axis=1) + (0, 0, 0.1)
        numpy.testing.assert_allclose(centre, expected, rtol=0, atol=1e-12)
        with h5py.File(self.output / "free.h5") as file:
            kinetic, elastic = file["motion/ball/energy"][()].T
        self.assertLess(elastic.max(), 1e-9 * kinetic.max())
        arguments = [word for setting in settings for word in ("--set", setting)]
        checked = program.idiophone("check", program.deck("free"), *arguments)
        self.require_status(checked, program.FINISHED)
        self.assertIn("held everywhere", checked.stdout)


if __name__ == "__main__":
    unittest.main()
