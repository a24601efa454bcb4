#!/usr/bin/python3
"""`idiophone timbre` and `evolve`: the examples of inputs/timbre, by what is known of their sounds."""
import itertools
import json
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

import h5py
import numpy
import scipy.io.wavfile

import program
from timbre_case import INPUTS, RATE, TimbreCase, band, level, notes_on, pitches, seconds

SOUND_FONT = "/usr/share/sounds/sf2/TimGM6mb.sf2"


class Trees(TimbreCase):
    def test_the_bee_grows_in_three_stages(self):
        sound = self.timbre(INPUTS / "bee_stages.yaml")
        stages = [seconds(sound, 2 * i + 0.1, 2 * i + 1.9) for i in range(3)]
        strengths = [band(stage, 225, 235) / band(stage, 20, 15000) for stage in stages]
        self.assertGreater(strengths[0], 1.1 * strengths[1])  # a pure tone, then a rough one
        wander = [pitches(stage, 180, 290).std() for stage in stages]
        self.assertLess(wander[0], 0.5)
        self.assertGreater(wander[2], 4 * wander[0] + 3)      # Hz: the mean frequency wanders
        self.assertAlmostEqual(pitches(stages[0], 180, 290).mean(), 230, delta=0.5)

    def test_a_bee_that_passes_falls_in_pitch(self):
        sound = self.timbre(INPUTS / "bee.yaml", "--set", "sounds.bee.parameters={freq: 230, roughness: 0, activity: 0}")
        found = pitches(sound[:, 0], 200, 260)
        self.assertAlmostEqual(found[5:10].mean() / found[-10:-5].mean(), (343 + 3) / (343 - 3), delta=0.003)
        loudness = [level(part) for part in numpy.array_split(sound[:, 0], 16)]
        self.assertIn(int(numpy.argmax(loudness)), (7, 8))

    def test_wind_follows_its_force(self):
        sound = self.timbre(INPUTS / "wind.yaml")
        loudness = [level(seconds(sound, t, t + 1)) for t in range(6)]
        self.assertGreater(loudness[2], 1.3 * loudness[0])
        self.assertGreater(loudness[3], 1.3 * loudness[5])
        self.assertGreater(band(sound, 50, 400), 3 * band(sound, 4000, 16000))

    def test_sliding_and_rolling_follow_speed_and_force(self):
        def sound(tree, speed, force):
            return self.timbre(self.scene(f"name: s\nduration: 1\nclasses: {{a: {INPUTS / tree}}}\nsounds: {{a: {{class: a, "
                                          f"parameters: {{speed: {speed}, force: {force}}}}}}}\n"))[RATE // 5:]

        def pitch(sound):  # the middle of the spectrum
            power = numpy.abs(numpy.fft.rfft(sound)) ** 2
            return numpy.sum(power * numpy.arange(len(power))) / numpy.sum(power)

        for tree, by_force in ("slide.tt", 2), ("roll.tt", 4):
            gentle, hard, fast = sound(tree, 0.4, 1), sound(tree, 0.4, 4), sound(tree, 0.8, 1)
            self.assertAlmostEqual(level(hard) / level(gentle), by_force, delta=0.01)
            self.assertGreater(level(fast), 1.2 * level(gentle))
            self.assertGreater(pitch(fast), 1.2 * pitch(gentle))
            for still in sound(tree, 0, 4), sound(tree, 0.4, 0), sound(tree, 0.4, -1):
                self.assertLess(numpy.abs(still).max(), 1e-6 * numpy.abs(gentle).max())

    def test_a_wall_shades_the_bee_and_reflects_it(self):
        behind = self.timbre(INPUTS / "wall.yaml")[:, 0]
        free = self.timbre(INPUTS / "wall.yaml", "--set", "objects=null")[:, 0]
        shaded = [band(seconds(sound, 1.2, 2), 1000, 10000) for sound in (behind, free)]
        self.assertLess(shaded[0], 0.05 * shaded[1])  # 15 kg/m2 take 41 dB of 1 kHz
        deep = [band(seconds(sound, 1.2, 2), 180, 260) for sound in (behind, free)]
        self.assertGreater(deep[0] / deep[1], 3 * shaded[0] / shaded[1])
        numpy.testing.assert_allclose(seconds(behind, 2.6, 2.9), seconds(free, 2.6, 2.9), atol=1e-6)  # it has come out
        self.assertGreater(level(seconds(behind - free, 3.7, 3.9)), 0.3 * level(seconds(free, 3.7, 3.9)))  # an image, too

    def test_scenes_and_trees_are_checked(self):
        tree = self.output / "tree.tt"
        tree.write_text("(parameter amp 1)\n(* amp (sinee 440))\n")
        scene = self.scene("name: s\nduration: 1\nclasses: {a: tree.tt}\nsounds: {a: {class: a}}\n")
        self.timbre(scene, status=program.WRONG_DECK)
        self.assertIn("tree.tt:2:9: there is no node 'sinee' (did you mean 'sine'?)", self.said)
        tree.write_text("(log (- 0.5 time))")
        self.timbre(scene, status=program.FAILED)
        self.assertIn("is not finite 0.5 s after the sound began", self.said)
        self.timbre(tree, status=program.FAILED)
        self.assertIn("tree.tt is a timbre tree. A sonic scene says when it sounds", self.said)
        tree.write_text("(* 0 (sine 440))")
        self.timbre(scene)
        self.assertIn(".wav is silent", self.said)

    def test_outputs_are_checked_before_the_sound_is_computed(self):
        (self.output / "tree.tt").write_text("(* 2 (sine 441))")
        scene = self.scene("name: s\nduration: 1\nclasses: {a: tree.tt}\nsounds: {a: {class: a, start: [0, 5]}}\n")
        for file, said in ("none/a.wav", "there is no such folder"), ("", "it is a folder"):
            job = program.idiophone("timbre", scene, "-o", self.output / file)
            self.require_status(job, program.FAILED)
            self.assertIn(said, job.stderr)
        self.timbre(scene, "--set", "duration=86400", status=program.FAILED)
        self.assertIn("more sound than the 4 GB of a WAV file hold", self.said)
        sound = self.timbre(scene, "--set", "wav=pcm16")
        self.assertIn("1 sounds start after the end of the scene and are left out", self.said)
        exceeding = numpy.count_nonzero(numpy.abs(2 * numpy.sin(2 * numpy.pi * 0.01 * numpy.arange(RATE))) > 1)
        self.assertIn(f"{exceeding} samples exceed full scale and were clipped", self.said)
        self.assertEqual(numpy.abs(sound).max(), 32767)

    def test_equal_seeds_give_equal_bits(self):
        first = self.timbre(INPUTS / "wind.yaml")
        self.assertTrue(numpy.array_equal(first, self.timbre(INPUTS / "wind.yaml")))
        self.assertFalse(numpy.array_equal(first, self.timbre(INPUTS / "wind.yaml", "--set", "seed=2")))


class Motion(TimbreCase):
    """Sounds that are bound to the motion of runs."""
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp())
        cls.addClassCleanup(shutil.rmtree, cls.folder)

    def motion(self, name, *arguments):
        """The result of a run, made once."""
        result = self.folder / f"{name}_motion.h5"
        if not result.exists():
            job = program.idiophone("run", INPUTS / f"{name}_motion.yaml", "--output-folder", self.folder, *arguments)
            self.require_status(job, program.FINISHED)
        return result

    def test_cubes_of_wood_and_metal_sound_when_they_collide(self):
        result = self.motion("cubes")
        with h5py.File(result) as file:
            force = numpy.linalg.norm(file["contacts/hit/force"][:], axis=1)
        start = numpy.argmax(force > 1) / RATE
        sound = self.timbre(INPUTS / "cubes.yaml", result)[:, 0]
        travel = (0.5 ** 2 + 0.2 ** 2) ** 0.5 / 343
        loudest = numpy.abs(sound).max()
        arrival = start + 0.4 / 343 - 42 / RATE  # the smooth fractional delay begins 42 samples early
        self.assertLess(numpy.abs(seconds(sound, 0, arrival)).max(), 1e-3 * loudest)
        self.assertGreater(numpy.abs(seconds(sound, start + travel, start + travel + 0.01)).max(), 0.1 * loudest)
        early, late = seconds(sound, 0.002, 0.05), seconds(sound, 0.4, 0.6)
        self.assertGreater(band(early, 5000, 10000), 0.1 * band(early, 450, 1050))       # wood
        self.assertLess(band(late, 4900, 10100), 1e-2 * band(late, 450, 1050))           # only metal rings on
        self.assertGreater(band(late, 450, 1050), 20 * band(late, 1100, 4900))
        twice = self.timbre(INPUTS / "cubes.yaml", result, "--set", "variables.strength.scale=0.004")[:, 0]
        numpy.testing.assert_allclose(twice, 2 * sound, atol=1e-5 * loudest)

    LAMP = ("ankle_opening", "ankle_closing", "knee_opening", "knee_closing", "neck_opening", "neck_closing", "landing")

    def lamp(self, result, *sounds):
        """The sound of the lamp, of some of its sounds alone."""
        silent = [f"sounds.{name}.gain=0" for name in self.LAMP if name not in sounds]
        return self.timbre(INPUTS / "lamp.yaml", result, *itertools.chain.from_iterable(("--set", gain) for gain in silent))

    def test_each_joint_of_the_lamp_has_two_squeaks_that_follow_its_speed(self):
        result = self.motion("lamp")
        for joint in ("ankle", "knee", "neck") if program.LONG else ("knee",):
            with h5py.File(result) as file:
                angle = file[f"gauges/{joint}/angle"][:, 0]
                rate = file[f"gauges/{joint}/angle"].attrs["rate"]
            speed = numpy.gradient(angle) * rate
            self.assertGreater(speed.max(), 0.5)
            self.assertLess(speed.min(), -0.5)
            opening, closing = self.lamp(result, f"{joint}_opening"), self.lamp(result, f"{joint}_closing")
            for squeak, turning in (opening, speed), (closing, -speed):
                now = numpy.interp(numpy.arange(len(squeak)) / RATE, numpy.arange(len(speed)) / rate, turning.clip(0, 20))
                self.assertEqual(numpy.abs(squeak[now == 0]).max(), 0)
                loud = [level(part) for part in numpy.array_split(squeak, 200)]
                fast = [part.mean() for part in numpy.array_split(numpy.tanh(0.6 * now), 200)]
                self.assertGreater(numpy.corrcoef(loud, fast)[0, 1], 0.8)

    def test_the_lamp_lands_on_its_base(self):
        result = self.motion("lamp")
        with h5py.File(result) as file:
            force = numpy.linalg.norm(file["contacts/landing/force"][:], axis=1)
            rate = file["contacts/landing/force"].attrs["rate"]
            height = file["motion/lamp/centre_of_mass"][:, 2]
        in_flight = numpy.count_nonzero(force[int(1.1 * rate):int(1.6 * rate)] == 0) / rate
        self.assertGreater(in_flight, 0.1)
        self.assertGreater(height.max() - height[0], 0.03)
        sound = self.lamp(result, "landing")
        start = numpy.argmax(force > 25) / rate
        self.assertEqual(numpy.abs(seconds(sound, 0, start)).max(), 0)
        self.assertGreater(numpy.abs(seconds(sound, start, start + 0.02)).max(), 0)
        loudest = numpy.argmax(numpy.abs(sound)) / RATE
        self.assertLess(abs(loudest - numpy.argmax(force) / rate), 0.05)

    def test_the_angles_of_the_lamps_joints_play_a_blues(self):
        others = ("--set", "music.parts.ankle=null", "--set", "music.parts.neck=null")
        for arguments, least in ((), 20), (others, 6):
            self.timbre(INPUTS / "lamp.yaml", self.motion("lamp"), *arguments)
            notes = notes_on(self.output / "sound.mid")
            self.assertGreater(len(notes), least)
            self.assertLessEqual({number % 12 for number, _ in notes}, {0, 3, 5, 6, 7, 10})
        self.assertGreater(len({velocity for _, velocity in notes}), 3)
        self.assertTrue(all(now[0] != before[0] for before, now in itertools.pairwise(notes)), "equal notes are not slurred")

    @unittest.skipUnless(shutil.which("fluidsynth") and pathlib.Path(SOUND_FONT).exists(), "needs fluidsynth")
    def test_fluidsynth_plays_the_music(self):
        self.timbre(INPUTS / "lamp.yaml", self.motion("lamp"))
        played = self.output / "music.wav"
        subprocess.run(["fluidsynth", "-ni", "-F", played, "-r", str(RATE), SOUND_FONT, self.output / "sound.mid"],
                       check=True, capture_output=True, timeout=60)
        rate, sound = scipy.io.wavfile.read(played)
        self.assertEqual(rate, RATE)
        self.assertGreater(len(sound), 2.5 * RATE)
        self.assertGreater(level(sound[:RATE].astype(float)), 10)

    def test_the_coin_sounds_by_its_angular_velocity(self):
        result = self.motion("coin", "--set", "time.duration=0.5")
        with h5py.File(result) as file:
            spin = numpy.linalg.norm(file["motion/coin/angular_velocity"][:], axis=1)
            rate = file["motion/coin/angular_velocity"].attrs["rate"]
        sound = self.timbre(INPUTS / "coin.yaml", result, "--set", "duration=0.5")[:, 0]
        times = numpy.arange(0.1, 0.45, 0.05)
        loudness = numpy.array([level(seconds(sound, t - 0.03, t + 0.03)) for t in times])
        spins = numpy.interp(times, numpy.arange(len(spin)) / rate, spin)
        self.assertGreater(numpy.corrcoef(loudness, spins)[0, 1], 0.5)

    def test_the_ball_slides_and_then_rolls(self):
        result = self.motion("ball", "--set", "time.duration=0.5")
        begins = 2 * 1.5 / (7 * 0.2 * 9.81)  # s: a rigid ball rolls then
        with h5py.File(result) as file:
            slip = numpy.linalg.norm(file["contacts/floor/slip"][:], axis=1)
            rate = file["contacts/floor/slip"].attrs["rate"]
        self.assertGreater(slip[:int(0.8 * begins * rate)].mean(), 0.6)
        self.assertLess(slip[int(1.15 * begins * rate):].mean(), 0.02)
        sound = self.timbre(INPUTS / "ball.yaml", result, "--set", "duration=0.5")[:, 0]
        sliding, rolling = seconds(sound, 0.02, 0.6 * begins), seconds(sound, 1.2 * begins, 0.48)
        self.assertGreater(band(sliding, 2000, 15000), 8 * band(rolling, 2000, 15000))  # the scratch ends
        self.assertGreater(band(rolling, 100, 500), 2 * band(sliding, 100, 500))        # the rumble begins
        numbers = [number for number, _ in notes_on(self.output / "sound.mid")]          # a melody of slip and rotation
        self.assertLess(numbers[0], 55)
        self.assertEqual(numbers[-1], 74)                                                # pure rolling is its highest note

    def test_sounds_move_with_their_bodies(self):
        result = self.motion("coin", "--set", "time.duration=0.5")
        (self.output / "tree.tt").write_text("(sine 1000)")
        sound = self.timbre(self.scene(
            "name: s\nduration: 0.5\nclasses: {a: tree.tt}\nsounds: {a: {class: a, body: coin}}\n"
            "listeners: {ear: {type: mono, position: [0.2, 0, 0.05]}}\n"), result)
        with h5py.File(result) as file:
            places = file["motion/coin/centre_of_mass"][:]
            rate = file["motion/coin/centre_of_mass"].attrs["rate"]
        distances = numpy.linalg.norm(places - [0.2, 0, 0.05], axis=1)
        self.assertGreater(distances.max(), 1.2 * distances.min())
        for time in numpy.arange(0.1, 0.45, 0.05):
            distance = numpy.interp(time, numpy.arange(len(distances)) / rate, distances)
            self.assertAlmostEqual(level(seconds(sound, time - 0.01, time + 0.01)) * distance, 0.5 ** 0.5, delta=0.02)

    def test_each_contact_above_a_force_starts_a_sound(self):
        result = self.motion("chimes", "--set", "time.duration=1.2")
        expected = 0
        with h5py.File(result) as file:
            for pair, sounds in ("first_second", 1), ("second_third", 1), ("third_fourth", 1), ("fourth_fifth", 2):
                force = numpy.linalg.norm(file[f"contacts/{pair}/force"][:], axis=1)
                times = numpy.flatnonzero(force > 0.05) / file[f"contacts/{pair}/force"].attrs["rate"]
                expected += sounds * numpy.count_nonzero(numpy.diff(times, prepend=-1) > 0.05)
        self.assertGreater(expected, 4)
        self.timbre(INPUTS / "chimes.yaml", result, "--set", "duration=1.2")
        self.assertIn(f"{expected + 1} sounds started", self.said)  # and the wind

    def test_the_wind_that_pushes_the_chimes_is_heard(self):
        result = self.motion("chimes", "--set", "time.duration=1.2")
        with h5py.File(result) as file:
            force = numpy.linalg.norm(file["loads/breeze/force"][:], axis=1)
            rate = file["loads/breeze/force"].attrs["rate"]
            places = file["motion/third/centre_of_mass"][:]
        self.assertGreater(force.max(), 2 * force.min())
        self.assertGreater(places[:, 0].max() - places[0, 0], 0.005)  # it blows them aside
        quiet = [argument for name in ("first", "second", "third", "fourth", "fifth")
                 for argument in ("--set", f"sounds.{name}.gain=0")]
        def wind(*arguments):
            return self.timbre(INPUTS / "chimes.yaml", result, "--set", "duration=1.2", "--set", "reverberation.level=0", *quiet,
                               *arguments)[:, 0]

        sound, half = wind(), wind("--set", "sounds.wind.parameters.amp.scale=0.15")
        numpy.testing.assert_allclose(2 * half, sound, atol=1e-4 * numpy.abs(sound).max())
        even = wind("--set", "sounds.wind.parameters.amp=1")
        times = numpy.arange(len(sound)) / RATE - numpy.linalg.norm([0.05, 3, 1.2]) / 343  # when it left its place
        factor = 0.3 * numpy.interp(times, numpy.arange(len(force)) / rate, force)
        self.assertLess(numpy.linalg.norm(sound - factor * even), 0.01 * numpy.linalg.norm(sound))

    def test_chimes_ring_at_the_frequencies_of_tubes_when_they_touch(self):
        result = self.motion("chimes", "--set", "time.duration=1.2")
        with h5py.File(result) as file:
            force = numpy.linalg.norm(file["contacts/first_second/force"][:], axis=1)
            rate = file["contacts/first_second/force"].attrs["rate"]
        start = numpy.argmax(force > 0.05) / rate
        quiet = [argument for name in ("second", "third", "fourth", "fifth", "wind")
                 for argument in ("--set", f"sounds.{name}.gain=0")]
        sound = self.timbre(INPUTS / "chimes.yaml", result, "--set", "duration=1.2", "--set", "reverberation.level=0",
                            *quiet)[:, 0]
        self.assertEqual(numpy.abs(seconds(sound, 0, start)).max(), 0)
        gyration = 0.5 * numpy.hypot(0.01, 0.008)
        lowest = numpy.pi * gyration / (8 * 0.42 ** 2) * numpy.sqrt(7e10 / 2700) * 3.011 ** 2
        self.assertAlmostEqual(pitches(sound, 100, 4000)[-1] / lowest, 1, delta=0.01)
        first = notes_on(self.output / "sound.mid")
        self.assertLessEqual({number % 12 for number, _ in first}, {0, 2, 4, 5, 7, 9, 11})


class Examples(program.TestCase):
    @program.long_verification
    @unittest.skipUnless(shutil.which("ffmpeg") and shutil.which("xvfb-run"), "needs ffmpeg and xvfb-run")
    def test_the_script_makes_pictures_and_movies(self):
        job = subprocess.run([program.SOURCE / "scripts/timbre_examples", "--program", program.PROGRAM, "--output-folder", self.output,
                              "--movies", "wind", "lamp"], capture_output=True, text=True, timeout=program.TIMEOUT)
        self.require_status(job, 0)
        self.assertEqual(job.stderr, "")
        made = {path.name for path in self.output.iterdir() if path.suffix in (".png", ".mp4")}
        self.assertEqual(made, {"wind.png", "lamp.png", "lamp.mp4"})
        lengths = subprocess.run(["ffprobe", "-v", "error", "-show_entries", "stream=duration", "-of", "csv=p=0",
                                  self.output / "lamp.mp4"], check=True, capture_output=True, text=True).stdout.split()
        self.assertEqual(len(lengths), 2)  # pictures and sound
        for length in lengths:
            self.assertAlmostEqual(float(length), 3, delta=0.05)


class Evolution(TimbreCase):
    def evolve(self, *arguments, ranks=None):
        job = program.idiophone("evolve", *arguments, ranks=ranks)
        self.require_status(job, program.FINISHED)
        return job.stdout + job.stderr

    def test_is_the_same_on_any_number_of_ranks(self):
        target = self.output / "sound.wav"
        sound = self.timbre(INPUTS / "wind.yaml", "--set", "duration=0.2")
        self.assertEqual(len(sound), 0.2 * RATE)
        texts = []
        for ranks in (1, 2):
            tree = self.output / f"tree{ranks}.tt"
            said = self.evolve(INPUTS / "bee.tt", INPUTS / "wind.tt", "--target", target, "-o", tree, "--population", 12,
                               "--generations", 4, ranks=ranks)
            distance, before = map(float, re.search(r"distance (\S+) dB, of the nearest ancestor (\S+) dB", said).groups())
            self.assertLessEqual(distance, before)
            texts.append(tree.read_text() + tree.with_suffix(".ancestry.csv").read_text())
        self.assertEqual(texts[0], texts[1])

    @program.long_verification
    def test_imitates_an_impact_of_table_1(self):
        """In short form; docs/use/timbre.md has the whole."""
        deck = program.SOURCE / "inputs/table1/fidelity/clamped_bar.yaml"
        job = program.idiophone("run", deck, "--output-folder", self.output, "--set", "time.duration=0.1", "--set",
                                "listeners={ear: {type: mono, position: [0.15, 0, 1]}}", "--set", "output.frames_per_second=0")
        self.require_status(job, program.FINISHED)
        job = program.idiophone("evolve", INPUTS / "four_sines.tt", "--target", self.output / "clamped_bar.wav", "-o",
                                self.output / "bar.tt", "--nodes", 30, "--population", 24, "--generations", 12, "--json")
        self.require_status(job, program.FINISHED)
        answer = json.loads(job.stdout)
        self.assertEqual(answer["tree"], str(self.output / "bar.tt"))
        self.assertLess(answer["distance"], 0.75 * answer["ancestor_distance"])

    def test_offers_sounds_on_a_page(self):
        page = self.output / "bees.html"
        self.evolve(INPUTS / "bee.tt", "--page", page, "--population", 5, "--duration", 0.2)
        text = page.read_text()
        offered = re.findall(r'value="(\S+\.tt)"', text)
        self.assertEqual(len(offered), 5)
        for name in offered:
            self.assertTrue((self.output / name).exists())
            self.assertEqual(len(scipy.io.wavfile.read((self.output / name).with_suffix(".wav"))[1]), 0.2 * RATE)
        self.evolve(self.output / offered[0], self.output / offered[3], "--page", self.output / "next.html",
                    "--population", 3, "--duration", 0.1, "--seed", 2)


if __name__ == "__main__":
    unittest.main()
