#!/usr/bin/python3
"""`idiophone play` with sound maps, proxies and timbre trees in one stage, and every driver from the command line."""
import pathlib
import shutil
import tempfile
import unittest

import numpy

import program

TREE = "(parameter impulse)\n(* 20 impulse (damp 300 0.01) (sine 300))\n"
LISTENER = "listener: {type: mono, position: [0, 0, 1]}\n"
BLOW = "at: [0.02, 0.01, 0.01], direction: [0, 0, -1], mass: 0.01, hardness: 1e7, speed: 1}"
# Note 60 at the beginning of a quarter of half a second.
MIDI = b"MThd\x00\x00\x00\x06\x00\x00\x00\x01\x00\x60MTrk\x00\x00\x00\x0c\x00\x90\x3c\x7f\x30\x80\x3c\x00\x00\xff\x2f\x00"


class Stage(program.TestCase):
    """With the ball that bounces between two walls: its run, its sound map, its deck, and a tree of its name."""
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        for arguments in (["run", program.deck("bounce"), "--progress", "log"],
                          ["map", program.deck("bounce"), "--modes", 8, "--radiation", "kirchhoff"]):
            job = program.idiophone(*arguments, "--output-folder", cls.folder)
            assert job.returncode == 0, job.stdout + job.stderr
        cls.result = cls.folder / "bounce.h5"
        cls.map, = cls.folder.glob("*.map.h5")
        cls.tree = cls.folder / "ball.tt"
        cls.tree.write_text(TREE)
        cls.bodies = {"map": cls.map, "proxy": program.deck("bounce"), "tree": cls.tree}

    def play(self, *arguments, score=None, status=program.FINISHED, output="sound.wav"):
        driven = []
        if score:
            (self.output / "score.yaml").write_text("wav_full_scale: 1\n" + score)
            driven = ["--score", self.output / "score.yaml"]
        job = program.idiophone("play", *arguments, *driven, "--rate", 8000, "-o", self.output / output)
        self.require_status(job, status)
        return program.wav_samples(self.output / output).astype(float) if status == program.FINISHED and output.endswith("wav") else (
            job.stdout + job.stderr)

    def test_contacts_of_a_run_strike_every_kind_of_body(self):
        for kind, file in self.bodies.items():
            with self.subTest(body=kind):
                sound = self.play(file, "--contacts", self.result)
                self.assertGreater(numpy.abs(sound).max(), 0)
                self.assertTrue(numpy.isfinite(sound).all())

    def test_midi_files_play_every_kind_of_body(self):
        (self.output / "notes.mid").write_bytes(MIDI)
        score = LISTENER + "duration: 0.2\nnotes:\n  - {note: 60, " + BLOW + "\n"
        for kind, file in self.bodies.items():
            with self.subTest(body=kind):
                sound = self.play(file, "--midi", self.output / "notes.mid", score=score)
                self.assertGreater(numpy.abs(sound).max(), 0)

    def test_motion_of_a_run_drives_every_kind_of_body(self):
        score = LISTENER + ("duration: 0.4\nmotion:\n  - {channel: motion/ball/velocity, column: x, at: [0.04, 0, 0],"
                            " force: [1, 0, 0], above: 0.5}\n")
        for kind, file in self.bodies.items():
            with self.subTest(body=kind):
                sound = self.play(file, "--motion", self.result, score=score)
                self.assertGreater(numpy.abs(sound).max(), 0)
        self.assertIn("give both", self.play(self.map, score=score, status=program.FAILED))

    def test_adds_the_sounds_of_all_kinds(self):
        other = self.output / "bee.tt"
        other.write_text(TREE)
        plate = program.deck("simple")
        events = [f"  - {{time: {time}, body: {body}, {BLOW}\n" for time, body in ((0.01, "ball"), (0.02, "plate"), (0.03, "bee"))]
        head = LISTENER + "duration: 0.2\nevents:\n"
        together = self.play(self.map, plate, other, score=head + "".join(events))
        alone = sum(self.play(file, score=head + event) for file, event in zip((self.map, plate, other), events))
        self.assertGreater(numpy.abs(alone).max(), 0)
        self.assertLess(numpy.abs(together - alone).max(), 1e-6 * numpy.abs(alone).max())

    def test_writes_a_result(self):
        score = LISTENER + "duration: 0.2\nevents:\n  - {time: 0.01, " + BLOW + "\n"
        expected = self.play(self.map, score=score)
        self.play(self.map, score=score, output="played.h5")
        told = program.idiophone("info", self.output / "played.h5", "--channel", "audio/played").stdout
        rows = [float(line.split(",")[-1]) for line in told.splitlines() if line[:1].isdigit()]
        self.assertEqual(len(rows), len(expected))
        self.assertLess(numpy.abs(numpy.array(rows) - expected).max(), 1e-5 * numpy.abs(expected).max())

    def test_refuses_what_is_wrong(self):
        tune = LISTENER + "duration: 0.2\nevents:\n  - {type: tune, time: 0.1, tension: 2}\n"
        self.assertIn("only proxies have a tension", self.play(self.map, score=tune, status=program.FAILED))
        self.assertIn("no parameter 'tension'", self.play(self.tree, score=tune, status=program.FAILED))
        contact = LISTENER + ("duration: 0.2\ncontacts:\n  - {at: [0.02, 0.01, 0.01], direction: [0, 0, 1], gap: 1e-5,"
                              " hardness: 1e7}\n")
        for kind in ("proxy", "tree"):
            self.assertIn("only sound maps can touch", self.play(self.bodies[kind], score=contact, status=program.FAILED))
        self.assertIn("another body with the name", self.play(self.map, self.tree, score=tune, status=program.FAILED))
        self.assertIn("no contact of its deck", self.play(program.deck("simple"), "--contacts", self.result, status=program.FAILED))


if __name__ == "__main__":
    unittest.main()
