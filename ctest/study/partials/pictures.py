#!/usr/bin/python3
"""Draws a result with both picture scripts and checks that pictures come out, and that mistakes are answered.
pictures.py SCRIPTS_FOLDER"""

import contextlib
import functools
import io
import subprocess
import sys
import tempfile
from importlib.machinery import SourceFileLoader
from pathlib import Path
from types import SimpleNamespace

import matplotlib.image
import numpy as np
from scipy.io import wavfile

scripts = Path(sys.argv[1])
here = Path(__file__).parent
sys.path.insert(0, str(scripts))
sys.dont_write_bytecode = True


@functools.cache
def loaded(script):
    return SourceFileLoader(script, str(scripts / script)).load_module()


def run(script, *arguments):
    """The script in this process: what it imports takes longer than all else that it does, and is here."""
    errors, status = io.StringIO(), 0
    sys.argv = [script, *map(str, arguments)]
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(errors):
        try:
            loaded(script).main()
        except SystemExit as end:
            status = end.code if isinstance(end.code, int) else 1
            if isinstance(end.code, str):
                print(end.code, file=errors)
    return SimpleNamespace(returncode=status, stderr=errors.getvalue())


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


def expect_right_place():
    """A tone and a click stand in the spectrogram where they are in the sound."""
    script = loaded("spectrogram")
    rate, tone, click = 44100, 443.0, 0.75
    samples = np.sin(2 * np.pi * tone * np.arange(rate) / rate)
    samples[round(click * rate)] += 50
    frequency, times, amplitude = script.spectrogram(samples, rate, round(0.2 * rate), (0.2, 0.9), (400.0, 500.0))
    found = frequency[amplitude[:, times < 0.6].mean(axis=1).argmax()]
    assert abs(found - tone) <= frequency[1] - frequency[0], f"a tone of {tone} Hz is drawn at {found} Hz"
    _, times, amplitude = script.spectrogram(samples, rate, round(0.02 * rate), (0.2, 0.9), (5000.0, 9000.0))
    found = times[amplitude.mean(axis=0).argmax()]
    assert abs(found - click) <= times[1] - times[0], f"a click at {click} s is drawn at {found} s"


expect_right_place()
with tempfile.TemporaryDirectory() as folder:
    result, recording = Path(folder, "plate.h5"), Path(folder, "plate.wav")
    subprocess.run(["/usr/bin/python3", here / "make_result.py", result], check=True)
    tone = np.sin(2 * np.pi * 440 * np.arange(22050) / 44100)
    wavfile.write(recording, 44100, (tone * 20000).astype(np.int16))
    for script in ("spectrum", "spectrogram"):
        expect_picture(script, result, Path(folder, f"{script}.png"))
    expect_picture("spectrum", result, Path(folder, "right.png"), "--channel", 1, "--max-frequency", 1000)
    expect_picture("spectrum", result, Path(folder, "later.png"), "--from", 0.2, "--to", 0.6, "--min-frequency", 200)
    expect_picture("spectrogram", result, Path(folder, "narrow.png"), "--window", 0.2, "--range", 50,
                   "--from", 0.1, "--min-frequency", 250, "--max-frequency", 350)
    expect_picture("spectrum", recording, Path(folder, "wav.png"))
    expect_refusal("spectrum", "no file", Path(folder, "missing.h5"))
    expect_refusal("spectrum", "nobody", result, "--listener", "nobody")
    expect_refusal("spectrum", "channels", result, "--channel", 2)
    expect_refusal("spectrum", "can't be read", here / "make_result.py")
    expect_refusal("spectrum", "0 to 0.8 s", result, "--from", 0.5, "--to", 0.9)
    expect_refusal("spectrogram", "0 to 0.8 s", result, "--from", 0.5, "--to", "nan")
    expect_refusal("spectrogram", "in order", result, "--min-frequency", 500, "--max-frequency", 400)
    expect_refusal("spectrogram", "--window", result, "--window", 2)
    expect_refusal("spectrogram", "--range", result, "--range", 0)
    expect_refusal("spectrogram", "can't be written", result, "-o", Path(folder, "none", "picture.png"))
