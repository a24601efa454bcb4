"""Disks that fill up during a run: it fails with a message; with more space it is resumed to the same bits."""

import os
import subprocess
import tempfile

from . import scenes
from .program import FAILED, FINISHED, Wrong


def can_mount():
    with tempfile.TemporaryDirectory() as folder:
        try:
            with Disk(folder, 100):
                return True
        except subprocess.CalledProcessError:
            return False


class Disk:
    """A file system of this many kilobytes in memory, mounted on a folder. Needs root."""

    def __init__(self, folder, size):
        self.folder, self.size = folder, size

    def mount(self, *options):
        subprocess.run(["mount", "-t", "tmpfs", *options, "tmpfs", self.folder], check=True, capture_output=True)

    def enlarge(self, size):
        self.mount("-o", f"remount,size={size}k")

    def __enter__(self):
        self.mount("-o", f"size={self.size}k")
        return self

    def __exit__(self, *_):
        subprocess.run(["umount", "--lazy", self.folder], check=True, capture_output=True)


class Disks:
    SHARE = 1
    NEEDS = "root, to mount file systems"

    def __init__(self, program, work):
        self.program = program
        self.straight = scenes.straight(program, work, "simple", *scenes.EVERY_BLOCK, *scenes.RECORDED)
        results = self.straight.folder / "results"
        self.largest = sum(path.stat().st_size for path in results.rglob("*") if path.is_file()) // 1024

    @staticmethod
    def possible():
        return os.geteuid() == 0 and can_mount()

    def trial(self, random, folder):
        self.straight.copy(folder)
        (folder / "results").mkdir()
        with Disk(folder / "results", random.randint(4, self.largest)) as disk:
            ranks = random.choice((1, 2))
            job = self.program.call(folder, *self.straight.command(), ranks=ranks, allowed=(FINISHED, FAILED))
            if job.status == FINISHED:
                outcome = "large enough"
            else:
                disk.enlarge(1 << 17)
                outcome = self.go_on(folder, random.choice((1, 2, 3)))
            if self.straight.bits_of(folder) != self.straight.bits:
                raise Wrong("other bits than the straight run")
        return outcome

    def go_on(self, folder, ranks):
        job = self.program.call(folder, *self.straight.command("--resume"), ranks=ranks, allowed=(FINISHED, FAILED))
        if job.status == FINISHED:
            return "full, then resumed"
        if "leave --resume out" not in job.err:
            raise Wrong(f"does not say how to go on\n{job.text()}")
        self.program.call(folder, *self.straight.command(), ranks=ranks, allowed=(FINISHED,))
        return "full, then started again as the message says"
