"""Sound maps in Python: modes, directivity and blows."""
import subprocess

import numpy as np
import pytest
from conftest import DECKS

import idiophone
from idiophone.program import path_of_program


@pytest.fixture(scope="module")
def plate(tmp_path_factory):
    folder = tmp_path_factory.mktemp("maps")
    subprocess.run([path_of_program(), "map", DECKS / "simple.yaml", "--up-to", "3000", "--radiation", "kirchhoff",
                    "--output-folder", folder], check=True)
    (path,) = folder.glob("*.map.h5")
    return idiophone.SoundMap(path)


def test_has_the_modes(plate):
    assert len(plate) == len(plate.decay) > 3
    assert np.all(plate.frequency < 3000)
    directions, pressure = plate.directivity(0)
    np.testing.assert_allclose(np.linalg.norm(directions, axis=1), 1)
    assert pressure.shape == (len(directions),) and np.iscomplexobj(pressure)


def test_a_blow_is_as_loud_as_its_impulse(plate):
    at, down = [0.04, 0.03, 0.01], [0, 0, -2]
    once = plate.strike(at, down, impulse=1e-3, duration=0.1)
    assert once.unit == "Pa" and once.rate == 48000 and len(once.values) == 4800
    twice = plate.strike(at, down, impulse=2e-3, duration=0.1)
    np.testing.assert_allclose(twice.values, 2 * once.values, rtol=1e-6, atol=1e-9)
    # A pulse is short for the lowest mode: its sound depends on the impulse alone.
    wider = plate.strike(at, down, impulse=1e-3, width=4e-4, duration=0.1)
    lowest = lambda sound: abs(np.vdot(np.exp(2j * np.pi * plate.frequency[0] * sound.time), sound.values[:, 0]))
    assert lowest(wider) == pytest.approx(lowest(once), rel=0.05)


def test_a_blow_by_a_hammer(plate):
    soft = plate.strike([0, 0, 0.01], [0, 0, -1], hammer=idiophone.Hammer(0.01, 1e5, 1), duration=0.05)
    hard = plate.strike([0, 0, 0.01], [0, 0, -1], hammer=idiophone.Hammer(0.01, 1e9, 1), duration=0.05)
    assert np.abs(np.diff(hard.values[:, 0])).max() > np.abs(np.diff(soft.values[:, 0])).max()
    with pytest.raises(ValueError, match="not both"):
        plate.strike([0, 0, 0], [0, 0, 1], impulse=1, hammer=idiophone.Hammer())
    with pytest.raises(idiophone.IdiophoneError, match="rate"):
        plate.strike([0, 0, 0], [0, 0, 1], rate=1)


def test_refuses_what_is_no_map(result):
    with pytest.raises(idiophone.IdiophoneError, match="not a sound map"):
        idiophone.SoundMap(result.path)
    with pytest.raises(idiophone.IdiophoneError, match="no file"):
        idiophone.SoundMap("none.h5")
