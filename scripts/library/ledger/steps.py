"""What the step in time does to the pitch: one sound at several steps, against the eigenfrequencies of its mesh."""

import math

import numpy as np
from idiophone import Result

from . import pictures
from .ledger import Row, Section, cents, signed


def measure(name, case, program):
    """Judged: how far each partial is from where the step's own error puts it. Beside it that error, in cents from the
    mesh's frequency."""
    modes = list(zip(*program.modes(name, case["deck"], case.get("set", []), case["count"])))
    points, tables = [], []
    for steps in case["steps_per_sample"]:
        overrides = [*case.get("set", []), f"time.steps_per_sample={steps}"]
        result = program.sound(f"{name}/{steps}", case["deck"], overrides)
        step = time_step(result)
        found = program.partials(result, case["start"], 40, case["highest"], case["channel"])
        rows = []
        for number, (mode, decay) in enumerate(modes, 1):
            predicted = stepped(mode, decay, step)
            nearest = min((peak.frequency for peak in found), key=lambda frequency: abs(frequency - predicted))
            rows.append(Row(f"mode {number}, step {1e6 * step:.3g} us", predicted, nearest, "Hz", case["tolerance"],
                            {"heard above the mesh's own, cents": signed(cents(nearest, mode)),
                             "predicted, cents": signed(cents(predicted, mode))}))
            points.append((2 * math.pi * mode * step, cents(nearest, mode), cents(predicted, mode)))
        tables.append(rows)
    return Section(tables, after=[] if program.short else draw(name, points))


def time_step(result):
    """s"""
    return Result(result).facts.step


def stepped(frequency, decay_time, step):
    """Hz at which central differences let a damped mode swing. sin(w' dt/2) = w dt/2 raises it by (w dt)^2/24; damping
    that acts with the velocity half a step ago is a little stiffness, zeta w dt/2; and damping itself lowers it by
    zeta^2/2."""
    half = math.pi * frequency * step
    zeta = math.log(1000) / (2 * math.pi * frequency * decay_time)
    return frequency * (math.asin(half) / half + zeta * half - zeta**2 / 2)


def draw(name, points):
    phase, heard, predicted = np.array(sorted(points)).T
    return pictures.log_log(name, [(phase, heard, "ko", "partials of the sound"), (phase, predicted, "r-", "predicted")],
                            "w dt", "cents above the mesh's frequency")
