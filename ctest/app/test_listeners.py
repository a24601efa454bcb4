#!/usr/bin/python3
"""What listeners hear of a ball that is shaken: Doppler shift, patterns, a floor, heads."""
import json
import math
import sys
import unittest

import h5py
import numpy

import program

sys.path.insert(0, str(program.SOURCE / "tools/fuzz"))
import seeds

SPEED = 343.0    # of sound, m/s
TONE = 440.0     # Hz
RATE = 8000      # audio samples per second


class Listeners(program.TestCase):
    def shake(self, listeners, *settings, output="shaken", duration=0.1):
        """The sounds, by listener, of a ball that moves along z as the sine of a tone. Nothing of it bends: it is quick."""
        motion = f"{{group: body, displacement: [0, 0, 1e-4], shape: sine, frequency: {TONE}}}"
        deck = (f"bodies.ball.driven=[{motion}]", f"time={{duration: {duration}, steps_per_sample: 12}}",
                f"audio={{rate: {RATE}, max_frequency: 4000}}", f"listeners={{{listeners}}}", *settings)
        arguments = [word for setting in deck for word in ("--set", setting)]
        self.require_status(program.run("free", self.output / output, *arguments), program.FINISHED)
        with h5py.File(self.output / output / "free.h5") as file:
            return {name: sound[()].T for name, sound in file["audio"].items()}

    def frequency(self, sound, start):
        """Of a tone whose level may change slowly: the slope of its phase."""
        later = sound[round(start * RATE):]
        time = numpy.arange(len(later)) / RATE
        window = numpy.hanning(129)
        carried = numpy.convolve(later * numpy.exp(-2j * math.pi * TONE * time), window / window.sum(), "valid")
        return TONE + numpy.polyfit(numpy.arange(len(carried)) / RATE, numpy.unwrap(numpy.angle(carried)), 1)[0] / (2 * math.pi)

    def path(self, name, *rows):
        file = self.output / name
        file.write_text("".join(", ".join(map(str, row)) + "\n" for row in rows))
        return file

    def test_a_listener_that_recedes_hears_the_doppler_shift(self):
        for velocity in (20.0, -20.0):
            path = self.path("recede.csv", (0, 0, 0, 8), (1, 0, 0, 8 + velocity))
            sound = self.shake(f"ear: {{type: mono, path: {path}}}", duration=0.2)["ear"][0]
            self.assertAlmostEqual(self.frequency(sound, 0.05) / (TONE * (1 - velocity / SPEED)), 1, delta=1e-4)

    def test_a_listener_that_turns_a_corner_hears_no_click(self):
        path = self.path("corner.csv", (0, 0, 0, 2), (0.05, 0.5, 0, 2), (0.1, 0.5, 0, 1.5), (0.2, 0.5, 0, 1.5))
        sound = self.shake(f"ear: {{type: mono, path: {path}}}", "radiation={model: huygens}", "audio.dc_corner=10",
                           duration=0.2)["ear"][0][200:]
        smooth = (2 * math.pi * TONE * (1 + 15 / SPEED) / RATE) ** 2
        self.assertLess(numpy.abs(numpy.diff(sound, 2)).max(), 1.1 * smooth * numpy.abs(sound).max())

    def test_microphones_have_their_patterns(self):
        keys = "type: mono, position: [0, 0, 5]"
        sounds = self.shake(f"omni: {{{keys}}}, away: {{{keys}, look: [0, 0, 1], pattern: cardioid}}, "
                            f"towards: {{{keys}, look: [0, 0, -1], pattern: cardioid}}, "
                            f"aside: {{{keys}, look: [0, 1, 0], pattern: figure_of_eight}}, "
                            f"slant: {{{keys}, look: [0, 1, -1], pattern: 0.75}}")
        level = {name: numpy.abs(sound).max() for name, sound in sounds.items()}
        self.assertGreater(level["omni"], 0)
        self.assertAlmostEqual(level["towards"] / level["omni"], 1, delta=1e-3)
        self.assertAlmostEqual(level["slant"] / level["omni"], 0.25 + 0.75 * math.sqrt(0.5), delta=1e-3)
        for name in ("away", "aside"):
            self.assertLess(level[name] / level["omni"], 2e-3)

    def test_a_floor_gives_what_is_heard_at_the_image_besides(self):
        below = self.shake("here: {type: mono, position: [0.5, 0.2, 0.7]}, there: {type: mono, position: [0.5, 0.2, -0.9]}")
        above = self.shake("here: {type: mono, position: [0.5, 0.2, 0.7]}",
                           "radiation={floor: {at: [0, 0, -0.1], reflection: -0.8}}", output="floor")
        expected = below["here"] - 0.8 * below["there"]
        numpy.testing.assert_allclose(above["here"], expected, rtol=0, atol=1e-12 * abs(expected).max())
        self.assertGreater(abs(below["there"]).max(), 0.1 * abs(below["here"]).max())

    def test_a_head_hears_more_at_the_nearer_ear(self):
        head = "type: binaural, position: [0, 0, 2], up: [0, 1, 0]"
        sounds = self.shake(f"front: {{{head}, look: [0, 0, -1]}}, side: {{{head}, look: [-1, 0, 0]}}, "
                            "omni: {type: mono, position: [0, 0, 2]}")
        settled = {name: numpy.abs(sound[:, 300:]).max(axis=1) for name, sound in sounds.items()}
        left, right = settled["front"]
        self.assertAlmostEqual(20 * math.log10(left / right), 0, delta=0.1)
        self.assertAlmostEqual(20 * math.log10(left / settled["omni"][0]), 0, delta=1.5)
        left, right = settled["side"]  # looking to -x with y up, the source at -z is on the right
        self.assertGreater(20 * math.log10(right / left), 3)

    def test_absorbing_air_takes_what_the_standard_says(self):
        keys = "far: {type: mono, position: [0, 0, 40]}"
        clear = self.shake(keys, duration=0.3)["far"][0]
        absorbed = self.shake(keys, "radiation={air: {absorption: true}}", output="absorbed", duration=0.3)["far"][0]
        loss = 20 * math.log10(abs(clear[1600:]).max() / abs(absorbed[1600:]).max())
        self.assertAlmostEqual(loss, 40 * 2.445e-3, delta=0.01)  # 440 Hz, 20 degrees, 50 %: 2.445 dB/km

    def test_what_is_wrong_is_answered_with_its_place(self):
        garbage = self.output / "garbage.sofa"
        garbage.write_text("no responses\n")
        head = f"{{type: binaural, position: [0, 0, 1], look: [0, 0, -1], up: [0, 1, 0], hrtf: {garbage}}}"
        job = program.run("free", self.output, "--set", f"listeners.head={head}", ranks=2)
        self.require_status(job, program.WRONG_DECK)
        self.assertIn("listeners.head.hrtf: ", job.stderr)
        self.assertIn("garbage.sofa has no head-related responses", job.stderr)
        path = self.path("bang.csv", (0, 0, 0, 1), (1, 0, 0, 400))
        job = program.run("free", self.output, "--set", f"listeners.fast={{type: mono, path: {path}}}", ranks=2)
        self.require_status(job, program.WRONG_DECK)
        self.assertIn("must be slower than sound", job.stderr)

    def test_a_damaged_head_ends_the_program_in_time(self):
        seeds.put_head(self.output)
        head = self.output / "head.sofa"
        whole = head.read_bytes()
        one_value = b"\x02\x01\x01\x01\x01" + bytes(7)  # the size of an attribute: HDF5, dataspace message of version 2
        self.assertIn(one_value, whole)
        head.write_bytes(whole.replace(one_value, one_value[:5] + b"\xff" * 7))
        listener = f"{{type: binaural, position: [0, 0, 1], look: [0, 0, -1], up: [0, 1, 0], hrtf: {head}}}"
        job = program.run("free", self.output, "--set", f"listeners.head={listener}")
        self.require_status(job, program.FAILED)
        self.assertIn("head.sofa is damaged: reading it crashes, or does not end", job.stderr)

    def test_a_body_behind_the_floor_is_told(self):
        job = program.run("free", self.output, "--set", "radiation={floor: {at: [0, 0, 0]}}", "--set", "time.duration=0.001")
        self.require_status(job, program.FINISHED)
        self.assertIn("body ball reaches 0.04 m behind radiation.floor", job.stdout + job.stderr)

    def test_listeners_inside_or_near_a_body(self):
        def with_ear(height):
            return "--set", f"listeners={{ear: {{type: mono, position: [0, 0, {height}]}}}}"
        recorded = program.run("free", self.output, "--set", "time.duration=0.001", "--set", "output.surface_motion=true")
        self.require_status(recorded, program.FINISHED)
        deck = program.deck("free")
        for command in (["run", deck], ["check", deck], ["map", deck], ["radiate", deck, "--frequencies", 300],
                        ["listen", self.output / "free.h5"]):
            job = program.idiophone(*command, "--output-folder", self.output, *with_ear(0.03))
            self.require_status(job, program.WRONG_DECK)
            self.assertIn("listeners.ear: ear is inside ball, where there is no air", job.stderr)
        job = program.idiophone("check", deck, "--output-folder", self.output, *with_ear(0.042))
        self.require_status(job, program.FINISHED)
        self.assertRegex(job.stdout + job.stderr, "ear is 0.002 m from ball: nearer than a twentieth of a wavelength")


class FirstExperiment(program.TestCase):
    """The decay of a free bar that is struck off its centre. All modes have the T60 of mass-proportional damping."""
    T60 = 2 * math.log(1000) / 8

    def run_bar(self, *settings):
        arguments = [word for setting in settings for word in ("--set", setting)]
        self.require_status(program.run("bar", self.output, *arguments), program.FINISHED)
        return self.output / "bar.h5"

    def analyze(self, result):
        job = program.idiophone("analyze", result, "--start", "0.08", "--range", "20", "--json")
        self.require_status(job, program.FINISHED)
        partials = {channel["listener"]: channel["partials"] for channel in json.loads(job.stdout)["channels"]}
        return partials, job.stderr

    def require_decays(self, partials):
        self.assertGreaterEqual(len(partials), 2)
        for partial in partials:
            with self.subTest(frequency=partial["frequency"]):
                self.assertAlmostEqual(partial["decay_time"] / self.T60, 1, delta=0.01)

    def test_an_attached_microphone_hears_the_decay_of_the_modes(self):
        partials, warnings = self.analyze(self.run_bar())
        self.require_decays(partials["carried"])
        wrong = [partial for partial in partials["still"] if abs((partial["decay_time"] or 0) / self.T60 - 1) > 0.05]
        self.assertGreater(len(wrong), 0, "the bar turns, so a listener that stands still hears other decays")
        self.assertIn("still: body bar turns by", warnings)
        self.assertNotIn("carried: body bar turns by", warnings)

    def test_listening_again_attached_hears_the_same(self):
        result = self.run_bar("time.duration=0.3", "output.surface_motion=true")
        self.require_status(program.idiophone("listen", result, "--output-folder", self.output, ranks=2), program.FINISHED)
        with h5py.File(result) as run, h5py.File(self.output / "bar_listen.h5") as again:
            for name in ("still", "carried"):
                first, second = run[f"audio/{name}"][()], again[f"audio/{name}"][()]
                numpy.testing.assert_allclose(second, first, rtol=0, atol=1e-4 * abs(first).max())

    def test_a_balanced_blow_leaves_the_bar_in_its_place(self):
        result = self.run_bar("loads.tap.balanced=true")
        with h5py.File(result) as file:
            self.assertLess(abs(file["motion/bar/velocity"][()]).max(), 1e-9)
            turned = file["motion/bar/orientation"][-1]
        self.assertAlmostEqual(abs(turned[0]), 1, delta=1e-9)
        partials, warnings = self.analyze(result)
        self.require_decays(partials["still"])
        self.assertNotIn("turns by", warnings)


if __name__ == "__main__":
    unittest.main()
