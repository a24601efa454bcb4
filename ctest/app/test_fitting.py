#!/usr/bin/python3
"""`idiophone identify` and `idiophone tune`: their answers, the decks they write, and answers to wrong options."""
import itertools
import json
import math
import re
import unittest

import program

TUNING = program.SOURCE / "inputs/tuning"
SEMITONES = {"F#3": -15, "C4": -9, "D4": -7, "E4": -5, "F4": -4, "G4": -2, "A4": 0, "B4": 2, "C5": 3}
NOTES = {note: 440 * 2 ** (semitones / 12) for note, semitones in SEMITONES.items()}  # Hz


class Identify(program.TestCase):
    def identify(self, *arguments, measured):
        (self.output / "measured.yaml").write_text(measured)
        return program.idiophone("identify", program.deck("free"), "--measured", self.output / "measured.yaml", *arguments)

    def frequencies(self, *overrides):
        job = program.idiophone("modes", program.deck("free"), "--output-folder", self.output, "--mass", "consistent", "--modes",
                                "20", "--json", *overrides)
        self.require_status(job, program.FINISHED)
        return [mode["frequency"] for mode in json.loads(job.stdout)["modes"]]

    def test_finds_the_constants_that_the_program_used(self):
        material = re.search(r"^  (\w+): .*young", program.deck("free").read_text(), re.MULTILINE)[1]
        truth = f"materials.{material}"
        lines = self.frequencies("--set", f"{truth}.young=6.2e6", "--set", f"{truth}.poisson=0.36")
        job = self.identify("--json", measured=json.dumps({"lines": lines}))
        self.require_status(job, program.FINISHED)
        found = json.loads(job.stdout)
        self.assertAlmostEqual(found["constants"]["young"]["value"] / 6.2e6, 1, delta=1e-5)
        self.assertAlmostEqual(found["constants"]["poisson"]["value"], 0.36, delta=1e-5)
        self.assertLess(found["fitted_rms"], 0.01)
        self.assertLess(found["chi_squared"], 1e-3)
        self.assertEqual(found["degrees_of_freedom"], len(lines) - 2)
        self.assertTrue(found["accepted"])
        self.assertIn(f"moduli are those for the deck's density of {found['density']:.4g} kg/m3", job.stderr)
        mass = found["density"] * found["volume"]
        self.assertIn(f"the body weighs {mass:.4g} kg", job.stderr)
        job = self.identify(measured=json.dumps({"lines": lines, "mass": mass}))
        self.assertNotIn("the mass was not measured", job.stderr + job.stdout)
        text = job.stdout
        self.assertIn(f"materials:\n  {material}:\n    young: 6.2e+06\n", text)
        self.assertIn("rms of the fitted lines: 0.00 cents", text)

    def crystal(self, name, constants, euler):
        """The deck of a block of a cubic crystal whose axes are turned by these angles."""
        deck = self.output / f"{name}.yaml"
        deck.write_text(json.dumps({
            "name": name, "time": {"duration": 0.01},
            "materials": {"silicon": {"density": 2330, "stiffness": {"symmetry": "cubic", **constants}}},
            "bodies": {"block": {"mesh": str(program.SOURCE / "meshes/bar.geo"), "element": "hex",
                                 "order": {"plane": 4, "thickness": 4}, "material": "silicon", "grain": {"euler": euler},
                                 "parameters": {"length": 0.03, "width": 0.025, "thickness": 0.02, "size": 0.03}}},
            "listeners": {"ear": {"type": "mono", "position": [0.1, 0, 0]}}}))
        return deck

    def lines_of(self, deck):
        job = program.idiophone("modes", deck, "--output-folder", self.output, "--mass", "consistent", "--modes", "15", "--no-estimate",
                                "--json")
        self.require_status(job, program.FINISHED)
        return [mode["frequency"] for mode in json.loads(job.stdout)["modes"]]

    def test_finds_how_the_axes_of_a_crystal_are_turned(self):
        truth = {"c11": 165.7e9, "c12": 63.9e9, "c44": 79.6e9}
        measured = self.output / "measured.yaml"
        measured.write_text(json.dumps({"lines": self.lines_of(self.crystal("turned", truth, [20, 0, 0]))}))
        guess = self.crystal("guess", {"c11": 155e9, "c12": 67e9, "c44": 74e9}, [0, 0, 0])
        words = ["identify", guess, "--measured", measured, "--fit", "constants,turn_z"]
        job = program.idiophone(*words, "--json")
        self.require_status(job, program.FINISHED)
        found = json.loads(job.stdout)
        turn = found["constants"].pop("turn_z")
        self.assertAlmostEqual(abs(turn["value"]), 20, delta=0.01)
        self.assertLess(turn["half_width"], 3)
        for name, constant in found["constants"].items():
            self.assertAlmostEqual(constant["value"] / truth[name], 1, delta=1e-3)
        self.assertAlmostEqual(found["grain"]["euler"][0], turn["value"], delta=1e-6)
        self.assertAlmostEqual(found["equivalent_turns"][0][2], -turn["value"], delta=1e-6)
        answered = self.crystal("answered", {name: constant["value"] for name, constant in found["constants"].items()},
                                found["grain"]["euler"])
        for line, again in zip(json.loads(measured.read_text())["lines"], self.lines_of(answered)):
            self.assertAlmostEqual(again / line, 1, delta=1e-5)
        text = program.idiophone(*words).stdout
        self.assertRegex(text, r"bodies:\n  block:\n    grain: \{euler: \[-?20\.0\d+, 0.0000, 0.0000\]\}|euler: \[-?19\.99")

    def test_what_is_expected_of_turns_needs_turns(self):
        deck = self.crystal("untouched", {"c11": 165.7e9, "c12": 63.9e9, "c44": 79.6e9}, [0, 0, 0])
        job = program.idiophone("identify", deck, "--measured", "any.yaml", "--turn-deviation", "5")
        self.require_status(job, program.FAILED)
        self.assertIn("--fit constants,turns", job.stderr)

    def require_refusal(self, lines, doubt):
        """That the fit is not accepted, and says why, in text and as JSON."""
        job = self.identify(measured=json.dumps({"lines": lines}))
        self.require_status(job, program.FAILED)
        self.assertIn("the fit is not accepted", job.stdout + job.stderr)
        job = self.identify("--json", measured=json.dumps({"lines": lines}))
        self.require_status(job, program.FAILED)
        found = json.loads(job.stdout)
        self.assertFalse(found["accepted"])
        self.assertIn(doubt, found["doubts"][0])

    def test_a_fit_with_false_lines_or_above_the_uncertainties_is_not_accepted(self):
        lines = self.frequencies()
        middle = [math.sqrt(lower * upper) for lower, upper in itertools.pairwise(lines) if upper / lower > 1.07]
        self.require_refusal(lines + middle[:2], f"2 of {len(lines) + 2} lines are no mode of the body within 50 cents")
        moved = [line * 2 ** ((30 if number % 2 else -30) / 1200) for number, line in enumerate(lines)]
        self.require_refusal(moved, "cents away from their modes")

    def test_wrong_options_and_files(self):
        lines = '{"lines": [1000]}'
        for arguments, measured, status, message in (
                (["--tolerance", "0"], lines, program.FAILED, "--tolerance must be above 0 cents"),
                (["--fit", "yuong"], lines, program.FAILED, "did you mean 'young'"),
                (["--fit", "turns"], lines, program.FAILED, "rubber is the same in all directions"),
                (["--body", "bell"], lines, program.FAILED, "there is no body 'bell'"),
                ([], "lines: [1000, high]", program.WRONG_DECK, "measured.yaml:1:15: lines.1: expected a number")):
            with self.subTest(arguments=arguments):
                job = self.identify(*arguments, measured=measured)
                self.require_status(job, status)
                self.assertIn(message, job.stderr)
        job = program.idiophone("identify", program.deck("free"), "--measured", program.deck("free").with_suffix(".wav"))
        self.require_status(job, program.FAILED)
        self.assertIn("can't read the sound file", job.stderr)


class Tune(program.TestCase):
    def tune(self, *arguments, deck="tuning_fork"):
        return program.idiophone("tune", TUNING / f"{deck}.yaml", *arguments)

    def require_yield(self, found, length):
        """Requires the share of forks within 1.5 cents that the sensitivity gives, where lengths differ by 0.05 %."""
        in_tune = found["in_tune"]
        self.assertAlmostEqual(in_tune["scatter"][length]["mean"], found["values"][length], delta=1e-9)
        deviation = abs(found["modes"][0]["sensitivities"][length]) * 0.0005 * found["values"][length]  # cents
        self.assertAlmostEqual(in_tune["modes"][0]["deviation"], deviation, delta=0.1)
        self.assertAlmostEqual(in_tune["share"], math.erf(1.5 / deviation / math.sqrt(2)), delta=0.04)

    def test_a_tuning_fork_and_the_deck_that_it_writes(self):
        tuned = self.output / "tuned.yaml"
        job = self.tune("--target", "A4", "--vary", "bodies.fork.parameters.length=0.05:0.11", "--mode-numbers", "2", "-o", tuned,
                        "--scatter", "bodies.fork.parameters.length=0.05%", "--within", "1.5", "--json")
        self.require_status(job, program.FINISHED)
        found = json.loads(job.stdout)
        self.require_yield(found, "bodies.fork.parameters.length")
        self.assertAlmostEqual(found["modes"][0]["frequency"], 440, delta=0.5)
        before, after = (path.read_text() for path in (TUNING / "tuning_fork.yaml", tuned))
        self.assertEqual(re.sub(r"length: [\d.]+", "", after), re.sub(r"length: [\d.]+", "", before))
        self.assertAlmostEqual(float(re.search(r"length: ([\d.]+)", after)[1]),
                               found["values"]["bodies.fork.parameters.length"], delta=1e-8)
        after = after.replace("../..", str(program.SOURCE))
        tuned.write_text(after)
        modes = program.idiophone("modes", tuned, "--output-folder", self.output, "--modes", "3", "--json")
        self.require_status(modes, program.FINISHED)
        mode = json.loads(modes.stdout)["modes"][1]
        self.assertAlmostEqual(mode["frequency"], 440, delta=0.5)
        self.assertAlmostEqual(mode["mesh_error"], found["modes"][0]["mesh_error"], delta=0.05)

    def test_decay_times_and_bands_without_modes(self):
        deck = (TUNING / "tuned_tuning_fork.yaml").read_text()
        mass, stiffness = (float(re.search(rf"{name}: ([\d.e-]+)", deck)[1]) for name in ("mass", "stiffness"))
        wanted = 2 * math.log(1000) / (mass + stiffness * (2 * math.pi * 440) ** 2)
        job = self.tune("--target", "A4", "--mode-numbers", "2", "--vary", "bodies.fork.parameters.length=0.05:0.11",
                        "--tolerance", "50", "--decay-time", f"2={wanted}", "--avoid", "500:600", "--json", deck="tuned_tuning_fork")
        self.require_status(job, program.FINISHED)
        found = json.loads(job.stdout)
        (decay,) = found["decays"]
        self.assertAlmostEqual(decay["decay_time"] / wanted, 1, delta=1e-3)
        self.assertEqual(found["avoided"], [{"lower": 500, "upper": 600, "modes": [], "frequencies": []}])

    def level_of_play(self, deck, blow):
        """A-weighted sound exposure level of the map's sound of a blow, dB re 20 uPa."""
        self.require_status(program.idiophone("map", deck, "--output-folder", self.output, "--up-to", "3000"), program.FINISHED)
        score = self.output / "score.yaml"
        score.write_text(json.dumps({"duration": 0.5, "listener": {"type": "mono", "position": [0.1, 0, 3]},
                                     "events": [{"time": 0, "type": "force", "body": "bar", **blow}]}))
        sound = self.output / "blow.wav"
        job = program.idiophone("play", self.output / "struck_bar_bar.map.h5", "--score", score, "--output", sound)
        self.require_status(job, program.FINISHED)
        full_scale = float(re.search(r"full scale is ([\d.e-]+) Pa", job.stdout + job.stderr)[1])
        analysed = program.idiophone("analyze", sound, "--json")
        level = json.loads(analysed.stdout)["channels"][0]["levels"]["exposure"]
        return level + 20 * math.log10(full_scale / 20e-6)

    @program.long_verification
    def test_the_level_at_a_listener(self):
        blow = {"at": [0.02, 0, 0.004], "force": [0, 0, -20], "shape": "half_sine", "duration": 2e-4}
        deck = self.output / "struck_bar.yaml"
        deck.write_text(json.dumps({
            "name": "struck_bar", "time": {"duration": 0.5},
            "materials": {"aluminium": {"young": 7e10, "poisson": 0.33, "density": 2700, "damping": {"mass": 20}}},
            "bodies": {"bar": {"mesh": str(program.SOURCE / "meshes/bar.geo"), "element": "hex", "order": {"plane": 3, "thickness": 3},
                               "material": "aluminium", "parameters": {"length": 0.2, "width": 0.03, "thickness": 0.008, "size": 0.1}}},
            "loads": {"tap": {"body": "bar", "balanced": True, **blow}},
            "listeners": {"ear": {"type": "mono", "position": [0.1, 0, 3]}},
            "audio": {"rate": 44100, "max_frequency": 3000}, "radiation": {"model": "kirchhoff"}}))
        tuned = self.output / "tuned.yaml"
        vary = ["--vary", "bodies.bar.parameters.thickness=0.004:0.012", "--vary", "bodies.bar.parameters.length=0.13:0.25"]
        wish = ["--target", "1000", "--mode-numbers", "1", "--level-tolerance", "0.2"]
        job = program.idiophone("tune", deck, *wish, *vary, "--level", "ear=18.5", "-o", tuned, "--json")
        self.require_status(job, program.FINISHED)
        (level,) = json.loads(job.stdout)["levels"]
        self.assertTrue(level["reached"])
        self.assertAlmostEqual(level["level"], 18.5, delta=0.2)
        self.assertAlmostEqual(self.level_of_play(tuned, blow), level["level"], delta=0.5)
        job = program.idiophone("tune", deck, *wish, "--vary", "bodies.bar.parameters.length=0.19:0.21", "--level",
                                "ear=at_least:90")
        self.require_status(job, program.FAILED)
        self.assertRegex(job.stdout + job.stderr, r"the blows have [\d.]+ dB at ear instead of at least 90 dB")

    def partials(self, deck, *settings):
        """Frequencies in the run of a deck."""
        arguments = [word for setting in settings for word in ("--set", setting)]
        self.require_status(program.idiophone("run", deck, "--output-folder", self.output, *arguments, ranks=1), program.FINISHED)
        result = next(self.output.glob("*.h5"))
        job = program.idiophone("analyze", result, "--range", "60", "--json")
        result.unlink()
        self.require_status(job, program.FINISHED)
        return [partial["frequency"] for partial in json.loads(job.stdout)["channels"][0]["partials"]]

    def require_partials(self, found, wanted, cents):
        for frequency in wanted:
            distances = [abs(1200 * math.log2(partial / frequency)) for partial in found]
            self.assertLess(min(distances), cents, f"no partial at {frequency:.2f} Hz")

    def test_runs_of_tuned_bodies_have_the_wanted_partials(self):
        decks = (("tuned_vibraphone_bar", "F#3", (1, 4, 10)), ("tuned_xylophone_bar", "F4", (1, 3, 6)),
                 ("tuned_tuning_fork", "A4", (1,)))
        for deck, pitch, ratios in decks if program.LONG else decks[:1]:
            with self.subTest(deck=deck):
                found = self.partials(TUNING / f"{deck}.yaml", "time.duration=0.2")
                self.require_partials(found, [NOTES[pitch] * ratio for ratio in ratios], cents=3)

    @program.long_verification
    def test_the_octave_plays_a_scale(self):
        scale = ("C4", "D4", "E4", "F4", "G4", "A4", "B4", "C5")
        together = [f"loads.{note.lower()}.start=0" for note in scale]
        found = self.partials(TUNING / "octave.yaml", "time.duration=0.25", *together)
        self.require_partials(found, [NOTES[note] for note in scale], cents=3)

    @program.long_verification
    def test_a_number_that_sits_on_a_bound_is_named(self):
        length = "bodies.fork.parameters.length"
        arguments = ["--target", "A6", "--vary", f"{length}=0.085:0.095", "--mode-numbers", "2"]
        job = self.tune(*arguments)
        self.require_status(job, program.FAILED)
        self.assertIn("not all modes are within 2 cents", job.stdout + job.stderr)
        self.assertIn("0.085  on its lower bound", job.stdout)
        self.assertIn(f"On a bound: {length} (lower bound)", job.stdout + job.stderr)
        self.assertEqual(json.loads(self.tune(*arguments, "--json").stdout)["bounds"], {length: "lower"})

    def test_stopped_by_a_signal_it_saves_the_best_values(self):
        tuned = self.output / "tuned.yaml"
        status, said = program.stopped_when_it_says(
            "2 of about", "tune", TUNING / "tuning_fork.yaml", "--target", "A4", "--tolerance", "1e-12",
            "--vary", "bodies.fork.parameters.length=0.05:0.11", "--mode-numbers", "2", "-o", tuned)
        self.assertEqual(status, program.RESUMABLE, said)
        self.assertIn("left  best so far", said)
        self.assertIn("the values are the best ones so far", said)
        self.assertIn("length", tuned.read_text())

    def test_wrong_options(self):
        length = "bodies.fork.parameters.length"
        one = ["--target", "A4", "--vary", f"{length}=0.07:0.11"]
        for arguments, message in (
                (["--target", "H4", "--vary", f"{length}=0.07:0.11"], "neither a frequency above 0 Hz nor a note"),
                (["--target", "A4", "--vary", length], "expected KEY=LOWEST:HIGHEST"),
                (["--target", "A4", "--vary", f"{length}=0.11:0.07"], "the lowest value must be below the highest"),
                (["--target", "A4", "--vary", f"{length}=0.07:x"], "'x' is not a number"),
                (["--target", "A4", "--vary", f"{length}=0.01:0.02"], "the deck's value, 0.09, is not within"),
                (["--target", "A4", "--vary", "bodies.fork.parameters.width=0.01:0.02"], "has no key bodies.fork"),
                (["--target", "A4,A5", "--vary", f"{length}=0.07:0.11", "--mode-numbers", "1"], "--target has 2 values"),
                (["--target", "1:2", "--pitch", "0", "--vary", f"{length}=0.07:0.11"], "neither a frequency"),
                (["--target", "A4", "--vary", f"{length}=0.07:0.11", "--tolerance", "-1"], "--tolerance must be above 0"),
                ([*one, "--scatter", length], "expected KEY=DEVIATION"),
                ([*one, "--scatter", f"{length}=0"], "the standard deviation must be above 0"),
                ([*one, "--scatter", f"{length}=2%", "--scatter", f"{length}=0.001"], "this key is given twice"),
                ([*one, "--scatter", "bodies.fork.parameters.width=1%"], "has no key bodies.fork.parameters.width"),
                ([*one, "--within", "0"], "--within must be above 0 cents"),
                ([*one, "--decay-time", "2"], "--decay-time 2: expected MODE=SECONDS"),
                ([*one, "--decay-time", "2=1", "--decay-time", "2=3"], "this mode is given twice"),
                ([*one, "--decay-tolerance", "0"], "--decay-tolerance must be above 0 percent"),
                ([*one, "--level", "ear"], "--level ear: expected LISTENER=DB"),
                ([*one, "--level", "nose=60"], "no listener is called 'nose'"),
                ([*one, "--level-tolerance", "0"], "--level-tolerance must be above 0 dB"),
                ([*one, "--avoid", "500:400"], "--avoid 500:400: the lowest frequency must be below the highest"),
                ([*one, "--avoid", "A4"], "--avoid A4: expected LOWEST:HIGHEST"),
                ([*one, "--avoid", "A4~50"], "440 Hz is wanted, but 427.474 to 452.893 Hz is to be avoided")):
            with self.subTest(arguments=arguments):
                job = self.tune(*arguments)
                self.require_status(job, program.FAILED)
                self.assertIn(message, job.stderr)


if __name__ == "__main__":
    unittest.main()
