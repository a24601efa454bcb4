"""Sound maps in Python: modes, directivity and blows."""
import subprocess

import h5py
import netCDF4
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
    np.testing.assert_allclose(np.linalg.norm(plate.directions, axis=1), 1)
    assert plate.far_field.shape == (len(plate), len(plate.directions)) and np.iscomplexobj(plate.far_field)
    assert plate.listeners == ["ear"] and plate.body == "plate"


def test_the_response_is_the_spectrum_of_a_blow(plate):
    at, down = plate.vertices[40], [0, 0, -1]
    sound = plate.strike(at, down, impulse=1e-3, width=2e-4, duration=1.0)
    frequency = np.arange(150.0, 2900, 37)
    spectrum = np.exp(-2j * np.pi * np.outer(frequency, sound.time)) @ sound.values[:, 0] / sound.rate
    time = np.linspace(0, 2e-4, 2001)
    force = np.exp(-2j * np.pi * np.outer(frequency, time)) @ (1e-3 * np.pi / 4e-4 * np.sin(np.pi * time / 2e-4)) * time[1]
    ratio = spectrum / force / plate.listener_response(frequency, at, down)[:, 0]
    np.testing.assert_allclose(np.abs(ratio), 1, atol=0.06)  # `play` has samples
    late = -np.unwrap(np.angle(ratio)) / (2 * np.pi * frequency)
    assert np.all((late > -1e-5) & (late < 2.5 / sound.rate)), "later than `play` by more than its rounding"


def test_the_power_at_a_resonance_is_what_the_mode_loses(plate):
    vertex, down = 40, np.array([0, 0, -1.0])
    with h5py.File(plate.path) as file:
        lost = file["modes/radiation_decay"][0]  # W at a modal velocity of 1 m sqrt(kg)/s
    velocity = plate.shape[0, vertex] @ down / (2 * plate.decay[0])  # at resonance the damping takes the whole force
    power = plate.radiated_power([plate.frequency[0]], plate.vertices[vertex], down)
    assert power[0] == pytest.approx(lost * velocity**2, rel=0.03)  # the rest is that of the other modes


def test_the_power_is_that_of_the_far_field(plate):
    at, down, frequency = plate.vertices[40], [0, 0, -1], np.linspace(20, 3000, 2100)
    pressure = plate.far_field_response(frequency, at, down)
    power = plate.distance**2 / (2 * plate.impedance) * (np.abs(pressure)**2 @ plate.weights)
    np.testing.assert_allclose(plate.radiated_power(frequency, at, down), power, rtol=1e-3)
    assert len(plate.radiated_power([], at, down)) == 0


def test_a_sofa_file_has_the_far_field(plate, tmp_path):
    idiophone.write_sofa(plate, tmp_path / "modes.sofa")
    with netCDF4.Dataset(tmp_path / "modes.sofa") as file:
        assert (file.Conventions, file.SOFAConventions, file.DataType) == ("SOFA", "FreeFieldDirectivityTF", "TF")
        assert file["Data.Real"].dimensions == ("M", "R", "N") and file["ReceiverPosition"].dimensions == ("R", "C", "I")
        assert np.all(np.diff(file["N"][:]) >= 0)
        np.testing.assert_allclose(file["Data.Real"][0].T + 1j * file["Data.Imag"][0].T, plate.far_field)
        azimuth, elevation, radius = np.radians(file["ReceiverPosition"][:, 0, 0]), np.radians(file["ReceiverPosition"][:, 1, 0]), 1
        found = np.transpose([np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)])
        np.testing.assert_allclose(radius * found, plate.directions, atol=1e-9)


def test_a_sofa_file_has_the_response_to_a_force(plate, tmp_path):
    at, down, frequency = plate.vertices[40], [0, 0, -1], [200.0, 500.0, 1000.0]
    idiophone.write_sofa(plate, tmp_path / "blow.sofa", frequency, at, down)
    with netCDF4.Dataset(tmp_path / "blow.sofa") as file:
        np.testing.assert_allclose(file["N"][:], frequency)
        np.testing.assert_allclose(file["Data.Real"][0].T, plate.far_field_response(frequency, at, down).real)
        assert "per newton" in file.Description
    listing = subprocess.run(["ncdump", "-h", tmp_path / "blow.sofa"], capture_output=True, text=True)
    assert listing.returncode == 0 and "double Data.Imag(M, R, N)" in listing.stdout
    with pytest.raises(ValueError, match="together"):
        idiophone.write_sofa(plate, tmp_path / "blow.sofa", frequency)


def test_uff_files_have_responses_and_sounds(plate, tmp_path):
    frequency, time = np.arange(100, 400, 12.5), np.array([0, 0.1, 0.3])
    response = plate.listener_response(frequency, plate.vertices[40], [0, 0, -1])[:, 0]
    sound = np.array([1.0, -2.5e-7, 3e12])
    idiophone.write_uff(tmp_path / "all.uff", [idiophone.Function("ear", response, frequency, "Pa/N"),
                                               idiophone.Function("left ear", sound, time, "Pa", node=2)])
    first, second = [part.split("\n")[1:] for part in (tmp_path / "all.uff").read_text().split("    -1\n    58")[1:]]
    assert first[0] == "ear" and first[5][:5] == "    4" and second[5][:5] == "    1"
    assert first[5][31:41] == "ear       " and second[5][31:51] == "left_ear           2"
    assert [int(first[6][i:i + 10]) for i in (0, 10, 20)] == [6, 24, 1]
    assert [float(first[6][i:i + 13]) for i in (30, 43)] == [100, 12.5]
    assert [first[7][:10], first[7][47:49]] == ["        18", "Hz"] and first[8][47:49] == "Pa" and first[9][47:48] == "N"
    numbers = [float(line[i:i + 20]) for line in first[11:23] for i in range(0, 80, 20)]
    np.testing.assert_allclose(np.array(numbers[::2]) + 1j * np.array(numbers[1::2]), response, rtol=1e-11)
    assert [int(second[6][i:i + 10]) for i in (0, 10, 20)] == [4, 3, 0]
    uneven = [(float(line[i:i + 13]), float(line[i + 13:i + 33])) for line in second[11:13] for i in (0, 33) if line[i:]]
    np.testing.assert_allclose(uneven, np.transpose([time, sound]))
    assert first[23] == "    -1"


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


def test_the_directivity_of_a_mode_has_its_loudest_direction_as_one(plate):
    directivity = plate.directivity(0)
    assert np.abs(directivity).max() == pytest.approx(1)
    np.testing.assert_allclose(directivity * np.abs(plate.far_field[0]).max(), plate.far_field[0])
