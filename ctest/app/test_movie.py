#!/usr/bin/python3
"""Movies: picture and sound in step, deformation magnified without the motion, everything in the picture."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy
import yaml
from scipy.spatial.transform import Rotation

import program

SCRIPTS = program.SOURCE / "scripts"
sys.path.insert(0, str(SCRIPTS))
from library.cinema import camera, film  # noqa: E402
from library.cinema.obstacles import shape  # noqa: E402
from library.cinema.result import Result, outside  # noqa: E402

RATE, JUMP = 44100, 0.5  # Hz; s, when the body jumps and the sound clicks
CUBE = numpy.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], dtype=float) - 0.5
TETRAHEDRA = numpy.array([[0, 1, 3, 5], [0, 3, 2, 6], [0, 5, 6, 4], [3, 5, 7, 6], [0, 3, 6, 5]])
DECK = """
bodies: {cube: {material: steel, fixed: [{group: side, axes: x}]}}
obstacles:
  floor: {shape: half_space, at: [0, 0, -1]}
  block: {shape: box, at: [-2, 0, 0], size: [0.5, 0.5, 2], rotation: {axis: [0, 0, 1], degrees: 20}}
  ball: {shape: sphere, at: [-2, 2, 0], radius: 0.5}
  post: {shape: cylinder, at: [0, 4, 0], direction: [0, 0, 2], radius: 0.2, length: 2}
listeners:
  side: {type: mono, position: [0, -9, 0]}
  ears: {type: stereo, position: [0, -9, 2], look: [0, 9, -2], up: [0, 0, 1]}
"""


def write_result(path, times, displacement, deck=DECK, overrides=()):
    """A result like a run's: a cube of one metre, and a click in both ears at the time of the jump."""
    sound = numpy.zeros((RATE, 2))
    sound[round(JUMP * RATE)] = 1
    with h5py.File(path, "w") as file:
        file.attrs["format"], file.attrs["name"] = "idiophone result", path.stem
        file["deck"] = [deck]
        file["overrides"] = numpy.array(overrides, dtype=h5py.string_dtype())
        file["mesh/cube/nodes"], file["mesh/cube/elements"] = CUBE, TETRAHEDRA.astype(numpy.int32)
        file["frames/time"], file["frames/cube/displacement"] = times, numpy.asarray(displacement, numpy.float32)
        for listener, heard in (("side", sound[:, :1]), ("ears", sound)):
            audio = file.create_dataset(f"audio/{listener}", data=heard)
            audio.attrs["rate"], audio.attrs["unit"], audio.attrs["columns"] = float(RATE), "Pa m", [listener] * heard.shape[1]
    return path


def frame_times(frames_per_second, duration):
    """Times of a run's frames: the first audio sample at or after each frame is due."""
    return numpy.ceil(numpy.arange(round(duration * frames_per_second) + 1) * RATE / frames_per_second) / RATE


def movie(*arguments, **environment):
    return subprocess.run([SCRIPTS / "movie", *map(str, arguments)], capture_output=True, text=True,
                          timeout=program.TIMEOUT, env={**os.environ, **environment})


def decode(path, width, height):
    """Pictures [pictures x height x width] in grey, and samples [samples x 2], as a player gets them."""
    read = lambda *how: subprocess.run(["ffmpeg", "-loglevel", "error", "-i", path, *how, "-"], check=True,
                                       capture_output=True, timeout=program.TIMEOUT).stdout
    grey = numpy.frombuffer(read("-f", "rawvideo", "-pix_fmt", "gray"), numpy.uint8).reshape(-1, height, width)
    return grey.astype(float), numpy.frombuffer(read("-f", "f32le"), numpy.float32).reshape(-1, 2)


class Movie(program.TestCase):
    def jumping(self, frames_per_second=60, **how):
        times = frame_times(frames_per_second, 1)
        shift = numpy.where(times < JUMP, 0, 1.5)
        return write_result(self.output / "jump.h5", times, shift[:, None, None] * [1, 0, 0] + 0 * CUBE, **how)

    def require_refusal(self, job, *words):
        self.assertEqual(job.returncode, 1, job.stderr)
        self.assertTrue(job.stderr.startswith("error: "), job.stderr)
        for word in words:
            self.assertIn(word, job.stderr)

    def test_the_jump_is_seen_when_the_click_is_heard(self):
        self.require_status(movie(self.jumping(), "--size", "320x180", DISPLAY=":none"), 0)
        grey, sound = decode(self.output / "jump.mp4", 320, 180)
        self.assertEqual(len(grey), 61)
        jump = numpy.abs(numpy.diff(grey[:, :150], axis=0)).mean(axis=(1, 2)).argmax() + 1  # without the label
        click = numpy.abs(sound).max(axis=1).argmax() / RATE
        self.assertAlmostEqual(jump / 60, JUMP, delta=0.001)
        self.assertAlmostEqual(click, JUMP, delta=0.001)
        self.assertGreater(numpy.abs(sound).max(), 0.5)

    def test_frames_are_shown_at_their_times(self):
        for frames_per_second, rate in ((60, 60), (24, 24), (1000, 60), (2, 10)):
            times = frame_times(frames_per_second, 10)
            found, frames = film.schedule(times)
            moments = numpy.arange(len(frames)) / found
            self.assertEqual(found, rate)
            self.assertLessEqual(numpy.abs(times[frames] - moments).max(), 0.5 / frames_per_second + 1 / RATE)
            self.assertEqual(frames[-1], len(times) - 1)
        self.assertEqual(list(film.schedule(numpy.zeros(1))[1]), [0])

    def test_magnified_is_the_deformation_alone(self):
        turn = Rotation.from_rotvec([1, 2, -0.5])
        bent = 1e-3 * CUBE * [1, -2, 0.5]
        place = lambda deformation: turn.apply(CUBE + deformation) + [7, 8, 9]
        path = write_result(self.output / "turn.h5", [0.0, 0.1], [place(0) - CUBE, place(bent) - CUBE])
        with h5py.File(path) as file:
            body = Result(file).bodies[0]
            reach = lambda frame, factor: body.magnified(frame, factor)[numpy.argsort(body.numbers)]
            numpy.testing.assert_allclose(reach(0, 1000), place(0), atol=2e-3)  # float32 a thousandfold
            numpy.testing.assert_allclose(reach(1, 100), place(100 * bent), atol=3e-4)
            body.held = True
            numpy.testing.assert_allclose(reach(1, 2), CUBE + 2 * (place(bent) - CUBE), atol=1e-5)

    def test_overrides_count(self):
        path = self.jumping(overrides=["bodies.cube.fixed.0=rim", "bodies.cube.fixed.1.group=top",
                                       "output.wav_full_scale=2"])
        with h5py.File(path) as file:
            result = Result(file)
        self.assertEqual(result.deck.values["bodies"]["cube"]["fixed"], ["rim", {"group": "top"}])
        self.assertEqual(result.deck.section("output"), {"wav_full_scale": "2"})
        self.assertTrue(result.bodies[0].held)

    def test_outside_is_closed_and_turned_outwards(self):
        middles = [(0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3)]
        corners = CUBE[[0, 1, 2, 4]]
        ten = numpy.vstack([corners, [corners[[a, b]].mean(axis=0) for a, b in middles]])
        for nodes, elements, volume in ((CUBE, TETRAHEDRA, 1), (ten, numpy.arange(10)[None], 1 / 6)):
            numbers, triangles = outside(elements)
            a, b, c = nodes[numbers][triangles.T]
            self.assertAlmostEqual((a * numpy.cross(b, c)).sum() / 6, volume)

    def test_obstacles_have_their_size_and_place(self):
        for obstacle, low, high in (
                ("{shape: box, at: [1, 2, 3], size: [2, 1, 4]}", [0, 1.5, 1], [2, 2.5, 5]),
                ("{shape: box, at: [0, 0, 3], size: [2, 2, 4], rotation: {axis: [0, 0, 3], degrees: 45}}",
                 [-2 ** 0.5, -2 ** 0.5, 1], [2 ** 0.5, 2 ** 0.5, 5]),
                ("{shape: box, at: [1, 0, 0], size: [2, 4, 6], rotation: {axis: [0, 0, 1], degrees: -90}}",
                 [-1, -1, -3], [3, 1, 3]),
                ("{shape: sphere, at: [1, 2, 3], radius: 2}", [-1, 0, 1], [3, 4, 5]),
                ("{shape: cylinder, at: [1, 2, 3], direction: [-9, 0, 0], radius: 1, length: 6}",
                 [-2, 1, 2], [4, 3, 4]),
                ("{shape: cylinder, at: [1, 2, 3], radius: 1, length: 6}", [0, 1, 0], [2, 3, 6]),
                ("{shape: surface, mesh: sphere.geo, parameters: {radius: 0.5, size: 0.1}, at: [1, 2, 3]}",
                 [0.5, 1.5, 2.5], [1.5, 2.5, 3.5])):
            with self.subTest(obstacle=obstacle):
                source = shape("it", yaml.load(obstacle, yaml.BaseLoader), program.SOURCE / "meshes")
                source.Update()
                bounds = numpy.reshape(source.GetOutputDataObject(0).GetBounds(), (3, 2)).T
                numpy.testing.assert_allclose(bounds, [low, high], atol=0.02)

    def test_camera_has_everything_in_the_picture(self):
        with h5py.File(self.jumping()) as file:
            deck = Result(file).deck
        for listener, direction in (("ears", None), ("ears", (1, 1, 0)), ("side", None), ("side", (0, 0, -1))):
            view = camera.choose(deck, listener, direction, numpy.array([[-0.5] * 3, [2, 0.5, 0.5]]), 2.0)
            self.assertEqual(listener == "ears" and direction is None, numpy.allclose(view.position, [0, -9, 2]))
            frame = [numpy.cross(view.look, view.up), view.up, view.look]
            corners = CUBE * [2.5, 1, 1] + [0.75, 0, 0]
            right, above, ahead = numpy.array(frame) @ (corners - view.position).T
            filled = max(numpy.abs(above / ahead).max(), numpy.abs(right / ahead).max() / 2)
            self.assertGreater(ahead.min(), 0)
            self.assertLess(filled, numpy.tan(numpy.radians(view.angle / 2)))
            self.assertGreater(filled, 0.8 * numpy.tan(numpy.radians(view.angle / 2)))

    def test_a_run_s_own_result(self):
        self.require_status(program.run("rich", self.output), program.FINISHED)
        result = self.output / "rich.h5"
        self.require_status(movie(result, "--size", "160x120", "--colour", "speed", "--edges"), 0)
        grey, sound = decode(self.output / "rich.mp4", 160, 120)
        self.assertEqual(len(grey), 2)
        self.assertGreater(grey.std(), 5)
        self.assertGreater(numpy.abs(sound).max(), 0.3)
        self.require_status(movie(result, "--still", 0.005, self.output / "one.png", "--listener", "side"), 0)
        self.assertGreater((self.output / "one.png").stat().st_size, 1000)

    def test_mistakes_are_answered(self):
        result, empty = self.jumping(), self.output / "empty.h5"
        write_result(empty, numpy.empty(0), numpy.empty((0, 8, 3)))
        noise = self.output / "noise.wav"
        noise.write_bytes(b"no sound at all")
        self.require_refusal(movie(empty), "no frames", "output.frames_per_second")
        self.require_refusal(movie(self.output / "none.h5"), "there is no file")
        self.require_refusal(movie(result, "--size", "321x180"), "--size")
        self.require_refusal(movie(result, "--listener", "nobody"), "nobody", "side, ears")
        self.require_refusal(movie(result, PATH="/nowhere"), "xvfb-run is missing")
        with tempfile.TemporaryDirectory() as tools:
            os.symlink(shutil.which("xvfb-run"), f"{tools}/xvfb-run")
            self.require_refusal(movie(result, PATH=tools), "ffmpeg is missing: scripts/install_dependencies movie")
            pathlib.Path(tools, "vtkmodules.py").touch()
            self.require_refusal(movie(result, PYTHONPATH=tools), "vtkmodules", "scripts/install_dependencies movie")
        self.require_refusal(movie(result, "--still", 2, "late.png"), "from 0 to 1 s")
        bad_sound = movie(result, "--sound", noise)
        self.assertEqual(bad_sound.returncode, 1)
        self.assertIn("error: ffmpeg could not make", bad_sound.stderr)
        self.assertNotIn("Traceback", bad_sound.stderr)
        with h5py.File(result, "a") as file:
            del file["audio/ears"]
        self.require_refusal(movie(result), "no listener ears")
        rock = DECK.replace("sphere, at: [-2, 2, 0], radius: 0.5", "surface, mesh: rock.stl, at: [0, 0, 0]")
        self.require_refusal(movie(self.jumping(deck=rock)), "ball", "rock.stl", "--deck-folder")
        self.assertEqual(sorted(path.suffix for path in self.output.iterdir()), [".h5", ".h5", ".wav"])


if __name__ == "__main__":
    unittest.main()
