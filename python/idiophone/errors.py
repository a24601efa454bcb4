"""What goes wrong, as exceptions."""
from __future__ import annotations

import re
from dataclasses import dataclass

PLACE = re.compile(r"^(?P<file>.*?):(?P<line>\d+):(?P<column>\d+): (?P<text>.*)$")


class IdiophoneError(Exception):
    """Any error of this module."""


class ProgramError(IdiophoneError):
    """The program ended with an error, which is the text of this exception."""


class Stopped(IdiophoneError):
    """A run was stopped in good order by a signal. `Deck.run(resume=True)` goes on from its checkpoint."""


@dataclass(frozen=True)
class Mistake:
    """One mistake of a deck."""
    text: str
    file: str = ""    #: the deck, or another file that it names
    line: int = 0     #: from 1 on
    column: int = 0   #: from 1 on
    key: str = ""     #: instead of a place in a file, of values that Python has set: the key path, e.g. "bodies.plate.material"

    def __str__(self) -> str:
        if self.key:
            return self.text if self.text.startswith(f"{self.key}:") else f"{self.key}: {self.text}"
        return f"{self.file}:{self.line}:{self.column}: {self.text}" if self.line else self.text


class DeckError(IdiophoneError):
    """A deck has mistakes."""

    def __init__(self, mistakes: list[Mistake]):
        super().__init__("\n".join(map(str, mistakes)))
        self.mistakes = mistakes  #: all of them


def mistakes_of(text: str) -> list[Mistake]:
    """The mistakes that the program prints, one in a line."""
    found = []
    for line in filter(None, map(str.strip, text.splitlines())):
        place = PLACE.match(line)
        found.append(Mistake(place["text"], place["file"], int(place["line"]), int(place["column"])) if place else Mistake(line))
    return found
