"""blender --background --python three_objects.py -- OUTPUT.mp4 [FRAMES]: a bar, a disc and a tile fall on a table, and a movie of it.

Without OUTPUT.mp4 nothing is rendered. FRAMES (default 24 at 24 per second) is the length.
"""
import math
import sys
from pathlib import Path

import bpy

sys.path.append(str(Path(__file__).resolve().parents[1]))
import idiophone_blender

WORDS = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []


def add_body(name, material, colour, size, location, degrees=(0, 0, 0)):
    """Makes the active object a body."""
    item = bpy.context.object
    item.name, item.location = name, location
    item.rotation_euler = [math.radians(angle) for angle in degrees]
    settings = item.idiophone
    settings.is_body, settings.material, settings.size = True, material, size
    paint(item, colour)
    return item


def paint(item, colour):
    item.data.materials.append(bpy.data.materials.new(item.name))
    shader = item.data.materials[0]
    shader.use_nodes = True
    shader.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = (*colour, 1)


def make_scene(frames):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    idiophone_blender.register()
    scene = bpy.context.scene
    scene.name, scene.frame_end = "three_objects", frames
    bpy.ops.rigidbody.world_add()

    bpy.ops.mesh.primitive_cube_add(size=1, scale=(0.6, 0.4, 0.04), location=(0, 0, -0.02))
    table = bpy.context.object
    table.name = "table"
    bpy.ops.rigidbody.object_add(type="PASSIVE")
    table.rigid_body.collision_shape, table.rigid_body.friction = "BOX", 0.6
    paint(table, (0.25, 0.12, 0.05))

    bpy.ops.mesh.primitive_cube_add(size=1, scale=(0.2, 0.03, 0.008))
    add_body("bar", "aluminium", (0.8, 0.8, 0.85), 0.02, (-0.1, 0, 0.06), (0, 12, 20))
    bpy.ops.mesh.primitive_cylinder_add(radius=0.05, depth=0.006, vertices=24)
    add_body("disc", "brass", (0.9, 0.7, 0.2), 0.025, (0.12, 0.05, 0.09), (25, 0, 0))
    bpy.ops.mesh.primitive_cube_add(size=1, scale=(0.08, 0.06, 0.008))
    tile = add_body("tile", "glass", (0.2, 0.6, 0.4), 0.02, (0.05, -0.1, 0.1), (20, 30, 0))
    tile.keyframe_insert("location", frame=1)  # it is thrown to the left
    tile.location.x -= 0.02
    tile.keyframe_insert("location", frame=2)
    for curve in tile.animation_data.action.fcurves:
        for key in curve.keyframe_points:
            key.interpolation = "LINEAR"

    bpy.ops.object.camera_add(location=(0, -0.75, 0.4), rotation=(math.radians(65), 0, 0))
    scene.camera = bpy.context.object
    bpy.ops.object.light_add(type="SUN", rotation=(0.6, 0.3, 0))
    bpy.context.object.data.energy = 4
    scene.world = bpy.data.worlds.new("world")
    scene.world.color = (0.2, 0.2, 0.22)
    return scene


def render(scene, output):
    """A small movie with sound, by Cycles on the processor, which needs no display."""
    render = scene.render
    render.engine, scene.cycles.samples, scene.cycles.use_denoising = "CYCLES", 8, False
    render.resolution_x, render.resolution_y, render.resolution_percentage = 480, 320, 100
    render.image_settings.file_format = "FFMPEG"
    render.ffmpeg.format, render.ffmpeg.codec, render.ffmpeg.audio_codec = "MPEG4", "H264", "AAC"
    render.filepath, render.use_file_extension = str(Path(output).resolve()), False
    bpy.ops.render.render(animation=True)


def main():
    scene = make_scene(int(WORDS[1]) if len(WORDS) > 1 else 24)
    scene.idiophone.folder = str(Path(WORDS[0]).resolve().parent / "three_objects") if WORDS else "three_objects"
    bpy.ops.idiophone.compute()
    if WORDS:
        render(scene, WORDS[0])


if __name__ == "__main__":
    main()
