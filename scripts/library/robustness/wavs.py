"""Kills, signals and full disks while WAV files are written: the sound is in the result, and the WAV file comes later."""

import os
import signal
import time

from . import processes, scenes
from .kills import kill_process
from .program import FAILED, FINISHED, RESUMABLE, UNDISTURBED, Wrong, judged

SIGNALS = (signal.SIGTERM, signal.SIGINT, signal.SIGUSR1)


class Wavs:
    SHARE = 1

    def __init__(self, program, work):
        self.program = program
        self.straight = scenes.straight(program, work, "simple", *scenes.EVERY_BLOCK)
        self.wav = self.wav_of(self.straight.folder).read_bytes()

    @staticmethod
    def wav_of(folder):
        return folder / "results" / "simple.wav"

    def trial(self, random, folder):
        self.straight.copy(folder)
        (folder / "results").mkdir()
        outcome = random.choice((self.kill, self.stop, self.fill))(random, folder, self.wav_of(folder))
        self.program.call(folder, *self.straight.command("--resume"), ranks=random.choice((1, 2, 3)),
                          allowed=(FINISHED,))
        if self.straight.bits_of(folder) != self.straight.bits:
            raise Wrong("other bits than the straight run")
        if self.wav_of(folder).read_bytes() != self.wav:
            raise Wrong("another WAV file than that of the straight run")
        if left := list((folder / "results").rglob("*.part")):
            raise Wrong(f"{left[0].name} is left behind")
        return outcome

    def start(self, folder, wav, ranks):
        """A run that waits while it writes its WAV file: nobody reads the pipe in the file's place."""
        pipe = wav.with_name(wav.name + ".part")
        os.mkfifo(pipe)
        job = self.program.start(folder, *self.straight.command(), ranks=ranks)
        deadline = time.monotonic() + UNDISTURBED * self.program.slowness
        while "share of time" not in (folder / "stdout").read_text() and job.poll() is None:
            if time.monotonic() > deadline:
                raise Wrong("no WAV file is written")
            time.sleep(0.01)
        time.sleep(0.2)
        pipe.unlink()
        return job

    def kill(self, random, folder, wav):
        job = self.start(folder, wav, random.choice((1, 2)))
        kill_process(self.program, job, random.choice(processes.named(job.pid, "idiophone") or [job.pid]))
        return "killed, then resumed"

    def stop(self, random, folder, wav):
        job = self.start(folder, wav, None)
        self.program.stop(job, random.choice(SIGNALS))
        judged(self.program.end(job, UNDISTURBED), (RESUMABLE,))
        return "obeyed, then resumed"

    def fill(self, random, folder, wav):
        wav.with_name(wav.name + ".part").symlink_to("/dev/full")
        job = self.program.call(folder, *self.straight.command(), ranks=random.choice((None, 1, 2)),
                                allowed=(FAILED,))
        if wav.name not in job.err:
            raise Wrong(f"does not name the WAV file\n{job.text()}")
        return "full, then resumed"
