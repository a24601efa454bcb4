"""A thin plate on edges that can turn but not move, struck so hard that it bends by its own thickness: how its middle
moves, against von Karman's equations."""

import numpy as np

from .frames import read_frames
from .ledger import Row, measured
from .pictures import picture
from .program import material, read_yaml
from .von_karman import Plate, struck

PADDING = 1024  # the spectrum's lines are so much closer than the window's resolution
QUARTER = 4   # the deck has a quarter of the plate, and of the force


def measure(name, case, program):
    """Rows for each of the case's `forces`, N, on the whole plate: the largest deflection of its middle, and the highest
    peak of its spectrum in each of the `windows`, s."""
    deck = read_yaml(case["deck"])
    deflections, pitches, motions = [], [], {}
    for force in case["forces"]:
        result = program.sound(f"{name}/{force:g}", case["deck"], [f"loads.blow.force=[0, 0, {-force / QUARTER:g}]"])
        time, computed = motion_of_the_middle(read_frames(result))
        expected = theory(case, deck, force, time)
        motions[force] = time, expected, computed
        deflections.append(Row(f"largest deflection, {force:g} N", abs(expected).max(), abs(computed).max(), "m",
                               case["deflection"]))
        pitches += [Row(f"pitch from {1000 * begin:g} to {1000 * end:g} ms, {force:g} N",
                        *(pitch(time, each, begin, end) for each in (expected, computed)), "Hz", case["tolerance"])
                    for begin, end in case["windows"]]
    if not program.short:
        draw(name, motions)
    return measured(case, [deflections, pitches], program)


def motion_of_the_middle(frames):
    """Times, s, and deflections of the node in the middle, m."""
    return frames.time, frames.displacement[:, np.argmin(np.linalg.norm(frames.nodes, axis=1)), 2]


def theory(case, deck, force, time):
    """The same deflections by von Karman's equations."""
    body, load = deck["bodies"]["plate"], deck["loads"]["blow"]
    size = body["parameters"]
    plate = Plate(size["length"], size["width"], size["thickness"], **material(case["deck"]),
                  loss=deck["materials"]["steel"]["damping"]["mass"])
    blow = {"force": -force, "radius": load["radius"], "duration": float(load["duration"])}
    return struck(plate, blow, body["model"]["up_to"], time).sum(axis=0)  # each mode is 1 in the middle


def pitch(time, deflection, begin, end):
    """Hz, of the highest peak of the spectrum of a stretch."""
    piece = deflection[(begin <= time) & (time < end)]
    length = PADDING * len(piece)
    level = abs(np.fft.rfft(piece * np.hanning(len(piece)), length))
    return np.fft.rfftfreq(length, time[1] - time[0])[level.argmax()]


def draw(name, motions):
    with picture(name, "time, ms", "deflection of the middle, mm") as axes:
        for force, (time, expected, computed) in motions.items():
            line, = axes.plot(1000 * time, 1000 * expected, linewidth=3, alpha=0.4, label=f"von Karman, {force:g} N")
            axes.plot(1000 * time, 1000 * computed, color=line.get_color(), linewidth=1, label=f"modal body, {force:g} N")
        axes.grid(alpha=0.3)
