"""Small decks for trials, complete in a folder of their own, and what their straight runs give."""

import functools
import pathlib
import re
import shutil
import tempfile
import time

from .program import FINISHED

HOME = pathlib.Path(__file__).resolve().parents[3]
DECKS = HOME / "ctest/app/decks"
EVERY_BLOCK = ("--set", "output.checkpoint.every_minutes=1e-9")
RECORDED = ("--set", "output.surface_motion=true")


def text_of(name):
    """A deck of the tests, with its meshes beside it."""
    return re.sub(r"(\.\./)+meshes/", "meshes/", (DECKS / f"{name}.yaml").read_text())


def lay_out(folder):
    """The files that the decks name."""
    shutil.copytree(HOME / "meshes", folder / "meshes")
    shutil.copy(DECKS / "tap.csv", folder)


class Straight:
    """A deck, and the bits and the time of its uninterrupted run."""

    def __init__(self, program, work, name, *arguments):
        self.program, self.name, self.arguments = program, name, arguments
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix=name, dir=work))
        lay_out(self.folder)
        (self.folder / "deck.yaml").write_text(text_of(name))
        start = time.monotonic()
        program.call(self.folder, *self.command(), ranks=2, allowed=(FINISHED,))
        self.seconds = time.monotonic() - start
        self.bits = self.bits_of(self.folder)

    def command(self, *more):
        return "run", "deck.yaml", "--output-folder", "results", *self.arguments, *more

    def files(self, folder):
        """The result and the recording, if there is one."""
        return sorted((folder / "results").glob(f"{self.name}*.h5"))

    def bits_of(self, folder):
        return {path.name: self.program.bits(path) for path in self.files(folder)}

    def copy(self, folder):
        """The deck and its files."""
        shutil.copytree(self.folder, folder, dirs_exist_ok=True,
                        ignore=shutil.ignore_patterns("results", "commands", "stdout", "stderr"))


@functools.cache
def straight(program, work, name, *arguments):
    return Straight(program, work, name, *arguments)
