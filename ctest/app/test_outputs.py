#!/usr/bin/python3
"""What a finished run leaves: sound, frames, and lines that tell how it went."""
import importlib.machinery
import importlib.util
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import unittest.mock
import wave
import xml.etree.ElementTree

import h5py
import numpy

import program

# RIFF's format tags: 1 integers, 3 floats, 0xfffe extensible
FORMATS = {"float32": (3, 32), "pcm16": (1, 16), "pcm24": (1, 24)}


def wav_header(path):
    """Format tag, channels, rate, bits and frames, from the chunks of a RIFF file."""
    data = path.read_bytes()
    assert data[:4] == b"RIFF" and data[8:12] == b"WAVE"
    chunks, place = {}, 12
    while place + 8 <= len(data):
        size = int.from_bytes(data[place + 4:place + 8], "little")
        chunks[data[place:place + 4]] = data[place + 8:place + 8 + size]
        place += 8 + size + size % 2
    number = lambda at, width: int.from_bytes(chunks[b"fmt "][at:at + width], "little")
    tag = number(24, 2) if number(0, 2) == 0xFFFE else number(0, 2)
    return tag, number(2, 2), number(4, 4), number(14, 2), len(chunks[b"data"]) // number(12, 2)


class Outputs(program.TestCase):
    def test_wav_files(self):
        for name, (tag, bits) in FORMATS.items():
            with self.subTest(format=name):
                self.require_status(program.run("simple", self.output, "--set", f"output.wav={name}"), program.FINISHED)
                self.assertEqual(wav_header(self.output / "simple.wav"), (tag, 1, 8000, bits, 100))

    def test_each_listener_has_its_wav_and_its_samples(self):
        self.require_status(program.run("rich", self.output, ranks=2), program.FINISHED)
        with h5py.File(self.output / "rich.h5") as file:
            for name, channels in (("ears", 2), ("side", 1), ("far", 1), ("head", 2), ("pair", 2)):
                self.assertEqual(wav_header(self.output / f"rich_{name}.wav"), (3, channels, 8000, 32, 80))
                self.assertEqual(file[f"audio/{name}"].shape, (80, channels))

    def test_frames_open(self):
        self.require_status(program.run("rich", self.output, ranks=2), program.FINISHED)
        check = subprocess.run([program.SOURCE / "tools" / "check_xdmf", self.output / "rich.xdmf"],
                               capture_output=True, text=True, timeout=program.TIMEOUT)
        self.require_status(check, 0)
        for body, cells in (("bar", "tetra10"), ("ball", "tetra")):
            self.assertEqual(len(re.findall(rf"(?m)^\S+ {body} {cells} ", check.stdout)), 11)  # 0 to 10 ms

    def test_motion_channels_of_each_body(self):
        self.require_status(program.run("rich", self.output), program.FINISHED)
        with h5py.File(self.output / "rich.h5") as file:
            for body in "bar", "ball":
                found = {name: (series.attrs["unit"].decode(), b" ".join(series.attrs["columns"]).decode(), series.shape)
                         for name, series in file[f"motion/{body}"].items()}
                rows = len(file["energy"])
                self.assertEqual(found, {
                    "centre_of_mass": ("m", "x y z", (rows, 3)),
                    "velocity": ("m/s", "x y z", (rows, 3)),
                    "orientation": ("1", "w x y z", (rows, 4)),
                    "angular_velocity": ("rad/s", "x y z", (rows, 3)),
                    "angular_momentum": ("kg m2/s", "x y z", (rows, 3)),
                    "energy": ("J", "kinetic elastic", (rows, 2))})
            numpy.testing.assert_allclose(file["motion/ball/orientation"][0], [1, 0, 0, 0], atol=1e-14)
            numpy.testing.assert_allclose(file["motion/ball/angular_velocity"][0], [0, 40, 10], atol=1e-10)

    def test_orientation_keeps_its_sign_when_a_run_is_interrupted(self):
        spin = "--set", "bodies.ball.spin=[0, 100, 200]"
        self.require_status(program.run("free", self.output / "whole", *spin), program.FINISHED)
        with h5py.File(self.output / "whole" / "free.h5") as file:
            whole = file["motion/ball/orientation"][()]
        self.assertLess(whole[:, 0].min(), -0.9)  # more than half a turn: the sign that w alone would not tell
        self.assertGreater((whole[1:] * whole[:-1]).sum(axis=1).min(), 0.9)
        self.run_in_jobs("free", self.output, *spin, ranks=len(whole) * (1,))
        with h5py.File(self.output / "free.h5") as file:
            numpy.testing.assert_array_equal(file["motion/ball/orientation"][()], whole)

    def test_info_names_every_dataset_and_analyze_the_partials(self):
        self.require_status(program.run("simple", self.output), program.FINISHED)
        told = program.idiophone("info", self.output / "simple.h5")
        self.require_status(told, program.FINISHED)
        for path in program.contents(self.output / "simple.h5"):
            if not path.startswith("checksums/"):
                self.assertIn(f"/{path} ", told.stdout)
        found = program.idiophone("analyze", self.output / "simple.h5", "--start", "0.002")
        self.require_status(found, program.FINISHED)
        self.assertIn("frequency/Hz", found.stdout)
        self.assertRegex(found.stdout, r"(?m)^ +\d+\.\d\d +-?\d+\.\d\d ")
        self.assertNotIn("forces act", found.stderr + found.stdout)
        during = program.idiophone("analyze", self.output / "simple.h5", "--start", "0.0015")  # the blow ends at 0.001 s
        heard = re.search(r"forces act in this part \(loads, heard until ([\d.]+) s\)", during.stderr + during.stdout)
        self.assertAlmostEqual(float(heard[1]), 0.001 + 0.3 / 343, delta=1e-5)  # the listener is 0.3 m above the plate's middle

    def test_lines_of_a_run(self):
        checkpoints = "--set", "output.checkpoint.every_minutes=1e-9"
        job = program.run("simple", self.output, "--progress", "line", *checkpoints, ranks=2)
        self.require_status(job, program.FINISHED)
        progress = re.findall(r"([\d.]+) %  [\d.]+ s  \d+ steps/s  \d+:\d\d:\d\d left  loudest \S+  checkpoints (\d+)",
                              job.stdout)
        self.assertGreater(len(progress), 1)
        self.assertEqual(float(progress[-1][0]), 100)
        self.assertEqual(int(progress[0][1]), 1)
        self.assertRegex(job.stdout, r"of computing, \S+ million elements a second and core")
        shares = "  ".join(rf"{stage} \S+ %" for stage in ("motion", "surface", "radiation", "store"))
        self.assertRegex(job.stdout, f"share of time on rank 0:  {shares}")

    @unittest.skipIf(len(os.sched_getaffinity(0)) < 2, "needs two processors")
    def test_ranks_bound_to_one_processor_are_said(self):
        one = min(os.sched_getaffinity(0))
        for bound, said in ((["taskset", "-c", str(one)], True), ([], False)):
            job = subprocess.run([*program.MPIRUN, "-n", "2", *bound, program.PROGRAM, "run", program.deck("simple"),
                                  "--output-folder", self.output], capture_output=True, text=True,
                                 timeout=program.TIMEOUT)
            self.require_status(job, program.FINISHED)
            self.assertEqual("2 ranks of one machine may only use 1 of its" in job.stdout + job.stderr, said, job.stderr)


class OddFolders(program.TestCase):
    """Folders whose names mean something in HTML, XML and YAML, or are not UTF-8."""
    def call(self, *arguments):
        job = program.idiophone(*arguments)
        self.require_status(job, program.FINISHED)
        return job.stdout

    def test_names_do_not_steer_the_terminal(self):
        name = "a\x1b[31m\x9b7m\u202e"
        for arguments in (("info", self.output / f"{name}.h5"), ("run", program.deck("simple"), "--output-folder", self.output / name)):
            job = program.idiophone(*arguments)
            self.require_status(job, program.FAILED if arguments[0] == "info" else program.FINISHED)
            said = job.stdout + job.stderr
            self.assertIn("a\\x1b[31m\\x9b7m\\u202e", said)
            self.assertFalse(set("\x1b\x9b\u202e") & set(said))

    def test_gmsh_cannot_quote_every_name(self):
        folder = self.output / """a "b" 'c'"""
        folder.mkdir()
        (folder / "plate.geo").write_text("")
        job = program.run("simple", self.output, "--set", f"bodies.plate.mesh={folder}/plate.geo")
        self.require_status(job, program.WRONG_DECK)
        self.assertIn("both kinds of quotation marks", job.stderr)

    def test_every_command_works_in_them(self):
        for name in (b'a "b" <&> #c: *d', b"caf\xe9 'e'"):
            with self.subTest(name=name):
                folder = self.output / os.fsdecode(name)
                folder.mkdir()
                shutil.copy(program.SOURCE / "meshes/square_plate.geo", folder)
                deck, result = folder / "simple.yaml", folder / "simple.h5"
                deck.write_text(program.deck("simple").read_text().replace("../../../meshes/square_plate.geo", "square_plate.geo"))
                json.loads(self.call("check", deck, "--json"))
                job = program.idiophone("run", deck, "--output-folder", folder, ranks=2)
                self.require_status(job, program.FINISHED)
                self.assertGreater(json.loads(self.call("info", "--json", result))["run"]["elements"], 0)
                self.call("info", result)
                self.call("info", "--verify", result)
                self.call("report", result, "-o", folder / "simple.html")
                json.loads(self.call("modes", deck, "--modes", 2, "--json", "--output-folder", folder))
                json.loads(self.call("map", deck, "--modes", 2, "--radiation", "kirchhoff", "--json", "--output-folder", folder))
                xml.etree.ElementTree.parse(folder / "simple.xdmf")
                if name.isascii():
                    again = self.output / "again.yaml"
                    again.write_text(self.call("check", deck, "--resolved"))
                    self.call("check", again)


class Pictures(unittest.TestCase):
    def test_peaks_are_compared_with_the_first_references(self):
        """Not with those of a worse theory that happen to be nearer."""
        path = str(program.SOURCE / "scripts/spectrum")
        sys.path.insert(0, str(program.SOURCE / "scripts"))
        self.addCleanup(sys.path.pop, 0)
        loader = importlib.machinery.SourceFileLoader("spectrum", path)
        spectrum = importlib.util.module_from_spec(importlib.util.spec_from_loader("spectrum", loader))
        loader.exec_module(spectrum)
        axes = unittest.mock.Mock()
        references = {"3-D elasticity": numpy.array([174.37, 354.39]), "thin plate": numpy.array([174.96, 356.83])}
        spectrum.name_peaks(axes, (numpy.array([174.9, 355.6, 500.0]), numpy.zeros(3)), references, 700, 20)
        self.assertEqual([call.args[0] for call in axes.annotate.call_args_list],
                         ["174.9  (+5 ct)", "355.6  (+6 ct)", "500.0"])

    def test_blows_are_drawn_side_by_side(self):
        """Three tones, one after another: each blow has its centroid."""
        with tempfile.TemporaryDirectory() as folder:
            sound, picture = f"{folder}/tones.wav", f"{folder}/tones.png"
            times = numpy.arange(8000) / 8000
            tones = numpy.concatenate([numpy.sin(2 * numpy.pi * pitch * times) for pitch in (400, 800, 1600)])
            with wave.open(sound, "wb") as file:
                file.setparams((1, 2, 8000, 0, "NONE", ""))
                file.writeframes((2e4 * tones).astype("<i2").tobytes())
            blows = ["--at", "0.1", "--at", "1.1", "--at", "2.1"]
            done = subprocess.run([program.SOURCE / "scripts/blows_figure", sound, *blows, "--split", "1000", "-o", picture],
                                  capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stderr)
            found = re.findall(r"blow at ([\d.]+) s, 100 ms: centroid (\d+) Hz", done.stdout)
            self.assertEqual([at for at, _ in found], ["0.1", "1.1", "2.1"])
            for (_, centroid), pitch in zip(found, (400, 800, 1600)):
                self.assertAlmostEqual(float(centroid), pitch, delta=10)
            self.assertTrue(os.path.getsize(picture) > 10_000)


if __name__ == "__main__":
    unittest.main()
