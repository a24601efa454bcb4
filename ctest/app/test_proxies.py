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

import h5py
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


class Proxies(program.TestCase):
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

    def box(self, more=""):
        """Settings that make the body a box of 60 x 40 x 20 mm with elements of 10 mm."""
        (self.output / "box.geo").write_text("SetFactory(\"OpenCASCADE\");\nDefineConstant[ size = 0.01 ];\n" + more +
                                             "Box(1) = {0, 0, 0, 0.06, 0.04, 0.02};\n"
                                             "MeshSize{ PointsOf{ Volume{1}; } } = size;\n")
        return ["--set", f"bodies.plate.mesh={self.output / 'box.geo'}", "--set", "bodies.plate.fixed=null",
                "--set", "bodies.plate.parameters={size: 0.01}"]

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

    def test_results_have_frames_of_bodies_that_vibrate_and_move(self):
        blow = ("duration: 0.02\nevents:\n"
                "  - {time: 0, at: [0.02, 0.01, 0.01], direction: [0, 0, -1], mass: 0.01, hardness: 1e7, speed: 1}\n")
        (self.output / "score.yaml").write_text(blow)
        folder = self.output / "result"
        job = program.idiophone("proxies", program.deck("simple"), "--score", self.output / "score.yaml",
                                "--output-folder", folder)
        self.require_status(job, program.FINISHED)
        job = program.idiophone("proxies", program.deck("simple"), "--score", self.output / "score.yaml",
                                "--frames-per-second", 1000, "--output", self.output / "film.h5")
        self.require_status(job, program.FINISHED)
        with h5py.File(folder / "simple.h5") as file, h5py.File(self.output / "film.h5") as film:
            numpy.testing.assert_allclose(file["frames/time"][()], numpy.arange(21) / 1000, atol=1e-9)  # the deck's rate
            frames, filmed = (each["frames/plate/displacement"][()] for each in (file, film))
            self.assertEqual(file["mesh/plate/nodes"].shape, film["mesh/plate/nodes"].shape)
        self.assertEqual(frames.shape[0], 21)
        self.assertEqual(abs(frames[0]).max(), 0)
        self.assertLess(abs(frames[5:20] - filmed[5:20]).max(), 0.1 * abs(filmed).max())  # other steps, the same vibration
        self.assertTrue((folder / "simple.xdmf").exists())
        self.require_status(program.run("bounce", self.output), program.FINISHED)
        job = program.idiophone("proxies", program.deck("bounce"), "--contacts", self.output / "bounce.h5",
                                "--output-folder", folder, "--frames-per-second", 500)
        self.require_status(job, program.FINISHED)
        run, proxy = (program.contents(path / "bounce.h5") for path in (self.output, folder))
        body = next(name.split("/")[1] for name in proxy if name.startswith("frames/") and name.endswith("displacement"))
        moved = proxy[f"frames/{body}/displacement"].mean(axis=1)
        path = run[f"motion/{body}/centre_of_mass"]
        self.assertLess(numpy.linalg.norm(moved[-1] - (path[-1] - path[0])), 0.05 * numpy.linalg.norm(path[-1] - path[0]))

    def test_radiates_by_the_model_of_the_deck(self):
        kirchhoff = ["--set", "radiation.model=kirchhoff", "--set", "materials.rubber.damping.mass=100"]
        self.proxies(*kirchhoff)
        near = self.sound()[1]
        (self.output / "score.yaml").write_text(SCORE)
        radiate = ["proxies", program.deck("simple"), "--score", self.output / "score.yaml", "--output-folder", self.output / "result",
                   *kirchhoff]
        job = program.idiophone(*radiate)
        self.require_status(job, program.FINISHED)
        rate, heard = wavfile.read(self.output / "result/simple.wav")
        self.assertEqual((rate, len(heard)), (8000, 1600))
        peaks = [abs(numpy.fft.rfft(sound.astype(float)[80:1600])).argmax() for sound in (near, heard)]
        self.assertAlmostEqual(peaks[0], peaks[1], delta=1)  # the same vibration
        facts = json.loads(program.idiophone("info", "--json", self.output / "result/simple.h5").stdout)["run"]
        self.assertGreater(facts["bodies"]["plate"]["springs"], facts["bodies"]["plate"]["masses"])
        with open(self.output / "score.yaml", "a") as score:
            score.write("  - {type: tune, time: 0.05, tension: 4}\n")
        job = program.idiophone(*radiate)
        self.require_status(job, program.FAILED)
        self.assertIn("can't tune a body", job.stdout + job.stderr)
        self.assertIn("leave out --output,", self.proxies("--output-folder", self.output / "result", status=program.FAILED))

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

    def test_contacts_of_a_result_drive_proxies(self):
        # The ball flies to the wall at x = 0.05 with 1 m/s for 0.01 s; the ears are 34.3 m away from it, 0.1 s of sound.
        job = program.run("bounce", self.output)
        self.require_status(job, program.FINISHED)
        result, = self.output.glob("bounce*.h5")
        ears = "listeners.ear={type: stereo, position: [0, 0, 34.3], look: [0, 0, -1], up: [0, 1, 0], separation: 10}"
        self.proxies("--contacts", result, "--set", ears, deck="bounce", score=None)
        sound = self.sound()[1]
        self.assertEqual(sound.shape, (1000, 2))
        power = (sound ** 2).max(axis=1)
        self.assertGreater(power.max(), 0)
        self.assertLess(power[:200].max(), 1e-6 * power.max())

    def test_moving_bodies_are_heard_with_their_doppler_shift(self):
        # The ball hits the wall at x = 0.05 with 8 m/s and flies back, towards one ear and away from the other.
        flight = ["--set", "bodies.ball.velocity=[8, 0, 0]", "--set", "obstacles.left=null", "--set", "contacts.left=null",
                  "--set", "listeners.front={type: mono, position: [-20, 0, 0]}",
                  "--set", "listeners.back={type: mono, position: [20, 0, 0]}"]
        self.require_status(program.run("bounce", self.output, *flight), program.FINISHED)
        result, = self.output.glob("bounce*.h5")
        job = program.idiophone("proxies", program.deck("bounce"), *flight, "--contacts", result,
                                "--output-folder", self.output / "heard")
        self.require_status(job, program.FINISHED)
        pitches = []
        for ear in ("front", "back"):
            rate, sound = wavfile.read(self.output / f"heard/bounce_{ear}.wav")
            spectrum = abs(numpy.fft.rfft(sound[300:900] * numpy.hanning(600), 1 << 16))
            low, high = 300 * (1 << 16) // rate, 360 * (1 << 16) // rate  # the lowest mode is alone there
            pitches.append(low + spectrum[low:high].argmax())
        self.assertAlmostEqual(pitches[0] / pitches[1], (343 + 8) / (343 - 8), delta=0.006)

    def choices(self):
        with open(self.output / "choices.csv") as file:
            return list(csv.DictReader(file))

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

    def test_brittle_body_breaks_into_pieces_that_sound(self):
        blow = ("duration: 0.05\nevents:\n"
                "  - {time: 0.01, at: [0.06, 0.02, 0.02], direction: [0, 0, -1], mass: 0.05, hardness: 1e7, speed: 5}\n")
        report = ["--report", self.output / "choices.csv", *self.box()]
        self.assertNotIn("broke into", self.proxies(*report, "--strength", "plate=1e9", score=blow))
        told = self.proxies(*report, "--strength", "plate=1e4", "--most-active", 100, score=blow)
        self.assertRegex(told, r"plate broke into \d+ pieces and released")
        self.assertIn("plate.1", [choice["body"] for choice in self.choices()])
        self.assertTrue(numpy.isfinite(self.sound()[1]).all())
        self.assertIn("no deck has a body", self.proxies("--strength", "plat=1e9", status=program.FAILED))
        self.assertIn("is not BODY=PA", self.proxies("--strength", "plate", status=105))

    def test_pane_and_vase_of_the_examples_break_as_a_film_shows(self):
        for deck, score, strength, size in (("pane", "stone", "4e7", 0.02), ("vase", "floor", "1e7", 0.014)):
            inputs = program.SOURCE / "inputs/breaking"
            text = (inputs / f"{score}.yaml").read_text().replace("duration: 0.3", "duration: 0.02")
            (self.output / "score.yaml").write_text(text)
            film = self.output / "film.h5"
            render = ["proxies", inputs / f"{deck}.yaml", "--score", self.output / "score.yaml",
                      "--set", f"bodies.{deck}.parameters.size={size}"]
            job = program.idiophone(*render, "--most-active", 200, "--strength", f"{deck}={strength}",
                                    "--output", film, "--frames-per-second", 1000)
            self.require_status(job, program.FINISHED)
            parts = [int(number) for number in re.findall(r"; (\d+) parts", job.stdout + job.stderr)]
            self.assertEqual(parts, sorted(parts))
            self.assertGreater(parts[-1], 5)
            with h5py.File(film) as file:
                sound, moved = file["audio/film"][()], file[f"frames/{deck}/displacement"][()]
                times, nodes = file["frames/time"][()], file[f"mesh/{deck}/nodes"][()]
            self.assertTrue(numpy.isfinite(sound).all() and numpy.isfinite(moved).all())
            self.assertTrue(numpy.allclose(times, numpy.arange(20) / 1000, atol=1e-4))
            places, first = numpy.unique(nodes, axis=0, return_inverse=True)
            gap = [max(numpy.ptp(frame[first == i], axis=0).max() for i in range(0, len(places), 7)) for frame in moved[[5, -1]]]
            self.assertLess(gap[0], 1e-9)      # before the blow
            self.assertGreater(gap[1], 1e-4)
            self.assertTrue((self.output / "film.xdmf").exists())
            if deck == "pane":
                still = subprocess.run([program.SOURCE / "scripts/movie", film, "--still", "0.015", self.output / "still.png"],
                                       capture_output=True, text=True, timeout=program.TIMEOUT)
                self.require_status(still, program.FINISHED)
                self.assertTrue((self.output / "still.png").exists())
            self.require_status(program.idiophone(*render, "--output", self.output / "whole.h5"), program.FINISHED)
            with h5py.File(self.output / "whole.h5") as file:
                whole = file["audio/whole"][()]
                self.assertNotIn(deck, file["frames"])
            late = slice(len(whole) // 2, None)
            self.assertLess(numpy.abs(sound).max(), 500)  # Pa: splinters that are let go are loud
            self.assertGreater(numpy.abs(sound[late] - whole[late]).max(), 0.05 * numpy.abs(whole).max())

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
