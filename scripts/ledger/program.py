"""Starts the program, and keeps what it computed."""

import csv
import json
import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import h5py
import yaml

HOME = Path(__file__).resolve().parents[2]
ENVIRONMENT = dict(
    line.split("=") for words in (HOME / "scripts/mpi_environment").read_text().splitlines()
    if words.startswith("export ") for line in words.split()[1:])


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
    """young, poisson, density of the deck's first material."""
    return next(iter(read_yaml(deck)["materials"].values()))


@dataclass
class Partial:
    """A damped sine of a sound."""
    frequency: float   # Hz
    level: float       # dB
    decay_time: float  # T60, s; infinite where no decay can be told from none


@dataclass
class Program:
    path: Path     # of idiophone
    results: Path  # directory for all results
    ranks: int
    reuse: bool    # results that are there are not computed again
    short: bool    # only what is for every day: nothing is drawn

    def call(self, *arguments, ranks=None, log=None):
        start = ["mpirun", "--oversubscribe", "--bind-to", "none", "-n", str(ranks)] if ranks else []
        command = [*start, str(self.path), *map(str, arguments)]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              env={**os.environ, **ENVIRONMENT})
        if log:
            log.write_text(done.stdout)
        if done.returncode:
            sys.exit(f"{' '.join(command)} failed:\n{done.stdout}")

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
            self.call("run", HOME / deck, "--output", folder, "--progress", "log", *words(overrides),
                      ranks=self.ranks, log=folder / "run.log")
        return result

    def modes(self, name, deck, overrides=(), count=10, mass="lumped"):
        """The lowest frequencies (Hz) of the deck's first body, and the damping's decay times T60 (s)."""
        folder = self.results / name
        kept = folder / f"{mass}.json"
        if not (self.reuse and kept.exists()):
            folder.mkdir(parents=True, exist_ok=True)
            self.call("modes", HOME / deck, "--output", folder, "--mass", mass, "--count", count, *words(overrides))
            found = next(folder.glob("*_modes.h5"))
            with h5py.File(found) as file:
                body = next(iter(file["modes"].values()))
                kept.write_text(json.dumps([body["frequency"][()].tolist(), body["decay_time"][()].tolist()]))
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
