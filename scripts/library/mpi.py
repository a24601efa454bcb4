"""How scripts start MPI jobs: the environment of scripts/mpi_environment, and mpirun on more ranks than cores."""

import pathlib
import shutil

ENVIRONMENT = dict(
    setting.split("=")
    for line in (pathlib.Path(__file__).resolve().parents[1] / "mpi_environment").read_text().splitlines()
    if line.startswith("export ") for setting in line.split()[1:])


def mpirun(ranks, variables=()):
    """The words that start a program on this many ranks. The variables are for the ranks only, not for mpirun."""
    exports = [word for key, value in dict(variables).items() for word in ("-x", f"{key}={value}")]
    return ["mpirun", "--oversubscribe", "--bind-to", "none", *exports, "-n", str(ranks)]


def program_beside(home):
    """The program that was built in this source tree; if the scripts are installed, the one that was installed with them."""
    installed = home.parent.parent / "bin/idiophone"
    built = home / "build/production/idiophone"
    return next((path for path in (built, installed) if path.exists()), pathlib.Path(shutil.which("idiophone") or built))
