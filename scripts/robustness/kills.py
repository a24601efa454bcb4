"""kill -9 of ranks and of mpirun at random times; resumed on other numbers of ranks, the bits are those of a straight run."""

import signal
import time

from . import processes, scenes
from .program import FINISHED, PATIENCE, Wrong

DECKS = ("simple", "rich", "touching", "hexahedra")
RANKS = (1, 2, 3)
GONE_WITHIN = 10  # s from a kill to the end of all ranks


class Kills:
    SHARE = 3

    def __init__(self, program, work):
        self.program = program
        arguments = *scenes.EVERY_BLOCK, *scenes.RECORDED
        self.straight = [scenes.straight(program, work, name, *arguments) for name in DECKS]

    def trial(self, random, folder):
        straight = random.choice(self.straight)
        straight.copy(folder)
        for _ in range(random.choice((1, 2, 3))):
            self.kill(random, folder, straight)
        self.program.call(folder, *straight.command("--resume"), ranks=random.choice(RANKS), allowed=(FINISHED,))
        if straight.bits_of(folder) != straight.bits:
            raise Wrong("other bits than the straight run")
        return "resumed to the same bits"

    def kill(self, random, folder, straight):
        """Starts or resumes the run and kills one of its processes."""
        ranks = random.choice(RANKS)
        victim, delay = random.randrange(ranks + 1), random.uniform(0, 1.2 * straight.seconds)
        job = self.program.start(folder, *straight.command("--resume"), ranks=ranks)
        time.sleep(delay)
        found = processes.named(job.pid, "idiophone")
        processes.send(found[victim] if victim < len(found) else job.pid, signal.SIGKILL)
        gone = processes.ended(job.pid, GONE_WITHIN * self.program.slowness)
        self.program.end(job, PATIENCE)
        if not gone:
            raise Wrong(f"processes remained {GONE_WITHIN * self.program.slowness:g} s after a kill")
