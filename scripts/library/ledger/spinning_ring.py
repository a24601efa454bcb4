"""The bending waves of a free ring that spins about its axis, z, in the frame that turns with it."""

import numpy as np
from idiophone import Result
from scipy.optimize import least_squares

from .frames import read_frames
from .ledger import Row, measured
from .pictures import picture

WAVES = 2        # round the ring: the oval mode, the lowest
SETTLED = 0.012  # s; the squeeze is over and the breathing that the spin set off has decayed


def predicted(still, spin):
    """Angular frequencies, rad/s, of the waves of a thin ring that does not stretch, which run against (negative) and
    with (positive) the spin; `still` is that of the ring at rest, both in rad/s. With n waves round the ring

      p = -2 n spin/(n^2 + 1) -+ sqrt(still^2 + (n (n^2 - 1) spin/(n^2 + 1))^2),

    the first term from Coriolis's force (Bryan, Proc. Cambridge Phil. Soc. 7 (1890) 101), the last under the root from
    the hoop tension rho A (spin R)^2, less the centrifugal force: with v = Re z(t) e^{-i n theta} along the ring and
    w = -dv/dtheta outwards, the Lagrangian, pi rho A R = 1, is
    (n^2 + 1) |z'|^2/2 + 2 n spin Im(z* z') - (n^2 + 1) still^2 |z|^2/2 - spin^2 ((n^2 - 1)^2 - (n^2 + 1)) |z|^2/2."""
    n = WAVES
    drag = 2 * n * spin / (n * n + 1)
    root = np.hypot(still, n * (n * n - 1) * spin / (n * n + 1))
    return np.array([-drag - root, -drag + root])


def measure(name, case, program):
    """Two rows for each of the case's `spins`, rad/s."""
    overrides = case.get("set", [])
    still = 2 * np.pi * frequency_in_plane(program.shapes(name, case["deck"], overrides, count=6))
    rows, points = [], []
    for spin in case["spins"]:
        result = program.sound(f"{name}/{spin:g}", case["deck"], [*overrides, f"bodies.ring.spin=[0, 0, {spin}]"])
        time, wave, spun = travelling_wave(result)
        expected = predicted(still, spun)
        found = two_frequencies(time, wave, expected)
        points.append((spun, found))
        rows += [Row(f"wave {way} the spin of {spun:.1f} rad/s", *np.abs([reference, computed]) / (2 * np.pi), "Hz",
                     case["tolerance"]) for way, reference, computed in zip(("against", "with"), expected, found)]
    if not program.short:
        draw(name, still, points)
    return measured(case, [rows], program)


def frequency_in_plane(modes):
    """The lowest, Hz, whose mode moves little along the axis."""
    axial = np.sum(modes.shapes[:, :, 2]**2, axis=1) / np.sum(modes.shapes**2, axis=(1, 2))
    return modes.frequencies[np.argmax(axial < 0.1)]


def travelling_wave(result):
    """Times, s, n times the z(t) of `predicted`, m, from the radial displacement w in the turning frame, and the angular
    velocity, rad/s, all after things have settled. The motion channels must have the frames' rate."""
    frames = read_frames(result)
    computed = Result(result)
    quaternion, centre, spins = (computed.channels[f"motion/{computed.bodies[0]}/{name}"].values
                                 for name in ("orientation", "centre_of_mass", "angular_velocity"))
    spin = spins[:, 2]
    turn = 2 * np.arctan2(quaternion[:, 3], quaternion[:, 0])
    settled = frames.time > SETTLED
    x, y, _ = np.moveaxis((frames.nodes + frames.displacement - centre[:, None])[settled], -1, 0)
    angle = np.arctan2(frames.nodes[:, 1], frames.nodes[:, 0])
    radial = np.real((x + 1j * y) * np.exp(-1j * (turn[settled, None] + angle))) - np.hypot(*frames.nodes.T[:2])
    parts = np.transpose([np.ones_like(angle), np.cos(WAVES * angle), np.sin(WAVES * angle)])
    _, cosine, sine = np.linalg.lstsq(parts, radial.T, rcond=None)[0]
    return frames.time[settled], sine - 1j * cosine, spin[settled].mean()


def two_frequencies(time, wave, guess):
    """The two angular frequencies, rad/s, whose decaying turns e^{i p t} and a constant fit the wave best."""
    def residual(parameters):
        turns = np.exp(np.outer(time, 1j * parameters[:2] - parameters[2:]))
        parts = np.column_stack([turns, np.ones_like(time)])
        rest = (wave - parts @ np.linalg.lstsq(parts, wave, rcond=None)[0]) / np.abs(wave).max()
        return np.concatenate([rest.real, rest.imag])
    return least_squares(residual, [*guess, 0, 0], x_scale=[*np.abs(guess) / 1000, 1, 1]).x[:2]


def draw(name, still, points):
    spins = np.linspace(0, 1.05 * max(spin for spin, _ in points), 200)
    against, along = np.abs([predicted(still, spin) for spin in spins]).T / (2 * np.pi)
    with picture(name, "spin, rad/s", "frequency in the turning frame, Hz") as axes:
        axes.plot(spins, against, "C0", label="against the spin, theory")
        axes.plot(spins, along, "C1", label="with the spin, theory")
        for spin, found in points:
            axes.plot([spin, spin], np.abs(found) / (2 * np.pi), "ko", markersize=4)
        axes.grid(alpha=0.3)
