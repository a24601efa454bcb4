"""What the tests of the nine scenes hear and see in a result: partials, bursts, when and how long bodies touch."""
import h5py
import numpy
from scipy.signal import butter, find_peaks, hilbert, sosfiltfilt
from scipy.signal.windows import blackmanharris

PADDING = 8  # spectra are padded to so many times the sound: parabolas through their peaks then meet them


class Scene:
    """The sound of the left ear and what moved, from a result file."""

    def __init__(self, path):
        with h5py.File(path) as file:
            ears = file["audio/ears"]
            self.rate = float(ears.attrs["rate"])
            self.sound = ears[:, 0]                          # [samples] Pa m
            self.left_ear = ears.attrs["positions"][0]       # [3] m
            self.contacts = {name: {key: series[()] for key, series in group.items()}
                             for name, group in file.get("contacts", {}).items()}
            self.motion = {name: {key: series[()] for key, series in group.items()}
                           for name, group in file["motion"].items()}
            self.energy = dict(zip(("kinetic", "elastic", "contact", "gravitational", "work"), file["energy"][()].T))
            self.motion_rate = float(file["energy"].attrs["rate"])

    def stretch(self, start, duration=None):
        """The sound from start on, s."""
        first = round(start * self.rate)
        return self.sound[first:None if duration is None else first + round(duration * self.rate)]

    def touches(self, contact, gap=0.01):
        """Times [touches x 2] s from when to when two bodies touch; what is nearer than the gap is one touch."""
        touching = numpy.flatnonzero(numpy.any(self.contacts[contact]["force"] != 0, axis=1))
        if not len(touching):
            return numpy.zeros((0, 2))
        groups = numpy.split(touching, numpy.flatnonzero(numpy.diff(touching) > gap * self.rate) + 1)
        return numpy.array([(group[0], group[-1] + 1) for group in groups]) / self.rate


def spectrum(sound, rate):
    """Frequencies, Hz, and amplitudes of the sound's partials: a sine of amplitude 1 has a peak of 1."""
    window = blackmanharris(len(sound), sym=False)
    amplitude = 2 * numpy.abs(numpy.fft.rfft(sound * window, PADDING * len(sound))) / window.sum()
    return numpy.arange(len(amplitude)) * rate / (PADDING * len(sound)), amplitude


def loudest_between(sound, rate, low, high):
    """Frequency, Hz, and level, dB, of the largest peak between two frequencies; level -inf where there is no peak."""
    frequency, amplitude = spectrum(sound, rate)
    level = 20 * numpy.log10(amplitude + 1e-300)
    inside = [peak for peak in find_peaks(level)[0] if low < frequency[peak] < high]
    if not inside:
        return numpy.nan, -numpy.inf
    peak = max(inside, key=lambda candidate: level[candidate])
    below, here, above = level[peak - 1:peak + 2]
    shift = (below - above) / (2 * (below - 2 * here + above))
    return frequency[peak] + shift * frequency[1], here - (below - above) * shift / 4


def centroid(sound, rate):
    """Mean frequency of the sound, weighted by its power, Hz."""
    frequency, amplitude = spectrum(sound, rate)
    return (frequency * amplitude**2).sum() / (amplitude**2).sum()


def band(sound, rate, low, high):
    """The part of the sound between two frequencies, its phases unchanged, as a complex signal: amplitude and phase."""
    return hilbert(sosfiltfilt(butter(4, (low, high), "bandpass", fs=rate, output="sos"), sound))
