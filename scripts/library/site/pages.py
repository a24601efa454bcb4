"""Copies the documentation, and every file of the repository that it links to, to where mkdocs reads it."""
import os
import re
import shutil
from pathlib import Path

LINK = re.compile(r"(?P<text>!?\[(?:[^\]`]|`[^`]*`)*\])\((?P<path>[^)\s#]+)(?P<section>#[^)\s]*)?\)")
CODE = re.compile(r"(^```.*?^```$)", re.DOTALL | re.MULTILINE)
FIRST = "README.md"


def linked(page, home):
    """The files of the repository that a page links to."""
    for link in LINK.finditer(CODE.sub("", page.read_text())):
        target = Path(os.path.normpath(page.parent / link["path"]))
        if "://" not in link["path"] and target.is_file() and target.is_relative_to(home):
            yield target


def without_links_to_folders(text, page):
    """A website has no listings of folders: the text of such a link stays, without the link."""
    def text_only(link):
        is_folder = "://" not in link["path"] and (page.parent / link["path"]).is_dir()
        return link["text"][1:-1] if is_folder else link[0]
    return "".join(piece if CODE.fullmatch(piece) else LINK.sub(text_only, piece) for piece in CODE.split(text))


def copy_pages(home, folder):
    """Every file keeps the path that it has in the repository, so links hold. Returns the pages' paths in it."""
    waiting, found = [home / FIRST], set()
    while waiting:
        file = waiting.pop()
        if file in found:
            continue
        found.add(file)
        copy = folder / file.relative_to(home)
        copy.parent.mkdir(parents=True, exist_ok=True)
        if file.suffix == ".md":
            copy.write_text(without_links_to_folders(file.read_text(), file))
            waiting += linked(file, home)
        else:
            shutil.copy(file, copy)
    return sorted(str(file.relative_to(home)) for file in found if file.suffix == ".md")
