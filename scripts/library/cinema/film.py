"""Pictures and sound joined in step, by ffmpeg."""

import subprocess
import sys

import numpy as np
from scipy.io import wavfile

from library.recording import fail

SLOWEST, FASTEST = 10, 60  # pictures per second
LOUDEST = 0.9              # of full scale, where the deck says nothing: AAC may overshoot
VIDEO = ["-vf", "scale=out_color_matrix=bt709:out_range=tv", "-colorspace", "bt709", "-color_primaries", "bt709",
         "-color_trc", "bt709", "-c:v", "libx264", "-crf", "18", "-pix_fmt", "yuv420p"]
AUDIO = ["-c:a", "aac", "-b:a", "256k"]


def schedule(times):
    """Pictures per second, and the frame that each shows: the nearest in time, so that none is off by half a frame."""
    usual = (len(times) - 1) / times[-1] if times[-1] > 0 else SLOWEST
    rate = int(np.clip(round(usual), SLOWEST, FASTEST))
    moments = np.arange(round(times[-1] * rate) + 1) / rate
    return rate, np.searchsorted((times[1:] + times[:-1]) / 2, moments)


def write_sound(heard, full_scale, path):
    """A WAV file of a recording, divided by the full scale, or near its loudest sample where that is None."""
    if not len(heard.samples) or not np.isfinite(heard.samples).all():
        fail(f"the sound of {heard.name} is empty or not finite; another can be given by --sound FILE.wav")
    full_scale = full_scale or np.abs(heard.samples).max() / LOUDEST or 1.0
    wavfile.write(path, round(heard.rate), (heard.samples / full_scale).clip(-1, 1).astype(np.float32))


def record(pictures, rate, size, sound, output):
    """Hands the pictures (bytes: red, green, blue from the top left) to ffmpeg one by one, which joins them with a WAV
    file that begins with the first. rate: pictures per second; size: (width, height)."""
    part = output.with_name(output.name + ".part")  # a movie that isn't finished does not look like one
    raw = ["-f", "rawvideo", "-pix_fmt", "rgb24", "-s", "{}x{}".format(*size), "-framerate", str(rate), "-i", "-"]
    try:
        with subprocess.Popen(["ffmpeg", "-loglevel", "error", "-y", *raw, "-i", f"file:{sound}", "-map", "0:v",
                               "-map", "1:a", *VIDEO, *AUDIO, "-movflags", "+faststart", "-f", "mp4", f"file:{part}"],
                              stdin=subprocess.PIPE) as job:
            _hand_over(pictures, job.stdin)
        if job.returncode:
            fail(f"ffmpeg could not make {output}; its own words are above")
        part.replace(output)
    finally:
        part.unlink(missing_ok=True)


def _hand_over(pictures, pipe):
    watched = sys.stderr.isatty()
    try:
        for number, picture in enumerate(pictures, 1):
            pipe.write(picture)
            if watched:
                print(f"\r{number} pictures", end="", file=sys.stderr)
        pipe.close()
    except BrokenPipeError:
        pass  # ffmpeg has ended and says why
    if watched:
        print(file=sys.stderr)
