#!/usr/bin/python3
"""Rooms around a ball that is shaken: walls as images, the same bits on any ranks, and what is refused."""
import unittest

import h5py
import numpy

import program

WALLS = "left: 1, right: 1, front: 1, back: 1, ceiling: 1"
ROOM = ("radiation={room: {size: [2, 1.5, 1.2], corner: [-1, -0.7, -0.6], "
        "absorption: {left: 0.1, right: 0.2, front: 0.3, back: 0.4, floor: [0.1, 0.2, 0.3, 0.4, 0.5, 0.6], ceiling: 0.3}}}")


class Rooms(program.TestCase):
    def run_free(self, output, *settings, ranks=1, status=program.FINISHED):
        motion = "bodies.ball.driven=[{group: body, displacement: [0, 0, 1e-4], shape: sine, frequency: 440}]"
        arguments = [word for setting in ("time={duration: 0.03, steps_per_sample: 12}", motion, *settings)
                     for word in ("--set", setting)]
        job = program.run("free", self.output / output, *arguments, ranks=ranks)
        self.require_status(job, status)
        return job

    def audio(self, output, name="free"):
        with h5py.File(self.output / output / f"{name}.h5") as file:
            return {listener: sound[()] for listener, sound in file["audio"].items()}

    def test_a_wall_is_heard_from_the_image_by_every_model(self):
        listeners = "listeners={here: {type: mono, position: [0.5, 0.2, 0.7]}, there: {type: mono, position: [0.5, 0.2, -1.3]}}"
        room = f"room: {{size: [2, 2, 2], corner: [-1, -1, -0.3], absorption: {{{WALLS}, floor: 0.36}}, images: 1, late: false}}"
        for model in ("model: kirchhoff", "model: waves, cell: 0.02"):
            with self.subTest(model=model):
                self.run_free("open", listeners, f"radiation={{{model}}}")
                self.run_free("room", "listeners={here: {type: mono, position: [0.5, 0.2, 0.7]}}",
                              f"radiation={{{model}, {room}}}")
                heard = self.audio("open")
                expected = heard["here"] + 0.8 * heard["there"]
                numpy.testing.assert_allclose(self.audio("room")["here"], expected, rtol=0, atol=1e-12 * abs(expected).max())
                self.assertGreater(abs(heard["there"]).max(), 0.1 * abs(heard["here"]).max())

    def test_the_same_bits_on_any_ranks_and_for_a_recording(self):
        ears = "listeners={ears: {type: stereo, position: [0.3, 0, 0.3], look: [0, 0, -1], up: [0, 1, 0]}}"
        self.run_free("one", ears, ROOM, "output.surface_motion=true")
        self.run_free("three", ears, ROOM, ranks=3)
        one = self.audio("one")["ears"]
        self.assertEqual(one.tobytes(), self.audio("three")["ears"].tobytes())
        self.require_status(program.idiophone("listen", self.output / "one" / "free.h5", "--output-folder", self.output / "heard",
                                              ranks=2), program.FINISHED)
        self.assertEqual(one.tobytes(), self.audio("heard", "free_listen")["ears"].tobytes())
        self.run_free("open", ears)
        self.assertGreater(abs(one[-20:]).max(), 0)

    def test_a_body_outside_is_refused_with_its_place(self):
        job = self.run_free("outside", "radiation={room: {size: [2, 2, 2], corner: [-1, -1, -0.03], absorption: 0.5}}",
                            status=program.WRONG_DECK)
        self.assertRegex(job.stderr, r"free\.yaml:7:3: bodies\.ball: reaches 0\.01 m out of radiation\.room")


if __name__ == "__main__":
    unittest.main()
