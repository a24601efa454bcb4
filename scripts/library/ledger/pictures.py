"""Pictures in verification/pictures."""

from contextlib import contextmanager

import matplotlib

from .program import HOME

matplotlib.use("Agg")
import matplotlib.pyplot as plt

FOLDER = HOME / "verification/pictures"


@contextmanager
def picture(name, across, up):
    """The axes of a picture to be drawn, with their labels; it becomes NAME.png."""
    figure, axes = plt.subplots(figsize=(6, 4))
    axes.set(xlabel=across, ylabel=up)
    yield axes
    if axes.get_legend_handles_labels()[0]:
        axes.legend(fontsize="small")
    figure.tight_layout()
    FOLDER.mkdir(exist_ok=True)
    figure.savefig(FOLDER / f"{name}.png", dpi=100)
    plt.close(figure)


def log_log(name, series, across, up, title=""):
    """Draws series of (x, y, style, label) and returns the lines that show the picture."""
    with picture(name, across, up) as axes:
        for x, y, style, label in series:
            axes.loglog(x, y, style, label=label, alpha=0.4 if label is None else 1)
        axes.set(title=title)
        axes.grid(which="both", alpha=0.3)
    return [f"![{up} over {across}](pictures/{name}.png)", ""]
