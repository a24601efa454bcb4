#!/usr/bin/python3
"""The music of a sonic scene, and the notes of a score, go to a MIDI input of JACK, on a server of our own without a sound card."""
import pathlib
import re
import shutil
import signal
import subprocess
import time
import unittest

import jack_server

import program

SCENE = """name: s
duration: {duration}
classes: {{tick: tree.tt}}
sounds: {{tick: {{class: tick}}}}
music:
  every: 0.25
  parts:
    low: {{channel: motion/plate/velocity, column: x, from: [1, 2], scale: blues, tonic: 48, velocity: 77, program: 32}}
    high: {{channel: motion/plate/velocity, column: x, from: [1, 2], scale: blues, tonic: 72, velocity: 33, program: 11}}
"""
SCORE = """duration: 1
events:
  - {time: 0.1, at: [0.9, 0, 0], direction: [1, 0, 0], mass: 0.01, hardness: 1e7, speed: 1}
  - {time: 0.2, at: [0.1, 0, 0], direction: [1, 0, 0], mass: 0.01, hardness: 1e7, speed: 2}
notes:
  - {note: 60, at: [0, 0, 0], direction: [1, 0, 0], mass: 0.01, hardness: 1e7, speed: 2}
  - {note: 62, at: [1, 0, 0], direction: [1, 0, 0], mass: 0.01, hardness: 1e7, speed: 2}
"""
ALL_NOTES_OFF = [f"b{channel:x} 7b 00" for channel in range(16)]


@unittest.skipIf(shutil.which("jackd") is None or shutil.which("jack_midi_dump") is None, "needs jackd")
class MidiOutput(program.TestCase):
    def setUp(self):
        super().setUp()
        _, self.environment = jack_server.start(self, 2048, "--sync")  # it waits for its clients, so that none loses a period
        job = program.run("simple", self.output, "--set", "time.duration=0.001")
        self.require_status(job, program.FINISHED)
        (self.output / "tree.tt").write_text("(* 0 time)")

    def play(self, duration, destination):
        scene = self.output / "scene.yaml"
        scene.write_text(SCENE.format(duration=duration))
        return self.start("timbre", scene, self.output / "simple.h5", "-o", self.output / "s.wav", "--midi-out", destination)

    def start(self, *arguments):
        process = subprocess.Popen([program.PROGRAM, *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                   env=self.environment)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.kill)
        return process

    def listen(self):
        """A monitor of MIDI, once its input is there."""
        heard = pathlib.Path(self.output / "heard")
        with heard.open("w") as file:
            monitor = subprocess.Popen(["stdbuf", "-oL", "jack_midi_dump", "-a", "monitor"], stdout=file, env=self.environment)
        self.addCleanup(monitor.wait)
        self.addCleanup(monitor.terminate)
        for _ in range(100):
            if "monitor:input" in subprocess.run(["jack_lsp"], capture_output=True, text=True, env=self.environment).stdout:
                return heard
            time.sleep(0.1)
        self.fail("jack_midi_dump does not start")

    def messages(self, heard):
        """[(time in audio samples, bytes)], once all notes have ended."""
        for _ in range(100):
            found = re.findall(r"^ *(\d+): ((?:[0-9a-f]{2} ?)+)", heard.read_text(), re.MULTILINE)
            if found and found[-1][1].strip() == ALL_NOTES_OFF[-1]:
                return [(int(at), text.strip()) for at, text in found]
            time.sleep(0.1)
        self.fail(heard.read_text())

    def test_notes_come_at_their_times_on_a_channel_for_each_part(self):
        heard = self.listen()
        process = self.play(0.5, "monitor")
        self.assertEqual(process.wait(timeout=60), program.FINISHED, process.stdout.read())
        found = self.messages(heard)
        self.assertEqual(sorted(text for _, text in found[:4]), ["90 30 4d", "91 48 21", "c0 20", "c1 0b"])
        self.assertEqual([text for _, text in found[4:6]], ["80 30 00", "81 48 00"])
        self.assertAlmostEqual(found[4][0] - found[0][0], 24000, delta=48)  # 0.5 s at 48 kHz; the file counts in ms
        self.assertEqual([text for _, text in found[6:]], ALL_NOTES_OFF)

    def test_a_signal_ends_all_notes(self):
        heard = self.listen()
        process = self.play(20, "jack")
        while "waits until something is connected" not in process.stdout.readline():
            self.assertIsNone(process.poll())
        subprocess.run(["jack_connect", "idiophone:music", "monitor:input"], check=True, env=self.environment)
        while "91 48 21" not in heard.read_text():
            self.assertIsNone(process.poll())
            time.sleep(0.1)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=30), program.FINISHED)
        self.assertEqual([text for _, text in self.messages(heard)][4:], ALL_NOTES_OFF)

    def test_play_sends_the_notes_of_a_score(self):
        heard = self.listen()
        score = self.output / "score.yaml"
        score.write_text(SCORE)
        (self.output / "knock.tt").write_text("(* 0 time)")
        process = self.start("play", self.output / "knock.tt", "--score", score, "--midi-out", "monitor", "--json")
        self.assertEqual(process.wait(timeout=60), program.FINISHED)
        self.assertIn('"midi_messages": 4', process.stdout.read())
        found = self.messages(heard)
        self.assertEqual([text for _, text in found[:4]], ["90 3e 40", "90 3c 7f", "80 3e 40", "80 3c 7f"])
        self.assertAlmostEqual(found[1][0] - found[0][0], 4800, delta=2)  # 0.1 s at 48 kHz
        self.assertAlmostEqual(found[2][0] - found[0][0], 12000, delta=2)

    def test_what_is_no_note_is_not_left_out_silently(self):
        (self.output / "score.yaml").write_text(SCORE)
        (self.output / "knock.tt").write_text("(* 0 time)")
        process = self.start("play", self.output / "knock.tt", "--score", self.output / "score.yaml", "--contacts", "fall.h5",
                             "--midi-out", "monitor")
        self.assertEqual(process.wait(timeout=60), program.FAILED)
        self.assertIn("leave out --contacts", process.stdout.read())

    def test_says_which_inputs_there_are(self):
        self.listen()
        process = self.play(0.5, "fluid")
        self.assertEqual(process.wait(timeout=60), program.FAILED)
        self.assertRegex(process.stdout.read(), r"JACK has no MIDI input whose name contains 'fluid'; there are: .*monitor:input")


if __name__ == "__main__":
    unittest.main()
