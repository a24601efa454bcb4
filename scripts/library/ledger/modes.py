"""Frequencies that `idiophone modes` finds, on the meshes that docs/use/mesh_guide.md recommends."""

from . import references
from .ledger import Row, Section, cents, signed


def measure(name, case, program):
    """Judged, in ascending order: the lumped mass, which the motion has. Beside it the consistent one, and a thin body's
    theory, of the same rank."""
    wanted = references.modes(case)
    lumped, consistent = (program.modes(name, case["deck"], case.get("set", []), len(wanted), mass)[0]
                          for mass in ("lumped", "consistent"))
    thin = references.theory(case)
    rows = []
    for rank, (mode, frequency) in enumerate(wanted):
        beside = {"consistent mass, cents": signed(cents(consistent[rank], frequency))}
        if rank < len(thin):
            beside["thin theory, cents"] = signed(cents(thin[rank], frequency))
        rows.append(Row(mode, frequency, lumped[rank], "Hz", case["tolerance"], beside))
    return Section([rows])
