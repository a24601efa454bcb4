#!/usr/bin/python3
"""What the documentation refers to exists: files, links, sections, and pages that the code cites."""

import re
import unittest
from pathlib import Path

HOME = Path(__file__).resolve().parents[2]
PAGES = [HOME / "README.md", HOME / "CONTRIBUTING.md", *sorted((HOME / "docs").rglob("*.md"))]
FOLDERS = ["benchmarks", "cmake", "ctest", "docs", "examples", "include", "inputs", "meshes", "packaging", "python", "scripts", "src",
           "tools", "verification"]
PATH = re.compile(rf"(?<![\w/.-])(?:{'|'.join(FOLDERS)})/[\w.<>*/-]*[\w>*/]")
FILE_NAME = re.compile(r"`(\w+\.(?:hpp|cpp|geo))`")
LINK = re.compile(r"\]\(([^)\s]+)\)")
CITATION = re.compile(r"docs/([\w/]+)\.md(?:, ([A-Z][A-Za-z ]*))?")


def without_code(text):
    return re.sub(r"```.*?```", "", text, flags=re.DOTALL)


def headings(text):
    return re.findall(r"^#+ (.*)$", without_code(text), flags=re.MULTILINE)


def anchor(heading):
    """The name by which a link refers to a heading."""
    return re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-")


def exists(path):
    """Whether there is such a file; words in capitals, `<...>` and `*` stand for any name."""
    pattern = re.sub(r"<[^>]*>|\*+|\b[A-Z]+\b", "*", path).rstrip("/")
    return any(HOME.glob(pattern))


class Documentation(unittest.TestCase):
    def test_names_paths_that_exist(self):
        for page in PAGES:
            for path in PATH.findall(page.read_text()):
                self.assertTrue(exists(path), f"{page.relative_to(HOME)} names {path}, which does not exist")

    def test_names_files_that_exist(self):
        there = {path.name for folder in FOLDERS for path in (HOME / folder).rglob("*.*")}
        for page in PAGES:
            for name in FILE_NAME.findall(without_code(page.read_text())):
                self.assertIn(name, there, f"{page.relative_to(HOME)} names it")

    def test_links_to_files_and_sections_that_exist(self):
        for page in [*PAGES, HOME / "verification/report.md"]:
            for link in LINK.findall(without_code(page.read_text())):
                if "://" in link:
                    continue
                path, _, section = link.partition("#")
                target = page.parent / path if path else page
                self.assertTrue(target.exists(), f"{page.relative_to(HOME)} links to {link}")
                if section:
                    self.assertIn(section, map(anchor, headings(target.read_text())), f"{page.relative_to(HOME)} links to {link}")

    def test_has_the_pages_and_sections_that_the_code_cites(self):
        text = ("", ".hpp", ".cpp", ".py", ".yaml", ".geo", ".tt", ".cmake")  # endings; scripts have none
        files = [path for folder in FOLDERS for path in (HOME / folder).rglob("*") if path.is_file() and path.suffix in text]
        for file in files:
            for page, section in CITATION.findall(file.read_text()):
                path = HOME / f"docs/{page}.md"
                self.assertTrue(path.exists(), f"{file.relative_to(HOME)} cites {path.name}")
                if section:
                    self.assertIn(section, headings(path.read_text()), f"{file.relative_to(HOME)} cites {path.name}")

    def test_lists_the_modules_in_their_order(self):
        declared = re.findall(r"^idiophone_module\(([\w/]+)", (HOME / "CMakeLists.txt").read_text(), flags=re.MULTILINE)
        page = (HOME / "docs/architecture.md").read_text().partition("| layer | module |")[2].partition("\n\n")[0]
        listed, layer = [], ""
        for named_layer, module in re.findall(r"^\| (?:`(\w+)` )?\| (?:`(\w+)` )?\|", page, flags=re.MULTILINE):
            layer = named_layer or layer
            listed.append(f"{layer}/{module}" if module else layer)
        self.assertEqual(listed, declared)

    def test_lists_the_state_that_the_code_archives(self):
        page = (HOME / "docs/method/checkpoints.md").read_text()
        for file in (HOME / "src").rglob("*.cpp"):
            for name in re.findall(r"archive\.(?:rows|root|sum)\(([^,]*),", file.read_text()):
                for literal in re.findall(r'"([^"]*)"', name):
                    self.assertIn(literal.replace("{}", ""), page, f"{file.relative_to(HOME)} archives it")

    def test_shows_the_job_script(self):
        self.assertIn((HOME / "scripts/job.slurm").read_text(), (HOME / "docs/use/running.md").read_text())

    def test_lists_every_page_in_the_contents(self):
        contents = HOME / "docs/README.md"
        links = LINK.findall(contents.read_text())
        for page in (HOME / "docs").rglob("*.md"):
            if page != contents:
                self.assertIn(str(page.relative_to(contents.parent)), links)

    def test_the_changelog_has_the_changes_of_this_version(self):
        version = re.search(r"project\(Idiophone VERSION (\S+)", (HOME / "CMakeLists.txt").read_text())[1]
        found = headings((HOME / "CHANGELOG.md").read_text())
        self.assertTrue(any(heading.split()[0] == version for heading in found), f"no heading {version} in CHANGELOG.md")


if __name__ == "__main__":
    unittest.main()
