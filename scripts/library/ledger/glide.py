"""The falling pitch of a decaying sound, against the one predicted from the start's deflection, the pitch of small
vibrations and the damping alone."""

import numpy as np
from idiophone import Result
from scipy.integrate import solve_ivp
from scipy.signal import get_window

from .ledger import Row
from .pictures import picture
from .program import read_yaml

WINDOW = 0.016   # s, of the pieces in which the pitch is looked for
SOUND = 343      # m/s, from deck to ear
PADDING = 8      # the spectrum's lines are so much closer than the window's resolution


def measure(name, case, program, result, small, deflection, coefficient):
    """Rows at the times of `glide`, s. The predicted motion q'' + alpha q' + w0^2 (1 + c q^2) q = 0 is listened to as
    the sound is: through the same windows, as late as the sound's way takes.
    @param small        frequency of small vibrations, Hz
    @param deflection   at the start, m
    @param coefficient  c, 1/m^2"""
    deck = read_yaml(case["deck"])
    ear = Result(result).sound()
    sound, rate, delay = ear[0], ear.rate, np.linalg.norm(ear.positions[0]) / SOUND
    alpha = next(iter(deck["materials"].values()))["damping"]["mass"]
    time = np.arange(len(sound)) / rate
    velocity = foretold_velocity(time - delay, 2 * np.pi * small, alpha, deflection, coefficient)
    heard, predicted = (np.array([pitch(signal, rate, at, small) for at in case["glide"]])
                       for signal in (sound, velocity))
    if not program.short:
        draw(name, sound, velocity, rate, small)
    return [Row(f"pitch of the sound at {1000 * at:g} ms", expected, found, "Hz", case["glide_tolerance"])
            for at, expected, found in zip(case["glide"], predicted, heard)]


def foretold_velocity(time, omega, alpha, deflection, coefficient):
    """Velocity, m/s; zero before time 0."""
    def rates(_, state):
        q, v = state
        return v, -alpha * v - omega**2 * (1 + coefficient * q * q) * q
    heard = time > 0
    solution = solve_ivp(rates, (0, time[-1]), (deflection, 0), t_eval=time[heard], rtol=1e-9, atol=1e-12)
    return np.concatenate([np.zeros(np.count_nonzero(~heard)), solution.y[1]])


def pitch(signal, rate, at, small):
    """Frequency, Hz, of the highest peak between 0.7 and 2 times that of small vibrations around the time `at`, s."""
    length = round(WINDOW * rate)
    begin = round(at * rate) - length // 2
    piece = signal[begin:begin + length] * get_window("hann", length)
    level = np.log(np.abs(np.fft.rfft(piece, PADDING * length)))
    spacing = rate / (PADDING * length)
    low, high = round(0.7 * small / spacing), round(2 * small / spacing)
    top = low + np.argmax(level[low:high])
    before, peak, after = level[top - 1:top + 2]  # the top of the parabola through these
    return spacing * (top + 0.5 * (after - before) / (2 * peak - before - after))


def draw(name, sound, velocity, rate, small):
    length = round(WINDOW * rate)
    times = np.arange(WINDOW / 2 + 0.003, len(sound) / rate - WINDOW / 2, 0.001)
    with picture(f"{name}_glide", "time, s", "frequency, Hz") as axes:
        *_, image = axes.specgram(sound, NFFT=length, Fs=rate, noverlap=length - round(0.0005 * rate),
                                  pad_to=8 * length, cmap="magma")
        loudest = image.get_array().max()
        image.set_clim(loudest - 50, loudest)
        axes.plot(times, [pitch(velocity, rate, at, small) for at in times], "c", label="predicted")
        axes.set_ylim(0, 6 * small)
