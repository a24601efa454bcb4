#!/usr/bin/python3
"""What `cmake --install` puts in place works from there, and says the same of itself everywhere."""
import os
import pathlib
import re
import subprocess
import unittest

import program
import scipy.io.wavfile

BUILD = pathlib.Path(os.environ["IDIOPHONE_BUILD"])


class Install(program.TestCase):
    def setUp(self):
        super().setUp()
        self.prefix = self.output / "prefix"
        subprocess.run(["cmake", "--install", BUILD, "--prefix", self.prefix], check=True, stdout=subprocess.DEVNULL)
        self.share = self.prefix / "share/idiophone"

    def call(self, *command):
        done = subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=program.TIMEOUT)
        self.require_status(done, program.FINISHED)
        return done.stdout

    def man_page(self):
        return (self.prefix / "share/man/man1/idiophone.1").read_text().replace("\\-", "-")

    def test_computes_a_deck_and_draws_its_spectrum(self):
        coarse = "--set", "time.duration=0.003", "--set", "bodies.bar.parameters.size=0.05"
        self.call(self.prefix / "bin/idiophone", "run", self.share / "inputs/clamped_bar.yaml", "--output-folder", self.output,
                  *coarse)
        self.call(self.share / "scripts/spectrum", self.output / "clamped_bar.h5", "-o", self.output / "spectrum.png")
        self.assertGreater((self.output / "spectrum.png").stat().st_size, 0)

    def test_python_finds_the_installed_program(self):
        code = "import idiophone.program; print(idiophone.program.path_of_program())"
        place = {**os.environ, "PYTHONPATH": str(self.prefix / "lib/python3/dist-packages"), "IDIOPHONE": ""}
        done = subprocess.run(["/usr/bin/python3", "-c", code], env=place, capture_output=True, text=True)
        self.require_status(done, program.FINISHED)
        self.assertEqual(done.stdout.strip(), str(self.prefix / "bin/idiophone"))

    def test_has_the_mesh_of_every_deck(self):
        decks = list(self.share.glob("inputs/**/*.yaml"))
        self.assertEqual(len(decks), len(list(program.SOURCE.glob("inputs/**/*.yaml"))))
        for deck in decks:
            for mesh in re.findall(r"mesh: ([^\s,}]+)", deck.read_text()):
                self.assertTrue((deck.parent / mesh).is_file(), f"{deck}: {mesh}")

    def test_scripts_have_what_they_import(self):
        for script in ("spectrum", "spectrogram", "blows_figure", "score_figure", "sound_map_figure", "polar", "figure", "movie",
                       "mesh_sequence", "gallery", "timbre_examples"):
            self.call(self.share / "scripts" / script, "--help")

    def test_scripts_find_the_installed_program(self):
        self.call(self.share / "scripts/timbre_examples", "--output-folder", self.output / "examples", "wind")
        self.assertTrue((self.output / "examples/wind.png").exists())

    def test_documentation_refers_to_what_is_there(self):
        in_source_only = re.search(r"The documentation also names(.*?)These", (self.share / "docs/use/install.md").read_text(),
                                   re.DOTALL).group(1)
        pages = list(self.share.rglob("*.md"))
        self.assertGreater(len(pages), 40)
        for page in pages:
            text = re.sub(r"```.*?```", "", page.read_text(), flags=re.DOTALL)
            for link in re.findall(r"\]\(([^)#\s]+)", text):
                self.assertTrue(re.match(r"\w+:", link) or (page.parent / link).exists(), f"{page}: {link}")
            if page.name not in ("CONTRIBUTING.md", "CHANGELOG.md"):
                for script in re.findall(r"`(scripts/[\w/]+(?:\.\w+)?)", page.read_text()):
                    is_known = (self.share / script).exists() or any(
                        script.startswith(name) for name in re.findall(r"`(scripts/[\w/]+)`", in_source_only))
                    self.assertTrue(is_known, f"{page}: {script}")

    def test_man_page_has_every_command_and_option(self):
        page = self.man_page()
        text = self.call(program.PROGRAM, "--help")
        commands = re.findall(r"^  (\w+)  ", text[text.index("\nSubcommands:"):], re.MULTILINE)
        self.assertIn("run", commands)
        for command in commands:
            section = page[page.index(f".SS {command}\n"):].partition("\n.S")[0]
            for option in set(re.findall(r"^  (?:-\w,)?(--[\w-]+)", self.call(program.PROGRAM, command, "--help"),
                                         re.MULTILINE)) - {"--help"}:
                self.assertRegex(section, rf"(?m)^\.B (-\w,)?{option}\b", f"{command} {option}")
        self.assertEqual(subprocess.run(["man", "--warnings", "-l", self.prefix / "share/man/man1/idiophone.1"],
                                        capture_output=True, text=True).stderr, "")

    def build_example(self, name):
        """Builds an example with the installed libraries. Returns the program."""
        build = self.output / name
        self.call("cmake", "-S", program.SOURCE / "examples" / name, "-B", build, "-DCMAKE_BUILD_TYPE=Release",
                  f"-DCMAKE_PREFIX_PATH={self.prefix}", *program.SANITIZED_BUILD)
        self.call("cmake", "--build", build)
        return build / name

    def test_library_of_proxies_builds_the_example(self):
        self.assertRegex(self.call(self.build_example("falling_bodies"), self.output / "sound.wav", "1"),
                         r"[1-9]\d* choices of levels, 0 forces left out")
        self.assertGreater((self.output / "sound.wav").stat().st_size, 4 * 44100)

    def test_library_of_voices_builds_the_example(self):
        deck, voice = self.output / "ideal.yaml", self.output / "bar.voice"
        deck.write_text("name: ideal\nlisteners: {ear: {type: mono, position: [0, 0, 1]}}\nideal_bodies:\n  bar: {type: bar, length: 0.3,"
                        " width: 0.03, stiffness: 50, density: 1.1, friction: 0.002, ends: free}\n")
        self.call(program.PROGRAM, "map", deck, "--modes", 12, "--output-folder", self.output)
        self.call(program.PROGRAM, "export", self.output / "ideal_bar.map.h5", "--voice", voice)
        proxy = self.output / "plate.proxy"
        self.call(program.PROGRAM, "export", program.deck("simple"), "--proxy", proxy, "--levels", 2)
        said = self.call(BUILD / "ctest/voices_in_c", voice, proxy)
        power = re.match(r"2 impacts, 1 strokes, (\S+), (\S+); a step takes 1e-5 to 1 s", said)
        self.assertGreater(float(power[1]), 0)
        self.assertGreater(float(power[2]), 2 * float(power[1]), "the proxy sounds, too")
        bodies = self.build_example("many_bodies")
        said = self.call(bodies, self.output / "pit.wav", "6", "2", "2", voice, proxy).splitlines()
        self.assertEqual(len(said), 3)
        impacts, left_out = map(int, said[-1].split()[-2:])
        self.assertGreater(impacts, 5)
        self.assertEqual(left_out, 0)
        sound = scipy.io.wavfile.read(self.output / "pit.wav")[1]
        self.assertEqual(sound.shape, (2 * 48000, 2))
        self.assertGreater(abs(sound).max(), 0)
        libraries = self.call("ldd", self.prefix / "lib/libidiophone_voices.so") + self.call("ldd", bodies)
        self.assertNotRegex(libraries, "libmpi|libhdf5|libpetsc|libfftw|libfmt|libyaml")

    def test_library_of_timbre_trees_builds_the_example(self):
        lamp = self.build_example("creaking_lamp")
        tree = program.SOURCE / "examples/creaking_lamp/knock.tt"
        said = self.call(lamp, tree, self.output / "lamp.wav", "2")
        self.assertRegex(said, r"^1 landings, [5-9] notes, 0\.\d\d m from the start$")
        sound = scipy.io.wavfile.read(self.output / "lamp.wav")[1]
        self.assertEqual(len(sound), 2 * 44100)
        self.assertGreater(abs(sound[22050:35280]).max(), 0.02)  # it squeaks while it crouches
        landing = abs(sound[44100:61740]).max()
        self.assertGreater(landing, 1.5 * abs(sound[:44100]).max())
        self.assertLess(abs(sound).max(), 1.0)
        libraries = self.call("ldd", lamp)
        self.assertNotRegex(libraries, "libmpi|libhdf5|libpetsc")
        self.assertIn("libsamplerate", libraries)

    def test_says_the_same_version_everywhere(self):
        version = self.call(program.PROGRAM, "--version").strip()
        self.assertIn(f"idiophone {version}", self.man_page())
        self.assertIn(f"\nversion: {version}\n", (program.SOURCE / "CITATION.cff").read_text())
        newest = re.search(r"^## (\S+) \((\S+)\)$", (program.SOURCE / "CHANGELOG.md").read_text(), re.MULTILINE)
        self.assertEqual(newest[1], version)
        self.assertIn(f"\ndate-released: {newest[2]}\n", (program.SOURCE / "CITATION.cff").read_text())


if __name__ == "__main__":
    unittest.main()
