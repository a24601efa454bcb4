"""Damaged checkpoints, results and recordings: what is resumed or read has the right bits, or a message says why not."""

import shutil

from . import mutations, scenes
from .program import FAILED, FINISHED, RESUMABLE, Wrong

STOP = ("--set", "time.wall_clock_limit=1e-6")  # each job ends after its first block
JOBS = 3  # before the damage


class Damage:
    SHARE = 3

    def __init__(self, program, work):
        self.program = program
        self.straight = scenes.straight(program, work, "simple", *scenes.RECORDED)
        self.stopped = work / "stopped"
        self.stopped.mkdir()
        self.straight.copy(self.stopped)
        for _ in range(JOBS):
            self.call(self.stopped, *STOP, "--resume", allowed=(RESUMABLE,))
        self.reading = [("info",), ("info", "--json"), ("analyze",), ("listen",)]
        verify = program.call(work, "info", "--verify", self.straight.files(self.straight.folder)[0],
                              allowed=(FINISHED, 109))
        self.verifies = verify.status == FINISHED

    def call(self, folder, *more, ranks=1, allowed=(FINISHED, FAILED)):
        return self.program.call(folder, *self.straight.command(*more), ranks=ranks, allowed=allowed)

    def trial(self, random, folder):
        return random.choice((self.resume, self.read))(random, folder)

    def resume(self, random, folder):
        """Resumes a stopped run of which files are damaged."""
        shutil.copytree(self.stopped, folder, dirs_exist_ok=True)
        for _ in range(random.choice((1, 1, 2))):
            damage(random, folder / "results", "*")
        for _ in range(20):
            job = self.call(folder, *STOP, "--resume", ranks=random.choice((1, 2)),
                            allowed=(FINISHED, FAILED, RESUMABLE))
            if job.status == FAILED:
                return "resume refused"
            if job.status == FINISHED:
                break
        if self.straight.bits_of(folder) != self.straight.bits:
            raise Wrong("resumed to other bits than the straight run")
        return "resumed to the same bits"

    def read(self, random, folder):
        """Reads a damaged result or recording."""
        shutil.copytree(self.straight.folder, folder, dirs_exist_ok=True)
        file = damage(random, folder / "results", "*.h5")
        if self.verifies:
            job = self.program.call(folder, "info", "--verify", file, allowed=(FINISHED, FAILED))
            if job.status == FINISHED and self.straight.bits_of(folder) != self.straight.bits:
                raise Wrong(f"info --verify takes a damaged file for sound\n{job.text()}")
        job = self.program.call(folder, *random.choice(self.reading), file, allowed=(FINISHED, FAILED, 2))
        return "read" if job.status == FINISHED else "reading refused"


def damage(random, folder, pattern):
    """Damages one file below a folder, and returns it."""
    file = random.choice(sorted(path for path in folder.rglob(pattern) if path.is_file()))
    file.write_bytes(mutations.damaged(random, file.read_bytes()))
    return file
