#!/usr/bin/python3
"""A run that is told to stop, or is killed, goes on later to the same bits."""
import os
import pathlib
import shutil
import signal
import subprocess
import time
import unittest

import program

EVERY_BLOCK = "--set", "output.checkpoint.every_minutes=1e-9"


def signals(name, block, rank, **more):
    return program.preload("BLOCK_SIGNAL", SIGNAL=int(name), SIGNAL_BLOCK=block, SIGNAL_RANK=rank, **more)


def checkpoints(output):
    return sorted((output / "simple_checkpoints").glob("checkpoint_*.h5"))


def children(pid, name):
    """Processes of this name that a process started."""
    found = []
    for entry in pathlib.Path(f"/proc/{pid}/task").glob("*/children"):
        try:
            found += [int(child) for child in entry.read_text().split()
                      if pathlib.Path(f"/proc/{child}/comm").read_text().strip() == name]
        except OSError:  # it has just ended
            pass
    return found


class Stopping(program.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.directory = program.tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.directory.cleanup)
        assert program.run("simple", cls.directory.name).returncode == program.FINISHED
        cls.expected = program.contents(os.path.join(cls.directory.name, "simple.h5"))

    def require_resumable(self, *arguments, ranks=2):
        job = program.run("simple", self.output, "--resume", *arguments, ranks=ranks)
        self.require_status(job, program.FINISHED)
        self.assertIn("resuming from", job.stdout)
        self.require_same(self.output / "simple.h5", self.expected)
        return job

    def test_signals_to_any_rank(self):
        for name, rank in ((signal.SIGTERM, 0), (signal.SIGINT, 1), (signal.SIGUSR1, 2), (signal.SIGXCPU, 1)):
            with self.subTest(signal=name.name, rank=rank):
                shutil.rmtree(self.output / "simple_checkpoints", ignore_errors=True)
                job = program.run("simple", self.output, ranks=3, environment=signals(name, 2, rank))
                self.require_status(job, program.RESUMABLE)
                self.assertIn(f"stopping in good order: signal {int(name)}", job.stdout)
                self.assertEqual(len(checkpoints(self.output)), 1)
                self.require_resumable()

    def test_signals_to_the_run_script(self):
        root = self.output / "tree"
        (root / "scripts").mkdir(parents=True)
        for name in ("run", "mpi_environment"):
            shutil.copy(program.SOURCE / "scripts" / name, root / "scripts")
        for name in ("build", "spectrum"):  # not what is tested here
            (root / "scripts" / name).symlink_to("/bin/true")
        program_link = root / "build" / "production" / "idiophone"
        program_link.parent.mkdir(parents=True)
        ranks_only = " ".join(f"{k}={v}" for k, v in program.preload("BLOCK_SIGNAL").items())
        program_link.write_text(f'#!/bin/sh\nexec env {ranks_only} {program.PROGRAM} "$@"\n')
        program_link.chmod(0o755)
        for name in (signal.SIGTERM, signal.SIGINT, signal.SIGUSR1):
            with self.subTest(signal=name.name):
                shutil.rmtree(self.output / "simple_checkpoints", ignore_errors=True)
                start = f"export SIGNAL={int(name)} SIGNAL_BLOCK=2 SIGNAL_PID=$$; exec {root}/scripts/run " \
                        f"{program.deck('simple')} --output-folder {self.output}"
                job = subprocess.run(["bash", "-c", start], capture_output=True, text=True, timeout=program.TIMEOUT)
                self.require_status(job, program.RESUMABLE)
                self.require_resumable()

    def endless_deck(self):
        """A deck whose meshing does not end."""
        (self.output / "endless.geo").write_text("For i In {1:1e9}\n  x = i;\nEndFor\n")
        deck = self.output / "deck.yaml"
        deck.write_text(program.deck("simple").read_text().replace("../../../meshes/square_plate.geo", "endless.geo")
                        .replace("parameters: {side", "# {side"))
        return deck

    def test_signals_while_gmsh_works(self):
        deck = self.endless_deck()
        for name in (signal.SIGTERM, signal.SIGINT, signal.SIGUSR1):
            with self.subTest(signal=name.name):
                job = subprocess.Popen([program.PROGRAM, "run", deck, "--output-folder", self.output / "results"],
                                       stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
                mesher = None
                while job.poll() is None and not mesher:
                    mesher = next(iter(children(job.pid, "idiophone_gmsh")), None)
                job.send_signal(name)
                _, said = job.communicate(timeout=5)
                self.assertEqual(job.returncode, program.RESUMABLE, said)
                self.assertIn("stopped by a signal before there was anything to save", said)
                for _ in range(100):  # the kernel ends gmsh with its parent
                    if not os.path.exists(f"/proc/{mesher}"):
                        break
                    time.sleep(0.05)
                self.assertFalse(os.path.exists(f"/proc/{mesher}"))

    def test_a_rank_that_another_one_takes_down_says_so(self):
        command = [*program.MPIRUN, "-n", "2", program.PROGRAM, "run", self.endless_deck(), "--output-folder", self.output]
        job = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        ranks, root = [], None
        while job.poll() is None and not root:
            ranks = children(job.pid, "idiophone")
            root = next((rank for rank in ranks if children(rank, "idiophone_gmsh")), None)
        os.kill(next(rank for rank in ranks if rank != root), signal.SIGKILL)
        _, said = job.communicate(timeout=60)
        self.assertIn("ended by the launcher, because another rank failed", said)
        self.assertNotIn("stopped by a signal", said)

    def test_wall_clock_limit(self):
        limit = "--set", "time.wall_clock_limit=1e-6"
        job = program.run("simple", self.output, *limit)
        self.require_status(job, program.RESUMABLE)
        self.assertIn("stopping in good order: wall-clock limit", job.stdout)

    def test_killed_rank_ends_the_job_and_the_last_checkpoint_goes_on(self):
        start = time.monotonic()
        job = program.run("simple", self.output, *EVERY_BLOCK, ranks=3, environment=signals(signal.SIGKILL, 3, 1))
        self.assertNotIn(job.returncode, (program.FINISHED, program.RESUMABLE))
        self.assertLess(time.monotonic() - start, 60)
        program.contents(self.output / "simple.h5")  # what was written opens
        self.require_resumable(*EVERY_BLOCK)

    def test_damaged_newest_checkpoint_is_skipped(self):
        program.run("simple", self.output, *EVERY_BLOCK, ranks=2, environment=signals(signal.SIGKILL, 3, 0))
        newest = checkpoints(self.output)[-1]
        self.assertGreater(len(checkpoints(self.output)), 1)
        damaged = bytearray(newest.read_bytes())
        damaged[len(damaged) // 2] ^= 0xFF
        newest.write_bytes(damaged)
        job = self.require_resumable(*EVERY_BLOCK)
        self.assertIn(f"{newest.name} refused", job.stdout + job.stderr)

    def test_lost_or_damaged_result_is_answered_with_what_to_do(self):
        limit = "--set", "time.wall_clock_limit=1e-6"
        for damage in (lambda path: path.unlink(), lambda path: os.truncate(path, path.stat().st_size // 2)):
            self.require_status(program.run("simple", self.output, *limit), program.RESUMABLE)
            damage(self.output / "simple.h5")
            job = program.run("simple", self.output, *limit, "--resume", ranks=2)
            self.require_status(job, program.FAILED)
            self.assertIn("simple.h5", job.stderr)
            self.assertIn("leave --resume out", job.stderr)


if __name__ == "__main__":
    unittest.main()
