"""Sound maps, and blows on them."""
from __future__ import annotations

import tempfile
from dataclasses import asdict, dataclass
from pathlib import Path

import h5py
import numpy as np
from numpy.typing import ArrayLike

from . import program
from .errors import IdiophoneError
from .result import Result, text
from .series import Series


@dataclass(frozen=True)
class Hammer:
    """A hammer whose force follows Hertz' law of contact."""
    mass: float = 0.02      #: kg
    hardness: float = 1e8   #: N/m^(3/2): 1e5 soft rubber, 1e8 wood, 1e10 metal
    speed: float = 1.0      #: m/s


class SoundMap:
    """A file of `idiophone map`. Raises IdiophoneError if it can't be read."""

    def __init__(self, path: str | Path):
        self.path = Path(path)
        if not self.path.is_file():
            raise IdiophoneError(f"there is no file {path}")
        try:
            with h5py.File(self.path) as file:
                if text(file.attrs.get("format", "")) != "idiophone sound map":
                    raise IdiophoneError(f"{path} is not a sound map of idiophone")
                self.frequency: np.ndarray = file["modes/frequency"][()]  #: [modes], Hz, without damping
                self.decay: np.ndarray = file["modes/decay"][()]          #: [modes], 1/s, of the amplitude
                self.vertices: np.ndarray = file["surface/vertices"][()]  #: [vertices x 3], m
                self.triangles: np.ndarray = file["surface/triangles"][()]  #: [triangles x 3], vertex numbers
        except OSError as error:
            raise IdiophoneError(f"{path} can't be read: {error}") from None

    def __len__(self) -> int:
        """The number of modes."""
        return len(self.frequency)

    def directivity(self, mode: int) -> tuple[np.ndarray, np.ndarray]:
        """Directions [directions x 3] and the complex pressure [directions] that a mode sends there into the far field,
        Pa s/(m sqrt(kg)): per modal velocity, at the distance of `/sphere` (docs/use/sound_map.md)."""
        with h5py.File(self.path) as file:
            pairs = file["sphere/pressure"][mode]
            return file["sphere/direction"][()], pairs[:, 0] + 1j * pairs[:, 1]

    def strike(self, at: ArrayLike, direction: ArrayLike, impulse: float | None = None, hammer: Hammer | None = None,
               width: float = 2e-4, duration: float = 2.0, rate: int = 48000) -> Series:
        """The sound of a blow at the point nearest to `at` (m), at the listeners of the map: [samples x receivers], Pa.

        direction: of the force on the body. impulse: N s, of a half sine that is `width` seconds wide; or a hammer (default:
        Hammer()). duration: of the sound, s; rate: samples per second. Raises ProgramError.
        """
        if impulse is not None and hammer is not None:
            raise ValueError("a blow has an impulse or a hammer, not both")
        towards = np.asarray(direction, float) / np.linalg.norm(direction)
        event: dict[str, object] = {"time": 0, "at": np.asarray(at, float)}
        if impulse is None:
            event |= {"direction": towards, **asdict(hammer or Hammer())}
        else:  # the integral of a half sine is its peak times 2/pi times its width
            event |= {"type": "force", "force": towards * impulse * np.pi / (2 * width), "shape": "half_sine", "duration": width}
        with tempfile.TemporaryDirectory() as folder:
            score, output = Path(folder) / "score.yaml", Path(folder) / "blow.h5"
            score.write_text(program.as_text({"duration": duration, "events": [event]}))
            program.call("play", self.path, "--score", score, "--output", output, "--rate", rate)
            return Result(output).sound()
