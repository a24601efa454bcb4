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
CORNERS = numpy.array([[x, y, z] for x in (0, 0.2) for y in (-0.3, 0.3) for z in (-0.6, 0)])
SIDES = (0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)
TRIANGLES = numpy.array([[side[a] for a in corners] for side in SIDES for corners in ((0, 1, 2), (0, 2, 3))], numpy.int32)


def pulse(rows, start):
    return numpy.exp(-((((numpy.arange(rows) - start) / test_screens.RATE) / 6e-5)**2))


class Diffraction(test_screens.Heard):
    def levels(self, radiation, obstacle):
        """At each place, dB."""
        self.record(SOURCE, pulse(1300, 90), obstacle)
        heard = self.hear(self.microphones(PLACES), radiation)
        phases = numpy.exp(-2j * numpy.pi / test_screens.RATE * numpy.outer(FREQUENCIES, numpy.arange(1150)))
        return numpy.array([10 * numpy.log10(numpy.mean(abs(phases @ sound[:1150])**2)) for sound in heard.values()])

    def test_behind_a_box_levels_are_those_of_waves(self):
        waves = "{model: waves, cell: 0.02}"
        box = CORNERS[TRIANGLES]
        expected = self.levels(waves, box) - self.levels(waves, None)
        found = self.levels(DIFFRACTION, box) - self.levels("{}", None)
        self.assertLess(expected.max(), -4)  # it is a shadow
        self.assertLess(abs(found - expected).max(), 2.5, found - expected)

    def test_edges_move_with_a_body(self):
        """A box that arrives before the pulse begins is heard as one that always stood there."""
        rows, start = 2600, 1700
        self.record(SOURCE, pulse(rows, start), CORNERS[TRIANGLES])
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
