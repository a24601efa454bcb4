"""Starts the program as a user would, and looks at what it left. The tests beside this file use it."""
import contextlib
import itertools
import os
import pathlib
import pty
import signal
import subprocess
import tempfile
import unittest

import h5py
import launcher
import numpy

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = HERE.parent.parent
PROGRAM = os.environ["IDIOPHONE"]
MPIRUN = os.environ["IDIOPHONE_MPIRUN"].split()
SANITIZERS = os.environ.get("IDIOPHONE_SANITIZE")  # e.g. address,undefined
SANITIZED = bool(SANITIZERS)  # slower, with memory of the sanitizers
SANITIZED_BUILD = [f"-DCMAKE_CXX_FLAGS=-fsanitize={SANITIZERS}"] if SANITIZED else []  # of programs with its libraries
# Marks a check, or a class of them, that only ctest --preset verification runs: it takes minutes, or a shorter one beside
# it sees most of what it sees. Its script is then a second test, app.NAME_long, with all of its checks.
LONG = "IDIOPHONE_LONG" in os.environ
OTHER_RANKS = (2, 3) if LONG else (3,)  # whose results are compared with those of one rank
long_verification = unittest.skipUnless(LONG, "part of the long verification")

TIMEOUT = 7200 if LONG else 2400 if SANITIZED else 240  # s: nothing may hang; a test takes a few seconds on an idle machine

FINISHED, FAILED, WRONG_DECK, RESUMABLE = 0, 1, 2, 75


def deck(name):
    return HERE / "decks" / f"{name}.yaml"


def idiophone(*arguments, ranks=None, environment=()):
    """Calls the program, under mpirun if ranks are given, and returns its status, stdout and stderr."""
    if ranks is None:
        return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=TIMEOUT,
                              env={**os.environ, **dict(environment)})
    start = [*MPIRUN, "-n", str(ranks)]
    for key, value in dict(environment).items():  # the ranks' alone: mpirun itself must not get a preloaded library
        start += ["-x", f"{key}={value}"]
    return launcher.call([*start, PROGRAM, *map(str, arguments)], TIMEOUT)


def stopped_when_it_says(text, *arguments):
    """Calls the program on a terminal of its own, where it shows its progress after each piece of work, and sends it SIGTERM
    when it has said something. Returns its status and all that it said."""
    screen, terminal = pty.openpty()
    job = subprocess.Popen([PROGRAM, *map(str, arguments)], stdout=terminal, stderr=terminal)
    os.close(terminal)
    said, told = "", False
    with contextlib.suppress(OSError):  # the terminal is closed
        while read := os.read(screen, 4096).decode(errors="replace"):
            said += read
            if text in said and not told:
                job.send_signal(signal.SIGTERM)
                told = True
    os.close(screen)
    return job.wait(timeout=TIMEOUT), said


def run(name, output, *arguments, ranks=1, environment=()):
    return idiophone("run", deck(name), "--output-folder", output, *arguments, ranks=ranks, environment=environment)


def preload(library, **environment):
    """Environment that puts one of the test's libraries before MPI, beside those that are there."""
    return {"LD_PRELOAD": f"{os.environ[library]}:{os.environ.get('LD_PRELOAD', '')}", **environment}


def can_mount():
    """Whether a test may mount file systems of its own."""
    return subprocess.run(["unshare", "--mount", "true"], capture_output=True, check=False).returncode == 0


def wav_samples(path):
    """Of a WAV file of 32-bit floats, [samples x channels] one after the other."""
    raw = path.read_bytes()
    return numpy.frombuffer(raw[raw.index(b"data") + 8:], dtype="<f4")


def contents(path):
    """Every dataset of a result by its path, without the deck's overrides, which tell how a run was stopped, and
    without the resolved deck, which has them."""
    found = {}
    with h5py.File(path) as file:
        file.visititems(lambda name, item: found.update({name: item[()]}) if isinstance(item, h5py.Dataset) else None)
    found.pop("overrides", None)
    found.pop("run/deck", None)
    return found


class TestCase(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.output = pathlib.Path(directory.name)

    def require_status(self, job, status):
        self.assertEqual(job.returncode, status, f"{' '.join(map(str, job.args))}\n{job.stdout}\n{job.stderr}")

    def run_in_jobs(self, name, output, *arguments, ranks, options=((),)):
        """Runs a deck by one job after another. Each stops at the end of its first block, and the next one goes on.
        @param ranks    of each job, at most so many
        @param options  further arguments of the first job, the second one, ..., then of the first one again
        @return         number of jobs"""
        limit = "--set", "time.wall_clock_limit=1e-6"
        for number, (n, more) in enumerate(zip(ranks, itertools.cycle(options)), start=1):
            job = run(name, output, *arguments, *limit, "--resume", *more, ranks=n)
            if job.returncode == FINISHED:
                return number
            self.require_status(job, RESUMABLE)
        return self.fail(f"{name} has not ended after {number} jobs")

    def require_same(self, path, expected):
        """Requires all datasets of two results to agree to the bit."""
        found = contents(path)
        self.assertEqual(sorted(found), sorted(expected))
        for name, values in expected.items():
            equal = numpy.array_equal if values.dtype == object else lambda a, b: a.tobytes() == b.tobytes()
            self.assertTrue(equal(found[name], values), f"/{name} differs")
