"""HDF5 files of the program."""
from __future__ import annotations

import contextlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import h5py
import numpy as np

from .errors import IdiophoneError

COMPLEX = np.array([1, 1j])  # makes complex numbers of pairs


def text(value: Any) -> str:
    """A text of an HDF5 file."""
    return value.decode() if isinstance(value, bytes) else str(value)


@contextlib.contextmanager
def opened(path: str | Path, kind: str) -> Iterator[h5py.File]:
    """A file of this kind, e.g. "sound map". Raises IdiophoneError if it is missing, of another kind or incomplete."""
    if not Path(path).is_file():
        raise IdiophoneError(f"there is no file {path}")
    try:
        with h5py.File(path) as file:
            if text(file.attrs.get("format", "")) != f"idiophone {kind}":
                raise IdiophoneError(f"{path} is not a {kind} of idiophone")
            yield file
    except (OSError, KeyError) as error:
        raise IdiophoneError(f"{path} can't be read: {error}") from None
