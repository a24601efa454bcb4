"""The decks of inputs/gallery, and what a page shows of each."""
import html
from pathlib import Path

FOLDER = Path(__file__).resolve().parents[2] / "inputs/gallery"
NAMES = ["marimba_bar", "wine_glass", "handpan", "triangle", "gong", "cymbal", "church_bell", "wood_block", "coin", "spanner",
         "glockenspiel", "tuning_fork"]
ARTICLE = """<article>
<img src="{folder}{name}.png" alt="{title}">
<h2>{title}</h2>
<p>{text}</p>
<audio controls src="{folder}{name}.wav"></audio>
<p><a href="{folder}{name}.html">Report of the run</a></p>
</article>"""


def sentences(deck):
    """The comment at the beginning of a deck."""
    lines = []
    for line in deck.read_text().splitlines():
        if not line.startswith("#"):
            break
        lines.append(line.lstrip("# "))
    return " ".join(lines)


def articles(names, folder=""):
    """HTML of pictures, players and reports that lie in a folder beside the page: "" or a path that ends in a slash."""
    return "\n".join(ARTICLE.format(folder=folder, name=name, title=name.replace("_", " ").capitalize(),
                                    text=html.escape(sentences(FOLDER / f"{name}.yaml"))) for name in names)
