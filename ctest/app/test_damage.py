#!/usr/bin/python3
"""Flips single bits of a result, a recording and a checkpoint. None is resumed with the damage kept, none hangs, and none
crashes. `test_damage.py --count N --seed S` flips N bits in each file; IDIOPHONE names the program, IDIOPHONE_MPIRUN the
launcher."""
import argparse
import pathlib
import random
import re
import shutil
import struct
import sys
import tempfile
import unittest

import h5py
import numpy

import program

COUNT, SEED = 10 if program.LONG else 4, 20261122
FILES = ("simple.h5", "simple_surface.h5", "checkpoint")
RECORDED = "--set", "output.surface_motion=true", "--set", "output.checkpoint.every_minutes=1e-9"


def flipped(path, generator):
    """Flips a random bit of a file, and says which."""
    content = bytearray(path.read_bytes())
    place, bit = generator.randrange(len(content)), generator.randrange(8)
    content[place] ^= 1 << bit
    path.write_bytes(content)
    return f"bit {bit} of byte {place} of {path.name}"


def newest_checkpoint(folder):
    return folder / "simple_checkpoints" / (folder / "simple_checkpoints" / "latest").read_text().strip()


class Campaign:
    """A run that was stopped after a few blocks, and its bits at its end."""

    def __init__(self, work):
        self.work = work
        self.straight = work / "straight"
        self.stopped = work / "stopped"
        self.require(program.run("simple", self.straight, *RECORDED), program.FINISHED)
        stop = program.preload("BLOCK_SIGNAL", SIGNAL=10, SIGNAL_BLOCK=3, SIGNAL_RANK=0)
        self.require(program.run("simple", self.stopped, *RECORDED, environment=stop), program.RESUMABLE)
        self.expected = {name: program.contents(self.straight / name) for name in FILES[:2]}
        self.counts = {"resumed": 0, "refused": 0, "only reported": 0}

    @staticmethod
    def require(job, status):
        if job.returncode != status:
            raise AssertionError(f"status {job.returncode}\n{job.stdout}\n{job.stderr}")

    def flip(self, file, generator, ranks):
        """Flips a bit, verifies, lists and resumes. Returns what is wrong; empty for nothing."""
        folder = self.work / "flipped"
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(self.stopped, folder)
        path = newest_checkpoint(folder) if file == "checkpoint" else folder / file
        what = flipped(path, generator)
        verified = program.idiophone("info", "--verify", path)
        described = program.idiophone("info", path)
        resumed = program.run("simple", folder, *RECORDED, "--resume", ranks=ranks)
        for job in (verified, described, resumed):
            if job.returncode not in (program.FINISHED, program.FAILED):
                return f"{what}: status {job.returncode}\n{job.stdout}\n{job.stderr}"
        if resumed.returncode != program.FINISHED:
            self.counts["refused"] += 1
            return "" if verified.returncode == program.FAILED else f"{what}: refused but not damaged\n{resumed.stderr}"
        self.counts["resumed" if verified.returncode == program.FINISHED else "only reported"] += 1
        for name, values in self.expected.items():
            found = program.contents(folder / name)
            wrong = [key for key in values if found[key].tobytes() != values[key].tobytes()] if (
                sorted(found) == sorted(values)) else ["the list of datasets"]
            if wrong:
                return f"{what}: {name} keeps damage in {', '.join(wrong)}"
        return ""

    def run(self, count, seed):
        """Returns what went wrong in `count` flips of each file."""
        generator = random.Random(seed)
        wrong = []
        for file in FILES:
            wrong += [self.flip(file, generator, 1 + i % 3) for i in range(count)]
        return [text for text in wrong if text]


class Damage(program.TestCase):
    def test_flipped_bits(self):
        campaign = Campaign(self.output)
        self.assertEqual(campaign.run(COUNT, SEED), [], f"seed {SEED}")

    def test_says_from_which_time_on(self):
        self.require_status(program.run("simple", self.output, *RECORDED), program.FINISHED)
        path = self.output / "simple.h5"
        for job in (program.idiophone("info", "--verify", path), program.idiophone("info", "--verify", "--json", path)):
            self.require_status(job, program.FINISHED)
        with h5py.File(path) as file:
            frame = file["frames/plate/displacement"][7].tobytes()
        content = bytearray(path.read_bytes())
        content[content.find(frame) + 5] ^= 1
        path.write_bytes(content)
        job = program.idiophone("info", "--verify", path)
        self.require_status(job, program.FAILED)
        self.assertIn("/frames/plate/displacement: DAMAGED from 0.007 s on", job.stdout)
        job = program.idiophone("info", "--verify", "--json", path)
        self.require_status(job, program.FAILED)
        self.assertIn('"since": 0.007', job.stdout)

    def test_damaged_text_is_not_shown(self):
        self.require_status(program.run("simple", self.output, *RECORDED), program.FINISHED)
        path = self.output / "simple.h5"
        content = bytearray(path.read_bytes())
        content[content.find(b"rubber: {young")] ^= 1  # in the deck
        path.write_bytes(content)
        job = program.idiophone("info", path, "--json")
        self.require_status(job, program.FAILED)
        self.assertIn("/deck does not match its checksum: the file is damaged", job.stderr)
        self.assertEqual(job.stdout, "")

    def test_lists_damaged_after_the_checkpoint_cost_nothing(self):
        """HDF5 keeps the addresses of later frames in blocks of their own, which begin with EADB."""
        arguments = *RECORDED, "--set", "output.frames_per_second=8000"
        straight, stopped = self.output / "straight", self.output / "stopped"
        self.require_status(program.run("simple", straight, *arguments), program.FINISHED)
        stop = program.preload("BLOCK_SIGNAL", SIGNAL=10, SIGNAL_BLOCK=2, SIGNAL_RANK=0)
        self.require_status(program.run("simple", stopped, *arguments, environment=stop), program.RESUMABLE)
        for name in ("simple.h5", "simple_surface.h5"):  # with rows of after the checkpoint
            shutil.copy(straight / name, stopped / name)
        path = stopped / "simple.h5"
        content = bytearray(path.read_bytes())
        content[content.rfind(b"EADB") + 30] ^= 1
        path.write_bytes(content)
        self.require_status(program.idiophone("info", "--verify", path), program.FAILED)
        resumed = program.run("simple", stopped, *arguments, "--resume", ranks=2)
        self.require_status(resumed, program.FINISHED)
        self.assertIn("it was rebuilt up to there", resumed.stdout)
        self.require_status(program.idiophone("info", "--verify", path), program.FINISHED)
        for name in ("simple.h5", "simple_surface.h5"):
            self.require_same(stopped / name, program.contents(straight / name))

    def test_a_damaged_recording_is_not_played(self):
        self.require_status(program.run("simple", self.output, *RECORDED), program.FINISHED)
        path = self.output / "simple_surface.h5"
        with h5py.File(path) as file:
            row = file["position"][60].tobytes()
        content = bytearray(path.read_bytes())
        content[content.find(row) + 3] ^= 1
        path.write_bytes(content)
        for ranks in (1, 2):
            job = program.idiophone("listen", path, "--output-folder", self.output / "again", ranks=ranks)
            self.require_status(job, program.FAILED)
            self.assertIn("simple_surface.h5 is damaged: /position", job.stderr)
        job = program.run("simple", self.output, "--set", f"bodies.other.recording={path}")
        self.require_status(job, program.WRONG_DECK)
        self.assertIn("simple_surface.h5 is damaged: /position", job.stderr)

    def test_a_chunk_index_that_names_itself_does_not_hang(self):
        """HDF5 searches such an index of the oldest format for ever."""
        path = self.output / "drum_surface.h5"
        with h5py.File(path, "w", libver=("earliest", "v108")) as file:
            file.attrs.update({"format": "idiophone surface motion", "format_version": 1, "rate": 8000.0})
            file["triangles"] = numpy.array([[0, 1, 2]], dtype="i4")
            file.create_dataset("pressure", data=numpy.zeros((64, 1)), chunks=(1, 1))
            file.create_dataset("position", data=numpy.ones((64, 3, 3)))
        job = program.idiophone("info", "--verify", path)
        self.require_status(job, program.FINISHED)
        self.assertIn("3 can be read but have none", job.stdout)
        content = bytearray(path.read_bytes())
        node = next(match.start() for match in re.finditer(b"TREE\x01", content))
        content[node + 5] = 1  # its level: children are nodes, too
        for child in range(64):  # after a header of 24 bytes: a key of 32 bytes and an address of 8 for each
            struct.pack_into("<Q", content, node + 24 + 40 * child + 32, node)
        path.write_bytes(content)
        for command in (["info", "--verify", path], ["listen", path, program.deck("simple")]):
            job = program.idiophone(*command)
            self.require_status(job, program.FAILED)
            self.assertIn("drum_surface.h5 is damaged", job.stderr)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=COUNT, help="bits in each file")
    parser.add_argument("--seed", type=int, default=SEED)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as work:
        campaign = Campaign(pathlib.Path(work))
        wrong = campaign.run(options.count, options.seed)
    print(f"seed {options.seed}: {options.count} flipped bits in each of {', '.join(FILES)}: "
          + ", ".join(f"{count} {what}" for what, count in campaign.counts.items()))
    sys.exit("\n".join(wrong))


if __name__ == "__main__":
    main() if "--count" in sys.argv or "--seed" in sys.argv else unittest.main()
