"""The shapes of a moving body that a result holds."""

from dataclasses import dataclass

import numpy as np
from idiophone import Result


@dataclass
class Frames:
    """The shapes of a result's only body."""
    time: np.ndarray          # [frames], s
    nodes: np.ndarray         # [nodes x 3] reference positions, m
    displacement: np.ndarray  # [frames x nodes x 3], m


def read_frames(result):
    computed = Result(result)
    body = computed.bodies[0]
    return Frames(computed.frame_times, computed.nodes(body), computed.displacement(body))
