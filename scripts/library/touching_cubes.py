"""A deck of rubber cubes in a block on a floor.

Every cube touches its neighbours and, in the lowest layer, the floor. All move towards the middle of the floor, so that
all contacts stay closed. Each layer is shifted a little, so that its mesh is not aligned with the next one.
"""

import itertools
import json
import math
import pathlib

MESH = pathlib.Path(__file__).resolve().parents[2] / "meshes/bar.geo"
SIDE = 0.02  # m
GAP = 1e-6  # m
SHIFT = 0.001  # m, along the faces
SPEED = 0.2  # m/s, of a cube at the rim


def cubes(along):
    """{name: place in the block}"""
    return {f"cube_{x}{y}{z}": (x, y, z) for x, y, z in itertools.product(range(along), repeat=3)}


def body(place, along, size):
    middle = (along - 1) / 2
    away = [place[0] - middle, place[1] - middle, place[2] + 0.5]
    x, y, z = (component * (SIDE + GAP) for component in away)
    x += SHIFT * math.sin(3 * place[2]) - SIDE / 2  # the mesh begins at x = 0
    y += SHIFT * math.cos(3 * place[2])
    return {"mesh": str(MESH), "element": "tet4", "material": "rubber", "position": [x, y, z],
            "parameters": {"length": SIDE, "width": SIDE, "thickness": SIDE, "size": size, "layers": 2},
            "velocity": [-SPEED * component / (along / 2) for component in away]}


def touching(first, second):
    return sum(abs(a - b) for a, b in zip(first, second)) == 1


def deck(along, size=0.01, friction=0.4, duration=0.005):
    """The deck of along x along x along cubes as JSON, which is YAML. Size of the elements: m, duration: s."""
    places = cubes(along)
    pairs = [(a, b) for a, b in itertools.combinations(places, 2) if touching(places[a], places[b])]
    pairs += [(name, "floor") for name, place in places.items() if place[2] == 0]
    return json.dumps({
        "name": "touching_cubes",
        "time": {"duration": duration},
        "materials": {"rubber": {"young": 5e7, "poisson": 0.4, "density": 1100, "damping": {"stiffness": 1e-7}}},
        "bodies": {name: body(place, along, size) for name, place in places.items()},
        "obstacles": {"floor": {"shape": "half_space", "at": [0, 0, 0]}},
        "contacts": {f"{a}_{b}": {"between": [a, b], "friction": friction, "damping": 1e-5} for a, b in pairs},
        "listeners": {"above": {"type": "mono", "position": [0, 0, 0.5]}},
        "audio": {"rate": 8000, "max_frequency": 4000},
        "radiation": {"visibility": "off"},
        "output": {"frames_per_second": 0}}, indent=1)
