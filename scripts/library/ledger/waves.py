"""Speeds of waves and roots of equations that the formulas share. `m` is a material: young (Pa), poisson, density
(kg/m3)."""

import math

import numpy as np
from scipy.optimize import brentq


def shear_speed(m):
    return math.sqrt(m["young"] / (2 * (1 + m["poisson"]) * m["density"]))


def pressure_speed(m):
    nu = m["poisson"]
    return shear_speed(m) * math.sqrt(2 * (1 - nu) / (1 - 2 * nu))


def plate_factor(m, thickness):
    """sqrt(D/(rho h)), m2/s."""
    return thickness * math.sqrt(m["young"] / (12 * (1 - m["poisson"]**2) * m["density"]))


def crossings(function, low, high):
    """Where a function changes sign."""
    x = np.linspace(low, high, 4000)
    values = np.array([function(each) for each in x])
    places = np.flatnonzero(np.sign(values[:-1]) * np.sign(values[1:]) < 0)
    return [brentq(function, x[i], x[i + 1], xtol=1e-13) for i in places]


def ascending(modes):
    return sorted(modes, key=lambda mode: mode[1])

