"""Pictures of sounds, by matplotlib."""
from __future__ import annotations

from typing import TYPE_CHECKING

import matplotlib.pyplot as plt
import numpy as np

from .errors import IdiophoneError
from .series import Series
from .spectra import spectrogram, spectrum

if TYPE_CHECKING:
    from matplotlib.axes import Axes

RANGE = 90  # dB drawn
STYLES = ["--", ":", "-."]


def plot_spectrum(sound: Series, column: str | int, references: dict[str, np.ndarray], axes: Axes | None = None) -> Axes:
    """Draws levels over frequencies, and lines at the expected frequencies (Hz) by name. Raises IdiophoneError if it is silent."""
    try:
        frequency, level = spectrum(sound[column], sound.rate)
    except ValueError as error:
        raise IdiophoneError(f"{sound.path}: {error}") from None
    axes = axes or plt.subplots()[1]
    axes.plot(frequency, level, linewidth=0.9)
    highest = frequency[np.flatnonzero(level > -60)[-1]]
    for number, (name, lines) in enumerate(references.items()):
        for first, line in enumerate(lines):
            axes.axvline(line, linestyle=STYLES[number % len(STYLES)], linewidth=0.8, color="0.5", label=None if first else name)
        highest = max(highest, lines.max(initial=0))
    if references:
        axes.legend()
    axes.set(xlabel="frequency, Hz", ylabel="level, dB re the strongest", xlim=(0, min(1.12 * highest, sound.rate / 2)), ylim=(-RANGE, 5))
    return axes


def plot_spectrogram(sound: Series, column: str | int, window: float, axes: Axes | None = None) -> Axes:
    """Draws levels over time and frequency. window: s, within the sound. Raises ValueError for another one."""
    samples = sound[column]
    length, end = round(window * sound.rate), len(samples) / sound.rate
    if not 16 <= length <= len(samples):
        raise ValueError(f"window must be from {16 / sound.rate:.2g} s to the sound's {end:g} s, not {window:g} s")
    frequency, times, amplitude = spectrogram(samples, sound.rate, length, (0, end), (0, sound.rate / 2))
    axes = axes or plt.subplots()[1]
    level = 20 * np.log10(np.maximum(amplitude / max(amplitude.max(), 1e-300), 1e-20))
    axes.imshow(level, origin="lower", aspect="auto", cmap="Greys", vmin=-RANGE, vmax=0,
                extent=(times[0], times[-1], frequency[0] / 1000, frequency[-1] / 1000))
    axes.set(xlabel="time, s", ylabel="frequency, kHz")
    return axes
