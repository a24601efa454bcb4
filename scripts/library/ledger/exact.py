"""Frequencies by three-dimensional elasticity, exact: (mode, Hz) ascending, with every mode of a multiplet. `m` is the
material (see waves.py), lengths in m."""

import math
from itertools import product

import numpy as np
from scipy.optimize import brentq
from scipy.special import spherical_jn, spherical_yn

from .waves import ascending, crossings, plate_factor, pressure_speed, shear_speed


def supported_square_plate(m, side, thickness, halves=range(1, 7)):
    """Three-dimensional elasticity, exact: bending of a plate whose edges are held across and along, not outwards
    (Srinivas, Rao and Rao 1970). Its modes are standing Lamb waves of wave number pi sqrt(i^2 + j^2)/side, and these
    obey the Rayleigh-Lamb equation, antisymmetric branch. halves: the half waves along a side, all or the odd ones."""
    return ascending((f"({i},{j})", lamb_wave(m, math.pi * math.hypot(i, j) / side, thickness))
                     for i, j in product(halves, repeat=2))


def lamb_wave(m, k, thickness):
    """Hz of the lowest antisymmetric wave of wave number k (1/m), slower than shear:
    4 k^2 p q tanh(q h/2) = (k^2 + q^2)^2 tanh(p h/2), p and q = sqrt(k^2 - (w/c)^2) with c of pressure and of shear."""
    def residual(speed):
        p, q = (k * math.sqrt(1 - (speed / c)**2) for c in (pressure_speed(m), shear_speed(m)))
        return 4 * k * k * p * q * math.tanh(q * thickness / 2) - (k * k + q * q)**2 * math.tanh(p * thickness / 2)
    thin, shear = plate_factor(m, thickness) * k, shear_speed(m)  # Kirchhoff's plate is faster than the true one
    speed = brentq(residual, min(0.3 * thin, 0.5 * shear), min(1.01 * thin, 0.999 * shear), rtol=1e-13)
    return k * speed / (2 * math.pi)


def elastic_sphere(m, radius):
    """Three-dimensional elasticity, exact (Lamb 1882): torsional T_l and spheroidal S_l, each 2 l + 1 times."""
    return sphere_modes(m, radius, [1.0], [spherical_jn], 0.8)


def spherical_shell(m, radius, thickness):
    """Three-dimensional elasticity, exact: a hollow sphere (Eringen and Suhubi, Elastodynamics II, 8.14). radius: of the
    middle surface."""
    inner, outer = radius - thickness / 2, radius + thickness / 2
    return sphere_modes(m, outer, [1.0, inner / outer], [spherical_jn, spherical_yn], 0.5)


def sphere_modes(m, radius, surfaces, kinds, lowest):
    """Modes of a sphere with free surfaces at some parts of its radius, out of spherical Bessel functions of as many
    kinds; from x = w a/c_shear = lowest to 9."""
    factor = shear_speed(m) / (2 * math.pi * radius)
    ratio = shear_speed(m) / pressure_speed(m)
    modes = []
    for degree in range(8):
        conditions = {"S": breathing if degree == 0 else spheroidal} | ({"T": torsional} if degree else {})
        for name, rows in conditions.items():
            def tractions(x, rows=rows, degree=degree):
                matrix = np.block([[np.array(rows(x * part, degree, ratio, kind)) for kind in kinds] for part in surfaces])
                return np.linalg.det(matrix / np.linalg.norm(matrix, axis=0))
            for number, root in enumerate(crossings(tractions, lowest, 9.0)):
                modes += [(f"{number + 1}{name}{degree}", factor * root)] * (2 * degree + 1)
    return ascending(modes)


def torsional(x, n, _, bessel):
    """Shear at the surface: (n - 1) f_n(x) - x f_{n+1}(x)."""
    return [[(n - 1) * bessel(n, x) - x * bessel(n + 1, x)]]


def breathing(x, n, ratio, bessel):
    """Pressure at the surface of a motion without shear waves, n = 0."""
    return [[spheroidal(x, n, ratio, bessel)[0][0]]]


def spheroidal(x, n, ratio, bessel):
    """Normal and tangential traction at the surface, of pressure waves and of shear waves; x = w a/c_shear, ratio =
    c_shear/c_pressure (Eringen and Suhubi, Elastodynamics II, 8.14)."""
    y = ratio * x
    fx, fx1, fy, fy1 = bessel(n, x), bessel(n + 1, x), bessel(n, y), bessel(n + 1, y)
    return [[(n * n - n - x * x / 2) * fy + 2 * y * fy1, n * (n + 1) * ((n - 1) * fx - x * fx1)],
            [(n - 1) * fy - y * fy1, (n * n - 1 - x * x / 2) * fx + x * fx1]]
