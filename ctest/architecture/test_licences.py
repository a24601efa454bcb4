#!/usr/bin/python3
"""The files that are offered under the MIT licence: those of the libraries `voices` and `proxies`, and no other."""
import pathlib
import re
import unittest

HOME = pathlib.Path(__file__).resolve().parents[2]
LIST = (HOME / "LICENSES/MIT_files.txt").read_text().splitlines()
OWN = re.compile(r'^\s*#include "([^"]+)"', re.MULTILINE)
OUTSIDE = re.compile(r"^\s*#include <([^>]+)>", re.MULTILINE)
ALLOWED = re.compile(r"(unsupported/)?Eigen/|fmt/|std\w+\.h$")  # beside the headers of C++, which have no dot and no folder


def closure(files):
    """The files and all of the project's headers that they include."""
    found, left = set(), [HOME / name for name in files]
    while left:
        path = left.pop().resolve()
        if path not in found:
            found.add(path)
            for name in OWN.findall(path.read_text()):
                beside = path.parent / name
                left.append(beside if beside.exists() else HOME / "include" / name)
    return sorted(str(path.relative_to(HOME)) for path in found)


class Licences(unittest.TestCase):
    def test_list_is_sorted(self):
        self.assertEqual(LIST, sorted(set(LIST)))

    def test_list_has_all_sources_and_headers_of_both_libraries_and_nothing_else(self):
        sources = [name for name in LIST if name.endswith(".cpp")]
        for module in "engines", "proxies", "touching":
            sources += [str(path.relative_to(HOME)) for path in (HOME / "src/instruments" / module).glob("*.cpp")]
        public = ["include/idiophone/voices.h"]
        for module in "engines", "proxies":
            public += [str(path.relative_to(HOME)) for path in (HOME / "include/idiophone/instruments" / module).glob("*.hpp")]
        self.assertEqual(LIST, closure(sources + public))

    def test_they_include_no_other_library(self):
        for name in LIST:
            for header in OUTSIDE.findall((HOME / name).read_text()):
                self.assertTrue(re.fullmatch(r"\w+", header) or ALLOWED.match(header), f"{name} includes <{header}>")

    def test_installed_headers_of_voices_need_the_standard_library_only(self):
        for path in [HOME / "include/idiophone/voices.h", HOME / "include/idiophone/instruments/touching/contact_events.hpp",
                     *(HOME / "include/idiophone/instruments/engines").glob("*.hpp")]:
            for header in OUTSIDE.findall(path.read_text()):
                self.assertRegex(header, r"^(\w+|stdint\.h)$", path)


if __name__ == "__main__":
    unittest.main()
