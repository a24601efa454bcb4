"""Limits of refined meshes: frequencies of three-dimensional elasticity where no formula gives them.

A body is cut along its planes of symmetry, so that its modes fall into families that cannot mix. Each family is computed
with the consistent mass, from above, on three meshes; f = limit + C h^order through the three gives the limit."""

import copy
import sys

import yaml
from scipy.optimize import brentq

from . import pictures
from .ledger import Row, Section, cents, number
from .program import HOME

FOLDER = HOME / "verification/limits"


def measure(name, case, program):
    """Computes the limits and keeps them in verification/limits/NAME.yaml. Judged: how far the finest mesh is from them,
    which bounds what they can be wrong by. Where there is no order, the finest mesh stands for the limit, and the one
    before it is judged."""
    families = [limits_of(name, case, family, program) for family in case["families"]]
    modes = sorted((mode for family in families for mode in family), key=lambda mode: mode["frequency"])
    modes = modes[:case["count"]]
    for family in families:
        if family[-1]["frequency"] < modes[-1]["frequency"] and len(families) > 1:
            sys.exit(f"{name}: a mode above {family[-1]['mode']} may be missing: raise the count of its family")
    FOLDER.mkdir(exist_ok=True)
    heading = f"# Hz, written by tools/verify {name}; docs/method/verification.md\n"
    (FOLDER / f"{name}.yaml").write_text(heading + yaml.safe_dump(modes, sort_keys=False))
    rows = []
    for mode in modes:
        judged = mode["meshes"][-2 if mode["order"] == "-" else -1]
        beside = {f"mesh {m + 1}, Hz": number(f) for m, f in enumerate(mode["meshes"])} | {"order": mode["order"]}
        rows.append(Row(mode["mode"], mode["frequency"], judged, "Hz", case["tolerance"], beside))
    lines = [f"{m + 1}. `{' '.join(mesh['set'])}`" for m, mesh in enumerate(case["meshes"])]
    return Section([rows], before=["Meshes, with the consistent mass:", "", *lines, ""],
                   after=[] if program.short else draw(name, case, modes))


def draw(name, case, modes):
    """Errors against the limits over the element size, of the modes that have an order; a mode that a pair shares once."""
    sizes = [mesh["size"] for mesh in case["meshes"]]
    ordered = {mode["mode"]: mode for mode in modes if mode["order"] != "-"}
    if not ordered:
        return []
    series = [(sizes, [cents(f, mode["frequency"]) for f in mode["meshes"]], "o-", f"{label}, order {mode['order']}")
              for label, mode in ordered.items()]
    return pictures.log_log(name, series, "element size", "error, cents", case["title"].split(",")[0])


def limits_of(name, case, family, program):
    """One family's modes; a pair that a symmetry gives one frequency appears `times` 2."""
    sizes = [mesh["size"] for mesh in case["meshes"]]
    found = [program.modes(f"{name}/{family['name']}_{size:g}".replace(" ", "_"), case["deck"],
                           [*case.get("set", []), *family.get("set", []), *mesh["set"]],
                           family["count"], "consistent")[0] for mesh, size in zip(case["meshes"], sizes)]
    modes = []
    for rank, frequencies in enumerate(zip(*found), 1):
        limit, order = extrapolated(sizes, frequencies)
        mode = {"mode": f"{family['name']} {rank}", "frequency": round(limit, 5),
                "order": f"{order:.1f}" if order else "-", "meshes": [round(f, 5) for f in frequencies]}
        modes += [copy.deepcopy(mode) for _ in range(family.get("times", 1))]
    return modes


def extrapolated(sizes, values):
    """(limit, order) of three values; an order below 1 is taken for 1. Where they don't converge from above, or too fast
    to tell, the last and None."""
    (a, b, c), (first, second, third) = sizes, values
    if not first > second > third:
        return third, None

    def mismatch(order):
        return (first - second) * (b**order - c**order) - (second - third) * (a**order - b**order)

    low, high = 1.0, 8.0  # beyond: not the rate of any element here
    if mismatch(high) > 0:
        return third, None
    order = brentq(mismatch, low, high) if mismatch(low) > 0 else low
    return third - (second - third) * c**order / (b**order - c**order), order


def known(name):
    """(mode, Hz) of the limits that a case left."""
    return [(mode["mode"], mode["frequency"]) for mode in yaml.safe_load((FOLDER / f"{name}.yaml").read_text())]
