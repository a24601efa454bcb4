"""Runs in Blender: one body is thrown and turns, another falls on a floor. Writes what came of it to FOLDER/seen.json."""
import json
import math
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "blender"))
import idiophone_blender
from idiophone import program
from idiophone_blender import motion, scene_deck, speaker

FOLDER = Path(sys.argv[sys.argv.index("--") + 1])


def box(name, sides, location):
    bpy.ops.mesh.primitive_cube_add(size=1, scale=sides, location=location)
    item = bpy.context.object
    item.name = name
    return item


def passive(item, shape):
    bpy.ops.rigidbody.object_add(type="PASSIVE")
    item.rigid_body.collision_shape, item.rigid_body.friction = shape, 0.4


def make_scene():
    bpy.ops.wm.read_factory_settings(use_empty=True)
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


def refusal(change):
    """What the operator says of a changed scene."""
    change()
    try:
        bpy.ops.idiophone.compute()
    except RuntimeError as error:
        return str(error)
    return "nothing"


def kabsch():
    turned = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]]) @ np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0]])
    points = np.random.default_rng(1).normal(size=(9, 3))
    rotation, translation = motion.rigid_motion(points, points @ turned.T + [1, 2, 3])
    return float(abs(rotation - turned).max() + abs(translation - [1, 2, 3]).max()), float(np.linalg.det(rotation))


def main():
    scene, flyer, lander = make_scene()
    seen = {"deck": json.loads(program.as_text(scene_deck.deck_of(scene, FOLDER)))}
    bpy.ops.idiophone.compute()
    seen["places"], seen["angles"] = [], []
    for frame in 1, 2, 3:
        scene.frame_set(frame)
        seen["places"].append(list(flyer.matrix_world.to_translation()))
        seen["angles"].append(2 * math.atan2(flyer.matrix_world.to_quaternion().z, flyer.matrix_world.to_quaternion().w))
    scene.frame_set(1)
    item = bpy.data.objects[speaker.NAME]
    middle = (flyer.matrix_world.to_translation() + lander.matrix_world.to_translation()) / 2
    seen["speaker"] = {"reference": item.data.distance_reference, "begin": item.animation_data.nla_tracks[0].strips[0].frame_start,
                       "distance": (scene.camera.matrix_world.to_translation() - middle).length,
                       "file": Path(item.data.sound.filepath).name}
    speaker.add_speaker(scene, FOLDER / "Scene.wav", [flyer, lander])
    seen["speakers"] = sum(item.type == "SPEAKER" for item in bpy.data.objects)
    seen["kabsch_error"], seen["kabsch_determinant"] = kabsch()
    seen["too_stiff"] = refusal(lambda: setattr(scene.idiophone, "up_to", 100))
    seen["without_camera"] = refusal(lambda: setattr(scene, "camera", None))
    seen["without_bodies"] = refusal(lambda: [setattr(item.idiophone, "is_body", False) for item in (flyer, lander)] and
                                     setattr(scene, "camera", bpy.data.objects["Camera"]))
    (FOLDER / "seen.json").write_text(json.dumps(seen))


main()
