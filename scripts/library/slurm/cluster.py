"""A Slurm cluster of two nodes on this machine, in a folder of its own. Needs root."""

import os
import pathlib
import re
import secrets
import signal
import socket
import subprocess
import tempfile
import time

from library import mpi
from library.robustness import processes

NODES = ("node1", "node2")
LOST_AFTER = 10  # s without an answer of slurmd
GRACE = 20  # s between the warning and the end of a preempted job
PATIENCE = 60  # s for daemons to start
CONFIGURATION = """
ClusterName=trial
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={port}
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket,cred_expire=5
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdSpoolDir={folder}/spool_%n
SlurmdPidFile={folder}/%n.pid
SlurmdLogFile={folder}/slurmd_%n.log
TmpFS={folder}/temporary_%n
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MailProg=/bin/true
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdTimeout={lost}
KillWait=10
ReturnToService=2
SchedulerParameters=bf_interval=1,sched_interval=2
PreemptType=preempt/partition_prio
PreemptMode=REQUEUE
NodeName=node1 NodeHostname={host} NodeAddr=127.0.0.1 Port={node1} CPUs=2
NodeName=node2 NodeHostname={host} NodeAddr=127.0.0.1 Port={node2} CPUs=2
PartitionName=ordinary Nodes=node[1-2] Default=YES PriorityTier=1 GraceTime={grace}
PartitionName=sudden Nodes=node[1-2] PriorityTier=1
PartitionName=urgent Nodes=node[1-2] PriorityTier=10 PreemptMode=OFF
"""


def free_ports(count):
    sockets = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    ports = [each.getsockname()[1] for each in sockets]
    for each in sockets:
        each.close()
    return ports


class Cluster:
    """Use it in a with statement: all daemons and their jobs end with it."""

    def __init__(self, program):
        self.program = program  # path of idiophone
        self.daemons = {}  # by name

    def __enter__(self):
        self.directory = tempfile.TemporaryDirectory(prefix="slurm_trial_")
        self.folder = pathlib.Path(self.directory.name)
        self.folder.chmod(0o755)
        for name in ("state", *(f"{kind}_{node}" for kind in ("spool", "temporary") for node in NODES)):
            (self.folder / name).mkdir()
        controller, node1, node2 = free_ports(3)
        (self.folder / "slurm.conf").write_text(CONFIGURATION.format(
            folder=self.folder, host=socket.gethostname(), port=controller, node1=node1, node2=node2, lost=LOST_AFTER,
            grace=GRACE))
        self.environment = os.environ | mpi.ENVIRONMENT | {
            "SLURM_CONF": str(self.folder / "slurm.conf"), "OMPI_MCA_btl_tcp_if_include": "lo",
            "PATH": f"{self.program.parent}:{os.environ['PATH']}"}
        try:
            self.start_munge()
            self.start("slurmctld", "slurmctld", "-D")
            for node in NODES:
                self.start_node(node)
            self.await_nodes()
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        for node in NODES:
            self.kill_node(node)
        for daemon in reversed(self.daemons.values()):
            daemon.kill()
            daemon.wait()
        self.end_jobs()
        self.directory.cleanup()

    def start(self, name, *command):
        with open(self.folder / f"{name}.log", "a") as log:
            self.daemons[name] = subprocess.Popen(command, env=self.environment, stdout=log, stderr=log,
                                                  stdin=subprocess.DEVNULL, start_new_session=True)

    def start_munge(self):
        key = self.folder / "munge.key"
        key.write_bytes(secrets.token_bytes(128))
        key.chmod(0o400)
        files = {"key-file": key, **{f"{what}-file": self.folder / f"munge.{what}" for what in ("pid", "log", "seed")}}
        self.start("munge", "munged", "--foreground", "--force", f"--socket={self.folder}/munge.socket",
                   *(f"--{option}={path}" for option, path in files.items()))
        self.wait((self.folder / "munge.socket").exists, "munged does not start")

    def start_node(self, node):
        self.start(node, "slurmd", "-D", "-N", node)

    def await_nodes(self):
        self.wait(lambda: self.call("sinfo", "--noheader", "--format=%T %D", check=False).split() == ["idle", "2"],
                  "the nodes do not become idle")

    def stop_slurmd(self, node):
        """kill -9 of the node's slurmd; its jobs continue."""
        daemon = self.daemons.pop(node)
        daemon.kill()
        daemon.wait()

    def kill_node(self, node):
        """Everything on the node ends at once, as if its power failed."""
        if node in self.daemons:
            self.stop_slurmd(node)
        self.end_jobs(node)

    def end_jobs(self, node=""):
        """All stop before the first one ends, so that none can report the end of another."""
        self.signal_jobs(signal.SIGSTOP, node)
        self.signal_jobs(signal.SIGKILL, node)

    def signal_jobs(self, number, node=""):
        for pid in self.jobs_processes(node):
            processes.send(pid, number)

    def jobs_processes(self, node=""):
        """Process numbers of the job steps of a node, or of both: tasks, and the daemons slurmstepd that start them."""
        marks = [f"SLURM_CONF={self.folder}/slurm.conf", *([f"SLURMD_NODENAME={node}"] if node else [])]
        found = processes.with_environment(*marks)
        return found | {pid for pid in map(processes.parent, found) if processes.name(pid) == "slurmstepd"}

    def call(self, *command, check=True):
        """Output of one of Slurm's commands."""
        done = subprocess.run(command, env=self.environment, capture_output=True, text=True)
        if check and done.returncode != 0:
            raise RuntimeError(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
        return done.stdout

    def wait(self, condition, otherwise, seconds=PATIENCE):
        deadline = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > deadline:
                logs = "\n".join(f"{log.name}:\n{log.read_text()[-1500:]}" for log in self.folder.glob("*.log"))
                raise RuntimeError(f"{otherwise}\n{logs}")
            time.sleep(0.5)

    def submit(self, script, *arguments, options=(), folder):
        """Number of the submitted job."""
        return self.call("sbatch", "--parsable", f"--chdir={folder}", f"--output={folder}/job.log", *options, script,
                         *map(str, arguments)).strip()

    def job(self, number):
        """Slurm's values of a job, by name."""
        return dict(re.findall(r"(\w+)=(\S*)", self.call("scontrol", "show", "job", "--oneliner", number)))

    def await_state(self, number, states, seconds=300):
        self.wait(lambda: self.job(number)["JobState"] in states, f"job {number} does not become {states}", seconds)
        return self.job(number)
