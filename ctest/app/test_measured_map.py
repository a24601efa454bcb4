#!/usr/bin/python3
"""`idiophone map` of recordings: the sound map of a plate is played, and made again from the sounds of its blows."""
import subprocess
import unittest
import wave

import h5py
import numpy

import program

RATE = 44100
GAP = 0.6      # s, from one blow to the next
CONTACT = 2e-4  # s
LENGTH, WIDTH, THICKNESS = 0.24, 0.17, 0.004
MICROPHONES = {"left": [-0.1, 0.05, 0.4], "right": [0.4, -0.05, 0.35]}
DECK = f"""
name: plate
time: {{duration: 0.1}}
materials:
  alloy: {{young: 7.0e10, poisson: 0.33, density: 2700, damping: {{mass: 30, stiffness: 4.0e-7}}}}
bodies:
  plate: {{mesh: {program.SOURCE}/meshes/bar.geo, material: alloy, element: tet10,
    parameters: {{length: {LENGTH}, width: {WIDTH}, thickness: {THICKNESS}, size: 0.03}}}}
loads: {{tap: {{at: [0.1, 0, {THICKNESS / 2}], force: [0, 0, -1], duration: 1e-3}}}}
listeners:
  left: {{type: mono, position: {MICROPHONES["left"]}}}
  right: {{type: mono, position: {MICROPHONES["right"]}}}
"""
STRUCK = [[x, y, THICKNESS / 2] for x in numpy.linspace(0, LENGTH, 6) for y in numpy.linspace(-WIDTH / 2, WIDTH / 2, 5)]


def write_wav(path, channels, scale=1.0):
    """16 bits, as recorders have them, with dither."""
    dither = numpy.random.default_rng(1).uniform(-0.5, 0.5, numpy.shape(channels))
    samples = numpy.clip(numpy.round(numpy.asarray(channels) * scale * 32767 + dither), -32767, 32767).astype("<i2")
    with wave.open(str(path), "wb") as file:
        file.setnchannels(len(samples))
        file.setsampwidth(2)
        file.setframerate(RATE)
        file.writeframes(samples.T.tobytes())


def participation(file, place):
    """Of a blow downwards, at the nearest vertex of the side that is struck."""
    vertices = file["surface/vertices"][()]
    vertex = numpy.argmin(numpy.linalg.norm(vertices - place, axis=1))
    return -file["modes/shape"][:, vertex, 2], vertices[vertex]


def heard(file, place):
    """Complex pressure of each mode at the microphones after a blow of 1 N s: [modes x microphones]."""
    return participation(file, place)[0][:, None] * (file["listeners/pressure"][()] @ [1, 1j])


class MeasuredMap(program.TestCase):
    def map(self, *arguments, status=program.FINISHED):
        job = program.idiophone("map", *arguments, "--output-folder", self.output)
        self.require_status(job, status)
        return job.stdout + job.stderr

    def strike(self, points):
        """The sound of blows one after the other, of 0.01 N s each, and of the times at which they begin."""
        events = "".join(
            f"  - {{time: {0.05 + GAP * i}, type: force, at: {list(map(float, point))}, force: [0, 0, {-numpy.pi / 2 * 0.01 / CONTACT}], "
            f"shape: half_sine, duration: {CONTACT}}}\n" for i, point in enumerate(points))
        score = self.output / "score.yaml"
        score.write_text(f"duration: {GAP * len(points)}\nwav_full_scale: 1\nevents:\n{events}")
        job = subprocess.run([program.PROGRAM, "play", self.output / "plate_plate.map.h5", "--score", score, "--output",
                              self.output / "all.h5", "--rate", str(RATE)], capture_output=True, text=True, timeout=120)
        self.require_status(job, program.FINISHED)
        with h5py.File(self.output / "all.h5") as file:
            audio = file["audio"]
            return numpy.concatenate([audio[name][()].reshape(audio[name].shape[0], -1) for name in sorted(audio)], axis=1).T

    def record(self, points, noise):
        """Writes a sound file for each point, at times that nobody knows, and the deck of the recordings."""
        random = numpy.random.default_rng(5)
        sound = self.strike(points)
        full_scale = 1.25 * numpy.abs(sound).max()
        level = noise * numpy.sqrt((sound ** 2).mean())
        blows = ""
        for i, point in enumerate(points):
            begin = int(GAP * RATE * i) + random.integers(0, int(0.03 * RATE))
            part = sound[:, begin:int(GAP * RATE * (i + 1))]
            write_wav(self.output / f"blow_{i}.wav", part + random.normal(0, level, part.shape), 1 / full_scale)
            blows += (f"      - {{sound: blow_{i}.wav, at: {list(map(float, point))}, direction: [0, 0, -1], impulse: 0.01, "
                      f"contact: {CONTACT}}}\n")
        deck = self.output / "measured.yaml"
        deck.write_text(f"""name: measured
measured_bodies:
  plate:
    mesh: {program.SOURCE}/meshes/bar.geo
    parameters: {{length: {LENGTH}, width: {WIDTH}, thickness: {THICKNESS}, size: 0.015}}
    mass: {LENGTH * WIDTH * THICKNESS * 2700}
    full_scale: {full_scale}
    blows:
{blows}listeners:
  left: {{type: mono, position: {MICROPHONES["left"]}}}
  right: {{type: mono, position: {MICROPHONES["right"]}}}
""")
        return deck

    def prepare(self, noise):
        (self.output / "plate.yaml").write_text(DECK)
        self.map(self.output / "plate.yaml", "--up-to", 2200, "--radiation", "kirchhoff")
        deck = self.record(STRUCK, noise)
        self.map(deck, "--up-to", 2200)
        return h5py.File(self.output / "plate_plate.map.h5"), h5py.File(self.output / "measured_plate.map.h5")

    def test_is_the_map_of_the_body_that_was_recorded(self):
        made, measured = self.prepare(noise=0.1)
        frequency, found = made["modes/frequency"][()], measured["modes/frequency"][()]
        self.assertEqual(len(frequency), len(found))
        cents = numpy.abs(1200 * numpy.log2(found / frequency))
        self.assertLess(cents.max(), 1)  # of a mode 50 dB below the loudest
        self.assertLess(numpy.sort(cents)[-2], 0.2)
        decay = numpy.abs(measured["modes/decay"][()] / made["modes/decay"][()] - 1)
        self.assertLess(decay.max(), 0.05)
        self.assertLess(numpy.sort(decay)[-2], 0.01)
        self.assertEqual(list(measured["listeners/name"][()]), [b"left", b"right"])
        errors, phases = [], []
        for x, y in (0.07, 0.02), (0.16, -0.06), (0.12, 0.04), (0.215, -0.02):  # between those that were struck
            place = participation(made, [x, y, THICKNESS / 2])[1]
            expected, answer = heard(made, place), heard(measured, place)
            loud = numpy.abs(expected) > 0.1 * numpy.abs(expected).max(axis=0)
            errors.extend(20 * numpy.log10(numpy.abs(answer / expected)[loud]))
            phases.extend(numpy.angle(answer / expected)[loud])
        self.assertGreater(len(errors), 30)
        self.assertLess(numpy.sqrt(numpy.mean(numpy.square(errors))), 1.5)  # dB
        self.assertLess(numpy.abs(errors).max(), 4)
        self.assertLess(numpy.abs(phases).max(), 0.6)  # rad: no sign is wrong
        self.assertLess(abs(measured.attrs["mass"] / made.attrs["mass"] - 1), 1e-6)
        numpy.testing.assert_allclose(measured.attrs["centre"], made.attrs["centre"], atol=1e-6)
        distance = numpy.linalg.norm(numpy.array(MICROPHONES["left"]) - measured.attrs["centre"][0])
        far = numpy.abs(measured["sphere/pressure"][:, 0] @ [1, 1j]) / distance
        near = numpy.abs(measured["listeners/pressure"][:, 0] @ [1, 1j])
        self.assertLess(numpy.abs(20 * numpy.log10(far / near)).mean(), 6)
        play = self.play_measured()
        self.assertGreater(numpy.abs(play).max(), 0)

    def play_measured(self):
        score = self.output / "blow.yaml"
        score.write_text("duration: 0.2\nlistener: {type: mono, position: [0, 0, 1]}\nevents:\n"
                         "  - {time: 0.01, at: [0.1, 0, 0.002], direction: [0, 0, -1], mass: 0.01, hardness: 1e8, speed: 1}\n")
        job = subprocess.run([program.PROGRAM, "play", self.output / "measured_plate.map.h5", "--score", score, "--output",
                              self.output / "blow.h5"], capture_output=True, text=True, timeout=120)
        self.require_status(job, program.FINISHED)
        with h5py.File(self.output / "blow.h5") as file:
            return file["audio/blow"][()]

    def test_refuses_recordings_that_cannot_be_used(self):
        time = numpy.arange(int(0.3 * RATE)) / RATE
        tone = numpy.exp(-20 * time) * numpy.sin(2 * numpy.pi * 800 * time)
        good, silent = self.output / "good.wav", self.output / "silent.wav"
        write_wav(good, [tone], 0.5)
        for name, samples in (("loud", [numpy.clip(2 * tone, -1, 1)]), ("wide", [tone, tone]), ("short", [tone[:1000]])):
            write_wav(self.output / f"{name}.wav", samples)
        write_wav(silent, [0 * tone], 0)
        silent.write_bytes(silent.read_bytes()[:44] + bytes(2 * len(tone)))
        slow = bytearray(good.read_bytes())
        slow[24:28] = (22050).to_bytes(4, "little")
        (self.output / "slow.wav").write_bytes(slow)
        write_wav(self.output / "hum.wav", [0.5 * numpy.sin(2 * numpy.pi * 800 * time)])
        for answer, blows in ((r"deck.yaml:6:15: .*loud.wav: channel 1 is clipped at", ["loud"]),
                              (r"silent.wav: channel 1 is silent", ["silent"]),
                              (r"wide.wav: has 2 channels, but the deck's listeners are 1 microphones", ["wide"]),
                              (r"slow.wav: has 22050 samples per second, the recordings before it have 44100", ["good", "slow"]),
                              (r"short.wav: less than 0.05 s are left", ["short"]),
                              (r"the recordings of body 'bar' have no partials that decay", ["hum"])):
            deck = self.output / "deck.yaml"
            lines = "".join(f"      {{sound: {name}.wav, at: [0.05, 0, 0.005], direction: [0, 0, -1]}},\n" for name in blows)
            deck.write_text(f"name: bar\nmeasured_bodies:\n  bar: {{mesh: {program.SOURCE}/meshes/bar.geo, mass: 0.2,\n"
                            f"    parameters: {{size: 0.1}},\n    blows: [\n{lines}]}}\n"
                            "listeners: {ear: {type: mono, position: [0, 0, 0.5]}}\n")
            self.assertRegex(self.map(deck, status=program.WRONG_DECK), answer)
        deck.write_text(deck.read_text().replace("hum.wav", "good.wav").replace("0.05, 0, 0.005", "0.05, 0, 0.05"))
        self.assertRegex(self.map(deck, status=program.WRONG_DECK), r"deck.yaml:6:.*nearest")
        self.assertRegex(self.map(deck, "--radiation", "kirchhoff", status=program.FAILED), "no meaning for measured bodies")
        deck.write_text(deck.read_text().replace("0.05, 0, 0.05", "0.05, 0, 0.005").replace("type: mono", "type: binaural"))
        self.assertIn("has no head", self.map(deck, status=program.WRONG_DECK))


if __name__ == "__main__":
    unittest.main()
