#!/usr/bin/python3
"""Scraping and rolling: bodies sound at their modes, and not by the slow force that holds them down."""
import unittest

import h5py
import numpy

import program

RATE = 48000
STEEL_ROLL = "mass: 0.05, hardness: 1e10, size: 2e-4, roughness: {height: 1e-7}"
RING = """
name: small
time: {duration: 0.01}
materials:
  brass: {young: 1.0e11, poisson: 0.34, density: 8500, damping: {stiffness: 2.0e-9}}
bodies:
  ring: {mesh: ring.geo, material: brass, element: tet10}
listeners:
  ear: {type: mono, position: [0.1, 0, 0.5]}
"""
RING_MESH = """
SetFactory("OpenCASCADE");
Disk(1) = {0, 0, 0, 0.02};
Disk(2) = {0, 0, 0, 0.014};
BooleanDifference(3) = {Surface{1}; Delete;}{Surface{2}; Delete;};
Extrude {0, 0, 0.004} {Surface{3};}
MeshSize{:} = 0.006;
"""
IDEAL = """
name: ideal
ideal_bodies:
  membrane: {type: membrane, radius: 0.05, size: 0.01, tension: 2000, density: 0.25, friction: 0.002}
  string: {type: string, length: 0.3, width: 0.001, tension: 70, density: 4.0e-4, friction: 0.001, position: [5, 0, 0]}
  bar: {type: bar, length: 0.1, width: 0.03, stiffness: 50, density: 0.8, ends: free, friction: 0.003, position: [10, 0, 0]}
  plate: {type: plate, length: 0.1, width: 0.08, stiffness: 140, density: 15, friction: 0.004, position: [15, 0, 0]}
listeners:
  ear: {type: mono, position: [0.5, 0.5, 1]}
"""
# Where a contact moves 3 cm over each body.
WAYS = {"ring": ([0.017, -0.015, 0.004], [0.017, 0.015, 0.004]),
        "membrane": ([-0.02, 0.01, 0], [0.01, 0.01, 0]),
        "string": ([5.03, 0, 0], [5.06, 0, 0]),
        "bar": ([10.02, 0.01, 0], [10.05, 0.01, 0]),
        "plate": ([15.02, 0.03, 0], [15.05, 0.03, 0])}
STROKES = {"roll": "speed: 0.2, load: 0.5, " + STEEL_ROLL,
           "scrape": "speed: 0.2, load: 2, mass: 0.02, hardness: 1e9, friction: 0.3, roughness: {height: 1e-6}"}


class Strokes(program.TestCase):
    def play(self, body, score):
        """The sound of a score on the map of a body, [samples], up to a factor, and the map's frequencies, Hz."""
        path, wav = self.output / "score.yaml", self.output / "sound.wav"
        path.write_text(score)
        found, = self.output.glob(f"*_{body}.map.h5")
        self.require_status(program.idiophone("play", found, "--score", path, "--output", wav, "--rate", RATE), program.FINISHED)
        with h5py.File(found) as file:
            return program.wav_samples(wav).astype(float), file["modes/frequency"][()]

    def require_tone(self, body):
        """The parts of the sound within 3 % of the modes are louder than that below 20 Hz."""
        begin, end = WAYS[body]
        for kind, keys in STROKES.items():
            sound, modes = self.play(body, f"duration: 0.5\nevents:\n  - {{time: 0.1, type: {kind}, from: {begin}, to: {end}, "
                                           f"direction: [0, 0, -1], {keys}}}\n")
            power = numpy.abs(numpy.fft.rfft(sound)) ** 2
            frequency = numpy.fft.rfftfreq(len(sound), 1 / RATE)
            at_modes = numpy.any(numpy.abs(frequency[:, None] / modes - 1) < 0.03, axis=1)
            level = 10 * numpy.log10(power[at_modes].sum() / power[frequency < 20].sum())
            print(f"{body}, {kind}: lowest mode {modes[0]:.0f} Hz, {level:.1f} dB over what is below 20 Hz")
            self.assertGreater(level, 20, f"{body}, {kind}")

    def test_a_slow_force_is_as_quiet_as_in_the_run_of_its_body(self):
        slow = ["--set", "time.duration=0.1", "--set", "loads.tap.duration=0.1", "--set", "radiation.model=kirchhoff",
                "--set", "radiation.visibility=off", "--set", "audio.dc_block=0", "--output-folder", self.output]
        self.require_status(program.idiophone("run", program.deck("simple"), *slow), program.FINISHED)
        with h5py.File(self.output / "simple.h5") as file:
            ran, rate = file["audio/ear"][:, 0], file["audio/ear"].attrs["rate"]
        self.require_status(program.idiophone("map", program.deck("simple"), "--up-to", 2000, "--radiation", "kirchhoff",
                                              "--output-folder", self.output), program.FINISHED)
        played, modes = self.play("plate", "duration: 0.1\nwav_full_scale: 1\nevents:\n  - {time: 0, type: force, "
                                           "at: [0.04, 0.03, 0.01], force: [0, 0, -0.5], shape: half_sine, duration: 0.1}\n")

        def slow_part(sound, rate):
            """What is below a third of the lowest mode, as a share of the louder mode that rings when the force begins."""
            amplitude = numpy.abs(numpy.fft.rfft(sound * numpy.hanning(len(sound))))
            frequency = numpy.fft.rfftfreq(len(sound), 1 / rate)
            return amplitude[frequency < modes[0] / 3].max() / amplitude[frequency > modes[0] / 2].max()

        in_run, in_play = slow_part(ran, rate), slow_part(played, RATE)
        print(f"lowest mode {modes[0]:.0f} Hz; slow part {in_run:.3g} of the mode in the run, {in_play:.3g} in play")
        self.assertLess(in_play, max(2 * in_run, 0.1))

    def test_a_small_stiff_ring_sounds_at_its_modes(self):
        (self.output / "ring.geo").write_text(RING_MESH)
        (self.output / "small.yaml").write_text(RING)
        self.require_status(program.idiophone("map", self.output / "small.yaml", "--modes", 6, "--radiation", "kirchhoff",
                                              "--output-folder", self.output), program.FINISHED)
        self.require_tone("ring")

    def test_ideal_bodies_sound_at_their_modes(self):
        (self.output / "ideal.yaml").write_text(IDEAL)
        self.require_status(program.idiophone("map", self.output / "ideal.yaml", "--modes", 6, "--output-folder", self.output),
                            program.FINISHED)
        for body in WAYS:
            if body != "ring":
                self.require_tone(body)


if __name__ == "__main__":
    unittest.main()
