#!/usr/bin/python3
"""Of which forces analyze warns: those whose sound arrives in the analysed part. The results are written here."""
import re
import unittest

import h5py
import numpy

import program

RATE = 8000
DURATION = 1.0  # s
SPEED = 171.5  # m/s, of sound
DELAY = 0.010  # s
NEAR = [-SPEED * DELAY, 0, 0]  # m: so far away is the listener, and twice as far from the origin
LISTENER = [-2 * SPEED * DELAY, 0, 0]
FAR_AWAY = [NEAR[0] - SPEED * 0.5, 0, 0]  # of another listener, half a second away
TIME = numpy.arange(int(DURATION * RATE)) / RATE


class HeardForces(program.TestCase):
    def result(self, **series):
        """A decaying tone, and series by their paths, where "/" is written as "__": (rate, columns, rows)."""
        path = self.output / "heard.h5"
        tone = numpy.exp(-5 * TIME) * numpy.sin(2 * numpy.pi * 440 * TIME)
        with h5py.File(path, "w") as file:
            file.attrs.update(format="idiophone result", format_version=1, name="heard")
            file["deck"], file["overrides"] = ["name: heard"], [f"radiation.air.speed={SPEED}"]
            for name, (rate, columns, rows) in {"audio__ear": (RATE, ["ear"], tone), **series}.items():
                data = file.create_dataset(name.replace("__", "/"), data=numpy.reshape(rows, (-1, len(columns))))
                data.attrs.update(rate=rate, unit="1", columns=columns, description="of a test")
            for name, listener in file["audio"].items():
                listener.attrs["positions"] = [FAR_AWAY if name == "far" else LISTENER]
        return path

    def contact(self, touches, **series):
        """A result with a contact that touches at some times."""
        rows = touches[:, None]
        return self.result(contacts__clack__force=(RATE, ["x", "y", "z"], rows * [0.0, 0.0, 5.0]),
                           contacts__clack__point=(RATE, ["x", "y", "z"], rows * NEAR), **series)

    def heard_until(self, result, start, end):
        """{name of a force: the time of its warning, s}"""
        job = program.idiophone("analyze", result, "--start", start, "--duration", end - start)
        self.require_status(job, program.FINISHED)
        return {name: float(time) for name, time in re.findall(r"(loads|contact \w+), heard until ([\d.]+) s", job.stderr + job.stdout)}

    def test_a_contact_is_heard_until_its_sound_has_arrived(self):
        result = self.contact(TIME < 0.2)
        self.assertAlmostEqual(self.heard_until(result, 0.205, 0.9)["contact clack"], 0.2 + DELAY, delta=2 / RATE)
        self.assertEqual(self.heard_until(result, 0.212, 0.9), {})

    def test_a_contact_closes_when_its_first_sound_arrives(self):
        result = self.contact(TIME >= 0.2)
        self.assertEqual(self.heard_until(result, 0.212, 0.9), {}, "it stands as long as it is heard")
        self.assertAlmostEqual(self.heard_until(result, 0.205, 0.9)["contact clack"], 0.9, delta=2 / RATE)

    def test_a_contact_opens_when_its_last_sound_has_arrived(self):
        result = self.contact(TIME < 0.5)
        self.assertEqual(self.heard_until(result, 0.1, 0.507), {})
        self.assertAlmostEqual(self.heard_until(result, 0.1, 0.513)["contact clack"], 0.5 + DELAY, delta=2 / RATE)

    def test_each_listener_hears_a_contact_in_its_time(self):
        result = self.contact(TIME < 0.1, audio__far=(RATE, ["far"], numpy.sin(2 * numpy.pi * 440 * TIME)))
        job = program.idiophone("analyze", result, "--start", 0.3, "--duration", 0.6)
        self.require_status(job, program.FINISHED)
        warnings = re.findall(r"(\w+): forces act in this part \(contact clack, heard until ([\d.]+) s", job.stderr + job.stdout)
        self.assertEqual([name for name, _ in warnings], ["far"])
        self.assertAlmostEqual(float(warnings[0][1]), 0.6, delta=2 / RATE)

    def test_a_part_outside_of_the_sound_is_told(self):
        result = self.contact(TIME < 0.2)
        for start, duration in [(0.9, -0.5), (0.9, "inf"), (2.0, 0.1)]:
            job = program.idiophone("analyze", result, "--start", start, "--duration", duration)
            self.require_status(job, program.FAILED)
            self.assertIn("the sound lasts 1 s", job.stderr)

    def test_loads_are_heard_from_the_farthest_body_until_the_end_of_the_part(self):
        rate = 1000
        times = numpy.arange(int(DURATION * rate)) / rate
        result = self.result(energy=(rate, ["kinetic", "work"], numpy.stack([0 * times, numpy.minimum(times, 0.5)], axis=1)),
                             motion__near__centre_of_mass=(rate, ["x", "y", "z"], numpy.full((len(times), 3), NEAR)),
                             motion__far__centre_of_mass=(rate, ["x", "y", "z"], numpy.zeros((len(times), 3))))
        self.assertAlmostEqual(self.heard_until(result, 0.1, 0.9)["loads"], 0.5 + 2 * DELAY, delta=2 / rate)
        self.assertAlmostEqual(self.heard_until(result, 0.1, 0.515)["loads"], 0.515, delta=1e-6)
        self.assertAlmostEqual(self.heard_until(result, 0.515, 0.9)["loads"], 0.5 + 2 * DELAY, delta=2 / rate)
        self.assertEqual(self.heard_until(result, 0.525, 0.9), {})


if __name__ == "__main__":
    unittest.main()
