#!/usr/bin/python3
"""`idiophone map` and `idiophone export`: the same bits on any ranks, Faust that sounds the same, and answers to wrong options."""
import json
import shutil
import subprocess
import unittest

import h5py
import numpy

import program

RATE = 44100
DRIVER = """
#include <cstdio>
struct Meta { void declare(const char*, const char*) {} };
struct UI {
  template <class... T> void declare(T...) {}
  template <class... T> void addHorizontalSlider(T...) {}
  template <class... T> void openVerticalBox(T...) {}
  void closeBox() {}
};
struct dsp { virtual ~dsp() = default; };
#define FAUSTFLOAT double
<<includeIntrinsic>>
<<includeclass>>
int main(int, char** arguments) {
  const int samples = atoi(arguments[1]), pulse = atoi(arguments[2]);
  double* force = new double[samples]();
  double* pressure = new double[samples];
  for (int i = 0; i < pulse; ++i) force[i] = i;  // a ramp
  mydsp* body = new mydsp;
  body->init(44100);
  body->compute(samples, &force, &pressure);
  for (int i = 0; i < samples; ++i) printf("%.17g\\n", pressure[i]);
}
"""


def sound(path, at, force):
    """Pressure at the first listener without its delay, as docs/method/sound_map.md says; the force is linear between samples."""
    with h5py.File(path) as file:
        vertex = numpy.argmin(numpy.linalg.norm(file["surface/vertices"][()] - at, axis=1))
        drive = -file["modes/shape"][:, vertex, 2].astype(float)
        pressure = file["listeners/pressure"][:, 0, :] @ [1, 1j]
        decay, frequency = file["modes/decay"][()], file["modes/frequency"][()]
    total = numpy.zeros(len(force))
    lowest = numpy.sqrt((2 * numpy.pi * frequency[0]) ** 2 - decay[0] ** 2)
    smooth, rise = 0, numpy.zeros(len(force))  # N, N/s: F' = w (F - F_smooth), of lines between the samples
    for n in range(len(force)):
        if n:
            change, kept = (force[n] - force[n - 1]) * RATE, numpy.exp(-lowest / RATE)
            smooth = force[n] - change / lowest + kept * (smooth - force[n - 1] + change / lowest)
        rise[n] = lowest * (force[n] - smooth)
    for gain, d, f in zip(drive * pressure, decay, frequency):
        x = 1j * numpy.sqrt((2 * numpy.pi * f) ** 2 - d ** 2) - d
        step = 1 / RATE
        growth = numpy.exp(x * step)
        whole = (growth - 1) / x
        now = (whole - step) / (x * step)
        z = 0
        amplitude = gain * (1 + 1j * d / x.imag)
        for n in range(len(force)):
            z = growth * z + now * force[n] + ((whole - now) * force[n - 1] if n else 0)
            total[n] += (amplitude * (z + force[n] / x + rise[n] / x ** 2)).real
    return total


class Map(program.TestCase):
    def map(self, ranks=None, *arguments):
        return program.idiophone("map", program.deck("simple"), "--output-folder", self.output, *arguments, ranks=ranks)

    def path(self):
        return self.output / "simple_plate.map.h5"

    def test_has_the_same_bits_on_any_ranks(self):
        self.require_status(self.map(None, "--up-to", "700"), program.FINISHED)
        alone = program.contents(self.path())
        modes = alone["modes/frequency"]
        self.assertTrue(650 < modes.max() <= 700 and len(modes) > 5, modes)
        self.assertEqual(alone["sphere/pressure"].shape, (len(modes), 512, 2))
        numpy.testing.assert_allclose(alone["modes/material_decay"],
                                      0.5 * (20 + 1e-7 * (2 * numpy.pi * modes) ** 2), rtol=1e-9)
        for ranks in program.OTHER_RANKS:
            self.require_status(self.map(ranks, "--up-to", "700"), program.FINISHED)
            self.require_same(self.path(), alone)

    def test_wrong_options_are_answered(self):
        job = self.map(None, "--modes", "3", "--json")
        self.require_status(job, program.FINISHED)
        made, = json.loads(job.stdout)["maps"]
        self.assertEqual((made["file"], made["body"], made["modes"]), (str(self.path()), "plate", 3))
        self.assertLess(made["lowest_frequency"], made["highest_frequency"])
        for arguments, answer in ((), "nothing to do"), (("--faust", self.output / "a", "--listener", "qq"), "no listener 'qq'"):
            job = program.idiophone("export", self.path(), *arguments)
            self.require_status(job, program.FAILED)
            self.assertIn(answer, job.stderr)
        job = self.map(None, "--up-to", "50")
        self.require_status(job, program.FAILED)
        self.assertRegex(job.stderr, r"no modes up to 50 Hz: its lowest one is at \d+\.?\d* Hz \(--up-to more than that, or --modes\)")

    def test_the_error_of_the_mesh_is_that_of_modes(self):
        job = self.map(None, "--modes", "4", "--json")
        self.require_status(job, program.FINISHED)
        made, = json.loads(job.stdout)["maps"]
        self.require_status(program.idiophone("modes", program.deck("simple"), "--modes", "4", "--output-folder", self.output),
                            program.FINISHED)
        wanted = program.contents(self.output / "simple_modes.h5")["modes/plate/mesh_error"]
        numpy.testing.assert_allclose(made["mesh_errors"], wanted, atol=1e-3)
        numpy.testing.assert_array_equal(program.contents(self.path())["modes/mesh_error"], made["mesh_errors"])
        largest = numpy.abs(wanted).argmax()
        self.assertIn(f"up to {abs(wanted[largest]):.1f} cents (mode {largest + 1})", self.map(None, "--modes", "4").stdout)
        job = self.map(None, "--modes", "4", "--no-estimate", "--json")
        self.assertEqual(json.loads(job.stdout)["maps"][0]["mesh_errors"], [])
        self.assertNotIn("modes/mesh_error", program.contents(self.path()))

    def test_stopped_by_a_signal_it_saves_the_modes_that_it_has(self):
        status, said = program.stopped_when_it_says("2 of about 40 modes of plate", "map", program.deck("simple"), "--output-folder",
                                                    self.output, "--modes", 40, "--no-estimate", "--radiation", "boundary_elements")
        self.assertEqual(status, program.RESUMABLE, said)
        found = program.contents(self.path())
        modes = len(found["modes/frequency"])
        self.assertTrue(2 <= modes < 40, modes)
        self.assertIn(f"left out {40 - modes} of 40 modes of plate", said)
        self.assertEqual(len(found["listeners/pressure"]), modes)
        self.require_status(program.idiophone("info", "--verify", self.path()), program.FINISHED)

    def test_a_body_without_modes_does_not_keep_the_others_from_theirs(self):
        deck = self.output / "two.yaml"
        deck.write_text("""
name: two
ideal_bodies:
  short: {type: string, length: 0.001, width: 0.0005, tension: 70, density: 4.0e-4}
  long: {type: string, length: 0.65, width: 0.001, tension: 70, density: 4.0e-4, position: [1, 0, 0]}
listeners:
  ear: {type: mono, position: [0, 0, 1]}
""")
        for ranks in None, 2:
            job = program.idiophone("map", deck, "--output-folder", self.output, "--up-to", 1000, "--json", ranks=ranks)
            self.require_status(job, program.FAILED)
            self.assertIn("1 of 2 bodies have no map; body 'short' has no modes up to 1000 Hz: its lowest one is at 209165 Hz",
                          job.stderr)
            self.assertTrue((self.output / "two_long.map.h5").exists())
            self.assertFalse((self.output / "two_short.map.h5").exists())
        refused = program.idiophone("map", deck, "--output-folder", self.output, "--estimate")
        self.require_status(refused, program.FAILED)
        self.assertIn("--estimate is for solids", refused.stderr)
        answer = json.loads(job.stdout[:job.stdout.rindex("}") + 1])
        self.assertEqual([made["body"] for made in answer["maps"]], ["long"])
        self.assertEqual([missing["body"] for missing in answer["without_modes"]], ["short"])

    def test_examples_of_ideal_bodies(self):
        for name, bodies in (("drums", 4), ("plates", 4)):
            job = program.idiophone("map", program.SOURCE / f"inputs/ideal/{name}.yaml", "--modes", 4, "--json",
                                    "--output-folder", self.output)
            self.require_status(job, program.FINISHED)
            self.assertEqual(len(json.loads(job.stdout)["maps"]), bodies)
        tabla = program.contents(self.output / "drums_tabla.map.h5")["modes/frequency"]
        numpy.testing.assert_allclose(tabla / tabla[0], (1, 1.94, 1.94, 2.95), rtol=0.01)
        job = program.idiophone("map", program.SOURCE / "inputs/ideal/drums.yaml", "--output-folder", self.output,
                                "--set", "ideal_bodies.tabla.density=0.3 - 10*x")
        self.require_status(job, program.WRONG_DECK)
        self.assertRegex(job.stderr, r"drums.yaml:\d+:\d+: ideal_bodies.tabla.density: the formula gives -")

    @unittest.skipUnless(shutil.which("faust"), "needs Debian's faust")
    def test_faust_sounds_the_same(self):
        self.require_status(self.map(None, "--modes", "12"), program.FINISHED)
        with h5py.File(self.path()) as file:
            vertices = file["surface/vertices"][()]
        at = vertices[numpy.argmin(numpy.linalg.norm(vertices - [0.04, 0.03, 0.01], axis=1))]
        self.require_status(program.idiophone("export", self.path(), "--faust", self.output / "plate.dsp", "--at",
                                              ",".join(map(repr, at.tolist()))), program.FINISHED)
        (self.output / "driver.cpp").write_text("#include <cstdlib>\n" + DRIVER)
        subprocess.run(["faust", "-double", "-a", self.output / "driver.cpp", self.output / "plate.dsp", "-o",
                        self.output / "plate.cpp"], check=True)
        subprocess.run(["c++", "-O0", self.output / "plate.cpp", "-o", self.output / "plate"], check=True)
        samples, pulse = 4000, 30
        answer = subprocess.run([self.output / "plate", str(samples), str(pulse)], check=True, capture_output=True, text=True)
        played = numpy.array([float(line) for line in answer.stdout.split()])
        force = numpy.concatenate([numpy.arange(pulse), numpy.zeros(samples - pulse)])
        expected = sound(self.path(), at, force)
        self.assertGreater(numpy.abs(expected).max(), 0)
        error = numpy.linalg.norm(played - expected) / numpy.linalg.norm(expected)
        self.assertLess(20 * numpy.log10(error), -60)


if __name__ == "__main__":
    unittest.main()
