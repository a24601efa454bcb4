"""What is found from decks: constants of materials, tuned numbers, radiated sound."""
import math

import numpy as np
import pytest
from conftest import DECKS

import idiophone

THICKNESS = "bodies.plate.parameters.thickness"


@pytest.fixture
def ball():
    return idiophone.Deck.read(DECKS / "free.yaml")


@pytest.fixture(scope="module")
def lines():
    """Frequencies, Hz, of the ball with other constants."""
    ball = idiophone.Deck.read(DECKS / "free.yaml")
    ball["materials.rubber.young"] = 6.2e6
    return ball.modes(count=8, estimate=False).frequency


def test_identifies_the_constants_that_were_used(ball, lines):
    found = ball.identify(lines, fit=["young"], mass="lumped")
    assert found.accepted and found.doubts == []
    assert found.constants["young"].value == pytest.approx(6.2e6, rel=1e-5)
    assert found.constants["young"].in_the_deck == 5e6 and found.constants["young"].determined
    assert [line.measured for line in found.lines] == pytest.approx(list(lines))
    assert found.lines[0].mode == 1 and abs(found.lines[0].cents) < 0.01
    assert found.fitted_rms < 0.01 and found.predicted_rms is None
    assert found.chi_squared < 1e-3 and found.degrees_of_freedom == len(lines) - 1
    ball["materials.rubber"] = found.materials["rubber"]
    assert ball["materials.rubber.young"] == pytest.approx(6.2e6, rel=1e-5)
    assert ball.modes(count=1, estimate=False).frequency[0] == pytest.approx(lines[0], rel=1e-5)


def test_a_fit_with_a_false_line_is_returned_with_its_doubts(ball, lines):
    first = np.argmax(lines[1:] / lines[:-1])  # the widest gap
    false = np.sqrt(lines[first] * lines[first + 1])
    found = ball.identify({"mass": 0.3, "lines": [*lines, false]}, fit=["young"], mass="lumped", tolerance=15)
    assert not found.accepted and "1 of 9 lines" in found.doubts[0]
    (line,) = [line for line in found.lines if line.mode is None]
    assert line.measured == pytest.approx(false) and line.computed is None
    assert found.density == pytest.approx(0.3 / found.volume, rel=1e-6)


def test_wrong_measurements_are_program_errors(ball):
    with pytest.raises(idiophone.ProgramError, match="did you mean 'young'"):
        ball.identify([1000], fit=["yuong"])
    with pytest.raises(idiophone.ProgramError, match="--turn-deviation needs turns"):
        ball.identify([1000], fit=["young"], turn_deviation=4)
    with pytest.raises(idiophone.DeckError, match="line"):
        ball.identify({"linez": [1000]})


def test_tunes_a_plate(simple):
    found = simple.tune([200.0], {THICKNESS: (0.01, 0.03)}, scatter={THICKNESS: "0.5%"}, within=5, avoid=["1:2"])
    assert found.tuned and not found.decays and not found.avoided[0].modes and found.bounds == {THICKNESS: None}
    (mode,) = found.modes
    assert (mode.start_mode, mode.wanted) == (1, pytest.approx(200)) and abs(mode.cents) < 2
    assert mode.sensitivities[THICKNESS] > 0, "a thicker plate is higher"
    assert found.in_tune and found.in_tune.scatter[THICKNESS]["mean"] == pytest.approx(found.values[THICKNESS])
    effect = found.in_tune.modes[0].effects[THICKNESS]
    assert effect == pytest.approx(mode.sensitivities[THICKNESS] * 0.005 * found.values[THICKNESS], rel=0.05)
    assert found.in_tune.share == pytest.approx(math.erf(5 / effect / math.sqrt(2)), abs=0.05)
    for key, value in found.values.items():
        simple[key] = value
    assert simple.modes(count=1, estimate=False).frequency[0] == pytest.approx(200, abs=0.3)


def test_tunes_a_level(simple):
    simple["audio.max_frequency"] = 250  # one mode
    found = simple.tune([200.0], {THICKNESS: (0.01, 0.03)}, levels={"ear": "at_least:10"}, level_tolerance=1)
    (level,) = found.levels
    assert found.tuned and level.reached and (level.listener, level.kind, level.wanted) == ("ear", "at_least", 10)
    assert level.level > 10 and level.sensitivities == {THICKNESS: 0}
    missed = simple.tune([200.0], {THICKNESS: (0.019, 0.021)}, levels={"ear": 80})
    assert not missed.tuned and not missed.levels[0].reached and "at ear instead of 80 dB" in missed.messages[-1]


def test_what_cannot_be_tuned_has_the_best_values(simple):
    found = simple.tune(["A6"], {THICKNESS: (0.019, 0.021)}, modes=np.array([1]))
    assert not found.tuned and found.bounds == {THICKNESS: "upper"} and found.values[THICKNESS] == pytest.approx(0.021)
    assert any("not all modes are within 2 cents" in line for line in found.messages)


def test_a_ball_that_moves_to_and_fro_is_a_dipole(ball):
    """Power of an oscillating sphere: Morse and Ingard 1968, eq. 7.1.15, for any wavelength."""
    frequency, radius, speed = 500.0, 0.04, 343.0
    sound = ball.radiate(frequencies=[frequency], tolerance=0)
    assert sound.motions == ["along x", "along y", "along z"] and sound.listeners == ["ear"]
    x = 2 * np.pi * frequency / speed * radius
    exact = np.pi / 1.5 * 1.2 * speed * radius**2 * x**4 / (4 + x**4)  # W, for 1 m/s
    np.testing.assert_allclose(10 * np.log10(sound.power / exact), 0, atol=1.5)  # the mesh is a coarse polyhedron
    assert sound.solid_angle.sum() == pytest.approx(4 * np.pi)
    np.testing.assert_allclose(np.abs(sound.directivity(2)), np.abs(sound.directions[:, 2]), atol=0.06)
    assert sound.listener_pressure.shape == (3, 1) and sound.surface_pressure.shape == (3, len(sound.vertices))
    assert np.all(np.isnan(sound.loss_factor)) and set(sound.model_error) == {"kirchhoff", "rayleigh"}


def test_refuses_what_is_no_radiated_sound(result):
    with pytest.raises(idiophone.IdiophoneError, match="not a radiation"):
        idiophone.Radiation(result.path)
