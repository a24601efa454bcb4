"""What a result says of its run: /run of docs/use/result_file.md."""

import json
import subprocess
import sys


def run_facts(program, result):
    """The object `run` of `idiophone info --json`: step, sizes, masses, jobs, ..."""
    done = subprocess.run([program, "info", "--json", result], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{program} info {result} failed:\n{done.stderr}")
    return json.loads(done.stdout)["run"]


def share(job, *stages):
    """The part of a job's time on rank 0 that these stages took, percent."""
    return 100 * sum(job["stages"][stage] for stage in stages) / sum(job["stages"].values())
