"""How errors fall with the element size: modes of one body on several meshes, with both masses."""

import matplotlib
import numpy as np

from . import references
from .ledger import Row, Section, cents, signed, table
from .program import HOME

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402


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
    picture = HOME / f"verification/pictures/{name}.png"
    figure, axes = plt.subplots(figsize=(6, 4))
    for mass, colour in ("lumped", "black"), ("consistent", "firebrick"):
        axes.loglog(sizes, np.abs(errors[mass]), ".", color=colour, alpha=0.4)
        axes.loglog(sizes, np.median(np.abs(errors[mass]), axis=1), color=colour, label=f"{mass} mass, median")
    axes.axhline(5, color="grey", linestyle=":", label="5 cents")
    axes.set(xlabel="element size, m", ylabel="error, cents", title=case["title"].split(",")[0].split(";")[0])
    axes.legend()
    axes.grid(which="both", alpha=0.3)
    figure.tight_layout()
    figure.savefig(picture, dpi=110)
    plt.close(figure)
    return [f"![errors over the element size](pictures/{name}.png)", ""]
