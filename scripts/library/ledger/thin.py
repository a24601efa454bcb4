"""Frequencies by the theories of thin bodies: (mode, Hz) ascending, with every mode of a pair. `m` is the material (see
waves.py), lengths in m."""

import math
from itertools import product

from scipy.special import iv, ivp, jv, jvp

from .waves import ascending, crossings, plate_factor, shear_speed

# Leissa, Vibration of Plates, NASA SP-160 (1969), nu = 0.3: w L^2 sqrt(rho h/D).
LEISSA = {
    "clamped": [("(1,1)", 35.985), ("(1,2)", 73.39), ("(2,1)", 73.39), ("(2,2)", 108.22), ("(1,3)-(3,1)", 131.58),
                ("(1,3)+(3,1)", 132.20), ("(2,3)", 165.0), ("(3,2)", 165.0)],
    "free": [("twist", 13.468), ("saddle", 19.596), ("ring", 24.270), ("pair", 34.801), ("pair'", 34.801),
             ("next pair", 61.09), ("next pair'", 61.09)]}

# Roots beta L of thin bars: Kinsler, Frey, Coppens and Sanders, Fundamentals of Acoustics, 3.10 and 3.11.
BENDING = {"clamped": [1.87510, 4.69409, 7.85476, 10.99554, 14.13717],
           "free": [4.73004, 7.85320, 10.99561, 14.13717, 17.27876]}


def square_plate(m, edge, side, thickness):
    """Kirchhoff's plate; edge: clamped, free (Leissa's values) or simply_supported (exact)."""
    supported = [(f"({i},{j})", math.pi**2 * (i * i + j * j)) for i, j in product(range(1, 7), repeat=2)]
    table = LEISSA.get(edge, supported)
    factor = plate_factor(m, thickness) / (2 * math.pi * side**2)
    return ascending((name, factor * root) for name, root in table)


def circular_plate(m, edge, radius, thickness):
    """Kirchhoff's circular plate, clamped or free: (nodal diameters, circles without the rim)."""
    factor = plate_factor(m, thickness) / (2 * math.pi * radius**2)
    condition = {"clamped": clamped_rim, "free": free_rim}[edge]
    modes = []
    for n in range(8):
        roots = crossings(lambda x, n=n: condition(x, n, m["poisson"]), 0.5, 14.0)
        first = 1 if edge == "free" and n < 2 else 0  # the circles that rigid motions would have
        modes += [(f"({n},{s + first})", factor * root**2) for s, root in enumerate(roots) for _ in range(1 + (n > 0))]
    return ascending(modes)


def clamped_rim(x, n, _):
    """Leissa 1969, eq. 2.3."""
    return jv(n, x) * ivp(n, x) - jvp(n, x) * iv(n, x)


def free_rim(x, n, nu):
    """Leissa 1969, eq. 2.11: no moment and no force along the rim."""
    def terms(sign, value, slope):
        return (sign * x * x * value + (1 - nu) * (x * slope - n * n * value),
                sign * x**3 * slope + (1 - nu) * n * n * (x * slope - value))
    moment_j, force_j = terms(1, jv(n, x), jvp(n, x))
    moment_i, force_i = terms(-1, iv(n, x), ivp(n, x))
    return moment_j * force_i - moment_i * force_j


def bar(m, edge, length, width, thickness):
    """Bending by Euler and Bernoulli across both sides, longitudinal waves, torsion by Saint-Venant."""
    bar = math.sqrt(m["young"] / m["density"])
    modes = [(f"bending {name} {i + 1}", root**2 / (2 * math.pi * length**2) * bar * depth / math.sqrt(12))
             for name, depth in (("flat", thickness), ("edge", width)) for i, root in enumerate(BENDING[edge])]
    quarters = [i + 1 if edge == "free" else i + 0.5 for i in range(4)]
    for name, speed in ("longitudinal", bar), ("torsion", torsion_speed(m, width, thickness)):
        modes += [(f"{name} {i + 1}", halves * speed / (2 * length)) for i, halves in enumerate(quarters)]
    return ascending(modes)


def torsion_speed(m, width, thickness):
    """sqrt(G J/(rho I)) of a rectangular section; Timoshenko and Goodier, Theory of Elasticity, art. 109."""
    series = sum(math.tanh(n * math.pi * width / (2 * thickness)) / n**5 for n in range(1, 40, 2))
    stiffness = width * thickness**3 / 3 * (1 - 192 * thickness / (math.pi**5 * width) * series)
    polar = width * thickness * (width**2 + thickness**2) / 12
    return shear_speed(m) * math.sqrt(stiffness / polar)


def free_tube(m, length, outer, inner):
    """Hahn et al. 1995, f = pi K/(8 L^2) sqrt(E/rho) (3.011^2, 5^2, 7^2, ...), of a tube that bends as a thin bar; K is
    its radius of gyration (Fletcher and Rossing), half of hypot(outer, inner). outer, inner: radii."""
    factor = math.pi * math.hypot(outer, inner) / 2 / (8 * length**2) * math.sqrt(m["young"] / m["density"])
    return [(f"bending {i + 1}", factor * root**2) for i, root in enumerate([3.011, 5.0, 7.0, 9.0]) for _ in range(2)]
