"""Calls of the program `idiophone`."""
from __future__ import annotations

import json
import os
import re
import shutil
import signal
import subprocess
import threading
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any

from .errors import DeckError, ProgramError, Stopped, mistakes_of
from .facts import Facts

FINISHED, FAILED, WRONG_DECK, RESUMABLE = 0, 1, 2, 75  # statuses of the program
STOP = signal.SIGUSR1  # mpirun passes it on to the ranks
PROGRESS = re.compile(r"^\s*(\d+(?:\.\d+)?) %")
# What mpirun adds to the words of a program that ends with an error: paragraphs between dashes, and lines "[host:process] ..."
NOTES_OF_MPIRUN = re.compile(r"^-{20,}\n.*?^-{20,}$|^\[[^\]\n]*:\d+\][^\n]*$", re.MULTILINE | re.DOTALL)
MPI = {  # as scripts/mpi_environment: more ranks than cores, root in containers, no threads in BLAS
    "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_btl_vader_single_copy_mechanism": "none",
    "OMPI_MCA_smsc": "^cma", "OMPI_MCA_btl_tcp_disable_family": "6", "OMPI_MCA_mpi_yield_when_idle": "1", "OMP_NUM_THREADS": "1",
    "HWLOC_COMPONENTS": "-opencl"}

OF_A_JOB = ("OMPI_", "PMIX_", "PRTE_", "ORTE_")  # what mpirun tells its processes; a program that finds it would join their job

Progress = Callable[[float], object]  #: is called with the fraction that is done, from 0 to 1


def path_of_program() -> Path:
    """The program that will be called. Raises ProgramError if there is none."""
    above = Path(__file__).resolve().parents
    candidates = [os.environ.get("IDIOPHONE"), str(above[2] / "build/production/idiophone"),  # of the source tree
                  *(str(folder / "bin/idiophone") for folder in above[4:5]),                 # installed with this module
                  shutil.which("idiophone")]
    for path in filter(None, candidates):
        if os.access(path, os.X_OK):
            return Path(path)
    raise ProgramError("there is no program idiophone: scripts/build production idiophone builds it, or the environment variable "
                       "IDIOPHONE names it")


def call(*arguments: object, ranks: int = 1, progress: Progress | None = None, stop: threading.Event | None = None) -> str:
    """What the program prints.

    Ctrl-C stops the program in good order, and is raised again when it has ended. When another thread sets `stop`, the program stops
    in the same way, and Stopped is raised.
    Raises DeckError for mistakes in a deck, Stopped if a signal stopped a run, ProgramError for all else.
    """
    return _call(arguments, ranks, progress, stop)[0]


def answer(*arguments: object, ranks: int = 1, judges: bool = False) -> Facts:
    """What the program answers with --json, and as `messages` the lines that it says besides. Raises as call().

    judges: the command also fails where it does not accept its own answer, which then says why.
    """
    printed, messages = _call([*arguments, "--json"], ranks, judges=judges)
    found: Facts = json.loads(printed, object_hook=Facts)
    found["messages"] = messages.splitlines()
    return found


def _call(arguments: Sequence[object], ranks: int = 1, progress: Progress | None = None, stop: threading.Event | None = None,
          judges: bool = False) -> tuple[str, str]:
    """What the program writes to its standard output and to its standard error."""
    if ranks < 1:
        raise ValueError(f"ranks must be at least 1, not {ranks}")
    launcher = ["mpirun", "--oversubscribe", "--bind-to", "none", "-n", str(ranks)] if ranks > 1 else []
    process = subprocess.Popen([*launcher, path_of_program(), *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               text=True, env=_environment(), start_new_session=True)  # Ctrl-C reaches it through us only
    errors: list[str] = []
    reader = threading.Thread(target=lambda: errors.append(process.stderr.read()))  # type: ignore[union-attr]
    reader.start()
    if stop:
        threading.Thread(target=_obey, args=(process, stop), daemon=True).start()
    try:
        printed = _read(process, progress)
        status = process.wait()
    except BaseException:
        _stop(process)
        raise
    finally:
        reader.join()
    said = _words_of_program(errors[0], status)
    if status == WRONG_DECK:
        raise DeckError(mistakes_of(said))
    if status == RESUMABLE or (stop and stop.is_set() and status != FINISHED):
        raise Stopped(said or "a signal stopped the run; resume=True goes on from its checkpoint")
    is_judged = judges and status == FAILED and printed.strip()
    if status != FINISHED and not is_judged:
        raise ProgramError(said or printed.strip() or f"idiophone ended with status {status}")
    return printed, said


def _words_of_program(text: str, status: int) -> str:
    """Without the notes of mpirun, where the program itself says why it ends. Otherwise they may be all that tells the cause."""
    own = NOTES_OF_MPIRUN.sub("", text).strip()
    is_told = status in (WRONG_DECK, RESUMABLE) or (status == FAILED and re.search("^idiophone: ", own, re.MULTILINE))
    return own if own and is_told else text.strip()


def _environment() -> dict[str, str]:
    """Ours and that of MPI. In a program that mpirun has started, the program is a job of its own."""
    in_a_job = "OMPI_COMM_WORLD_SIZE" in os.environ
    return {name: value for name, value in os.environ.items() if not (in_a_job and name.startswith(OF_A_JOB))} | MPI


def _read(process: subprocess.Popen[str], progress: Progress | None) -> str:
    lines = []
    for line in process.stdout or ():
        lines.append(line)
        if progress and (done := PROGRESS.match(line)):
            progress(float(done[1]) / 100)
    return "".join(lines)


def _obey(process: subprocess.Popen[str], stop: threading.Event) -> None:
    """Waits until the program ends, and stops it in good order when `stop` is set."""
    while process.poll() is None:
        if stop.wait(0.1):
            process.send_signal(STOP)
            return


def _stop(process: subprocess.Popen[str]) -> None:
    """Stops a program in good order, or at once if we are interrupted again."""
    process.send_signal(STOP)
    try:
        _read(process, None)
        process.wait()
    except KeyboardInterrupt:
        os.killpg(process.pid, signal.SIGKILL)


def options(**values: object) -> list[object]:
    """The options of a command by their names with _ for -. A list or array is joined by commas; None leaves the option out."""
    found: list[object] = []
    for name, value in values.items():
        if value is not None:
            text = value if isinstance(value, str) or not isinstance(value, Iterable) else ",".join(map(str, value))
            found += [f"--{name.replace('_', '-')}", text]
    return found


def setting(key: str, value: Any) -> list[str]:
    """The arguments that override a value of a deck."""
    return ["--set", f"{key}={as_text(value)}"]


def as_text(value: Any, indent: int | None = None) -> str:
    """A Python value as JSON, which is YAML, too. NumPy's arrays and numbers become lists and numbers, paths become texts."""
    def plain(other: Any) -> Any:
        return other.tolist() if hasattr(other, "tolist") else str(other)
    return json.dumps(value, indent=indent, default=plain, allow_nan=False)
