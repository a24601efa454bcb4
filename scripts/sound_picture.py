"""What the pictures of sounds share: reading a result or WAV file, the command line, the style of the figures."""

import argparse
import sys
from dataclasses import dataclass, field
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import h5py
import matplotlib.pyplot as plt
import numpy as np
from scipy.io import wavfile

INK, BLUE, RUST, GREY = "#222222", "#1f4e79", "#b5482a", "#8a8a8a"

plt.rcParams.update({
    "figure.dpi": 150, "figure.constrained_layout.use": True,
    "font.family": ["DejaVu Sans"], "font.size": 9, "axes.titlesize": 10, "axes.titlelocation": "left",
    "axes.edgecolor": GREY, "axes.labelcolor": INK, "text.color": INK, "xtick.color": INK, "ytick.color": INK,
    "axes.spines.top": False, "axes.spines.right": False, "axes.axisbelow": True,
    "grid.color": "#e4e4e4", "grid.linewidth": 0.6, "legend.frameon": False,
})


@dataclass
class Sound:
    """One channel of a sound, with the frequencies that were foretold for it."""
    name: str
    samples: np.ndarray                             # [samples]
    rate: float                                     # Hz
    unit: str
    references: dict = field(default_factory=dict)  # name -> [frequencies] Hz


def arguments(description):
    """The command line of a picture, to which a script may add."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("sound", type=Path, metavar="RESULT.h5", help="a result file, or a .wav")
    parser.add_argument("-o", "--output", type=Path, metavar="PICTURE.png", help="default: beside the sound")
    parser.add_argument("--listener", metavar="NAME", help="which listener of the result (default: the first)")
    parser.add_argument("--channel", type=int, default=0, metavar="NUMBER", help="which channel, from 0 (default: 0)")
    parser.add_argument("--maximum", type=float, metavar="HZ", help="highest frequency drawn")
    return parser


def fail(message):
    sys.exit(f"error: {message}")


def read(options):
    """The sound that the command line asks for."""
    path = options.sound
    if not path.is_file():
        fail(f"there is no file {path}")
    sound = _read_wav(path) if path.suffix.lower() == ".wav" else _read_result(path, options.listener)
    channels = sound.samples.shape[1]
    if not 0 <= options.channel < channels:
        fail(f"{path} has the channels 0 to {channels - 1}, not {options.channel}")
    sound.samples = sound.samples[:, options.channel]
    if len(sound.samples) < 64 or not np.isfinite(sound.samples).all():
        fail(f"{path}: a picture needs at least 64 samples, all of them finite")
    if options.maximum is not None and not 0 < options.maximum <= sound.rate / 2:
        fail(f"--maximum must be above 0 and at most {sound.rate / 2:g} Hz")
    return sound


def save(figure, options, kind):
    """Writes the picture and says where."""
    output = options.output or options.sound.with_name(f"{options.sound.stem}_{kind}.png")
    figure.savefig(output)
    print(output)


def _read_wav(path):
    try:
        rate, samples = wavfile.read(path)
    except ValueError as error:
        fail(f"{path} can't be read: {error}")
    scale = np.iinfo(samples.dtype).max if np.issubdtype(samples.dtype, np.integer) else 1.0
    return Sound(path.stem, samples.reshape(len(samples), -1) / scale, rate, "full scale")


def _text(attribute):
    return attribute.decode() if isinstance(attribute, bytes) else str(attribute)


def _read_result(path, listener):
    try:
        with h5py.File(path) as file:
            if "audio" not in file or not len(file["audio"]):
                fail(f"{path} has no audio")
            listener = listener or next(iter(file["audio"]))
            if listener not in file["audio"]:
                fail(f"{path} has no listener {listener}; it has: {', '.join(file['audio'])}")
            audio = file["audio"][listener]
            references = {_text(data.attrs["name"]): np.sort(data[()]) for data in file.get("references", {}).values()}
            return Sound(f"{path.stem}, {listener}", audio[()].reshape(len(audio), -1), float(audio.attrs["rate"]),
                         _text(audio.attrs["unit"]), references)
    except OSError as error:
        fail(f"{path} can't be read: {error}")
