"""Steps of many ranks on clusters, simulated with SimGrid (replay.cpp) from what `check --exchanges` writes."""

import dataclasses
import json
import math
import pathlib
import shutil
import subprocess

HERE = pathlib.Path(__file__).resolve().parent
AT_LEAST = 64  # steps that count, in whole periods; in each, ranks wait once before they compute


def missing():
    """What this machine lacks, if anything."""
    if not pathlib.Path("/usr/include/simgrid/s4u.hpp").exists():
        return "SimGrid is missing: scripts/install_dependencies libsimgrid-dev"
    return None if shutil.which("c++") else "c++ is missing: scripts/install_dependencies g++"


def compile_replay(folder):
    program = folder / "replay"
    subprocess.run(["c++", "-std=c++20", "-O1", HERE / "replay.cpp", "-lsimgrid", "-o", program], check=True)
    return program


@dataclasses.dataclass(frozen=True)
class Network:
    """As include/idiophone/study/advice/network.hpp."""

    latency: float  # of a message, s
    overhead: float  # of it, processor time at each end, s
    bandwidth: float  # of a host, bytes/s


@dataclasses.dataclass(frozen=True)
class Cluster:
    name: str
    levels: int  # of switches: 1 is one switch, 2 a fat tree
    between_hosts: Network
    in_host: Network = Network(4e-7, 2e-7, 1e10)
    ranks_on_host: int = 32
    hosts_on_switch: int = 16  # where there are two levels

    def network_words(self):
        """For `check`."""
        network = self.between_hosts
        return ["--latency", str(network.latency), "--overhead", str(network.overhead),
                "--bandwidth", str(network.bandwidth), "--ranks-on-host", str(self.ranks_on_host)]


CLUSTERS = {cluster.name: cluster for cluster in (
    Cluster("fat-tree", 2, Network(1.5e-6, 3e-7, 12.5e9)),  # 100 Gbit/s
    Cluster("ethernet", 1, Network(20e-6, 4e-6, 1.25e9)))}  # 10 Gbit/s, TCP


def numbers(cluster, steps):
    """The input of replay."""
    yield from (cluster.ranks_on_host, cluster.levels, cluster.hosts_on_switch)
    yield from (*dataclasses.astuple(cluster.between_hosts), *dataclasses.astuple(cluster.in_host))
    full_wait = steps["steps_per_full_wait"]
    period = max(1, full_wait)
    yield from (2 * math.ceil(AT_LEAST / period) * period, full_wait, len(steps["ranks"]))
    for rank in steps["ranks"]:
        yield from (rank["computing_seconds"], rank["inner_seconds"], len(rank["received"]))
        for message in rank["received"]:
            yield from message


def step_seconds(replay, cluster, steps):
    """The mean time of a step, s.

    steps: `motion` or `waves` of the file of `check --exchanges`
    """
    done = subprocess.run([replay, "--log=root.thresh:error"], input=" ".join(map(repr, numbers(cluster, steps))),
                          capture_output=True, text=True)
    if done.returncode:
        raise RuntimeError(f"replay: status {done.returncode}\n{done.stderr}")
    return float(done.stdout)


@dataclasses.dataclass
class Point:
    """Steps of a number of ranks, s."""

    ranks: int
    one_rank: float
    busiest: float  # what the busiest rank computes
    predicted: float  # by check
    simulated: float

    @property
    def speed_up(self):
        return self.one_rank / self.simulated


def check(program, deck, words, ranks, cluster, folder, others=0):
    """`prediction` of check, and what it writes for --exchanges.

    program: the words that start it
    others: programs that check the same beside, so that as many cores are busy as in a run
    """
    exchanges = folder / "exchanges.json"
    command = [*program, "check", deck, *words, "-n", str(ranks), *cluster.network_words(), "--json"]
    beside = [subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) for _ in range(others)]
    done = subprocess.run([*command, "--exchanges", exchanges], capture_output=True, text=True)
    for other in beside:
        other.wait()
    if done.returncode:
        raise RuntimeError(f"check -n {ranks}: {done.stderr}")
    return json.loads(done.stdout)["prediction"], json.loads(exchanges.read_text())


def points(replay, cluster, prediction, exchanges):
    """A Point for the motion, and one for waves, if there are any: (name, point)."""
    for name, facts in (("motion", prediction), ("waves", prediction["waves"])):
        if facts:
            steps = exchanges[name]
            yield name, Point(len(steps["ranks"]), facts["speed_up"] * facts["step_seconds"],
                              max(rank["computing_seconds"] for rank in steps["ranks"]), facts["step_seconds"],
                              step_seconds(replay, cluster, steps))
