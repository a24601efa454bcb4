"""Computations in this process, by the extension idiophone._core.

A build of the project makes it beside the program, in the folder python/idiophone; the Debian package has it beside this file.
What the program logs goes to the logger "idiophone" of Python's module logging.
"""
from __future__ import annotations

import atexit
import contextlib
import functools
import logging
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import idiophone

from . import program
from .errors import DeckError, ProgramError, Stopped, mistakes_of
from .modes import Modes

if TYPE_CHECKING:
    from mpi4py import MPI

LOG = logging.getLogger("idiophone")


@functools.cache
def is_built() -> bool:
    """Whether there is an extension that can be used here."""
    try:
        idiophone.__path__.append(str(program.path_of_program().resolve().parent / "python/idiophone"))
        program.call("--version")  # fails on a processor that lacks instructions that both were compiled for
        from . import _core
    except (ProgramError, ModuleNotFoundError):
        return False
    except ImportError as error:
        LOG.warning("the extension of the module can't be loaded: %s", error)
        return False
    atexit.register(_core.end)
    return True


def modes(deck: str, *settings: str, body: str | None, count: int, estimate: bool | None) -> Modes:
    """As Deck.modes(), on one rank. settings: --set KEY.PATH=VALUE. Raises as that."""
    from . import _core
    with _errors_of_the_module():
        return Modes(**_core.modes(deck, _values(settings), body or "", count, estimate, _log(None)))


def run(deck: str, *settings: str, output_folder: str | Path, resume: bool, communicator: MPI.Intracomm,
        progress: program.Progress | None) -> None:
    """As Deck.run(), on the ranks of a communicator. Raises as that."""
    if not is_built():
        raise ProgramError("only the extension of this module can compute in an MPI program, and it is not built: it needs the Debian "
                           "packages pybind11-dev and python3-dev. Without it, deck.run(ranks=2) starts the ranks itself")
    from . import _core
    first = communicator.bcast(deck)  # a deck of Python values has a file of its own on each rank
    with _errors_of_the_module(first, deck):
        _core.run(deck, _values(settings), str(output_folder), resume, communicator.py2f(), _log(progress))


def _values(settings: tuple[str, ...]) -> list[str]:
    return [word for word in settings if word != "--set"]


def _log(progress: program.Progress | None) -> Callable[[int, str], None]:
    """Where lines of the log go, with their levels: progress to `progress`, all else to LOG."""
    def log(level: int, line: str) -> None:
        if done := program.PROGRESS.match(line):
            if progress:
                progress(float(done[1]) / 100)
        else:
            LOG.log(level, "%s", line)
    return log


@contextlib.contextmanager
def _errors_of_the_module(file: str = "", own_file: str = "") -> Iterator[None]:
    """Raises the exceptions of the extension as those of this module, and names `own_file` where they name `file`."""
    from . import _core
    try:
        yield
    except _core.WrongDeck as error:
        raise DeckError(mistakes_of(str(error).replace(file, own_file) if file else str(error))) from None
    except _core.StoppedRun:
        raise Stopped("a signal or the wall-clock limit stopped the run; resume=True goes on from its checkpoint") from None
    except _core.FailedComputation as error:
        raise ProgramError(str(error)) from None
