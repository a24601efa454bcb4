"""The trials of tools/hosts_trial: jobs of several hosts beside the same job of one host."""

import os
import pathlib
import re
import shutil
import subprocess
import time

from library import mpi, result_bits

HOME = pathlib.Path(__file__).resolve().parents[3]
DECKS = HOME / "ctest/app/decks"
SIMPLE = ("simple", "--set", "bodies.plate.parameters.size=0.025", "--set", "output.surface_motion=true")
JOBS = {  # a deck, and what is changed in it
    "main": SIMPLE,
    "contact": ("collision",),
    "waves": ("simple", "--set", "radiation={model: waves, cell: 0.03}", "--set", "time.duration=0.006"),
}
PATIENCE = 120  # s
# A lost host is noticed by silence. Open MPI waits 300 s by default before it asks.
KEEPALIVE = {"oob_tcp_keepalive_time": 5, "oob_tcp_keepalive_intvl": 1, "oob_tcp_keepalive_probes": 3}


class Trials:
    def __init__(self, network, folder, program):
        self.network, self.folder, self.program = network, folder, program

    def command(self, job, name):
        deck, *changes = job
        return [self.program, "run", DECKS / f"{deck}.yaml", *changes, "--output-folder", self.place(name) / "results"]

    def place(self, name):
        place = self.folder / name
        place.mkdir(exist_ok=True)
        return place

    def bits(self, name):
        return {file.name: result_bits.digest(file) for file in sorted((self.place(name) / "results").glob("*.h5"))}

    def on_one_host(self, job, name):
        done = subprocess.run([*mpi.mpirun(2), *map(str, self.command(job, name))],
                              env=os.environ | mpi.ENVIRONMENT, capture_output=True, text=True)
        if done.returncode:
            raise RuntimeError(f"{name} on one host: status {done.returncode}\n{done.stderr}")
        return self.bits(name)

    def on_hosts(self, command, ranks, name, **settings):
        process = self.network.start(ranks, command, self.place(name), **settings)
        try:
            return process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            process.kill()
            raise RuntimeError(f"{name} hangs\n{self.said(name)}") from None

    def said(self, name):
        return "".join((self.place(name) / stream).read_text() for stream in ("stdout", "stderr"))[-4000:]

    def same(self, kind, ranks):
        """The job has the bits that it has on one host."""
        name = f"{kind}_on_{'_'.join(map(str, ranks))}"
        status = self.on_hosts(self.command(JOBS[kind], name), ranks, name)
        if status:
            raise RuntimeError(f"{name}: status {status}\n{self.said(name)}")
        expected = self.on_one_host(JOBS[kind], kind)
        return self.bits(name) == expected, f"{kind}: {' + '.join(map(str, ranks))} ranks on {len(ranks)} hosts"

    def lost(self, ranks):
        """A host vanishes: the job ends with a message, and the run is resumed to the bits of one that nothing disturbs."""
        name, job = "lost", (*SIMPLE, "--set", "time.duration=0.025", "--set", "output.checkpoint.every_minutes=0.01")
        expected = self.on_one_host(job, "undisturbed")
        process = self.network.start(ranks, self.command(job, name), self.place(name), **KEEPALIVE)
        checkpoints = self.place(name) / "results/simple_checkpoints"
        self.wait(lambda: process.poll() is not None or any(checkpoints.glob("*.h5")))
        if process.poll() is not None:
            raise RuntimeError(f"the job ends before the host is lost\n{self.said(name)}")
        self.network.lose(self.network.hosts[len(ranks) - 1])
        start = time.monotonic()
        status = process.wait(PATIENCE)
        seconds, message = time.monotonic() - start, re.search("lost communication", self.said(name))
        resumed = self.on_hosts([*self.command(job, name), "--resume"], ranks[:-1], name)
        passed = status and message and not resumed and self.bits(name) == expected
        return passed, (f"a lost host: status {status} after {seconds:.0f} s, {'with' if message else 'WITHOUT'} a message; "
                        f"resumed on {len(ranks) - 1}: status {resumed}")

    @staticmethod
    def wait(condition):
        for _ in range(20 * PATIENCE):
            if condition():
                return
            time.sleep(0.05)
        raise RuntimeError("nothing happens")

    def all(self):
        """Two hosts; one with two ranks and two with one; then one is lost."""
        for kind in JOBS:
            yield lambda kind=kind: self.same(kind, (1, 1))
        yield lambda: self.same("main", (2, 1, 1))
        yield lambda: self.lost((1, 1, 1))


def needs():
    """What is missing on this machine, if anything."""
    return next((f"{program} is missing" for program in ("ip", "unshare", "mpirun") if not shutil.which(program)), None)
