"""Answers of `idiophone identify` and `idiophone tune`."""
from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any, ClassVar, Protocol, TypeVar

import yaml

from .facts import Facts


class _Dataclass(Protocol):
    __dataclass_fields__: ClassVar[dict[str, Any]]


T = TypeVar("T", bound=_Dataclass)


@dataclass(frozen=True)
class Constant:
    """A constant of a material, e.g. "young", or a turn of its axes (degrees)."""
    value: float
    half_width: float | None  #: of the 95 % interval, in the unit of the value; None if it is unbounded
    in_the_deck: float        #: where the search began
    determined: bool          #: whether the lines determine it; if not, it keeps the value of the deck
    would_be_determined: bool  #: by `further_lines`, if it is not
    has_no_effect: bool       #: a turn about an axis around which the material is the same in all directions


@dataclass(frozen=True)
class Line:
    """A measured resonance."""
    measured: float                 #: Hz
    fitted: bool
    split: bool                     #: one of two lines into which imperfections split a mode
    mesh_error: float | None        #: cents; None if it is not fitted
    mode: int | None = None         #: its number, from 1 on; None for a false line
    modes: int = 0                  #: how many modes of one frequency it is
    computed: float | None = None   #: Hz
    cents: float | None = None      #: of the measured frequency above the computed one


@dataclass(frozen=True)
class Identification:
    """The constants of a material that give a body measured resonances (docs/use/identify.md)."""
    accepted: bool                     #: whether the fit is good; if not, do not use the constants before you know why
    doubts: list[str]                  #: why it is not accepted
    constants: dict[str, Constant]     #: by name, e.g. "young"
    lines: list[Line]
    not_measured: list[Facts]          #: `mode`, `modes` and `frequency` of modes between the lines that have no line
    further_lines: list[Facts]         #: that would determine the other constants: `constant`, `mode`, `modes`, `frequency`,
                                       #: `half_width` that would be left, and where to strike or listen: `at` (m), `along`
    further_sizes: list[Facts]         #: specimens that would tell constants which no further line does: `constant`, `factor` of
                                       #: the side `along`, `size` (m), how many `lines`, `up_to` (Hz), `half_width`, and
                                       #: whether the constant would be `determined`
    fitted_rms: float | None           #: cents; None if no line was fitted
    chi_squared: float                 #: sum of the squares of the fitted lines' cents over their uncertainties and mesh errors
    degrees_of_freedom: int            #: of chi_squared
    predicted_rms: float | None        #: cents; None if no line was predicted
    density: float                     #: kg/m3
    volume: float                      #: m3
    solves: int                        #: eigenvalue problems that were solved
    materials: dict[str, Any]          #: the section of a deck: deck["materials.steel"] = found.materials["steel"]
    grain: dict[str, Any] | None       #: if turns were fitted: deck["bodies.block.grain"] = found.grain
    equivalent_turns: list[list[float]]  #: about x, y, z (degrees), with which the lines fit as well, by symmetry of the body
    messages: list[str]                #: what the program says besides


@dataclass(frozen=True)
class TunedMode:
    """A mode that was tuned."""
    start_mode: int                   #: its number at the start, from 1 on
    mode: int                         #: its number in the end
    start: float                      #: Hz
    frequency: float                  #: Hz
    wanted: float                     #: Hz
    cents: float                      #: of the frequency above the wanted one
    similarity: float                 #: of its shape to that at the start, from 0 to 1
    #: key -> cents per unit of this number; None if the search ended before it had computed this, as in decays and levels
    sensitivities: dict[str, float | None]


@dataclass(frozen=True)
class TunedDecay:
    """A mode whose decay time was wanted."""
    start_mode: int                   #: its number at the start, from 1 on
    mode: int                         #: its number in the end
    start: float                      #: T60, s
    decay_time: float                 #: s
    wanted: float                     #: s
    percent: float                    #: of the decay time above the wanted one
    sensitivities: dict[str, float | None]  #: key -> percent per unit of this number


@dataclass(frozen=True)
class TunedLevel:
    """How loud the deck's blows are at a listener."""
    listener: str                     #: name of the channel
    kind: str                         #: of what was wanted: "equal", "at_least" or "at_most"
    start: float                      #: A-weighted sound exposure level (LAE) at the start, dB re 20 uPa
    level: float                      #: in the end
    wanted: float                     #: dB
    reached: bool                     #: whether it is within the tolerance, or beyond the limit
    sensitivities: dict[str, float | None]  #: key -> dB per unit of this number; 0 beyond a limit


@dataclass(frozen=True)
class AvoidedBand:
    """Frequencies that no mode should have."""
    lower: float                #: Hz
    upper: float                #: Hz
    modes: list[int]            #: numbers of those that are there all the same, from 1 on
    frequencies: list[float]    #: theirs, Hz


@dataclass(frozen=True)
class ModeScatter:
    """How a mode differs from body to body."""
    mode: int                   #: its number, from 1 on
    deviation: float            #: standard deviation of its error, cents
    effects: dict[str, float]   #: key -> cents for one standard deviation of this number


@dataclass(frozen=True)
class InTune:
    """How many bodies are in tune although numbers differ from body to body."""
    share: float                             #: of the bodies, 0 to 1
    within: float                            #: cents
    scatter: dict[str, dict[str, float]]     #: key -> `mean` and standard `deviation` of this number
    modes: list[ModeScatter]


@dataclass(frozen=True)
class Tuning:
    """Numbers of a deck that give modes wanted frequencies (docs/use/tune.md)."""
    tuned: bool                      #: whether all is as it was wanted
    values: dict[str, float]         #: key -> the number: for key, value in tuning.values.items(): deck[key] = value
    bounds: dict[str, str | None]    #: key -> "lower" or "upper" if the number is on this bound
    modes: list[TunedMode]
    decays: list[TunedDecay]
    levels: list[TunedLevel]
    avoided: list[AvoidedBand]
    in_tune: InTune | None           #: None if no numbers scatter
    solves: int                      #: bodies that were solved
    messages: list[str]              #: what the program says besides


def identification(answer: Facts) -> Identification:
    """From what the program answers."""
    return _made(Identification, answer, constants={name: _made(Constant, facts) for name, facts in answer["constants"].items()},
                 lines=[_made(Line, facts) for facts in answer["lines"]],
                 materials=yaml.safe_load(answer["materials"])["materials"])


def tuning(answer: Facts) -> Tuning:
    """From what the program answers."""
    return _made(Tuning, answer, modes=[_made(TunedMode, facts) for facts in answer["modes"]],
                 decays=[_made(TunedDecay, facts) for facts in answer["decays"]],
                 levels=[_made(TunedLevel, facts) for facts in answer["levels"]],
                 avoided=[_made(AvoidedBand, facts) for facts in answer["avoided"]],
                 in_tune=answer["in_tune"] and in_tune(answer["in_tune"]))


def in_tune(facts: Facts) -> InTune:
    """From what the program answers."""
    return _made(InTune, facts, modes=[_made(ModeScatter, mode) for mode in facts["modes"]])


def _made(kind: type[T], answer: Facts, **parts: object) -> T:
    """An object of the facts that have the names of its fields, and of parts that were made already."""
    names = [field.name for field in fields(kind)]
    return kind(**{name: answer[name] for name in names if name in answer} | parts)
