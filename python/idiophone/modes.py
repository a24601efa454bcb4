"""Modes of a body."""
from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np


@dataclass
class Modes:
    """The lowest modes of a body, by ascending frequency."""
    frequency: np.ndarray      #: [modes], Hz
    damping_ratio: np.ndarray  #: [modes]
    decay_time: np.ndarray     #: [modes], s: T60; infinite without damping
    shape: np.ndarray          #: [modes x nodes x 3], m at unit modal mass
    nodes: np.ndarray          #: [nodes x 3], m
    elements: np.ndarray       #: [cells x 4, 8 or 10], node numbers in VTK's order
    mesh_error: np.ndarray | None  #: [modes], cents by which the mesh makes each frequency too high, estimated; None if not
    rigid_motions: int         #: how many rigid motions the supports leave
    kinds: list[str] = field(default_factory=list)  #: [modes], e.g. "bending 1 along z"; empty texts for unknown ones

    def __len__(self) -> int:
        return len(self.frequency)
