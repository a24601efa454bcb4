"""Series: values at a fixed rate, as sounds and channels of the motion are."""
from __future__ import annotations

import base64
import io
from dataclasses import dataclass

import numpy as np
from scipy.io import wavfile


@dataclass(frozen=True)
class Series:
    """A series of a result."""
    path: str                      #: in the file, e.g. "/audio/ears"
    values: np.ndarray             #: [rows x columns], in `unit`
    rate: float                    #: rows per second, Hz
    unit: str
    columns: list[str]             #: names, e.g. ["ears.left", "ears.right"]
    description: str = ""
    positions: np.ndarray | None = None  #: [columns x 3], m: of a sound's receivers, at time 0 if they move

    @property
    def time(self) -> np.ndarray:
        """[rows], s."""
        return np.arange(len(self.values)) / self.rate

    def __getitem__(self, column: str | int) -> np.ndarray:
        """[rows] of one column by its name, the part of the name after the last dot, or its number. Raises KeyError."""
        if isinstance(column, int):
            return self.values[:, column]
        for number, name in enumerate(self.columns):
            if column in (name, name.rpartition(".")[2]):
                return self.values[:, number]
        raise KeyError(f"{self.path} has no column {column}; it has: {', '.join(self.columns)}")

    def wav(self) -> bytes:
        """A WAV file of it. Its loudest sample is 0.9 of full scale."""
        loudest = np.abs(self.values).max(initial=0)
        file = io.BytesIO()
        wavfile.write(file, round(self.rate), np.float32(self.values * (0.9 / loudest if loudest > 0 else 1)))
        return file.getvalue()

    def _repr_html_(self) -> str:
        """In Jupyter: a player, if it is a sound."""
        loudest = np.abs(self.values).max(initial=0)
        line = f"{self.path}: {len(self.values) / self.rate:g} s, {self.description or 'series'}, at most {loudest:.3g} {self.unit}"
        if not self.path.startswith("/audio/"):
            return f"<p>{line}</p>"
        return f'<p>{line}</p><audio controls src="data:audio/wav;base64,{base64.b64encode(self.wav()).decode()}"></audio>'
