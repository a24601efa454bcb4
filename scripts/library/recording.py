"""Recordings: what a listener of a result file heard, or a WAV file."""

import contextlib
import sys
import warnings
from dataclasses import dataclass, field

import h5py
import numpy as np
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


def text(value):
    """A text of an HDF5 file."""
    return value.decode() if isinstance(value, bytes) else str(value)


def open_result(path):
    """The HDF5 file of a result, for reading."""
    if not path.is_file():
        fail(f"there is no file {path}")
    try:
        return h5py.File(path)
    except OSError as error:
        fail(f"{path} can't be read: {error}")


def read(path, listener=None):
    """What the listener (default: the first) of a result heard, or a .wav."""
    if path.suffix.lower() == ".wav":
        return _read_wav(path)
    with open_result(path) as file:
        return of_listener(file, listener)


def of_listener(file, listener=None):
    """What the listener (default: the first) of an open result heard."""
    if not len(file.get("audio", {})):
        fail(f"{file.filename} has no audio")
    listener = listener or next(iter(file["audio"]))
    if listener not in file["audio"]:
        fail(f"{file.filename} has no listener {listener}; it has: {', '.join(file['audio'])}")
    audio = file["audio"][listener]
    references = {text(data.attrs.get("name", name)): np.sort(data[()])
                  for name, data in file.get("references", {}).items()}
    return Recording(listener, audio[()].reshape(len(audio), -1), float(audio.attrs["rate"]), text(audio.attrs["unit"]),
                     references)


def modes(path):
    """Body -> its eigenfrequencies (Hz), from a file of `idiophone modes`."""
    with open_result(path) as file:
        found = {f"modes of {body}": group["frequency"][()] for body, group in file.get("modes", {}).items()}
    return found or fail(f"{path} has no modes; `idiophone modes` finds them")


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
