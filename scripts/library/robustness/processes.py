"""What runs on this machine, from /proc."""

import os
import pathlib
import re
import signal
import time

STAT = re.compile(r"\d+ \((.*)\) (\S) (.*)", re.DOTALL)


def stat(pid):
    """Name, state, and the numbers after them in /proc/PID/stat; an ended process has no name."""
    try:
        name, state, fields = STAT.match(pathlib.Path(f"/proc/{pid}/stat").read_text()).groups()
    except OSError:
        return "", "Z", [0] * 3
    return name, state, fields.split()


def name(pid):
    return stat(pid)[0]


def parent(pid):
    return int(stat(pid)[2][0])


def everything():
    """All process numbers."""
    return [int(entry.name) for entry in pathlib.Path("/proc").iterdir() if entry.name.isdigit()]


def of_session(session):
    """Process numbers; zombies are left out."""
    found = set()
    for pid in everything():
        _, state, numbers = stat(pid)
        if state != "Z" and int(numbers[2]) == session:
            found.add(pid)
    return found


def with_environment(*settings):
    """Numbers of the processes that were started with these NAME=VALUE."""
    found = set()
    for pid in everything():
        try:
            environment = pathlib.Path(f"/proc/{pid}/environ").read_bytes().decode(errors="replace").split("\0")
        except OSError:
            continue
        if all(setting in environment for setting in settings):
            found.add(pid)
    return found


def named(session, wanted):
    return sorted(pid for pid in of_session(session) if name(pid) == wanted)


def send(pid, number):
    """Sends a signal, unless the process has just ended."""
    try:
        os.kill(pid, number)
    except ProcessLookupError:
        pass


def kill_session(session):
    for pid in of_session(session):
        send(pid, signal.SIGKILL)


def catches(pid, number):
    """Whether a process has a handler for this signal."""
    try:
        status = pathlib.Path(f"/proc/{pid}/status").read_text()
    except OSError:
        return False
    found = re.search(r"^SigCgt:\s*([0-9a-f]+)", status, re.MULTILINE)
    return bool(found) and bool(int(found[1], 16) >> (number - 1) & 1)


def ended(session, seconds):
    """Whether no process of the session is left within this time."""
    deadline = time.monotonic() + seconds
    while of_session(session):
        if time.monotonic() > deadline:
            return False
        time.sleep(0.05)
    return True
