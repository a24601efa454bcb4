#!/usr/bin/python3
"""`idiophone radiate`: an exact sound, the same on any ranks, its files, and answers to wrong options."""
import json
import subprocess
import unittest
from xml.etree import ElementTree

import h5py
import numpy

import program

DECK = """\
name: ball
materials:
  rubber_like: {young: 2.0e8, poisson: 0.3, density: 7850, damping: {mass: 2.0}}
bodies:
  ball: {mesh: MESHES/sphere.geo, parameters: {radius: 0.05, size: 0.03}, element: tet10, material: rubber_like}
listeners:
  ear: {type: mono, position: [0, 0, 1.0]}
time: {duration: 0.01}
radiation: {model: kirchhoff}
"""
COARSE = "--set", "bodies.ball.parameters.size=0.06"
VELOCITY_COLUMNS = "frequency,x,y,z,vx,vx_imaginary,vy,vy_imaginary,vz,vz_imaginary"


class Radiate(program.TestCase):
    def radiate(self, *arguments, ranks=None, tolerance=0):
        deck = self.output / "ball.yaml"
        deck.write_text(DECK.replace("MESHES", str(program.SOURCE / "meshes")))
        return program.idiophone("radiate", deck, "--output-folder", self.output, "--tolerance", tolerance, *arguments, ranks=ranks)

    def test_rigid_motion_has_the_sound_of_an_oscillating_sphere(self):
        job = self.radiate("--frequencies", "800", "--json")
        self.require_status(job, program.FINISHED)
        answer = json.loads(job.stdout)
        self.assertEqual([sound["motion"] for sound in answer["sounds"]], ["along x", "along y", "along z"])
        ka = 2 * numpy.pi * 800 / 343 * 0.05
        efficiency = ka**4 / (4 + ka**4)  # l = 1: Re(-i h/h')
        for sound in answer["sounds"]:
            self.assertAlmostEqual(10 * numpy.log10(sound["efficiency"] / efficiency), 0, delta=0.4)
            self.assertIsNone(sound["loss_factor"])
            self.assertAlmostEqual(sound["directivity_index"], 10 * numpy.log10(3), delta=0.1)
            self.assertAlmostEqual(sound["kirchhoff_error"], 0, delta=0.3)
        pressures = [abs(complex(*sound["listeners"]["ear"])) for sound in answer["sounds"]]
        self.assertLess(max(pressures[:2]), 0.02 * pressures[2])

    def test_stopped_by_a_signal_it_saves_the_motions_that_it_has(self):
        deck = self.output / "ball.yaml"
        deck.write_text(DECK.replace("MESHES", str(program.SOURCE / "meshes")))
        frequencies = ",".join(str(hertz) for hertz in range(400, 900, 10))
        status, said = program.stopped_when_it_says("2 of about 50 frequencies", "radiate", deck, "--output-folder", self.output,
                                                    "--tolerance", 0, "--frequencies", frequencies)
        self.assertEqual(status, program.RESUMABLE, said)
        with h5py.File(self.output / "ball_radiation.h5") as file:
            sounds = len(file["sounds/frequency"])
        self.assertTrue(6 <= sounds < 150 and sounds % 3 == 0, sounds)
        self.assertIn(f"{150 - sounds} of 150 motions are left out", said)

    def test_the_error_of_a_level_is_estimated_or_said_to_be_unknown(self):
        vertices, error = {}, {}
        for tolerance in 0, 0.1:
            job = self.radiate("--frequencies", "800", "--json", tolerance=tolerance)
            self.require_status(job, program.FINISHED)
            sound = json.loads(job.stdout)["sounds"][0]
            vertices[tolerance], error[tolerance] = sound["solved_vertices"], sound["level_error"]
        self.assertIsNone(error[0])
        self.assertLessEqual(error[0.1], 0.1)
        self.assertGreater(vertices[0.1], 3 * vertices[0])
        job = self.radiate("--frequencies", "800", "--most-vertices", 10, tolerance=0.5)
        self.require_status(job, program.FINISHED)
        self.assertIn("along x: the error of its level is unknown", job.stdout + job.stderr)

    def test_waves_on_a_grid_have_the_same_power(self):
        job = self.radiate("--frequencies", "800", "--waves", "0.01", "--json")
        self.require_status(job, program.FINISHED)
        for sound in json.loads(job.stdout)["sounds"]:
            self.assertAlmostEqual(sound["waves_error"], 0, delta=0.3)
            self.assertAlmostEqual(sound["waves_worst"], 0, delta=0.6)
        with h5py.File(self.output / "ball_radiation.h5") as file:
            self.assertEqual(file.attrs["waves_cell"], 0.01)
            self.assertEqual(file["sounds/waves_error"].shape, (3,))

    def test_modes_are_the_same_on_any_ranks_and_open(self):
        job = self.radiate("--modes", "3")
        self.require_status(job, program.FINISHED)
        self.assertIn("finding the 3 lowest modes", job.stdout)
        self.assertRegex(job.stdout, r"solving the sound of 3 motions up to \d+ Hz on a surface of \d+ vertices")
        alone = program.contents(self.output / "ball_radiation.h5")
        self.require_status(self.radiate("--modes", "3", ranks=2), program.FINISHED)
        together = program.contents(self.output / "ball_radiation.h5")
        self.assertEqual(alone.keys(), together.keys())
        for name, values in alone.items():
            numpy.testing.assert_array_equal(values, together[name], name)
        with h5py.File(self.output / "ball_radiation.h5") as file:
            sounds, sphere = file["sounds"], file["sphere"]
            square = (sphere["pressure"][()] ** 2).sum(axis=2) @ sphere["weight"][()]
            numpy.testing.assert_allclose(square / (2 * 1.21 * 343), sounds["power"][()], rtol=1e-3)
            omega = 2 * numpy.pi * sounds["frequency"][()]
            numpy.testing.assert_allclose(sounds["loss_factor"][()], sounds["power"][()] / (0.5 * omega), rtol=1e-12)
            vertices = file["surface/vertices"].shape[0]
        tree = ElementTree.parse(self.output / "ball_radiation.xdmf")
        self.assertEqual(len(tree.findall(".//Grid[@GridType='Uniform']")), 3)
        self.assertEqual({item.get("Dimensions") for item in tree.findall(".//DataItem[@ItemType='HyperSlab']")},
                         {str(vertices)})
        picture = subprocess.run([program.SOURCE / "scripts/polar", self.output / "ball_radiation.h5"],
                                 capture_output=True, text=True)
        self.require_status(picture, 0)
        self.assertTrue((self.output / "ball_radiation.png").exists())

    def write_velocities(self, vertices, motions):
        """A file of complex velocities of all vertices.

        :param motions: velocities [vertices x 3], m/s, by their frequency, Hz
        """
        rows = [VELOCITY_COLUMNS]
        for frequency, velocities in motions.items():
            for place, velocity in zip(vertices, velocities + numpy.zeros_like(vertices, complex)):
                rows.append(",".join(map(str, [frequency, *place, *numpy.ravel([velocity.real, velocity.imag], "F")])))
        path = self.output / "velocities.csv"
        path.write_text("\n".join(rows) + "\n")
        return path

    def rigid_motion(self, *arguments):
        """The sound of a motion along z at 800 Hz, and the vertices of the surface."""
        self.require_status(self.radiate("--frequencies", "800", *arguments), program.FINISHED)
        with h5py.File(self.output / "ball_radiation.h5") as file:
            sounds = file["sounds"]
            alone = {name: sounds[name][2] for name in ("power", "efficiency", "mean_square_velocity", "kirchhoff_worst")}
            return alone, file["listeners/pressure"][2, 0] @ [1, 1j], file["surface/vertices"][()]

    def test_given_velocities_have_the_sound_of_the_motion_that_they_are(self):
        alone, pressure, vertices = self.rigid_motion()
        along_z = numpy.array([0, 0, 1])
        pulsating = vertices / 0.05  # one side is louder than the other: which one depends on the sign of the phase
        file = self.write_velocities(vertices, {1000.0: along_z + 1j * pulsating, 800.0: (0.6 + 0.8j) * along_z})
        self.require_status(self.radiate("--velocities", file, "--waves", "0.01", ranks=2), program.FINISHED)
        with h5py.File(self.output / "ball_radiation.h5") as file:
            sounds = file["sounds"]
            numpy.testing.assert_array_equal(sounds["frequency"], [800, 1000])
            for name, value in alone.items():
                self.assertAlmostEqual(sounds[name][0] / value, 1, delta=1e-9, msg=name)
            self.assertLess(abs(file["listeners/pressure"][0, 0] @ [1, 1j] / pressure / (0.6 + 0.8j) - 1), 1e-9)
            self.assertTrue(numpy.isnan(sounds["loss_factor"]).all())
            numpy.testing.assert_allclose(sounds["waves_worst"], 0, atol=0.6)

    def test_velocities_of_an_hdf5_file_are_those_of_the_table(self):
        _, _, vertices = self.rigid_motion(*COARSE)
        motions = {800.0: vertices * (1 + 2j), 1000.0: vertices[:, ::-1] * 3j}
        self.require_status(self.radiate("--velocities", self.write_velocities(vertices, motions), *COARSE), program.FINISHED)
        expected = program.contents(self.output / "ball_radiation.h5")
        velocity = numpy.array(list(motions.values()))
        path = self.output / "velocities.h5"
        for change, said in (("", ""), ("unit", "must be in m/s, not mm/s"), ("shape", "/velocity must have the shape [2 x"),
                             ("nan", f"{path}:/velocity:2:1: frequency, position or velocity is not finite")):
            with h5py.File(path, "w") as file:
                file["frequency"], file["position"] = list(motions), vertices
                file["velocity"] = numpy.stack([velocity.real, velocity.imag], axis=-1)[:, :-1 if change == "shape" else None]
                if change == "unit":
                    file["velocity"].attrs["unit"] = "mm/s"
                if change == "nan":
                    file["velocity"][1, 0, 0, 0] = numpy.nan
            job = self.radiate("--velocities", path, *COARSE)
            if said:
                self.assertNotIn(job.returncode, (program.FINISHED, program.RESUMABLE), said)
                self.assertIn(said, job.stderr)
                continue
            self.require_status(job, program.FINISHED)
            found = program.contents(self.output / "ball_radiation.h5")
            for name, values in expected.items():
                numpy.testing.assert_array_equal(found[name], values, name)

    def test_velocities_that_do_not_fit(self):
        _, _, vertices = self.rigid_motion()
        file = self.write_velocities(vertices, {800.0: [0, 0, 1]})
        header, first, *rows = file.read_text().splitlines()
        still = self.write_velocities(vertices, {800.0: [0, 0, 0]}).read_text().splitlines()
        for lines, said in (([header, *rows], f"1 of {len(vertices)} vertices of the body have no row at 800 Hz"),
                            ([header, first, first, *rows], "velocities.csv:3:1: a row before has the same vertex at 800 Hz"),
                            ([header, "800,9,9,9,0,0,0,0,1,0", *rows], "velocities.csv:2:1: no vertex of the body is here"),
                            ([header, first.replace("800.0", "-1"), *rows], "the frequency must be above 0 Hz, not -1"),
                            (still, "all velocities at 800 Hz are 0"), ([header], "has no velocities"),
                            (["frequency,x", first, *rows], f"the columns must be '{VELOCITY_COLUMNS}'")):
            file.write_text("\n".join(lines) + "\n")
            job = self.radiate("--velocities", file)
            self.assertNotIn(job.returncode, (program.FINISHED, program.RESUMABLE), said)
            self.assertIn(said, job.stderr)

    def write_listeners(self, text):
        path = self.output / "listeners.yaml"
        path.write_text(text)
        return path

    def hear(self, listeners, *arguments, ranks=None):
        return program.idiophone("radiate", self.output / "ball_radiation.h5", "--listeners", self.write_listeners(listeners),
                                 "--output-folder", self.output, *arguments, ranks=ranks)

    def test_other_listeners_hear_what_a_new_solution_gives(self):
        listeners = "{near: {type: mono, position: [0, 0.02, 0.06]}, far: {type: mono, position: [3, 1, 0]}}"
        humid = "radiation.air={absorption: true}"
        self.require_status(self.radiate("--frequencies", 800, *COARSE, tolerance=0.3), program.FINISHED)
        first = program.contents(self.output / "ball_radiation.h5")
        self.require_status(self.hear(f"listeners: {listeners}", "--set", humid, ranks=2), program.FINISHED)
        heard = program.contents(self.output / "ball_listen_radiation.h5")
        self.require_status(self.radiate("--frequencies", 800, *COARSE, "--set", f"listeners={listeners}", "--set", humid,
                                         tolerance=0.3), program.FINISHED)
        solved = program.contents(self.output / "ball_radiation.h5")
        self.assertEqual(heard.keys(), solved.keys())
        for name, values in heard.items():
            expected = (solved if name.startswith("listeners") else first)[name]
            numpy.testing.assert_array_equal(values, expected, name)
        self.assertTrue("solutions/1/pressure" in heard, list(heard))

    def test_listeners_that_do_not_fit(self):
        self.require_status(self.radiate("--frequencies", "400", *COARSE), program.FINISHED)
        ear = "listeners: {ear: {type: mono, position: [0, 0, 0.2]}}"
        for text, said in (("listeners: {ear: {type: mono, position: [0, 0, 0.01]}}", "inside"),
                           (ear + "\naudio: {dc_corner: 10}", "audio: has no effect"),
                           (ear + "\nradiation: {floor: {at: [0, 0, -1]}}", "which was solved without a floor"),
                           (ear + "\nradiation: {air: {speed: 300}}", "radiation.air.speed"),
                           (ear + "\nname: ball", "would be overwritten")):
            job = self.hear(text)
            self.assertNotIn(job.returncode, (program.FINISHED, program.RESUMABLE), said)
            self.assertIn(said, job.stderr)

    def test_wrong_options(self):
        for arguments, said in ((["--body", "bell"], "no body 'bell'"), (["--modes", "0"], "at least 1"),
                                (["--frequencies", "-3"], "above 0 Hz"),
                                (["--frequencies", "2e6"], "choose a finer mesh")):
            job = self.radiate(*arguments)
            self.assertNotIn(job.returncode, (program.FINISHED, program.RESUMABLE))
            self.assertIn(said, job.stderr)


if __name__ == "__main__":
    unittest.main()
