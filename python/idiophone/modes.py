"""Modes of a body."""
from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np


@dataclass
class FrequencyBounds:
    """Between them lies each frequency of the exact elastic solid of the mesh's shape (docs/method/bounds.md)."""
    lower: np.ndarray   #: [modes], Hz; they hold if the solid has no more than `modes_below` modes below `separation`
    upper: np.ndarray   #: [modes], Hz
    modes_below: int
    separation: float   #: Hz


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
    bounds: FrequencyBounds | None = None  #: of the frequencies, if they were asked for
    kinetic_share: np.ndarray | None = None  #: [modes], of the kinetic energy: 1 without joints; only of a file that has it

    def __len__(self) -> int:
        return len(self.frequency)
