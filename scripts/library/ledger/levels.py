"""Levels that are heard, against a sum over modes: what a force pulse on a point gives each mode, and what the paper's
radiation and filters make of the mode's shape. It shares no code with the program, only the mesh's mode shapes."""

import math

import numpy as np

from .ledger import Row
from .program import deck_with

FACES = [(0, 1, 2, 4, 5, 6), (0, 1, 3, 4, 8, 7), (1, 2, 3, 5, 9, 8), (0, 2, 3, 6, 9, 7)]  # of a tet10: corners, middles
FOURTHS = [(0, 3, 5), (1, 4, 3), (2, 5, 4), (3, 4, 5)]                                   # triangles of such a face
AIR, SPEED = 1.21, 343.0  # kg/m3, m/s


def rows(name, case, sounding, found, program):
    """One row for each partial: its level at the start of the analysis."""
    deck = deck_with(case["deck"], case.get("set", []))
    pulse, listener = (next(iter(deck[section].values())) for section in ("loads", "listeners"))
    modes = program.shapes(name, case["deck"], case.get("set", []), case["count"] + 2)
    surface = Surface(modes.nodes, modes.elements)
    heard = {peak.frequency: peak.level for peak in found}
    lines = []
    for row in (row for row in sounding if row.computed):
        mode = int(np.argmin(abs(modes.frequencies - row.computed)))
        blow = np.dot(surface.at(np.array(pulse["at"]), modes.shapes[mode]), pulse["force"])
        omega = 2 * math.pi * modes.frequencies[mode]
        amplitude = (abs(blow) * half_sine(omega, float(pulse["duration"]))
                     * abs(surface.huygens(modes.shapes[mode], np.array(listener["position"]), omega))
                     * splat(omega / deck["audio"]["rate"]))
        travel = np.linalg.norm(np.array(listener["position"]) - surface.centres.mean(axis=0)) / SPEED
        rest = case["start"] - travel - float(pulse["duration"]) / 2  # s that it has decayed for
        level = 20 * math.log10(amplitude) - 60 * rest / modes.decay_times[mode]
        lines.append(Row(f"level at {row.computed:.0f} Hz", level, heard[row.computed], "dB", case["level"]))
    return lines


def half_sine(omega, duration):
    """|Fourier transform| of sin(pi t/duration) over its half period, s: the velocity of a mode at unit force."""
    x = omega * duration / math.pi
    return 2 * duration / math.pi * abs(math.cos(math.pi * x / 2) / (1 - x * x))


def splat(phase):
    """Gain of the accumulation buffer's Gaussian, standard deviation half a sample; phase: rad a sample."""
    return math.exp(-phase**2 / 8)


class Surface:
    """The outer triangles of a tet10 mesh, four to a face, as the program has them."""

    def __init__(self, nodes, elements):
        self.nodes = nodes
        faces = {}
        for element in elements:
            for face in FACES:
                opposite = element[6 - sum(face[:3])]
                faces.setdefault(tuple(sorted(element[list(face[:3])])), []).append((element[list(face)], opposite))
        outer = [face[0] for face in faces.values() if len(face) == 1]
        self.triangles = np.array([face[list(fourth)] for face, _ in outer for fourth in FOURTHS])
        inner = nodes[[opposite for _, opposite in outer for _ in FOURTHS]]
        a, b, c = (nodes[self.triangles[:, k]] for k in range(3))
        self.centres = (a + b + c) / 3
        normals = np.cross(b - a, c - a) / 2
        normals *= np.sign(np.einsum("ij,ij->i", normals, self.centres - inner))[:, None]
        self.areas = np.linalg.norm(normals, axis=1)
        self.normals = normals / self.areas[:, None]

    def at(self, point, shape):
        """A shape at a point of the surface, linear in the triangle that it lies in."""
        a, b, c = (self.nodes[self.triangles[:, k]] for k in range(3))
        weights = np.stack([np.einsum("ij,ij->i", np.cross(q - point, r - point), self.normals)
                            for q, r in ((b, c), (c, a), (a, b))], axis=1)
        weights /= weights.sum(axis=1, keepdims=True)
        off = abs(np.einsum("ij,ij->i", point - a, self.normals))
        inside = np.flatnonzero((weights.min(axis=1) > -1e-9) & (off < 1e-9))[0]
        return weights[inside] @ shape[self.triangles[inside]]

    def huygens(self, shape, receiver, omega):
        """Eqs. 5, 10 and 11 of O'Brien, Cook and Essl 2001 at one frequency, for unit velocity of the mode, Pa m."""
        towards = receiver - self.centres
        distance = np.linalg.norm(towards, axis=1)
        cosine = np.maximum(0, np.einsum("ij,ij->i", towards, self.normals) / distance)
        flux = np.einsum("ij,ij->i", shape[self.triangles].mean(axis=1), self.normals) * self.areas
        return AIR * SPEED * np.sum(flux * cosine / distance * np.exp(-1j * omega * distance / SPEED))
