#!/usr/bin/python3
"""Selection by ear: the page of `idiophone evolve` plays its sounds in Chromium, and says how to breed the marked trees."""
import json
import os
import shlex
import subprocess
import unittest

import program
from web import MODULES, install_modules


class EvolvePage(program.TestCase):
    def evolve(self, *arguments):
        job = subprocess.run([program.PROGRAM, "evolve", *map(str, arguments), "--population", "4", "--duration", "0.2"],
                             capture_output=True, text=True, timeout=program.TIMEOUT, cwd=self.output)
        self.require_status(job, program.FINISHED)

    def look(self, page):
        install_modules()
        self.evolve(program.SOURCE / "inputs/timbre/bee.tt", "--page", page)
        answer = subprocess.run(["node", program.SOURCE / "ctest/web/evolve.mjs", self.output / page],
                                env={**os.environ, "WEB_MODULES": str(MODULES)}, capture_output=True, text=True,
                                timeout=program.TIMEOUT)
        self.require_status(answer, 0)
        return json.loads(answer.stdout)

    def test_its_name_is_only_a_name(self):
        for name in ("""x'; document.title = "ran"; '""", """a b"><img src=. onerror='document.title = "ran"'>#1%20"""):
            with self.subTest(name=name):
                seen = self.look(name + ".html")
                self.assertEqual((seen["title"], seen["complaints"], len(seen["durations"])), ("Timbre trees", [], 4))
                words = shlex.split(seen["command"])
                self.assertEqual(words[-4:-1], ["--page", f"./{name}_next.html", "--seed"])
                self.assertEqual(len(words), 8)
                for tree in words[2:4]:
                    self.assertTrue((self.output / tree).exists())

    def test_marked_trees_are_bred_again_by_its_command(self):
        seen = self.look("bees.html")
        self.assertEqual(seen["complaints"], [])
        self.assertEqual(seen["before"], "Mark at least one sound.")
        self.assertEqual(len(seen["durations"]), 4)
        for duration in seen["durations"]:
            self.assertAlmostEqual(duration, 0.2, delta=1e-3)
        name, command, *arguments = seen["command"].split()
        self.assertEqual((name, command), ("idiophone", "evolve"))
        self.evolve(*arguments)
        self.assertTrue((self.output / "bees_next.html").exists())


if __name__ == "__main__":
    unittest.main()
