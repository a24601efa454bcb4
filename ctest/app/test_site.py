#!/usr/bin/python3
"""tools/site: every page, link, player and search of the website of the documentation, on a desktop and on a phone."""
import shutil
import subprocess
import sys
import unittest

import numpy
from scipy.io import wavfile

import program
from web import in_browser

sys.path.insert(0, str(program.SOURCE / "scripts"))
from library.site import links, navigation, pages

EXPLORER = "<!DOCTYPE html><html lang=en><title>Explorer</title><p>room</p></html>"


class Site(program.TestCase):
    def make(self, *arguments, status=0):
        self.site = self.output / "site"
        job = subprocess.run([program.SOURCE / "tools/site", "--output-folder", self.site, *arguments],
                             capture_output=True, text=True, timeout=program.TIMEOUT)
        self.assertEqual(job.returncode, status, job.stdout + job.stderr)
        return job.stderr

    def gallery(self):
        """What scripts/gallery makes of two decks, without computing."""
        folder = self.output / "gallery"
        folder.mkdir()
        for name in ("gong", "coin"):
            shutil.copy(program.SOURCE / "docs/pictures/bowl.png", folder / f"{name}.png")
            wavfile.write(folder / f"{name}.wav", 8000, numpy.zeros(2000, numpy.float32))
            (folder / f"{name}.html").write_text(EXPLORER)
        return folder

    def test_reads_well_on_a_desktop_and_on_a_phone(self):
        explorer = self.output / "room.html"
        explorer.write_text(EXPLORER)
        self.make("--gallery", self.gallery(), "--explorer", explorer)
        sounds = (self.site / "sounds.html").read_text()
        self.assertLess(sounds.index("Gong"), sounds.index("Coin"))
        self.assertEqual((self.site / "explorer.html").read_text(), EXPLORER)
        for view in in_browser("site.mjs", self.site).values():
            self.assertEqual(view["complaints"], [])
            self.assertEqual(view["elsewhere"], [], "the website fetches from other hosts")
            self.assertEqual(view["wide"], [], "pages are wider than the window")
            self.assertEqual(view["players"], [0.25, 0.25])
            self.assertEqual(view["broken"], 0, "pictures are missing")
            self.assertTrue({"Theory", "Radiation models"} & set(view["found"]), view["found"])

    def test_the_menu_has_every_page_of_the_contents(self):
        menu = str(navigation.navigation((program.SOURCE / "docs/README.md").read_text()))
        for page in (program.SOURCE / "docs").rglob("*.md"):
            if page.name != "README.md":
                self.assertIn(str(page.relative_to(program.SOURCE)), menu)

    def test_links_that_lead_nowhere_are_named(self):
        (self.output / "there.html").write_text("<h1 id=here>There</h1>")
        (self.output / "page.html").write_text(
            '<a href="there.html#here">right</a><a href="https://elsewhere">right</a><a href="there.html#gone">section</a>'
            '<a href="gone.html">page</a><img src="gone.png"><script src="https://elsewhere/code.js"></script>')
        self.assertEqual(links.broken_links(self.output), [
            "page.html fetches https://elsewhere/code.js",
            "page.html links to there.html#gone, but there is no such section",
            "page.html links to gone.html, which does not exist",
            "page.html links to gone.png, which does not exist"])

    def test_pages_keep_their_links_but_those_to_folders(self):
        (self.output / "inputs").mkdir()
        (self.output / "inputs/bar.yaml").write_text("name: bar")
        (self.output / "README.md").write_text(
            "[deck](inputs/bar.yaml), [all decks](inputs), [`code`](other.md#part), [web](https://elsewhere)\n```\n[no](link.md)\n```\n")
        (self.output / "other.md").write_text("## Part\n")
        copies = self.output / "copies"
        self.assertEqual(pages.copy_pages(self.output, copies), ["README.md", "other.md"])
        self.assertEqual((copies / "README.md").read_text(),
                         "[deck](inputs/bar.yaml), all decks, [`code`](other.md#part), [web](https://elsewhere)\n```\n[no](link.md)\n```\n")
        self.assertTrue((copies / "inputs/bar.yaml").exists())


if __name__ == "__main__":
    unittest.main()
