"""What the pictures of sounds share: the command line, the choice of channel and stretch, the style of the figures."""

import argparse
from dataclasses import dataclass
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from library import recording
from library.recording import fail

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
    """One channel of a recording, and the stretch of time and the frequencies that are drawn of it."""
    name: str
    samples: np.ndarray      # [samples], from time 0 on
    rate: float              # Hz
    references: dict         # name -> [frequencies] Hz
    start: float             # s
    stop: float              # s
    low: float               # Hz
    high: float | None       # Hz; None: the script chooses

    def stretch(self):
        """The samples from start to stop."""
        return self.samples[round(self.start * self.rate):round(self.stop * self.rate)]

    def band(self):
        """From which frequency to which, Hz; to the highest there is by default."""
        return self.low, self.high or self.rate / 2


def arguments(description):
    """The command line of a picture, to which a script may add."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("sound", type=Path, metavar="RESULT.h5", help="a result file, or a .wav")
    parser.add_argument("-o", "--output", type=Path, metavar="PICTURE.png", help="default: beside the sound")
    parser.add_argument("--listener", metavar="NAME", help="which listener of the result (default: the first)")
    parser.add_argument("--channel", type=int, default=0, metavar="NUMBER",
                        help="which channel, from 0 (default: 0); 0 is a stereo listener's left ear, 1 the right")
    parser.add_argument("--from", dest="start", type=float, default=0.0, metavar="SECONDS", help="default: 0")
    parser.add_argument("--to", dest="stop", type=float, metavar="SECONDS", help="default: the sound's end")
    parser.add_argument("--min-frequency", dest="low", type=float, default=0.0, metavar="HZ", help="default: 0")
    parser.add_argument("--max-frequency", dest="high", type=float, metavar="HZ")
    return parser


def read(options):
    """The sound that the command line asks for."""
    path = options.sound
    heard = recording.read(path, options.listener)
    channels = heard.samples.shape[1]
    if not 0 <= options.channel < channels:
        fail(f"{path} has the channels 0 to {channels - 1}, not {options.channel}")
    samples = heard.samples[:, options.channel]
    if not np.isfinite(samples).all():
        fail(f"{path}: the sound is not finite")
    end = len(samples) / heard.rate
    stop = end if options.stop is None else options.stop
    if not 0 <= options.start < stop <= end:
        fail(f"--from and --to must be in order and within the sound, 0 to {end:g} s")
    high = heard.rate / 2 if options.high is None else options.high
    if not 0 <= options.low < high <= heard.rate / 2:
        fail(f"--min-frequency and --max-frequency must be in order and within 0 to {heard.rate / 2:g} Hz")
    name = ", ".join(part for part in (path.stem, heard.name) if part)
    sound = Sound(name, samples, heard.rate, heard.references, options.start, stop, options.low, options.high)
    if len(sound.stretch()) < 64:
        fail(f"{path}: a picture needs at least 64 samples")
    return sound


def save(figure, options, kind):
    """Writes the picture and says where."""
    output = options.output or options.sound.with_name(f"{options.sound.stem}_{kind}.png")
    try:
        figure.savefig(output)
    except (OSError, ValueError) as error:
        fail(f"{output} can't be written: {error}")
    print(output)
