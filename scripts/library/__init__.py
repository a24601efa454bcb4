"""The functions that the programs in scripts/ and tools/ share. They read results by the Python module `idiophone`."""
import sys
from pathlib import Path

_above = Path(__file__).resolve().parents[1:]
for _folder in (_above[0].parent / "python", _above[2].parent / "lib/python3/dist-packages"):  # of the source tree, or installed
    if (_folder / "idiophone").is_dir():
        sys.path.insert(0, str(_folder))
