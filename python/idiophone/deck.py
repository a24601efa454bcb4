"""Decks: read, changed, checked and run."""
from __future__ import annotations

import contextlib
import re
import tempfile
import threading
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import yaml
from numpy.typing import ArrayLike

from . import native, places, program
from .errors import DeckError, Mistake
from .facts import Facts
from .modes import Modes
from .radiation import Radiation
from .result import Result
from .studies import Identification, Tuning, identification, tuning

if TYPE_CHECKING:
    from mpi4py import MPI


class _Loader(yaml.SafeLoader):
    """Reads numbers as the program does: 2.0e11 and 1e-3 are numbers, too."""


_Loader.add_implicit_resolver("tag:yaml.org,2002:float", re.compile(r"^[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$"), list("-+.0123456789"))


class Deck:
    """A deck (docs/use/deck.md): a file with values that were changed, or Python values alone.

    Deck({"name": "plate", ...}) makes one of Python values. The files that it names are relative to `folder`.
    """

    def __init__(self, values: dict[str, Any], folder: str | Path = "."):
        self._path: Path | None = None
        self._folder = Path(folder)
        self._values = values
        self._settings: dict[str, Any] = {}

    @classmethod
    def read(cls, path: str | Path) -> Deck:
        """The deck of a YAML file. Raises OSError, and DeckError if it is not YAML; check() finds all other mistakes."""
        path = Path(path)
        try:
            values = yaml.load(path.read_text(), _Loader)
        except yaml.MarkedYAMLError as error:
            mark = error.problem_mark
            place = (mark.line + 1, mark.column + 1) if mark else (0, 0)
            raise DeckError([Mistake(str(error.problem), str(path), *place)]) from None
        deck = cls(values if isinstance(values, dict) else {}, path.parent)
        deck._path = path
        return deck

    def __getitem__(self, key: str) -> Any:
        """The value of a key path, e.g. "bodies.plate.material" or "bodies.plate.fixed.0". Raises KeyError if the deck lacks it."""
        place: Any = self._values
        for word in key.split("."):
            try:
                place = place[int(word) if isinstance(place, list) else word]
            except (KeyError, IndexError, ValueError, TypeError):
                raise KeyError(f"the deck has no {key}") from None
        return place

    def __setitem__(self, key: str, value: Any) -> None:
        """Sets the value of a key path; sections that are missing are made."""
        *sections, last = key.split(".")
        place: Any = self._values
        for word in sections:
            if isinstance(place, list):
                place = place[int(word)]
            else:
                if place.get(word) is None:
                    place[word] = {}
                place = place[word]
        if isinstance(place, list) and int(last) == len(place):
            place.append(value)
        else:
            place[int(last) if isinstance(place, list) else last] = value
        self._settings[key] = value

    def check(self, accuracy: float | None = None, up_to: float | None = None, ranks: int | None = None) -> Facts:
        """Sizes, step, memory, time and warnings, without a run (docs/use/running.md).

        accuracy: cents, and up_to: Hz, of the mesh that is recommended; ranks: number of ranks of a predicted run.
        Raises DeckError.
        """
        return self._answer("check", *program.options(accuracy=accuracy, up_to=up_to, ranks=ranks))

    def modes(self, body: str | None = None, count: int = 20, ranks: int = 1, estimate: bool | None = None,
              bounds: bool = False) -> Modes:
        """The lowest modes of a body (default: the first).

        estimate: whether the error of the mesh is estimated, too, for all modes (default: for the lowest, for about ten seconds).
        bounds: whether each frequency gets two-sided bounds, too, by the consistent mass (docs/method/bounds.md).
        One rank without bounds computes in this process if the extension is built (native.py); Ctrl-C then takes effect when it
        has ended. Raises DeckError, ProgramError.
        """
        if ranks == 1 and not bounds and native.is_built():
            with self._arguments() as deck:
                return native.modes(*deck, body=body, count=count, estimate=estimate)
        with tempfile.TemporaryDirectory() as folder:
            words = program.options(modes=count, output_folder=folder, body=body)
            words += [] if estimate is None else ["--estimate" if estimate else "--no-estimate"]
            words += ["--bounds"] if bounds else []
            answer = self._answer("modes", *words, ranks=ranks)
            (path,) = Path(folder).glob("*_modes.h5")
            modes = Result(path).modes[answer.body]
        modes.kinds = [mode.kind or "" for mode in answer.modes]
        return modes

    def identify(self, measured: str | Path | dict[str, Any] | ArrayLike, body: str | None = None, fit: Sequence[str] | None = None,
                 tolerance: float | None = None, lines: int | None = None, mass: str | None = None,
                 turn_deviation: float | None = None) -> Identification:
        """The constants of the material of a body (default: the first) from measured resonances (docs/use/identify.md).

        measured: frequencies in Hz; or the path of a recording or of a file of lines; or the values of such a file, e.g.
        {"mass": 0.412, "lines": [523.1, 1443.7]}. fit: names of constants, e.g. ["young"] (default: all), and of turns of the
        material's axes, e.g. ["constants", "turn_z"]. tolerance: cents between a line and its mode. lines: fit only so many, the
        lowest. mass: "consistent" or "lumped". turn_deviation: degrees, expected standard deviation of each turn.
        A fit with doubts is returned, too, with `accepted` False. Raises DeckError, ProgramError.
        """
        with _measurements(measured) as path:
            words = program.options(measured=path, body=body, fit=fit, tolerance=tolerance, lines=lines, mass=mass,
                                    turn_deviation=turn_deviation)
            return identification(self._answer("identify", *words, judges=True))

    def tune(self, target: str | Sequence[float | str], vary: dict[str, tuple[float, float]], body: str | None = None,
             modes: Sequence[int] | None = None, pitch: float | str | None = None, tolerance: float | None = None,
             a4: float | None = None, mass: str | None = None, scatter: dict[str, float | str] | None = None,
             within: float | None = None, decay_times: dict[int, float] | None = None, decay_tolerance: float | None = None,
             levels: dict[str, float | str] | None = None, level_tolerance: float | None = None,
             avoid: Sequence[str] | None = None) -> Tuning:
        """Numbers of the deck that give modes of a body (default: the first) wanted frequencies (docs/use/tune.md).

        target: Hz or notes, e.g. [187, "F#5"], or ratios, e.g. "1:4:10", whose first is `pitch`, a note or Hz (default: any).
        vary: key path -> lowest and highest value. modes: their numbers at the start, from 1 on (default: the lowest ones).
        tolerance: cents. a4: Hz, of the note A4. mass: "lumped" or "consistent". scatter: key path -> standard deviation from body
        to body, in the number's unit or as text in percent, e.g. "2%". within: cents, at which a body counts as in tune.
        decay_times: number of a mode at the start -> T60, s. decay_tolerance: percent. levels: listener -> LAE of
        the deck's blows in dB, or a limit as text, e.g. {"ears.left": "at_least:70"}. level_tolerance: dB.
        avoid: where no mode shall be, Hz or notes or cents around them, e.g. ["380:420", "A4~50"].
        Where not all is reached, the best values are returned, with `tuned` False. Raises DeckError, ProgramError.
        """
        words = program.options(target=target, body=body, pitch=pitch, tolerance=tolerance,
                                mode_numbers=modes, a4=a4, mass=mass, within=within, decay_tolerance=decay_tolerance,
                                level_tolerance=level_tolerance)
        for mode, seconds in (decay_times or {}).items():
            words += ["--decay-time", f"{mode}={seconds}"]
        for listener, level in (levels or {}).items():
            words += ["--level", f"{listener}={level}"]
        for band in avoid or ():
            words += ["--avoid", band]
        for key, (lowest, highest) in vary.items():
            words += ["--vary", f"{key}={lowest}:{highest}"]
        for key, deviation in (scatter or {}).items():
            words += ["--scatter", f"{key}={deviation}"]
        return tuning(self._answer("tune", *words, judges=True))

    def radiate(self, body: str | None = None, modes: int | None = None, frequencies: Sequence[float] | None = None,
                velocities: str | Path | None = None, tolerance: float | None = None, waves: float | None = None,
                most_vertices: int | None = None, ranks: int = 1) -> Radiation:
        """The sound of the lowest modes of a body (default: the first) by boundary elements (docs/use/radiate.md).

        modes: how many. frequencies: Hz, of rigid motions along x, y and z instead. velocities: a CSV file of them instead. tolerance:
        dB, to which the surface is refined; 0 takes the mesh as it is. waves: m, compare with model waves in cells of this size.
        most_vertices: of a refined surface.
        Raises DeckError, ProgramError.
        """
        with tempfile.TemporaryDirectory() as folder:
            words = program.options(body=body, modes=modes, frequencies=frequencies, velocities=velocities,
                                    tolerance=tolerance, waves=waves, most_vertices=most_vertices, output_folder=folder)
            self._answer("radiate", *words, ranks=ranks)
            (path,) = Path(folder).glob("*_radiation.h5")
            return Radiation(path)

    def run(self, output_folder: str | Path = "results", ranks: int = 1, progress: program.Progress | None = None,
            resume: bool = False, communicator: MPI.Intracomm | None = None, stop: threading.Event | None = None) -> Result:
        """The result of a run, NAME.h5 in the output folder.

        progress: is called with the fraction of the time that is done. resume: goes on from the newest checkpoint.
        communicator: of mpi4py, instead of `ranks`: its processes compute themselves (docs/use/python.md). All of them call this
        function with the same deck, and have the same result or the same exception; progress is called on rank 0.
        stop: another thread sets it to stop the run, which then raises Stopped; not with a communicator.
        Ctrl-C and `stop` end the run in good order, with a checkpoint. Raises DeckError, Stopped, ProgramError.
        """
        words = program.options(output_folder=output_folder, progress="log") + (["--resume"] if resume else [])
        with self._arguments() as deck:
            if communicator is None:
                program.call("run", *deck, *words, ranks=ranks, progress=progress, stop=stop)
            elif ranks == 1 and stop is None:
                native.run(*deck, output_folder=output_folder, resume=resume, communicator=communicator, progress=progress)
            else:
                raise ValueError("a run with a communicator has neither ranks nor stop")
        return Result(Path(output_folder) / f"{self['name']}.h5")

    def _answer(self, command: str, *words: object, ranks: int = 1, judges: bool = False) -> Facts:
        with self._arguments() as deck:
            return program.answer(command, *deck, *words, ranks=ranks, judges=judges)

    @contextlib.contextmanager
    def _arguments(self) -> Iterator[list[str]]:
        """The deck as the program gets it: its file, and --set with what was set.

        Mistakes in what Python has set have a key path instead of a place in a file.
        """
        with self._file() as path:
            settings = self._settings if self._path else {}
            try:
                yield [path, *(word for item in settings.items() for word in program.setting(*item))]
            except DeckError as error:
                keys = {} if self._path else places.key_paths(Path(path).read_text())
                raise DeckError([places.with_key(mistake, path, keys) for mistake in error.mistakes]) from None

    @contextlib.contextmanager
    def _file(self) -> Iterator[str]:
        """The path of the deck: its own, or that of a file of the Python values that lasts as long as the call."""
        if self._path:
            yield str(self._path)
            return
        with tempfile.NamedTemporaryFile("w", dir=self._folder, prefix=".", suffix=".yaml") as file:
            file.write(program.as_text(self._values, indent=1))
            file.flush()
            yield file.name


@contextlib.contextmanager
def _measurements(measured: str | Path | dict[str, Any] | ArrayLike) -> Iterator[str | Path]:
    """The path of measured resonances: as given, or of a file of the values that lasts as long as the call."""
    if isinstance(measured, (str, Path)):
        yield measured
        return
    values = measured if isinstance(measured, dict) else {"lines": np.asarray(measured, float)}
    with tempfile.NamedTemporaryFile("w", suffix=".yaml") as file:
        file.write(program.as_text(values))
        file.flush()
        yield file.name
