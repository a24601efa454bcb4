"""What a case is judged by."""

from . import exact, limits, taut, thin
from .program import material, read_yaml


def modes(case):
    """[(mode, Hz)], ascending: limits of refined meshes, a formula's, or the first set of the deck's references, which
    the case names in `modes`."""
    given = case.get("reference")
    if given is None:
        return list(zip(case["modes"], next(iter(read_yaml(case["deck"])["references"].values()))))
    if "limits" in given:
        return limits.known(given["limits"])[:case["count"]]
    return formula(given, case["deck"])[:case["count"]]


def theory(case):
    """Hz by the thin body's theory that the case names, or none."""
    return [frequency for _, frequency in formula(case["theory"], case["deck"])] if "theory" in case else []


def formula(given, deck):
    """[(mode, Hz)] by a function of exact.py, taut.py or thin.py, which the case calls exact.NAME, taut.NAME or
    thin.NAME, for the deck's material."""
    module, function = given["formula"].split(".")
    arguments = {key: value for key, value in given.items() if key != "formula"}
    return getattr({"exact": exact, "taut": taut, "thin": thin}[module], function)(material(deck), **arguments)
