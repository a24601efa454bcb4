"""Recordings: what a listener of a result file heard, or a WAV file."""

import contextlib
import sys
import warnings
from dataclasses import dataclass, field

import numpy as np
from idiophone import IdiophoneError, Result
from scipy.io import wavfile


@dataclass
class Recording:
    """All channels that one listener heard, with the frequencies that were predicted for it."""
    name: str
    samples: np.ndarray                             # [samples x channels]
    rate: float                                     # Hz
    unit: str
    references: dict = field(default_factory=dict)  # name -> [frequencies] Hz


def fail(message):
    sys.exit(f"error: {message}")


@contextlib.contextmanager
def packages_of(group):
    """Around imports: where a package is missing, the script ends with the command that installs it."""
    try:
        yield
    except ModuleNotFoundError as error:
        fail(f"the Python package {error.name} is missing: scripts/install_dependencies {group} installs it")


def open_result(path):
    """A result, for reading."""
    try:
        return Result(path)
    except IdiophoneError as error:
        fail(error)


def read(path, listener=None):
    """What the listener (default: the first) of a result heard, or a .wav."""
    return _read_wav(path) if path.suffix.lower() == ".wav" else of_listener(open_result(path), listener)


def of_listener(result, listener=None):
    """What the listener (default: the first) of a result heard."""
    try:
        sound = result.sound(listener)
    except IdiophoneError as error:
        fail(error)
    return Recording(sound.path.removeprefix("/audio/"), sound.values, sound.rate, sound.unit, result.references)


def modes(path):
    """Body -> its eigenfrequencies (Hz), from a file of `idiophone modes`."""
    try:
        return {f"modes of {body}": modes.frequency for body, modes in open_result(path).modes.items()}
    except IdiophoneError as error:
        fail(error)


def _read_wav(path):
    if not path.is_file():
        fail(f"there is no file {path}")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", wavfile.WavFileWarning)  # of chunks beside the samples
            rate, samples = wavfile.read(path)
    except ValueError as error:
        fail(f"{path} can't be read: {error}")
    scale = np.iinfo(samples.dtype).max if np.issubdtype(samples.dtype, np.integer) else 1.0
    return Recording("", samples.reshape(len(samples), -1) / scale, rate, "full scale")
