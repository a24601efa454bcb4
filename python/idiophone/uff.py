"""Functions as files of the Universal File Format, dataset type 58, which programs for modal analysis read."""
from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

TIME_RESPONSE, FREQUENCY_RESPONSE = 1, 4  # types of functions
TIME, FREQUENCY = 17, 18                  # types of data on an axis
PRESSURE, FORCE, UNKNOWN = 15, 13, 0
AXIS = "{:10d}{:5d}{:5d}{:5d} {:<20.20s} {:<20.20s}"


@dataclass(frozen=True)
class Function:
    """A function of time or frequency."""
    name: str
    values: np.ndarray           #: [points]: complex ones are a frequency response, real ones a sound
    abscissa: np.ndarray         #: [points]: s or Hz
    unit: str                    #: of the values, e.g. "Pa" or "Pa/N"
    node: int = 1                #: number of the receiver


def write_uff(path: str | Path, functions: Iterable[Function]) -> None:
    """Writes functions, one dataset of type 58 each. Uneven abscissas are written with each value."""
    with open(path, "w", encoding="ascii", errors="replace") as file:
        for function in functions:
            file.write("\n".join(["    -1", "    58", *_header(function), *_numbers(function), "    -1", ""]))


def _header(function: Function) -> list[str]:
    """Records 1 to 11."""
    is_complex = np.iscomplexobj(function.values)
    kind, axis, over = (FREQUENCY_RESPONSE, FREQUENCY, FORCE) if is_complex else (TIME_RESPONSE, TIME, UNKNOWN)
    first, step, even = _spacing(function.abscissa)
    place = f" {function.name.replace(' ', '_'):<10.10s}{function.node:10d}{0:4d} {'NONE':<10s}{0:10d}{0:4d}"
    unit, _, denominator = function.unit.partition("/")
    return [
        f"{function.name:.80s}", "NONE", "NONE", "written by Idiophone", "NONE",
        f"{kind:5d}{0:10d}{0:5d}{0:10d}{place}",
        f"{6 if is_complex else 4:10d}{len(function.values):10d}{int(even):10d}{first:13.5e}{step:13.5e}{0:13.5e}",
        AXIS.format(axis, 0, 0, 0, "Frequency" if is_complex else "Time", "Hz" if is_complex else "s"),
        AXIS.format(PRESSURE, 0, 0, 0, "Pressure", unit),
        AXIS.format(over, 0, 0, 0, "Force" if is_complex else "NONE", denominator or "NONE"),
        AXIS.format(UNKNOWN, 0, 0, 0, "NONE", "NONE")]


def _spacing(abscissa: np.ndarray) -> tuple[float, float, bool]:
    """The first value, the step, and whether the file's six digits give all values: otherwise each is written, and these are 0."""
    first, step = (float(f"{value:.5e}") for value in (abscissa[0], abscissa[1] - abscissa[0] if len(abscissa) > 1 else 1.0))
    even = np.allclose(abscissa, first + step * np.arange(len(abscissa)), rtol=0, atol=1e-6 * step)
    return (first, step, True) if even else (0.0, 0.0, False)


def _numbers(function: Function) -> list[str]:
    """Record 12: numbers in lines, in double precision."""
    is_complex, even = np.iscomplexobj(function.values), _spacing(function.abscissa)[2]
    parts = [function.values.real, function.values.imag] if is_complex else [function.values]
    pairs = [(value, "{:20.12e}") for value in parts]
    columns = pairs if even else [(function.abscissa, "{:13.5e}"), *pairs]
    cells = [[form.format(number) for number in values] for values, form in columns]
    per_line = {1: 4, 2: 2, 3: 1}[len(columns)] if even or is_complex else 2
    points = ["".join(point) for point in zip(*cells)]
    return ["".join(points[start:start + per_line]) for start in range(0, len(points), per_line)]
