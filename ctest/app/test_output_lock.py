#!/usr/bin/python3
"""One run per name and directory: a second one stops at once, and a dead one is in nobody's way."""
import contextlib
import ctypes
import fcntl
import os
import pathlib
import signal
import subprocess
import time
import unittest

import program


class OutputLock(program.TestCase):
    def start(self, *arguments):
        command = [program.PROGRAM, "run", program.deck("simple"), "--output-folder", self.output, *arguments]
        return subprocess.Popen(list(map(str, command)), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    @contextlib.contextmanager
    def held(self, name):
        """This process holds the lock, as a run on another machine would."""
        with open(self.output / f"{name}.lock", "w") as file:
            fcntl.lockf(file, fcntl.LOCK_EX)
            file.write("process 7 on a_node since today\n")
            file.flush()
            yield

    def require_refused(self, job):
        self.require_status(job, program.FAILED)
        self.assertIn("another run writes the same files", job.stderr)
        self.assertIn("process 7 on a_node since today", job.stderr)
        self.assertIn("--output-folder", job.stderr)

    def test_of_two_runs_started_at_once_one_stops(self):
        jobs = [self.start("--set", "time.duration=1000") for _ in range(2)]
        for job in jobs:
            self.addCleanup(job.communicate)
            self.addCleanup(job.kill)
        while all(job.poll() is None for job in jobs):
            time.sleep(0.05)
        refused = next(job for job in jobs if job.poll() is not None)
        said = refused.communicate()[1]
        self.assertEqual(refused.returncode, program.FAILED, said)
        self.assertRegex(said, r"simple\.lock is held by (process \d+ on \S+ since \d{4}-\d\d-\d\d|"
                               r"a process that has not said which yet)")

    def test_a_semaphore_of_a_killed_run_is_in_nobodys_way(self):
        semaphore = pathlib.Path(f"/dev/shm/sem.OMPIO_{self.output.name}.h5")  # Open MPI's name for it
        library = ctypes.CDLL(None, use_errno=True)
        library.sem_open.restype = ctypes.c_void_p
        library.sem_open(f"/{semaphore.name.removeprefix('sem.')}".encode(), os.O_CREAT, 0o600, 0)  # locked
        self.assertTrue(semaphore.exists())
        self.addCleanup(semaphore.unlink)
        job = program.run("simple", self.output, "--set", f"name={self.output.name}")
        self.require_status(job, program.FINISHED)

    def test_a_killed_run_is_in_nobodys_way(self):
        job = self.start("--set", "time.duration=1000")
        while not (self.output / "simple.h5").exists():
            self.assertIsNone(job.poll())
            time.sleep(0.05)
        job.send_signal(signal.SIGKILL)
        job.communicate()
        self.assertTrue((self.output / "simple.lock").exists())
        self.require_status(program.run("simple", self.output), program.FINISHED)
        self.assertFalse((self.output / "simple.lock").exists())

    @unittest.skipUnless(program.can_mount(), "needs a mount namespace")
    def test_ranks_that_see_another_folder_end_the_job(self):
        """Two machines with disks of their own: rank 1 has another file system at the folder."""
        other = ["unshare", "--mount", "sh", "-c", f'mount -t tmpfs none "{self.output}" && exec "$0" "$@"']
        command = [program.PROGRAM, "run", program.deck("simple"), "--output-folder", self.output]
        job = subprocess.run(list(map(str, [*program.MPIRUN, "-n", "1", *command, ":", "-n", "1", *other, *command])),
                             capture_output=True, text=True, timeout=program.TIMEOUT)
        self.require_status(job, program.FAILED)
        self.assertRegex(job.stderr, r"rank 1 on \S+ does not see .*simple\.lock, which rank 0 \(process \d+ on .* share")
        self.assertEqual(list(self.output.iterdir()), [])  # nothing stays locked

    def test_a_lock_that_is_removed_comes_back(self):
        job = self.start("--set", "time.duration=1000")
        self.addCleanup(job.communicate)
        self.addCleanup(job.kill)
        while not (self.output / "simple.h5").exists():
            self.assertIsNone(job.poll())
            time.sleep(0.05)
        lock = self.output / "simple.lock"
        lock.unlink()
        for _ in range(100):
            if lock.exists() and lock.read_text():
                break
            time.sleep(0.1)
        second = program.run("simple", self.output)
        self.require_status(second, program.FAILED)
        self.assertIn(f"is held by process {job.pid} on", second.stderr)
        self.assertIsNone(job.poll())

    def test_every_command_that_writes_is_refused(self):
        recorded = "--set", "output.surface_motion=true"
        self.require_status(program.run("simple", self.output, *recorded), program.FINISHED)
        before = program.contents(self.output / "simple.h5")
        with self.held("simple"):
            for ranks in (None, 2):
                self.require_refused(program.run("simple", self.output, ranks=ranks))
                self.require_refused(program.run("simple", self.output, "--resume", ranks=ranks))
        self.require_same(self.output / "simple.h5", before)
        with self.held("simple_modes"):
            self.require_refused(program.idiophone("modes", program.deck("simple"), "--output-folder", self.output))
        other = self.output / "other"
        other.mkdir()
        with open(other / "simple_listen.lock", "w") as file:
            fcntl.lockf(file, fcntl.LOCK_EX)
            job = program.idiophone("listen", self.output / "simple.h5", "--output-folder", other)
        self.require_status(job, program.FAILED)
        self.assertIn("another run writes the same files", job.stderr)


if __name__ == "__main__":
    unittest.main()
