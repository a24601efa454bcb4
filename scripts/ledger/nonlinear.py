"""What the nonlinear cases share: rows, the program's runs, and what results hold."""

import math
import subprocess
import sys
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import h5py
import numpy as np
import yaml

HOME = Path(__file__).resolve().parents[2]
PICTURES = HOME / "verification/pictures"
ERRORS = {"Hz": ("cents", lambda computed, reference: 1200 * math.log2(computed / reference)),
          "m": ("%", lambda computed, reference: 100 * (computed / reference - 1))}


@dataclass
class Row:
    """A quantity, its reference and what was computed, both in `unit`: Hz or m. Error and tolerance are in cents of a
    frequency, percent of a length."""
    quantity: str
    reference: float
    computed: float
    unit: str
    tolerance: float

    @property
    def error(self):
        return ERRORS[self.unit][1](self.computed, self.reference)

    @property
    def passed(self):
        return abs(self.error) <= self.tolerance


@dataclass
class Program:
    path: Path     # of idiophone
    results: Path  # directory for all results
    reuse: bool    # results that are there are not computed again
    short: bool    # only what is for every day: nothing is drawn

    def call(self, command, deck, folder, overrides, *more):
        """NAME, where the program leaves its files as NAME.h5 or NAME_modes.h5."""
        name = folder / read_yaml(deck)["name"]
        result = Path(f"{name}{'_modes' if command == 'modes' else ''}.h5")
        if not (self.reuse and result.exists()):
            folder.mkdir(parents=True, exist_ok=True)
            words = [word for each in overrides for word in ("--set", each)]
            done = subprocess.run([self.path, command, HOME / deck, "--output", folder, *more, *words],
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            if done.returncode:
                sys.exit(f"{' '.join(map(str, done.args))} failed:\n{done.stdout}")
        return result

    def run(self, name, deck, overrides=()):
        """The result file of a run."""
        return self.call("run", deck, self.results / name, overrides, "--progress", "log")

    def modes(self, name, deck, overrides=(), count=6):
        """Frequencies, Hz, and shapes, [modes x nodes x 3], of the deck's only body with the motion's own mass."""
        with h5py.File(self.call("modes", deck, self.results / name, overrides, "--count", str(count))) as file:
            group = next(iter(file["modes"].values()))
            return group["frequency"][()], group["shape"][()]


@dataclass
class Frames:
    """The shapes of a result's only body."""
    time: np.ndarray          # [frames], s
    nodes: np.ndarray         # [nodes x 3] reference positions, m
    displacement: np.ndarray  # [frames x nodes x 3], m


def read_frames(result):
    with h5py.File(result) as file:
        body = next(iter(file["mesh"]))
        return Frames(file["frames/time"][()], file[f"mesh/{body}/nodes"][()],
                      file[f"frames/{body}/displacement"][()].astype(float))


def read_yaml(path):
    return yaml.safe_load((HOME / path).read_text())


@contextmanager
def picture(name, x, y):
    """The axes of a picture to be drawn, with their labels; it becomes verification/pictures/NAME.png."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(figsize=(6, 4))
    axes.set_xlabel(x)
    axes.set_ylabel(y)
    yield axes
    if axes.get_legend_handles_labels()[0]:
        axes.legend(fontsize="small")
    PICTURES.mkdir(exist_ok=True)
    figure.savefig(PICTURES / f"{name}.png", dpi=100, bbox_inches="tight")
    pyplot.close(figure)
