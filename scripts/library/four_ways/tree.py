"""A drawing of the timbre tree inputs/four_ways/bell.tt."""

from dataclasses import dataclass

from library.sound_picture import BLUE, GREY, INK, RUST


@dataclass
class Node:
    """A box with a text, and the names of the nodes below it."""
    text: str
    x: float  # of its middle, 0 to 1
    y: float
    arguments: tuple = ()
    kind: str = "function"


PRODUCT = "\N{MULTIPLICATION SIGN}"
STYLES = {"function": {"facecolor": "#dfe9f3", "edgecolor": BLUE, "linewidth": 1.2},
          "numbers": {"facecolor": "#f2f2f2", "edgecolor": GREY, "linewidth": 1.0},
          "parameter": {"facecolor": "#f9e6dc", "edgecolor": RUST, "linewidth": 1.2, "linestyle": "--"}}
NODES = {
    "sound": Node(PRODUCT, 0.42, 0.93, ("amp", "combine")),
    "amp": Node("amp", 0.15, 0.735, kind="parameter"),
    "combine": Node("combine", 0.60, 0.735, ("partials", "levels")),
    "partials": Node(PRODUCT, 0.47, 0.52, ("damp", "sine")),
    "levels": Node("levels", 0.86, 0.52, kind="numbers"),
    "damp": Node("damp", 0.27, 0.305, ("ratios", "frequencies")),
    "sine": Node("sine", 0.67, 0.305, ("frequencies",)),
    "ratios": Node("ratios", 0.16, 0.09, kind="numbers"),
    "frequencies": Node("frequencies", 0.60, 0.09, kind="numbers"),
}


def draw(axes):
    """On axes from 0 to 1."""
    for node in NODES.values():
        for name in node.arguments:
            below = NODES[name]
            axes.plot([node.x, below.x], [node.y, below.y], color=GREY, linewidth=1.3, zorder=1)
    for node in NODES.values():
        axes.text(node.x, node.y, node.text, ha="center", va="center", fontsize=12, color=INK, zorder=2,
                  bbox={"boxstyle": "round,pad=0.45", **STYLES[node.kind]})
    axes.text(NODES["amp"].x, NODES["amp"].y - 0.085, "bound to\nthe motion", ha="center", va="top", fontsize=10, color=RUST)
