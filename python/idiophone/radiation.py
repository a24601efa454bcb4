"""The sound of modes or rigid motions by boundary elements."""
from __future__ import annotations

from pathlib import Path

import numpy as np

from .files import COMPLEX, opened, text


class Radiation:
    """A file of `idiophone radiate` (docs/use/radiate.md). Complex pressures belong to exp(+i w t).

    The motions are modes with a modal velocity of amplitude 1 m sqrt(kg)/s, or rigid motions with 1 m/s.
    Raises IdiophoneError if the file can't be read.
    """

    def __init__(self, path: str | Path):
        self.path = Path(path)
        with opened(path, "radiation") as file:
            sounds, sphere = file["sounds"], file["sphere"]
            self.body = text(file.attrs["body"])
            self.motions = [text(name) for name in sounds["name"][()]]                  #: e.g. "mode 3" or "along x"
            self.frequency: np.ndarray = sounds["frequency"][()]                        #: [motions], Hz
            self.power: np.ndarray = sounds["power"][()]                                #: [motions], W
            self.level_error: np.ndarray = sounds["level_error"][()]                    #: [motions], dB; NaN if it is unknown
            self.efficiency: np.ndarray = sounds["efficiency"][()]                      #: [motions]
            self.loss_factor: np.ndarray = sounds["loss_factor"][()]                    #: [motions]; NaN for rigid motions
            self.directivity_index: np.ndarray = sounds["directivity_index"][()]        #: [motions], dB
            self.mean_square_velocity: np.ndarray = sounds["mean_square_velocity"][()]  #: [motions], m2/s2
            #: model -> [motions], dB: how much more power the models "kirchhoff", "rayleigh" and "waves" have
            self.model_error: dict[str, np.ndarray] = {
                name.removesuffix("_worst"): sounds[name.replace("_worst", "_error")][()] for name in sounds if "_worst" in name}
            self.vertices: np.ndarray = file["surface/vertices"][()]                    #: [vertices x 3], m, of all bodies
            self.triangles: np.ndarray = file["surface/triangles"][()]                  #: [triangles x 3], vertex numbers
            self.surface_pressure: np.ndarray = file["surface/pressure"][()] @ COMPLEX  #: [motions x vertices], Pa
            has_listeners = "listeners" in file
            self.listeners = [text(name) for name in file["listeners/name"][()]] if has_listeners else []
            self.listener_position: np.ndarray = (                                      #: [listeners x 3], m
                file["listeners/position"][()] if has_listeners else np.empty((0, 3)))
            self.listener_pressure: np.ndarray = (                                      #: [motions x listeners], Pa
                file["listeners/pressure"][()] @ COMPLEX if has_listeners else np.empty((len(self), 0), complex))
            self.directions: np.ndarray = sphere["direction"][()]                       #: [directions x 3], unit vectors
            self.solid_angle: np.ndarray = sphere["weight"][()]                         #: [directions], sr, of each direction
            self.far_field: np.ndarray = sphere["pressure"][()] @ COMPLEX               #: [motions x directions], Pa m

    def __len__(self) -> int:
        """The number of motions."""
        return len(self.frequency)

    def directivity(self, motion: int) -> np.ndarray:
        """[directions]: the complex far field of a motion, from 0 on, over its largest absolute value."""
        return relative(self.far_field[motion])


def relative(field: np.ndarray) -> np.ndarray:
    """A complex field over its largest absolute value; zeros stay zeros."""
    largest = np.abs(field).max(initial=0)
    return field / largest if largest > 0 else field
