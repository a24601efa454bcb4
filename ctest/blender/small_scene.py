"""A scene for the tests: one body is thrown and turns, another falls on a floor."""
import hashlib
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "blender"))
import idiophone_blender

FOLDER = Path(sys.argv[sys.argv.index("--") + 1])  # of results


def box(name, sides, location):
    bpy.ops.mesh.primitive_cube_add(size=1, scale=sides, location=location)
    item = bpy.context.object
    item.name = name
    return item


def passive(item, shape):
    bpy.ops.rigidbody.object_add(type="PASSIVE")
    item.rigid_body.collision_shape, item.rigid_body.friction = shape, 0.4


def make_scene():
    idiophone_blender.register()
    scene = bpy.context.scene
    scene.frame_end = 3
    scene.idiophone.folder, scene.idiophone.up_to = str(FOLDER), 7000
    bpy.ops.rigidbody.world_add()
    bpy.ops.mesh.primitive_plane_add(size=4)
    bpy.context.object.name = "floor"
    passive(bpy.context.object, "MESH")
    passive(box("wall", (0.1, 2, 2), (-2, 0, 1)), "BOX")
    lander = box("lander", (0.1, 0.08, 0.006), (0, 0, 0.006))
    lander.rotation_euler = (0.02, 0.03, 0)
    lander.idiophone.is_body, lander.idiophone.material, lander.idiophone.size = True, "glass", 0.04
    flyer = box("flyer", (0.2, 0.03, 0.008), (0.5, 0.5, 1))
    settings = flyer.idiophone
    settings.is_body, settings.material, settings.size = True, "own", 0.04
    settings.young, settings.poisson, settings.density = 60, 0.3, 2700
    for frame in 1, 2:
        flyer.location.x, flyer.rotation_euler.z = 0.5 + 1.2 * (frame - 1) / 24, 2.4 * (frame - 1) / 24
        flyer.keyframe_insert("location", frame=frame)
        flyer.keyframe_insert("rotation_euler", frame=frame)
    for curve in flyer.animation_data.action.fcurves:
        for key in curve.keyframe_points:
            key.interpolation = "LINEAR"
    bpy.ops.object.camera_add(location=(0, -1, 1))
    scene.camera = bpy.context.object
    return scene, flyer, lander


def hash_of_sound():
    return hashlib.sha256((FOLDER / "Scene.wav").read_bytes()).hexdigest()
