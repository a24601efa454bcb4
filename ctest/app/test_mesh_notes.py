#!/usr/bin/python3
"""What `idiophone check` says about a mesh that is too coarse, or locks, and that it leaves others alone."""
import json
import math
import re
import unittest

import program

PLATE = """
name: plate
time: {{duration: 0.01}}
materials: {{steel: {{young: 2.0e11, poisson: 0.3, density: 7850}}}}
bodies:
  plate:
    mesh: {mesh}
    parameters: {{side: 0.3, thickness: 0.006, size: 0.0125}}
    element: tet10
    material: steel
listeners: {{ear: {{type: mono, position: [0, 0, 1]}}}}
"""
WAVE = 0.0514  # m: of 20 kHz in 6 mm of steel, by the Rayleigh-Lamb equation


class MeshNotes(program.TestCase):
    def check(self, *settings):
        deck = self.output / "plate.yaml"
        deck.write_text(PLATE.format(mesh=program.SOURCE / "meshes/square_plate.geo"))
        job = program.idiophone("check", deck, *(word for each in settings for word in ("--set", each)))
        self.require_status(job, program.FINISHED)
        return job.stdout + job.stderr

    def test_a_coarse_mesh_is_told_with_its_limit_and_a_cure(self):
        told = self.check("bodies.plate.parameters.size=0.025")
        limit, elements, size = (float(re.search(pattern, told)[1]) for pattern in (
            r"too coarse above (\d+) Hz", r"bending waves are ([\d.]+) elements long", r"Use elements of ([\d.]+) m"))
        self.assertLess(elements, 4)
        self.assertAlmostEqual(elements, WAVE / 0.025, delta=0.1)
        self.assertNotIn("too coarse", self.check(f"bodies.plate.parameters.size={0.9 * size}"))
        for part, verdict in (0.9, self.assertNotIn), (1.1, self.assertIn):
            verdict("too coarse", self.check("bodies.plate.parameters.size=0.025", f"audio.max_frequency={part * limit}"))

    def test_the_foretold_error_grows_with_frequency(self):
        found = re.search(r"5 cents up to (\d+) Hz, 50 cents up to (\d+) Hz", self.check())
        self.assertAlmostEqual(float(found[2]) / float(found[1]), 10, delta=1.5)  # the square of the wave's length

    def test_curved_thin_walls_have_no_promise(self):
        job = program.idiophone("check", program.SOURCE / "inputs/bell.yaml", "--json")
        self.require_status(job, program.FINISHED)
        self.assertNotIn("highest_within_5_cents", json.loads(job.stdout)["bodies"]["bell"])
        job = program.idiophone("check", program.SOURCE / "inputs/bell.yaml", "--accuracy", "5", "--set", "time.duration=0.01")
        self.assertIn("body bell: no mesh is recommended for curved or joined thin walls", job.stdout)
        self.assertNotIn("CPU-seconds per second of sound", job.stdout)

    def test_a_mesh_is_recommended_for_ultrasound(self):
        deck = self.output / "die.yaml"
        deck.write_text(PLATE.format(mesh=program.SOURCE / "meshes/square_plate.geo"))
        job = program.idiophone("check", deck, "--set", "bodies.plate.parameters={side: 0.004, thickness: 0.003, size: 0.002}",
                                "--up-to", 1e6, "--set", "time.duration=1e-5", "--set", "audio.rate=1000000")
        self.require_status(job, program.FINISHED)
        self.assertIn("for 5 cents up to 1000000 Hz", job.stdout)

    def test_linear_elements_lock(self):
        told = self.check("bodies.plate.element=tet4")
        self.assertIn("lock", told)
        self.assertNotIn("5 cents up to", told)

    def test_a_body_that_is_held_rigid_has_no_pitch(self):
        told = self.check("bodies.plate.fixed=[body]", "time.steps_per_sample=4", "bodies.plate.parameters.size=0.03")
        self.assertNotIn("cents", told)
        self.assertNotIn("too coarse", told)


# A closed box of 2 x 1 x 0.2 m, its facets as an OBJ file.
BOX = """v 0 0 0\nv 2 0 0\nv 0 1 0\nv 2 1 0\nv 0 0 0.2\nv 2 0 0.2\nv 0 1 0.2\nv 2 1 0.2
f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6
"""


def prism(sides):
    """A closed column with so many sides, 1 m in radius and height, its facets as an OBJ file."""
    around = [(math.cos(2 * math.pi * side / sides), math.sin(2 * math.pi * side / sides)) for side in range(sides)]
    lines = [f"v {x} {y} {z}" for z in (0, 1) for x, y in around]
    for this in range(1, sides + 1):
        following = this % sides + 1
        lines.append(f"f {this} {following} {sides + following} {sides + this}")
        if 1 < this < sides:
            lines += [f"f 1 {following} {this}", f"f {sides + 1} {sides + this} {sides + following}"]
    return "\n".join(lines) + "\n"


class Faces(program.TestCase):
    def deck(self, *settings, surface=BOX):
        (self.output / "box.obj").write_text(surface)
        deck = self.output / "box.yaml"
        deck.write_text(PLATE.format(mesh="box.obj"))
        words = [word for each in ("bodies.plate.parameters={size: 0.3}", *settings) for word in ("--set", each)]
        return [deck, *words]

    def test_faces_are_listed_and_can_be_held(self):
        job = program.idiophone("check", *self.deck("bodies.plate.position=[0, 0, 1]"), "--faces", "--json")
        self.require_status(job, program.FINISHED)
        faces = json.loads(job.stdout)["plate"]
        self.assertGreaterEqual(len(faces), 6)  # gmsh can divide a side
        self.assertAlmostEqual(sum(face["area"] for face in faces.values()), 5.2, places=6)
        top = {name: face for name, face in faces.items() if face["normal"][2] > 0.99}
        self.assertAlmostEqual(sum(face["area"] for face in top.values()), 2.0, places=6)
        for corner, ends, expected in ("low", min, (0, 0, 1.2)), ("high", max, (2, 1, 1.2)):
            for axis in range(3):
                self.assertAlmostEqual(ends(face[corner][axis] for face in top.values()), expected[axis], places=6)
        table = program.idiophone("check", *self.deck(), "--faces").stdout
        self.assertEqual(len(re.findall(r"^ *face_\d+ ", table, re.MULTILINE)), len(faces))
        held = program.idiophone("modes", *self.deck(f"bodies.plate.fixed=[{','.join(top)}]"), "--modes", "1", "--no-estimate", "--json",
                                 "--output-folder", self.output)
        self.require_status(held, program.FINISHED)
        self.assertEqual(json.loads(held.stdout)["rigid_motions"], 0)

    def test_faces_are_listed_in_the_order_of_their_numbers_without_tables_of_forces(self):
        tap = "loads={tap: {at: [0, 0, 0.2], force: [0, 0, 1], shape: table, table: not_there.csv}}"
        job = program.idiophone("check", *self.deck(tap, surface=prism(8)), "--faces")
        self.require_status(job, program.FINISHED)
        numbers = [int(number) for number in re.findall(r"^ *face_(\d+) ", job.stdout, re.MULTILINE)]
        self.assertGreaterEqual(len(numbers), 10)
        self.assertEqual(numbers, sorted(numbers))
        self.require_status(program.idiophone("check", *self.deck(tap)), program.WRONG_DECK)

    def test_faces_are_held_by_normal_and_by_box(self):
        found = []
        for held in "normal 0 0 1", "box 0 0 0.2 2 1 0.2", "normal 0 0 -1":
            job = program.idiophone("modes", *self.deck(f"bodies.plate.fixed=[{held}]"), "--modes", "1", "--no-estimate", "--json",
                                    "--output-folder", self.output)
            self.require_status(job, program.FINISHED)
            answer = json.loads(job.stdout)
            self.assertEqual(answer["rigid_motions"], 0)
            found.append(answer["modes"][0]["frequency"])
        self.assertAlmostEqual(found[0], found[1], places=6)
        for held in "normal 1 1 1", "box 5 5 5 6 6 6", "normal 1 0":
            job = program.idiophone("check", *self.deck(f"bodies.plate.fixed=[{held}]"))
            self.require_status(job, program.WRONG_DECK)
            self.assertIn(f"the mesh has no group '{held}'", job.stderr)

    def test_a_deck_gives_names_to_faces(self):
        faces = json.loads(program.idiophone("check", *self.deck(), "--faces", "--json").stdout)["plate"]
        top = [name.removeprefix("face_") for name, face in faces.items() if face["normal"][2] > 0.99]
        found = []
        for lid in "{normal: [0, 0, 1]}", f"{{faces: [{', '.join(top)}]}}":
            job = program.idiophone("modes", *self.deck(f"bodies.plate.groups={{lid: {lid}}}", "bodies.plate.fixed=[lid]"),
                                    "--modes", "1", "--no-estimate", "--json", "--output-folder", self.output)
            self.require_status(job, program.FINISHED)
            found.append(json.loads(job.stdout))
        self.assertEqual(found[0]["rigid_motions"], 0)
        self.assertAlmostEqual(found[0]["modes"][0]["frequency"], found[1]["modes"][0]["frequency"], places=6)
        job = program.idiophone("check", *self.deck("bodies.plate.groups={lid: {faces: [99]}}", "bodies.plate.fixed=[lid]"))
        self.require_status(job, program.WRONG_DECK)
        self.assertIn("the mesh has no group 'faces 99'", job.stderr)

    def test_an_unknown_face_is_answered_with_those_that_there_are(self):
        job = program.idiophone("check", *self.deck("bodies.plate.fixed=[face_99]"))
        self.require_status(job, program.WRONG_DECK)
        self.assertRegex(job.stderr, r"the mesh has no group 'face_99'; did you mean 'face_\d+'")


class Recommendations(program.TestCase):
    """`check --accuracy` and `modes` of a steel box. The references, Hz, are `modes` of hexahedra of order 6 to 8."""
    BAR = ({"length": 0.3, "width": 0.03, "thickness": 0.01},
           (574.40, 1573.22, 1671.32, 2936.60, 3055.59, 4353.26, 4989.83, 5895.64, 7343.81, 7953.64))
    PLATE = ({"length": 0.3, "width": 0.3, "thickness": 0.006},
             (216.63, 317.12, 392.62, 559.22, 559.22, 985.54, 985.54, 1019.63))
    CUBE = ({"length": 0.1, "width": 0.1, "thickness": 0.1},
            (14229.19, 14229.19))

    def answer(self, command, *arguments):
        job = program.idiophone(command, program.SOURCE / "verification/bar.yaml", "--output-folder", self.output, "--json",
                                *arguments)
        self.require_status(job, program.FINISHED)
        return json.loads(job.stdout)

    @staticmethod
    def settings(sides, **parameters):
        words = ", ".join(f"{key}: {value}" for key, value in {**sides, **parameters}.items())
        return ["--set", f"bodies.bar.parameters={{{words}}}"]

    def errors(self, references, *arguments):
        found = self.answer("modes", "--modes", len(references), "--no-estimate", *arguments)["modes"]
        return [1200 * math.log2(mode["frequency"] / exact) for mode, exact in zip(found, references)]

    def facts(self, *arguments):
        return self.answer("check", *arguments)["bodies"]["bar"]

    @program.long_verification
    def test_recommended_hexahedra_are_as_accurate_as_wanted(self):
        for sides, references in self.BAR, self.PLATE, self.CUBE:
            coarse = self.settings(sides, size=sides["width"], layers=1)
            found = self.facts("--up-to", math.ceil(references[-1]), *coarse)["recommended"]
            hexahedra = found["hex"]
            tet10 = found.get("tet10", {"processor_seconds": math.inf})  # there may be none with so few cells
            self.assertLess(hexahedra["processor_seconds"], tet10["processor_seconds"])
            order = "{{plane: {plane}, thickness: {thickness}}}".format(**hexahedra["order"])
            mesh = self.settings(sides, size=hexahedra["size"], layers=hexahedra["layers"], hexahedra=1)
            element = ["--set", "bodies.bar.element=hex", "--set", f"bodies.bar.order={order}"]
            errors = self.errors(references, *mesh, *element)
            self.assertLess(max(map(abs, errors)), 5, (sides, hexahedra, errors))
            at_present = self.facts("--up-to", math.ceil(references[-1]), *mesh, *element)
            self.assertGreater(at_present["highest_within_5_cents"], 0.99 * references[-1])
            self.assertAlmostEqual(at_present["recommended"]["hex"]["relative_cost"], 1, delta=0.35)

    @program.long_verification
    def test_recommended_tetrahedra_are_as_accurate_as_wanted(self):
        for (sides, references), cents in (self.BAR, 20), (self.CUBE, 50):
            coarse = self.settings(sides, size=sides["width"], layers=1)
            found = self.facts("--accuracy", cents, "--up-to", math.ceil(references[-1]), *coarse)["recommended"]["tet10"]
            errors = self.errors(references, *self.settings(sides, size=found["size"], layers=found["layers"]))
            self.assertLess(max(map(abs, errors)), cents, (sides, found, errors))

    def test_the_recommendation_says_what_it_leaves_out(self):
        mesh = ["--up-to", 1000, *self.settings(self.BAR[0], size=0.03, layers=1)]
        self.assertEqual(self.facts(*mesh)["recommended"]["left_out"], [])
        clamped = self.facts(*mesh, "--set", "bodies.bar.fixed=[clamp]")
        self.assertEqual(clamped["recommended"]["left_out"], ["fixed"])
        self.assertGreater(clamped["processor_seconds"], 0)

    def test_the_promise_knows_torsion(self):
        sides, references = self.BAR
        mesh = self.settings(sides, size=0.005, layers=2)
        torsion = self.errors(references[:4], *mesh)[3]
        self.assertLess(torsion, -10)
        facts = self.facts(*mesh)
        self.assertLess(facts["highest_within_5_cents"], references[3])
        self.assertGreater(facts["highest_within_50_cents"], references[-1])
        self.assertNotIn("recommended", facts)

    def test_the_promise_for_a_cube(self):
        sides, references = self.CUBE
        mesh = self.settings(sides, size=0.1 / 6, layers=6)
        limit = self.facts(*mesh)["highest_within_50_cents"]
        for error, reference in zip(self.errors(references, *mesh), references):
            if reference < limit:
                self.assertLess(abs(error), 50)
        self.assertGreater(limit, references[0])  # 18 cents
        self.assertLess(limit, 22135)  # 52 cents


if __name__ == "__main__":
    unittest.main()
