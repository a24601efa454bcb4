"""Starts the program under limits, and judges how it ended."""

import json
import os
import pathlib
import re
import shlex
import signal
import subprocess
import sys
import time
from dataclasses import dataclass

from library import mpi

from . import processes

FINISHED, FAILED, WRONG_DECK, RESUMABLE = 0, 1, 2, 75
HONOURED_WITHIN = 5  # s from a signal to the end (docs/use/running.md)
PATIENCE = 4  # s that a trial computes before it is told to stop
UNDISTURBED = 60  # s, where it must finish
MEMORY = 4 << 30  # bytes that each process may write to
HARM = re.compile(r"received signal|terminate called|Caught signal|exited on signal|Aborted|Assertion|Sanitizer|"
                  r"runtime error: |PETSC ERROR|HDF5-DIAG|free\(\)|corrupted size|Bus error")
PLACE = re.compile(r":\d+:\d+: ")
BITS = pathlib.Path(__file__).parents[1] / "result_bits.py"


class Wrong(Exception):
    """What must not happen."""


@dataclass
class Job:
    """A program that ended."""
    command: str
    status: int
    out: str
    err: str
    told_to_stop: bool

    def text(self):
        return f"{self.command}\nstatus {self.status}\n{self.out}{self.err}"


class Program:
    def __init__(self, path, slowness):
        """path: of idiophone; slowness: how many times longer than on an idle machine an answer may take."""
        self.path = path
        self.slowness = slowness
        sanitized = b"__asan_init" in path.read_bytes()
        self.limits = ["prlimit", "--core=0"] + ([] if sanitized else [f"--data={MEMORY}"])
        self.environment = os.environ | mpi.ENVIRONMENT | {"ASAN_OPTIONS": "detect_leaks=0"}

    def start(self, folder, *arguments, ranks=None):
        """Starts the program in a folder and a session of its own; ranks=None starts it without mpirun."""
        command = [*self.limits, *(mpi.mpirun(ranks) if ranks else []), str(self.path), *map(str, arguments)]
        with open(folder / "commands", "a") as file:
            file.write(shlex.join(command) + "\n")
        with open(folder / "stdout", "w") as out, open(folder / "stderr", "w") as err:
            job = subprocess.Popen(command, cwd=folder, stdout=out, stderr=err, env=self.environment,
                                   stdin=subprocess.DEVNULL, start_new_session=True)
        job.folder = folder
        return job

    def end(self, job, patience):
        """Waits for the end; after this many seconds, the job must obey a signal. Returns the Job."""
        told_to_stop = False
        try:
            job.wait(patience * self.slowness)
        except subprocess.TimeoutExpired:
            told_to_stop = True
            self.stop(job, signal.SIGUSR1)
        finally:
            processes.kill_session(job.pid)
            job.wait()
        texts = [(job.folder / name).read_text(errors="replace") for name in ("stdout", "stderr")]
        return Job(shlex.join(job.args), job.returncode, *texts, told_to_stop)

    def stop(self, job, number):
        """Sends a signal, which the job must obey in time; returns the seconds that it took."""
        job.send_signal(number)
        start = time.monotonic()
        try:
            job.wait(HONOURED_WITHIN * self.slowness)
        except subprocess.TimeoutExpired:
            raise Wrong(f"hangs: {signal.Signals(number).name} not obeyed within {HONOURED_WITHIN * self.slowness:g} s") from None
        return time.monotonic() - start

    def call(self, folder, *arguments, ranks=None, allowed=(FINISHED, FAILED, WRONG_DECK, RESUMABLE)):
        patience = PATIENCE if RESUMABLE in allowed else UNDISTURBED
        return judged(self.end(self.start(folder, *arguments, ranks=ranks), patience), allowed)

    def bits(self, path):
        """Digest of a result's numbers, all of which must be finite."""
        try:
            done = subprocess.run([sys.executable, BITS, path], capture_output=True, text=True,
                                  timeout=60 * self.slowness)
        except subprocess.TimeoutExpired:
            raise Wrong(f"{path.name} makes HDF5 hang") from None
        if done.returncode != 0:
            raise Wrong(f"{path.name} cannot be read: {done.stderr}")
        found = json.loads(done.stdout)
        if not found["finite"]:
            raise Wrong(f"{path.name} has numbers that are not finite")
        return found["digest"]


def judged(job, allowed):
    """The job, if it ended with an allowed status and a message."""
    if job.status not in allowed:
        raise Wrong(f"status {job.status}\n{job.text()}")
    if found := HARM.search(job.out + job.err):
        raise Wrong(f"{found[0]!r} in the output\n{job.text()}")
    answers = "info --verify" in job.command  # what it finds is its answer, on standard output
    if job.status in (FAILED, WRONG_DECK) and not (job.err.strip() or answers):
        raise Wrong(f"no message\n{job.text()}")
    if job.status == WRONG_DECK and not PLACE.search(job.err):
        raise Wrong(f"a mistake of the deck without file:line:column\n{job.text()}")
    return job
