"""The rows of the ledger."""

import math
from dataclasses import dataclass, field


@dataclass
class Row:
    """A quantity, its reference and what was computed (None: nothing was found), both in `unit`: Hz, dB, s or m. Without a
    tolerance it is shown, not judged. Tolerance and error are in cents of a frequency, dB of a level, percent of a
    decay time or a length. `beside`: more columns, each a text under its heading."""
    quantity: str
    reference: float
    computed: float | None
    unit: str
    tolerance: float | None = None
    beside: dict = field(default_factory=dict)

    @property
    def error(self):
        if self.computed is None:
            return None
        return ERRORS[self.unit][1](self.computed, self.reference)

    @property
    def passed(self):
        return self.tolerance is None or (self.error is not None and abs(self.error) <= self.tolerance)

    @property
    def verdict(self):
        return "shown" if self.tolerance is None else "pass" if self.passed else "**fail**"


class AtMost(Row):
    """A quantity that the reference is a ceiling for."""

    @property
    def passed(self):
        return self.computed is not None and self.computed <= self.reference


@dataclass
class Section:
    """What a case adds to the report: tables of rows, lines of Markdown before and after them."""
    tables: list
    before: list = field(default_factory=list)
    after: list = field(default_factory=list)

    @property
    def rows(self):
        return [row for rows in self.tables for row in rows]


def measured(case, tables, program):
    """A section of tables, with the case's `source` before and its `pictures` after."""
    shown = [] if program.short else [f"![{name}](pictures/{name}.png)" for name in case["pictures"]]
    return Section(tables, before=[f"{case['source']}.", ""], after=[*shown, ""])


def cents(frequency, reference):
    return 1200 * math.log2(frequency / reference)


ERRORS = {"Hz": ("cents", cents),
          "dB": ("dB", lambda computed, reference: computed - reference),
          "s": ("%", lambda computed, reference: 100 * (computed / reference - 1)),
          "m": ("%", lambda computed, reference: 100 * (computed / reference - 1)),
          "cents": ("cents", lambda computed, reference: computed - reference),
          "order": ("", lambda computed, reference: computed - reference)}


def table(header, lines):
    return ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)] + ["| " + " | ".join(line) + " |"
                                                                             for line in lines] + [""]


def row_table(rows):
    unit = rows[0].unit
    name = ERRORS[unit][0]
    more = list(dict.fromkeys(heading for row in rows for heading in row.beside))
    header = ["quantity", f"reference, {unit}", f"computed, {unit}", f"error, {name}", f"tolerance, {name}", "", *more]
    header = [heading.strip(", ") for heading in header]
    return table(header, [[row.quantity, number(row.reference), number(row.computed), signed(row.error),
                           "-" if row.tolerance is None else f"{row.tolerance:g}", row.verdict,
                           *(row.beside.get(heading, "-") for heading in more)] for row in rows])


def number(value):
    return "none" if value is None else f"{value:.4g}" if abs(value) < 10 else f"{value:.2f}"


def signed(value):
    return "-" if value is None else f"{value:+.2f}"
