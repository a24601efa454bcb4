"""Calls a program under mpirun, whose own faults are not those of the program.

On a busy machine, mpirun of Open MPI 4.1 sometimes hangs or crashes in its own end, in PMIx_server_finalize, after a rank has
ended the job: about once in 200 such jobs. All ranks have ended by then. Such a job is called again.
"""
import pathlib
import signal
import subprocess

TRIES = 3
LOOKS = 10  # s between two looks at the ranks of a job that goes on


def call(command, timeout):
    """What the command left, as subprocess.run() gives it. Raises TimeoutExpired if it hangs while a rank lives."""
    for _ in range(TRIES):
        if job := ended(command, timeout):
            return job
    raise AssertionError(f"mpirun itself failed {TRIES} times: {command}")


def ended(command, timeout):
    """One call; None if mpirun itself hangs or crashes."""
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, errors="replace")
    for _ in range(max(1, timeout // LOOKS)):
        try:
            out, errors = process.communicate(timeout=LOOKS)
        except subprocess.TimeoutExpired:
            if not all_children_ended(process):
                continue
            kill(process)
            return None
        crashed = process.returncode == -signal.SIGSEGV  # a rank's would be 139 here
        return None if crashed else subprocess.CompletedProcess(command, process.returncode, out, errors)
    kill(process)
    raise subprocess.TimeoutExpired(command, timeout)


def all_children_ended(process):
    """Whether a process has children, and all are zombies."""
    states = [state for state, parent in map(state_and_parent, pathlib.Path("/proc").glob("[0-9]*/stat")) if parent == process.pid]
    return bool(states) and all(state == "Z" for state in states)


def state_and_parent(file):
    """Of the process whose /proc/.../stat it is; none if it is gone."""
    try:
        state, parent = file.read_text().rpartition(")")[2].split()[:2]
    except OSError:
        return "", 0
    return state, int(parent)


def kill(process):
    process.kill()
    process.wait()  # not for the ends of its output, which its children may hold
    process.stdout.close()
    process.stderr.close()
