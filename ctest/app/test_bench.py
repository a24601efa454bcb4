#!/usr/bin/python3
"""`idiophone bench`: its partials and cuts, its page, and answers to wrong options."""
import json
import math
import unittest

import program
from web import in_browser

BAR = program.SOURCE / "inputs/tuning/vibraphone_bar.yaml"
COARSE = ("--set", "bodies.bar.order={plane: 4, thickness: 2}")
TARGET = ("--target", "1:4:10", "--mode-numbers", "1,2,5")


class Bench(program.TestCase):
    def bench(self, *arguments, status=program.FINISHED):
        job = program.idiophone("bench", BAR, *COARSE, *arguments)
        self.require_status(job, status)
        return job

    def facts(self, *arguments):
        return json.loads(self.bench(*TARGET, "--json", *arguments).stdout)

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

    def computed(self, *arguments):
        modes = program.idiophone("modes", BAR, *COARSE, *arguments, "--mass", "consistent", "--modes", "6", "--output-folder",
                                  self.output, "--json")
        self.require_status(modes, program.FINISHED)
        return [mode["frequency"] for mode in json.loads(modes.stdout)["modes"]]

    def test_warns_where_a_line_may_be_that_of_another_mode(self):
        square = "--set", "bodies.bar.parameters={width: 0.013, centre: 0.0129, size: 0.05}"
        job = self.bench(*square, "--target", "1:2.7", "--mode-numbers", "1,3", *self.measured(self.computed(*square)))
        self.assertIn("cents from mode 1, so the line at", job.stdout)
        job = self.bench(*TARGET, *self.measured(self.computed()))
        self.assertNotIn("another mode is computed", job.stdout)

    def test_measured_partials_are_matched_and_keep_their_shifts(self):
        computed = self.computed()
        facts = self.facts(*self.measured([frequency * 2 ** ((150 + 5 * number) / 1200)
                                           for number, frequency in enumerate(computed)]))
        for partial, number in zip(facts["partials"], (0, 1, 4), strict=True):
            self.assertAlmostEqual(partial["shift"], 150 + 5 * number, places=3)
        job = self.bench(*TARGET, *self.measured(computed[1:]), status=program.FAILED)
        self.assertIn("mode 1, computed at", job.stderr)
        self.assertIn("was not measured", job.stderr)

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
        for partial in self.facts("--mass", "lumped", "--measured", tap)["partials"]:
            self.assertAlmostEqual(partial["shift"], 600 * math.log2(stiffer), delta=0.1)

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
        made.write_text('cuts: [{tool: "sander:0.02", place: 13.5, depth: 0.0004}]')
        self.assertIn("cuts.yaml: the middle of cut 1 is at 13.5 m, but the body lies from -0.18 to 0.18 m",
                      self.bench(*TARGET, "--cuts", made, status=program.FAILED).stderr)
        made.write_text('side: +z\ncuts: []')
        self.assertIn("cuts.yaml:1:7: side: these cuts were made at the side +z, but -z is to be cut: give --side +z",
                      self.bench(*TARGET, "--cuts", made, status=program.WRONG_DECK).stderr)

    def test_says_what_is_in_tune_or_out_of_reach(self):
        first, second, third = (partial["computed"] for partial in self.facts()["partials"])
        self.assertIn("all partials are within the tolerance",
                      self.bench("--target", f"{first},{second},{third}", "--mode-numbers", "1,2,5").stdout)
        higher = self.bench("--target", f"{2 * first},{second / 1.5},{third}", "--mode-numbers", "1,2,5").stdout
        self.assertIn("no removal at the side -z reaches the targets", higher)

    def test_wrong_options(self):
        for arguments, message in ((("--tools", "saw:0.01"), "'saw:0.01' is not a tool"), (("--side", "below"), "'below' is not a side"),
                                   (("--depth-error", "0"), "--depth-error must be above 0"),
                                   (("--mode-numbers", "1,2"), "--target has 3 values, but --mode-numbers 2")):
            with self.subTest(arguments=arguments):
                self.assertIn(message, self.bench("--target", "1:4:10", *arguments, status=program.FAILED).stderr)


if __name__ == "__main__":
    unittest.main()
