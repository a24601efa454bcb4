"""The computed motion as keyframes."""
from __future__ import annotations

import bpy
import numpy as np
from mathutils import Matrix

import idiophone


def rigid_motion(before: np.ndarray, after: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The rotation and the translation that bring points nearest to others (Kabsch 1976)."""
    centre, target = before.mean(axis=0), after.mean(axis=0)
    left, _, right = np.linalg.svd((before - centre).T @ (after - target))
    mirror = np.diag([1, 1, np.sign(np.linalg.det(left @ right))])
    rotation = right.T @ mirror @ left.T
    return rotation, target - rotation @ centre


def add_keyframes(scene: bpy.types.Scene, item: bpy.types.Object, body: str, result: idiophone.Result) -> None:
    """Moves an object as a body of a result moved as a whole. Old keyframes of its place are removed."""
    scene.frame_set(scene.frame_start)
    start, scale = item.matrix_world.copy(), item.matrix_world.to_scale()
    item.animation_data_clear()
    if item.rigid_body:
        item.rigid_body.kinematic = True  # it follows the keyframes
    item.rotation_mode = "QUATERNION"
    nodes, rate = result.nodes(body), scene.render.fps / scene.render.fps_base
    before = None
    for number, time in enumerate(result.frame_times):
        rotation, translation = rigid_motion(nodes, nodes + result.displacement(body, number))
        moved = Matrix.Translation(translation) @ Matrix(rotation).to_4x4() @ start
        location, turned, _ = moved.decompose()
        if before is not None:
            turned.make_compatible(before)
        before = turned
        item.matrix_world = Matrix.LocRotScale(location, turned, scale)
        item.rotation_quaternion.make_compatible(turned)
        for path in ("location", "rotation_quaternion"):
            item.keyframe_insert(path, frame=scene.frame_start + time * rate)
    for curve in item.animation_data.action.fcurves:
        for key in curve.keyframe_points:
            key.interpolation = "LINEAR"
