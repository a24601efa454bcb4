"""Chooses the trials, counts how they end, and keeps the failed ones."""

import collections
import pathlib
import random
import secrets
import shutil
import sys
import tempfile
import time

from .commands import Commands
from .damage import Damage
from .decks import Decks
from .disks import Disks
from .interruptions import Interruptions
from .kills import Kills
from .listening import Listening
from .meshes import Meshes
from .pairs import Pairs
from .program import Wrong
from .wavs import Wavs

KINDS = {"decks": Decks, "meshes": Meshes, "commands": Commands, "damage": Damage, "kills": Kills, "signals": Interruptions,
         "disks": Disks, "pairs": Pairs, "wavs": Wavs, "listening": Listening}


class Campaign:
    def __init__(self, program, seed, keep):
        """keep: folder of failed trials. Without a seed, it is a random one."""
        self.program, self.keep = program, keep
        self.seed = secrets.randbelow(10**6) if seed is None else seed
        self.outcomes = {}  # kind: Counter of outcomes
        self.failed = 0
        self.skipped = {}  # kind: what it needs

    def run(self, names, seconds):
        """Trials of all kinds by their shares of the time."""
        with tempfile.TemporaryDirectory(prefix="torment_") as work:
            trials = self.prepared(names, pathlib.Path(work))
            deadline = time.monotonic() + seconds
            spent = dict.fromkeys(trials, 0.0)
            numbers = dict.fromkeys(trials, 0)
            while trials and time.monotonic() < deadline:
                name = min(trials, key=lambda each: spent[each] / KINDS[each].SHARE)
                start = time.monotonic()
                self.trial(trials[name], name, numbers[name], pathlib.Path(work))
                spent[name] += time.monotonic() - start
                numbers[name] += 1

    def run_once(self, names, number):
        with tempfile.TemporaryDirectory(prefix="torment_") as work:
            for name, kind in self.prepared(names, pathlib.Path(work)).items():
                self.trial(kind, name, number, pathlib.Path(work))

    def prepared(self, names, work):
        """The kinds by name, without those that this machine does not allow."""
        made = {}
        for name in names:
            if not getattr(KINDS[name], "possible", lambda: True)():
                self.skipped[name] = KINDS[name].NEEDS
                continue
            made[name] = KINDS[name](self.program, work)
            self.outcomes[name] = collections.Counter()
        return made

    def trial(self, kind, name, number, work):
        folder = work / f"trial_{name}_{number}"
        folder.mkdir()
        try:
            outcome = kind.trial(random.Random(f"{self.seed} {name} {number}"), folder)
        except Wrong as wrong:
            outcome = "WRONG"
            self.failed += 1
            self.keep_trial(folder, name, number, str(wrong))
        self.outcomes[name][outcome] += 1
        shutil.rmtree(folder)

    def keep_trial(self, folder, name, number, wrong):
        kept = self.keep / f"{self.seed}_{name}_{number}"
        shutil.rmtree(kept, ignore_errors=True)
        repeat = f"tools/torment --seed {self.seed} --only {name} --trial {number}"
        (folder / "wrong").write_text(f"{repeat}\n\n{wrong}\n")
        shutil.copytree(folder, kept, symlinks=True)
        print(f"{name} {number}: {wrong.splitlines()[0][:200]}\n  files: {kept}\n  repeat: {repeat}", file=sys.stderr,
              flush=True)

    def summary(self):
        """One line for each kind."""
        lines = [f"{name:8} {sum(counts.values()):6} trials: "
                 + ", ".join(f"{count} {outcome}" for outcome, count in sorted(counts.items()))
                 for name, counts in self.outcomes.items()]
        lines += [f"{name:8} skipped: needs {needs}" for name, needs in self.skipped.items()]
        return "\n".join([*lines, f"{self.failed} wrong"])
