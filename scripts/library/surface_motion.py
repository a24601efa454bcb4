"""Recordings of surface motion (docs/use/surface_motion.md), written from positions at any times."""

import itertools

import h5py
import numpy as np
from scipy.interpolate import CubicSpline

IMPEDANCE = {"density": 1.21, "speed": 343.0}  # of air at 20 C: kg/m3, m/s
ROWS_AT_ONCE = 256


def normals(corners):
    """Outward unit normals from corners [... x triangles x 3 corners x 3]."""
    across = np.cross(corners[..., 1, :] - corners[..., 0, :], corners[..., 2, :] - corners[..., 0, :])
    return across / np.maximum(np.linalg.norm(across, axis=-1, keepdims=True), 1e-100)


def enclosed_volume(positions, triangles):
    """Volume inside a closed surface, m3; negative where its triangles wind the wrong way."""
    a, b, c = np.moveaxis(positions[triangles], 1, 0)
    return np.einsum("ij,ij->", a, np.cross(b, c)) / 6


def write(path, name, triangles, times, positions, rate=44100, air=None):
    """Writes a recording at the audio rate (Hz) of a surface that goes smoothly (cubic spline) through positions
    [times x vertices x 3] (m) at times (s, ascending). Sample 0 is at the first of them; before it the surface moves as
    it does then. Pressures are z v.n: z the air's impedance, v the mean velocity of a triangle's vertices, n its
    normal."""
    write_segments(path, name, [(triangles, times, positions)], rate, air)


def write_segments(path, name, segments, rate=44100, air=None):
    """The same for a surface whose triangles change: segments of (triangles, times, positions), one after the other, each
    with at least two times. Between the last time of one and the first of the next, each goes on for half of the way."""
    air = air or IMPEDANCE
    segments = [(np.asarray(triangles, np.int32), np.asarray(times, float), np.asarray(positions, float))
                for triangles, times, positions in segments]
    start = segments[0][1][0]
    ends = [(before[1][-1] + after[1][0]) / 2 for before, after in itertools.pairwise(segments)] + [segments[-1][1][-1]]
    with h5py.File(path, "w") as file:
        file.attrs.update({"format": "idiophone surface motion", "format_version": 1, "name": name, "rate": rate,
                           "air_density": air["density"], "air_speed": air["speed"]})
        first, number = 0, 0
        for (triangles, times, positions), end in zip(segments, ends):
            samples = np.arange(first, int(np.floor((end - start) * rate * (1 + 1e-12))) + 1)
            if len(samples) > 0:  # a segment may lie between two samples
                group = file if len(segments) == 1 else file.create_group(f"segments/{number}")
                _write_rows(group, triangles, CubicSpline(times, positions), start + samples / rate,
                            air["density"] * air["speed"])
                first, number = samples[-1] + 1, number + 1


def _write_rows(group, triangles, path_of_vertices, times, impedance):
    """The datasets of a recording, or of one of its segments: a row for each time."""
    velocity_of_vertices = path_of_vertices.derivative()
    group["triangles"] = triangles
    pressure = group.create_dataset("pressure", (len(times), len(triangles)), float)
    position = group.create_dataset("position", (len(times), *path_of_vertices(times[0]).shape), float)
    for begin in range(0, len(times), ROWS_AT_ONCE):
        rows = slice(begin, min(begin + ROWS_AT_ONCE, len(times)))
        at = times[rows]
        position[rows] = path_of_vertices(at)
        corners = position[rows][:, triangles]
        velocity = velocity_of_vertices(at)[:, triangles].mean(axis=2)
        pressure[rows] = impedance * np.einsum("rti,rti->rt", velocity, normals(corners))
