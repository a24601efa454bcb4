#!/usr/bin/python3
"""Sound bends around the edges of a box: against waves on a grid."""
import unittest

import h5py
import numpy

import program
import test_screens
from test_listen import sphere

SOURCE = numpy.array([-0.4, 0.0, -0.1])
PLACES = [0.5, 0.1, -0.3], [0.6, 0.05, -0.25], [0.25, 0.05, -0.05], [0.5, 0, -0.1]  # behind the box
FREQUENCIES = numpy.linspace(700, 2000, 27)  # Hz
DIFFRACTION = "{diffraction: true}"


def prism(profile, width=0.6):
    """Corners and triangles of a convex prism along y.

    :param profile: corners of its section (x, z), around it from x to z, m
    """
    count = len(profile)
    corners = numpy.array([[x, y, z] for y in (-width / 2, width / 2) for x, z in profile])
    triangles = [[end + corner for corner in (0, i, i + 1)[::order]]
                 for end, order in ((0, 1), (count, -1)) for i in range(1, count - 1)]
    for i in range(count):
        k = (i + 1) % count
        triangles += [[i, i + count, k], [k, i + count, k + count]]
    return corners, numpy.array(triangles, numpy.int32)


def wall(near, far):
    """A wall from x = near to far, m."""
    return [(near, -0.6), (far, -0.6), (far, 0), (near, 0)]


def solid(*profiles):
    """Triangles of prisms by their corners."""
    return numpy.concatenate([corners[triangles] for corners, triangles in map(prism, profiles)])


CORNERS, TRIANGLES = prism(wall(0, 0.2))
BOX = solid(wall(0, 0.2))


def pulse(rows, start):
    return numpy.exp(-((((numpy.arange(rows) - start) / test_screens.RATE) / 6e-5)**2))


class Diffraction(test_screens.Heard):
    def levels(self, radiation, obstacle, places, source):
        """At each place, dB."""
        self.record(source, pulse(1300, 90), obstacle)
        heard = self.hear(self.microphones(places), radiation)
        phases = numpy.exp(-2j * numpy.pi / test_screens.RATE * numpy.outer(FREQUENCIES, numpy.arange(1150)))
        return numpy.array([10 * numpy.log10(numpy.mean(abs(phases @ sound[:1150])**2)) for sound in heard.values()])

    def check_levels(self, obstacle, places, tolerance, source=SOURCE):
        """Behind an obstacle against those of waves, over those without it."""
        waves = "{model: waves, cell: 0.02}"
        expected = self.levels(waves, obstacle, places, source) - self.levels(waves, None, places, source)
        found = self.levels(DIFFRACTION, obstacle, places, source) - self.levels("{}", None, places, source)
        self.assertLess(expected.max(), -4)  # it is a shadow
        self.assertLess(abs(found - expected).max(), tolerance, found - expected)

    def test_behind_a_box_levels_are_those_of_waves(self):
        self.check_levels(BOX, PLACES, 2.5)

    def test_behind_two_walls_levels_are_those_of_waves(self):
        places = [0.7, 0.1, -0.3], [0.8, 0.05, -0.2], [0.6, 0.05, -0.1]
        self.check_levels(solid(wall(0, 0.1), wall(0.4, 0.5)), places, 2.5)

    @program.long_verification
    def test_behind_three_edges_levels_are_those_of_waves(self):
        house = [(0, -0.6), (0.4, -0.6), (0.4, 0), (0.2, 0.12), (0, 0)]
        places = [0.7, 0.1, -0.45], [0.8, 0.05, -0.5], [0.55, 0.05, -0.3], [0.7, 0, -0.4]
        self.check_levels(solid(house), places, 2.5, source=numpy.array([-0.3, 0.0, -0.45]))

    def test_edges_move_with_a_body(self):
        """A box that arrives before the pulse begins is heard as one that always stood there."""
        rows, start = 2600, 1700
        self.record(SOURCE, pulse(rows, start), BOX)
        still = self.hear(self.microphones(PLACES), DIFFRACTION)
        points, triangles = sphere(1)
        with h5py.File(self.output / "source_surface.h5", "r+") as file:
            del file["triangles"], file["obstacles"]
            file["triangles"] = numpy.concatenate([triangles, len(points) + TRIANGLES])
            file["bodies/name"] = numpy.array(["ball", "box"], h5py.string_dtype())
            file["bodies/triangle"] = numpy.array([0, len(triangles)], numpy.int32)
            file["bodies/vertex"] = numpy.array([0, len(points)], numpy.int32)
            arriving = numpy.where(numpy.arange(rows) < 100, 5.0, 0.0)[:, None, None] + CORNERS
            for name, more in (("position", arriving), ("pressure", numpy.zeros((rows, len(TRIANGLES))))):
                values = numpy.concatenate([file[name], more], axis=1)
                del file[name]
                file[name] = values
        moved = self.hear(self.microphones(PLACES), DIFFRACTION)
        for name, sound in still.items():
            self.assertGreater(abs(sound).max(), 0)
            self.assertLess(abs(moved[name] - sound).max(), 1e-4 * abs(sound).max())
        on_two = self.hear(self.microphones(PLACES), DIFFRACTION, ranks=2)
        for name, sound in moved.items():
            self.assertEqual(on_two[name].tobytes(), sound.tobytes())

    def test_too_many_edges_are_refused(self):
        spikes = [[[x, y, 0], [x + 0.01, y, 0], [x, y + 0.01, 0]] for x in numpy.arange(10) / 10 for y in numpy.arange(10) / 10]
        self.record(SOURCE, numpy.zeros(100), spikes)
        said = self.hear(self.microphones(PLACES), DIFFRACTION, status=program.FAILED)
        self.assertIn("at most 200", said)


if __name__ == "__main__":
    unittest.main()
