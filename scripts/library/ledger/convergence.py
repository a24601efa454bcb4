"""How errors fall with the element size: modes of one body on several meshes, with both masses."""

import numpy as np

from . import pictures, references
from .ledger import Row, Section, cents, signed, table


def measure(name, case, program):
    """Shown: cents of each mode on each mesh. Judged: the order at which the errors of each mass fall, at least
    `orders`; a slope fitted to the median error of the modes."""
    wanted = references.modes(case)
    sizes = [mesh["size"] for mesh in case["meshes"]]
    errors = {mass: np.array([errors_on(name, case, mesh, wanted, mass, program) for mesh in case["meshes"]])
              for mass in ("lumped", "consistent")}
    rows = []
    for mass, order in case["orders"].items():
        typical = np.median(np.abs(errors[mass]), axis=1)
        slope = np.polyfit(np.log(sizes), np.log(typical), 1)[0]
        rows.append(Row(f"order, {mass} mass", order, slope, "order", case["tolerance"]))
    lines = [[mode, *(f"{signed(errors['lumped'][m][i])} / {signed(errors['consistent'][m][i])}"
                      for m in range(len(sizes)))] for i, (mode, _) in enumerate(wanted)]
    text = ["Errors in cents, lumped / consistent mass:", "",
            *table(["mode", *(f"{size:g} m" for size in sizes)], lines)]
    return Section([rows], before=text, after=[] if program.short else draw(name, case, sizes, errors))


def errors_on(name, case, mesh, wanted, mass, program):
    """Cents of the modes on one mesh, [modes]."""
    overrides = [*case.get("set", []), *mesh["set"]]
    found, _ = program.modes(f"{name}/{mesh['size']:g}", case["deck"], overrides, len(wanted), mass)
    return [cents(frequency, exact) for frequency, (_, exact) in zip(found, wanted)]


def draw(name, case, sizes, errors):
    series = [(sizes, np.full(len(sizes), 5.0), "b:", "5 cents")]
    for mass, colour in ("lumped", "k"), ("consistent", "r"):
        each = np.abs(errors[mass])
        series.append((sizes, each, colour + ".", None))
        series.append((sizes, np.median(each, axis=1), colour + "-", f"{mass} mass, median"))
    return pictures.log_log(name, series, "element size, m", "error, cents", case["title"].split(",")[0])
