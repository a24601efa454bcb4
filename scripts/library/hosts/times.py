"""Times of messages and of steps on hosts with a latency, and what `check` predicts of them."""

import contextlib
import dataclasses
import functools
import json
import math
import pathlib
import statistics
import subprocess

from library import run_facts
from library.scale import simulation

HERE = pathlib.Path(__file__).resolve().parent
HOME = HERE.parents[2]
DECK = HOME / "inputs/benchmark_plate.yaml"
FIRST = ("chrt", "--fifo", "1")  # before all other programs of the machine, so that the wall clock can be used
REAL_TIME_SHARE = pathlib.Path("/proc/sys/kernel/sched_rt_runtime_us")
PATIENCE = 120  # s


def compile_programs(folder):
    """forwarder, ping_pong and, with SimGrid, replay, in this folder."""
    for compiler, name in (("c++", "forwarder"), ("mpicxx", "ping_pong")):
        subprocess.run([compiler, "-std=c++20", "-O2", HERE / f"{name}.cpp", "-o", folder / name], check=True)
    if not simulation.missing():
        simulation.compile_replay(folder)


@contextlib.contextmanager
def whole_cores():
    """Programs at real-time priority get all of the processor. Linux gives them 95 % of each second by default."""
    share = REAL_TIME_SHARE.read_text()
    REAL_TIME_SHARE.write_text("-1")
    try:
        yield
    finally:
        REAL_TIME_SHARE.write_text(share)


@dataclasses.dataclass(eq=False)
class Size:
    """A plate of tools/benchmark, and how long it sounds."""

    name: str
    settings: dict
    samples: int

    def words(self):
        return [word for key, value in self.settings.items() for word in ("--set", f"{key}={value}")]


SIZES = (Size("1842 tet4", {}, 60),
         Size("49 923 nodes of hexahedra", {"bodies.plate.element": "hex", "bodies.plate.order": "{plane: 4, thickness: 2}",
                                            "bodies.plate.parameters.size": 0.3 / 32}, 2))


@functools.cache
def halo_bytes(program, size):
    """Of a message between two ranks in a step."""
    done = subprocess.run([program, "check", DECK, *size.words(), "-n", "2", "--json"], capture_output=True, text=True, check=True)
    return round(json.loads(done.stdout)["prediction"]["largest_part"]["halo_bytes"])


class Clock:
    """What two hosts of a network need, one rank on each."""

    def __init__(self, network, folder, program):
        self.network, self.folder, self.program = network, folder, program

    def run(self, command):
        """Its output."""
        process = self.network.start((1, 1), [*FIRST, *command], self.folder)
        try:
            status = process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            process.kill()
            status = "none: it hangs"
        if status:
            raise RuntimeError(f"status {status}\n{(self.folder / 'stderr').read_text()}")
        return (self.folder / "stdout").read_text()

    def message(self, size):
        """Latency and overhead in s, and bandwidth in bytes/s, of messages of MPI as long as those of a step."""
        lines = self.run([self.folder / "ping_pong", 0, halo_bytes(self.program, size)]).splitlines()
        (_, latency, _), (bytes_sent, longer, overhead) = (map(float, line.split()) for line in lines)
        overhead = max(overhead, 0)
        return max(latency, 2 * overhead), overhead, bytes_sent / (longer - latency)

    def step(self, size):
        """s"""
        self.run([self.program, "run", DECK, *size.words(), "--set", f"time.duration={size.samples / 44100}",
                  "--set", "output.frames_per_second=0", "--output-folder", self.folder])
        facts = run_facts.run_facts(self.program, self.folder / "benchmark_plate.h5")
        job, = facts["jobs"]
        return job["stages"]["motion"] / ((job["last_sample"] - job["first_sample"]) * facts["steps_per_sample"])

    def predicted(self, size, network):
        """`prediction` of check, and the step that SimGrid simulates, s (nan without SimGrid)."""
        cluster = simulation.Cluster("hosts", 1, network, ranks_on_host=1)
        prediction, exchanges = simulation.check([*FIRST, self.program], DECK, size.words(), 2, cluster, self.folder, others=1)
        if simulation.missing():
            return prediction, math.nan
        return prediction, simulation.step_seconds(self.folder / "replay", cluster, exchanges["motion"])

    def rows(self, rounds):
        """A row of the table for each size; medians of the rounds, in which measurements alternate."""
        found = [[(*self.message(size), self.step(size), size) for size in SIZES] for _ in range(rounds)]
        for of_size in zip(*found):
            *message, step = (statistics.median(column) for column in list(zip(*of_size))[:4])
            size = of_size[0][4]
            network = simulation.Network(*message)
            yield size.name, network, step, *self.predicted(size, network)
