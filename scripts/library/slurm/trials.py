"""The trials of tools/slurm_trial. Each submits scripts/job.slurm and compares the bits with a straight run."""

import json
import pathlib
import signal
import subprocess
import time

from library import mpi, result_bits

from .cluster import GRACE, LOST_AFTER

HOME = pathlib.Path(__file__).resolve().parents[3]
SCRIPT = HOME / "scripts/job.slurm"
LIMIT = 50  # s before the end of a minute's job that it gets its signal


class Trials:
    def __init__(self, cluster, folder, seconds):
        """folder: for all results; seconds: that the straight run computes after its start, about."""
        self.cluster, self.folder = cluster, folder
        pilot = 0.02  # s of sound
        self.run(self.deck(pilot), folder / "pilot")
        self.arguments = self.deck(pilot * seconds / self.jobs("pilot")[0]["elapsed"])
        self.seconds = self.run(self.arguments, folder / "straight")
        self.bits = self.bits_of(folder / "straight")

    @staticmethod
    def deck(duration):
        """Arguments of a run with this much sound, s."""
        return [HOME / "ctest/app/decks/simple.yaml", "--set", f"time.duration={duration:.3f}",
                "--set", "bodies.plate.parameters.size=0.02", "--set", "output.frames_per_second=0",
                "--set", "output.checkpoint.every_minutes=0.03"]

    def run(self, deck, results):
        """Seconds of a straight run on two ranks."""
        start = time.monotonic()
        subprocess.run([*mpi.mpirun(2), self.cluster.program, "run", *deck, "--output-folder", results], check=True,
                       env=self.cluster.environment, stdout=subprocess.DEVNULL)
        return time.monotonic() - start

    def bits_of(self, results):
        return result_bits.digest(results / "simple.h5")

    def submit(self, name, *options, tasks=2):
        results = self.folder / name
        results.mkdir(exist_ok=True)
        options = [f"--ntasks={tasks}", "--time=10", *options]
        return self.cluster.submit(SCRIPT, *self.arguments, "--output-folder", results, options=options, folder=results)

    def computes(self, number, name):
        """Waits until the job has written a checkpoint."""
        self.cluster.await_state(number, ("RUNNING",))
        checkpoints = self.folder / name / "simple_checkpoints"
        seen = set(checkpoints.glob("*.h5"))
        self.cluster.wait(lambda: set(checkpoints.glob("*.h5")) - seen or self.cluster.job(number)["JobState"] != "RUNNING",
                          f"job {number} writes no checkpoint")
        if (state := self.cluster.job(number)["JobState"]) != "RUNNING":
            raise RuntimeError(f"job {number} is {state} too early; --seconds makes it longer")

    def conclude(self, name, number):
        """Waits for the end; one line about the trial."""
        self.cluster.await_state(number, ("COMPLETED",), seconds=300 + 5 * self.seconds)
        same = self.bits_of(self.folder / name) == self.bits
        ranks = [str(job["ranks"]) for job in self.jobs(name)]
        restarts = self.cluster.job(number)["Restarts"]
        text = f"{name}: {len(ranks)} starts on {', '.join(ranks)} tasks, {restarts} by requeue"
        return same and len(ranks) > 1, f"{text}, {'the same bits' if same else 'OTHER BITS'}"

    def jobs(self, name):
        facts = subprocess.run([self.cluster.program, "info", "--json", self.folder / name / "simple.h5"], check=True,
                               env=self.cluster.environment, capture_output=True, text=True).stdout
        return json.loads(facts)["run"]["jobs"]

    def time_limit(self):
        """The job gets SIGUSR1 before its time limit, writes a checkpoint and requeues itself."""
        number = self.submit("time_limit", "--time=1", f"--signal=USR1@{LIMIT}")
        return self.conclude("time_limit", number)

    def requeued(self):
        """An administrator requeues the job, without a warning to it."""
        number = self.submit("requeued")
        self.computes(number, "requeued")
        self.cluster.call("scontrol", "requeue", number)
        return self.conclude("requeued", number)

    def preempted_with_grace(self):
        """Slurm warns the job before an urgent one takes its nodes."""
        return self.preempted("preempted_with_grace", "ordinary")

    def preempted_at_once(self):
        """An urgent job takes the nodes without a warning."""
        return self.preempted("preempted_at_once", "sudden")

    def preempted(self, name, partition):
        number = self.submit(name, f"--partition={partition}")
        self.computes(number, name)
        urgent = self.cluster.call("sbatch", "--parsable", "--partition=urgent", "--nodes=2", "--exclusive",
                                   "--output=/dev/null", "--wrap=sleep 3").strip()
        self.cluster.await_state(urgent, ("COMPLETED",), seconds=60 + GRACE)
        return self.conclude(name, number)

    def slurmd_restarted(self):
        """slurmd is killed and started again: the job does not notice. It has a task on each node."""
        name = "slurmd_restarted"
        number = self.submit(name, "--nodes=2")
        self.computes(number, name)
        self.cluster.stop_slurmd("node2")
        time.sleep(2)
        self.cluster.start_node("node2")
        self.computes(number, name)
        self.cluster.call("scancel", "--signal=USR1", number)  # it requeues itself
        return self.conclude(name, number)

    def node_lost(self):
        """A node fails with all of its processes: Slurm requeues the job on the other one."""
        number = self.submit("node_lost", "--nodes=1")
        self.computes(number, "node_lost")
        node = self.cluster.job(number)["NodeList"]
        self.cluster.kill_node(node)
        time.sleep(LOST_AFTER)
        passed, line = self.conclude("node_lost", number)
        self.cluster.start_node(node)
        self.cluster.await_nodes()
        return passed, line

    def node_hangs(self):
        """A node hangs for a while: the lock refuses the requeued job on the other node. Submitted again, it continues."""
        name = "node_hangs"
        number = self.submit(name, "--nodes=1")
        self.computes(number, name)
        node = self.cluster.job(number)["NodeList"]
        self.cluster.stop_slurmd(node)
        self.cluster.signal_jobs(signal.SIGSTOP, node)
        self.cluster.await_state(number, ("FAILED",))
        if "another run writes the same files" not in (self.folder / name / "job.log").read_text():
            return False, f"{name}: the requeued job is not refused"
        self.cluster.signal_jobs(signal.SIGCONT, node)
        self.cluster.start_node(node)
        self.cluster.wait(lambda: not self.cluster.jobs_processes(node), "the tasks do not end")
        self.cluster.await_nodes()
        return self.conclude(name, self.submit(name))

    def other_number_of_tasks(self):
        """scancel stops the job with a checkpoint; submitted again, it continues on another number of tasks."""
        name = "other_number_of_tasks"
        for tasks in (2, 3):
            number = self.submit(name, tasks=tasks)
            self.computes(number, name)
            self.cluster.call("scancel", number)
            self.cluster.await_state(number, ("CANCELLED",))
            self.cluster.await_nodes()
        return self.conclude(name, self.submit(name, tasks=1))


ALL = (Trials.time_limit, Trials.requeued, Trials.preempted_with_grace, Trials.preempted_at_once,
       Trials.slurmd_restarted, Trials.node_hangs, Trials.node_lost, Trials.other_number_of_tasks)
