#!/usr/bin/python3
"""`idiophone modes`: its table, its files, the same on any ranks, and answers to wrong options."""
import json
import re
import subprocess
import unittest
import xml.etree.ElementTree

import h5py
import numpy

import program


class Modes(program.TestCase):
    def modes(self, name, *arguments, ranks=None):
        return program.idiophone("modes", program.deck(name), "--output-folder", self.output, *arguments, ranks=ranks)

    def found(self, name="simple", body="plate"):
        with h5py.File(self.output / f"{name}_modes.h5") as file:
            return {key: values[()] for key, values in file[f"modes/{body}"].items()}

    def test_table_and_file_agree(self):
        job = self.modes("simple", "--modes", "5", "--references", "1.5,900")
        self.require_status(job, program.FINISHED)
        self.assertIn("0 rigid motions", job.stdout)
        rows = [row.split() for row in job.stdout.splitlines() if re.match(r" +\d+  ", row)]
        found = self.found()
        self.assertEqual([int(row[0]) for row in rows], [1, 2, 3, 4, 5])
        for column, key, digits in (1, "frequency", 4e-5), (2, "damping_ratio", 1e-3), (3, "decay_time", 1e-2):
            numpy.testing.assert_allclose([float(row[column]) for row in rows], found[key], rtol=1e-3, atol=digits)
        omega = 2 * numpy.pi * found["frequency"]
        numpy.testing.assert_allclose(found["damping_ratio"], 20 / (2 * omega) + 1e-7 * omega / 2, rtol=1e-9)
        for row, frequency in zip(rows, found["frequency"]):
            cents = 1200 * numpy.log2(frequency / 900)
            self.assertEqual(row[5], f"{cents:+.1f}" if abs(cents) <= 100 else "-")

    def test_the_error_of_the_mesh_is_estimated(self):
        job = program.idiophone("modes", program.SOURCE / "inputs/clamped_bar.yaml", "--modes", "3", "--references",
                                "90.950,566.998", "--json", "--output-folder", self.output)  # 3-D elasticity
        self.require_status(job, program.FINISHED)
        modes = json.loads(job.stdout)["modes"]
        for mode in modes[0], modes[2]:
            self.assertLess(mode["cents"]["references"], 2 * mode["mesh_error"])
            self.assertGreater(mode["cents"]["references"], 0.2 * mode["mesh_error"])
        numpy.testing.assert_allclose(self.found("clamped_bar", "bar")["mesh_error"], [mode["mesh_error"] for mode in modes])

    def test_check_estimates_the_lowest_modes_of_small_bodies(self):
        deck = program.SOURCE / "inputs/clamped_bar.yaml"
        job = program.idiophone("check", deck, "--set", "time.duration=0.01", "--output-folder", self.output, "--json")
        self.require_status(job, program.FINISHED)
        seen = json.loads(job.stdout)["bodies"]["bar"]["lowest_modes"]
        self.require_status(program.idiophone("modes", deck, "--modes", "4", "--output-folder", self.output), program.FINISHED)
        wanted = self.found("clamped_bar", "bar")
        numpy.testing.assert_allclose(seen["frequencies"], wanted["frequency"], rtol=1e-6)
        numpy.testing.assert_allclose(seen["mesh_errors"], wanted["mesh_error"], atol=1e-3)
        text = program.idiophone("check", deck, "--set", "time.duration=0.01", "--output-folder", self.output).stdout
        self.assertIn(f"{seen['frequencies'][0]:.5g} Hz {seen['mesh_errors'][0]:+.1f} cents", text)
        self.assertNotIn("by the rules", text)

    def test_check_estimates_the_vibrations_of_a_body_on_soft_supports(self):
        cords = "cord: {at: [0.09, 0, 0.01], radius: 0.02, stiffness: 1}, string: {at: [0, 0.09, 0.01], stiffness: 1}"
        supports = f"bodies.plate.supports={{{cords}}}"
        words = program.deck("simple"), "--set", "bodies.plate.fixed=[]", "--set", supports, "--output-folder", self.output, "--json"
        job = program.idiophone("check", *words)
        self.require_status(job, program.FINISHED)
        seen = json.loads(job.stdout)["bodies"]["plate"]["lowest_modes"]
        job = program.idiophone("modes", *words, "--modes", "10")
        self.require_status(job, program.FINISHED)
        modes = json.loads(job.stdout)["modes"]
        self.assertEqual([mode["kind"][:12] for mode in modes[:6]], 6 * ["rigid motion"])
        numpy.testing.assert_allclose(seen["frequencies"], [mode["frequency"] for mode in modes[6:]], rtol=1e-6)
        numpy.testing.assert_allclose(seen["mesh_errors"], [mode["mesh_error"] for mode in modes[6:]], atol=0.1)

    def test_large_meshes_are_estimated_on_request(self):
        job = self.modes("simple", "--modes", "2", "--no-estimate", ranks=2)
        self.require_status(job, program.FINISHED)
        self.assertNotIn("mesh/cents", job.stdout)
        self.assertNotIn("mesh_error", self.found())
        self.require_status(self.modes("simple", "--modes", "2", "--estimate", ranks=2), program.FINISHED)
        self.assertEqual(len(self.found()["mesh_error"]), 2)

    def test_bounds_are_in_table_json_and_file(self):
        bar = [program.SOURCE / "verification/bar.yaml", "--modes", "3", "--no-estimate", "--bounds", "--output-folder", self.output]
        hexahedra = ["--set", "bodies.bar.element=hex", "--set", "bodies.bar.order={plane: 4, thickness: 2}",
                     "--set", "bodies.bar.parameters.size=0.075"]
        job = program.idiophone("modes", *bar, *hexahedra, "--json", ranks=2)
        self.require_status(job, program.FINISHED)
        answer = json.loads(job.stdout)
        self.assertEqual(answer["mass"], "consistent")
        self.assertEqual(len(answer["modes"]), 3)
        bounds = answer["bounds"]
        for lower, limit, upper in zip(bounds["lower"], [574.403, 1573.218, 1671.320], bounds["upper"]):  # 3-D elasticity
            self.assertLess(lower, limit)
            self.assertGreater(upper, limit)
        with h5py.File(self.output / "bar_modes.h5") as file:
            numpy.testing.assert_array_equal(file["modes/bar/bounds/lower"], bounds["lower"])
            self.assertEqual(file["modes/bar/bounds"].attrs["modes_below"], bounds["modes_below"])
        table = program.idiophone("modes", *bar, *hexahedra).stdout
        self.assertIn(f"{bounds['lower'][0]:.4f}  {bounds['upper'][0]:>12.4f}", table)
        self.assertIn(f"no more than {bounds['modes_below']} modes below {bounds['separation']:.6g} Hz", table)
        self.require_status(program.idiophone("info", self.output / "bar_modes.h5"), program.FINISHED)
        tetrahedra = program.idiophone("modes", *bar)
        self.assertIn("tetrahedra", tetrahedra.stderr)
        lumped = program.idiophone("modes", *bar, "--mass", "lumped")
        self.assertIn("--mass", lumped.stderr)

    def test_air_lowers_a_light_ball_on_springs(self):
        deck = self.output / "ball.yaml"
        density, radius, frequency = 20.0, 0.05, 400.0
        mass = density * 4 / 3 * numpy.pi * radius**3
        deck.write_text(f"""
name: ball
time: {{duration: 0.01}}
materials: {{foam: {{young: 2.0e8, poisson: 0.3, density: {density}}}}}
bodies:
  ball: {{mesh: {program.SOURCE}/meshes/sphere.geo, parameters: {{radius: {radius}, size: 0.03}}, material: foam, element: tet10,
         supports: {{springs: {{at: [0, 0, {radius}], radius: 1, stiffness: {mass * (2 * numpy.pi * frequency)**2}}}}}}}
listeners: {{ear: {{type: mono, position: [0, 0, 1]}}}}
""")
        x = 2j * numpy.pi * frequency / 343 * radius  # Morse and Ingard, Theoretical Acoustics, section 7.2
        added = (4 / 3 * numpy.pi * radius**3 * 1.21 * (1 + x) / (2 + 2 * x + x**2)).real
        shift = 600 * numpy.log2(1 + added / mass)
        job = program.idiophone("modes", deck, "--output-folder", self.output, "--modes", 3)
        self.require_status(job, program.FINISHED)
        self.assertRegex(job.stdout + job.stderr, "would lower mode . by about .. cents; --in-air")
        for ranks in (None, 2) if program.LONG else (None,):
            job = program.idiophone("modes", deck, "--output-folder", self.output, "--modes", 3, "--in-air", "--json", ranks=ranks)
            self.require_status(job, program.FINISHED)
            for mode in json.loads(job.stdout)["modes"]:
                self.assertAlmostEqual(-mode["air_shift"] / shift, 1, delta=0.05)
                self.assertGreater(mode["damping_ratio"], 0)
        job = program.idiophone("map", deck, "--output-folder", self.output, "--modes", 3, "--in-air")
        self.require_status(job, program.FINISHED)
        with h5py.File(self.output / "ball_ball.map.h5") as file:
            numpy.testing.assert_allclose(file["modes/frequency"][()], self.found("ball", "ball")["frequency"], rtol=1e-6)
            self.assertIn("modes with the mass of the air", file.attrs["radiation"].decode())

    def test_stopped_by_a_signal_it_saves_what_it_has(self):
        status, said = program.stopped_when_it_says("12 of about 120 estimates", "modes", program.deck("simple"), "--output-folder",
                                                    self.output, "--modes", 120, "--estimate")
        self.assertEqual(status, program.RESUMABLE, said)
        found = self.found()
        self.assertEqual(len(found["frequency"]), 120)
        left_out = numpy.count_nonzero(numpy.isnan(found["mesh_error"]))
        self.assertTrue(0 < left_out < 120, left_out)
        self.assertIn(f"left out {left_out} of 120 estimates of the error of the mesh", said)

    def test_ranks_agree(self):
        self.require_status(self.modes("simple", "--modes", "4"), program.FINISHED)
        alone = self.found()
        self.require_status(self.modes("simple", "--modes", "4", ranks=3), program.FINISHED)
        together = self.found()
        numpy.testing.assert_allclose(together["frequency"], alone["frequency"], rtol=1e-9)
        self.assertEqual(together["shape"].shape, alone["shape"].shape)
        numpy.testing.assert_allclose(together["shape"][0], alone["shape"][0], atol=1e-6 * alone["shape"][0].max())

    def test_a_sound_has_the_frequencies_of_its_modes(self):
        self.require_status(self.modes("simple", "--modes", "1"), program.FINISHED)
        self.require_status(program.run("simple", self.output, "--set", "time.duration=0.2"), program.FINISHED)
        found = program.idiophone("analyze", self.output / "simple.h5", "--range", "30")
        first = float(re.search(r"(?m)^ +(\d+\.\d\d) ", found.stdout)[1])
        self.assertAlmostEqual(first / self.found()["frequency"][0], 1, delta=1e-3)
        picture = subprocess.run([program.SOURCE / "scripts/spectrum", self.output / "simple.h5", "--modes",
                                  self.output / "simple_modes.h5"], capture_output=True, text=True)
        self.require_status(picture, 0)
        picture = subprocess.run([program.SOURCE / "scripts/spectrum", self.output / "simple.h5", "--modes",
                                  self.output / "simple.h5"], capture_output=True, text=True)
        self.assertEqual(picture.returncode, 1)
        self.assertIn("has no modes", picture.stderr)

    def test_shapes_open(self):
        for body, cells in ("bar", "tetra10"), ("ball", "tetra"):
            self.require_status(self.modes("rich", "--body", body, "--modes", "3", ranks=2), program.FINISHED)
            check = subprocess.run([program.SOURCE / "tools/check_xdmf", self.output / f"rich_{body}_modes.xdmf"],
                                   capture_output=True, text=True)
            self.require_status(check, 0)
            self.assertEqual([line.split()[:3] for line in check.stdout.splitlines()],
                             [[f"{mode}.000000", body, cells] for mode in (1, 2, 3)])
            last = [float(value) for value in check.stdout.splitlines()[-1].split()[-3:]]
            numpy.testing.assert_allclose(last, self.found(f"rich_{body}", body)["shape"][2, -1], atol=1e-6)
            told = program.idiophone("info", self.output / f"rich_{body}_modes.h5")
            self.assertIn(f"/modes/{body}/shape ", told.stdout)

    def test_draws_pictures(self):
        self.require_status(self.modes("simple", "--modes", "3", "--pictures", ranks=2), program.FINISHED)
        picture = self.output / "simple_modes.svg"
        pictures = xml.etree.ElementTree.parse(picture).getroot().findall("{http://www.w3.org/2000/svg}g")
        titles = [group.find("{http://www.w3.org/2000/svg}text").text for group in pictures]
        self.assertEqual([title.split(":")[0] for title in titles], ["1", "2", "3"])
        self.assertIn("(0, 0)", titles[0])
        self.assertTrue(all(len(group) > 20 for group in pictures))
        together = picture.read_text()
        self.require_status(self.modes("simple", "--modes", "3", "--pictures"), program.FINISHED)
        self.assertLess(abs(len(picture.read_text()) / len(together) - 1), 0.02)  # (1, 0) and (0, 1) have one frequency

    def test_free_body_and_consistent_mass(self):
        job = self.modes("free", "--modes", "1", "--mass", "consistent", "--shift", "5")
        self.require_status(job, program.FINISHED)
        self.assertIn("consistent mass, 6 rigid motions", job.stdout)
        consistent = self.found("free", "ball")
        self.assertTrue(numpy.isinf(consistent["decay_time"][0]))
        self.require_status(self.modes("free", "--modes", "1"), program.FINISHED)
        self.assertLess(self.found("free", "ball")["frequency"][0], consistent["frequency"][0])

    def kinds(self, mesh, parameters, at, count, body=""):
        """[(kind, Hz)] of a free body of steel."""
        deck = self.output / "kinds.yaml"
        deck.write_text(f"""name: kinds
time: {{duration: 0.01}}
materials: {{steel: {{young: 2.0e11, poisson: 0.3, density: 7850}}}}
bodies: {{body: {{mesh: {mesh}, parameters: {parameters}, material: steel, {body or 'element: tet10'}}}}}
loads: {{tap: {{at: {at}, force: [0, 0, -1], duration: 1e-3}}}}
listeners: {{ear: {{type: mono, position: [0, 0, 1]}}}}
""")
        job = program.idiophone("modes", deck, "--modes", count, "--output-folder", self.output, "--json")
        self.require_status(job, program.FINISHED)
        return [(mode["kind"], mode["frequency"]) for mode in json.loads(job.stdout)["modes"]]

    def test_modes_of_a_bar_have_the_frequencies_of_their_kinds(self):
        bar = program.SOURCE / "meshes/bar.geo"
        found = dict(self.kinds(bar, "{length: 0.3, width: 0.03, thickness: 0.01, size: 0.015}", [0.1, 0, 0.005], 12))
        speed = numpy.sqrt(2e11 / 7850)
        for number, root in enumerate((4.73004, 7.85320, 10.9956, 14.1372), 1):  # Euler's beam, which is too high for short waves
            exact = root ** 2 / (2 * numpy.pi) * speed * 0.01 / numpy.sqrt(12) / 0.3 ** 2
            self.assertAlmostEqual(found[f"bending {number} along z"] / exact, 1, delta=0.02 * number)
            if number < 3:
                self.assertAlmostEqual(found[f"bending {number} along y"] / exact / 3, 1, delta=0.05 * number)
        twist = numpy.sqrt(2e11 / 2.6 / 7850 * 0.263 / ((3 ** 2 + 1) / 12))  # m/s, J = 0.263 a b^3 for sides of 3 : 1
        for number in 1, 2:
            self.assertAlmostEqual(found[f"torsion {number}"] / (number * twist / (2 * 0.3)), 1, delta=0.05)
        self.assertAlmostEqual(found["longitudinal 1"] / (speed / 0.6), 1, delta=0.01)

    def test_modes_of_a_plate_a_disc_and_a_bell_have_nodal_lines(self):
        bar = program.SOURCE / "meshes/bar.geo"
        plate = self.kinds(bar, "{length: 0.24, width: 0.17, thickness: 0.003, size: 0.025}", [0.1, 0, 0.0015], 8)
        self.assertEqual([kind for kind, _ in plate][:4], ["(1, 1)", "(2, 0)", "(0, 2)", "(2, 1)"])
        geometry = self.output / "disc.geo"
        geometry.write_text('SetFactory("OpenCASCADE");\nDefineConstant[size = 0.02];\nCylinder(1) = {0, 0, 0, 0, 0, 0.003, 0.1};\n'
                            'Mesh.MeshSizeMax = size;\nPhysical Volume("body") = {1};\n')
        disc = self.kinds(geometry, "{size: 0.016}", [0.05, 0, 0.003], 9)
        squares = {"(2, 0)": 5.358, "(0, 1)": 9.003, "(3, 0)": 12.44, "(1, 1)": 20.47, "(4, 0)": 21.84}  # Leissa 1969, nu = 0.3
        self.assertEqual([kind for kind, _ in disc],
                         ["(2, 0)", "(2, 0)", "(0, 1)", "(3, 0)", "(3, 0)", "(1, 1)", "(1, 1)", "(4, 0)", "(4, 0)"])
        rigidity = numpy.sqrt(2e11 * 0.003 ** 2 / (12 * (1 - 0.09) * 7850))
        for kind, frequency in disc:
            self.assertAlmostEqual(frequency / (squares[kind] * rigidity / (2 * numpy.pi * 0.01)), 1, delta=0.04)
        job = program.idiophone("modes", self.output / "kinds.yaml", "--modes", "5", "--no-estimate", "--output-folder", self.output)
        split = 1200 * numpy.log2(disc[4][1] / disc[3][1])
        self.assertIn(f"(modes 4 and 5 are one pair and {split:.1f} cents apart", job.stdout)
        bell = self.kinds(program.SOURCE / "meshes/bell.geo", "{radius: 0.08, height: 0.1, size: 0.04}", [0.074, 0, 0.0073], 10,
                          "element: hex, order: {plane: 3, thickness: 2}, thickness: 0.003, fixed: [crown]")
        self.assertEqual([kind for kind, _ in bell][:2], ["(2, 0)"] * 2)
        self.assertEqual([kind for kind, _ in bell].count("(2, 1)"), 2)  # the lip moves against the waist

    def test_wrong_options(self):
        for ranks, arguments, *messages in (
                (None, ["--modes", "0"], "--modes must be at least 1"),
                (2, ["--modes", "100000"], "has no more than"),
                (None, ["--shift", "-3"], "--shift must be 0 Hz or above"),
                (None, ["--shift", "nan"], "--shift must be 0 Hz or above"),
                (None, ["--references", "100,0"], "--references must be frequencies above 0 Hz"),
                (None, ["--tolerance", "0"], "--tolerance must be above 0 cents"),
                (2, ["--body", "plaet"], "there is no body 'plaet'", "plate"),
                (None, ["--set", "bodies.plate.fixed=[]", "--shift", "0"], "can move rigidly in 6 ways"),
                (None, ["--set", "bodies.plate.fixed=[body]"], "all of it is held")):
            with self.subTest(arguments=arguments):
                job = self.modes("simple", *arguments, ranks=ranks)
                self.require_status(job, program.FAILED)
                for message in messages:
                    self.assertIn(message, job.stderr)
        self.assertGreater(self.modes("simple", "--mass", "heavy").returncode, 100)
        self.assertGreater(self.modes("simple", "--references", "high").returncode, 100)


if __name__ == "__main__":
    unittest.main()
