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
            kill_one(self.program, random, folder, straight.command("--resume"), 1.2 * straight.seconds)
        self.program.call(folder, *straight.command("--resume"), ranks=random.choice(RANKS), allowed=(FINISHED,))
        if straight.bits_of(folder) != straight.bits:
            raise Wrong("other bits than the straight run")
        return "resumed to the same bits"


def kill_one(program, random, folder, command, longest):
    """Starts a command and kills one of its processes after at most this many seconds."""
    ranks = random.choice(RANKS)
    victim, delay = random.randrange(ranks + 1), random.uniform(0, longest)
    job = program.start(folder, *command, ranks=ranks)
    time.sleep(delay)
    found = processes.named(job.pid, "idiophone")
    kill_process(program, job, found[victim] if victim < len(found) else job.pid)


def kill_process(program, job, pid):
    """kill -9 of a process of a job: the others end soon."""
    processes.send(pid, signal.SIGKILL)
    gone = processes.ended(job.pid, GONE_WITHIN * program.slowness)
    program.end(job, PATIENCE)
    if not gone:
        raise Wrong(f"processes remained {GONE_WITHIN * program.slowness:g} s after a kill")
