#!/usr/bin/python3
"""Recorded motion is heard again: by the same listeners to the same bits, by others as a run with them hears it."""
import json
import shutil
import subprocess
import tempfile
import typing
import unittest

import h5py
import numpy

import program

RECORD = "--set", "output.surface_motion=true"
OTHER_LISTENERS = """
name: elsewhere
listeners:
  pair: {type: stereo, position: [0.3, 0.1, 0.4], look: [-0.3, -0.1, -0.4], up: [0, 1, 0]}
  near: {type: mono, position: [0, 0.15, 0.1]}
audio: {dc_block: 0.05}
output: {wav: pcm16}
"""


def audio(path):
    with h5py.File(path) as file:
        return {name: file["audio"][name][()] for name in file["audio"]}


def attributes(path):
    """All that is told of each channel."""
    with h5py.File(path) as file:
        return {name: {key: str(value) for key, value in file["audio"][name].attrs.items()} for name in file["audio"]}


def sphere(subdivisions):
    """An icosahedron's corners and triangles, each divided in four so many times, on the unit sphere."""
    t = (1 + 5**0.5) / 2
    points = [(-1, t, 0), (1, t, 0), (-1, -t, 0), (1, -t, 0), (0, -1, t), (0, 1, t), (0, -1, -t), (0, 1, -t),
              (t, 0, -1), (t, 0, 1), (-t, 0, -1), (-t, 0, 1)]
    triangles = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2),
                 (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11),
                 (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    points = [numpy.array(p) / numpy.linalg.norm(p) for p in points]
    for _ in range(subdivisions):
        middles, finer = {}, []

        def middle(a, b, middles=middles):
            if (min(a, b), max(a, b)) not in middles:
                middles[min(a, b), max(a, b)] = len(points)
                point = points[a] + points[b]
                points.append(point / numpy.linalg.norm(point))
            return middles[min(a, b), max(a, b)]

        for a, b, c in triangles:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        triangles = finer
    return numpy.array(points), numpy.array(triangles, numpy.int32)


class Listen(program.TestCase):
    recorded: typing.ClassVar = {}  # folders of runs that several tests start from, by what was run

    def record(self, name, *arguments, ranks=2):
        """A result beside its recording, in the folder of this test. Each run is computed once."""
        if (name, arguments, ranks) not in self.recorded:
            directory = tempfile.TemporaryDirectory()
            self.addClassCleanup(directory.cleanup)
            self.require_status(program.run(name, directory.name, *RECORD, *arguments, ranks=ranks), program.FINISHED)
            self.recorded[name, arguments, ranks] = directory.name
        shutil.copytree(self.recorded[name, arguments, ranks], self.output, dirs_exist_ok=True)
        return self.output / f"{name}.h5"

    def listen(self, *arguments, ranks=1, status=program.FINISHED):
        job = program.idiophone("listen", *arguments, "--output-folder", self.output / "heard", ranks=ranks)
        self.require_status(job, status)
        return job

    def require_same_sound(self, found, expected):
        self.assertEqual(attributes(found), attributes(expected))
        found, expected = audio(found), audio(expected)
        for name, samples in expected.items():
            self.assertGreater(abs(samples).max(), 0, f"{name} is silent: it tests nothing")
            self.assertEqual(found[name].tobytes(), samples.tobytes(), f"{name} differs")

    def test_the_same_listeners_hear_the_same_bits_on_any_number_of_ranks(self):
        for name in ("simple", "rich"):
            result = self.record(name)
            for ranks in (1, *program.OTHER_RANKS):
                with self.subTest(name=name, ranks=ranks):
                    self.listen(result, ranks=ranks)
                    self.require_same_sound(self.output / "heard" / f"{name}_listen.h5", result)

    def test_recording_changes_nothing_else(self):
        result = self.record("rich")
        self.require_status(program.run("rich", self.output / "plain"), program.FINISHED)
        self.require_same(result, program.contents(self.output / "plain" / "rich.h5"))

    def test_other_listeners_hear_what_a_run_with_them_hears(self):
        deck = self.output / "elsewhere.yaml"
        deck.write_text(OTHER_LISTENERS)
        self.listen(self.record("simple"), deck, ranks=2)
        settings = []
        for setting in ("listeners={pair: {type: stereo, position: [0.3, 0.1, 0.4], look: [-0.3, -0.1, -0.4], "
                        "up: [0, 1, 0]}, near: {type: mono, position: [0, 0.15, 0.1]}}", "audio.dc_block=0.05"):
            settings += ["--set", setting]
        self.require_status(program.run("simple", self.output / "run", *settings), program.FINISHED)
        self.require_same_sound(self.output / "heard" / "elsewhere.h5", self.output / "run" / "simple.h5")
        for name in ("pair", "near"):
            self.assertTrue((self.output / "heard" / f"elsewhere_{name}.wav").exists())
        told = program.idiophone("info", self.output / "heard" / "elsewhere.h5")
        self.require_status(told, program.FINISHED)
        self.assertIn("job 1: 2 ranks", told.stdout)

    def test_a_result_says_what_was_heard(self):
        recorded = self.record("simple")
        self.listen(recorded, "--set", "audio.dc_block=0.05", ranks=2)
        run = json.loads(program.idiophone("info", "--json", self.output / "heard" / "simple_listen.h5").stdout)["run"]
        origin = json.loads(program.idiophone("info", "--json", recorded).stdout)["run"]
        self.assertEqual(run["recorded_run"], "simple")
        self.assertEqual(run["triangles"], origin["triangles"])
        self.assertEqual(run["bodies"]["plate"]["triangles"], origin["bodies"]["plate"]["triangles"])
        self.assertIn("dc_block: 0.05", run["deck"])
        self.assertIn("name: simple_listen", run["deck"])
        job, = run["jobs"]
        self.assertEqual(job["ranks"], 2)
        self.assertEqual(job["last_sample"], origin["jobs"][0]["last_sample"])
        self.assertGreater(job["stages"]["radiation"], 0)
        self.assertEqual(job["versions"], origin["jobs"][0]["versions"])
        self.assertNotIn("elements_per_second", job)
        deck = self.output / "again.yaml"  # the resolved deck hears the same
        deck.write_text(run["deck"])
        self.listen(recorded, deck, "--set", "name=again")
        self.require_same_sound(self.output / "heard" / "again.h5", self.output / "heard" / "simple_listen.h5")

    @program.long_verification
    def test_other_models_hear_what_a_run_with_them_hears(self):
        whole = self.record("rich")  # by model kirchhoff
        self.listen(whole, ranks=3)
        self.require_same_sound(self.output / "heard" / "rich_listen.h5", whole)
        expected = audio(whole)["ears"]
        self.listen(self.record("rich", "--set", "radiation.model=huygens"), "--set", "radiation.model=kirchhoff", ranks=2)
        found = audio(self.output / "heard" / "rich_listen.h5")["ears"]
        # The recording ends with the sound of model huygens. The filter of sounds in pascals reaches further ahead.
        self.assertGreaterEqual(len(found), len(expected) - 41)
        self.assertEqual(found.tobytes(), expected[:len(found)].tobytes())

    def test_one_listener_is_moved_on_the_command_line(self):
        self.listen(self.record("simple"), "--set", "listeners.ear.position=[0, 0.2, 0.2]")
        self.require_status(program.run("simple", self.output / "run", "--set", "listeners.ear.position=[0, 0.2, 0.2]"),
                            program.FINISHED)
        self.require_same_sound(self.output / "heard" / "simple_listen.h5", self.output / "run" / "simple.h5")

    @program.long_verification
    def test_interrupted_recording_goes_on_to_the_same_bits(self):
        whole = program.contents(self.record("rich").with_name("rich_surface.h5"))
        other = self.output / "interrupted"
        limit = "--set", "time.wall_clock_limit=1e-6"
        for number, ranks in enumerate(2 * (3, 2, 1, 4, 2, 3)):
            job = program.run("rich", other, *RECORD, *limit, "--resume", ranks=ranks)
            if job.returncode != program.RESUMABLE:
                break
            if number < 5:  # the last jobs do no more than make the last sounds final
                shutil.copy(other / "rich.h5", other / "half.h5")
                shutil.copy(other / "rich_surface.h5", other / "half_surface.h5")
        self.require_status(job, program.FINISHED)
        self.require_same(other / "rich_surface.h5", whole)
        job = self.listen(other / "half.h5", ranks=2)  # what there is of an unfinished run
        self.assertIn("it ends before the sound does", job.stdout)
        half = audio(self.output / "heard" / "rich_listen.h5")["far"]
        self.assertGreater(len(half), 10)
        self.assertEqual(half.tobytes(), audio(other / "rich.h5")["far"][:len(half)].tobytes())

    def test_what_a_recording_takes_is_told_before(self):
        job = program.idiophone("check", program.deck("simple"), *RECORD)
        self.require_status(job, program.FINISHED)
        stated = float(job.stdout.split("recorded surface motion: ")[1].split()[0]) * 1e6
        with h5py.File(self.record("simple").with_name("simple_surface.h5")) as file:
            found = 8000 * (file["pressure"].dtype.itemsize * file["pressure"].shape[1] + 24 * file["position"].shape[1])
        self.assertAlmostEqual(stated, found, delta=0.05e6)

    def test_signals_stop_it_in_good_order(self):
        result = self.record("simple", "--set", "radiation.model=huygens")  # the first block has sound of it
        signals = program.preload("BLOCK_SIGNAL", SIGNAL=15, SIGNAL_BLOCK=1, SIGNAL_RANK=1)
        job = program.idiophone("listen", result, "--output-folder", self.output / "heard", ranks=2, environment=signals)
        self.require_status(job, program.RESUMABLE)
        found = audio(self.output / "heard" / "simple_listen.h5")["ear"]
        self.assertLess(0, len(found))
        self.assertLess(len(found), 100)
        self.assertEqual(found.tobytes(), audio(result)["ear"][:len(found)].tobytes())

    def check_wrong(self, *messages, deck=None, settings=(), source=None, status=program.WRONG_DECK):
        words = [word for setting in settings for word in ("--set", setting)]
        if deck is not None:
            (self.output / "ears.yaml").write_text(deck)
            words = [self.output / "ears.yaml", *words]
        for ranks in (None, 2):
            job = self.listen(source or self.result, *words, ranks=ranks, status=status)
            for message in messages:
                self.assertIn(message, job.stderr)

    def test_wrong_input(self):
        self.result = self.record("simple")
        ears = "listeners: {ear: {type: mono, position: [0, 0, 1]}}\n"
        self.check_wrong("ears.yaml:2:1: time: unknown key", deck=ears + "time: {duration: 1}\n")
        self.check_wrong("ears.yaml:2:9: audio.rate: unknown key", deck=ears + "audio: {rate: 44100}\n")
        self.check_wrong("ears.yaml:2:10: output.frames_per_second: unknown key", deck=ears + "output: {frames_per_second: 9}\n")
        self.check_wrong("radiation.air.speed: is given by the recording", deck=ears + "radiation: {air: {speed: 300}}\n")
        self.check_wrong("did you mean 'position'?", deck="listeners: {ear: {type: mono, psition: [0, 0, 1]}}\n")
        self.check_wrong("--set listeners.ear.type=deaf:1:", settings=["listeners.ear.type=deaf"])
        self.check_wrong("listeners: is empty", deck="listeners: {}\n")
        no_recording = self.output / "silent.h5"
        shutil.copy(self.result, no_recording)
        self.check_wrong("but an idiophone result", "surface_motion: true",
                         source=no_recording, status=program.FAILED)
        self.check_wrong("No such file", "surface_motion: true", source=self.output / "none.h5", status=program.FAILED)
        recording = self.output / "simple_surface.h5"
        recording.write_bytes(recording.read_bytes()[:5000])
        self.check_wrong("simple_surface.h5", "damaged", source=self.result, status=program.FAILED)

    def test_the_run_is_not_overwritten(self):
        self.result = self.record("simple")
        job = program.idiophone("listen", self.result, "--set", "name=simple", "--output-folder", self.output)
        self.require_status(job, program.FAILED)
        self.assertIn("would be overwritten", job.stderr)

    def test_motion_that_is_no_number_is_named(self):
        self.result = self.record("simple")
        with h5py.File(self.output / "simple_surface.h5", "r+") as file:
            file["position"][50, 3] = numpy.nan
            for attribute in ("crc32", "rows_per_checksum"):  # else it is a damaged file
                del file["position"].attrs[attribute]
        self.check_wrong("can't be heard", "not finite", status=program.FAILED)


class MeshSequence(program.TestCase):
    """A sphere that pulsates at 500 Hz, as a sequence of mesh files: p = z v pi a^2/r by the paper's model."""
    RADIUS, SPEED, FREQUENCY, DISTANCE, FRAMES = 0.05, 1e-3, 500.0, 2.0, 240

    def setUp(self):
        super().setUp()
        self.points, self.triangles = sphere(3)
        times = numpy.arange(self.FRAMES) / 8000.0
        grown = self.SPEED / (2 * numpy.pi * self.FREQUENCY) * numpy.sin(2 * numpy.pi * self.FREQUENCY * times)
        self.positions = (self.RADIUS + grown)[:, None, None] * self.points
        self.ears = self.output / "ears.yaml"
        self.ears.write_text(f"name: heard\nlisteners: {{ear: {{type: mono, position: [0, 0, {self.DISTANCE}]}}}}\n"
                             "audio: {dc_block: 0}\nradiation: {model: huygens}\n")

    def sequence(self, *arguments, status=0):
        job = subprocess.run([program.SOURCE / "scripts" / "mesh_sequence", *map(str, arguments)], capture_output=True,
                             text=True, timeout=program.TIMEOUT)
        self.require_status(job, status)
        return job

    def check_sound(self, recording, ranks):
        self.require_status(program.idiophone("listen", recording, self.ears, "--output-folder", self.output, ranks=ranks),
                            program.FINISHED)
        with h5py.File(self.output / "heard.h5") as file:
            sound, rate = file["audio/ear"][:, 0], file["audio/ear"].attrs["rate"]
        self.assertEqual(rate, 16000)
        steady = sound[int(0.01 * rate):int(0.026 * rate)]  # 8 periods
        periods = numpy.exp(-2j * numpy.pi * self.FREQUENCY * numpy.arange(len(steady)) / rate)
        level = 2 * abs(numpy.mean((steady - steady.mean()) * periods))
        nearer = 1 - 2 / 3 * self.RADIUS / self.DISTANCE  # the visible side is, on the mean
        expected = 1.21 * 343 * self.SPEED * numpy.pi * self.RADIUS**2 / self.DISTANCE * nearer
        self.assertAlmostEqual(level / expected, 1, delta=0.03)
        spectrum = abs(numpy.fft.rfft((steady - steady.mean()) * numpy.hanning(len(steady))))
        self.assertEqual(spectrum.argmax() * rate / len(steady), self.FREQUENCY)

    def test_files_of_a_folder(self):
        import meshio
        folder = self.output / "sphere"
        folder.mkdir()
        for frame, positions in enumerate(self.positions):
            meshio.write_points_cells(folder / f"{frame:04}.ply", positions, [("triangle", self.triangles)])
        self.sequence(folder, "--frames-per-second", 8000, "--rate", 16000)
        self.check_sound(self.output / "sphere_surface.h5", ranks=2)

    def test_an_npz(self):
        numpy.savez(self.output / "sphere.npz", triangles=self.triangles, positions=1000 * self.positions,
                    times=numpy.arange(self.FRAMES) / 8000.0)
        self.sequence(self.output / "sphere.npz", "--rate", 16000, "--scale", 1e-3)
        self.check_sound(self.output / "sphere_surface.h5", ranks=None)

    def test_wrong_sequences_are_answered(self):
        path = self.output / "sphere.npz"
        numpy.savez(path, triangles=self.triangles[:, ::-1], positions=self.positions)
        self.assertIn("--frames-per-second", self.sequence(path, status=1).stderr)
        self.assertIn("--flip", self.sequence(path, "--frames-per-second", 8000, status=1).stderr)
        self.assertIn("there is no", self.sequence(self.output / "none.npz", status=1).stderr)
        numpy.savez(path, triangles=self.triangles)
        self.assertIn("no array 'positions'", self.sequence(path, status=1).stderr)


if __name__ == "__main__":
    unittest.main()
