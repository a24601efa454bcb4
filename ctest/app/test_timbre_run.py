#!/usr/bin/python3
"""Timbre trees with bodies in them, and sonic scenes beside a run."""
import shutil
import signal
import subprocess
import unittest

import h5py
import numpy
import scipy.io.wavfile
import test_map

import program
from timbre_case import INPUTS, RATE, TimbreCase


class Bodies(TimbreCase):
    """Nodes of bodies that a force drives."""
    def render(self, tree, **keys):
        (self.output / "tree.tt").write_text(tree)
        settings = "".join(f"{key}: {value}\n" for key, value in keys.items())
        return self.timbre(self.scene(f"name: s\n{settings}classes: {{a: tree.tt}}\nsounds: {{a: {{class: a}}}}\n"))

    def test_a_sound_map_gives_the_sound_of_a_force(self):
        job = program.idiophone("map", program.deck("simple"), "--output-folder", self.output, "--modes", 12,
                                "--radiation", "kirchhoff")
        self.require_status(job, program.FINISHED)
        path = self.output / "simple_plate.map.h5"
        with h5py.File(path) as file:
            vertices = file["surface/vertices"][()]
        at = vertices[numpy.argmin(numpy.linalg.norm(vertices - [0.04, 0.03, 0.01], axis=1))].tolist()
        place = f"(vector {at[0]!r} {at[1]!r} {at[2]!r}) (vector 0 0 -1)"
        sound = self.render(f'(map "{path.name}" (timer 0 (/ 30 rate) (* rate time)) {place})', duration=4000 / RATE)
        expected = test_map.sound(path, at, numpy.concatenate([numpy.arange(30), numpy.zeros(3970)]))
        self.assertLess(numpy.linalg.norm(sound - expected), 1e-4 * numpy.linalg.norm(expected))

    def test_a_proxy_sounds_as_the_command_renders_it(self):
        (self.output / "score.yaml").write_text(
            "duration: 0.2\nevents: [{time: 0, type: force, at: [0.04, 0.03, 0.01], force: [0, 0, -1], shape: half_sine, "
            "duration: 0.0025}]\n")
        job = program.idiophone("proxies", program.deck("simple"), "--score", self.output / "score.yaml", "--set",
                                "audio.rate=44100", "--output", self.output / "proxy.wav")
        self.require_status(job, program.FINISHED)
        expected = scipy.io.wavfile.read(self.output / "proxy.wav")[1].astype(float)
        sound = self.render(f'(proxy "{program.deck("simple")}" "plate" (timer 0 0.0025 (sine 200))'
                            " (vector 0.04 0.03 0.01) (vector 0 0 -1))", duration=0.2)
        likeness = numpy.correlate(expected[:4000], sound[:4000], "full")
        delay = likeness.argmax() - 3999  # of the way to the listener, which the node does not have
        self.assertLess(abs(delay - 0.3 / 343 * 44100), 4)
        self.assertGreater(numpy.corrcoef(sound[:4000], expected[delay:delay + 4000])[0, 1], 0.99)

    def test_wrong_bodies_are_answered(self):
        (self.output / "tree.tt").write_text(
            f'(+ (map "no.h5" 1 (vector 0 0 0) (vector 0 0 -1))\n   (proxy "{program.deck("simple")}" "plait" 1 '
            "(vector 0 0 0) (vector 0 0 -1)))")
        scene = self.scene("name: s\nduration: 1\nclasses: {a: tree.tt}\nsounds: {a: {class: a}}\n")
        self.timbre(scene, status=program.WRONG_DECK)
        self.assertIn("tree.tt:1:4: ", self.said)
        (self.output / "tree.tt").write_text(
            f'(proxy "{program.deck("simple")}" "plait" 1 (vector 0 0 0) (vector 0 0 -1))')
        self.timbre(scene, status=program.WRONG_DECK)
        self.assertIn("tree.tt:1:1: there is no body 'plait' in the deck; it has: plate", self.said)


class BesideARun(TimbreCase):
    """`run --scene`: both sounds in the result."""
    def run_cubes(self, output, *arguments, status=program.FINISHED, **how):
        job = program.idiophone("run", INPUTS / "cubes_motion.yaml", "--output-folder", output, *arguments, **how)
        self.require_status(job, status)
        return job.stdout + job.stderr

    def test_has_both_sounds_on_any_ranks(self):
        self.run_cubes(self.output / "one", "--scene", INPUTS / "cubes.yaml")
        result = self.output / "one" / "cubes_motion.h5"
        with h5py.File(result) as file:
            self.assertEqual(set(file["audio"]), {"ears", "cubes_ears"})
            sound = file["audio/cubes_ears"][()]
            self.assertEqual(sound.shape, (2 * RATE, 2))
        rendered = self.timbre(INPUTS / "cubes.yaml", result)
        numpy.testing.assert_allclose(sound, rendered, atol=1e-6 * numpy.abs(rendered).max())
        rate, samples = scipy.io.wavfile.read(self.output / "one" / "cubes_motion_cubes_ears.wav")
        self.assertEqual((rate, samples.shape), (RATE, (2 * RATE, 2)))
        self.run_cubes(self.output / "two", "--scene", INPUTS / "cubes.yaml", ranks=2)
        self.require_same(self.output / "two" / "cubes_motion.h5", program.contents(result))

    def test_follows_how_a_body_deforms(self):
        """The strain of a plate that is plucked bends the pitch; in memory as from the result, on any ranks."""
        (self.output / "tree.tt").write_text("(parameter f) (sine f)")
        scene = self.scene("name: bent\nduration: 0.01\nclasses: {a: tree.tt}\nsounds: {a: {class: a, parameters: {f: "
                           "{channel: gauges/across/strain, scale: 1.0e8, offset: 1000, range: [100, 9000]}}}}\n")
        deck = ("--set", "gauges={across: {type: strain, points: [{at: [0, 0, 0.01]}, {at: [0.04, 0, 0.01]}]}}")
        for ranks in (1, 2):
            job = program.idiophone("run", program.deck("simple"), "--output-folder", self.output / str(ranks), "--scene", scene,
                                    *deck, ranks=ranks)
            self.require_status(job, program.FINISHED)
        result = self.output / "1" / "simple.h5"
        with h5py.File(result) as file:
            strain, sound = file["gauges/across/strain"][()], file["audio/bent"][()][:, 0]
        self.assertGreater(numpy.ptp(strain), 1e-9)
        rendered = self.timbre(scene, result)
        numpy.testing.assert_allclose(sound, rendered, atol=1e-6)
        self.assertGreater(numpy.abs(sound - numpy.sin(2 * numpy.pi * 1000 * numpy.arange(len(sound)) / RATE)).max(), 0.1)
        self.require_same(self.output / "2" / "simple.h5", program.contents(result))

    def test_a_resumed_run_has_the_same_sounds(self):
        shutil.copytree(INPUTS, self.output / "inputs")
        scene = self.output / "inputs" / "cubes.yaml"
        self.run_cubes(self.output / "one", "--scene", scene)
        stop = program.preload("BLOCK_SIGNAL", SIGNAL=int(signal.SIGTERM), SIGNAL_BLOCK=1, SIGNAL_RANK=0)
        said = self.run_cubes(self.output / "two", "--scene", scene, ranks=1, environment=stop, status=program.RESUMABLE)
        self.assertNotIn("sounds started", said)
        said = self.run_cubes(self.output / "two", "--resume", status=program.FAILED)
        self.assertIn("the text of the deck or of the sonic scene has changed", said)
        tree = self.output / "inputs" / "collision.tt"
        text = tree.read_text()
        tree.write_text(text + "; changed\n")
        self.run_cubes(self.output / "two", "--scene", scene, "--resume", status=program.FAILED)
        tree.write_text(text)
        said = self.run_cubes(self.output / "two", "--scene", scene, "--resume", ranks=2)
        self.assertIn("resuming from", said)
        self.require_same(self.output / "two" / "cubes_motion.h5", program.contents(self.output / "one" / "cubes_motion.h5"))
        wavs = [(self.output / folder / "cubes_motion_cubes_ears.wav").read_bytes() for folder in ("one", "two")]
        self.assertEqual(*wavs)

    def test_mistakes_are_found_before_the_motion_is_computed(self):
        text = (INPUTS / "cubes.yaml").read_text().replace("collision.tt", str(INPUTS / "collision.tt"))
        scene = self.scene(text.replace("name: hit, above: 1}   ", "name: hut, above: 1}   "))
        said = self.run_cubes(self.output / "one", "--scene", scene, status=program.WRONG_DECK)
        self.assertIn("scene.yaml:11:", said)
        self.assertIn("contacts/hit/force", said)
        self.assertNotIn("100.0 %", said)


class RunScript(TimbreCase):
    def test_passes_a_scene_on(self):
        """`scripts/run`, with programs in place of the others that only write down how they are called."""
        root = self.output / "tree"
        (root / "scripts").mkdir(parents=True)
        (root / "build/production").mkdir(parents=True)
        for name in ("run", "mpi_environment"):
            shutil.copy(program.SOURCE / "scripts" / name, root / "scripts")
        for name in ("scripts/build", "scripts/spectrum", "build/production/idiophone"):
            (root / name).write_text(f'#!/bin/sh\necho {name} "$@" >> {self.output}/calls\n')
            (root / name).chmod(0o755)
        deck = program.deck("simple")
        for arguments in (("--scene", "music.yaml"), ("--scene=music.yaml",)):
            (self.output / "calls").unlink(missing_ok=True)
            job = subprocess.run([root / "scripts/run", deck, "-n", "1", *arguments, "--output-folder=out"], capture_output=True,
                                 text=True, timeout=program.TIMEOUT)
            self.require_status(job, program.FINISHED)
            called = (self.output / "calls").read_text()
            self.assertIn(f"idiophone run {deck} --output-folder out --progress log {' '.join(arguments)}\n", called)
            self.assertIn("idiophone report out/simple.h5 -o out/simple.html", called)


if __name__ == "__main__":
    unittest.main()
