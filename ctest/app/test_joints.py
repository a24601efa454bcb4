#!/usr/bin/python3
"""Bodies that a joint ties together: their sound, energies, modes and sound map, and what is refused."""
import itertools
import json
import tempfile
import unittest

import h5py
import numpy

import program

DECK = program.deck("joined")
FOAM = ("--set", "materials.foam={young: 1.0e7, poisson: 0.3, density: 300}", "--set", "bodies.right.material=foam")
HINGE = "--set", ("joints.glue={type: hinge, between: [left.tip, right.clamp], axis: [[0.0603, -0.01, 0], [0.0603, 0.01, 0]], "
                  "turning: {stiffness: 0.1, damping: 1.0e-3}}")
SPRING = "--set", ("joints.coil={type: spring, between: [left.clamp, right.clamp], stiffness: {axial: 200, lateral: 100}, "
                   "at: [0.03, 0, 0], radius: 1, damping: 1.0e-4}")
BOLT = "--set", ("joints={bolt: {type: bolt, between: [left.clamp, right.tip], axis: [[0, 0, 0], [0.1205, 0, 0]], radius: 0.01, "
                 "shank: 0.003, material: rubber, preload: 20}}")
STIFF = ("--set", "materials.rubber={young: 2.0e11, poisson: 0.3, density: 7850}",
         "--set", "materials.wire={young: 2.0e9, poisson: 0.3, density: 1000}", "--set", "bodies.left.spin=[0, 0, 0]",
         "--set", "time.duration=0.002", "--set", "audio.rate=16000")
STUD = ("stud: {type: bolt, between: [left.clamp, right.tip], axis: [[0, 0, 0], [0.1205, 0, 0]], radius: 0.02, shank: 0.003, "
        "material: wire, preload: 30}")
MODAL = tuple(argument for body in ("left", "right") for argument in ("--set", f"bodies.{body}.model={{type: modal, count: 6}}"))
AT_REST = ("--set", "bodies.left.spin=[0, 0, 0]", "--set", "bodies.right.velocity=[0, 0, 0]",
           "--set", "materials.rubber.expansion=1e-4", "--set", "bodies.left.fixed=[clamp]",
           "--set", "bodies.right.fixed=[tip]", "--set", "bodies.right.prestress={temperature: -100}",
           "--set", "time.duration=0.0025")
LOOSE = AT_REST[:8] + AT_REST[10:]  # nothing but glue holds the body on the right
PAD = "pad: {between: [left.tip, right.clamp], stiffness: {normal: 1.0e9, tangential: 1.0e9}}"
SCORE = """
duration: 0.1
events:
  - {time: 0.01, type: force, body: left, at: [0.12, 0, 0.01], force: [0, 0, -10], shape: half_sine, duration: 5.0e-4}
"""


class Joints(program.TestCase):
    def test_the_bodies_stay_together_and_keep_momentum_and_energy(self):
        self.job = program.run("joined", self.output, "--set", "materials.rubber.damping=null")
        self.require_status(self.job, program.FINISHED)
        self.assertIn("joint glue: 0.0006 m2 joined, at most 0.0005 m apart", self.job.stdout + self.job.stderr)
        result = program.contents(self.output / "joined.h5")
        momentum = result["motion/left/velocity"] + result["motion/right/velocity"]  # of equal masses
        self.assertLess(abs(momentum - momentum[0]).max(), 1e-9)
        apart = numpy.linalg.norm(result["motion/right/centre_of_mass"] - result["motion/left/centre_of_mass"], axis=1)
        self.assertLess(abs(apart / 0.0605 - 1).max(), 0.05)
        energy = result["energy"]
        total = energy[:, :4].sum(axis=1) + energy[:, 5]
        self.assertGreater(energy[:, 5].max(), 0)
        self.assertLess(abs(total / total[0] - 1).max(), 0.02)

    def test_modal_bodies_stay_together_with_the_same_bits_on_any_ranks(self):
        modal = "--set", "bodies.right.model={type: modal, count: 6}", "--set", "materials.rubber.damping=null"
        self.job = program.run("joined", self.output, *modal)
        self.require_status(self.job, program.FINISHED)
        self.assertIn("body right: 84 nodes, 2 hex elements", self.job.stdout)
        self.assertIn("rigid motion, 6 modes", self.job.stdout)
        self.assertIn("6 further modes for its joints", self.job.stdout)
        alone = program.contents(self.output / "joined.h5")
        momentum = alone["motion/left/velocity"] + alone["motion/right/velocity"]
        self.assertLess(abs(momentum - momentum[0]).max(), 1e-9)
        apart = numpy.linalg.norm(alone["motion/right/centre_of_mass"] - alone["motion/left/centre_of_mass"], axis=1)
        self.assertLess(abs(apart / 0.0605 - 1).max(), 0.05)
        self.require_status(program.run("joined", self.output, *modal, ranks=3), program.FINISHED)
        self.require_same(self.output / "joined.h5", alone)

    def test_two_modal_bodies_have_the_same_bits_on_two_ranks_and_through_resume(self):
        modal = ("--set", "bodies.left.model={type: modal, count: 3}", "--set", "bodies.right.model={type: modal, count: 4}",
                 "--set", "time.duration=0.0025")
        self.job = program.run("joined", self.output / "one", *modal)
        self.require_status(self.job, program.FINISHED)
        alone = program.contents(self.output / "one" / "joined.h5")
        self.require_status(program.run("joined", self.output / "two", *modal, ranks=2), program.FINISHED)
        self.require_same(self.output / "two" / "joined.h5", alone)
        self.run_in_jobs("joined", self.output, *modal, ranks=4 * (2, 1))
        self.require_same(self.output / "joined.h5", alone)

    def test_check_counts_the_states_of_ghosts_beside_modal_bodies(self):
        for model, bytes_of_ghost in ("{type: finite_elements}", 24), ("{type: modal, count: 6}", 64):
            setting = "--set", f"bodies.right.model={model}", "--set", "time.duration=0.001"
            job = program.idiophone("check", DECK, *setting, "-n", 2, "--json")
            self.require_status(job, program.FINISHED)
            predicted = json.loads(job.stdout)["prediction"]["largest_part"]
            self.assertEqual(predicted["halo_bytes"], bytes_of_ghost * predicted["ghost_nodes"])
            self.require_status(program.run("joined", self.output, *setting, ranks=2), program.FINISHED)
            job = program.idiophone("info", self.output / "joined.h5", "--json")
            self.assertEqual(predicted, json.loads(job.stdout)["run"]["jobs"][0]["largest_part"])
            (self.output / "joined.h5").unlink()

    def test_modes_that_an_assembly_lacks_are_asked_for_at_their_place(self):
        job = program.run("joined", self.output, "--set", "bodies.left.model={type: modal, count: 1}",
                          "--set", "bodies.right.model={type: modal, up_to: 1}")
        self.require_status(job, program.WRONG_DECK)
        self.assertIn("bodies.right.model", job.stderr)
        self.assertIn("the assembly of bodies 'left', 'right' has no modes up to 1 Hz", job.stderr)

    def test_a_damped_hinge_and_a_spring_keep_momentum_and_the_same_bits_on_any_ranks(self):
        self.job = program.run("joined", self.output, *HINGE, *SPRING)
        self.require_status(self.job, program.FINISHED)
        self.assertIn("joint glue: a hinge of 0.02 m; stiffness", self.job.stdout)
        self.assertIn("joint glue: stiffness 0.1 N m/rad against turning", self.job.stdout)
        self.assertIn("joint coil: a spring of 0.0605 m; stiffness 200 N/m axial, 100 N/m lateral, damping 0.0001 s", self.job.stdout)
        alone = program.contents(self.output / "joined.h5")
        momentum = alone["motion/left/velocity"] + alone["motion/right/velocity"]
        self.assertLess(abs(momentum - momentum[0]).max(), 1e-9)
        energy = alone["energy"]
        total = energy[:, :4].sum(axis=1) + energy[:, 5]
        self.assertLess(total[-1], total[0])
        self.assertLess(total.max(), 1.001 * total[0])
        self.require_status(program.run("joined", self.output, *HINGE, *SPRING, ranks=3), program.FINISHED)
        self.require_same(self.output / "joined.h5", alone)

    def test_a_bolt_with_preload_keeps_momentum_and_the_same_bits_on_any_ranks_and_through_resume(self):
        self.job = program.run("joined", self.output / "one", *BOLT)
        self.require_status(self.job, program.FINISHED)
        self.assertIn("joint bolt: a bolt of 0.1205 m under 20 N; stiffness 1.173e+04 N/m axial, 220.9 N/m lateral, "
                      "0.2272 N m/rad in bending, 0.01886 N m/rad in torsion", self.job.stdout)
        alone = program.contents(self.output / "one" / "joined.h5")
        momentum = alone["motion/left/velocity"] + alone["motion/right/velocity"]
        self.assertLess(abs(momentum - momentum[0]).max(), 1e-9)
        self.assertGreater(abs(momentum - 2 * alone["motion/left/velocity"]).max(), 0.1)
        self.require_status(program.run("joined", self.output / "three", *BOLT, ranks=3), program.FINISHED)
        self.require_same(self.output / "three" / "joined.h5", alone)
        self.run_in_jobs("joined", self.output, *BOLT, ranks=4 * (2, 1))
        self.require_same(self.output / "joined.h5", alone)

    def said_of_bolts(self, joints, speed, models=(), ranks=(1,), jobs=1):
        """What a run of two steel blocks of 0.2826 kg says of bolts. They fly apart, each at a speed.
        @param models  MODAL: modal blocks
        @param ranks   of its jobs in turn
        @param jobs    at most so many: if more than one, each stops at the end of its first block"""
        motion = "--set", f"bodies.left.velocity=[{-speed}, 0, 0]", "--set", f"bodies.right.velocity=[{speed}, 0, 0]"
        limit = ("--set", "time.wall_clock_limit=1e-6") if jobs > 1 else ()
        said = ""
        with tempfile.TemporaryDirectory() as folder:
            for _, count in zip(range(jobs), itertools.cycle(ranks)):
                job = program.run("joined", folder, *STIFF, *models, *motion, *limit, "--set", f"joints={{{joints}}}", "--resume",
                                  ranks=count)
                said += job.stdout + job.stderr
                if job.returncode != program.RESUMABLE:
                    break
        self.require_status(job, program.FINISHED)
        return [line for line in said.splitlines() if "the motion t" in line]

    def test_a_bolt_that_loses_its_pull_is_warned_of(self):
        # A spring k = E A/L between two masses: the force is v sqrt(2 k m) sin(sqrt(2 k/m) t), here 51.5 N, above 30 N at 0.34 ms.
        said = self.said_of_bolts(STUD, -0.1)
        self.assertEqual(len(said), 2)
        self.assertRegex(said[0], r"joint stud: at 0.000375 s the motion takes 32\.\d+ N off the pull of its shank, which its preload "
                         "of 30 N gives: head and nut would come off, and here the shank pushes")
        self.assertIn("joint stud: the motion took at most 1.71 of its preload off the pull of its shank", said[1])
        resumed = self.said_of_bolts(STUD, -0.1, ranks=(3, 1), jobs=10)
        self.assertEqual([resumed[0], resumed[-1]], said)
        self.assertEqual(sum("the motion takes" in line for line in resumed), 1)
        self.assertEqual(self.said_of_bolts(STUD, -0.1, MODAL)[1:], said[1:])

    def test_parts_that_a_blow_pulls_apart_are_warned_of(self):
        # Likewise with the stiffness of stud and pad: their forces are as 469 to 600, and 0.2 m/s make 77.7 N.
        said = self.said_of_bolts(f"{PAD}, {STUD}", 0.1)
        self.assertEqual(len(said), 3)
        self.assertRegex(said[0], r"joint stud: at 0.0003125 s the motion takes 33\.\d+ N off the pressure at the joint 'pad', which "
                         "its preload of 30 N gives: the parts would come apart there")
        self.assertIn("the motion took at most 1.45 of its preload off the pressure at the joint 'pad'", said[1])
        self.assertIn("the motion took at most 1.13 of its preload off the pull of its shank", said[2])
        self.assertEqual(self.said_of_bolts(f"{PAD}, {STUD}", 0.1, ranks=(3,)), said)
        self.assertEqual(self.said_of_bolts(f"{PAD}, {STUD}", 0.1, MODAL)[1:], said[1:])
        self.assertEqual(len(self.said_of_bolts(f"{PAD}, {STUD}", 0.06)), 2)  # 0.87 and 0.68

    def test_bodies_that_pull_at_each_other_or_are_plucked_start_in_equilibrium(self):
        at_rest = AT_REST
        self.job = program.run("joined", self.output, *at_rest)
        self.require_status(self.job, program.FINISHED)
        alone = program.contents(self.output / "joined.h5")
        energy = alone["energy"]
        self.assertGreater(energy[0, 5], 1e-6)  # the glue is stretched
        self.assertLess(energy[:, 0].max(), 1e-12 * energy[0, 5])
        self.require_status(program.run("joined", self.output, *at_rest, ranks=3), program.FINISHED)
        self.require_same(self.output / "joined.h5", alone)
        pluck = "--set", "loads={finger: {type: pluck, body: left, at: [0.05, 0, 0.01], force: [0, 0, -1]}}"
        self.require_status(program.run("joined", self.output, *at_rest, *pluck), program.FINISHED)
        plucked = program.contents(self.output / "joined.h5")["energy"]
        total = plucked[:, :4].sum(axis=1) + plucked[:, 5]
        self.assertGreater(plucked[:, 0].max(), 0.1 * (total[0] - energy[0, [1, 5]].sum()))

    def test_modal_bodies_that_pull_at_each_other_rest(self):
        left, right = (("--set", f"bodies.{body}.model={{type: modal, count: 6}}") for body in ("left", "right"))
        for number, what in enumerate([AT_REST + left, AT_REST + right, AT_REST + left + right, LOOSE + right]):
            self.job = program.run("joined", self.output / str(number), *what)
            self.require_status(self.job, program.FINISHED)
            energy = program.contents(self.output / str(number) / "joined.h5")["energy"]
            self.assertGreater(energy[0, 5], 1e-6)
            self.assertLess(energy[:, 0].max(), 1e-12 * energy[0, 5], what)
        for number, what, ranks in (0, AT_REST + left, 3), (2, AT_REST + left + right, 2):
            self.require_status(program.run("joined", self.output / "ranks", *what, ranks=ranks), program.FINISHED)
            self.require_same(self.output / "ranks" / "joined.h5", program.contents(self.output / str(number) / "joined.h5"))
            (self.output / "ranks" / "joined.h5").unlink()

    def test_a_modal_body_with_a_spring_between_its_ends_rests_under_its_prestress_and_is_plucked_from_there(self):
        cord = "--set", "joints={cord: {type: spring, between: [left.clamp, left.tip], stiffness: 1000}}"
        model = "--set", "bodies.left.model={type: modal, count: 6}"
        cold = "--set", "bodies.left.prestress={temperature: -100}", "--set", "bodies.right.prestress=null"
        pluck = ("--set", "loads={finger: {type: pluck, body: left, at: [0.05, 0, 0.01], force: [0, 0, -1]}}",
                 "--set", "materials.rubber.damping=null")
        for number, elements in enumerate([(), model]):
            self.job = program.run("joined", self.output / f"rest{number}", *AT_REST, *cold, *cord, *elements)
            self.require_status(self.job, program.FINISHED)
            energy = program.contents(self.output / f"rest{number}" / "joined.h5")["energy"]
            self.assertGreater(energy[0, 5], 1e-6)
            self.assertLess(energy[:, 0].max(), 1e-12 * energy[0, 5])
        ways = []
        for number, elements in enumerate([(), model]):
            self.job = program.run("joined", self.output / f"pluck{number}", *AT_REST, *cold, *cord, *pluck, *elements)
            self.require_status(self.job, program.FINISHED)
            ways.append(program.contents(self.output / f"pluck{number}" / "joined.h5")["motion/left/centre_of_mass"])
        expected, found = ways
        self.assertLess(abs(found - expected).max(), 0.02 * abs(expected - expected[0]).max())

    def test_modal_bodies_that_pull_at_each_other_are_plucked_as_finite_elements_are(self):
        pluck = ("--set", "loads={finger: {type: pluck, body: left, at: [0.05, 0, 0.01], force: [0, 0, -1]}}",
                 "--set", "materials.rubber.damping=null")
        for held in AT_REST, LOOSE:
            ways = []
            for models in (), MODAL:
                with tempfile.TemporaryDirectory() as folder:
                    self.job = program.run("joined", folder, *held, *pluck, *models)
                    self.require_status(self.job, program.FINISHED)
                    result = program.contents(f"{folder}/joined.h5")
                ways.append(result["motion/right/centre_of_mass"][:, 2])
                energy = result["energy"]
                total = energy[:, :4].sum(axis=1) + energy[:, 5]
                self.assertLess(abs(total - total[0]).max(), 0.02 * energy[:, 0].max())
            expected, found = ways
            self.assertLess(abs(found - expected).max(), 0.005 * abs(expected - expected[0]).max())

    def test_bodies_without_rest_are_refused_where_the_cause_is(self):
        pluck = ("--set", "loads={finger: {type: pluck, body: left, at: [0.05, 0, 0.01], force: [0, 0, -1]}}", "--set", "joints={}",
                 "--set", "bodies.right.supports={cord: {at: [0.1, 0, 0.01], radius: 0.02, stiffness: 1000}}")
        job = program.run("joined", self.output, *pluck)
        self.require_status(job, program.WRONG_DECK)
        self.assertIn("nothing holds body 'left' under pluck 'finger', so there is no rest", job.stderr)
        only_right_is_deformed = ("--set", "bodies.left.fixed=[clamp, tip]", "--set", "bodies.left.prestress={xx: 1000}",
                                  "--set", "bodies.right.prestress={yz: 1.0e11}")
        job = program.idiophone("modes", DECK, *only_right_is_deformed, "--output-folder", self.output)
        self.require_status(job, program.WRONG_DECK)
        self.assertIn("bodies.right.prestress leaves no static equilibrium", job.stderr)

    def test_bolted_bodies_have_modes_and_a_map_that_rise_with_the_preload(self):
        lowest = []
        for pull in 0, 20:
            bolt = BOLT[0], BOLT[1].replace("preload: 20", f"preload: {pull}")
            job = program.idiophone("modes", DECK, *bolt, "--modes", 4, "--output-folder", self.output)
            self.require_status(job, program.FINISHED)
            self.assertIn("6 rigid motions", job.stdout)
            job = program.idiophone("map", DECK, *bolt, *FOAM, "--modes", 4, "--output-folder", self.output)
            self.require_status(job, program.FINISHED)
            with h5py.File(self.output / "joined_modes.h5") as modes:
                lowest.append(modes["modes/left/frequency"][0])
            (self.output / "joined_modes.h5").unlink()
            self.output.joinpath("joined_left.map.h5").unlink()
        self.assertGreater(lowest[1], 1.02 * lowest[0])

    def test_bodies_on_a_spring_have_modes_and_a_map_of_both_closed_surfaces(self):
        only = "--set", "joints={coil: {type: spring, between: [left.clamp, right.tip], stiffness: 200}}"
        job = program.idiophone("modes", DECK, *only, "--modes", 4, "--output-folder", self.output)
        self.require_status(job, program.FINISHED)
        self.assertIn("9 rigid motions", job.stdout)
        job = program.idiophone("map", DECK, *only, *FOAM, "--modes", 4, "--output-folder", self.output)
        self.require_status(job, program.FINISHED)
        path, = self.output.glob("*.map.h5")
        with h5py.File(path) as made:
            triangles = made["surface/triangles"][()]
            self.assertEqual(made["modes/frequency"].shape, (4,))
        edges = numpy.sort(numpy.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
        self.assertTrue((numpy.unique(edges, axis=0, return_counts=True)[1] == 2).all())

    def test_modes_are_those_of_both_bodies(self):
        job = program.idiophone("modes", DECK, "--modes", "4", "--output-folder", self.output)
        self.require_status(job, program.FINISHED)
        self.assertIn("bodies left, right:", job.stdout)
        self.assertIn("6 rigid motions", job.stdout)
        with h5py.File(self.output / "joined_modes.h5") as file:
            for body in "left", "right":
                self.assertEqual(file[f"modes/{body}/shape"].shape[1:], file[f"mesh/{body}/nodes"].shape)
            numpy.testing.assert_array_equal(file["modes/left/frequency"], file["modes/right/frequency"])

    def kinds(self, bodies, joints, count):
        """The modes of bars of steel, 30 x 10 mm, from --json.
        @param bodies  [(name, length, begin)] in m"""
        deck = self.output / "bars.yaml"
        bar = ("mesh: %s, parameters: {length: %s, width: 0.03, thickness: 0.01, size: 0.1}, position: [%s, %s, 0], "
               "element: hex, order: {plane: 4, thickness: 2}, material: steel")
        sections = "".join(f"  {name}: {{{bar % (program.SOURCE / 'meshes/bar.geo', length, *begin)}}}\n"
                           for name, length, begin in bodies)
        deck.write_text(f"""name: bars
time: {{duration: 0.01}}
materials: {{steel: {{young: 2.0e11, poisson: 0.3, density: 7850}}}}
bodies:
{sections}joints: {{{joints}}}
listeners: {{ear: {{type: mono, position: [0, 0, 1]}}}}
""")
        job = program.idiophone("modes", deck, "--modes", count, "--no-estimate", "--output-folder", self.output, "--json")
        self.require_status(job, program.FINISHED)
        return json.loads(job.stdout)["modes"]

    def test_a_bar_that_is_cut_and_tied_has_the_kinds_of_the_whole_bar(self):
        whole = self.kinds([("bar", 0.3, (0, 0))], "", 12)
        tied = self.kinds([("left", 0.1, (0, 0)), ("right", 0.2, (0.1, 0))],
                          "weld: {between: [left.tip, right.clamp], stiffness: rigid}", 12)
        self.assertEqual([mode["kind"] for mode in tied], [mode["kind"] for mode in whole])
        self.assertEqual(whole[0]["kind"], "bending 1 along z")
        self.assertEqual(whole[0]["kinetic_share"], {"bar": 1})
        stretched, = [mode for mode in tied if mode["kind"] == "longitudinal 1"]
        exact = (1 + numpy.sqrt(0.75) / numpy.pi * 1.5) / 3  # of cos(pi x/l)^2, up to l/3: 1/3 + sin(2 pi/3)/(2 pi)
        self.assertAlmostEqual(stretched["kinetic_share"]["left"], exact, 3)
        with h5py.File(self.output / "bars_modes.h5") as file:
            for body in "left", "right":
                self.assertEqual([text.decode() for text in file[f"modes/{body}/kind"]], [mode["kind"] for mode in tied])
                numpy.testing.assert_allclose(file[f"modes/{body}/kinetic_share"],
                                              [mode["kinetic_share"][body] for mode in tied], rtol=1e-12)

    def test_modes_of_one_of_several_bodies_on_springs_have_its_name(self):
        bars = [("short", 0.2, (0, 0)), ("long", 0.3, (0, 0.05))]
        modes = self.kinds(bars, "cord: {type: spring, between: [short.clamp, long.clamp], stiffness: 1000}", 8)
        bending = [mode for mode in modes if mode["kind"] in ("long: bending 1 along z", "short: bending 1 along z")]
        self.assertEqual([mode["kind"].split(":")[0] for mode in bending], ["long", "short"])
        for mode, length in zip(bending, (0.3, 0.2)):
            self.assertGreater(max(mode["kinetic_share"].values()), 0.9)
            exact = 4.73004 ** 2 / (2 * numpy.pi) * numpy.sqrt(2e11 / 7850) * 0.01 / numpy.sqrt(12) / length ** 2
            self.assertAlmostEqual(mode["frequency"] / exact, 1, delta=0.02)

    def test_modes_of_glued_bodies_have_an_error_of_the_mesh(self):
        job = program.idiophone("modes", program.deck("bar_of_layers"), "--modes", 3, "--json", "--output-folder", self.output)
        self.require_status(job, program.FINISHED)
        for mode in json.loads(job.stdout)["modes"]:
            self.assertGreater(mode["mesh_error"], 0.05)

    def test_check_estimates_no_modes_of_a_body_by_itself(self):
        job = program.idiophone("check", DECK, "--json")
        self.require_status(job, program.FINISHED)
        for body in json.loads(job.stdout)["bodies"].values():
            self.assertNotIn("lowest_modes", body)

    def test_one_map_has_the_modes_of_both_bodies_and_is_played(self):
        job = program.idiophone("map", DECK, *FOAM, "--modes", 4, "--radiation", "kirchhoff", "--output-folder", self.output)
        self.require_status(job, program.FINISHED)
        self.assertIn("bodies left, right: joints tie them together", job.stdout + job.stderr)
        path, = self.output.glob("*.map.h5")
        self.assertEqual(path.name, "joined_left.map.h5")
        self.require_status(program.idiophone("modes", DECK, *FOAM, "--modes", 4, "--output-folder", self.output),
                            program.FINISHED)
        with h5py.File(path) as made, h5py.File(self.output / "joined_modes.h5") as modes:
            numpy.testing.assert_allclose(made["modes/frequency"], modes["modes/left/frequency"], rtol=1e-9)
            numpy.testing.assert_allclose(made["modes/material_decay"],
                                          numpy.log(1000) / numpy.array(modes["modes/left/decay_time"]), rtol=1e-9)
            self.assertAlmostEqual(float(made.attrs["mass"]), 3.6e-5 * (1100 + 300), 9)
            self.assertNotIn("material", made.attrs)
            vertices, triangles = made["surface/vertices"][()], made["surface/triangles"][()]
            x = vertices[triangles].mean(axis=1)[:, 0]
            self.assertEqual(list(x[(x > 0.05999) & (x < 0.06051)]), [])  # no triangle of the two joined faces
            self.assertGreater(vertices[:, 0].max(), 0.12)
        score = self.output / "score.yaml"
        score.write_text(SCORE)
        self.require_status(program.idiophone("play", path, "--score", score, "--output", self.output / "blow.wav"),
                            program.FINISHED)
        self.assertGreater(abs(numpy.frombuffer((self.output / "blow.wav").read_bytes()[-20000:], dtype="<f4")).max(), 0)

    def test_what_knows_no_joints_refuses_them(self):
        job = program.idiophone("map", DECK, "--estimate", "--output-folder", self.output)
        self.assertEqual(job.returncode, program.FAILED)
        self.assertIn("--estimate is for bodies without joints", job.stderr)
        job = program.idiophone("modes", DECK, "--in-air", "--output-folder", self.output)
        self.assertEqual(job.returncode, program.FAILED)
        self.assertIn("--in-air is for a body without joints", job.stderr)
        job = program.idiophone("modes", DECK, "--estimate", "--output-folder", self.output)
        self.assertEqual(job.returncode, program.FAILED)
        self.assertIn("--estimate is not possible: the elements of 'left' are tet10, and those of 'right' hex", job.stderr)
        job = program.idiophone("modes", DECK, "--modes", 2, "--output-folder", self.output)
        self.require_status(job, program.FINISHED)
        self.assertIn("the error of the mesh is not estimated: the elements of 'left' are tet10", job.stdout + job.stderr)
        job = program.idiophone("bench", DECK, "--target", "1:2")
        self.assertEqual(job.returncode, program.WRONG_DECK)
        self.assertIn("joints.glue: 'bench' does not know joints", job.stderr)


if __name__ == "__main__":
    unittest.main()
