"""Frequencies that `idiophone modes` finds on the meshes that the guide recommends."""

from . import exact, limits, thin
from .ledger import Row, Section, cents, signed
from .program import material


def reference(case):
    """[(mode, Hz)] that the case is judged by: a formula's, a limit's, or written down in the case."""
    given = case["reference"]
    if "limit" in given:
        modes = [(mode, frequency) for mode, frequency, _ in limits.known(given["limit"])]
        return [(mode, frequency * given.get("scale", 1)) for mode, frequency in modes]
    if "formula" in given:
        return formula(given, case["deck"])
    return [(mode, frequency) for mode, frequency in given["modes"].items()]


def formula(given, deck):
    """The modes of a function of exact.py or thin.py, named as `exact.NAME`."""
    module, function = given["formula"].split(".")
    arguments = {key: value for key, value in given.items() if key != "formula"}
    return getattr({"exact": exact, "thin": thin}[module], function)(material(deck), **arguments)


def measure(name, case, program):
    """Judged: the lumped mass, which the motion has. Beside it the consistent one, and a thin body's theory."""
    wanted = reference(case)[:case["count"]]
    lumped, consistent = (program.modes(f"{name}", case["deck"], case.get("set", []), len(wanted), mass)[0]
                          for mass in ("lumped", "consistent"))
    theory = thin_theory(case, wanted)
    rows = []
    for (mode, frequency), sound, other, thin_value in zip(wanted, lumped, consistent, theory):
        beside = {"consistent mass, cents": signed(cents(other, frequency))}
        if thin_value:
            beside["thin theory, cents"] = signed(cents(thin_value, frequency))
        rows.append(Row(mode, frequency, sound, "Hz", case["tolerance"], beside))
    return Section([rows])


def thin_theory(case, wanted):
    """Of each mode, the frequency of the nearest in rank by the thin theory that the case names."""
    if "beside" not in case:
        return [None] * len(wanted)
    modes = [frequency for _, frequency in formula(case["beside"], case["deck"])]
    return (modes + [None] * len(wanted))[:len(wanted)]
