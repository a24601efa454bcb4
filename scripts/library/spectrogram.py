"""Spectrograms of sounds."""

import numpy as np
from scipy.signal import ZoomFFT
from scipy.signal.windows import blackmanharris

ROWS, COLUMNS = 600, 1200  # about the pixels of the picture: frequencies, and times at least
OVERLAP = 4                # windows begin at least so often in a window's length: no impact falls between two
BATCH = 64                 # windows transformed at a time


def spectrogram(sound, length, high):
    """Frequencies [ROWS] Hz, times [columns] s and amplitudes [ROWS x columns] of a sound_picture.Sound under windows of so many
    samples, centred on the times. The frequencies are those drawn and no others, however narrow their band is."""
    duration = sound.stop - sound.start
    columns = max(COLUMNS, int(np.ceil(OVERLAP * duration * sound.rate / length)))
    times = sound.start + (np.arange(columns) + 0.5) * duration / columns
    padded = np.pad(sound.samples, (length, 0))  # all was silent before the sound; what follows it is not known
    first = np.round(times * sound.rate).astype(int) + length - length // 2
    first = np.minimum(first, len(padded) - length)
    window = blackmanharris(length, sym=False)  # its side lobes are fainter than what is drawn
    transform = ZoomFFT(length, [sound.low, high], ROWS, fs=sound.rate, endpoint=True)
    amplitude = np.empty((columns, ROWS), dtype=np.float32)
    for begin in range(0, columns, BATCH):
        pieces = padded[first[begin:begin + BATCH, np.newaxis] + np.arange(length)]
        amplitude[begin:begin + BATCH] = np.abs(transform(pieces * window))
    return np.linspace(sound.low, high, ROWS), times, amplitude.T
