"""How far mass scaling moves the pitch of a thin plate: measurement against promise and prediction."""

import math

from scipy.optimize import brentq

from . import exact
from .ledger import Row, Section, signed
from .program import material

HIGHEST = 20e3  # Hz, the highest audible frequency
EDGE = 1.3      # rotation near free edges, over that of a plane wave
MOST = 30       # the program adds no more than this multiple


def measure(name, case, program):
    """Judged: no mode falls by more than the deck's `shift`. Beside it the prediction for a wave of its frequency."""
    scaled = f"bodies.plate.mass_scaling.shift={case['shift']}"
    without, found = (program.modes(f"{name}/{folder}", case["deck"], [*case["set"], *more], case["count"])[0]
                      for folder, more in (("without", []), ("with", [scaled])))
    steel = material(case["deck"])
    rows = [Row(f"mode {mode}", before, after, "Hz", case["shift"],
                {"predicted, cents": signed(-predicted(steel, case["thickness"], case["shift"], before))})
            for mode, (before, after) in enumerate(zip(without, found), 1) if before < HIGHEST]
    return Section([rows])


def predicted(steel, thickness, shift, frequency):
    """Cents by which a bending wave falls: its kinetic energy grows by the added mass of rotation and bow, of which each
    may take half of the shift at the highest audible frequency."""
    each = (2**(shift / 600) - 1) / 2
    added = sum(min(MOST, each / most) * here
                for most, here in zip(shares(steel, thickness, HIGHEST), shares(steel, thickness, frequency)))
    return 600 * math.log2(1 + added)


def shares(steel, thickness, frequency):
    """Parts of a bending wave's kinetic energy: rotation and bow of the lines through the thickness."""
    wave = thickness * brentq(lambda k: exact.lamb_wave(steel, k, thickness) - frequency, 1e-3 / thickness, 10 / thickness)
    squeeze = (steel["poisson"] / (1 - steel["poisson"]))**2
    return EDGE * wave**2 / 12, squeeze * wave**4 / 720
