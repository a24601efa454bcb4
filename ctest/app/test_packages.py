#!/usr/bin/python3
"""The two Debian packages: what is in each, and what each needs."""
import ast
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import program

BUILD = pathlib.Path(os.environ["IDIOPHONE_BUILD"])
MODULE = program.SOURCE / "python/idiophone"
QUICKLY = ("-D", "CPACK_DEBIAN_PACKAGE_SHLIBDEPS=OFF", "-D", "CPACK_STRIP_FILES=OFF", "-D", "CPACK_DEBIAN_COMPRESSION_TYPE=none")


def imported(nodes):
    """The modules that statements import which come neither with Python nor with Idiophone."""
    found = set()
    for node in nodes:
        if isinstance(node, ast.Import):
            found |= {name.name.partition(".")[0] for name in node.names}
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            found.add(node.module.partition(".")[0])
    return found - set(sys.stdlib_module_names) - {"idiophone"}


class Packages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        subprocess.run(["cpack", "--config", BUILD / "CPackConfig.cmake", "-B", cls.folder, *QUICKLY], check=True,
                       stdout=subprocess.DEVNULL)

    def ask(self, question, package, *words):
        (path,) = self.folder.glob(f"{package}_*.deb")
        return subprocess.run(["dpkg-deb", question, path, *words], check=True, capture_output=True, text=True).stdout

    def packages(self, field):
        """The packages that a field of python3-idiophone names, without their versions."""
        return {item.split()[0] for item in self.ask("--field", "python3-idiophone", field).split(",")}

    def files(self, package):
        return {line.split()[5].lstrip(".") for line in self.ask("--contents", package).splitlines() if not line.startswith("d")}

    def test_the_python_module_is_a_package_of_its_own(self):
        module, rest = self.files("python3-idiophone"), self.files("idiophone")
        self.assertLessEqual({f"/usr/lib/python3/dist-packages/idiophone/{path.name}" for path in MODULE.glob("*.py")}, module)
        self.assertIn("/usr/bin/idiophone", rest)
        self.assertEqual([path for path in rest if "python3" in path], [])
        for package in "idiophone", "python3-idiophone":
            self.assertIn(f"/usr/share/doc/{package}/copyright", module | rest)

    def test_the_python_module_comes_with_what_it_imports(self):
        needed, used = set(), set()
        for path in MODULE.glob("*.py"):
            tree = ast.parse(path.read_text())
            used |= imported(ast.walk(tree))
            if path.name != "plots.py":  # read at the first picture
                needed |= imported(tree.body)
        depends = self.packages("Depends")
        self.assertIn("idiophone", depends)
        self.assertLessEqual({f"python3-{name}" for name in needed}, depends)
        self.assertLessEqual({f"python3-{name}" for name in used}, depends | self.packages("Recommends"))


if __name__ == "__main__":
    unittest.main()
