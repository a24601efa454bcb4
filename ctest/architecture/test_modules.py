#!/usr/bin/python3
"""The architecture: what each layer and each module includes, against what CMakeLists.txt lets it use."""
import functools
import graphlib
import pathlib
import re
import unittest

HOME = pathlib.Path(__file__).resolve().parents[2]
PUBLIC = HOME / "include" / "idiophone"
SOURCE = HOME / "src"
TESTS = HOME / "ctest"
MOST_ARROWS = 45  # between layers
LINES_OF_README = 10
COMMON = "foundation"  # the headers in this folder itself belong to no module
CALL = re.compile(r"idiophone_module\(([\w/]+)([^)]*)\)")
PAGE = re.compile(r"idiophone_embed_page\(([\w/]+)([^)]*)\)")
COMPARED_KIND = re.compile(
    r"[!=]=\s*(element::)?(Kind::(tet|hex)|(tet4|tet10|hex)\b)|element::(Kind::)?(tet4|tet10|hex)\s*[!=]=")
FILE_NAME = re.compile(r"_(file|reader|writer)$")
INCLUDE = re.compile(r'^\s*#include "([^"]+)"', re.MULTILINE)


@functools.cache
def cmake_lists():
    return re.sub(r"#.*", "", (HOME / "CMakeLists.txt").read_text())


@functools.cache
def modules():
    """Folder of a module -> the folders of those that it uses, in the order of CMakeLists.txt."""
    calls = CALL.findall(cmake_lists())
    folders = {pathlib.PurePath(folder).name: folder for folder, _ in calls}
    found = {}
    for folder, arguments in calls:
        uses = re.findall(r"\bUSES(?:_INSIDE)?\b(.*?)(?=\b(?:USES_INSIDE|LINKS)\b|$)", arguments, re.DOTALL)
        found[folder] = [folders[name] for names in uses for name in names.split()]
    return found


def layer_of(folder):
    return folder.split("/")[0]


def layers():
    """In the order of CMakeLists.txt."""
    return list(dict.fromkeys(layer_of(folder) for folder in modules()))


@functools.cache
def included(path):
    """The project's files that a file includes, as the compiler finds them."""
    found = []
    for name in INCLUDE.findall(path.read_text()):
        beside, public = path.parent / name, HOME / "include" / name
        found.append(beside.resolve() if beside.exists() else public)
    return found


def sources(folder):
    return sorted(path for path in folder.rglob("*") if path.suffix in (".cpp", ".hpp"))


def folder_of(path):
    """The folder of a file's module; None for headers that belong to no module, such as types.hpp, and main programs."""
    for root in PUBLIC, SOURCE:
        if path.is_relative_to(root):
            folder = str(path.relative_to(root).parent)
            return None if folder in (".", COMMON) else folder
    return None


def files_of(folder):
    return [path for root in (SOURCE, PUBLIC) for path in sorted((root / folder).glob("*")) if path.suffix in (".cpp", ".hpp")]


def embedded(folder):
    """The folders whose web page files a module embeds."""
    for page, files in PAGE.findall(cmake_lists()):
        if page == folder:
            return {str(pathlib.PurePath(name).parent) for name in files.split() if "/" in name}
    return set()


def used(folder):
    return {folder_of(header) for path in files_of(folder) for header in included(path)} | embedded(folder)


class Modules(unittest.TestCase):
    def test_every_folder_is_a_module_and_every_module_a_folder(self):
        folders = {folder_of(path) for root in (SOURCE, PUBLIC) for path in sources(root)} - {None}
        self.assertEqual(folders, set(modules()))

    def test_tests_have_the_folders_of_modules(self):
        kinds = {"app", "architecture", "docs", "mutants", "support", "verification", "web"}
        folders = {str(path.parent.relative_to(TESTS)) for path in sources(TESTS)} - {"."}
        self.assertLessEqual({folder for folder in folders if layer_of(folder) not in kinds}, set(modules()))

    def test_uses_names_only_modules_above(self):
        above = set()
        for folder, uses in modules().items():
            self.assertLessEqual(set(uses), above, f"{folder} uses modules that are not above it")
            above.add(folder)

    def test_every_included_file_exists(self):
        for folder in modules():
            for path in files_of(folder):
                for header in included(path):
                    self.assertTrue(header.exists(), f"{path.relative_to(HOME)} includes {header}")

    def test_includes_and_uses_agree(self):
        for folder, uses in modules().items():
            with self.subTest(module=folder):
                self.assertEqual(used(folder) - {folder, None}, set(uses))

    def test_private_headers_stay_in_their_module(self):
        for folder in modules():
            for path in files_of(folder):
                for header in included(path):
                    if folder_of(header) not in (folder, None):
                        self.assertTrue(header.is_relative_to(PUBLIC),
                                        f"{path.relative_to(HOME)} includes the private {header.relative_to(HOME)}")

    def test_public_headers_are_used_by_another_module(self):
        """Because another module, a main program or an example includes it, or a header that is public for that reason."""
        all_files = sources(SOURCE) + sources(HOME / "examples") + sources(PUBLIC)
        includes = [(folder_of(path), header) for path in all_files for header in included(path)]
        public = [header for folder, header in includes if header.is_relative_to(PUBLIC) and folder_of(header) != folder]
        for header in public:  # grows as it is read
            public += [further for further in included(header) if further not in public]
        unused = [str(header.relative_to(HOME)) for header in sources(PUBLIC) if header not in public and folder_of(header)]
        self.assertEqual(unused, [], "these belong into src/: no other module uses them")

    def test_physics_does_not_depend_on_files(self):
        """Only code that reads and writes files, or describes any file, includes the HDF5 toolkit."""
        allowed = ("files", "run/results", "study/contents")
        others = [str(path.relative_to(HOME)) for root in (SOURCE, PUBLIC) for path in sources(root)
                  if folder_of(path) not in allowed and not FILE_NAME.search(path.stem)
                  and any(folder_of(header) == "files" for header in included(path))]
        self.assertEqual(others, [])

    def test_physics_takes_sections_of_a_scene(self):
        """Solids and air get sections, or the views scene::Solids and scene::Acoustics."""
        whole = PUBLIC / "scene" / "scene.hpp"
        takers = [str(path.relative_to(HOME)) for root in (SOURCE, PUBLIC) for path in sources(root)
                  if folder_of(path) and layer_of(folder_of(path)) in ("solids", "air") and whole in included(path)]
        self.assertEqual(takers, [])

    def test_kinds_of_elements_are_compared_only_in_their_module(self):
        """Others ask element/type.hpp about a type, or switch over all kinds."""
        comparing = [str(path.relative_to(HOME)) for root in (SOURCE, PUBLIC) for path in sources(root)
                     if folder_of(path) != "foundation/element" and COMPARED_KIND.search(path.read_text())]
        self.assertEqual(comparing, [])

    def test_names_of_headers_are_unique(self):
        names = [path.name for root in (SOURCE, PUBLIC) for path in sources(root) if path.suffix == ".hpp"]
        self.assertEqual(sorted({name for name in names if names.count(name) > 1}), [])

    def test_no_file_includes_itself_through_others(self):
        graph = {path: included(path) for path in sources(SOURCE) + sources(PUBLIC)}
        try:
            graphlib.TopologicalSorter(graph).prepare()
        except graphlib.CycleError as error:
            self.fail(" <- ".join(str(path.relative_to(HOME)) for path in error.args[1]))


class Layers(unittest.TestCase):
    def test_modules_of_a_layer_stand_together(self):
        order = [layer_of(folder) for folder in modules()]
        self.assertEqual([layer for layer, before in zip(order, [None, *order]) if layer != before], layers())

    def test_arrows_between_layers_go_up_the_list_and_are_few(self):
        arrows = set()
        for folder in modules():
            for other in used(folder) - {None}:
                if layer_of(other) != layer_of(folder):
                    arrows.add((layer_of(folder), layer_of(other)))
        order = layers()
        self.assertEqual([arrow for arrow in arrows if order.index(arrow[0]) < order.index(arrow[1])], [])
        self.assertLessEqual(len(arrows), MOST_ARROWS)

    def test_every_layer_has_a_page_at_its_door(self):
        for layer in layers():
            readme = SOURCE / layer / "README.md"
            self.assertTrue(readme.exists(), f"src/{layer}/README.md is missing")
            self.assertLessEqual(len(readme.read_text().splitlines()), LINES_OF_README + 5, readme)


if __name__ == "__main__":
    unittest.main()
