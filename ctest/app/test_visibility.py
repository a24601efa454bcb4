#!/usr/bin/python3
"""Bodies and obstacles cast shadows, which come and go without clicks."""
import unittest

import h5py
import numpy

import program

RATE = 8000  # audio samples per second of the decks here


class Visibility(program.TestCase):
    def sound(self, deck, *settings):
        """What the deck's only listener hears, and what the program said."""
        arguments = [word for text in settings for word in ("--set", text)]
        job = program.run(deck, self.output, *arguments)
        self.require_status(job, program.FINISHED)
        with h5py.File(self.output / f"{deck}.h5") as file:
            return next(iter(file["audio"].values()))[:, 0], job.stdout

    def test_a_wall_silences(self):
        wall = "obstacles.wall={shape: box, at: [0, 0, 0.7], size: [4, 4, 0.1]}", "contacts.bump.between=[bar, wall]"
        silent, _ = self.sound("shadow", *wall)
        loud, _ = self.sound("shadow", *wall, "radiation.visibility=off")
        self.assertGreater(abs(loud).max(), 0)
        self.assertEqual(abs(silent).max(), 0)

    def test_a_floor_silences_what_is_behind_it(self):
        floor = "obstacles.floor={shape: half_space, at: [0, 0, 0.7]}", "contacts.bump.between=[bar, floor]"
        silent, said = self.sound("shadow", *floor, "contacts.bump.stiffness=1")
        self.assertEqual(abs(silent).max(), 0)
        self.assertNotIn("hears nothing", said)
        silent, said = self.sound("shadow", *floor, "obstacles.floor.direction=[0, 0, -1]")
        self.assertEqual(abs(silent).max(), 0)
        self.assertIn("listener ear: it is inside the obstacle floor and hears nothing", said)

    def test_what_stands_between_silences_bodies_that_do_not_shade_themselves(self):
        kirchhoff = "radiation.model=kirchhoff"
        floor = "obstacles.floor={shape: half_space, at: [0, 0, 0.7]}", "contacts.bump.between=[bar, floor]"
        wall = "obstacles.wall={shape: box, at: [0, 0, 0.7], size: [4, 4, 0.1]}", "contacts.bump.between=[bar, wall]"
        for between in (*floor, "contacts.bump.stiffness=1"), wall:
            for bodies in (), ("bodies.board=null", "time.steps_per_sample=20"):
                silent, _ = self.sound("shadow", kirchhoff, *between, *bodies)
                self.assertEqual(abs(silent).max(), 0, f"{between} {bodies}")
        faded, _ = self.sound("shadow", kirchhoff, "radiation.visibility.rate=200")
        free, _ = self.sound("shadow", kirchhoff, "radiation.visibility=off")
        board = slice(int(0.036 * RATE), int(0.045 * RATE))  # see test_a_passing_board_fades_the_sound_out_and_in
        self.assertLess(abs(faded[board]).max(), 0.1 * abs(free[board]).max())

    def test_one_body_alone_sounds_as_without(self):
        kirchhoff = "radiation.model=kirchhoff"
        seen, _ = self.sound("simple", kirchhoff)
        free, _ = self.sound("simple", kirchhoff, "radiation.visibility=off")
        self.assertGreater(abs(free).max(), 0)
        self.assertEqual(abs(seen - free).max(), 0)

    def test_a_passing_board_fades_the_sound_out_and_in(self):
        interval = RATE // 200
        faded, _ = self.sound("shadow", "radiation.visibility.rate=200")
        free, _ = self.sound("shadow", "radiation.visibility=off")
        # Over the bar from 16 to 38 ms, wholly from 18 to 36 ms. Looks at 20 and 40 ms see the change, which fades in
        # from 25 to 30 and from 45 to 50 ms. The sound travels for 3 ms.
        at = lambda milliseconds: int(milliseconds * RATE / 1000)
        shadow = slice(at(34), at(47))
        self.assertGreater(abs(free[shadow]).max(), 0.5 * abs(free).max())
        self.assertLess(abs(faded[shadow]).max(), 1e-6 * abs(free).max())
        for light in slice(0, at(27)), slice(at(54), None):
            self.assertLess(abs(faded - free)[light].max(), 1e-6 * abs(free).max())
        steepest = abs(numpy.diff(free)).max() + abs(free).max() / interval
        self.assertLess(abs(numpy.diff(faded)).max(), 1.01 * steepest)

    def test_a_convex_body_sounds_as_without(self):
        for deck in "simple", "free":  # a plate seen from above; a ball that tumbles
            settings = () if deck == "simple" else ("bodies.ball.spin=[50, 70, 0]", "bodies.ball.velocity=[1, 0, 0]")
            with self.subTest(deck=deck):
                seen, _ = self.sound(deck, *settings)
                free, _ = self.sound(deck, *settings, "radiation.visibility=off")
                self.assertGreater(abs(free).max(), 0)
                self.assertLess(abs(seen - free).max(), 1e-9 * abs(free).max())


if __name__ == "__main__":
    unittest.main()
