"""Runs in Blender without a window: computes the small scene. Writes what came of it to FOLDER/seen.json."""
import json
import math
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))
from small_scene import FOLDER, hash_of_sound, make_scene  # the first one: it knows where the add-on is

from idiophone import Result, program
from idiophone_blender import motion, scene_deck, speaker


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


def finite_elements(scene, flyer):
    """A bar of finite elements alone lands on the floor from 1 mm above it."""
    flyer.animation_data_clear()
    flyer.location, flyer.rotation_quaternion = (0.5, 0.5, 0.005), (1, 0, 0, 0)
    settings = flyer.idiophone
    settings.is_body, settings.finite_elements, settings.material = True, True, "rubber"
    scene.frame_end = 1
    deck = json.loads(program.as_text(scene_deck.deck_of(scene, FOLDER)))
    bpy.ops.idiophone.compute()
    scene.frame_set(2)
    return {"body": deck["bodies"]["flyer"], "height": flyer.matrix_world.to_translation().z,
            "pressure": float(abs(Result(FOLDER / "Scene.h5").sound().values).max())}


def main():
    bpy.ops.wm.read_factory_settings(use_empty=True)
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
    seen["sound"] = hash_of_sound()
    seen["kabsch_error"], seen["kabsch_determinant"] = kabsch()
    seen["too_stiff"] = refusal(lambda: setattr(scene.idiophone, "up_to", 100))
    seen["without_camera"] = refusal(lambda: setattr(scene, "camera", None))
    seen["without_bodies"] = refusal(lambda: [setattr(item.idiophone, "is_body", False) for item in (flyer, lander)] and
                                     setattr(scene, "camera", bpy.data.objects["Camera"]))
    seen["finite_elements"] = finite_elements(scene, flyer)
    seen["unsaved"] = refusal(lambda: setattr(scene.idiophone, "folder", "//idiophone"))
    (FOLDER / "seen.json").write_text(json.dumps(seen))


main()
