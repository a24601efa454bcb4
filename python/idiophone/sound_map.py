"""Sound maps, and blows on them."""
from __future__ import annotations

import tempfile
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from . import program
from .files import COMPLEX, opened, text
from .radiation import relative
from .result import Result
from .series import Series


@dataclass(frozen=True)
class Hammer:
    """A hammer whose force follows Hertz' law of contact."""
    mass: float = 0.02      #: kg
    hardness: float = 1e8   #: N/m^(3/2): 1e5 soft rubber, 1e8 wood, 1e10 metal
    speed: float = 1.0      #: m/s


def _option(name: str, numbers: ArrayLike) -> list[str]:
    """An option of the program whose value are numbers."""
    return [f"{name}=" + ",".join(repr(float(number)) for number in np.asarray(numbers, float))]


class SoundMap:
    """A file of `idiophone map`. Raises IdiophoneError if it can't be read."""

    def __init__(self, path: str | Path):
        self.path = Path(path)
        with opened(path, "sound map") as file:
            self.body = text(file.attrs["body"])
            self.material = text(file.attrs["material"]) if "material" in file.attrs else ""  #: "" of several, and of ideal bodies
            self.centre: np.ndarray = file.attrs["centre"].reshape(3)     #: [3], m: from where directions are
            self.frequency: np.ndarray = file["modes/frequency"][()]      #: [modes], Hz, without damping
            #: [modes], cents by which the mesh makes each frequency too high, estimated; NaN where unknown; None if not at all
            self.mesh_error: np.ndarray | None = file["modes/mesh_error"][()] if "modes/mesh_error" in file else None
            self.decay: np.ndarray = file["modes/decay"][()]              #: [modes], 1/s, of the amplitude
            self.shape: np.ndarray = file["modes/shape"][()]              #: [modes x vertices x 3], 1/sqrt(kg)
            self.vertices: np.ndarray = file["surface/vertices"][()]      #: [vertices x 3], m
            self.triangles: np.ndarray = file["surface/triangles"][()]    #: [triangles x 3], vertex numbers
            self.listeners = [text(name) for name in file["listeners/name"][()]]
            self.listener_position: np.ndarray = file["listeners/position"][()]  #: [listeners x 3], m
            self.listener_delay: np.ndarray = file["listeners/delay"][()]        #: [listeners], s
            #: [modes x listeners], Pa s/(m sqrt(kg)): complex pressure for each modal velocity, after the delay
            self.listener_pressure: np.ndarray = file["listeners/pressure"][()] @ COMPLEX
            self.directions: np.ndarray = file["sphere/direction"][()]           #: [directions x 3], unit vectors
            self.distance = float(file["sphere/direction"].attrs["distance"])    #: m, of the far field
            self.weights: np.ndarray = file["sphere/weight"][()]                 #: [directions], sr: their solid angles
            self.impedance = float(file.attrs["air_density"] * file.attrs["air_speed"])  #: of the air, Pa s/m
            #: [modes x directions], Pa s/(m sqrt(kg)): complex pressure in the far field
            self.far_field: np.ndarray = file["sphere/pressure"][()] @ COMPLEX

    def __len__(self) -> int:
        """The number of modes."""
        return len(self.frequency)

    def directivity(self, mode: int) -> np.ndarray:
        """[directions]: the complex far field of a mode, from 0 on, over its largest absolute value."""
        return relative(self.far_field[mode])

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

    def listener_response(self, frequencies: ArrayLike, at: ArrayLike, direction: ArrayLike) -> np.ndarray:
        """[frequencies x listeners], Pa/N: complex pressure for a sinusoidal force at the vertex nearest to `at` (m), with the delay.

        frequencies: Hz. Complex numbers belong to exp(+i w t).
        """
        late = np.exp(-2j * np.pi * np.outer(np.asarray(frequencies, float), self.listener_delay))
        return self._response(self.listener_pressure, frequencies, at, direction) * late

    def far_field_response(self, frequencies: ArrayLike, at: ArrayLike, direction: ArrayLike) -> np.ndarray:
        """The same in all directions at the map's distance: [frequencies x directions], Pa/N, without a delay."""
        return self._response(self.far_field, frequencies, at, direction)

    def radiated_power(self, frequencies: ArrayLike, at: ArrayLike, direction: ArrayLike) -> np.ndarray:
        """[frequencies], W: mean sound power while a sinusoidal force with an amplitude of 1 N acts; with F N it is F^2 times that.

        It acts at the point of the surface nearest to `at` (m). Computed by `idiophone export --power`. Raises ProgramError.
        """
        flat = np.asarray(frequencies, float).ravel()
        at_once = 2000  # as a command line has room for
        power: list[np.ndarray] = [np.zeros(0)]
        with tempfile.TemporaryDirectory() as folder:
            table = Path(folder) / "power.csv"
            for first in range(0, len(flat), at_once):
                some = flat[first:first + at_once]
                program.call("export", self.path, "--power", table, *_option("--frequencies", some), *_option("--at", at),
                             *_option("--direction", direction))
                power.append(np.loadtxt(table, delimiter=",", ndmin=2)[:, 1])
        return np.concatenate(power)

    def _response(self, pressure: np.ndarray, frequencies: ArrayLike, at: ArrayLike, direction: ArrayLike) -> np.ndarray:
        """[frequencies x places] for a pressure [modes x places]: docs/method/sound_map.md, "Slow forces", for F = exp(i W t).

        The sound is the real part of a complex amplitude A, so a force exp(i W t) gives (A(W) + conj(A(-W)))/2.
        """
        vertex = np.argmin(np.linalg.norm(self.vertices - np.asarray(at, float), axis=1))
        drive = self.shape[:, vertex, :] @ (np.asarray(direction, float) / np.linalg.norm(direction))
        undamped = 2 * np.pi * self.frequency
        damped = np.sqrt(undamped**2 - self.decay**2)
        x = 1j * damped - self.decay
        factor = (1 + 1j * self.decay / damped) * drive
        ringing = 2j * np.pi * np.asarray(frequencies, float)[:, np.newaxis]
        slope = ringing / (1 + ringing / undamped[0])  # of the force, after its low-pass

        def amplitude(x: np.ndarray, factor: np.ndarray, pressure: np.ndarray) -> np.ndarray:
            return (factor * (1 / (ringing - x) + 1 / x + slope / x**2)) @ pressure

        return (amplitude(x, factor, pressure) + amplitude(x.conj(), factor.conj(), pressure.conj())) / 2
