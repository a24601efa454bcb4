"""Bodies that somebody measured: `idiophone identify` fits elastic constants to their lowest resonances and predicts the
others."""

from .ledger import AtMost, Row, Section
from .program import HOME


def measure(name, case, program):
    """Judged: the root of the mean square of the predicted lines' distances, and that every line is a mode and every mode
    a line, but for those that were not measured. Each line is shown."""
    found = program.facts("identify", case["deck"],
                          options=["--measured", HOME / case["measured"], "--lines", case["fitted"],
                                   "--fit", case.get("fit", "constants")])
    lines = found["lines"]
    false_lines = sum(line["mode"] is None for line in lines)
    judged = [AtMost(f"rms of the {len(lines) - case['fitted']} predicted lines", case["tolerance"],
                     found["predicted_rms"], "cents", 0),
              AtMost("false lines", 0, false_lines, "", 0),
              AtMost("modes without a line", case.get("not_measured", 0), len(found["not_measured"]), "", 0)]
    shown = [Row(f"mode {line['mode']}, {'fitted' if line['fitted'] else 'predicted'}", line["measured"],
                 line.get("computed"), "Hz") for line in lines]
    return Section([judged, shown], before=[f"{case['source']}.", "", *map(constant_text, found["constants"].items()), ""])


def constant_text(item):
    name, constant = item
    return f"- {name}: {constant['value']:.6g}, 95 % interval +-{constant['half_width']:.2g}"
