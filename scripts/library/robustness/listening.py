"""`listen` that is killed, stopped or has no room: called again, it gives what an undisturbed one gives."""

import signal
import time

from . import scenes
from .disks import Disk, Disks
from .kills import kill_one
from .program import FAILED, FINISHED, RESUMABLE, UNDISTURBED, Wrong, judged

SIGNALS = (signal.SIGTERM, signal.SIGINT, signal.SIGUSR1)


class Listening:
    SHARE = 1

    def __init__(self, program, work):
        self.program = program
        straight = scenes.straight(program, work, "simple", *scenes.EVERY_BLOCK, *scenes.RECORDED)
        self.command = ("listen", straight.files(straight.folder)[1], "--output-folder", "results")
        heard = work / "heard"
        heard.mkdir()
        start = time.monotonic()
        program.call(heard, *self.command, allowed=(FINISHED,))
        self.seconds = time.monotonic() - start
        self.expected = self.heard_in(heard)
        self.largest = sum(path.stat().st_size for path in (heard / "results").iterdir()) // 1024
        self.ways = (self.kill, self.stop, self.fill) if Disks.possible() else (self.kill, self.stop)

    def heard_in(self, folder):
        results = folder / "results"
        return self.program.bits(results / "simple_listen.h5"), (results / "simple_listen.wav").read_bytes()

    def trial(self, random, folder):
        (folder / "results").mkdir()
        return random.choice(self.ways)(random, folder)

    def again(self, random, folder):
        self.program.call(folder, *self.command, ranks=random.choice((1, 2, 3)), allowed=(FINISHED,))
        if self.heard_in(folder) != self.expected:
            raise Wrong("another sound than that of an undisturbed listen")
        if left := list((folder / "results").rglob("*.part")):
            raise Wrong(f"{left[0].name} is left behind")

    def kill(self, random, folder):
        kill_one(self.program, random, folder, self.command, 2 * self.seconds)
        self.again(random, folder)
        return "killed, then heard"

    def stop(self, random, folder):
        job = self.program.start(folder, *self.command)
        time.sleep(random.uniform(0.15, max(self.seconds, 0.2)))  # before, the system still loads it (docs/use/running.md)
        if job.poll() is None:
            self.program.stop(job, random.choice(SIGNALS))
        judged(self.program.end(job, UNDISTURBED), (FINISHED, RESUMABLE))
        self.again(random, folder)
        return "stopped, then heard"

    def fill(self, random, folder):
        with Disk(folder / "results", random.randint(4, self.largest)) as disk:
            job = self.program.call(folder, *self.command, ranks=random.choice((None, 1, 2)),
                                    allowed=(FINISHED, FAILED))
            disk.enlarge(1 << 17)
            self.again(random, folder)
        return "large enough" if job.status == FINISHED else "full, then heard"
