"""Starts the program, and keeps what it computed."""

import csv
import json
import os
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import yaml
from idiophone import Result

from library import mpi

HOME = Path(__file__).resolve().parents[3]


def read_yaml(path):
    return yaml.safe_load((HOME / path).read_text())


def deck_with(path, overrides):
    """A deck with KEY.PATH=VALUE overrides."""
    deck = read_yaml(path)
    for each in overrides:
        keys, value = each.split("=", 1)
        *folders, last = keys.split(".")
        section = deck
        for key in folders:
            section = section.setdefault(key, {}) if isinstance(section, dict) else section[int(key)]
        section[last if isinstance(section, dict) else int(last)] = yaml.safe_load(value)
    return deck


def material(deck):
    """young, poisson, density of the deck's first material. (YAML in Python takes 2.0e11, without +, for a text.)"""
    given = next(iter(read_yaml(deck)["materials"].values()))
    return {key: float(given[key]) for key in ("young", "poisson", "density")}


@dataclass
class Partial:
    """A damped sine of a sound."""
    frequency: float   # Hz
    level: float       # dB
    decay_time: float  # T60, s; infinite where no decay can be told from none


@dataclass
class Shapes:
    """Modes of a body and its mesh."""
    frequencies: np.ndarray  # Hz [modes]
    decay_times: np.ndarray  # T60, s [modes]
    shapes: np.ndarray       # m at unit modal mass [modes x nodes x 3]
    nodes: np.ndarray        # m [nodes x 3]
    elements: np.ndarray     # nodes of each [elements x nodes per element]


@dataclass
class Program:
    path: Path     # of idiophone
    results: Path  # directory for all results
    ranks: int
    reuse: bool    # results that are there are not computed again
    short: bool    # only what is for every day: nothing is drawn

    def call(self, *arguments, ranks=None, log=None):
        start = mpi.mpirun(ranks) if ranks else []
        command = [*start, str(self.path), *map(str, arguments)]
        with open(log, "w+") if log else tempfile.TemporaryFile("w+") as said:
            done = subprocess.run(command, stdout=said, stderr=subprocess.STDOUT, env={**os.environ, **mpi.ENVIRONMENT})
            if done.returncode:
                said.seek(0)
                sys.exit(f"{' '.join(command)} failed:\n{said.read()}")

    def facts(self, command, deck, overrides=(), options=()):
        """The answer of a command with --json."""
        done = subprocess.run([str(self.path), command, str(HOME / deck), "--json", *map(str, options), *words(overrides)],
                              capture_output=True, text=True, env={**os.environ, **mpi.ENVIRONMENT})
        if done.returncode:
            sys.exit(f"{' '.join(map(str, done.args))} failed:\n{done.stderr}")
        return json.loads(done.stdout)

    def result(self, name, deck):
        """Where the result file of a run is."""
        return self.results / name / (read_yaml(deck)["name"] + ".h5")

    def sound(self, name, deck, overrides=()):
        """The result file of a run, which is computed."""
        result = self.result(name, deck)
        folder = result.parent
        if not (self.reuse and result.exists()):
            folder.mkdir(parents=True, exist_ok=True)
            print(f"running {name}", flush=True)
            self.call("run", HOME / deck, "--output-folder", folder, "--progress", "log", *words(overrides),
                      ranks=self.ranks, log=folder / "run.log")
        return result

    def radiation(self, name, deck, motions, overrides=()):
        """The answer of `radiate --json`. motions: its options, e.g. [--modes, 5]."""
        kept = self.results / name / "radiation.json"
        if not (self.reuse and kept.exists()):
            kept.parent.mkdir(parents=True, exist_ok=True)
            kept.write_text(json.dumps(self.facts("radiate", deck, overrides,
                                                  [*map(str, motions), "--output-folder", str(kept.parent)])))
        return json.loads(kept.read_text())

    def shapes(self, name, deck, overrides=(), count=10):
        """The lowest modes with the lumped mass, with their shapes."""
        folder = self.results / name / "shapes"
        folder.mkdir(parents=True, exist_ok=True)
        self.call("modes", HOME / deck, "--output-folder", folder, "--modes", count, "--no-estimate", *words(overrides))
        (modes,) = Result(next(folder.glob("*_modes.h5"))).modes.values()
        return Shapes(modes.frequency, modes.decay_time, modes.shape, modes.nodes, modes.elements)

    def modes(self, name, deck, overrides=(), count=10, mass="lumped"):
        """The lowest frequencies (Hz) of the deck's first body, and the damping's decay times T60 (s)."""
        folder = self.results / name
        kept = folder / f"{mass}.json"
        if not (self.reuse and kept.exists()):
            folder.mkdir(parents=True, exist_ok=True)
            self.call("modes", HOME / deck, "--output-folder", folder, "--mass", mass, "--modes", count, "--no-estimate",
                      *words(overrides))
            found = next(folder.glob("*_modes.h5"))
            (modes,) = Result(found).modes.values()
            kept.write_text(json.dumps([modes.frequency.tolist(), modes.decay_time.tolist()]))
            found.unlink()  # the shapes are large
        return json.loads(kept.read_text())

    def partials(self, result, start, span, highest, channel):
        """A channel's partials, by frequency."""
        table = result.with_suffix(".partials.csv")
        self.call("analyze", result, "--partials", table, "--start", start, "--range", span, "--highest", highest)
        with open(table) as file:
            return [Partial(float(row["frequency_Hz"]), float(row["level_dB"]), float(row["decay_time_s"] or "inf"))
                    for row in csv.DictReader(file) if row["channel"].endswith(channel)]


def words(overrides):
    return [word for each in overrides for word in ("--set", each)]
