#!/usr/bin/python3
"""Large amplitudes in the Sonic Explorer: a sheet that is struck hard sounds as `play` has it, and higher than after a soft blow."""
import json
import pathlib
import shutil
import unittest

import numpy

import program
from hearing import spectrum
from web import in_browser, page_of_room

RATE, DURATION, SIZE = 44100, 0.3, 1.25
SPEEDS = {"soft": 0.01, "hard": 2}  # m/s
MESH = program.SOURCE / "meshes/square_plate.geo"
DECK = f"""
name: room
time: {{duration: 0.1}}
materials:
  metal: {{young: 2.0e11, poisson: 0.3, density: 7850, damping: {{mass: 20, stiffness: 1.0e-7}}}}
bodies:
  sheet:
    mesh: {MESH}
    parameters: {{side: 0.2, thickness: 0.001, size: 0.05}}
    element: tet10
    material: metal
    fixed: [rim]
    model: {{type: modal, up_to: 2500, large_amplitudes: true}}
listeners:
  ear: {{type: mono, position: [0.1, 0, 0.4]}}
"""
BLOW = "{{time: 0.05, at: [0.021, 0.013, 0.0005], direction: [0, 0, -1], mass: 0.02, hardness: 1e8, speed: {speed}}}"


def hammer(speed):
    return {"mass": 0.02, "hardness": 1e8, "speed": speed}


def pitch(sound):
    """Of the lowest mode, Hz, in the first 0.1 s after the blow."""
    frequency, amplitude = spectrum(sound[int(0.06 * RATE):int(0.16 * RATE)], RATE)
    low = frequency < 450
    return frequency[low][numpy.argmax(amplitude[low])]


class LargeAmplitudes(program.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(program.tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        page, (cls.map,) = page_of_room(cls.folder, DECK, ["sheet"], 2500)
        blows = [{"time": 0.05, "body": 0, "origin": [0.021, 0.013, 1], "direction": [0, 0, -1], "hammer": hammer(speed)}
                 for speed in SPEEDS.values()]
        given = {"blows": blows, "size": SIZE, "duration": DURATION, "rate": RATE}
        cls.seen = in_browser("large.mjs", page, json.dumps(given))

    def setUp(self):
        super().setUp()
        if not self.seen["heard"]:
            self.skipTest("the program was built without WebAssembly")

    def played(self, speed, more=""):
        """The sound of `play`, up to its scale."""
        score, wav = self.output / "score.yaml", self.output / "sound.wav"
        score.write_text(f"duration: {DURATION}\nevents:\n  - {BLOW.format(speed=speed)}\n{more}")
        job = program.idiophone("play", self.map, "--score", score, "--output", wav, "--rate", RATE)
        self.require_status(job, program.FINISHED)
        return program.wav_samples(wav).astype(float)

    def difference(self, heard, expected):
        """dB"""
        scaled = expected * numpy.dot(expected, heard) / numpy.dot(expected, expected)
        return 20 * numpy.log10(numpy.linalg.norm(heard - scaled) / numpy.linalg.norm(heard))

    def test_blows_sound_as_play_has_them(self):
        for (name, speed), heard in zip(SPEEDS.items(), self.seen["heard"]["sounds"], strict=True):
            difference = self.difference(numpy.array(heard), self.played(speed))
            print(f"{name}: the page and play differ by {difference:.1f} dB")
            self.assertLess(difference, -60, name)

    def test_a_longer_body_sounds_as_play_has_it(self):
        more = f"  - {{type: tune, time: 0, size: {SIZE}}}\n"
        self.assertLess(self.difference(numpy.array(self.seen["heard"]["sized"]), self.played(SPEEDS["hard"], more)), -60)

    def test_a_hard_blow_sounds_higher(self):
        soft, hard = (pitch(numpy.array(sound)) for sound in self.seen["heard"]["sounds"])
        print(f"soft {soft:.1f} Hz, hard {hard:.1f} Hz; a second takes {self.seen['heard']['load']:.2f} s")
        self.assertGreater(1200 * numpy.log2(hard / soft), 50)

    def test_without_webassembly_vibrations_are_small_ones(self):
        soft = numpy.array(self.seen["heard"]["sounds"][0])
        self.assertLess(self.difference(numpy.array(self.seen["heard"]["javascript"]), soft), -30)

    def test_the_page_doubts_blows_that_turn_the_parts_far(self):
        self.assertRegex(self.seen["told"], r"^sheet vibrates so strongly .* turn by more than 0\.1 rad")
        self.assertEqual(self.seen["complaints"], [])


if __name__ == "__main__":
    unittest.main()
