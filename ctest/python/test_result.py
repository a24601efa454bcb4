"""Results in Python."""
import h5py
import matplotlib
import numpy as np
import pytest

import idiophone


def test_has_the_sound_with_its_unit_and_rate(result):
    sound = result.audio["ear"]
    with h5py.File(result.path) as file:
        np.testing.assert_array_equal(sound.values, file["audio/ear"][()])
    assert (sound.rate, sound.unit, sound.columns) == (8000, "Pa", ["ear"])
    np.testing.assert_array_equal(sound["ear"], sound.values[:, 0])
    assert sound.time[-1] == 99 / 8000
    np.testing.assert_allclose(sound.positions, [[0, 0, 0.3]])
    with pytest.raises(KeyError, match="it has: ear"):
        _ = result.audio["eye"]
    with pytest.raises(KeyError, match="it has: ear"):
        _ = sound["left"]


def test_has_all_channels_by_name(result):
    assert "motion/plate/velocity" in result.channels and "audio/ear" not in result.channels
    velocity = result.channels["motion/plate/velocity"]
    assert velocity.unit == "m/s" and velocity.values.shape[1] == 3
    assert result.energy.columns[:2] == ["kinetic", "elastic"]
    assert 0.5 < result.energy.values[-1, :4].sum() / result.energy["work"][-1] < 1  # damping takes a part


def test_has_facts_frames_and_meshes(result):
    facts = result.facts
    assert facts.bodies.plate.element == "tet10" and facts.jobs[0].ranks == 1
    assert facts.nodes == len(result.nodes("plate"))
    times = result.frame_times
    np.testing.assert_allclose(np.diff(times), 1e-3)
    last = result.mesh("plate", frame=-1)
    np.testing.assert_allclose(last.points - result.nodes("plate"), result.displacement("plate")[-1])
    assert last.cells[0].type == "tetra10" and len(last.cells[0].data) == facts.elements
    assert result.bodies == ["plate"]
    assert "square_plate.geo" in result.deck


def test_finds_partials(result):
    (channel,) = result.partials(highest=3000).channels
    assert channel.listener == "ear"


def test_draws_spectra(result):
    axes = result.plot_spectrum()
    (line,) = axes.lines
    assert line.get_ydata().max() == 0 and axes.get_xlabel() == "frequency, Hz"
    shades = result.plot_spectrogram(window=0.004).images[0]
    assert shades.get_array().max() == 0
    with pytest.raises(ValueError, match="window"):
        result.plot_spectrogram(window=1)
    matplotlib.pyplot.close("all")


def test_plays_in_a_notebook(result):
    assert result._repr_html_().count("<audio controls") == 1
    assert "<audio" not in result.energy._repr_html_()


def test_has_modes_with_their_kinds_and_shares(simple, tmp_path):
    kinds = simple.modes(count=3, estimate=False).kinds
    simple._answer("modes", "--modes", 3, "--no-estimate", "--output-folder", tmp_path)
    (path,) = tmp_path.glob("*_modes.h5")
    modes = idiophone.Result(path).modes["plate"]
    assert modes.kinds == kinds and modes.kinds[0] == "(0, 0)"
    np.testing.assert_array_equal(modes.kinetic_share, np.ones(3))
    with h5py.File(path, "a") as file:  # as programs wrote it before
        del file["modes/plate/kind"], file["modes/plate/kinetic_share"]
    modes = idiophone.Result(path).modes["plate"]
    assert modes.kinds == [] and modes.kinetic_share is None


def test_refuses_what_is_no_result(result, tmp_path):
    with pytest.raises(idiophone.IdiophoneError, match="there is no file"):
        idiophone.Result(tmp_path / "none.h5")
    (tmp_path / "text.h5").write_text("text")
    with pytest.raises(idiophone.IdiophoneError, match="can't be read"):
        idiophone.Result(tmp_path / "text.h5")
    with h5py.File(tmp_path / "other.h5", "w") as file:
        file.attrs["format"] = "idiophone sound map"
    with pytest.raises(idiophone.IdiophoneError, match="but an idiophone sound map"):
        idiophone.Result(tmp_path / "other.h5")
    with h5py.File(tmp_path / "other.h5", "w") as file:
        file.attrs["format"] = "idiophone result"
    with pytest.raises(idiophone.IdiophoneError, match="incomplete"):
        idiophone.Result(tmp_path / "other.h5")
    with pytest.raises(idiophone.IdiophoneError, match="no modes"):
        _ = result.modes
    with pytest.raises(idiophone.IdiophoneError, match="no listener eye; it has: ear"):
        result.sound("eye")
