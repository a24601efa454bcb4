"""Speed-up over ranks."""

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt


def draw(curves, file):
    """curves: {label: [Point]}; file: an SVG or PNG file."""
    figure, axes = plt.subplots(figsize=(6, 4.5), layout="constrained")
    for label, points in curves.items():
        ranks = [point.ranks for point in points]
        line, = axes.loglog(ranks, [point.speed_up for point in points], "o-", label=label)
        axes.loglog(ranks, [point.one_rank / point.predicted for point in points], "x:", color=line.get_color())
    axes.axline((1, 1), (2, 2), color="gray", linewidth=0.8)
    axes.set(xlabel="ranks", ylabel="speed-up over one rank")
    axes.legend(title="simulated; dotted: check -n")
    figure.savefig(file)
