"""Frequencies by three-dimensional elasticity, exact: (mode, Hz) ascending, with every mode of a multiplet. `m` is the
material (see waves.py), lengths in m."""

import math
from itertools import product

from scipy.optimize import brentq
from scipy.special import spherical_jn

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
    factor = shear_speed(m) / (2 * math.pi * radius)
    ratio = shear_speed(m) / pressure_speed(m)
    modes = []
    for degree in range(8):
        kinds = [("S", lambda x, n=degree: spheroidal(x, n, ratio))]
        kinds += [("T", lambda x, n=degree: torsional(x, n))] if degree else []
        for kind, condition in kinds:
            for number, root in enumerate(crossings(condition, 0.8, 9.0)):
                modes += [(f"{number + 1}{kind}{degree}", factor * root)] * (2 * degree + 1)
    return ascending(modes)


def torsional(x, n):
    """No shear at the surface: (n - 1) j_n(x) = x j_{n+1}(x)."""
    return (n - 1) * spherical_jn(n, x) - x * spherical_jn(n + 1, x)


def spheroidal(x, n, ratio):
    """No traction at the surface; x = w a/c_shear, ratio = c_shear/c_pressure (Eringen and Suhubi, Elastodynamics II,
    8.14)."""
    y = ratio * x
    jx, jx1, jy, jy1 = spherical_jn(n, x), spherical_jn(n + 1, x), spherical_jn(n, y), spherical_jn(n + 1, y)
    normal_pressure = (n * n - n - x * x / 2) * jy + 2 * y * jy1
    if n == 0:
        return normal_pressure
    normal_shear = n * (n + 1) * ((n - 1) * jx - x * jx1)
    along_pressure = (n - 1) * jy - y * jy1
    along_shear = (n * n - 1 - x * x / 2) * jx + x * jx1
    return normal_pressure * along_shear - normal_shear * along_pressure
