#!/usr/bin/python3
"""Recordings whose triangles change over time are heard."""
import subprocess
import unittest

import h5py
import numpy

import program
from test_listen import audio, sphere


class ChangingTriangles(program.TestCase):
    """A body that pulsates at 500 Hz and changes its triangles while it does, written as another program would."""
    RADIUS, SPEED, FREQUENCY, RATE, ROWS = 0.05, 1e-3, 500.0, 16000, 2100

    def setUp(self):
        super().setUp()
        self.ears = self.output / "ears.yaml"
        self.ears.write_text("name: heard\nlisteners: {ear: {type: mono, position: [0, 0.3, 2]}}\n")

    def write(self, *surfaces, screen=None):
        """A recording of surfaces (points on the unit sphere, triangles), each for an even share of the rows. The size and
        the speed of a triangle do not depend on its number."""
        path = self.output / "body_surface.h5"
        phase = 2 * numpy.pi * self.FREQUENCY * numpy.arange(self.ROWS) / self.RATE
        radius = self.RADIUS + self.SPEED / (2 * numpy.pi * self.FREQUENCY) * numpy.sin(phase)
        pressure = 1.21 * 343 * self.SPEED * numpy.cos(phase)
        shares = numpy.array_split(numpy.arange(self.ROWS), len(surfaces))
        with h5py.File(path, "w") as file:
            file.attrs.update({"format": "idiophone surface motion", "format_version": 1, "rate": self.RATE})
            for number, (rows, (points, triangles)) in enumerate(zip(shares, surfaces)):
                group = file.create_group(f"segments/{number}") if len(surfaces) > 1 else file
                group["triangles"] = triangles
                group["position"] = radius[rows, None, None] * points
                pattern = 1 + points[triangles].mean(axis=1) @ [0.3, -0.2, 0.4]
                group["pressure"] = pressure[rows, None] * pattern
            if screen is not None:
                file["obstacles/triangles"] = numpy.ravel(screen)
        return path

    def listen(self, *settings, status=program.FINISHED, ranks=1):
        words = [word for setting in settings for word in ("--set", setting)]
        job = program.idiophone("listen", self.output / "body_surface.h5", self.ears, *words, "--output-folder", self.output,
                                ranks=ranks)
        self.require_status(job, status)
        return audio(self.output / "heard.h5")["ear"][:, 0] if status == program.FINISHED else job.stderr

    def test_another_order_of_triangles_sounds_the_same(self):
        """A flat body half behind a screen: sizes of the surface, pressures, filters and visibility go on at each change."""
        points, triangles = sphere(2)
        points = points * [1, 1, 0.3]
        shuffled = [numpy.random.default_rng(seed).permutation(triangles) for seed in range(3)]
        screen = [[-3, 0, 0.5], [0, 3, 0.5], [0, -3, 0.5]]
        for model in "kirchhoff", "rayleigh", "huygens":
            with self.subTest(model=model):
                settings = f"radiation.model={model}", "audio.dc_block=0"
                self.write((points, triangles), screen=screen)
                expected = self.listen(*settings)
                self.write(*[(points, each) for each in shuffled], screen=screen)
                found = self.listen(*settings)
                self.assertLess(abs(found - expected).max(), 1e-4 * abs(expected).max())

    def test_a_finer_mesh_makes_no_click(self):
        """A sphere of 320 triangles that becomes one of 1280, and back, is never more than -40 dB (of the peak) outside of
        what the two sound like that keep their triangles."""
        coarse, fine = sphere(2), sphere(3)
        for model in "kirchhoff", "rayleigh", "huygens":
            with self.subTest(model=model):
                sounds = []
                for surfaces in [coarse], [fine], [coarse, fine, coarse]:
                    self.write(*surfaces)
                    sounds.append(self.listen(f"radiation.model={model}")[200:])  # after the begin of the sound
                self.require_between(*sounds)

    def require_between(self, one, other, found, limit=0.01):
        one, other = one[:len(found)], other[:len(found)]
        outside = numpy.maximum(numpy.minimum(one, other) - found, found - numpy.maximum(one, other))
        self.assertLess(outside.max(), limit * abs(one).max())

    def test_any_number_of_ranks_hears_the_same_bits(self):
        self.write(sphere(2), sphere(1), sphere(2))
        alone = self.listen()
        self.assertGreater(abs(alone).max(), 0)
        for ranks in program.OTHER_RANKS:
            self.assertEqual(self.listen(ranks=ranks).tobytes(), alone.tobytes())

    def test_wrong_segments_are_named(self):
        def change(edit):
            path = self.write(sphere(1), sphere(2))
            with h5py.File(path, "r+") as file:
                edit(file)
            return self.listen(status=program.FAILED)

        self.assertIn("there is no /segments/1/pressure", change(lambda file: file.pop("segments/1/pressure")))
        self.assertIn("there is no /segments/0/triangles", change(lambda file: file.move("segments/0", "segments/2")))
        self.assertIn("/triangles beside /segments", change(lambda file: file.create_dataset("triangles", data=[[0, 1, 2]])))

        def shorten(file):
            rows = file.pop("segments/1/pressure")[:-1]
            file["segments/1/pressure"] = rows
        self.assertIn("/segments/1/pressure has the shape [1049 x 320], expected [1050 x 320]", change(shorten))

        def lose_vertices(file):
            positions = file.pop("segments/0/position")[:, :20]
            file["segments/0/position"] = positions
        self.assertIn("of segment 0 has vertex", change(lose_vertices))

        def flatten(file):
            file["segments/1/triangles"][7] = [0, 0, 1]
        self.assertIn("triangle 7 of a segment", change(flatten))

        self.write(sphere(1), sphere(2))
        self.assertIn("cannot be attached", self.listen("listeners.ear.attached=body_surface", status=program.FAILED))
        self.assertIn("model waves", self.listen("radiation={model: waves, cell: 0.02}", status=program.FAILED))

    def test_a_sequence_of_files_changes_its_triangles(self):
        import meshio
        folder = self.output / "body"
        folder.mkdir()
        times = numpy.arange(160) / 8000.0
        radius = self.RADIUS + self.SPEED / (2 * numpy.pi * self.FREQUENCY) * numpy.sin(2 * numpy.pi * self.FREQUENCY * times)
        sounds = []
        for change in 160, 0, 80:
            for frame, size in enumerate(radius):
                points, triangles = sphere(2 if frame < change else 3)
                meshio.write_points_cells(folder / f"{frame:04}.ply", size * points, [("triangle", triangles)])
            job = subprocess.run([program.SOURCE / "scripts/mesh_sequence", folder, "--frames-per-second", "8000", "--rate",
                                  str(self.RATE)], capture_output=True, text=True, timeout=program.TIMEOUT)
            self.require_status(job, 0)
            self.assertEqual("change 1 times" in job.stdout, change == 80)
            sounds.append(self.listen("listeners.ear.position=[0, 0, 2]")[130:])
        self.require_between(*sounds, limit=0.05)  # of two splines that end between two files


if __name__ == "__main__":
    unittest.main()
