"""Scene to deck, run, and result to scene."""
from pathlib import Path

import bpy

import idiophone

from . import motion, scene_deck, speaker


class Compute(bpy.types.Operator):
    """Computes how the objects of the scene move and sound"""

    bl_idname = "idiophone.compute"
    bl_label = "Compute motion and sound"
    bl_options = {"REGISTER", "UNDO"}  # noqa: RUF012 - Blender takes no other set

    def execute(self, context: bpy.types.Context) -> set[str]:
        scene = context.scene
        folder = Path(bpy.path.abspath(scene.idiophone.folder))
        try:
            folder.mkdir(parents=True, exist_ok=True)
            result = self._run(context, scene_deck.deck_of(scene, folder), folder)
        except (ValueError, OSError, idiophone.IdiophoneError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        bodies = scene_deck.bodies_of(scene)
        for name, item in bodies.items():
            motion.add_keyframes(scene, item, name, result)
        speaker.add_speaker(scene, result.path.with_suffix(".wav"), list(bodies.values()))
        self.report({"INFO"}, f"{len(bodies)} objects move and sound as in {result.path}")
        return {"FINISHED"}

    def _run(self, context: bpy.types.Context, values: dict, folder: Path) -> idiophone.Result:
        """With a progress bar at the pointer."""
        window = context.window_manager
        window.progress_begin(0, 1)
        try:
            return idiophone.Deck(values, folder).run(folder, ranks=context.scene.idiophone.ranks, progress=window.progress_update)
        finally:
            window.progress_end()


def register() -> None:
    bpy.utils.register_class(Compute)


def unregister() -> None:
    bpy.utils.unregister_class(Compute)
