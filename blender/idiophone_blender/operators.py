"""Scene to deck, run, and result to scene."""
from __future__ import annotations

import threading
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path

import bpy

import idiophone

from . import motion, scene_deck, speaker

MISTAKES = (ValueError, OSError, idiophone.IdiophoneError)
HARMLESS = {"TIMER", "TIMER_AUTOSAVE", "MOUSEMOVE", "INBETWEEN_MOUSEMOVE", "MIDDLEMOUSE", "WHEELUPMOUSE", "WHEELDOWNMOUSE",
            "TRACKPADPAN", "TRACKPADZOOM"}  # events that change no scene


class Compute(bpy.types.Operator):
    """Computes how the objects of the scene move and sound"""

    bl_idname = "idiophone.compute"
    bl_label = "Compute motion and sound"
    bl_options = {"REGISTER", "UNDO"}  # noqa: RUF012 - Blender takes no other set

    def execute(self, context: bpy.types.Context) -> set[str]:
        """Waits for the result: of a script, and without a window."""
        try:
            deck, folder = self._deck(context.scene)
            return self._use(context.scene, deck.run(folder, context.scene.idiophone.ranks))
        except MISTAKES as error:
            return self._refuse(error)

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        """Computes in a thread. Until it has ended, modal() gets all events: the scene can be looked at but not changed."""
        try:
            deck, folder = self._deck(context.scene)
        except MISTAKES as error:
            return self._refuse(error)
        self._done, self._stop = 0.0, threading.Event()
        self._run: Future[idiophone.Result] = ThreadPoolExecutor(1).submit(
            deck.run, folder, context.scene.idiophone.ranks, progress=self._note, stop=self._stop)
        self._timer = context.window_manager.event_timer_add(0.2, window=context.window)
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        if self._run.done():
            return self._end(context)
        if event.type == "ESC":
            self._stop.set()
        words = "stopping" if self._stop.is_set() else f"{100 * self._done:.0f} % computed; Esc cancels"
        context.workspace.status_text_set(f"Idiophone: {words}")
        return {"PASS_THROUGH" if event.type in HARMLESS else "RUNNING_MODAL"}

    def cancel(self, context: bpy.types.Context) -> None:
        """Blender itself ends the operator, for example because it quits."""
        self._stop.set()

    def _note(self, done: float) -> None:
        self._done = done

    def _deck(self, scene: bpy.types.Scene) -> tuple[idiophone.Deck, Path]:
        """The deck and its folder. Raises MISTAKES."""
        setting = scene.idiophone.folder
        if setting.startswith("//") and not bpy.data.filepath:
            raise ValueError("The folder is beside the .blend file, which is not saved yet: save it, or choose another folder")
        folder = Path(bpy.path.abspath(setting))
        folder.mkdir(parents=True, exist_ok=True)
        return idiophone.Deck(scene_deck.deck_of(scene, folder), folder), folder

    def _end(self, context: bpy.types.Context) -> set[str]:
        context.window_manager.event_timer_remove(self._timer)
        context.workspace.status_text_set(None)
        try:
            return self._use(context.scene, self._run.result())
        except idiophone.Stopped:
            self.report({"WARNING"}, "Cancelled: the scene is as it was")
            return {"CANCELLED"}
        except MISTAKES as error:
            return self._refuse(error)

    def _use(self, scene: bpy.types.Scene, result: idiophone.Result) -> set[str]:
        """Brings a result back into the scene."""
        bodies = scene_deck.bodies_of(scene)
        for name, item in bodies.items():
            motion.add_keyframes(scene, item, name, result)
        speaker.add_speaker(scene, result.path.with_suffix(".wav"), list(bodies.values()))
        self.report({"INFO"}, f"{len(bodies)} objects move and sound as in {result.path}")
        return {"FINISHED"}

    def _refuse(self, error: Exception) -> set[str]:
        self.report({"ERROR"}, str(error))
        return {"CANCELLED"}


def register() -> None:
    bpy.utils.register_class(Compute)


def unregister() -> None:
    bpy.utils.unregister_class(Compute)
