"""Hosts on this machine: network namespaces that are joined by a bridge, or by a network with a latency. Needs root."""

import os
import pathlib
import secrets
import shlex
import signal
import subprocess

from library import mpi

AGENT = pathlib.Path(__file__).resolve().parent / "agent"


def ip(*words):
    subprocess.run(["ip", *map(str, words)], check=True, capture_output=True, text=True)


class Network:
    """Joined by a bridge. Use it in a with statement: hosts, their processes and the bridge end with it."""

    def __init__(self, count):
        self.mark = secrets.token_hex(2)  # names of interfaces have at most 15 letters
        self.hosts = [f"host{number}{self.mark}" for number in range(1, count + 1)]
        self.bridge = f"hosts{self.mark}"
        self.subnet = f"10.{secrets.randbelow(200) + 20}.{secrets.randbelow(250)}"

    def address(self, host):
        return f"{self.subnet}.{self.hosts.index(host) + 1}"

    def __enter__(self):
        try:
            for host in self.hosts:
                self.add(host)
            self.join()
            for host in self.hosts:
                ip("-n", host, "addr", "add", f"{self.address(host)}/24", "dev", "eth0")
                ip("-n", host, "link", "set", "eth0", "up")
        except BaseException:
            self.remove()
            raise
        return self

    def join(self):
        """Gives each host a device eth0."""
        ip("link", "add", self.bridge, "type", "bridge")
        ip("link", "set", self.bridge, "up")
        for host in self.hosts:
            ip("link", "add", f"c{host}", "type", "veth", "peer", "name", "eth0", "netns", host)
            ip("link", "set", f"c{host}", "master", self.bridge, "up")

    def add(self, host):
        ip("netns", "add", host)
        ip("-n", host, "link", "set", "lo", "up")
        names = pathlib.Path("/etc/netns") / host
        names.mkdir(parents=True)
        (names / "hosts").write_text("127.0.0.1 localhost\n" + "".join(
            f"{self.address(each)} {each}\n" for each in self.hosts))
        pathlib.Path("/tmp", host).mkdir()

    def __exit__(self, *_):
        self.remove()

    def remove(self):
        for host in self.hosts:
            self.kill(host)
            subprocess.run(["ip", "netns", "del", host], capture_output=True)
            (pathlib.Path("/etc/netns") / host / "hosts").unlink(missing_ok=True)
            for folder in (pathlib.Path("/etc/netns") / host, pathlib.Path("/tmp", host)):
                if folder.exists():
                    folder.rmdir()
        subprocess.run(["ip", "link", "del", self.bridge], capture_output=True)

    def kill(self, host):
        found = subprocess.run(["ip", "netns", "pids", host], capture_output=True, text=True).stdout
        for process in map(int, found.split()):
            try:
                os.kill(process, signal.SIGKILL)
            except ProcessLookupError:
                pass

    def lose(self, host):
        """The host loses its power: first nobody hears it any more, then its processes are gone."""
        ip("link", "set", f"c{host}", "down")
        self.kill(host)

    def start(self, ranks, command, folder, **settings):
        """Starts mpirun on the first host, with so many ranks on each host, and output in folder."""
        places = ",".join(f"{host}:{ranks_here}" for host, ranks_here in zip(self.hosts, ranks))
        launch = ["mpirun", "--mca", "plm_rsh_agent", AGENT, "--host", places, "--oversubscribe",
                  "--bind-to", "none", "--prefix", "/usr", "-n", sum(ranks)]
        for key, value in settings.items():
            launch += ["--mca", key, value]
        with open(folder / "stdout", "w") as out, open(folder / "stderr", "w") as errors:
            return subprocess.Popen([AGENT, self.hosts[0], shlex.join(map(str, (*launch, *command)))], cwd=folder,
                                    env=os.environ | mpi.ENVIRONMENT, stdout=out, stderr=errors)


class DelayedNetwork(Network):
    """Joined by forwarder.cpp: a message takes a latency (s), and its size over the bandwidth (bytes/s) of its sender."""

    def __init__(self, count, forwarder, latency, bandwidth):
        super().__init__(count)
        self.command = [forwarder, str(latency), str(bandwidth)]
        self.process = None

    def join(self):
        ends = [f"{host}={self.address(host)}" for host in self.hosts]
        self.process = subprocess.Popen([*self.command, *ends], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        if not self.process.stdout.readline():
            raise RuntimeError("the forwarder did not start")

    def remove(self):
        super().remove()
        if self.process:
            self.process.communicate()  # it ends with its input
