#!/usr/bin/python3
"""Draws a result with both picture scripts and checks that pictures come out, and that mistakes are answered.
pictures.py SCRIPTS_FOLDER"""

import subprocess
import sys
import tempfile
from pathlib import Path

import matplotlib.image
import numpy as np
from scipy.io import wavfile

scripts = Path(sys.argv[1])
here = Path(__file__).parent


def run(script, *arguments):
    return subprocess.run(["/usr/bin/python3", scripts / script, *map(str, arguments)], capture_output=True, text=True)


def expect_picture(script, sound, output, *arguments):
    done = run(script, sound, "-o", output, *arguments)
    assert done.returncode == 0, f"{script} failed: {done.stderr}"
    image = matplotlib.image.imread(output)
    assert image.shape[1] >= 900, f"{output} is only {image.shape[1]} pixels wide"
    assert image.std() > 0.01, f"{output} is blank"


def expect_refusal(script, word, *arguments):
    done = run(script, *arguments)
    assert done.returncode != 0 and done.stderr.startswith("error: ") and word in done.stderr, \
        f"{script} {arguments} should be refused with a word on {word!r}, said: {done.stderr}"


with tempfile.TemporaryDirectory() as folder:
    result, recording = Path(folder, "plate.h5"), Path(folder, "plate.wav")
    subprocess.run(["/usr/bin/python3", here / "make_result.py", result], check=True)
    tone = np.sin(2 * np.pi * 440 * np.arange(22050) / 44100)
    wavfile.write(recording, 44100, (tone * 20000).astype(np.int16))
    for script in ("spectrum", "spectrogram"):
        expect_picture(script, result, Path(folder, f"{script}.png"))
    expect_picture("spectrum", result, Path(folder, "right.png"), "--channel", 1, "--maximum", 1000)
    expect_picture("spectrum", recording, Path(folder, "wav.png"))
    expect_refusal("spectrum", "no file", Path(folder, "missing.h5"))
    expect_refusal("spectrum", "nobody", result, "--listener", "nobody")
    expect_refusal("spectrum", "channels", result, "--channel", 2)
    expect_refusal("spectrum", "can't be read", here / "make_result.py")
