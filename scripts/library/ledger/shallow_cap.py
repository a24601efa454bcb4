"""Free discs and shallow spherical caps: how the pitches of a sound map bend with the amplitude, against Marguerre's
equations."""

import numpy as np
from idiophone.files import opened

from .ledger import Row, measured
from .program import material, read_yaml
from .shallow_shell import ShallowShell, bend, disc

MODES = 20  # of the map, and of the reference
CENTS = 1200 / np.log(2)


def measure(name, case, program):
    """Rows for each of the case's `heights` of the middle over the rim, thicknesses, and each of its `modes`: by how much the
    pitch changes from small vibrations to the `amplitude`, a root mean square over the body in thicknesses, to second
    order."""
    deck = read_yaml(case["deck"])
    tables = []
    for height in case["heights"]:
        shell = ShallowShell(disc(), height, material(case["deck"])["poisson"])
        computed = bends_of_map(name, case, height, deck["bodies"]["cap"], program)
        tables.append([Row(f"mode {mode}, height {height:g}", *(CENTS * case["amplitude"]**2 * share for share in
                                                             (shell.bend_of(number, MODES), computed[number])), "cents",
                           case["tolerance"]) for mode, number in case["modes"].items()])
    return measured(case, tables, program)


def bends_of_map(name, case, height, body, program):
    """Of each mode, at a root mean square deflection of one thickness."""
    folder = program.results / name / f"{height:g}"
    size, thickness = body["parameters"], body["thickness"]
    overrides = [f"bodies.cap.parameters.z{point + 1}={z!r}" for point, z in enumerate(parabola(size, height * thickness))]
    program.facts("map", case["deck"], overrides, ["--modes", MODES, "--radiation", "kirchhoff", "--no-estimate",
                                                   "--output-folder", folder])
    with opened(folder / "shallow_cap_cap.map.h5", "sound map") as file:
        mass, frequencies = float(file.attrs["mass"]), 2 * np.pi * file["modes/frequency"][()]
        linear, quadratic = file["stretching/linear"][()], file["stretching/quadratic"][()]
    return [bend(frequencies, mode, linear.T, quadratic[:, mode, mode], quadratic[:, mode].T) *
            mass * thickness**2 for mode in range(MODES)]


def parabola(size, height):
    """Heights of the five points of a cubic B-spline that is the parabola -height (r/radius)^2; their radii are evenly
    spaced but for the first and the last gap, which are half as wide as the others."""
    inner, rim = size["r1"], size["r5"]
    middle = (inner + rim) / 2
    knots = [inner] * 3 + [middle] + [rim] * 3
    triples = [knots[:3], knots[1:4], knots[2:5], knots[3:6], knots[4:]]
    return [-height * (a * b + b * c + c * a) / 3 / rim**2 for a, b, c in triples]
