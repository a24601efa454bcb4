"""Where the mistakes of a deck of Python values are: key paths instead of lines and columns."""
from __future__ import annotations

import re

import yaml

from .errors import Mistake

SETTING = re.compile(r"^--set ([^=]+)=")


def with_key(mistake: Mistake, path: str, keys: dict[tuple[int, int], str]) -> Mistake:
    """A mistake with the key path of its place in the file `path`, if `keys` are its places, or of the value that was set."""
    if keys and mistake.file == path:
        return Mistake(mistake.text, key=keys.get((mistake.line, mistake.column), ""))
    setting = SETTING.match(mistake.file)
    return Mistake(mistake.text, key=setting[1]) if setting else mistake


def key_paths(text: str) -> dict[tuple[int, int], str]:
    """The key paths of a YAML text by the lines and columns, from 1 on, of their keys and values."""
    found: dict[tuple[int, int], str] = {}

    def add(node: yaml.Node, path: str) -> None:
        found.setdefault((node.start_mark.line + 1, node.start_mark.column + 1), path)
        pairs = node.value if isinstance(node, yaml.MappingNode) else []
        items = enumerate(node.value) if isinstance(node, yaml.SequenceNode) else []
        for key, value in pairs:
            below = f"{path}.{key.value}".lstrip(".")
            found[key.start_mark.line + 1, key.start_mark.column + 1] = below
            add(value, below)
        for number, value in items:
            add(value, f"{path}.{number}")

    add(yaml.compose(text, yaml.SafeLoader), "")
    return found
