"""The moving bodies of a result file: their surfaces, and where the surfaces are in each frame."""

import numpy as np
import yaml
from scipy.spatial.transform import Rotation

from idiophone.files import text

from library.recording import fail

FACES = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])    # corners of a tetrahedron, seen from outside in turn
MIDDLES = np.array([[6, 5, 4], [4, 8, 7], [5, 9, 8], [7, 9, 6]])  # of the faces' edges, the first between the first two
QUARTERS = np.array([[0, 3, 5], [3, 1, 4], [5, 4, 2], [3, 4, 5]])  # of a face: three corners, then three middles
SQUARES = np.array([[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]])  # of a hexahedron
HALVES = np.array([[0, 1, 2], [0, 2, 3]])  # of a square


class Deck:
    """The deck of a result with its overrides, every scalar as text."""

    def __init__(self, file):
        self.values = yaml.load(text(file["deck"][0]), yaml.BaseLoader)
        for override in file["overrides"]:
            path, value = text(override).split("=", 1)
            _put(self.values, path.split("."), yaml.load(value, yaml.BaseLoader))

    def section(self, key):
        """A map of the deck by name, empty where it is left out."""
        return self.values.get(key) or {}

    def holds(self, body):
        """Whether a part of the body can't move at all."""
        return any(isinstance(group, str) or set(group.get("axes", "xyz")) == set("xyz")
                   for group in self.section("bodies")[body].get("fixed") or [])


def vector(values):
    """[3] numbers of a deck."""
    return np.array([float(value) for value in values])


def outside(elements):
    """Numbers [points] of the nodes on the outside of tetrahedra or hexahedra, and triangles [n x 3] that refer to these,
    seen from outside in turn. elements: [elements x 4, 10 or 8], in VTK's order; a second-order face becomes four flat
    triangles, a square two."""
    sides = SQUARES if elements.shape[1] == 8 else FACES
    corners = elements[:, sides].reshape(-1, sides.shape[1])
    _, first, count = np.unique(np.sort(corners, axis=1), axis=0, return_index=True, return_counts=True)
    faces = corners[first[count == 1]]
    if elements.shape[1] == 10:
        middles = elements[:, MIDDLES].reshape(-1, 3)[first[count == 1]]
        faces = np.hstack([faces, middles])[:, QUARTERS].reshape(-1, 3)
    elif elements.shape[1] == 8:
        faces = faces[:, HALVES].reshape(-1, 3)
    numbers, triangles = np.unique(faces, return_inverse=True)
    return numbers, triangles.reshape(-1, 3)


class Body:
    """The surface of one body in motion."""

    def __init__(self, file, name, deck):
        mesh = file["mesh"][name]
        nodes = mesh["nodes"][()]
        self.name = name
        self.numbers, self.triangles = outside(mesh["elements"][()])
        self.reference = nodes[self.numbers]  # [points x 3], m
        self.displacement = file["frames"][name]["displacement"]
        self.held = deck.holds(name)

    def position(self, frame):
        """[points x 3], m."""
        displacement = self.displacement[frame][self.numbers]
        if not np.isfinite(displacement).all():
            fail(f"frame {frame} of {self.name} is not finite: the run was unstable")
        return self.reference + displacement

    def magnified(self, frame, factor):
        """[points x 3], m: the position, its deviation from the body's rigid motion multiplied by the factor. The rigid
        motion is none for a body that is held, and the best fit to the surface's points otherwise."""
        position = self.position(frame)
        rigid = self.reference if self.held or factor == 1 else rigid_motion(self.reference, position)
        return rigid + factor * (position - rigid)


def rigid_motion(reference, position):
    """The reference turned and shifted to fit the position best, by least squares. [points x 3] each."""
    centre = reference.mean(axis=0)
    turn, _ = Rotation.align_vectors(position - position.mean(axis=0), reference - centre)
    return turn.apply(reference - centre) + position.mean(axis=0)


class Result:
    """A result file with frames.

    times: [frames] s; bodies: their surfaces; deck: what was run."""

    def __init__(self, file):
        if text(file.attrs.get("format", "")) != "idiophone result":
            fail(f"{file.filename} is not a result of idiophone")
        if "frames" not in file or not len(file["frames/time"]):
            fail(f"{file.filename} has no frames: set output.frames_per_second in the deck, 60 for instance, and run "
                 "it again")
        try:
            self.deck = Deck(file)
            self.times = file["frames/time"][()]
            self.bodies = [Body(file, name, self.deck) for name in self.deck.section("bodies")]
        except KeyError as error:
            fail(f"{file.filename} is incomplete: {error}")

    def speed(self, body, frame):
        """[points] m/s: mean over the time from the frame before, or to the next one for the first."""
        if len(self.times) == 1:
            return np.zeros(len(body.reference))
        after = max(frame, 1)
        moved = body.position(after) - body.position(after - 1)
        return np.linalg.norm(moved, axis=1) / (self.times[after] - self.times[after - 1])


def _put(place, path, value):
    """Sets one value inside maps and lists, as the program's --set does."""
    key, *rest = path
    if isinstance(place, list):
        key = int(key)
        place.extend([{}] * (key == len(place)))
    elif rest and not place.get(key):
        place[key] = {}
    if rest:
        _put(place[key], rest, value)
    else:
        place[key] = value
