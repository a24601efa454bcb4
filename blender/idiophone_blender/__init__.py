"""Idiophone in Blender: computes the motion and the sound of a scene's objects (docs/use/blender.md)."""
import sys
from pathlib import Path

bl_info = {
    "name": "Idiophone",
    "description": "Computes how objects fall, strike and sound",
    "version": (0, 3, 0),
    "blender": (3, 4, 0),
    "location": "Properties > Object > Idiophone, Properties > Scene > Idiophone",
    "category": "Animation",
}

try:
    import idiophone  # noqa: F401
except ImportError:  # the add-on lies in the source tree
    sys.path.append(str(Path(__file__).resolve().parents[2] / "python"))

from . import operators, panels, properties  # noqa: E402

PARTS = (properties, operators, panels)


def register() -> None:
    for part in PARTS:
        part.register()


def unregister() -> None:
    for part in reversed(PARTS):
        part.unregister()
