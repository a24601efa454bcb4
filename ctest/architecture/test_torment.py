#!/usr/bin/python3
"""What tools/torment takes for wrong, with programs that misbehave on purpose."""
import contextlib
import io
import pathlib
import random
import sys
import tempfile
import unittest

import h5py

HOME = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(HOME / "scripts"))
from library.robustness import mutations  # noqa: E402
from library.robustness.campaign import Campaign  # noqa: E402
from library.robustness.program import Program, Wrong  # noqa: E402

HURRY = 0.05  # of the usual time limits


class Judge(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.folder = pathlib.Path(directory.name)

    def program(self, text, slowness=1):
        path = self.folder / "program"
        path.write_text(f"#!/bin/bash\n{text}\n")
        path.chmod(0o755)
        return Program(path, slowness)

    def require_wrong(self, text, reason, slowness=1):
        with self.assertRaisesRegex(Wrong, reason):
            self.program(text, slowness).call(self.folder)

    def test_accepts_sounds_and_messages(self):
        for text in ("exit 0", "exit 75", "echo full >&2; exit 1", "echo deck.yaml:3:4: no >&2; exit 2"):
            self.program(text).call(self.folder)

    def test_signals_and_other_statuses_are_wrong(self):
        for text in ("kill -SEGV $$", "kill -ABRT $$", "exit 3", "exit 139"):
            self.require_wrong(text, "status")

    def test_failures_have_a_message_and_a_place(self):
        self.require_wrong("exit 1", "no message")
        self.require_wrong("exit 2", "no message")
        self.require_wrong("echo the deck is wrong >&2; exit 2", "without file:line:column")

    def test_reports_of_checkers_and_libraries_are_wrong(self):
        for text in ("ERROR: AddressSanitizer: x", "a.cpp:1:2: runtime error: x", "[0]PETSC ERROR: x", "HDF5-DIAG: x"):
            self.require_wrong(f"echo '{text}' >&2; exit 1", "in the output")

    def test_a_program_that_obeys_a_signal_does_not_hang(self):
        job = self.program("trap 'exit 75' USR1\nwhile :; do sleep 0.01; done", HURRY).call(self.folder)
        self.assertTrue(job.told_to_stop)
        self.require_wrong("trap '' USR1\nwhile :; do sleep 0.01; done", "hangs", HURRY)

    def test_numbers_that_are_not_finite_are_wrong(self):
        result = self.folder / "result.h5"
        for value, wrong in ((1.0, False), (float("nan"), True), (float("inf"), True)):
            with h5py.File(result, "w") as file:
                file["audio/ear"] = [0.0, value]
            with self.assertRaisesRegex(Wrong, "not finite") if wrong else contextlib.nullcontext():
                self.program("").bits(result)

    def test_a_failed_trial_is_kept_with_its_repetition(self):
        campaign = Campaign(self.program("echo broken >&2; kill -SEGV $$"), 7, self.folder / "kept")
        with contextlib.redirect_stderr(io.StringIO()) as said:
            campaign.run_once(["decks"], 3)
        self.assertEqual(campaign.failed, 1)
        self.assertIn("tools/torment --seed 7 --only decks --trial 3", said.getvalue())
        kept = self.folder / "kept/7_decks_3"
        self.assertIn("broken", (kept / "wrong").read_text())
        self.assertTrue((kept / "deck.yaml").exists())
        self.assertIn("1 trials: 1 WRONG", campaign.summary())


class Mutations(unittest.TestCase):
    def test_are_those_of_the_seed(self):
        deck = (HOME / "ctest/app/decks/rich.yaml").read_text()
        for seed in range(200):
            texts = [mutations.text(random.Random(seed), deck, [deck]) for _ in range(2)]
            self.assertEqual(*texts)
            data = [mutations.damaged(random.Random(seed), deck.encode()) for _ in range(2)]
            self.assertEqual(*data)

    def test_change_most_texts(self):
        deck = (HOME / "ctest/app/decks/rich.yaml").read_text()
        changed = sum(mutations.text(random.Random(seed), deck, ["new: line\n"]) != deck for seed in range(200))
        self.assertGreater(changed, 180)

    def test_bear_empty_files(self):
        for seed in range(200):
            mutations.text(random.Random(seed), "")
            mutations.damaged(random.Random(seed), b"")


if __name__ == "__main__":
    unittest.main()
