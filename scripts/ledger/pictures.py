"""Log-log pictures of errors, in verification/pictures."""

import matplotlib

from .program import HOME

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend first)

FOLDER = HOME / "verification/pictures"


def log_log(name, series, across, up, title=""):
    """Draws series of (x, y, style, label) and returns the lines that show the picture."""
    figure, axes = plt.subplots(figsize=(6, 4))
    for x, y, style, label in series:
        axes.loglog(x, y, style, label=label, alpha=0.4 if label is None else 1)
    axes.set(xlabel=across, ylabel=up, title=title)
    axes.legend()
    axes.grid(which="both", alpha=0.3)
    figure.tight_layout()
    FOLDER.mkdir(exist_ok=True)
    figure.savefig(FOLDER / f"{name}.png", dpi=100)
    plt.close(figure)
    return [f"![{up} over {across}](pictures/{name}.png)", ""]
