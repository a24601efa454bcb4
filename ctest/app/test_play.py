#!/usr/bin/python3
"""`idiophone play`: scores to files, and in real time on a JACK server without a sound card."""
import os
import pathlib
import re
import shutil
import signal
import socket
import struct
import subprocess
import tempfile
import threading
import time
import unittest

import numpy

import jack_server
import program

SCORE = program.deck("score").read_text()
ROLL = ("/roll/begin", "hand", "plate", -0.02, 0.0, 0.01, 0.02, 0.0, 0.01, 0.0, 0.0, -1.0, 0.2, 0.5, 0.05, 1e10, 2e-4, 1e-7)
BLOW = ("/blow", "plate", 0.02, 0.01, 0.01, 0.0, 0.0, -1.0, 0.01, 1e8, 1.0)


def osc(address, *arguments):
    """An OSC message of texts and numbers."""
    def padded(text):
        raw = text.encode() + b"\0"
        return raw + b"\0" * (-len(raw) % 4)
    types = "," + "".join("s" if isinstance(argument, str) else "f" for argument in arguments)
    return padded(address) + padded(types) + b"".join(
        padded(argument) if isinstance(argument, str) else struct.pack(">f", argument) for argument in arguments)


class PlayCase(program.TestCase):
    """With the sound map of a small plate."""
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        job = program.idiophone("map", program.deck("simple"), "--modes", 30, "--radiation", "kirchhoff",
                                "--output-folder", cls.folder)
        assert job.returncode == 0, job.stdout + job.stderr
        cls.map, = cls.folder.glob("*.map.h5")

    def score(self, text=SCORE):
        path = self.output / "score.yaml"
        path.write_text(text)
        return path

    def play(self, *arguments, status=program.FINISHED, environment=None):
        job = subprocess.run([program.PROGRAM, "play", *map(str, arguments)], capture_output=True, text=True, timeout=60,
                             env={**os.environ, **(environment or {})})
        self.require_status(job, status)
        return job.stdout + job.stderr


class Play(PlayCase):
    def test_writes_a_score_as_pressure(self):
        sound = self.output / "sound.wav"
        told = self.play(self.map, "--score", self.score(), "--output", sound, "--rate", 44100)
        full_scale = float(re.search(r"full scale is (\S+) Pa", told)[1])
        first = program.wav_samples(sound).astype(float) * full_scale
        self.assertEqual(len(first), 22050)
        self.assertEqual(numpy.abs(first[:441]).max(), 0)       # silence before the blow
        self.assertGreater(numpy.abs(first[441:4410]).max(), 0)
        self.play(self.map, "--score", self.score(SCORE + "wav_full_scale: 4\n"), "--output", sound, "--rate", 44100)
        self.assertLess(numpy.abs(program.wav_samples(sound) * 4.0 - first).max(), 1e-3 * full_scale)

    def test_refuses_what_is_wrong(self):
        score = self.score(SCORE.replace("hardness: 1e8", "hardnes: 1e8", 1))
        self.assertRegex(self.play(self.map, "--score", score, "--output", self.output / "a.wav", status=program.WRONG_DECK),
                         r"score.yaml:5:.*unknown key \(did you mean 'hardness'\?\)")
        for message, arguments in (("nothing to play", [self.map]),
                                   ("leave out --osc", [self.map, "--score", self.score(), "--osc", 5000, "--output", "a.wav"]),
                                   ("no such file|No such file", [self.folder / "none.h5", "--score", self.score()]),
                                   ("another body with the name", [self.map, self.map, "--score", self.score()]),
                                   ("can't be read as a MIDI file",
                                    [self.map, "--score", self.score(), "--midi", self.score(), "--output", "a.wav"]),
                                   ("needs a score", [self.map, "--midi", "a.mid"])):
            self.assertRegex(self.play(*arguments, status=program.FAILED), message)

    def test_tells_of_listeners_at_a_body_and_refuses_those_inside(self):
        def heard_at(place, status=program.FINISHED):
            score = self.score(SCORE.replace("[0, 0, 1]}", place + "}", 1))
            return self.play(self.map, "--score", score, "--output", self.output / "a.wav", status=status)
        near = heard_at("[0, 0, 0.03]")
        self.assertRegex(near, "listener .* is 0.02 m from plate: nearer than a twentieth of a wavelength")
        self.assertRegex(near, r"comes within 0.03 m of the centre of plate and hears it as from 0.14\d* m, its largest radius")
        self.assertNotRegex(heard_at("[0, 0, 1]"), "largest radius|twentieth")
        self.assertIn("is inside plate", heard_at("[0, 0, 0.005]", status=program.WRONG_DECK))

    def test_tells_of_a_listener_behind_the_wall_of_an_ideal_body(self):
        deck = self.output / "ideal.yaml"
        deck.write_text("name: ideal\nlisteners: {ear: {type: mono, position: [0, 0, 1]}}\nideal_bodies:\n"
                        "  string: {type: string, length: 0.65, width: 0.001, tension: 70, density: 4.0e-4}\n")
        self.require_status(program.idiophone("map", deck, "--modes", 2, "--output-folder", self.output), program.FINISHED)
        string = self.output / "ideal_string.map.h5"
        score = self.score("duration: 0.1\nlistener: {type: mono, position: [0, 0, -1]}\nevents:\n  - {time: 0.01, at: [0.2, 0, 0], "
                           "direction: [0, 0, -1], mass: 0.01, hardness: 1e8, speed: 1}\n")
        self.assertIn("comes behind the wall of string", self.play(string, "--score", score, "--output", self.output / "a.wav"))

    def test_refuses_listeners_inside_proxies(self):
        score = self.score(SCORE.replace("listener: {type: mono, position: [0, 0, 1]}\n", ""))
        job = program.idiophone("proxies", program.deck("simple"), "--set", "listeners.ear.position=[0, 0, 0.005]", "--score", score,
                                "--output", self.output / "a.wav")
        self.require_status(job, program.WRONG_DECK)
        self.assertIn("is inside plate", job.stdout + job.stderr)

    def test_says_that_there_is_no_device(self):
        self.assertRegex(self.play(self.map, "--score", self.score(), "--device", "no such device", status=program.FAILED,
                                   environment={"JACK_DEFAULT_SERVER": "idiophone_none"}), "there is no (audio )?device|no audio device")
        self.assertIn("no JACK server", self.play(self.map, "--score", self.score(), "--midi", "jack", status=program.FAILED,
                                                  environment={"JACK_DEFAULT_SERVER": "idiophone_none"}))


@unittest.skipIf(shutil.which("jackd") is None, "needs jackd")
class RealTime(PlayCase):
    """On a JACK server of our own without a sound card."""
    def setUp(self):
        super().setUp()
        self.server, self.environment = jack_server.start(self)

    def start(self, *arguments):
        process = subprocess.Popen([program.PROGRAM, "play", self.map, "--device", "JACK", *map(str, arguments)],
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=self.environment)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.kill)
        return process

    def port(self):
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
            probe.bind(("127.0.0.1", 0))
            return probe.getsockname()[1]

    def begun(self, process):
        self.assertIn("Ctrl-C ends", process.stdout.readline())

    def finish(self, process, status=program.FINISHED):
        told = process.communicate(timeout=30)[0]
        self.assertEqual(process.returncode, status, told)
        return told

    def test_plays_a_score_to_its_end(self):
        told = self.finish(self.start("--score", self.score()))
        blocks = int(re.search(r"(\d+) blocks of 128 frames", told)[1])
        self.assertGreaterEqual(blocks, 187)
        self.assertRegex(told, r"load \S+ %, largest \S+ %; \d+ late blocks")

    def test_plays_blows_by_osc_until_it_is_interrupted(self):
        port = self.port()
        process = self.start("--score", self.score(), "--osc", port)
        self.begun(process)
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
            for _ in range(20):
                sender.sendto(osc(*BLOW), ("127.0.0.1", port))
                time.sleep(0.02)
            sender.sendto(osc("/listener", 0.5, 0.0, 1.0), ("127.0.0.1", port))
            for message in ROLL, ("/stroke/change", "hand", 0.4, 1.0), ("/stroke/end", "hand"), ("/stroke/end", "hand"):
                sender.sendto(osc(*message), ("127.0.0.1", port))
                time.sleep(0.05)
            sender.sendto(osc("/blow", "plate"), ("127.0.0.1", port))
        second = self.start("--score", self.score(), "--osc", port)
        self.assertIn(f"UDP port {port} can't be used", self.finish(second, program.FAILED))
        process.send_signal(signal.SIGINT)
        told = self.finish(process)
        self.assertIn("needs 10 arguments, found 1", told)
        self.assertEqual(told.count("there is no stroke 'hand'; begin it first"), 1)
        mean, longest = re.search(r"from a blow to its sound: (\S+) blocks on average, at most (\S+)", told).groups()
        self.assertGreaterEqual(float(longest), float(mean))
        late = int(re.search(r"(\d+) late blocks", told)[1])
        if late > 0:
            self.skipTest(f"the machine is too busy to measure delays: {late} late blocks, {mean} blocks on average")
        self.assertLessEqual(float(mean), 2.0)

    def test_a_flood_of_messages_does_not_hold_up_ctrl_c(self):
        port = self.port()
        process = self.start("--score", self.score(), "--osc", port)
        self.begun(process)
        over = threading.Event()
        def flood():
            with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
                while not over.is_set():
                    for message in osc("/stroke/end", "hand"), osc(*BLOW), osc("/tune", "plate", 1.0, 1.0), b"nonsense":
                        sender.sendto(message, ("127.0.0.1", port))
        sender = threading.Thread(target=flood)
        sender.start()
        self.addCleanup(over.set)
        time.sleep(1)
        process.send_signal(signal.SIGINT)
        started = time.monotonic()
        told = self.finish(process)
        over.set()
        sender.join()
        self.assertLess(time.monotonic() - started, 10)
        self.assertRegex(told, r"\d+ OSC messages were wrong and left out")
        self.assertLess(len(told.splitlines()), 100)

    def test_says_that_the_server_is_gone(self):
        process = self.start("--score", self.score(), "--osc", self.port())
        self.begun(process)
        self.server.terminate()
        self.assertIn("stopped", self.finish(process, program.FAILED))


if __name__ == "__main__":
    unittest.main()
