"""Spectra and spectrograms of sounds."""
from __future__ import annotations

import numpy as np
from scipy.signal import ZoomFFT
from scipy.signal.windows import blackmanharris

RISE = 0.005               # s in which the window of a spectrum rises: softens the blow, keeps what decays fast
ROWS, COLUMNS = 600, 1200  # about the pixels of a spectrogram's picture: frequencies, and times at least
OVERLAP = 4                # windows begin at least so often in a window's length: no impact falls between two
BATCH = 64                 # windows transformed at a time


def spectrum(samples: np.ndarray, rate: float) -> tuple[np.ndarray, np.ndarray]:
    """Frequencies (Hz) and levels (dB re the strongest) of a sound under a window that rises fast and falls like half a Hann.

    Raises ValueError if the sound is silent.
    """
    count = len(samples)
    rise = min(int(RISE * rate), count // 4)
    window = np.cos(0.5 * np.pi * np.arange(count) / count) ** 2
    window[:rise] *= np.sin(0.5 * np.pi * np.arange(rise) / rise) ** 2
    size = 4 * count  # padding, so that the parabola through a peak finds its top
    amplitude = np.abs(np.fft.rfft((samples - samples.mean()) * window, size))
    if not amplitude.max():
        raise ValueError("the sound is silent")
    level = 20 * np.log10(np.maximum(amplitude / amplitude.max(), 1e-20))
    return np.fft.rfftfreq(size, 1 / rate), level


def spectrogram(samples: np.ndarray, rate: float, length: int, stretch: tuple[float, float],
                band: tuple[float, float]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Frequencies [ROWS] Hz, times [columns] s and amplitudes [ROWS x columns] of a sound under windows of so many samples, centred
    on the times. The frequencies are those of the band and no others, however narrow it is.

    samples: from time 0 on; stretch: s, from when to when; band: Hz, from where to where
    """
    start, stop = stretch
    duration = stop - start
    columns = max(COLUMNS, int(np.ceil(OVERLAP * duration * rate / length)))
    times = start + (np.arange(columns) + 0.5) * duration / columns
    padded = np.pad(samples, (length, 0))  # all was silent before the sound; what follows it is not known
    first = np.round(times * rate).astype(int) + length - length // 2
    first = np.minimum(first, len(padded) - length)
    window = blackmanharris(length, sym=False)  # its side lobes are fainter than what is drawn
    transform = ZoomFFT(length, band, ROWS, fs=rate, endpoint=True)
    amplitude = np.empty((columns, ROWS), dtype=np.float32)
    for begin in range(0, columns, BATCH):
        pieces = padded[first[begin:begin + BATCH, np.newaxis] + np.arange(length)]
        amplitude[begin:begin + BATCH] = np.abs(transform(pieces * window))
    return np.linspace(*band, ROWS), times, amplitude.T
