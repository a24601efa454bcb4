"""The computed sound on the timeline."""
from __future__ import annotations

from pathlib import Path

import bpy
from mathutils import Vector

NAME = "Idiophone"


def add_speaker(scene: bpy.types.Scene, sound: Path, items: list[bpy.types.Object]) -> bpy.types.Object:
    """A speaker amid the objects, which begins with the first frame. It replaces the one of an earlier sound.

    At the distance of the camera it is as loud as computed there; elsewhere the pressure falls with 1/distance.
    """
    if old := bpy.data.objects.get(NAME):
        bpy.data.objects.remove(old)
    scene.frame_set(scene.frame_start)
    middle = sum((item.matrix_world.to_translation() for item in items), Vector()) / len(items)
    bpy.ops.object.speaker_add(location=middle)  # with a strip of sound on the timeline
    speaker = bpy.context.object
    speaker.name = NAME
    speaker.data.sound = bpy.data.sounds.load(str(sound))
    speaker.data.distance_reference = (scene.camera.matrix_world.to_translation() - middle).length
    speaker.data.attenuation = 1
    scene.audio_distance_model = "INVERSE"
    return speaker
