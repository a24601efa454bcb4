"""Two runs in one folder: one is refused, or starts when the other has ended; the files are those of one run."""

import time

from . import scenes
from .program import FAILED, FINISHED, UNDISTURBED, Wrong, judged


class Pairs:
    SHARE = 1

    def __init__(self, program, work):
        self.program = program
        self.straight = scenes.straight(program, work, "simple", *scenes.EVERY_BLOCK, *scenes.RECORDED)

    def trial(self, random, folder):
        self.straight.copy(folder)
        jobs = []
        for name in ("first", "second"):
            (folder / name).mkdir()
            command = self.straight.command(*random.choice(((), ("--resume",))))
            command = [{"deck.yaml": "../deck.yaml", "results": "../results"}.get(word, word) for word in command]
            jobs.append(self.program.start(folder / name, *command, ranks=random.choice((None, 1, 2))))
            time.sleep(random.uniform(0, self.straight.seconds))
        ended = [judged(self.program.end(job, UNDISTURBED), (FINISHED, FAILED)) for job in jobs]
        refused = [job for job in ended if job.status == FAILED]
        if len(refused) == 2 or any("another run writes the same files" not in job.err for job in refused):
            raise Wrong("\n".join(job.text() for job in ended))
        if self.straight.bits_of(folder) != self.straight.bits:
            raise Wrong("other bits than the straight run")
        return "one refused" if refused else "one after the other"
