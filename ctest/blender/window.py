"""Runs in Blender with a window: computes the small scene as a user does, and cancels a second computation. Writes what came of it
to FOLDER/seen.json."""
import json
import os
import sys
import traceback
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parent))
from small_scene import FOLDER, hash_of_sound, make_scene

from idiophone_blender import operators

ended = []  # what the operator returned


def watch(end):
    def watched(operator, context):
        ended.append(list(end(operator, context))[0])
        return {ended[-1]}
    return watched


def in_window():
    """A timer has no window of its own. Reading a file makes a new one."""
    return bpy.context.temp_override(window=bpy.context.window_manager.windows[0])


def invoke():
    """As the button of the panel."""
    ended.clear()
    with in_window():
        return list(bpy.ops.idiophone.compute("INVOKE_DEFAULT"))[0]


def press_escape():
    bpy.context.window_manager.windows[0].event_simulate("ESC", "PRESS", x=100, y=100)


def until_the_end(seconds=300):
    for _ in range(10 * seconds):
        if ended:
            return
        yield 0.1
    raise TimeoutError("the operator goes on")


def steps(seen):
    """Yields the seconds until the next step, between which Blender goes on."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    with in_window():
        scene, flyer, _ = make_scene()
    operators.Compute._end = watch(operators.Compute._end)
    seen["invoked"] = invoke()
    seen["steps_meanwhile"] = 0
    for pause in until_the_end():
        seen["steps_meanwhile"] += 1
        yield pause
    seen["ended"] = ended[0]
    seen["sound"] = hash_of_sound()
    scene.frame_set(3)
    seen["place"] = list(flyer.matrix_world.to_translation())
    scene.frame_end = 480
    invoke()
    yield 2
    press_escape()
    yield from until_the_end()
    seen["cancelled"] = ended[0]
    scene.frame_set(3)
    seen["place_after_cancelling"] = list(flyer.matrix_world.to_translation())


def main():
    seen, failures = {}, []
    course = steps(seen)

    def step():
        try:
            return next(course)
        except StopIteration:
            pass
        except Exception:
            failures.append(traceback.format_exc())
        (FOLDER / "seen.json").write_text(json.dumps({**seen, "failures": failures}))
        os._exit(0)  # Blender can't end from a timer

    bpy.app.timers.register(step, first_interval=0.5, persistent=True)  # reading a file ends all others


main()
