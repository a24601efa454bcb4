"""Decay times that are heard, against the damping that the deck prescribes."""

import math

from .ledger import Row
from .program import deck_with


def rows(case, sounding, found):
    """One row for each partial that a mode of the case was found to be."""
    damping = next(iter(deck_with(case["deck"], case.get("set", []))["materials"].values()))["damping"]
    heard = {peak.frequency: peak.decay_time for peak in found}
    frequencies = dict.fromkeys(row.computed for row in sounding if row.computed)
    return [Row(f"T60 at {frequency:.0f} Hz", decay_time(damping, frequency), heard[frequency], "s", case["decay"])
            for frequency in frequencies]


def decay_time(damping, frequency):
    """T60 = ln(1000)/(zeta w), s, with zeta = mass/(2 w) + stiffness w/2, or half of a loss factor."""
    omega = 2 * math.pi * frequency
    mass, stiffness, loss_factor = (float(damping.get(key, 0)) for key in ("mass", "stiffness", "loss_factor"))
    zeta = (mass / omega + stiffness * omega + loss_factor) / 2
    return math.log(1000) / (zeta * omega)
