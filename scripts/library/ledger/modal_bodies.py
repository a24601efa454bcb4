"""Partials of a modal body against those of the finite elements of the same mesh, in sounds of whole runs."""

import dataclasses

from . import sound
from .ledger import Row, Section

SAME = 0.005  # part of the frequency within which two partials are one


def measure(name, case, program):
    """Three tables: frequencies, levels and decay times of all partials."""
    program = dataclasses.replace(program, ranks=1)  # a modal body lies on one rank
    model = f"bodies.{case['body']}.model={case['model']}"
    elements, modal = (sound.heard(case, program.sound(f"{name}/{folder}", case["deck"], [*case.get("set", []), *more]),
                                   program)
                       for folder, more in (("elements", []), ("modal", [model])))
    loudest = max(peak.level for peak in elements)
    pairs = [(peak, nearest(peak, modal)) for peak in elements
             if peak.level > loudest - case["faintest"] and peak.decay_time > case["start"]]
    return Section([[Row(f"{quantity} at {peak.frequency:.0f} Hz", getattr(peak, key), other and getattr(other, key), unit,
                         case[tolerance]) for peak, other in pairs]
                    for quantity, key, unit, tolerance in (("frequency", "frequency", "Hz", "tolerance"),
                                                           ("level", "level", "dB", "level"),
                                                           ("T60", "decay_time", "s", "decay"))])


def nearest(peak, others):
    """The partial of the other sound with the same frequency, or None."""
    other = min(others, key=lambda each: abs(each.frequency - peak.frequency))
    return other if abs(other.frequency / peak.frequency - 1) < SAME else None
