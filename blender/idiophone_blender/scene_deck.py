"""A deck of a scene: bodies, obstacles, contacts and a listener."""
from __future__ import annotations

import itertools
import re
from pathlib import Path
from typing import Any

import bpy
import numpy as np

from .geometry import Shape, shape_of, turn, velocities


def name_of(item: bpy.types.ID) -> str:
    """Its name in a deck."""
    return re.sub(r"[^A-Za-z0-9_-]", "_", item.name).lstrip("-")[:30]


def bodies_of(scene: bpy.types.Scene) -> dict[str, bpy.types.Object]:
    """The objects that sound, by their names in the deck. Raises ValueError if there are none, or two of one name."""
    items = [item for item in scene.objects if item.type == "MESH" and item.idiophone.is_body]
    if not items:
        raise ValueError("No object sounds: switch on the panel Idiophone of an object")
    return _by_name(items)


def obstacles_of(scene: bpy.types.Scene) -> dict[str, bpy.types.Object]:
    """The passive rigid bodies that do not sound, by their names in the deck."""
    return _by_name([item for item in scene.objects if item.type == "MESH" and not item.idiophone.is_body and
                     item.rigid_body and item.rigid_body.type == "PASSIVE"])


def _by_name(items: list[bpy.types.Object]) -> dict[str, bpy.types.Object]:
    found = {name_of(item): item for item in items}
    if len(found) < len(items):
        raise ValueError(f"Names must differ in letters, digits, - and _: {', '.join(item.name for item in items)}")
    return found


def deck_of(scene: bpy.types.Scene, folder: Path) -> dict[str, Any]:
    """The values of the deck; meshes are written to the folder. Raises ValueError."""
    if scene.unit_settings.scale_length != 1:
        raise ValueError("The unit scale of the scene must be 1: Idiophone takes a unit for a metre")
    if scene.camera is None:
        raise ValueError("The scene has no camera, which is where the sound is heard")
    scene.frame_set(scene.frame_start)
    rate = scene.render.fps / scene.render.fps_base
    bodies, obstacles = bodies_of(scene), obstacles_of(scene)
    deck = {"name": name_of(scene),
            "time": {"duration": (scene.frame_end - scene.frame_start + 1) / rate},
            "materials": {name: _material(item) for name, item in bodies.items()},
            "bodies": {name: _body(name, item, scene, folder) for name, item in bodies.items()},
            "obstacles": {name: _obstacle(name, item, folder) for name, item in obstacles.items()},
            "contacts": _contacts(scene, bodies, obstacles),
            "listeners": {"camera": {"type": "mono", "position": list(scene.camera.matrix_world.to_translation())}},
            "output": {"frames_per_second": rate}}
    if scene.use_gravity:
        deck["gravity"] = list(scene.gravity)
    return {key: value for key, value in deck.items() if value != {}}


def _material(item: bpy.types.Object) -> dict[str, Any]:
    settings = item.idiophone
    if settings.material != "own":
        return {"from": settings.material, "damping": {"loss_factor": "table"}}
    return {"young": settings.young * 1e9, "poisson": settings.poisson, "density": settings.density,
            "damping": {"loss_factor": settings.loss_factor}}


def _mesh(name: str, shape: Shape, size: float, folder: Path) -> dict[str, Any]:
    shape.write_obj(folder / f"{name}.obj")
    return {"mesh": f"{name}.obj", "parameters": {"size": size or float(shape.sides.max()) / 5, "scale": 1}}


def _body(name: str, item: bpy.types.Object, scene: bpy.types.Scene, folder: Path) -> dict[str, Any]:
    shape, placed = shape_of(item), item.matrix_world
    body = {**_mesh(name, shape, item.idiophone.size, folder), "material": name, "position": list(placed.to_translation()),
            "rotation": turn(placed)}
    velocity, spin = velocities(item, scene, shape.centre)
    if np.any(velocity) or np.any(spin):
        body |= {"velocity": velocity, "spin": spin}
    if not item.idiophone.finite_elements:
        body["model"] = {"type": "modal", "up_to": scene.idiophone.up_to}
    return body


def _obstacle(name: str, item: bpy.types.Object, folder: Path) -> dict[str, Any]:
    """A plane is a half space, an object whose collision shape is a box is one, and others are what their surface encloses."""
    shape, placed = shape_of(item), item.matrix_world
    if shape.is_flat:
        return {"shape": "half_space", "at": list(placed.to_translation()), "direction": list(placed.to_quaternion().to_matrix().col[2])}
    if item.rigid_body.collision_shape == "BOX":
        middle = (shape.vertices.min(axis=0) + shape.vertices.max(axis=0)) / 2
        at = np.array(placed.to_translation()) + np.array(placed.to_quaternion().to_matrix()) @ middle
        return {"shape": "box", "at": at, "size": shape.sides, "rotation": turn(placed)}
    if placed.to_quaternion().angle > 1e-6:
        raise ValueError(f"{item.name} is turned: apply its rotation, or give it the collision shape Box")
    return {"shape": "surface", "at": list(placed.to_translation()), **_mesh(name, shape, 0, folder)}


def _contacts(scene: bpy.types.Scene, bodies: dict[str, bpy.types.Object], obstacles: dict[str, bpy.types.Object]) -> dict[str, Any]:
    """Every body can touch every other body and every obstacle. Friction is the product of both, as in Blender's rigid bodies."""
    def friction(item: bpy.types.Object) -> float:
        return item.rigid_body.friction if item.rigid_body else 0.5
    pairs = [*itertools.combinations(bodies.items(), 2), *itertools.product(bodies.items(), obstacles.items())]
    return {f"{first}-{second}": {"between": [first, second], "friction": friction(one) * friction(other),
                                  "damping": scene.idiophone.damping}
            for (first, one), (second, other) in pairs}
