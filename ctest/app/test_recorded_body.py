#!/usr/bin/python3
"""A recorded body sounds beside a computed one, and hides it, as if both were computed."""
import re
import unittest

import h5py

import program

STEPS = "--set", "time.steps_per_sample=8"  # the same in every run, with or without the other body
SHORT = "--set", "time.duration=0.03"
BOARD = "{mesh: ../../../meshes/bar.geo, parameters: {length: 0.2, width: 0.4, thickness: 0.02, size: 0.1}, " \
        "position: [-0.2, 0, 0.5], element: tet4, material: foam, velocity: [20, 5, 0], spin: [0, 300, 100]}"

BAR = "{mesh: ../../../meshes/bar.geo, parameters: {length: 0.04, width: 0.04, thickness: 0.04, size: 0.04}, " \
      "element: tet4, material: rubber, " \
      "driven: [{group: body, displacement: [0, 0, 1.0e-5], shape: sine, frequency: 200, duration: 1.0}]}"


def sound(path):
    with h5py.File(path) as file:
        return file["audio/ear"][()]


class RecordedBody(program.TestCase):
    def run_shadow(self, folder, *settings, ranks=1, status=program.FINISHED):
        """The deck 'shadow': a bar hums below a board that flies past."""
        arguments = [word for text in settings for word in ("--set", text)]
        job = program.run("shadow", self.output / folder, *STEPS, *SHORT, *arguments, ranks=ranks)
        self.require_status(job, status)
        return job

    def record_board(self, *settings):
        """The board alone. Returns the setting that puts its recording beside the bar."""
        self.run_shadow("alone", f"bodies={{board: {BOARD}}}", "output.surface_motion=true", *settings)
        return f"bodies.board={{recording: {self.output / 'alone' / 'shadow_surface.h5'}}}"

    def test_it_sounds_and_hides_as_if_it_were_computed_on_any_number_of_ranks(self):
        self.run_shadow("both", f"bodies.board={BOARD}")
        expected = sound(self.output / "both" / "shadow.h5")
        recorded = self.record_board()
        for ranks in (1, *program.OTHER_RANKS):
            with self.subTest(ranks=ranks):
                self.run_shadow("beside", recorded, ranks=ranks)
                self.assertEqual(sound(self.output / "beside" / "shadow.h5").tobytes(), expected.tobytes())
        self.run_shadow("clear", recorded, "radiation.visibility=off")
        self.run_shadow("bar", f"bodies={{bar: {BAR}}}")
        bar = sound(self.output / "bar" / "shadow.h5")
        hidden = sound(self.output / "clear" / "shadow.h5") - expected
        self.assertGreater(abs(hidden).max(), 0.5 * abs(bar).max(), "the board does not hide the bar")

    def test_it_sounds_the_same_by_a_model_that_needs_the_shapes_of_bodies(self):
        model = "radiation.model=kirchhoff"
        self.run_shadow("both", f"bodies.board={BOARD}", model)
        self.run_shadow("beside", self.record_board(model), model, ranks=2)
        self.assertEqual(sound(self.output / "beside" / "shadow.h5").tobytes(),
                         sound(self.output / "both" / "shadow.h5").tobytes())

    def test_a_resumed_run_has_the_same_bits(self):
        recorded = self.record_board()
        stopped = recorded, "time.wall_clock_limit=1e-6", "time.duration=0.008"  # a stop after each block
        self.run_shadow("whole", recorded, "time.duration=0.008")
        self.run_shadow("beside", *stopped, ranks=2, status=program.RESUMABLE)
        arguments = [word for text in stopped for word in ("--set", text)]
        for ranks in (3, 1, 2, 3, 1, 2):
            job = program.run("shadow", self.output / "beside", *STEPS, *SHORT, *arguments, "--resume", ranks=ranks)
            self.assertIn("resuming from", job.stdout)
            if job.returncode != program.RESUMABLE:
                break
        self.require_status(job, program.FINISHED)
        self.assertEqual(sound(self.output / "beside" / "shadow.h5").tobytes(),
                         sound(self.output / "whole" / "shadow.h5").tobytes())

    def test_a_recording_of_both_is_heard_again(self):
        self.run_shadow("beside", self.record_board(), "output.surface_motion=true", ranks=2)
        result = self.output / "beside" / "shadow.h5"
        job = program.idiophone("listen", result, "--output-folder", self.output / "heard", ranks=3)
        self.require_status(job, program.FINISHED)
        self.assertEqual(sound(self.output / "heard" / "shadow_listen.h5").tobytes(), sound(result).tobytes())

    def test_a_recording_that_ends_early_stays_still_and_says_so(self):
        recorded = self.record_board("time.duration=0.01")
        job = self.run_shadow("beside", recorded)
        self.assertRegex(job.stdout + job.stderr, r"body board: its recording ends at 0\.01\d* s; it stays still")

    def test_wrong_recordings_are_refused_with_their_place(self):
        recorded = self.record_board("audio.rate=4000", "audio.max_frequency=2000")
        for settings, words in (((recorded,), "4000 audio samples per second, audio.rate is 8000"),
                                ((recorded, "audio.rate=4000", "audio.max_frequency=2000", "radiation.air.speed=300"),
                                 "radiation.air has"),
                                ((recorded, "bodies.board.material=foam"), "unknown key"),
                                (("bodies={board: {recording: tap.csv}}",), "listen"),
                                (("bodies.board={recording: tap.csv}",), "tap.csv")):
            with self.subTest(settings=settings):
                job = self.run_shadow("wrong", *settings, status=program.WRONG_DECK)
                self.assertIn(words, job.stderr)
                self.assertTrue(re.search(r":\d+:\d+: bodies", job.stderr), job.stderr)


if __name__ == "__main__":
    unittest.main()
