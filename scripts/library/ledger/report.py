"""Writes the ledger down: verification/report.md."""

from .ledger import ERRORS, AtMost, row_table, signed, table
from .program import HOME

HEADING = ["# Verification report", "", "Written by tools/verify; docs/method/verification.md says what it means. Errors are in "
           "cents of a frequency, decibels of a level, percent of a decay time. Every case's worst judged row:", ""]


def section_text(name, case, section):
    """Lines of Markdown of one case."""
    overrides = "".join(f" `--set {each}`" for each in case.get("set", []))
    lines = [f"## {name}", "", case["title"], "", f"`{case['deck']}`{overrides}", "", *section.before]
    for rows in section.tables:
        lines += row_table(rows) if rows else []
    return lines + section.after


def worst(section):
    """One row for each unit in which the case is judged: the one nearest to its tolerance, or beyond it."""
    judged = [row for row in section.rows if row.tolerance is not None]
    for unit in dict.fromkeys(row.unit for row in judged):
        rows = [row for row in judged if row.unit == unit]
        yield len(rows), max(rows, key=strain)


def strain(row):
    """Error over tolerance; above 1 for a failure."""
    if row.error is None:
        return float("inf")
    if isinstance(row, AtMost):
        return 1 + row.error / 100
    return abs(row.error) / row.tolerance


def summary(sections):
    lines = []
    for name, section in sections.items():
        for count, row in worst(section):
            unit = ERRORS[row.unit][0]
            tolerance = "0 at most" if isinstance(row, AtMost) else f"{row.tolerance:g}"
            good = all(each.passed for each in section.rows if each.unit == row.unit)
            lines.append([f"[{name}](#{name})", row.quantity, str(count), f"{signed(row.error)} {unit}".strip(),
                          f"{tolerance} {unit}".strip(), "pass" if good else "**fail**"])
    return table(["case", "worst row", "rows", "its error", "tolerance", ""], lines)


def write(cases, sections):
    lines = HEADING + summary(sections)
    for name, section in sections.items():
        lines += section_text(name, cases[name], section)
    (HOME / "verification/report.md").write_text("\n".join(lines))
