#!/usr/bin/python3
"""A body from a damaged surface sounds as a whole one: `run` on any number of ranks and resumed, `map` and `radiate`."""
import json
import sys
import unittest

import h5py
import numpy

import program

sys.path.insert(0, str(program.SOURCE / "ctest/solids/mesher"))
from damaged_surfaces import box, with_fins, with_holes, write_obj

SIZE = numpy.array((0.1, 0.08, 0.06))  # m
DECK = """\
name: block
time: {duration: 0.008}
materials:
  plastic: {young: 2.0e9, poisson: 0.35, density: 1150, damping: {mass: 100}}
bodies:
  block: {mesh: %s, parameters: %s, %s material: plastic}
loads:
  tap: {body: block, at: [0.03, 0.02, 0.03], radius: 0.01, force: [0, 0, -50], duration: 1.0e-4}
listeners:
  ear: {type: mono, position: [0.1, 0.2, 0.5]}
audio: {rate: 44100, max_frequency: 15000, dc_corner: 20}
radiation: {model: kirchhoff}
"""
SHORT = "--set", "time.duration=0.002"


class Repaired(program.TestCase):
    def setUp(self):
        super().setUp()
        random = numpy.random.default_rng(2)
        surface = self.output / "block.obj"
        write_obj(surface, with_fins(with_holes(box(-SIZE / 2, SIZE / 2), random), random))
        self.damaged = self.deck("damaged", surface, "{size: 0.02}", "meshing: {repair: wrap},")
        parameters = "{length: 0.1, width: 0.08, thickness: 0.06, size: 0.02, layers: 3}"
        self.whole = self.deck("whole", program.SOURCE / "meshes/bar.geo", parameters, "")

    def deck(self, name, *keys):
        path = self.output / f"{name}.yaml"
        path.write_text(DECK % keys)
        return path

    def answer(self, command, deck, *arguments, ranks=None):
        job = program.idiophone(command, deck, "--output-folder", self.output / deck.stem, *arguments, ranks=ranks)
        self.require_status(job, program.FINISHED)
        return job

    def test_a_run_has_the_same_bits_on_any_ranks_and_resumed(self):
        sounds = set()
        for ranks in 1, *program.OTHER_RANKS:
            folder = self.output / f"ranks_{ranks}"
            job = program.idiophone("run", self.damaged, *SHORT, "--output-folder", folder, ranks=ranks)
            self.require_status(job, program.FINISHED)
            sounds.add((folder / "block.wav").read_bytes())
        folder = self.output / "resumed"
        self.run_in_jobs(self.damaged.with_suffix(""), folder, *SHORT, ranks=(2, 1) * 5)
        sounds.add((folder / "block.wav").read_bytes())
        self.assertEqual(len(sounds), 1)

    def test_a_run_has_the_levels_of_the_whole_block(self):
        spectra = {}
        for deck in self.damaged, self.whole:
            self.answer("run", deck)
            sound = program.wav_samples(self.output / deck.stem / "block.wav")
            spectra[deck] = abs(numpy.fft.rfft(sound * numpy.hanning(len(sound))))
        difference = 20 * numpy.log10(numpy.linalg.norm(spectra[self.damaged]) / numpy.linalg.norm(spectra[self.whole]))
        self.assertAlmostEqual(difference, 0, delta=1)

    def test_its_map_has_the_modes_of_the_whole_block(self):
        maps = []
        for deck in self.damaged, self.whole:
            self.answer("map", deck, "--modes", 5, "--no-estimate", "--radiation", "kirchhoff")
            with h5py.File(self.output / deck.stem / "block_block.map.h5") as file:
                maps.append((file["modes/frequency"][()], file["modes/radiation_decay"][()]))
        cents = 1200 * numpy.log2(maps[0][0] / maps[1][0])
        self.assertLess(abs(cents).max(), 20, cents)
        decays = 10 * numpy.log10(maps[0][1] / maps[1][1])
        self.assertLess(abs(decays).max(), 0.5, decays)

    def test_its_modes_radiate_as_those_of_the_whole_block(self):
        power = []
        for deck in self.damaged, self.whole:
            job = self.answer("radiate", deck, "--modes", 3, "--tolerance", 0, "--json", ranks=2)
            power.append([10 * numpy.log10(sound["power"]) for sound in json.loads(job.stdout)["sounds"]])
        self.assertLess(abs(numpy.subtract(*power)).max(), 1, power)


if __name__ == "__main__":
    unittest.main()
