"""Shapes of objects, and their places."""
from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import bpy
import numpy as np
from mathutils import Matrix, Quaternion


@dataclass
class Shape:
    """The triangles of an object with its modifiers and its scale, in its own axes."""

    vertices: np.ndarray   # [vertices x 3], m
    triangles: np.ndarray  # [triangles x 3], vertex numbers

    def write_obj(self, path: Path) -> None:
        lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in self.vertices.tolist()]
        lines += [f"f {a} {b} {c}" for a, b, c in (self.triangles + 1).tolist()]
        path.write_text("\n".join(lines) + "\n")

    @property
    def sides(self) -> np.ndarray:
        """Of the box around it, m."""
        return np.ptp(self.vertices, axis=0)

    @property
    def is_flat(self) -> bool:
        """Whether it lies in the plane of its x and y axes."""
        return bool(self.sides[2] < 1e-6 * self.sides.max())

    @property
    def centre(self) -> np.ndarray:
        """Of mass, of the volume that it encloses, m."""
        a, b, c = np.moveaxis(self.vertices[self.triangles], 1, 0)
        shares = np.einsum("ij,ij->i", a, np.cross(b, c))
        return (shares[:, None] * (a + b + c)).sum(axis=0) / (4 * shares.sum())


def shape_of(item: bpy.types.Object) -> Shape:
    """Raises ValueError if it has no faces."""
    evaluated = item.evaluated_get(bpy.context.evaluated_depsgraph_get())
    mesh = evaluated.to_mesh()
    mesh.calc_loop_triangles()
    vertices, triangles = np.empty(3 * len(mesh.vertices)), np.empty(3 * len(mesh.loop_triangles), np.int32)
    mesh.vertices.foreach_get("co", vertices)
    mesh.loop_triangles.foreach_get("vertices", triangles)
    evaluated.to_mesh_clear()
    if not len(triangles):
        raise ValueError(f"{item.name} has no faces")
    return Shape(vertices.reshape(-1, 3) * np.array(item.matrix_world.to_scale()), triangles.reshape(-1, 3))


def rotation_vector(turned: Quaternion) -> np.ndarray:
    """Axis times angle, rad. Blender's own axis and angle have three digits for small angles, and no axis for none."""
    if turned.w < 0:
        turned = -turned
    part = np.array((turned.x, turned.y, turned.z))
    sine = np.linalg.norm(part)
    return part * (2 * np.arctan2(sine, turned.w) / sine if sine else 2)


def turn(placed: Matrix) -> dict[str, object]:
    """The rotation of a deck."""
    vector = rotation_vector(placed.to_quaternion())
    angle = np.linalg.norm(vector)
    return {"axis": vector / angle if angle else [0, 0, 1], "degrees": float(np.degrees(angle))}


def velocities(item: bpy.types.Object, scene: bpy.types.Scene, centre: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Velocity of a point in its own axes, m/s, and angular velocity, rad/s, with which its animation goes on from the first frame."""
    part = 0.1  # of a frame
    places = []
    for subframe in (0.0, part):
        scene.frame_set(scene.frame_start, subframe=subframe)
        places.append(item.matrix_world.copy())
    scene.frame_set(scene.frame_start)
    if places[0] == places[1]:
        return np.zeros(3), np.zeros(3)
    seconds = part * scene.render.fps_base / scene.render.fps
    first, last = (np.array(place.to_translation()) + np.array(place.to_quaternion().to_matrix()) @ centre for place in places)
    turned = places[1].to_quaternion() @ places[0].to_quaternion().inverted()
    return (last - first) / seconds, rotation_vector(turned) / seconds
