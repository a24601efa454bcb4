"""Frequencies of taut bodies with stiffness: (mode, Hz) ascending, with every mode of a pair. `m` is the material (see
waves.py), lengths in m, stress in Pa, that at rest."""

import math

from scipy.optimize import brentq
from scipy.special import ive, jv, jvp

from .waves import ascending, crossings, plate_factor, shear_speed


def clamped_string(m, length, radius, stress, count=25):
    """A round string clamped at both ends: bending by Euler and Bernoulli with tension (Fletcher, Journal of the
    Acoustical Society of America 36, 1964), longitudinal waves and torsion, whose stiffness the stress adds to."""
    bar = m["young"] / m["density"]
    taut = stress / m["density"]
    bending = bar * radius**2 / 4  # E I/(rho A), m4/s2
    modes = []
    for n in range(1, count + 1):  # k length lies between n pi and (n + 1/2) pi
        low, high = math.pi * (n + 1e-9), math.pi * (n + 0.4999)
        k = brentq(lambda x: string_ends(x, length, taut / bending), low / length, high / length, xtol=1e-13)
        modes += [(f"partial {n}{prime}", k * math.sqrt(taut + bending * k * k) / (2 * math.pi)) for prime in ("", "'")]
    for name, square in ("longitudinal", bar), ("torsion", shear_speed(m)**2):
        modes += [(f"{name} {n}", n * math.sqrt(square + taut) / (2 * length)) for n in range(1, 5)]
    return ascending(modes)


def string_ends(k, length, ratio):
    """Zero where a string is clamped at both ends, with waves of the wave number k; ratio: tension/(E I), 1/m2."""
    decay = math.sqrt(k * k + ratio)  # of the bending near the ends, 1/m
    return (2 * k * decay * (1 / math.cosh(min(decay * length, 700)) - math.cos(k * length))
            + ratio * math.sin(k * length) * math.tanh(decay * length))


def clamped_membrane(m, radius, thickness, stress):
    """A circular membrane clamped at its rim, with the stiffness of Kirchhoff's plate: (nodal diameters, circles without
    the rim). Its shapes are J_n(k r) and I_n(q r) with q^2 = k^2 + tension/D (Leissa, Vibration of Plates, 1969, 10.2)."""
    taut = stress / m["density"]
    bending = plate_factor(m, thickness)**2

    def rim(x, n):
        decay = math.hypot(x, radius * math.sqrt(taut / bending))
        slope = (ive(abs(n - 1), decay) + ive(n + 1, decay)) / 2
        return x * jvp(n, x) * ive(n, decay) - decay * slope * jv(n, x)

    modes = []
    for n in range(10):
        for s, root in enumerate(crossings(lambda x, n=n: rim(x, n), 0.5, 16.0)):
            k = root / radius
            modes += [(f"({n},{s})", k * math.sqrt(taut + bending * k * k) / (2 * math.pi))] * (1 + (n > 0))
    return ascending(modes)
