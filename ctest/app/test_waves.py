#!/usr/bin/python3
"""Waves on a grid: the same bits on any ranks, and from checkpoints; what the check reports; air that acts on bodies."""
import unittest

import program

WAVES = ("--set", "radiation={model: waves, cell: 0.03}", "--set", "time.duration=0.006")
BACK = (*WAVES, "--set", "radiation.back=true")
MODAL = ("--set", "bodies.plate.model={type: modal, up_to: 1000}", "--set", "loads.tap.body=plate",
         "--set", "bodies.other={mesh: ../../../meshes/square_plate.geo, parameters: {side: 0.2, thickness: 0.02, "
         "size: 0.05}, element: tet10, material: rubber, position: [0, 0, 0.08]}")

INSIDE = "--set", "listeners.inside={type: mono, position: [0.01, 0.02, 0.05]}"  # of the box around the plate

ACCELERATOR = ("--accelerator", "0")  # any OpenCL device; pocl-opencl-icd is one without hardware


class Waves(program.TestCase):
    def run_waves(self, settings, folder, ranks=1):
        self.require_status(program.run("simple", self.output / folder, *settings, ranks=ranks), program.FINISHED)
        return self.output / folder / "simple.h5"

    def sounds_of(self, contents):
        """Paths of all that is heard, none of which is silence."""
        sounds = [path for path in contents if path.startswith("audio/")]
        self.assertTrue(sounds)
        for path in sounds:
            self.assertGreater(abs(contents[path]).max(), 0, path)
        return sounds

    def require_the_same_bits(self, settings, ranks):
        """On so many ranks, and from the checkpoints of jobs that are stopped."""
        expected = program.contents(self.run_waves(settings, "one"))
        self.sounds_of(expected)
        for n in ranks:
            self.require_same(self.run_waves(settings, f"on_{n}", ranks=n), expected)
        self.run_in_jobs("simple", self.output / "stopped", *settings, ranks=5 * (2, 1))
        self.require_same(self.output / "stopped" / "simple.h5", expected)
        return expected

    @program.long_verification
    def test_the_same_bits_on_any_ranks_and_after_a_stop(self):
        self.require_the_same_bits(WAVES, (2,))

    def test_the_same_bits_with_air_that_acts_on_the_bodies_and_losses_at_walls(self):
        lossy = self.require_the_same_bits((*BACK, "--set", "radiation.wall_losses=true"), (2, 3))
        coupled = program.contents(self.run_waves(BACK, "coupled"))
        self.assertNotEqual(coupled["energy"].tobytes(), lossy["energy"].tobytes())
        free = program.contents(self.run_waves(WAVES, "free"))
        self.assertNotEqual(coupled["energy"].tobytes(), free["energy"].tobytes())

    @program.long_verification
    def test_the_same_bits_with_air_that_acts_on_a_modal_body(self):
        self.require_the_same_bits(BACK + MODAL, (2,))

    def require_an_accelerator(self):
        job = program.run("simple", self.output / "none", *ACCELERATOR, "--accelerate", "waves")
        self.require_status(job, program.FAILED)  # its deck has no waves
        self.assertIn("--accelerator has nothing to compute", job.stderr)
        job = program.run("simple", self.output / "none", *WAVES, "--accelerator", "no such device")
        self.require_status(job, program.FAILED)
        if "no such device" not in job.stderr:
            self.skipTest(job.stderr)

    def test_an_accelerator_computes_the_same_sound_and_takes_turns_with_the_processor(self):
        self.require_an_accelerator()
        ahead = *WAVES, *INSIDE, "--set", "time.duration=0.002"
        for name, settings in (("back", (*BACK, "--set", "radiation.wall_losses=true")), ("ahead", ahead)):
            expected = program.contents(self.run_waves(settings, f"{name}_processor"))
            self.run_in_jobs("simple", self.output / name, *settings, ranks=5 * (2, 1), options=(ACCELERATOR, ()))
            found = program.contents(self.output / name / "simple.h5")
            for path in self.sounds_of(expected):
                error = abs(found[path] - expected[path]).max() / abs(expected[path]).max()
                self.assertLess(error, 1e-4, (name, path))  # 0.01 dB would be 1e-3

    def test_a_recording_has_felt_the_air_and_refuses_it(self):
        self.run_waves((*BACK, "--set", "output.surface_motion=true"), "recorded")
        recording = self.output / "recorded" / "simple.h5"
        listen = "listen", recording, "--output-folder", self.output
        self.require_status(program.idiophone(*listen), program.FINISHED)
        job = program.idiophone(*listen, "--set", "radiation.back=true")
        self.require_status(job, program.WRONG_DECK)
        self.assertIn("a recording keeps its motion", job.stderr)

    def test_a_body_that_is_driven_whole_moves_the_air_that_acts_on_bodies(self):
        settings = ("--set", "bodies.board=null", "--set", "time={duration: 0.03, steps_per_sample: 20}")
        levels = []
        for waves in ("{model: waves, cell: 0.02}", "{model: waves, cell: 0.02, back: true}"):
            self.require_status(program.run("shadow", self.output / "driven", *settings, "--set", f"radiation={waves}"),
                                program.FINISHED)
            sound = program.contents(self.output / "driven/shadow.h5")["audio/ear"][80:]  # the wave of the start is over
            levels.append((sound.astype(float) ** 2).mean() ** 0.5)
        self.assertGreater(levels[0], 1e-4)
        self.assertAlmostEqual(levels[1] / levels[0], 1, delta=0.02)

    def test_the_check_reports_the_grid(self):
        job = program.idiophone("check", program.deck("simple"), *WAVES)
        self.require_status(job, program.FINISHED)
        self.assertRegex(job.stdout + job.stderr, r"waves: \d+ x \d+ x \d+ cells of 0.03 m, \d+ steps")
        self.assertRegex(job.stdout + job.stderr, r"waves: levels hold up to 1143 Hz")
        self.assertRegex(job.stdout + job.stderr, r"body \w+: 0\.\d cells across its thinnest part .* radiation.cell: 0.0")
        self.assertRegex(job.stdout + job.stderr, r"as the tines of a fork, can be off by more than 3 dB below \d+ Hz")

    def test_the_check_refuses_what_a_run_cannot_hear(self):
        job = program.idiophone("check", program.deck("simple"), *BACK, *INSIDE)
        self.require_status(job, program.FAILED)
        self.assertIn("a listener must not be inside the box around the bodies", job.stderr)

    def test_keys_that_other_models_do_not_have(self):
        for radiation, answer in (("{model: waves}", "the key 'cell' is missing"),
                                  ("{model: kirchhoff, cell: 0.01}", "only model waves uses it"),
                                  ("{model: kirchhoff, back: true}", "only model waves uses it"),
                                  ("{model: kirchhoff, wall_losses: true}", "only model waves uses it"),
                                  ("{model: waves, cell: 0.01, visibility: off}", "bend around bodies")):
            job = program.idiophone("check", program.deck("simple"), "--set", f"radiation={radiation}")
            self.require_status(job, program.WRONG_DECK)
            self.assertIn(answer, job.stderr)

    def test_steps_of_the_motion_are_a_multiple_of_those_of_the_air(self):
        job = program.idiophone("check", program.deck("simple"), *BACK, "--set", "time.steps_per_sample=100")
        self.assertIn("give 102", job.stderr)


if __name__ == "__main__":
    unittest.main()
