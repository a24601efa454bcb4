#!/usr/bin/python3
"""Proxies that move, break and radiate by the model of the deck."""
import json
import re
import subprocess
import unittest

import h5py
import numpy
from scipy.io import wavfile

import program
import test_proxies


class ProxyBodies(test_proxies.Rendered):
    def test_results_have_frames_of_bodies_that_vibrate_and_move(self):
        blow = ("duration: 0.02\nevents:\n"
                "  - {time: 0, at: [0.02, 0.01, 0.01], direction: [0, 0, -1], mass: 0.01, hardness: 1e7, speed: 1}\n")
        (self.output / "score.yaml").write_text(blow)
        folder = self.output / "result"
        job = program.idiophone("proxies", program.deck("simple"), "--score", self.output / "score.yaml",
                                "--output-folder", folder)
        self.require_status(job, program.FINISHED)
        job = program.idiophone("proxies", program.deck("simple"), "--score", self.output / "score.yaml",
                                "--frames-per-second", 1000, "--output", self.output / "film.h5")
        self.require_status(job, program.FINISHED)
        with h5py.File(folder / "simple.h5") as file, h5py.File(self.output / "film.h5") as film:
            numpy.testing.assert_allclose(file["frames/time"][()], numpy.arange(21) / 1000, atol=1e-9)  # the deck's rate
            frames, filmed = (each["frames/plate/displacement"][()] for each in (file, film))
            self.assertEqual(file["mesh/plate/nodes"].shape, film["mesh/plate/nodes"].shape)
        self.assertEqual(frames.shape[0], 21)
        self.assertEqual(abs(frames[0]).max(), 0)
        self.assertLess(abs(frames[5:20] - filmed[5:20]).max(), 0.1 * abs(filmed).max())  # other steps, the same vibration
        self.assertTrue((folder / "simple.xdmf").exists())
        self.require_status(program.run("bounce", self.output), program.FINISHED)
        job = program.idiophone("proxies", program.deck("bounce"), "--contacts", self.output / "bounce.h5",
                                "--output-folder", folder, "--frames-per-second", 500)
        self.require_status(job, program.FINISHED)
        run, proxy = (program.contents(path / "bounce.h5") for path in (self.output, folder))
        body = next(name.split("/")[1] for name in proxy if name.startswith("frames/") and name.endswith("displacement"))
        moved = proxy[f"frames/{body}/displacement"].mean(axis=1)
        path = run[f"motion/{body}/centre_of_mass"]
        self.assertLess(numpy.linalg.norm(moved[-1] - (path[-1] - path[0])), 0.05 * numpy.linalg.norm(path[-1] - path[0]))

    def test_radiates_by_the_model_of_the_deck(self):
        kirchhoff = ["--set", "radiation.model=kirchhoff", "--set", "materials.rubber.damping.mass=100"]
        self.proxies(*kirchhoff)
        near = self.sound()[1]
        (self.output / "score.yaml").write_text(test_proxies.SCORE)
        radiate = ["proxies", program.deck("simple"), "--score", self.output / "score.yaml", "--output-folder", self.output / "result",
                   *kirchhoff]
        job = program.idiophone(*radiate)
        self.require_status(job, program.FINISHED)
        rate, heard = wavfile.read(self.output / "result/simple.wav")
        self.assertEqual((rate, len(heard)), (8000, 1600))
        peaks = [abs(numpy.fft.rfft(sound.astype(float)[80:1600])).argmax() for sound in (near, heard)]
        self.assertAlmostEqual(peaks[0], peaks[1], delta=1)  # the same vibration
        facts = json.loads(program.idiophone("info", "--json", self.output / "result/simple.h5").stdout)["run"]
        self.assertGreater(facts["bodies"]["plate"]["springs"], facts["bodies"]["plate"]["masses"])
        with open(self.output / "score.yaml", "a") as score:
            score.write("  - {type: tune, time: 0.05, tension: 4}\n")
        job = program.idiophone(*radiate)
        self.require_status(job, program.FAILED)
        self.assertIn("can't tune a body", job.stdout + job.stderr)
        self.assertIn("leave out --output,", self.proxies("--output-folder", self.output / "result", status=program.FAILED))

    def test_contacts_of_a_result_drive_proxies(self):
        # The ball flies to the wall at x = 0.05 with 1 m/s for 0.01 s; the ears are 34.3 m away from it, 0.1 s of sound.
        job = program.run("bounce", self.output)
        self.require_status(job, program.FINISHED)
        result, = self.output.glob("bounce*.h5")
        ears = "listeners.ear={type: stereo, position: [0, 0, 34.3], look: [0, 0, -1], up: [0, 1, 0], separation: 10}"
        self.proxies("--contacts", result, "--set", ears, deck="bounce", score=None)
        sound = self.sound()[1]
        self.assertEqual(sound.shape, (1000, 2))
        power = (sound ** 2).max(axis=1)
        self.assertGreater(power.max(), 0)
        self.assertLess(power[:200].max(), 1e-6 * power.max())

    def test_moving_bodies_are_heard_with_their_doppler_shift(self):
        # The ball hits the wall at x = 0.05 with 8 m/s and flies back, towards one ear and away from the other.
        flight = ["--set", "bodies.ball.velocity=[8, 0, 0]", "--set", "obstacles.left=null", "--set", "contacts.left=null",
                  "--set", "listeners.front={type: mono, position: [-20, 0, 0]}",
                  "--set", "listeners.back={type: mono, position: [20, 0, 0]}"]
        self.require_status(program.run("bounce", self.output, *flight), program.FINISHED)
        result, = self.output.glob("bounce*.h5")
        job = program.idiophone("proxies", program.deck("bounce"), *flight, "--contacts", result,
                                "--output-folder", self.output / "heard")
        self.require_status(job, program.FINISHED)
        pitches = []
        for ear in ("front", "back"):
            rate, sound = wavfile.read(self.output / f"heard/bounce_{ear}.wav")
            spectrum = abs(numpy.fft.rfft(sound[300:900] * numpy.hanning(600), 1 << 16))
            low, high = 300 * (1 << 16) // rate, 360 * (1 << 16) // rate  # the lowest mode is alone there
            pitches.append(low + spectrum[low:high].argmax())
        self.assertAlmostEqual(pitches[0] / pitches[1], (343 + 8) / (343 - 8), delta=0.006)

    def test_brittle_body_breaks_into_pieces_that_sound(self):
        blow = ("duration: 0.05\nevents:\n"
                "  - {time: 0.01, at: [0.06, 0.02, 0.02], direction: [0, 0, -1], mass: 0.05, hardness: 1e7, speed: 5}\n")
        report = ["--report", self.output / "choices.csv", *self.box()]
        self.assertNotIn("broke into", self.proxies(*report, "--strength", "plate=1e9", score=blow))
        told = self.proxies(*report, "--strength", "plate=1e4", "--most-active", 100, score=blow)
        self.assertRegex(told, r"plate broke into \d+ pieces and released")
        self.assertIn("plate.1", [choice["body"] for choice in self.choices()])
        self.assertTrue(numpy.isfinite(self.sound()[1]).all())
        self.assertIn("no deck has a body", self.proxies("--strength", "plat=1e9", status=program.FAILED))
        self.assertIn("is not BODY=PA", self.proxies("--strength", "plate", status=105))

    def test_pane_and_vase_of_the_examples_break_as_a_film_shows(self):
        for deck, score, strength, size in (("pane", "stone", "4e7", 0.02), ("vase", "floor", "1e7", 0.014)):
            inputs = program.SOURCE / "inputs/breaking"
            text = (inputs / f"{score}.yaml").read_text().replace("duration: 0.8", "duration: 0.02")
            (self.output / "score.yaml").write_text(text)
            film = self.output / "film.h5"
            render = ["proxies", inputs / f"{deck}.yaml", "--score", self.output / "score.yaml",
                      "--set", f"bodies.{deck}.parameters.size={size}"]
            job = program.idiophone(*render, "--most-active", 200, "--strength", f"{deck}={strength}",
                                    "--output", film, "--frames-per-second", 1000)
            self.require_status(job, program.FINISHED)
            parts = [int(number) for number in re.findall(r"; (\d+) parts", job.stdout + job.stderr)]
            self.assertEqual(parts, sorted(parts))
            self.assertGreater(parts[-1], 5)
            with h5py.File(film) as file:
                sound, moved = file["audio/film"][()], file[f"frames/{deck}/displacement"][()]
                times, nodes = file["frames/time"][()], file[f"mesh/{deck}/nodes"][()]
            self.assertTrue(numpy.isfinite(sound).all() and numpy.isfinite(moved).all())
            self.assertTrue(numpy.allclose(times, numpy.arange(20) / 1000, atol=1e-4))
            places, first = numpy.unique(nodes, axis=0, return_inverse=True)
            gap = [max(numpy.ptp(frame[first == i], axis=0).max() for i in range(0, len(places), 7)) for frame in moved[[5, -1]]]
            self.assertLess(gap[0], 1e-9)      # before the blow
            self.assertGreater(gap[1], 1e-4)
            self.assertTrue((self.output / "film.xdmf").exists())
            if deck == "pane":
                still = subprocess.run([program.SOURCE / "scripts/movie", film, "--still", "0.015", self.output / "still.png"],
                                       capture_output=True, text=True, timeout=program.TIMEOUT)
                self.require_status(still, program.FINISHED)
                self.assertTrue((self.output / "still.png").exists())
            self.require_status(program.idiophone(*render, "--output", self.output / "whole.h5"), program.FINISHED)
            with h5py.File(self.output / "whole.h5") as file:
                whole = file["audio/whole"][()]
                self.assertNotIn(deck, file["frames"])
            late = slice(len(whole) // 2, None)
            self.assertLess(numpy.abs(sound).max(), 500)  # Pa: splinters that are let go are loud
            self.assertGreater(numpy.abs(sound[late] - whole[late]).max(), 0.05 * numpy.abs(whole).max())


if __name__ == "__main__":
    unittest.main()
