#!/usr/bin/python3
"""`idiophone proxies`: scores, contacts of a result, levels of detail, and wrong input."""
import csv
import itertools
import json
import re
import shutil
import signal
import socket
import subprocess
import time
import unittest

import numpy
import test_play
from scipy.io import wavfile

import jack_server
import program

SCORE = """
duration: 0.2
events:
  - {time: 0.01, at: [0.02, 0.01, 0.01], direction: [0, 0, -1], mass: 0.01, hardness: 1e7, speed: 1}
  - {type: scrape, time: 0.1, from: [-0.02, 0, 0.01], to: [0.02, 0, 0.01], direction: [0, 0, -1], speed: 0.8, load: 1,
     mass: 0.01, hardness: 1e8, friction: 0.2, roughness: {height: 1e-6}}
"""
LATE = ["--set", "materials.rubber.damping.stiffness=1e-5", "--set", "materials.rubber.damping.mass=100"]


def block_edges():
    """The two ends of each spring of that block, [springs][6] in cells of 10 mm."""
    edges = set()
    for cell in itertools.product(range(6), range(4), range(2)):
        for axes in itertools.permutations(range(3)):
            corner, corners = list(cell), [cell]
            for axis in axes:
                corner[axis] += 1
                corners.append(tuple(corner))
            edges.update(itertools.combinations(corners, 2))
    return [start + end for start, end in sorted(edges)]


def block_mesh(views):
    """The text of a .msh file of a block of 60 x 40 x 20 mm, each cell of which is six tetrahedra.
    views: a list of name, kind (Node or Element) and a function of the number of tetrahedra or nodes"""
    cells = (6, 4, 2)
    number = {place: i + 1 for i, place in enumerate(itertools.product(*(range(n + 1) for n in cells)))}
    elements = []
    for cell in itertools.product(*(range(n) for n in cells)):
        for axes in itertools.permutations(range(3)):
            corner, corners = list(cell), [number[cell]]
            for axis in axes:
                corner[axis] += 1
                corners.append(number[tuple(corner)])
            if axes not in [(0, 1, 2), (1, 2, 0), (2, 0, 1)]:
                corners[2:] = reversed(corners[2:])
            elements.append("4 2 1 1 " + " ".join(map(str, corners)))
    sections = {"Nodes": [" ".join(map(str, (i, *(0.01 * x for x in place)))) for place, i in number.items()],
                "Elements": [f"{i + 1} {element}" for i, element in enumerate(elements)]}
    text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
    for name, lines in sections.items():
        text += "\n".join([f"${name}", str(len(lines)), *lines, f"$End{name}", ""])
    for name, kind, value in views:
        count = len(sections[f"{kind}s"])
        text += f'${kind}Data\n1\n"{name}"\n1\n0\n3\n0\n1\n{count}\n'
        text += "".join(f"{i + 1} {value(i)}\n" for i in range(count)) + f"$End{kind}Data\n"
    return text


class Rendered(program.TestCase):
    """Proxies, rendered to a file."""
    def proxies(self, *arguments, deck="simple", score=SCORE, status=program.FINISHED):
        driven = []
        if score:
            (self.output / "score.yaml").write_text(score)
            driven = ["--score", self.output / "score.yaml"]
        job = program.idiophone("proxies", program.deck(deck), *driven, "--output", self.output / "sound.wav", *arguments)
        self.require_status(job, status)
        return job.stdout + job.stderr

    def sound(self):
        rate, samples = wavfile.read(self.output / "sound.wav")
        return rate, samples.astype(float)

    @staticmethod
    def pitch(samples):
        """The lowest partial of 0.1 s at 8000 Hz, by its line in a spectrum of 2^14 samples; at least line 200."""
        spectrum = abs(numpy.fft.rfft(samples * numpy.hanning(800), 1 << 14))[200:]
        high = spectrum > 0.02 * spectrum.max()
        return next(i for i in range(1, len(spectrum)) if high[i] and spectrum[i - 1] < spectrum[i] > spectrum[i + 1]) + 200

    def box(self, more=""):
        """Settings that make the body a box of 60 x 40 x 20 mm with elements of 10 mm."""
        (self.output / "box.geo").write_text("SetFactory(\"OpenCASCADE\");\nDefineConstant[ size = 0.01 ];\n" + more +
                                             "Box(1) = {0, 0, 0, 0.06, 0.04, 0.02};\n"
                                             "MeshSize{ PointsOf{ Volume{1}; } } = size;\n")
        return ["--set", f"bodies.plate.mesh={self.output / 'box.geo'}", "--set", "bodies.plate.fixed=null",
                "--set", "bodies.plate.parameters={size: 0.01}"]

    def choices(self):
        with open(self.output / "choices.csv") as file:
            return list(csv.DictReader(file))


class Proxies(Rendered):
    def test_renders_a_score(self):
        self.proxies()
        rate, sound = self.sound()
        self.assertEqual((rate, len(sound)), (8000, 1600))
        self.assertEqual(numpy.abs(sound[:80]).max(), 0)       # silence before the blow
        self.assertGreater(numpy.abs(sound[80:400]).max(), 0)
        self.assertTrue(numpy.isfinite(sound).all())

    def test_chooses_levels_and_reports_them(self):
        told = self.proxies("--levels", 2, "--lowest-rate", 2, "--report", self.output / "choices.csv", *LATE)
        springs = [int(number) for number in re.findall(r"masses, (\d+) springs", told)]
        self.assertEqual(len(springs), 2)
        self.assertGreater(springs[0], 2 * springs[1])
        with open(self.output / "choices.csv") as file:
            choices = list(csv.DictReader(file))
        self.assertEqual((choices[0]["body"], choices[0]["choice"], choices[0]["level"]), ("plate", "begin", "0"))
        self.assertAlmostEqual(float(choices[0]["time"]), 0.01)
        cost = float(choices[0]["springs_per_second"])
        self.proxies("--levels", 2, "--budget", 0.5, "--speed", cost, "--report", self.output / "choices.csv", *LATE)
        with open(self.output / "choices.csv") as file:
            self.assertEqual(next(csv.DictReader(file))["level"], "1")
        self.assertIn("forces were left out", self.proxies("--budget", 1e-6))

    def test_reports_the_exact_rate_of_a_proxy(self):
        self.proxies("--lowest-rate", 8, "--budget", 0.2, "--speed", 1e9, "--set", "audio.rate=44100",
                     "--report", self.output / "choices.csv")
        with open(self.output / "choices.csv") as file:
            self.assertIn(float(next(csv.DictReader(file))["rate"]), [44100, 22050, 11025, 5512.5])

    def test_coarse_levels_are_good_or_left_out(self):
        told = self.proxies("--levels", 3, *self.box())
        self.assertEqual(re.findall(r"level (\d): \d+ masses", told), ["0", "1", "2"], told)
        told = self.proxies("--levels", 3, *self.box(more="If (size > 0.03)\n  Error(\"too coarse\"); Exit;\nEndIf\n"))
        self.assertEqual(re.findall(r"level (\d): \d+ masses", told), ["0", "1"], told)
        self.assertIn("body plate does without its mesh 2 of elements of 0.04 m", told)

    def test_views_of_the_mesh_give_springs_and_masses_their_own_values(self):
        blow = ("duration: 0.1\nevents:\n"
                "  - {time: 0, at: [0.06, 0.02, 0.02], direction: [0, 0, -1], mass: 0.01, hardness: 1e7, speed: 1}\n")
        file = self.output / "block.msh"
        block = ["--set", f"bodies.plate.mesh={file}", "--set", "bodies.plate.fixed=null",
                 "--set", "bodies.plate.parameters=null", "--set", "materials.rubber.damping={mass: 20, stiffness: 1e-6}"]

        def pitch(*views):
            file.write_text(block_mesh(views))
            self.proxies(*block, score=blow)
            return self.pitch(self.sound()[1])
        plain = pitch()
        self.assertAlmostEqual(pitch(("spring_stiffness", "Element", lambda i: 0.49)) / plain, 0.7, delta=0.01)
        self.assertNotAlmostEqual(pitch(("spring_stiffness", "Element", lambda i: 0.1 if i < 144 else 1)) / plain, 1, delta=0.02)
        heavier = pitch(("mass", "Node", lambda i: 8e-4))
        self.assertAlmostEqual(pitch(("mass", "Node", lambda i: 16e-4)) / heavier, 0.5 ** 0.5, delta=0.01)
        # Springs that are all shorter by a tenth: a smaller block of the same springs and masses has the same pitch.
        self.assertAlmostEqual(pitch(("spring_length", "Element", lambda i: 0.9)) / plain, 1, delta=0.01)
        self.assertGreater(pitch(("spring_length", "Element", lambda i: 0.7 if i < 144 else 1)) / plain, 1.01)
        file.write_text(block_mesh([("spring_damping", "Element", lambda i: 2.0), ("colour", "Node", lambda i: 1)]))
        self.assertRegex(self.proxies(*block, score=blow), r"block\.msh: its view 'colour' has no meaning")
        file.write_text(block_mesh([("spring_stiffness", "Element", lambda i: -1)]))
        self.assertRegex(self.proxies(*block, score=blow, status=program.WRONG_DECK), r"body 'plate': own stiffness")
        file.write_text(block_mesh([("mass", "Element", lambda i: 1)]))
        self.assertRegex(self.proxies(*block, score=blow, status=program.WRONG_DECK), r"'mass' of .* must be \$NodeData")

    def test_fitted_springs_have_the_pitch_of_finite_elements(self):
        blow = ("duration: 0.1\nevents:\n"
                "  - {time: 0, at: [0.195, 0, 0.0075], direction: [0, 0, -1], mass: 0.01, hardness: 1e7, speed: 1}\n")
        bar = ["--set", f"bodies.plate.mesh={program.SOURCE / 'meshes/bar.geo'}", "--set", "bodies.plate.fixed=null",
               "--set", "bodies.plate.parameters={length: 0.2, width: 0.03, thickness: 0.015, size: 0.015, layers: 1}",
               "--set", "materials.rubber.young=5e9"]
        job = program.idiophone("modes", program.deck("simple"), "--mass", "consistent", "--modes", 1, "--no-estimate", "--json",
                                "--output-folder", self.output, *bar)
        self.require_status(job, program.FINISHED)
        frequency = json.loads(job.stdout)["modes"][0]["frequency"] * (1 << 14) / 8000  # as a line of the spectrum

        def cents(*options, score=blow):
            told = self.proxies(*bar, *options, score=score)
            spectrum = abs(numpy.fft.rfft(self.sound()[1][:800] * numpy.hanning(800), 1 << 14))
            return told, 1200 * numpy.log2(spectrum.argmax() / frequency)  # the lowest partial is the strongest
        told, sharp = cents()
        self.assertNotIn("fitted", told)
        self.assertGreater(sharp, 500)  # one layer of springs is stiff in bending
        plain = self.sound()[1]
        cents("--springs", "van_gelder")
        self.assertEqual(self.sound()[1].tobytes(), plain.tobytes())
        told, fitted = cents("--springs", "fitted")
        self.assertAlmostEqual(fitted, 0, delta=10)
        found = re.search(r"plate: springs fitted to 18 modes; the lowest ones are ([-+]\d+) .* elements, ([-+]\d+)", told)
        self.assertAlmostEqual(int(found[1]), fitted, delta=8)  # of 0.1 s of sound
        self.assertAlmostEqual(int(found[2]), sharp, delta=5)
        tuned = blow + "  - {type: tune, time: 0, tension: 0.49}\n"
        self.assertAlmostEqual(cents("--springs", "fitted", score=tuned)[1], 1200 * numpy.log2(0.7), delta=15)
        told = self.proxies(*bar, "--springs", "fitted", "--strength", "plate=1e4", "--most-active", 100, score=blow)
        self.assertRegex(told, r"plate broke into \d+ pieces")
        self.assertEqual(self.proxies(*bar, "--springs", "fitted", "--levels", 2, score=blow).count("springs fitted"), 2)

    def test_fitted_springs_of_one_layer_follow_a_plate(self):
        blow = ("duration: 0.01\nevents:\n"
                "  - {time: 0, at: [0.03, 0.02, 0.006], direction: [0, 0, -1], mass: 0.01, hardness: 1e7, speed: 1}\n")
        told = self.proxies("--set", f"bodies.plate.mesh={program.SOURCE / 'meshes/square_plate.geo'}", "--set", "bodies.plate.fixed=[rim]",
                            "--set", "bodies.plate.parameters={side: 0.2, thickness: 0.012, size: 0.024, layers: 1}",
                            "--set", "materials.rubber.poisson=0.25", "--springs", "fitted", score=blow)
        found = re.search(r"fitted to 24 modes; the lowest ones are (.*) cents from those of finite elements", told)
        self.assertLess(max(abs(int(cents)) for cents in found[1].split()), 65)
        self.assertLess(int(re.search(r"plate: (\d+) of its 24 fitted modes are more than 100", told)[1]), 10)

    def test_fitted_springs_say_when_they_cannot_be(self):
        told = self.proxies("--springs", "fitted", "--set", "bodies.plate.fixed=[body]", status=program.WRONG_DECK)
        self.assertRegex(told, r"the springs of body 'plate' can't be fitted: .* all of it is held.*--springs van_gelder")

    def test_own_values_multiply_fitted_springs(self):
        blow = ("duration: 0.1\nevents:\n"
                "  - {time: 0, at: [0.06, 0.02, 0.02], direction: [0, 0, -1], mass: 0.01, hardness: 1e7, speed: 1}\n")
        file = self.output / "block.msh"
        block = ["--set", f"bodies.plate.mesh={file}", "--set", "bodies.plate.fixed=null", "--set", "bodies.plate.parameters=null",
                 "--set", "materials.rubber.damping={mass: 20, stiffness: 1e-6}", "--springs", "fitted"]

        def pitch(*views):
            file.write_text(block_mesh(views))
            self.proxies(*block, score=blow)
            return self.pitch(self.sound()[1])
        self.assertAlmostEqual(pitch(("spring_stiffness", "Element", lambda i: 0.49)) / pitch(), 0.7, delta=0.01)

    def test_a_file_gives_single_springs_their_own_values(self):
        blow = ("duration: 0.1\nevents:\n"
                "  - {time: 0, at: [0.06, 0.02, 0.02], direction: [0, 0, -1], mass: 0.01, hardness: 1e7, speed: 1}\n")
        mesh, springs = self.output / "block.msh", self.output / "springs.csv"
        mesh.write_text(block_mesh([]))
        block = ["--set", f"bodies.plate.mesh={mesh}", "--set", "bodies.plate.fixed=null",
                 "--set", "bodies.plate.parameters=null", "--set", "materials.rubber.damping={mass: 20, stiffness: 1e-6}"]

        def sound(rows):
            springs.write_text("# x1, y1, z1, x2, y2, z2, stiffness, damping, length\n"
                               + "".join(", ".join(f"{x:.8g}" for x in row) + "\n" for row in rows))
            self.proxies(*block, "--set", f"bodies.plate.springs={springs}", score=blow)
            return self.sound()[1]

        def rows(stiffness, damping=1, move=0):
            return [[0.01 * x + move for x in edge] + [stiffness(edge), damping, 1] for edge in block_edges()]
        plain = sound(rows(lambda edge: 1))
        self.proxies(*block, score=blow)
        self.assertEqual(plain.tobytes(), self.sound()[1].tobytes())
        self.assertAlmostEqual(self.pitch(sound(rows(lambda edge: 0.49, move=1e-3))) / self.pitch(plain), 0.7, delta=0.01)
        half = sound(rows(lambda edge: 0.1 if edge[0] < 3 else 1))
        self.assertLess(self.pitch(half) / self.pitch(plain), 0.98)
        one = sound(rows(lambda edge: 1)[:1] + [[0.06, 0.04, 0.02, 0.05, 0.04, 0.02, 50, 1, 1]])
        self.assertNotEqual(one.tobytes(), plain.tobytes())
        ending = numpy.linalg.norm(plain[400:])
        self.assertLess(numpy.linalg.norm(sound(rows(lambda edge: 1, damping=100))[400:]), 0.9 * ending)
        for row, message in (("0, 0, 0, 0.06, 0, 0, 1, 1, 1", r"springs\.csv:1:1: no spring is between these points"),
                             ("0, 0, 0, 0.01, 0, 0, 1, 1", r"springs\.csv:1:26: expected a comma between damping and length"),
                             ("0, 0, 0, 0.01, 0, 0, 0, 1, 1", r"springs\.csv:1:1: stiffness and length must be above 0"),
                             ("0, 0, 0, 0.01, 0, 0, 2, 1, 1\n0.01, 0, 0, 0, 0, 0, 2, 1, 1",
                              r"springs\.csv:2:1: names the same spring as line 1")):
            springs.write_text(row + "\n")
            answer = self.proxies(*block, "--set", f"bodies.plate.springs={springs}", score=blow, status=program.WRONG_DECK)
            self.assertRegex(answer, message)

    def test_answers_scripts(self):
        (self.output / "score.yaml").write_text(SCORE)
        ask = ["proxies", program.deck("simple"), "--score", self.output / "score.yaml", "--json"]
        job = program.idiophone(*ask, "--levels", 2, *LATE, "--output", self.output / "sound.wav")
        self.require_status(job, program.FINISHED)
        facts = json.loads(job.stdout)  # what is logged goes to stderr
        self.assertEqual((facts["output"], facts["bodies"], facts["rate"], facts["duration"]),
                         (str(self.output / "sound.wav"), ["plate"], 8000, 0.2))
        self.assertEqual([(level["body"], level["level"]) for level in facts["proxies"]["levels"]], [("plate", 0), ("plate", 1)])
        self.assertGreater(facts["proxies"]["levels"][0]["springs"], 2 * facts["proxies"]["levels"][1]["springs"])
        self.assertEqual(facts["proxies"]["choices"]["begin"], 1)
        self.assertGreater(facts["processor_time"], 0)
        job = program.idiophone(*ask, "--output-folder", self.output)
        self.require_status(job, program.FINISHED)
        facts = json.loads(job.stdout)
        self.assertEqual((facts["output"], facts["is_complete"]), (str(self.output / "simple.h5"), True))
        self.assertGreater(facts["bodies"]["plate"]["springs"], 0)

    def test_says_that_walls_are_left_out(self):
        walls = "radiation={room: {size: [4, 4, 4], corner: [-2, -2, -2], absorption: 0.2}}"
        self.assertIn("the walls of radiation.room are left out", self.proxies("--set", walls))
        floor = "radiation={floor: {at: [0, 0, -1], reflection: 0.9}}"
        self.assertIn("the reflections of radiation.floor are left out", self.proxies("--set", floor))

    def test_tunes_while_it_sounds(self):
        self.proxies()
        plain = self.sound()[1]
        self.proxies(score=SCORE + "  - {type: tune, time: 0.05, tension: 4, friction: 2}\n")
        tuned = self.sound()[1]
        scale = numpy.abs(plain[:400]).max() / numpy.abs(tuned[:400]).max()  # of the WAV files
        self.assertLess(numpy.abs(plain[:400] - scale * tuned[:400]).max(), 1e-3 * numpy.abs(plain[:400]).max())
        self.assertGreater(numpy.abs(plain[400:] - scale * tuned[400:]).max(), 1e-3 * numpy.abs(plain[:400]).max())
        self.assertIn("100 000 steps", self.proxies(score=SCORE + "  - {type: tune, time: 0.05, size: 0.01, tension: 1e4}\n",
                                                    status=program.FAILED))

    def test_levels_and_limits_change_by_the_score(self):
        blow = "  - {time: %s, at: [0.02, 0.01, 0.01], direction: [0, 0, -1], mass: 0.01, hardness: 1e7, speed: 1}\n"
        score = "duration: 0.2\nevents:\n  - {type: detail, time: 0, level: 1}\n" + blow % 0.01
        report = ["--levels", 2, "--report", self.output / "choices.csv"]
        self.proxies(*report, score=score)
        self.assertEqual(self.choices()[0]["level"], "1")
        self.proxies(*report, score=score.replace("level: 1", "level: -1"))
        self.assertEqual(self.choices()[0]["level"], "0")
        self.proxies(*report, score=score + "  - {type: detail, time: 0.1, budget: 1e-6, most_active: 1}\n")
        self.assertEqual([choice["choice"] for choice in self.choices()], ["begin", "stop", "end"])
        self.assertAlmostEqual(float(self.choices()[1]["time"]), 0.1, delta=1e-3)
        self.assertIn("has no level 3", self.proxies(score=score.replace("level: 1", "level: 3"), status=program.FAILED))
        self.assertRegex(self.proxies(score=score.replace(", level: 1", ""), status=program.WRONG_DECK), "changes nothing")

    def test_refuses_what_is_wrong(self):
        self.assertIn("--frames-per-second needs", self.proxies("--frames-per-second", 60, status=program.FAILED))
        self.assertIn("nothing drives the proxies", self.proxies(score=None, status=program.FAILED))
        self.assertRegex(self.proxies(score=SCORE.replace("speed: 1}", "sped: 1}"), status=program.WRONG_DECK),
                         r"score\.yaml:4:.*sped")
        self.assertIn("improved_euler needs", self.proxies(
            "--integrator", "improved_euler", "--set", "materials.rubber.damping={mass: 0, stiffness: 0}",
            status=program.FAILED))
        self.assertRegex(self.proxies("--levels", 2, "--set", "bodies.plate.fixed=[{group: rim, axes: z}]",
                                      status=program.WRONG_DECK), r"pin masses in all directions")


class Exported(program.TestCase):
    """`export --proxy`: a proxy for engines. What engines hear is tested in ctest/instruments/engines."""

    def export(self, *arguments, status=program.FINISHED):
        job = program.idiophone("export", program.deck("simple"), *arguments)
        self.require_status(job, status)
        return job.stdout + job.stderr

    def test_says_once_what_proxies_of_a_material_lack(self):
        other = "{mesh: ../../../meshes/square_plate.geo, parameters: {size: 0.1}, material: rubber}"
        said = self.export("--proxy", self.output / "plate.proxy", "--body", "plate", "--set", f"bodies.other={other}",
                           "--set", "loads.tap.body=plate",
                           "--set", "materials.rubber.damping={loss_factor: 0.1, band: [50, 500]}")
        self.assertEqual(said.count("its proxies have the loss factor at 200 and 5000 Hz only"), 1, said)

    def test_writes_a_flat_file_with_all_levels(self):
        sizes = []
        for levels in (1, 2):
            self.export("--proxy", self.output / "plate.proxy", "--body", "plate", "--levels", levels)
            data = (self.output / "plate.proxy").read_bytes()
            self.assertEqual(data[:20], b"IDIOPHONE PROXY\n\1\0\0\0")
            self.assertEqual(data[28:49], b"\5\0\0\0\0\0\0\0plate" + bytes([levels]) + bytes(7))
            sizes.append(len(data))
        self.assertGreater(sizes[1], 1.05 * sizes[0])
        self.export("--proxy", self.output / "stiff.proxy", "--set", "materials.rubber.young=1e7")
        self.assertNotEqual((self.output / "stiff.proxy").read_bytes(), data)

    def test_refuses_what_is_wrong(self):
        proxy = self.output / "plate.proxy"
        self.assertIn("plate", self.export("--proxy", proxy, "--body", "bell", status=program.FAILED))
        self.assertIn("do not go with it", self.export("--proxy", proxy, "--voice", self.output / "plate.voice", status=program.FAILED))
        job = program.idiophone("export", program.deck("simple"), "--voice", proxy, "--levels", 2)
        self.assertNotEqual(job.returncode, program.FINISHED)
        self.assertIn("--levels requires --proxy", job.stderr)
        self.assertFalse(proxy.exists())


@unittest.skipIf(shutil.which("jackd") is None, "needs jackd")
class RealTime(program.TestCase):
    def test_plays_a_score_to_its_end_and_counts_gaps(self):
        _, environment = jack_server.start(self)
        (self.output / "score.yaml").write_text(SCORE)
        job = subprocess.run([program.PROGRAM, "proxies", program.deck("simple"), "--score", self.output / "score.yaml",
                              "--set", "audio.rate=48000", "--device", "JACK", "--buffers", "40"],
                             capture_output=True, text=True, timeout=program.TIMEOUT, env=environment)
        self.require_status(job, program.FINISHED)
        self.assertRegex(job.stdout, r"1 bodies, 40 buffers of 256 frames")
        self.assertRegex(job.stdout, r"0\.2\d* s; \d+ gaps")

    def test_hears_osc_until_it_is_interrupted(self):
        _, environment = jack_server.start(self)
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
            sender.bind(("127.0.0.1", 0))
            port = sender.getsockname()[1]
        process = subprocess.Popen([program.PROGRAM, "proxies", program.deck("simple"), "--osc", str(port),
                                    "--set", "audio.rate=48000", "--device", "JACK"],
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=environment)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.kill)
        for line in process.stdout:
            if "Ctrl-C ends" in line:
                break
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
            sender.sendto(test_play.osc(*test_play.BLOW), ("127.0.0.1", port))
            sender.sendto(test_play.osc("/listener", 0.1, 0.0, 1.0), ("127.0.0.1", port))
            sender.sendto(test_play.osc("/tune", "plate", 1.0, 2.0), ("127.0.0.1", port))
            sender.sendto(test_play.osc("/event", "{type: tune, tension: 1.5}"), ("127.0.0.1", port))
        time.sleep(1)
        process.send_signal(signal.SIGINT)
        told = process.communicate(timeout=60)[0]
        self.assertEqual(process.returncode, program.FINISHED, told)
        self.assertIn("1 proxies began to sound", told)
        self.assertNotIn("OSC /", told)  # no message was refused


if __name__ == "__main__":
    unittest.main()
