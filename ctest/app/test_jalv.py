#!/usr/bin/python3
"""The LV2 plugin in jalv, a host, on a JACK server without a sound card: a preset of a map, and a key that is heard."""
import os
import pathlib
import runpy
import shutil
import subprocess
import sys
import time
import unittest

import numpy

import jack_server
import program

SCRIPTS = program.SOURCE / "scripts"
sys.path.insert(0, str(SCRIPTS))
PRESETS = runpy.run_path(str(SCRIPTS / "plugin_presets"))
GALLERY = program.SOURCE / "inputs/gallery"
TOOLS = ("jalv", "jackd", "jack_lsp", "jack_midiseq", "jack_rec")


def samples(path):
    """Of a WAV file of 16 bits."""
    raw = path.read_bytes()
    start = raw.index(b"data") + 8
    return numpy.frombuffer(raw[start:start + (len(raw) - start) // 2 * 2], dtype="<i2")


class Presets(unittest.TestCase):
    def test_there_is_one_for_each_body_of_the_gallery_with_modes(self):
        names = {deck.stem for deck in GALLERY.glob("*.yaml")}
        self.assertEqual(names - set(PRESETS["PLACES"]), {"gong"})  # its partials move with its amplitude


@unittest.skipIf(program.SANITIZED, "jalv has no sanitizers, so it can't load the plugin")
@unittest.skipIf(any(shutil.which(tool) is None for tool in TOOLS), f"needs {', '.join(TOOLS)}")
class Jalv(program.TestCase):
    def setUp(self):
        super().setUp()
        self.server, self.environment = jack_server.start(self, 256)
        bundles = pathlib.Path(os.environ["IDIOPHONE_LV2"])
        self.environment["LV2_PATH"] = f"{bundles}:{self.output}"

    def make_preset(self):
        """A preset as scripts/plugin_presets makes it, of a small plate."""
        bundle = self.output / "presets.lv2"
        job = program.idiophone("map", program.deck("simple"), "--modes", 10, "--radiation", "kirchhoff",
                                "--output-folder", bundle / "maps")
        self.require_status(job, program.FINISHED)
        map_file, = (bundle / "maps").glob("*.map.h5")
        (bundle / "coin.ttl").write_text(PRESETS["PREFIXES"] + PRESETS["preset"]("coin", [map_file.name]))
        (bundle / "manifest.ttl").write_text(PRESETS["PREFIXES"] + PRESETS["manifest"](["coin"]))

    def start(self, *command):
        process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                   env=self.environment)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        return process

    def wait_for_ports(self, *ports):
        for _ in range(100):
            if set(ports) <= set(subprocess.run(["jack_lsp"], capture_output=True, text=True, env=self.environment).stdout.split("\n")):
                return
            time.sleep(0.1)
        self.fail(f"there are no ports {ports}")

    def recording(self):
        path = self.output / "sound.wav"
        subprocess.run(["jack_rec", "-f", path, "-d", "1", "-b", "16", "jalv:left", "jalv:right"], check=True, timeout=60,
                       env=self.environment, capture_output=True)
        return samples(path)

    def test_a_preset_sounds_when_a_key_is_struck(self):
        self.make_preset()
        host = self.start("jalv", "-n", "jalv", "urn:idiophone:plugin")
        self.start("jack_midiseq", "keys", "12000", "0", "60", "6000")
        self.wait_for_ports("jalv:left", "jalv:right", "keys:out")
        subprocess.run(["jack_connect", "keys:out", "jalv:events_in"], check=True, env=self.environment)
        self.assertFalse(self.recording().any())
        host.stdin.write("presets\npreset urn:idiophone:plugin:coin\n")
        host.stdin.flush()
        for _ in range(20):
            if self.recording().any():
                return
        self.fail("no key is heard")


if __name__ == "__main__":
    unittest.main()
