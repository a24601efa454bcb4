"""Peaks of a sound that the whole program computed: deck, mesh, motion, filters, radiation."""

import itertools
import subprocess

from . import decay, levels, pictures, references, steps
from .ledger import AtMost, Row, Section, cents, signed
from .program import HOME, read_yaml

CHANNEL = ".left"   # the ear that is looked at
WINDOW = 0.02       # a peak farther from its reference than this part of it isn't that mode's
SAME = 0.0015       # part of the frequency within which a partial is a silent mode's
FAINTEST = 50       # dB below the strongest, nothing fainter is taken for a mode
START = 0.02        # s; the blow is over and its sound has passed the ears
HIGHEST = 4000      # Hz; no mode looked at is above it, unless the case says so
RANGE = 80          # dB below the strongest down to which silence is measured
STEP = 1.0          # cent that time integration, damping and filters may add to the mesh's own frequency


def measure(name, case, program):
    result = program.sound(name, case["deck"], case.get("set", []))
    found = heard(case, result, program)
    rows = compare(case, found)
    tables = [rows]
    if "tolerance" in case:
        tables.append(chain(name, case, rows, result, program))
    if "decay" in case:
        tables.append(decay.rows(case, rows, found))
    if "level" in case:
        tables.append(levels.rows(name, case, rows, found, program))
    if "beside" in case and (there := beside(case["beside"], program)):
        tables.append(silence(case, found, rows, there))
    return Section(tables, after=[] if program.short else draw(name, result, rows))


def beside(name, program):
    """The rows of another case whose sound is there."""
    case = read_yaml(f"verification/cases/{name}.yaml")
    result = program.result(name, case["deck"])
    return compare(case, heard(case, result, program)) if result.exists() else None


def heard(case, result, program):
    """The partials (program.Partial) of one channel."""
    return program.partials(result, case.get("start", START), RANGE, case.get("highest", HIGHEST),
                            case.get("channel", CHANNEL))


def compare(case, found):
    """Rows of the modes that sound. Without a tolerance the modes are the lowest peaks in turn, or those that `peaks`
    numbers."""
    loudest = max(peak.level for peak in found)
    strong = [peak for peak in found if peak.level > loudest - case.get("faintest", FAINTEST)]
    modes = [(mode, frequency) for mode, frequency in references.modes(case) if mode not in case.get("silent", [])]
    if "tolerance" not in case:
        numbers = case.get("peaks", range(1, len(modes) + 1))
        peaks = [strong[number - 1] if number <= len(strong) else None for number in numbers]
    else:
        different = sorted({frequency for _, frequency in references.modes(case)})
        nearest = dict(zip(different, match_in_order(different, strong)))
        peaks = [nearest[frequency] for _, frequency in modes]
    return [Row(mode, frequency, peak and peak.frequency, "Hz", case.get("tolerance"),
                {"level, dB": f"{peak.level:.1f}"} if peak else {}) for (mode, frequency), peak in zip(modes, peaks)]


def match_in_order(references, found):
    """For each reference a peak near to it or none, in ascending order and as near as can be. A reference without a peak
    costs as much as the farthest one, so that neighbours don't take each other's peaks."""
    def off(peak, reference):
        return abs(peak.frequency / reference - 1)

    near = [[None] + [peak for peak in found if off(peak, reference) < WINDOW] for reference in references]

    def ascends(choice):
        return all(a.frequency < b.frequency for a, b in itertools.pairwise(peak for peak in choice if peak))

    def cost(choice):
        return sum(off(peak, reference) if peak else WINDOW for peak, reference in zip(choice, references))

    return min(filter(ascends, itertools.product(*near)), key=cost)


def chain(name, case, rows, result, program):
    """Peaks against the frequencies of the same mesh: what the step in time, the damping and the filters add."""
    step = steps.time_step(result)
    modes = list(zip(*program.modes(name, case["deck"], case.get("set", []), case.get("count", 2 * len(references.modes(case))))))
    heard_rows = {row.computed: row for row in rows if row.computed}
    lines = []
    for frequency, row in heard_rows.items():
        mesh, decay_time = min(modes, key=lambda mode: abs(mode[0] - frequency))
        lines.append(Row(f"{row.quantity}, all but the mesh", mesh, frequency, "Hz", STEP,
                         {"step foretells, cents": signed(cents(steps.stepped(mesh, decay_time, step), mesh)),
                          "mesh alone, cents": signed(cents(mesh, row.reference))}))
    return lines


def silence(case, found, rows, rows_beside):
    """Levels of the modes that the strike must leave out, dB re the first mode: `margin` below it and below what the
    other sound has of them. A mode's place is where the mesh puts it: as far off its reference as the nearest mode that
    sounds is. Where there is no partial, its level is the search's floor: the true one is lower still."""
    floor = max(peak.level for peak in found) - RANGE
    first = float(rows[0].beside["level, dB"])
    lines = []
    for there in (row for row in rows_beside if row.quantity in case["silent"]):
        nearest = min(rows, key=lambda row: abs(row.reference - there.reference))
        place = there.reference * nearest.computed / nearest.reference
        here = max([peak.level for peak in found if abs(peak.frequency / place - 1) < SAME], default=floor)
        other = float(there.beside["level, dB"]) - float(rows_beside[0].beside["level, dB"])
        lines.append(AtMost(f"{there.quantity} stays silent, at most", min(0, other) - case["margin"],
                            here - first, "dB", 0, {"in the other sound, dB": f"{other:.1f}"}))
    return lines


def draw(name, result, rows):
    """A picture of the spectrum a little beyond the highest mode."""
    maximum = 1.3 * max(max(row.reference, row.computed or 0) for row in rows)
    pictures.FOLDER.mkdir(exist_ok=True)
    subprocess.run([HOME / "scripts/spectrum", result, "-o", pictures.FOLDER / f"{name}.png",
                    "--max-frequency", f"{maximum:.0f}"], check=True, stdout=subprocess.DEVNULL)
    return [f"![spectrum](pictures/{name}.png)", ""]
