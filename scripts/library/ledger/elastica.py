"""A slender cantilever in static equilibrium under a force on its tip, against Euler's elastica."""

import numpy as np
from scipy.optimize import brentq
from scipy.special import ellipe, ellipeinc, ellipk, ellipkinc

from .frames import read_frames
from .ledger import Row, measured
from .pictures import picture
from .program import read_yaml


def tip(load):
    """How far the tip sinks and comes back, both over the length, under the load F L^2/(E I). With the tip's slope s,
    m = (1 + sin s)/2 and sin p = 1/sqrt(2 m): sqrt(load) = K(m) - F(p, m), and the tip sinks by
    1 - 2 (E(m) - E(p, m))/sqrt(load) and stays at sqrt(2 sin s/load). Bisshopp and Drucker, Q. Appl. Math. 3 (1945)
    272."""
    def parameters(slope):
        m = (1 + np.sin(slope)) / 2
        return m, np.arcsin(1 / np.sqrt(2 * m))

    def residual(slope):
        m, p = parameters(slope)
        return ellipk(m) - ellipkinc(p, m) - np.sqrt(load)
    slope = brentq(residual, 1e-9, np.pi / 2 - 1e-9, xtol=1e-14)
    m, p = parameters(slope)
    return 1 - 2 * (ellipe(m) - ellipeinc(p, m)) / np.sqrt(load), 1 - np.sqrt(2 * np.sin(slope) / load)


def measure(name, case, program):
    """Rows for each of the case's `loads` on its finest mesh; `sizes` are those of the elements, m, the finest last."""
    length, stiffness = length_and_stiffness(read_yaml(case["deck"]))
    rows = {(size, load): tip_rows(name, case, program, size, load, length, load * stiffness / length**2)
            for size in case["sizes"] for load in case["loads"]}
    if not program.short:
        draw(name, case, rows)
    return measured(case, [[row for load in case["loads"] for row in rows[case["sizes"][-1], load]]], program)


def length_and_stiffness(deck):
    """Length, m, and bending stiffness E I, N m^2, of the cantilever that is half as long and wide as the deck says."""
    size = deck["bodies"]["bar"]["parameters"]
    inertia = size["width"] / 2 * size["thickness"]**3 / 12
    return size["length"] / 2, deck["materials"]["steel"]["young"] * inertia


def tip_rows(name, case, program, size, load, length, force):
    """The tip's displacement across the bar and back along it, mean of the end face at time 0."""
    frames = read_frames(program.sound(f"{name}/{size:g}_{load:g}", case["deck"], [
        f"bodies.bar.parameters.size={size}", f"loads.pull.force=[0, 0, {force:.12g}]"]))
    along, _, across = frames.displacement[0][np.isclose(frames.nodes[:, 0], length)].mean(axis=0)
    return [Row(f"tip under F L²/(E I) = {load:g}, {word}", length * reference, computed, "m", case["tolerance"])
            for word, reference, computed in zip(("across", "back"), tip(load), (across, -along))]


def draw(name, case, rows):
    with picture(name, "length of the elements, m", "error of the tip's displacement across, %") as axes:
        for load in case["loads"]:
            axes.loglog(case["sizes"], [abs(rows[size, load][0].error) for size in case["sizes"]], "o-",
                        label=f"F L²/(E I) = {load:g}")
        axes.grid(which="both", alpha=0.3)
