#!/usr/bin/python3
"""A kettledrum: the air in the kettle and around it brings the modes of the head near 1 : 1.5 : 2 : 2.5.

The reference is tools/timpani_modes: the same drum by spectral elements in the half plane, which know nothing of the program.
The published frequencies are those of a kettledrum of 65 cm (N. H. Fletcher and T. D. Rossing, The Physics of Musical
Instruments, chapter 18, after R. S. Christian et al., J. Acoust. Soc. Am. 76, 1984, 1336)."""
import json
import unittest

import numpy

import program

DECK = program.SOURCE / "inputs/tension/timpani.yaml"
# An ideal membrane on a cylinder of the same volume, whose wall reaches under the rim.
CYLINDER = ("materials.film={young: 1e8, poisson: 0.38, density: 1396.3}", "bodies.head.parameters.radius=0.328",
            "bodies.kettle.parameters={radius: 0.327, straight: 0.41676, bowl: 0}")
REFERENCE = {"01": (128.78, 30.37), "11": (152.02, 3.45), "21": (228.53, 1.22), "02": (254.01, 21.67), "31": (300.79, 0.33),
             "12": (351.97, 19.43), "41": (371.12, 0.08)}  # Hz, decay rate of the amplitude in 1/s
PUBLISHED = {"01": 127, "11": 150, "21": 227, "02": 252, "31": 298, "41": 366}  # Hz


def cents(frequency, reference):
    return 1200 * numpy.log2(frequency / reference)


class Timpani(program.TestCase):
    def partials(self, *settings):
        """Frequencies, Hz, and decay rates, 1/s (NaN where too little decays), of what the drum sounds."""
        changes = [word for setting in settings for word in ("--set", setting)]
        self.require_status(program.idiophone("run", DECK, "--output-folder", self.output, *changes), program.FINISHED)
        answer = program.idiophone("analyze", self.output / "timpani.h5", "--highest", 500, "--json")
        self.require_status(answer, program.FINISHED)
        found = json.loads(answer.stdout)["channels"][0]["partials"]
        return [(partial["frequency"], 3 * numpy.log(10) / (partial["decay_time"] or numpy.nan)) for partial in found]

    def mode(self, partials, name):
        """The partial that is nearest to a mode of the reference."""
        frequency, decay = REFERENCE[name]
        found, rate = min(partials, key=lambda partial: abs(partial[0] - frequency))
        print(f"({name[0]},{name[1]}): {found:.2f} Hz, reference {frequency:.2f}: {cents(found, frequency):+.1f} cents; "
              f"decay {rate:.2f} 1/s, reference {decay:.2f}")
        return found, rate

    def test_the_kettle_keeps_its_air(self):
        partials = self.partials(*CYLINDER, "time.duration=0.1", "radiation.cell=0.03", "bodies.head.parameters.around=6",
                                 "bodies.head.model.up_to=400")
        for name in ("01", "11", "21", "31"):
            self.assertLess(abs(cents(self.mode(partials, name)[0], REFERENCE[name][0])), 14, name)

    @program.long_verification
    def test_the_modes_are_those_of_head_and_air(self):
        partials = self.partials(*CYLINDER, "time.duration=0.3", "bodies.head.parameters.around=8")
        found = {name: self.mode(partials, name) for name in REFERENCE}
        for name, (frequency, _) in found.items():
            self.assertLess(abs(cents(frequency, REFERENCE[name][0])), 15, name)
        for name in ("01", "11", "02", "12"):
            self.assertLess(abs(found[name][1] / REFERENCE[name][1] - 1), 0.15, name)
        for name, published in PUBLISHED.items():
            ratio = found[name][0] / found["11"][0]
            self.assertLess(abs(cents(ratio, published / PUBLISHED["11"])), 30, name)


if __name__ == "__main__":
    unittest.main()
