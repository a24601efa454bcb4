"""Where the camera of a movie stands: at a listener's place if everything can be seen from there."""

import itertools
from dataclasses import dataclass

import numpy as np

from library.cinema.result import vector

WIDEST = 60    # degrees: what a listener's view may take from bottom to top
USUAL = 30     # degrees, of a view from anywhere else
MARGIN = 1.15  # of the picture's size to what must be in it
DEFAULT_VIEW = (-0.5, 0.8, -0.45)


@dataclass
class View:
    """A camera's place. position: [3] m; look, up: unit vectors [3]; angle: degrees from bottom to top."""
    position: np.ndarray
    look: np.ndarray
    up: np.ndarray
    angle: float

    def apply(self, camera):
        """Puts a VTK camera there."""
        camera.SetPosition(self.position)
        camera.SetFocalPoint(self.position + self.look)
        camera.SetViewUp(self.up)
        camera.SetViewAngle(self.angle)


def choose(deck, listener, direction, box, aspect):
    """The listener's view if it is a stereo one and all of the box is in it; else one from where the box fills the
    picture. direction: to look in, None for the listener's; box: lowest and highest x, y, z [2 x 3]; aspect: width to
    height."""
    ears = deck.section("listeners").get(listener, {})
    gravity = vector(deck.values.get("gravity", [0, 0, 0]))
    up = -gravity if gravity.any() else np.array([0.0, 0.0, 1.0])
    if direction is None and "look" in ears:
        direction, up = vector(ears["look"]), vector(ears["up"])
        seen = _from(vector(ears["position"]), direction, up, box, aspect)
        if seen:
            return seen
    return _around(np.array(DEFAULT_VIEW if direction is None else direction, dtype=float), up, box, aspect)


def _frame(look, up):
    """Right, up and look, unit vectors at right angles: [3 x 3]."""
    look = look / np.linalg.norm(look)
    right = np.cross(look, up)
    if np.linalg.norm(right) < 1e-6 * np.linalg.norm(up):  # straight up or down
        right = np.cross(look, [0.0, 1.0, 0.0] if abs(look[1]) < 0.9 else [1.0, 0.0, 0.0])
    right = right / np.linalg.norm(right)
    return np.array([right, np.cross(right, look), look])


def _corners(box):
    return np.array(list(itertools.product(*np.transpose(box))))


def _from(position, look, up, box, aspect):
    """The view from there, as narrow as the box allows; None if a part of the box is behind or far aside."""
    frame = _frame(look, up)
    right, above, ahead = frame @ (_corners(box) - position).T
    if ahead.min() <= 0:
        return None
    slope = MARGIN * max(np.abs(above / ahead).max(), np.abs(right / ahead).max() / aspect)
    angle = 2 * np.degrees(np.arctan(slope))
    return View(position, frame[2], frame[1], angle) if angle <= WIDEST else None


def _around(look, up, box, aspect):
    """The view in that direction from where the box just fits."""
    frame = _frame(look, up)
    centre = np.mean(box, axis=0)
    right, above, ahead = frame @ (_corners(box) - centre).T
    slope = np.tan(np.radians(USUAL / 2)) / MARGIN
    distance = max((np.abs(above) / slope - ahead).max(), (np.abs(right) / (slope * aspect) - ahead).max())
    return View(centre - distance * frame[2], frame[2], frame[1], USUAL)
