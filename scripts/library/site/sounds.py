"""The website's page of sounds: the gallery with players, its reports, and the Sonic Explorer."""
import shutil

from ..gallery import NAMES, articles

PAGE = """---
hide: [toc]
---
# Sounds

{explorer}

## Gallery

Each sound was computed from the shape and the material of the body alone.
[How to make this gallery](docs/use/gallery.md).

<div class="gallery">
{articles}
</div>
"""
EXPLORER = """## Sonic Explorer

<p><a class="md-button md-button--primary" href="explorer.html">Open the Sonic Explorer</a></p>

A room with bodies that you strike, scrape and tune in the browser: [how it works](docs/use/explorer.md).
"""


def add_sounds(pages, gallery, explorer):
    """Adds sounds.md and what it plays to the folder of pages.

    gallery:  folder made by scripts/gallery; it may have only some of the decks
    explorer: page made by `idiophone explore`
    """
    names = [name for name in NAMES if (gallery / f"{name}.wav").exists()]
    (pages / "gallery").mkdir()
    for name in names:
        for ending in ("png", "wav", "html"):
            shutil.copy(gallery / f"{name}.{ending}", pages / "gallery")
    shutil.copy(explorer, pages / "explorer.html")
    (pages / "sounds.md").write_text(PAGE.format(explorer=EXPLORER, articles=articles(names, "gallery/")))
