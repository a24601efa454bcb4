"""The Blender add-on: a scene becomes a deck, and its result becomes keyframes and a speaker."""
import functools
import json
import math
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
DEBIAN = {**os.environ, "PATH": f"/usr/bin:{os.environ['PATH']}"}  # Blender takes the Python that it finds first


WITHOUT_A_WINDOW = ["blender", "--background"]
IN_A_WINDOW = ["xvfb-run", "--auto-servernum", "--server-args=-screen 0 400x300x24", "blender", "--window-geometry", "0", "0", "400", "300",
               "--enable-event-simulate"]


@functools.cache
def seen(script, *blender):
    """What a script saw in Blender."""
    with tempfile.TemporaryDirectory() as folder:
        job = subprocess.run([*blender, "--factory-startup", "--python-exit-code", "1", "--python", HERE / script, "--", folder],
                             capture_output=True, text=True, timeout=600, env=DEBIAN)
        assert job.returncode == 0, job.stdout + job.stderr
        return json.loads((pathlib.Path(folder) / "seen.json").read_text())


@unittest.skipUnless(shutil.which("blender"), "Blender is not installed: scripts/install_dependencies blender installs it")
class WithoutAWindow(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.seen = seen("fall.py", *WITHOUT_A_WINDOW)

    def test_a_scene_is_a_deck(self):
        deck = self.seen["deck"]
        self.assertEqual(sorted(deck["bodies"]), ["flyer", "lander"])
        self.assertEqual(deck["bodies"]["lander"]["model"], {"type": "modal", "up_to": 7000.0})
        self.assertNotIn("velocity", deck["bodies"]["lander"])
        self.assertEqual(deck["materials"]["lander"]["from"], "glass")
        self.assertAlmostEqual(deck["materials"]["flyer"]["young"], 60e9, delta=1e4)
        self.assertEqual(deck["obstacles"]["floor"], {"shape": "half_space", "at": [0, 0, 0], "direction": [0, 0, 1]})
        self.assertEqual(deck["obstacles"]["wall"]["shape"], "box")
        self.assertAlmostEqual(deck["obstacles"]["wall"]["size"][2], 2, delta=1e-6)
        self.assertEqual(len(deck["contacts"]), 5)
        self.assertAlmostEqual(deck["contacts"]["lander-floor"]["friction"], 0.5 * 0.4, delta=1e-6)

    def test_a_free_body_flies_on_as_it_was_thrown(self):
        """x = v t, z = z0 - g t^2 / 2, and a turn about a principal axis at a constant rate."""
        for frame, (place, angle) in enumerate(zip(self.seen["places"], self.seen["angles"])):
            time = frame / 24
            expected = (0.5 + 1.2 * time, 0.5, 1 - 9.81 * time ** 2 / 2)
            for found, exact in zip(place, expected):
                self.assertAlmostEqual(found, exact, delta=2e-4)
            self.assertAlmostEqual(angle, 2.4 * time, delta=2e-3)

    def test_the_sound_is_a_speaker_at_its_distance(self):
        speaker = self.seen["speaker"]
        self.assertAlmostEqual(speaker["reference"], speaker["distance"], delta=1e-6)
        self.assertEqual(speaker["begin"], 1)
        self.assertEqual(speaker["file"], "Scene.wav")
        self.assertEqual(self.seen["speakers"], 1)  # also after a second sound

    def test_finite_elements_land_and_sound(self):
        landed = self.seen["finite_elements"]
        self.assertNotIn("model", landed["body"])
        self.assertTrue(0.0035 < landed["height"] < 0.005, landed)  # of the middle of a bar that is 8 mm thick; it began at 5 mm
        self.assertGreater(landed["pressure"], 0.01)

    def test_mistakes_are_said(self):
        self.assertIn("no camera", self.seen["without_camera"])
        self.assertIn("No object sounds", self.seen["without_bodies"])
        self.assertIn("not saved yet", self.seen["unsaved"])
        self.assertIn("has no modes up to", self.seen["too_stiff"])

    def test_keyframes_turn_as_the_points_do(self):
        self.assertLess(self.seen["kabsch_error"], 1e-12)
        self.assertTrue(math.isclose(self.seen["kabsch_determinant"], 1, abs_tol=1e-12))


@unittest.skipUnless(shutil.which("blender") and shutil.which("Xvfb"), "Blender or Xvfb is not installed")
class InAWindow(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.seen = seen("window.py", *IN_A_WINDOW)
        assert cls.seen["failures"] == [], "".join(cls.seen["failures"])

    def test_blender_goes_on_while_the_same_result_is_computed(self):
        without = seen("fall.py", *WITHOUT_A_WINDOW)
        self.assertEqual((self.seen["invoked"], self.seen["ended"]), ("RUNNING_MODAL", "FINISHED"))
        self.assertGreater(self.seen["steps_meanwhile"], 1)
        self.assertEqual(self.seen["sound"], without["sound"])
        self.assertEqual(self.seen["place"], without["places"][2])

    def test_escape_cancels(self):
        self.assertEqual(self.seen["cancelled"], "CANCELLED")
        self.assertEqual(self.seen["place_after_cancelling"], self.seen["place"])


if __name__ == "__main__":
    unittest.main()
