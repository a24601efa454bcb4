"""SIGTERM, SIGINT and SIGUSR1 at random times: each phase obeys within five seconds, and the run can be resumed."""

import signal
import time

from . import processes, scenes
from .program import FINISHED, HONOURED_WITHIN, RESUMABLE, UNDISTURBED, Wrong, judged

SIGNALS = (signal.SIGTERM, signal.SIGINT, signal.SIGUSR1)
PLATE = "bodies.plate.parameters"
PHASES = {  # arguments with which a command spends its time in a phase
    "meshing": ("run", "--set", f"{PLATE}={{side: 1, thickness: 0.02, size: 0.003, regular: 0, layers: 4}}"),
    "start": ("run", "--set", f"{PLATE}={{side: 1, thickness: 0.02, size: 0.02}}"),
    "motion": ("run", "--set", "time.duration=100"),
    "checkpoints": ("run", "--set", "time.duration=100", *scenes.EVERY_BLOCK),
    "modes": ("modes", "--modes", "40", "--set", f"{PLATE}={{side: 1, thickness: 0.02, size: 0.02}}"),
    "check": ("check", "--set", f"{PLATE}={{side: 1, thickness: 0.02, size: 0.01}}"),
}
LONGEST = 8  # s before the signal


class Interruptions:
    SHARE = 2

    def __init__(self, program, work):
        self.program = program
        self.straight = scenes.straight(program, work, "simple", *scenes.EVERY_BLOCK)

    def trial(self, random, folder):
        self.straight.copy(folder)
        phase = random.choice(("any", "any", *PHASES))
        if phase == "any":
            return self.interrupt_and_resume(random, folder)
        command, *more = PHASES[phase]
        self.interrupt(random, folder, [command, "deck.yaml", "--output-folder", "results", *more], LONGEST)
        return f"obeyed in {phase}"

    def interrupt(self, random, folder, command, longest):
        """The ended job: finished, or stopped within the time allowed."""
        ranks = random.choice((None, 2))
        number = signal.SIGUSR1 if ranks else random.choice(SIGNALS)  # mpirun itself ends the job on the others
        job = self.program.start(folder, *command, ranks=ranks)
        self.await_handlers(job, number, ranks or 1)
        time.sleep(random.uniform(0, longest))
        if job.poll() is None:
            self.program.stop(job, number)
        return judged(self.program.end(job, UNDISTURBED), (FINISHED, RESUMABLE))

    def await_handlers(self, job, number, count):
        """A signal kills the program while the system still loads it (docs/use/running.md)."""
        deadline = time.monotonic() + HONOURED_WITHIN * self.program.slowness
        while sum(processes.catches(pid, number) for pid in processes.named(job.pid, "idiophone")) < count:
            if job.poll() is not None:
                return
            if time.monotonic() > deadline:
                raise Wrong("signals are not watched")
            time.sleep(0.002)

    def interrupt_and_resume(self, random, folder):
        command = self.straight.command("--resume")
        for _ in range(random.choice((1, 2, 3))):
            if self.interrupt(random, folder, command, self.straight.seconds).status == FINISHED:
                break
        self.program.call(folder, *command, ranks=random.choice((1, 2, 3)), allowed=(FINISHED,))
        if self.straight.bits_of(folder) != self.straight.bits:
            raise Wrong("other bits than the straight run")
        return "obeyed and resumed to the same bits"
