"""Recordings of surface motion (docs/use/surface_motion.md), written from positions at any times."""

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
    air = air or IMPEDANCE
    times = np.asarray(times, float)
    path_of_vertices = CubicSpline(times, np.asarray(positions, float))
    velocity_of_vertices = path_of_vertices.derivative()
    samples = int(np.floor((times[-1] - times[0]) * rate * (1 + 1e-12))) + 1
    with h5py.File(path, "w") as file:
        file.attrs.update({"format": "idiophone surface motion", "format_version": 1, "name": name, "rate": rate,
                           "air_density": air["density"], "air_speed": air["speed"]})
        file["triangles"] = np.asarray(triangles, np.int32)
        pressure = file.create_dataset("pressure", (samples, len(triangles)), float)
        position = file.create_dataset("position", (samples, len(positions[0]), 3), float)
        for begin in range(0, samples, ROWS_AT_ONCE):
            rows = slice(begin, min(begin + ROWS_AT_ONCE, samples))
            at = times[0] + np.arange(rows.start, rows.stop) / rate
            position[rows] = path_of_vertices(at)
            corners = position[rows][:, triangles]
            velocity = velocity_of_vertices(at)[:, triangles].mean(axis=2)
            pressure[rows] = air["density"] * air["speed"] * np.einsum("rti,rti->rt", velocity, normals(corners))
