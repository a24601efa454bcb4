#!/usr/bin/python3
"""Calls that change files, and large allocations, fail on one rank: the job ends in time with a message, and nothing is lost.

Short lets a few calls fail. Long lets the first call from each place in the program fail in turn, or each tenth of all calls by
IDIOPHONE_EVERY=10.
"""
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

import launcher
import program

RANKS = 2
PATIENCE = 600  # s: a job takes one or two on an idle machine, and a minute on a busy one
LARGE = 1 << 16  # bytes, of allocations that fail
HARM = re.compile(r"received signal|terminate called|exited on signal|Assertion|PETSC ERROR|HDF5-DIAG|free\(\)|Bus error")
RECORDED = "--set", "output.surface_motion=true", "--set", "output.checkpoint.every_minutes=1e-9"
COMMANDS = {"run": ["run", *RECORDED], "resume": ["run", *RECORDED, "--resume"], "map": ["map", "--modes", "3"],
            "radiate": ["radiate", "--modes", "1"]}
FILES = {"run": ("simple.h5", "simple_surface.h5"), "map": ("simple_plate.map.h5",), "radiate": ("simple_radiation.h5",)}


def call(command, folder, ranks=RANKS, patience=PATIENCE, **failing):
    """Calls a command whose environment has FAILING_..., and must not hang."""
    environment = program.preload("FAILING_CALLS", **failing) if failing else {}
    start = [*program.MPIRUN, "-n", str(ranks)]
    for key, value in environment.items():
        start += ["-x", f"{key}={value}"]
    name, *arguments = COMMANDS[command]
    return launcher.call([*start, program.PROGRAM, name, program.deck("simple"), "--output-folder", folder, *arguments], patience)


class FailingCalls(program.TestCase):
    @classmethod
    def setUpClass(cls):
        work = tempfile.TemporaryDirectory()
        cls.addClassCleanup(work.cleanup)
        cls.work = pathlib.Path(work.name)
        cls.folder = cls.work / "folder"
        cls.made = {}

    def before(self, command):
        """A folder with what was there before the call that fails, and the bits that it must have in the end."""
        if command not in self.made:
            self.made[command] = self.make(command, self.work / command)
        return self.made[command]

    def make(self, command, straight):
        if command == "resume":
            _, bits = self.before("run")
            stop = program.preload("BLOCK_SIGNAL", SIGNAL=10, SIGNAL_BLOCK=3, SIGNAL_RANK=0)
            self.require_status(program.run("simple", straight, *RECORDED, ranks=RANKS, environment=stop), program.RESUMABLE)
            return straight, bits
        self.require_status(call(command, straight), program.FINISHED)
        bits = {name: program.contents(straight / name) for name in FILES[command]}
        return (None if command == "run" else straight), bits

    def begin(self, command):
        """Puts into the folder what was there before."""
        there, bits = self.before(command)
        shutil.rmtree(self.folder, ignore_errors=True)
        if there:
            shutil.copytree(there, self.folder)
        return bits

    def kind(self, rank, what):
        return {"FAILING_RANK": rank, **({"FAILING_FOLDER": self.folder} if what == "files" else {"FAILING_BYTES": LARGE})}

    def calls_to_fail(self, command, rank, what):
        """The numbers of the calls that shall fail."""
        self.begin(command)
        job = call(command, self.folder, **self.kind(rank, what))
        self.require_status(job, program.FINISHED)
        number, first_ones = re.search(r"(\d+) calls can fail; the first from their places:(.*)", job.stdout).groups()
        if every := os.environ.get("IDIOPHONE_EVERY"):
            return range(1, int(number) + 1, int(every))
        return [int(word) for word in first_ones.split()]

    def require_answer(self, job):
        self.assertIn(job.returncode, (program.FINISHED, program.FAILED), job.stdout + job.stderr)
        self.assertIsNone(HARM.search(job.stdout + job.stderr), job.stdout + job.stderr)
        if job.returncode == program.FAILED:
            self.assertIn("idiophone: ", job.stderr)

    def fail_one(self, command, rank, what, number):
        """Lets a call fail, and then finishes the work."""
        bits = self.begin(command)
        job = call(command, self.folder, FAILING_CALL=number, **self.kind(rank, what))
        self.require_answer(job)
        if command in ("map", "radiate"):
            self.require_bits(bits)  # those of before, or new ones
        elif job.returncode == program.FINISHED:
            self.require_bits(bits)
        else:
            self.go_on(bits)

    def require_bits(self, bits):
        for name, expected in bits.items():
            self.require_same(self.folder / name, expected)

    def go_on(self, bits):
        job = call("resume", self.folder)
        if job.returncode != program.FINISHED and "leave --resume out" in job.stderr:
            self.assertFalse(list(self.folder.glob("*_checkpoints/checkpoint_*.h5")), job.stderr)
            job = call("run", self.folder)
        self.require_status(job, program.FINISHED)
        self.require_bits(bits)


class Short(FailingCalls):
    def test_files(self):
        for command, rank, number in (("run", 0, 165), ("resume", 1, 100), ("map", 0, 20)):
            with self.subTest(command=command, rank=rank, number=number):
                self.fail_one(command, rank, "files", number)

    def test_memory(self):
        self.fail_one("run", 0, "memory", 66)

    @unittest.skipUnless(program.can_mount(), "may not mount file systems")
    def test_a_disk_with_one_free_page(self):
        """A job alone and one of two ranks on a tmpfs that has room for the lock and nothing else."""
        bits = self.begin("run")
        script = 'mount -t tmpfs -o size=$((3 * 4096)) tmpfs "$1" && shift && exec "$@"'
        for ranks in 1, 2:
            self.folder.mkdir(exist_ok=True)
            job = subprocess.run(["unshare", "--mount", "bash", "-c", script, "bash", self.folder, *program.MPIRUN, "-n", str(ranks),
                                  program.PROGRAM, "run", program.deck("simple"), "--output-folder", self.folder, *RECORDED],
                                 capture_output=True, text=True, timeout=PATIENCE)
            self.require_status(job, program.FAILED)
            self.require_answer(job)
        self.go_on(bits)


@program.long_verification
class Long(FailingCalls):
    def test_a_file_that_ranks_cannot_close(self):
        """MPI has a second file for each rank. If it is missing on one, this rank and the others wait in different calls as
        they close the file."""
        bits = self.begin("run")
        job = call("run", self.folder, patience=400, FAILING_CALL=1, FAILING_NAME=".data.", **self.kind(1, "files"))
        self.require_status(job, program.FAILED)
        self.assertIn("not all ranks have closed it", job.stderr)
        self.go_on(bits)

    def test_each(self):
        for command in COMMANDS:
            for rank in range(RANKS):
                for what in "files", "memory":
                    numbers = self.calls_to_fail(command, rank, what)
                    print(f"{command}, rank {rank}, {what}: {len(numbers)} calls", flush=True)
                    for number in numbers:
                        with self.subTest(command=command, rank=rank, what=what, number=number):
                            self.fail_one(command, rank, what, number)


if __name__ == "__main__":
    unittest.main()
