"""Levels of the radiation models of `run` against boundary elements: radiated power of modes or rigid motions, and the
worst direction."""

import math

from .ledger import Row, Section, signed

TOLERANCES = {"kirchhoff": None, "rayleigh": None, "waves": 0.5}  # dB of the power; None: the row is shown, not judged


def measure(name, case, program):
    found = program.radiation(name, case["deck"], [*case["motions"], "--waves", case["cell"]], case.get("set", []))
    rows = []
    for sound in found["sounds"]:
        level = 10 * math.log10(sound["power"] / 1e-12)
        for model, tolerance in TOLERANCES.items():
            rows.append(Row(f"{model}, {sound['motion']} at {sound['frequency']:.0f} Hz", level,
                            level + sound[f"{model}_error"], "dB", tolerance,
                            beside={"worst direction, dB": signed(sound[f"{model}_worst"])}))
    before = [f"{found['triangles']} triangles; cells of {1000 * case['cell']:g} mm. "
              "Levels are those of the radiated power for 1 m sqrt(kg)/s of a mode or 1 m/s of a rigid motion, dB re 1 pW. "
              "Directions that are 10 dB below the mean do not count as worst.", ""]
    return Section([rows], before=before)
