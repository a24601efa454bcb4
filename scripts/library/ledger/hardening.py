"""Thin bodies between immovable supports: the larger the vibration, the higher its pitch. Each period of one decaying
vibration gives an amplitude and a frequency, and these are laid beside the curve of theory."""

import itertools
import sys

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.special import ellipk

from . import glide
from .frames import read_frames
from .ledger import Row, measured
from .pictures import picture
from .program import read_yaml


def hinged_bar(thickness, _):
    """c of w0^2 (1 + c q^2) q, 1/m^2: a bar of rectangular section on immovable hinges. Its axial force is
    E A (pi q/(2 L))^2, and a half sine solves the equation of motion exactly. Woinowsky-Krieger, J. Appl. Mech. 17
    (1950) 35."""
    return 1 / (4 * thickness**2 / 12)


def supported_plate(thickness, poisson):
    """The same of a simply supported square plate whose edges are held outwards and free to slide along: von Karman's
    equations with one mode, sin sin. Chu and Herrmann, J. Appl. Mech. 23 (1956) 532."""
    return 3 * (1 - poisson**2) * (1 / 8 + 1 / (4 * (1 - poisson))) / thickness**2


THEORIES = {"hinged bar": hinged_bar, "supported plate": supported_plate}


def duffing_ratio(x):
    """Frequency over that of small vibrations of q'' + w0^2 (1 + c q^2) q = 0 at the amplitude a, x = c a^2: exact."""
    return np.pi * np.sqrt(1 + x) / (2 * ellipk(x / (2 * (1 + x))))


def measure(name, case, program):
    """Rows at the case's `amplitudes`, in units of `unit_length` m."""
    overrides = case.get("set", [])
    small = program.shapes(name, case["deck"], overrides, count=6)
    pitch = small.frequencies[0]
    result = program.sound(name, case["deck"], overrides)
    time, deflection = modal_deflection(read_frames(result), small.shapes[0])
    amplitude, frequency = periods(time, deflection)
    coefficient = theory(case)
    wanted = case["unit_length"] * np.array(case["amplitudes"])
    if not np.all((amplitude.min() < wanted) & (wanted < amplitude.max())):
        sys.exit(f"{name}: amplitudes {amplitude / case['unit_length']} {case['unit']} aren't on both sides of each of "
                 f"{case['amplitudes']}")
    fit = np.polynomial.Polynomial.fit(amplitude**2, (frequency / pitch)**2, case.get("degree", 2))
    rows = [Row(f"pitch at an amplitude of {number} {case['unit']}", pitch * duffing_ratio(coefficient * a * a),
                pitch * np.sqrt(fit(a * a)), "Hz", case["tolerance"])
            for number, a in zip(case["amplitudes"], wanted)]
    if not program.short:
        draw(name, case, amplitude, frequency / pitch, coefficient)
    if "glide" in case:
        rows += glide.measure(name, case, program, result, pitch, deflection[0], coefficient)
    return measured(case, [rows], program)


def theory(case):
    deck = read_yaml(case["deck"])
    body, material = next(iter(deck["bodies"].values())), next(iter(deck["materials"].values()))
    return THEORIES[case["theory"]](body["parameters"]["thickness"], material["poisson"])


def modal_deflection(frames, shape):
    """Times, s, and how far the middle is deflected in the mode, m: other modes are projected out."""
    across = shape[:, 2] / shape[np.argmin(np.linalg.norm(frames.nodes, axis=1)), 2]
    return frames.time, frames.displacement[:, :, 2] @ across / (across @ across)


def periods(time, deflection):
    """Amplitude, m, and frequency, Hz, of each period from one upward passage through zero to the next."""
    motion = CubicSpline(time, deflection)
    turns = motion.derivative().roots(extrapolate=False)
    zeros = motion.roots(extrapolate=False)
    upward = zeros[motion(zeros, 1) > 0]
    found = []
    for begin, end in itertools.pairwise(upward):
        extremes = motion(turns[(turns > begin) & (turns < end)])
        found.append(((extremes.max() - extremes.min()) / 2, 1 / (end - begin)))
    return np.transpose(found)


def draw(name, case, amplitude, ratio, coefficient):
    unit = case["unit_length"]
    line = np.linspace(0, 1.05 * amplitude.max(), 200)
    with picture(name, f"amplitude in the middle, {case['unit']}", "frequency / that of small vibrations") as axes:
        axes.plot(line / unit, duffing_ratio(coefficient * line**2), color="0.5", label="theory")
        axes.plot(amplitude / unit, ratio, "o", markersize=4, label="computed, one period each")
        axes.grid(alpha=0.3)
