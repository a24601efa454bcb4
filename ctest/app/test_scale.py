#!/usr/bin/python3
"""tools/simulate_scale: steps of ranks on a cluster, simulated with SimGrid."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

import program

sys.path.insert(0, str(program.SOURCE / "scripts"))
from library.scale import simulation

FAR = simulation.Network(latency=22e-6, overhead=1e-6, bandwidth=1e9)  # 20 µs on the way
CLUSTER = simulation.Cluster("two hosts", 1, FAR, ranks_on_host=1)


def steps(computing, full_wait, bytes_sent=1, inner=4e-6):
    """Of two ranks."""
    return {"steps_per_full_wait": full_wait, "ranks": [
        {"computing_seconds": time, "inner_seconds": inner, "received": [[1 - rank, bytes_sent]]}
        for rank, time in enumerate(computing)]}


@unittest.skipIf(simulation.missing(), simulation.missing())
class Scale(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.replay = simulation.compile_replay(pathlib.Path(cls.folder.name))

    def require_step(self, expected, described):
        self.assertAlmostEqual(simulation.step_seconds(self.replay, CLUSTER, described) / expected, 1, delta=1e-3)

    def test_two_ranks_take_what_their_messages_take(self):
        self.require_step(28e-6, steps((10e-6, 10e-6), 0))  # 6 before it sends, 2 for the messages, 20 on the way
        self.require_step(30e-6, steps((10e-6, 10e-6), 2))  # 4 after every second message cannot be hidden
        self.require_step(38e-6, steps((10e-6, 10e-6), 0, bytes_sent=10000))
        self.require_step(102e-6, steps((100e-6, 100e-6), 0, inner=50e-6))  # the messages are hidden
        self.require_step(33e-6, steps((10e-6, 20e-6), 0))  # what waits for the slower one is late itself

    def test_check_agrees_with_the_simulation(self):
        job = subprocess.run([program.SOURCE / "tools/simulate_scale", program.deck("simple"), "--program",
                              program.PROGRAM, "--ranks", "4", "--cluster", "ethernet", "--ranks-on-host", "1"],
                             capture_output=True, text=True)
        self.assertEqual(job.returncode, 0, job.stderr)
        *_, ratio, _, _ = [cell.strip() for cell in job.stdout.splitlines()[-1].strip("|").split("|")]
        self.assertAlmostEqual(float(ratio), 1, delta=0.15, msg=job.stdout)


if __name__ == "__main__":
    unittest.main()
