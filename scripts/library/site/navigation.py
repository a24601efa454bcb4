"""The navigation of the website, from the contents of the documentation (docs/README.md)."""
import os
import re
from pathlib import PurePosixPath

from .pages import LINK

HEADING = re.compile(r"^## (.*)$", re.MULTILINE)
GROUP = re.compile(r"^- \*\*(.*?)\*\*:", re.MULTILINE)
CONTENTS = PurePosixPath("docs/README.md")


def pages_of(text):
    """The pages that a text of the contents links to, by their paths in the repository."""
    return [os.path.normpath(CONTENTS.parent / link.group("path")) for link in LINK.finditer(text)]


def parts(pattern, text):
    """(name, text up to the next name) of each name that the pattern finds."""
    pieces = pattern.split(text)
    return list(zip(pieces[1::2], pieces[2::2]))


def navigation(contents):
    """mkdocs' `nav`: sections, in them groups, in them pages, whose titles are their own.

    contents: the text of docs/README.md
    """
    return [{section: [{group: pages_of(links)} for group, links in parts(GROUP, text)] or pages_of(text)}
            for section, text in parts(HEADING, contents)]
