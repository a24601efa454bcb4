#!/usr/bin/python3
"""The rooms of the house: what each includes against what CMakeLists.txt lets it use."""
import functools
import graphlib
import pathlib
import re
import unittest

HOUSE = pathlib.Path(__file__).resolve().parents[2]
PUBLIC = HOUSE / "include"
CALL = re.compile(r"idiophone_room\((\w+)([^)]*)\)")
INCLUDE = re.compile(r'^\s*#include "([^"]+)"', re.MULTILINE)


@functools.cache
def rooms():
    """Room -> the rooms that it uses, in the order of CMakeLists.txt."""
    text = re.sub(r"#.*", "", (HOUSE / "CMakeLists.txt").read_text())
    found = {}
    for room, arguments in CALL.findall(text):
        uses = re.search(r"\bUSES\b(.*?)(?=\bLINKS\b|$)", arguments, re.DOTALL)
        found[room] = uses[1].split() if uses else []
    return found


@functools.cache
def included(path):
    """The project's files that a file includes, as the compiler finds them."""
    found = []
    for name in INCLUDE.findall(path.read_text()):
        beside, public = path.parent / name, PUBLIC / name
        found.append(beside.resolve() if beside.exists() else public)
    return found


def sources(folder):
    return sorted(path for path in folder.rglob("*") if path.suffix in (".cpp", ".hpp"))


def room_of(path):
    """The room of a file; None for headers that belong to no room, such as types.hpp."""
    for root in PUBLIC / "idiophone", HOUSE / "src", HOUSE / "ctest":
        if path.is_relative_to(root):
            parts = path.relative_to(root).parts
            return parts[0] if len(parts) > 1 else None
    return None


def files_of(room):
    return sources(HOUSE / "src" / room) + sources(PUBLIC / "idiophone" / room)


class Rooms(unittest.TestCase):
    def test_every_folder_is_a_room_and_every_room_a_folder(self):
        folders = {path.name for root in (HOUSE / "src", PUBLIC / "idiophone") for path in root.iterdir() if path.is_dir()}
        self.assertEqual(folders, set(rooms()))

    def test_uses_names_only_rooms_above(self):
        above = set()
        for room, uses in rooms().items():
            self.assertLessEqual(set(uses), above, f"{room} uses rooms that are not above it")
            above.add(room)

    def test_every_included_file_exists(self):
        for room in rooms():
            for path in files_of(room):
                for header in included(path):
                    self.assertTrue(header.exists(), f"{path.relative_to(HOUSE)} includes {header}")

    def test_includes_and_uses_agree(self):
        for room, uses in rooms().items():
            with self.subTest(room=room):
                taken = {room_of(header) for path in files_of(room) for header in included(path)}
                self.assertEqual(taken - {room, None}, set(uses))

    def test_private_headers_stay_in_their_room(self):
        for room in rooms():
            for path in files_of(room):
                for header in included(path):
                    if room_of(header) not in (room, None):
                        self.assertTrue(header.is_relative_to(PUBLIC),
                                        f"{path.relative_to(HOUSE)} includes the private {header.relative_to(HOUSE)}")

    def test_public_headers_are_used_by_another_room(self):
        """A header is public because another room, a main program or an example includes it, or a header that is public for that reason."""
        house = sources(HOUSE / "src") + sources(HOUSE / "examples") + sources(PUBLIC)
        includes = [(room_of(path), header) for path in house for header in included(path)]
        public = [header for room, header in includes if header.is_relative_to(PUBLIC) and room_of(header) != room]
        for header in public:  # grows as it is read
            public += [further for further in included(header) if further not in public]
        unused = [str(header.relative_to(HOUSE)) for header in sources(PUBLIC) if header not in public]
        self.assertEqual(unused, [], "these belong into src/: no other room uses them")

    def test_no_file_includes_itself_through_others(self):
        graph = {path: included(path) for path in sources(HOUSE / "src") + sources(PUBLIC)}
        try:
            graphlib.TopologicalSorter(graph).prepare()
        except graphlib.CycleError as error:
            self.fail(" <- ".join(str(path.relative_to(HOUSE)) for path in error.args[1]))


if __name__ == "__main__":
    unittest.main()
