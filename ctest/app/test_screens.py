#!/usr/bin/python3
"""Sound bends around the edges of screens: against the exact field of a point source beside a rigid half-plane."""
import unittest

import h5py
import numpy

import program
from test_listen import sphere

SPEED, RATE = 343.0, 44100
FREQUENCIES = 63, 125, 250, 500, 1000, 2000, 4000, 8000  # Hz
SCREEN = "{wall: {corners: [[0, -60, 0], [0, 60, 0], [0, 60, -120], [0, -60, -120]]}}"  # its upper edge is the y axis


def place(radius, angle, along=0.0):
    """A point by its distance from the edge (m), its angle from the screen (degrees) and its place along the edge (m)."""
    return [-radius * numpy.sin(numpy.radians(angle)), along, -radius * numpy.cos(numpy.radians(angle))]


def edge_wave(frequency, detoured, distance):
    """Of a unit point source at `distance`: the Fourier transform of Friedlander's response, along the path of steepest
    descent x = detoured - i u^2."""
    wave_number = 2 * numpy.pi * frequency / SPEED
    u = numpy.linspace(0, numpy.sqrt(40 / wave_number), 20001)
    x = detoured - 1j * u**2
    values = numpy.exp(-wave_number * u**2) / ((x**2 - distance**2) * numpy.sqrt(x + detoured)) * -2j / numpy.sqrt(-1j)
    integral = (u[1] - u[0]) * (values.sum() - (values[0] + values[-1]) / 2)
    return numpy.sqrt(detoured**2 - distance**2) / numpy.pi * integral * numpy.exp(-1j * wave_number * detoured)


def half_plane(frequency, source, receiver):
    """Sound pressure behind the half-plane z < 0 of the plane x = 0, over that without it."""
    detoured = numpy.hypot(numpy.hypot(*source[::2]) + numpy.hypot(*receiver[::2]), source[1] - receiver[1])
    distance = numpy.linalg.norm(numpy.subtract(source, receiver))
    mirrored = numpy.linalg.norm(numpy.subtract([-source[0], *source[1:]], receiver))
    free = numpy.exp(-2j * numpy.pi * frequency / SPEED * distance) / distance
    height = (source[2] * receiver[0] - receiver[2] * source[0]) / (receiver[0] - source[0])  # where the ray crosses it
    direct = edge_wave(frequency, detoured, distance)
    mirror = edge_wave(frequency, detoured, mirrored)
    return (free - direct + mirror if height > 0 else direct + mirror) / free


class Heard(program.TestCase):
    """A sphere that pulsates beside something, and microphones."""
    def record(self, source, pressure, obstacle=None):
        """A sphere of 1 cm, here by its pressure (Pa) alone.

        :param obstacle: corners of triangles [n x 3 x 3], m
        """
        points, triangles = sphere(1)
        rows = len(pressure)
        with h5py.File(self.output / "source_surface.h5", "w") as file:
            file.attrs.update({"format": "idiophone surface motion", "format_version": 1, "rate": RATE})
            file["triangles"] = triangles
            file["position"] = numpy.broadcast_to(source + 0.01 * points, (rows, *points.shape))
            file["pressure"] = numpy.broadcast_to(numpy.asarray(pressure)[:, None], (rows, len(triangles)))
            if obstacle is not None:
                file["obstacles/triangles"] = numpy.ravel(obstacle)

    def hear(self, listeners, radiation, *settings, status=program.FINISHED, ranks=1):
        """The sound of each listener; what was said instead if the program is to fail."""
        deck = self.output / "ears.yaml"
        deck.write_text(f"name: heard\nlisteners:\n{listeners}audio: {{dc_block: 0}}\nradiation: {radiation}\n")
        words = [word for setting in settings for word in ("--set", setting)]
        job = program.idiophone("listen", self.output / "source_surface.h5", deck, *words, "--output-folder", self.output,
                                ranks=ranks)
        self.require_status(job, status)
        if status != program.FINISHED:
            return job.stderr
        with h5py.File(self.output / "heard.h5") as file:
            return {name: file["audio"][name][:, 0] for name in file["audio"]}

    @staticmethod
    def microphones(places):
        return "".join(f"  m{i}: {{type: mono, position: {[float(x) for x in at]}}}\n" for i, at in enumerate(places))



class Screens(Heard):
    def listen(self, listeners, *settings, screens=SCREEN, status=program.FINISHED, ranks=1):
        return self.hear(listeners, f"{{screens: {screens}}}", *settings, status=status, ranks=ranks)

    def check_levels(self, source, places):
        time = numpy.arange(4000) / RATE
        self.record(source, numpy.exp(-(((time - 2e-3) / 3e-5)**2)))
        behind = self.listen(self.microphones(places))
        free = self.listen(self.microphones(places), screens="{}")
        errors = []
        samples = min(len(behind["m0"]), len(free["m0"]))
        for i, at in enumerate(places):
            for frequency in FREQUENCIES:
                phases = numpy.exp(-2j * numpy.pi * frequency / RATE * numpy.arange(samples))
                found = abs(phases @ behind[f"m{i}"][:samples]) / abs(phases @ free[f"m{i}"][:samples])
                errors.append(20 * numpy.log10(found / abs(half_plane(frequency, source, at))))
        self.assertLess(numpy.abs(errors).max(), 1.0)

    def test_behind_a_screen_levels_are_those_of_the_exact_solution(self):
        for source_at in ((1.0, 30.0), (2.0, 60.0), (0.5, 100.0)) if program.LONG else ((2.0, 60.0),):
            with self.subTest(source=source_at):
                source = place(*source_at)
                shadow = 180 + source_at[1]  # begins here
                places = [place(radius, shadow + beyond, along) for radius, along in ((0.7, 0.0), (3.0, 1.5))
                          for beyond in (1, 10, 30, 70) if shadow + beyond < 355]
                self.check_levels(source, places)

    def test_levels_are_continuous_where_the_shadow_begins(self):
        self.check_levels(place(1.0, 60.0), [place(2.0, 240 + beyond) for beyond in (-2, -0.5, -0.1, 0.1, 0.5, 2)])

    def test_a_listener_that_moves_into_the_shadow_hears_no_click(self):
        time = numpy.arange(20000) / RATE
        rise = numpy.minimum(1, time / 0.02)
        self.record(place(1.0, 60.0), numpy.sin(2 * numpy.pi * 500 * time) * numpy.sin(rise * numpy.pi / 2)**2)
        walk = [[0.0, *place(1.0, 200)], [0.5, *place(1.0, 280)]]
        ear = f"  ear: {{type: mono, path: {[[float(x) for x in row] for row in walk]}}}\n"
        sound = self.listen(ear)["ear"][4000:18000]
        window = numpy.blackman(len(sound))
        spectrum = abs(numpy.fft.rfft(sound * window))
        frequency = numpy.fft.rfftfreq(len(sound), 1 / RATE)
        self.assertLess(spectrum[frequency > 1500].max(), 1e-3 * spectrum.max())
        quiet = [numpy.sqrt(numpy.mean(part**2)) for part in numpy.array_split(sound, 40)]
        self.assertLess(numpy.abs(numpy.diff(20 * numpy.log10(quiet))).max(), 1.5)

    def test_any_number_of_ranks_hears_the_same_bits(self):
        self.record(place(1.0, 30.0), numpy.sin(numpy.arange(1000)))
        places = self.microphones([place(1.0, 205), place(1.0, 250, 0.5)])
        alone = self.listen(places, "radiation.air.absorption=true")
        self.assertGreater(abs(alone["m1"]).max(), 0)
        for ranks in program.OTHER_RANKS:
            found = self.listen(places, "radiation.air.absorption=true", ranks=ranks)
            for name, sound in alone.items():
                self.assertEqual(found[name].tobytes(), sound.tobytes())

    @program.long_verification
    def test_a_resumed_run_hears_the_same_bits(self):
        screen = "--set", "radiation.screens={roof: {corners: [[-0.1, -5, 0.15], [-0.1, 5, 0.15], [5, 5, 0.15], [5, -5, 0.15]]}}"
        self.require_status(program.run("simple", self.output / "whole", *screen), program.FINISHED)
        self.assertGreater(self.run_in_jobs("simple", self.output / "parts", *screen, ranks=4 * (3, 1, 2)), 2)
        whole, parts = (program.contents(self.output / name / "simple.h5") for name in ("whole", "parts"))
        self.assertGreater(abs(whole["audio/ear"]).max(), 0)
        self.assertEqual(parts["audio/ear"].tobytes(), whole["audio/ear"].tobytes())

    def test_a_floor_is_a_mirror(self):
        """A wall on a floor is heard as the wall and its image are, at the listener and at its image together. In a room, no
        way is reflected twice."""
        self.record([-0.8, 0.1, 0.5], numpy.exp(-(((numpy.arange(1500) - 90) / 3)**2)))
        places = [1.0, 0.2, 0.4], [0.5, 0.0, 0.3], [1.5, 0.3, 1.6]
        wall = "{{wall: {{corners: [[0, -3, {0}], [0, 3, {0}], [0, 3, 1], [0, -3, 1]]}}}}"
        images = [place * numpy.array([1, 1, -1]) for place in places]
        doubled = self.listen(self.microphones([*places, *images]), screens=wall.format(-1))
        open_walls = "left: 1, right: 1, front: 1, back: 1, ceiling: 1"
        room = f"{{size: [40, 40, 20], corner: [-20, -20, 0], absorption: {{floor: 0, {open_walls}}}, images: 1, late: false}}"
        deep = self.listen(self.microphones(places), screens=wall.format(-50))  # no way below it in time
        for mirror, direct in ("radiation.floor={at: [0, 0, 0]}", doubled), (f"radiation.room={room}", deep):
            found = self.listen(self.microphones(places), mirror, screens=wall.format(0))
            for i in range(len(places)):
                expected = direct[f"m{i}"][:1400] + doubled[f"m{i + len(places)}"][:1400]
                self.assertGreater(abs(expected).max(), 0)
                self.assertLess(abs(found[f"m{i}"][:1400] - expected).max(), 1e-3 * abs(expected).max(), mirror)

    def test_a_screen_blocks_reflections_in_a_room(self):
        self.record([1, 2, 1], numpy.exp(-(((numpy.arange(2500) - 90) / 3)**2)))
        room = "radiation.room={size: [4, 4, 3], absorption: 0.1, images: 2, late: false}"
        place = self.microphones([[3.3, 2.4, 1.2]])
        wall = "{{wall: {{corners: [[2, 0, 0], [2, 4, 0], [2, 4, {0}], [2, 0, {0}]]}}}}"
        open_room, half, full = (self.listen(place, room, screens=screens)["m0"]
                                 for screens in ("{}", wall.format(1.5), wall.format(3)))
        self.assertLess(numpy.sum(half**2), 0.5 * numpy.sum(open_room**2))
        self.assertGreater(numpy.sum(half**2), 0.01 * numpy.sum(open_room**2))
        self.assertLess(abs(full).max(), 1e-6 * abs(open_room).max())

    def test_wrong_screens_are_named(self):
        self.record(place(1.0, 30.0), numpy.zeros(100))
        ear = self.microphones([place(1.0, 205)])

        def answer(*settings, screens=SCREEN):
            return self.listen(ear, *settings, screens=screens, status=program.WRONG_DECK)

        self.assertIn("at least three corners", answer(screens="{wall: {corners: [[0, 0, 0], [1, 0, 0]]}}"))
        self.assertIn("no area", answer(screens="{wall: {corners: [[0, 0, 0], [1, 0, 0], [2, 0, 0]]}}"))
        self.assertIn("not in one plane",
                      answer(screens="{wall: {corners: [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.1]]}}"))
        self.assertIn("not convex at corner 4",
                      answer(screens="{wall: {corners: [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0.9, 0.1, 0]]}}"))
        self.assertIn("radiation.screens: screens need visibility", answer("radiation.visibility=off"))
        self.assertIn("waves bend around bodies by themselves", answer("radiation.model=waves", "radiation.cell=0.1"))


if __name__ == "__main__":
    unittest.main()
