#!/usr/bin/python3
"""`idiophone bench`: its partials and cuts, its page, and answers to wrong options."""
import importlib.machinery
import importlib.util
import json
import math
import unittest

import ezdxf
import h5py
import numpy

import program
from web import in_browser

BAR = program.SOURCE / "inputs/tuning/vibraphone_bar.yaml"
COARSE = ("--set", "bodies.bar.order={plane: 4, thickness: 2}")
AT_THE_END = "--tapped-at=0.17,0,0"  # in the middle of the width, where torsion is hardly excited
TARGET = ("--target", "1:4:10", "--mode-numbers", "1,2,5")


class Bench(program.TestCase):
    def bench(self, *arguments, status=program.FINISHED):
        job = program.idiophone("bench", BAR, *COARSE, *arguments)
        self.require_status(job, status)
        return job

    def answer(self, *arguments):
        """The facts, whatever the verdict; the status tells whether it is one to go on with."""
        job = program.idiophone("bench", BAR, *COARSE, *arguments, "--json")
        facts = json.loads(job.stdout)
        self.require_status(job, program.FINISHED if facts["verdict"] in ("cut", "in_tune") else program.FAILED)
        return facts

    def facts(self, *arguments):
        return self.answer(*TARGET, *arguments)

    def measured(self, frequencies):
        path = self.output / "tap.yaml"
        path.write_text(json.dumps({"uncertainty": 1, "lines": frequencies}))
        return "--measured", path

    def test_the_next_cuts_and_their_page(self):
        page = self.output / "bench.html"
        facts = self.facts("-o", page)
        self.assertEqual((facts["verdict"], facts["side"], facts["along"]), ("cut", "-z", "x"))
        first, second, third = facts["partials"]
        self.assertEqual(first["missing"], 0)
        self.assertAlmostEqual(second["missing"], 1200 * math.log2(4 * first["computed"] / second["computed"]), places=6)
        for partial in (second, third):
            self.assertLess(abs(partial["expected"]), abs(partial["missing"]))
        for cut in facts["cuts"]:
            self.assertTrue(1e-4 <= cut["depth"] <= 1e-3)
            self.assertLess(abs(cut["place"]) + cut["width"] / 2, 0.18)
        seen = in_browser("bench.mjs", page)
        self.assertEqual(seen["complaints"], [])
        self.assertTrue(seen["narrow"], "the page is wider than a phone")
        self.assertEqual(seen["advice"].rstrip(".").lower(), facts["advice"])
        self.assertEqual(seen["cuts"], len(facts["cuts"]))
        self.assertTrue(seen["cut_triangles"] > 0 and seen["coloured"] > 5, "the surface is not coloured")
        self.assertNotEqual(seen["first_legend"], seen["last_legend"])

    def test_the_plan_goes_on_where_the_mesh_bears_grooves_badly(self):
        """The nodes of this mesh lie 12 mm apart, as far as a groove is wide: more depth in it does what no slope says."""
        last = self.facts()["visits"][-1]
        self.assertLess(max(map(abs, last["expected"])), 25)

    def computed(self, *arguments):
        modes = program.idiophone("modes", BAR, *COARSE, *arguments, "--mass", "consistent", "--modes", "6", "--output-folder",
                                  self.output, "--json")
        self.require_status(modes, program.FINISHED)
        return [mode["frequency"] for mode in json.loads(modes.stdout)["modes"]]

    def test_says_what_decides_where_a_line_may_be_that_of_another_mode(self):
        lines = self.computed()  # the second bending mode and the first torsion are 54 cents apart
        job = self.bench(*TARGET, *self.measured(lines), status=program.FAILED)
        self.assertIn("or of mode 3 (torsion 1)", job.stdout)
        self.assertIn("no cuts to make: ambiguous", job.stderr + job.stdout)
        exact = ",".join(map(str, (lines[0], lines[1], lines[4])))
        in_tune = ("--target", exact, "--mode-numbers", "1,2,5")
        facts = self.answer(*in_tune, *self.measured(lines))
        self.assertEqual(facts["verdict"], "ambiguous")
        self.assertLess(facts["learned"]["probability"], 0.99)
        # At the place that the command names, torsion is not excited; then the lines are certain.
        place = ",".join(map(str, facts["tap_at"]))
        heard = [line for number, line in enumerate(lines) if number not in (2, 3)]
        facts = self.answer(*in_tune, *self.measured(heard), f"--tapped-at={place}")
        self.assertEqual(facts["verdict"], "in_tune")
        self.assertGreater(facts["learned"]["probability"], 0.99)

    def test_a_bar_whose_modes_changed_places_is_not_called_in_tune(self):
        lines = self.computed("--set", "materials.aluminium.poisson=0.45")  # a softer shear: torsion lies below bending
        wrong = ",".join(map(str, (lines[0], lines[1], lines[4])))  # in tune, if lines kept the order of the modes
        target = ("--target", wrong, "--mode-numbers", "1,2,5")
        self.assertEqual(self.answer(*target, *self.measured(lines))["verdict"], "ambiguous")
        heard = self.measured([line for number, line in enumerate(lines) if number not in (1, 3)])
        facts = self.answer(*target, *heard, AT_THE_END)
        self.assertNotEqual(facts["verdict"], "in_tune")
        self.assertAlmostEqual(facts["partials"][1]["measured"], lines[2], places=6)

    def test_a_doubted_line_is_ambiguous_where_the_likeliest_way_leaves_a_mode_without_one(self):
        lines = self.computed()
        heard = [line for number, line in enumerate(lines) if number != 1]  # mode 2, or torsion, which lies near
        facts = self.facts(*self.measured(heard))
        self.assertEqual(facts["verdict"], "ambiguous")
        self.assertIn("may be that of mode 2 (bending 2 along z) or of mode 3 (torsion 1)", facts["advice"])
        self.assertIsNone(facts["partials"][1]["measured"])
        self.assertEqual(facts["cuts"], [])

    def test_learned_constants_are_those_of_a_stable_material(self):
        soft = ("--set", "materials.aluminium.poisson=0.47")
        flat = 2 ** (-50 / 1200)  # of torsion, as of Poisson's ratio 0.54
        lines = [line * (flat if number in (1, 5) else 1) for number, line in enumerate(self.computed(*soft))]
        facts = self.answer("--target", "1:4:10", "--mode-numbers", "1,3,5", *soft, *self.measured(sorted(lines)))
        poisson, = (constant for constant in facts["learned"]["constants"] if constant["name"] == "poisson")
        self.assertGreater(poisson["change"], 0.02)
        self.assertLess(poisson["change"], 0.03)
        self.assertEqual(facts["verdict"], "cut")

    def test_a_file_with_its_last_tap_after_its_last_cut_needs_no_other_tap(self):
        lines = [line for number, line in enumerate(self.computed()) if number not in (2, 3)]
        tapped = self.facts(*self.measured(lines), AT_THE_END)
        made = self.output / "cuts.yaml"
        made.write_text(f"cuts: []\ntaps: [{{cuts: 0, lines: {lines}, uncertainties: {[1] * len(lines)}, at: [0.17, 0, 0]}}]")
        self.assertEqual(self.facts("--cuts", made)["cuts"], tapped["cuts"])
        # What the command writes, it reads, however shallow a cut is.
        made.write_text('cuts: [{tool: "sander:0.02", place: 0.0123456, depth: 4e-7}]')
        made.write_text(self.facts("--cuts", made)["cuts_file"])
        self.assertIn("depth: 4e-07", made.read_text())
        self.assertIn("depth: 4e-07", self.facts("--cuts", made)["cuts_file"])

    def test_measured_partials_are_matched_and_keep_their_shifts(self):
        computed = self.computed()
        raised = [frequency * 2 ** ((150 + 5 * number) / 1200) for number, frequency in enumerate(computed) if number not in (2, 3)]
        facts = self.facts(*self.measured(raised), AT_THE_END)
        for partial, number in zip(facts["partials"], (0, 1, 4), strict=True):
            self.assertAlmostEqual(partial["shift"], 150 + 5 * number, places=3)
        job = self.bench(*TARGET, *self.measured([computed[1], *computed[4:]]), AT_THE_END, status=program.FAILED)
        self.assertIn("mode 1, computed at", job.stderr)
        self.assertIn("was not measured", job.stderr)

    def test_a_line_that_the_last_tap_misses_is_carried_over(self):
        made, page = self.output / "cuts.yaml", self.output / "bench.html"
        made.write_text('cuts: [{tool: "router:0.006", place: 0.0255, depth: 0.0005}]')
        cut = [partial["computed"] for partial in self.facts("--cuts", made)["partials"]]
        lines = [partial["computed"] for partial in self.facts()["partials"]]
        made.write_text('cuts: [{tool: "router:0.006", place: 0.0255, depth: 0.0005}]\n'
                        f"taps: [{{cuts: 0, lines: {lines}, uncertainties: [1, 1, 1], at: [0.17, 0, 0]}}]")
        again = ("--cuts", made, *self.measured([cut[0], cut[2]]), AT_THE_END)
        facts = self.facts(*again, "-o", page)
        first, second, third = facts["partials"]
        self.assertEqual((first["carried_over"], third["carried_over"]), (None, None))
        moved = 1200 * math.log2(cut[1] / lines[1])
        self.assertEqual(second["carried_over"]["tap"], 1)
        self.assertAlmostEqual(second["carried_over"]["moved"], moved, delta=0.5)
        self.assertGreater(second["carried_over"]["uncertainty"], 1.0)
        self.assertLess(second["carried_over"]["uncertainty"], 0.2 * abs(moved) + 1)
        self.assertAlmostEqual(second["measured"], cut[1], delta=1e-3 * cut[1])
        self.assertIsNotNone(facts["tap_at"])
        text = self.bench(*TARGET, *again).stdout
        self.assertIn("the last tap has no line of mode 2: the line is that of tap 1, moved by -", text)
        self.assertIn("The last tap has no line of mode 2. The line is that of tap 1", in_browser("bench.mjs", page)["carried"])

    def test_a_recording_of_a_tap_tells_the_shift_of_a_stiffer_bar(self):
        stiffer = 1.02  # times Young's modulus: all modes rise by the same
        mapped = program.idiophone("map", BAR, *COARSE, "--set", f"materials.aluminium.young={stiffer * 7e10}",
                                   "--set", "listeners.ear.position=[0.15, 0, 0.3]", "--modes", 8, "--no-estimate",
                                   "--output-folder", self.output)
        self.require_status(mapped, program.FINISHED)
        score, tap = self.output / "tap.yaml", self.output / "tap.wav"
        score.write_text("duration: 3\nevents:\n"
                         "  - {time: 0.05, at: [0.16, 0, 0], direction: [0, 0, -1], mass: 0.01, hardness: 1e8, speed: 1}\n")
        played = program.idiophone("play", self.output / "untuned_vibraphone_bar_bar.map.h5", "--score", score, "--output", tap,
                                   "--rate", 44100)
        self.require_status(played, program.FINISHED)
        for partial in self.facts("--mass", "lumped", "--measured", tap, "--tapped-at=0.16,0,0")["partials"]:
            self.assertAlmostEqual(partial["shift"], 600 * math.log2(stiffer), delta=0.1)

    def test_taps_tell_how_deep_cuts_are(self):
        asked, error = 0.0006, 0.0001
        cuts = self.output / "cuts.yaml"
        wood = ("--set", "materials.aluminium.young=7.2e10")

        def true_lines(text):
            cuts.write_text(text)
            return [partial["computed"] for partial in self.facts(*wood, "--cuts", cuts)["partials"]]

        cut = 'cuts: [{{tool: "router:0.01", place: 0.0, depth: {}}}]'
        before, after = true_lines("cuts: []"), true_lines(cut.format(asked + error))
        cuts.write_text(cut.format(asked) + f"\ntaps: [{{cuts: 0, lines: {before}, uncertainties: [0.3, 0.3, 0.3], at: [0.17, 0, 0]}}]")
        tap = self.output / "tap.yaml"
        tap.write_text(json.dumps({"uncertainty": 0.3, "lines": after}))
        learned = self.facts("--cuts", cuts, "--measured", tap, AT_THE_END, "--slope-error", "0.02")["learned"]
        depth, = learned["depths"]
        self.assertLess(depth["deviation"], 4e-5)
        self.assertAlmostEqual(depth["change"], error, delta=2 * depth["deviation"])
        self.assertGreater(depth["change"], 0.6 * error)

    def test_cuts_that_were_made_are_part_of_the_body(self):
        first = self.facts()
        made = self.output / "cuts.yaml"
        made.write_text(first["cuts_file"])
        then = self.facts("--cuts", made)
        for before, after in zip(first["partials"][1:], then["partials"][1:], strict=True):
            self.assertAlmostEqual(after["missing"], -before["expected"], delta=0.05)  # depths of the file are rounded
        if len(first["visits"]) > 1:
            for now, foreseen in zip(then["partials"], first["visits"][1]["expected"], strict=True):
                self.assertAlmostEqual(now["expected"], foreseen, delta=0.2)
        made.write_text('cuts: [{tool: "saw:0.1", place: 0, depth: -1}]')
        stderr = self.bench(*TARGET, "--cuts", made, status=program.WRONG_DECK).stderr
        self.assertIn("cuts.yaml:1:15", stderr)
        self.assertIn("'saw:0.1' is not a tool", stderr)
        self.assertIn("cuts.yaml:1:43", stderr)
        made.write_text('cuts: [{tool: "sander:0.02", place: 0, depth: 0.004}]')
        self.assertIn("more than half of the body's", self.bench(*TARGET, "--cuts", made, status=program.FAILED).stderr)
        for text, message in (('cuts: [{tool: "sander:0.02", place: 13.5, depth: 0.0004}]',
                               "cuts.yaml:1:37: cuts.0.place: the middle of the cut is not on the body, which lies from -0.18 to 0.18 m"),
                              ('cuts: [{tool: "router:1e-9", place: 0, depth: 0.0004}]',
                               "cuts.yaml:1:15: cuts.0.tool: the cut is narrower than the plan resolves on this body: the radius of its "
                               "tool must be at least 0.0012 m"),
                              ("cuts: []\ntaps: [{cuts: 1, lines: [200], uncertainties: [1]}]", "there are 0 cuts"),
                              ("cuts: []\ntaps: [{cuts: 0, lines: [200, 300], uncertainties: [1]}]", "has 1 numbers for 2 lines"),
                              ("cuts: []\ntaps: [{cuts: 0, lines: [], uncertainties: []}]", "a tap has at least one frequency")):
            made.write_text(text)
            self.assertIn(message, self.bench(*TARGET, "--cuts", made, status=program.WRONG_DECK).stderr)
        made.write_text('cuts: [{tool: "sander:0.02", place: 0, depth: 0.0004}]\ntaps: [{cuts: 0, lines: [200], uncertainties: [1]}]')
        self.assertIn("none after its last cut: give one by --measured", self.bench(*TARGET, "--cuts", made, status=program.FAILED).stderr)
        made.write_text('side: +z\ncuts: []')
        self.assertIn("cuts.yaml:1:7: side: these cuts were made at the side +z, but -z is to be cut: give --side +z",
                      self.bench(*TARGET, "--cuts", made, status=program.WRONG_DECK).stderr)

    def test_a_groove_does_what_a_new_mesh_with_it_does(self):
        loader = importlib.machinery.SourceFileLoader("tuning_workshop", str(program.SOURCE / "tools/tuning_workshop"))
        workshop = importlib.util.module_from_spec(importlib.util.spec_from_loader("tuning_workshop", loader))
        loader.exec_module(workshop)
        made, uncut_deck = self.output / "cuts.yaml", workshop.deck(self.output, "uncut", workshop.WOOD, [], 0.0)

        def lowest(deck):
            job = program.idiophone("modes", deck, "--modes", 1, "--mass", "consistent", "--no-estimate", "--output-folder", self.output,
                                    "--json")
            self.require_status(job, program.FINISHED)
            return json.loads(job.stdout)["modes"][0]["frequency"]

        uncut = lowest(uncut_deck)
        # An edge of elements lies at 0, and 5 mm is the middle of one: a groove does the same at both.
        for radius, place, depth, delta in ((0.006, 0.02, 5e-4, 0.04), (0.003, 0.0, 3e-4, 0.1), (0.003, 0.005, 3e-4, 0.1)):
            with self.subTest(radius=radius, place=place):
                groove = {"tool": "router", "place": place, "width": 2 * radius, "depth": depth}
                made.write_text(f'cuts: [{{tool: "router:{radius}", place: {place}, depth: {depth}}}]')
                meshed = lowest(workshop.deck(self.output, "cut", workshop.WOOD, [groove], 0.0))
                job = program.idiophone("bench", uncut_deck, "--target", uncut, "--mode-numbers", 1, "--cuts", made, "--tolerance", 100,
                                        "--json")
                self.require_status(job, program.FINISHED)
                moved = json.loads(job.stdout)["partials"][0]["computed"]
                self.assertAlmostEqual(math.log(moved / uncut) / math.log(meshed / uncut), 1, delta=delta)

    def test_drawings_have_the_places_of_the_mesh_and_the_profiles_of_the_cuts(self):
        drawing, made, mesh = (self.output / name for name in ("bar.dxf", "cuts.yaml", "bar.h5"))
        made.write_text('cuts: [{tool: "router:0.01", place: 0.02, depth: 0.0006}, {tool: "sander:0.02", place: -0.05, depth: 0.001}]')
        facts = self.facts("--cuts", made, "--dxf", drawing)
        written = program.idiophone("mesh", BAR, *COARSE, "-o", mesh)
        self.require_status(written, program.FINISHED)
        with h5py.File(mesh) as file:
            nodes, triangles = numpy.array(file["nodes"]) * 1e3, numpy.array(file["surface"])  # mm
        corners = nodes[triangles]
        normals = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        underside = nodes[numpy.unique(triangles[normals[:, 2] < -0.5 * numpy.linalg.norm(normals, axis=1)])]
        lines = {line.dxf.layer: numpy.array([tuple(vertex.dxf.location)[:2] for vertex in line.vertices])
                 for line in ezdxf.readfile(drawing).modelspace().query("POLYLINE") if line.is_closed}
        self.assertEqual(set(lines), {"BODY", "NEXT"})

        def depth(cuts, x):
            return sum(1e3 * cut["depth"] * (1 if cut["tool"] == "router" else math.cos(math.pi * share / 2) ** 2)
                       for cut in cuts for share in [abs(x - 1e3 * cut["place"]) / (500 * cut["width"])] if share < 1)

        def area(line):
            x, y = line.T
            return abs(numpy.dot(x, numpy.roll(y, -1)) - numpy.dot(y, numpy.roll(x, -1))) / 2

        earlier = [{"tool": "router", "place": 0.02, "width": 0.02, "depth": 0.0006},
                   {"tool": "sander", "place": -0.05, "width": 0.04, "depth": 0.001}]
        for layer, cuts in (("BODY", earlier), ("NEXT", earlier + facts["cuts"])):
            line = lines[layer]
            top = numpy.isclose(line[:, 1], nodes[:, 2].max(), atol=1e-5)
            below = line[~top]
            for x, _, bottom in underside:
                if min(abs(abs(x - 1e3 * cut["place"]) - 500 * cut["width"]) for cut in cuts) > 1e-3:  # not at an edge
                    drawn = numpy.interp(x, below[:, 0], below[:, 1])
                    self.assertAlmostEqual(drawn, bottom + depth(cuts, x), delta=2e-3, msg=f"{layer} at {x} mm")
        removed = sum(1e6 * cut["depth"] * cut["width"] * (1 if cut["tool"] == "router" else 0.5) for cut in facts["cuts"])
        self.assertAlmostEqual(area(lines["BODY"]) - area(lines["NEXT"]), removed, delta=0.002 * removed)

    def test_says_what_is_in_tune_or_out_of_reach(self):
        first, second, third = (partial["computed"] for partial in self.facts()["partials"])
        self.assertIn("all partials are within the tolerance",
                      self.bench("--target", f"{first},{second},{third}", "--mode-numbers", "1,2,5").stdout)
        higher = self.bench("--target", f"{2 * first},{second / 1.5},{third}", "--mode-numbers", "1,2,5",
                            status=program.FAILED).stdout
        self.assertIn("no removal at the side -z reaches the targets", higher)

    def test_wrong_options(self):
        for arguments, message in ((("--tools", "saw:0.01"), "'saw:0.01' is not a tool"),
                                   (("--tools", "router:1e-9"), "router:1e-09 does not suit this body, which is 0.36 m long"),
                                   (("--tools", "sander:0.19"), "its radius must be between 0.0012 and 0.18 m"),
                                   (("--side", "below"), "'below' is not a side"),
                                   (("--depth-error", "0"), "--depth-error must be above 0"),
                                   (("--measured", BAR, "--tapped-at=nan,0,0"), "--tapped-at must be three finite numbers"),
                                   (("--mode-numbers", "1,2"), "--target has 3 values, but --mode-numbers 2")):
            with self.subTest(arguments=arguments):
                self.assertIn(message, self.bench("--target", "1:4:10", *arguments, status=program.FAILED).stderr)


if __name__ == "__main__":
    unittest.main()
