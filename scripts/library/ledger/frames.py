"""The shapes of a moving body that a result holds."""

from dataclasses import dataclass

import h5py
import numpy as np


@dataclass
class Frames:
    """The shapes of a result's only body."""
    time: np.ndarray          # [frames], s
    nodes: np.ndarray         # [nodes x 3] reference positions, m
    displacement: np.ndarray  # [frames x nodes x 3], m


def read_frames(result):
    with h5py.File(result) as file:
        body = next(iter(file["mesh"]))
        return Frames(file["frames/time"][()], file[f"mesh/{body}/nodes"][()],
                      file[f"frames/{body}/displacement"][()].astype(float))
