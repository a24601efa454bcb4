#!/usr/bin/python3
"""Ordinary parts go through `idiophone check` at the element sizes given (m), or the message says why not.

test_parts.py SIZE... [--only NAME,NAME,...]: prints a table and fails when a part fares otherwise than expected.
"""
import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
DECK = """name: part
time: {duration: 0.001}
materials: {brass: {young: 1.0e11, poisson: 0.35, density: 8500}}
bodies: {part: {mesh: %s, parameters: {size: %g}, material: brass, element: %s}}
listeners: {ear: {type: mono, position: [0, 0, 1]}}
"""
REASONS = {  # what is said of those that can't be meshed
    "refused_open_scan.stl": "its surface isn't closed",
    "refused_open.obj": "its surface isn't closed",
    "refused_two_on_an_edge.stl": "its surface isn't closed",
    "refused_crossing.stl": "crosses itself",
    "refused_missing_vertex.obj": "'8' is none of the 7 vertices",
    "refused_empty.stl": "it has no triangles",
    "refused_cut.step": "Could not read file",
    "refused_text.brep": "has no volume elements",
}


def check(folder, part, size, element="tet10"):
    deck = folder / "deck.yaml"
    deck.write_text(DECK % (part, size, element))
    return subprocess.run([os.environ["IDIOPHONE"], "check", str(deck)], capture_output=True, text=True, timeout=600)


def verdict(part, job):
    """What is wrong with the answer, or nothing."""
    text = job.stdout + job.stderr
    if part.name in REASONS:
        place = re.search(r"deck\.yaml:4:\d+: ", job.stderr)
        return "" if job.returncode == 2 and place and REASONS[part.name] in job.stderr else f"should be refused: {text}"
    return "" if job.returncode == 0 else f"status {job.returncode}: {text}"


def summary(job):
    found = re.search(r"(\d+) tet10 elements.*?steps of (\S+) s", job.stdout, re.S)
    quality = re.search(r"quality ([\d.]+)", job.stdout)
    straight = re.search(r"(\d+) of \d+ elements have straight edges", job.stdout)
    if not (found and quality):
        return (job.stderr.strip().splitlines() or [""])[0][-90:]
    return f"{found[1]:>7} elements, stable step {found[2]} s, worst quality {quality[1]}" + (
        f", {straight[1]} straight" if straight else "")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("sizes", type=float, nargs="+")
    parser.add_argument("--only", type=lambda text: text.split(","), default=[])
    arguments = parser.parse_args()
    wrong = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run([HERE / "make_parts.py", folder], check=True, stdout=subprocess.DEVNULL)
        parts = [p for p in sorted(folder.iterdir()) if not arguments.only or p.name in arguments.only]
        for part in parts:
            for size in arguments.sizes[:1] if part.name in REASONS else arguments.sizes:
                job = check(folder, part, size)
                print(f"{part.name:28} {size:6g} m  {summary(job)}", flush=True)
                problem = verdict(part, job)
                wrong += [f"{part.name} at {size:g} m: {problem}"] if problem else []
    print("\n".join(wrong))
    return 1 if wrong else 0


sys.exit(main())
