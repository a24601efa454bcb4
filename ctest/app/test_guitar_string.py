#!/usr/bin/python3
"""A string whose end lies on the bridge of a plate: its modes are those of waves on a string that ends in the receptance of plate
and bridge (N. H. Fletcher and T. D. Rossing, The Physics of Musical Instruments, sections 2.12 and 9.6; C. E. Gough, Acustica 49,
1981, 124)."""
import unittest

import h5py
import numpy

import program

DECK = program.SOURCE / "inputs/joined/guitar_string.yaml"
SADDLE = (0.65, 0, 0)  # where the string lies on the bridge, m
STRESS, DENSITY, SADDLE_STIFFNESS = 4.0744e8, 7850, 3.0e12  # as in the deck: Pa, kg/m3, Pa/m
WITHOUT_STRING = ("bodies.string=null", "joints.saddle=null", "loads=null")
STRING_ALONE = ("joints=null", "bodies.string.fixed=[ends]")


class GuitarString(program.TestCase):
    def modes(self, body, count, *settings):
        """What `idiophone modes` finds, of one body."""
        changes = [word for setting in settings for word in ("--set", setting)]
        folder = self.output / f"{body}_{count}"
        self.require_status(program.idiophone("modes", DECK, "--body", body, "--modes", count, "--no-estimate",
                                              "--output-folder", folder, *changes), program.FINISHED)
        result, = folder.glob("*.h5")
        with h5py.File(result) as file:
            found = {name: data[()] for name, data in file[f"modes/{body}"].items()}
            return found | {"nodes": file[f"mesh/{body}/nodes"][()]}

    def receptance(self, bridge, section):
        """Displacement of the bridge over a vertical force of the string, at a complex angular frequency, m/N."""
        saddle = numpy.argmin(numpy.linalg.norm(bridge["nodes"] - SADDLE, axis=1))
        shape, own = bridge["shape"][:, saddle, 2], 2 * numpy.pi * bridge["frequency"]
        damped = own**2 * (1 + 2j * bridge["damping_ratio"])
        return lambda w: numpy.sum(shape**2 / (damped - w**2)) + 1 / (SADDLE_STIFFNESS * section)

    def coupled(self, string, receptance, section, guess):
        """The complex angular frequency near a guess at which waves fit on the string: tan(k L) = -T k receptance."""
        frequency, damping = string["frequency"][::2], string["damping_ratio"][::2]  # both directions are alike
        fundamental = frequency / numpy.arange(1, len(frequency) + 1)
        impedance = section * numpy.sqrt(STRESS * DENSITY)  # kg/s

        def misfit(w):
            at = w.real / (2 * numpy.pi)
            turn = w / (2 * numpy.interp(at, frequency, fundamental) * (1 + 1j * numpy.interp(at, frequency, damping)))
            return numpy.sin(turn) + impedance * w * receptance(w) * numpy.cos(turn)

        w = guess
        for _ in range(30):  # Newton's method
            step = 1e-7 * w
            w -= misfit(w) * step / (misfit(w + step) - misfit(w))
        return w

    def test_modes_are_those_of_a_string_on_the_receptance_of_the_plate(self):
        string = self.modes("string", 12, *STRING_ALONE)
        receptance = self.receptance(self.modes("bridge", 30, *WITHOUT_STRING), section := 1.94035e-7)  # m2, of the mesh
        tied = self.modes("string", 14)
        up = numpy.ptp(tied["shape"][:, :, 2], axis=1) > numpy.ptp(tied["shape"][:, :, 1], axis=1)  # not to the side
        on_string = up & (numpy.abs(tied["shape"][:, :, 2]).max(axis=1) > 5)
        self.assertGreaterEqual(numpy.count_nonzero(on_string), 5)
        for frequency, damping in zip(tied["frequency"][on_string], tied["damping_ratio"][on_string], strict=True):
            found = self.coupled(string, receptance, section, 2 * numpy.pi * frequency * (1 + 1j * damping))
            cents = 1200 * numpy.log2(2 * numpy.pi * frequency / found.real)
            print(f"{frequency:.2f} Hz, {cents:+.2f} cents; damping ratio {damping:.5f}, reference {found.imag / abs(found):.5f}")
            self.assertLess(abs(cents), 2.5)
            self.assertLess(abs(damping / (found.imag / abs(found)) - 1), 0.05)
        # Near the plate's lowest mode, the string gives it its energy. To the side it does not.
        first_up, first_aside = (tied["decay_time"][direction & (tied["frequency"] < 180)].min() for direction in (up, ~up))
        self.assertLess(5 * first_up, first_aside)


if __name__ == "__main__":
    unittest.main()
