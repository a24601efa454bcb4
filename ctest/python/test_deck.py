"""Decks from Python: values, mistakes, checks, modes, runs."""
import os
import pathlib
import signal
import subprocess
import threading

import numpy as np
import pytest
from conftest import DECKS

import idiophone

VERIFICATION = DECKS.parents[2] / "verification"


def python_values(simple):
    """The same deck as Python values."""
    values = {key: simple[key] for key in ("name", "time", "materials", "bodies", "loads", "listeners", "audio", "output")}
    return idiophone.Deck(values, folder=simple._path.parent)


def test_numbers_are_read_as_the_program_reads_them(simple, tmp_path):
    assert simple["materials.rubber.young"] == 5e7
    (tmp_path / "deck.yaml").write_text("{a: 2.0e11, b: 1e-3, c: -4, d: 1e5x, e: [.5, yes]}")
    deck = idiophone.Deck.read(tmp_path / "deck.yaml")
    assert [deck[key] for key in "abcd"] == [2e11, 1e-3, -4, "1e5x"]
    assert deck["e.0"] == 0.5
    with pytest.raises(KeyError, match=r"no e\.2"):
        deck["e.2"]


def test_check_knows_what_was_set(simple):
    before = simple.check()
    simple["materials.rubber.density"] = np.float64(2200)
    after = simple.check()
    assert after.bodies.plate.mass == pytest.approx(2 * before.bodies["plate"]["mass"])
    assert after.costs.memory_bytes > 0 and after.step > before.step
    assert any("body plate" in line for line in after.messages)
    with pytest.raises(AttributeError, match=r"there are: .*costs"):
        _ = after.cost


def test_mistakes_have_their_places(simple, tmp_path):
    path = tmp_path / "deck.yaml"
    path.write_text(simple._path.read_text().replace("material: rubber", "material: rubbr").replace("rate: 8000", "rate: fast")
                    .replace("../../../meshes", str(simple._path.parents[3] / "meshes")))
    with pytest.raises(idiophone.DeckError) as caught:
        idiophone.Deck.read(path).check()
    places = [(mistake.file, mistake.line, mistake.column) for mistake in caught.value.mistakes]
    assert places == [(str(path), 11, 15), (str(path), 17, 15)]
    assert "did you mean 'rubber'" in str(caught.value)
    path.write_text("name: [1\n")
    with pytest.raises(idiophone.DeckError, match=r"deck.yaml:2:1"):
        idiophone.Deck.read(path)


def test_mistakes_in_values_that_were_set_have_their_keys(simple):
    simple["bodies.plate.material"] = "rubbr"
    with pytest.raises(idiophone.DeckError) as caught:
        simple.check()
    assert [mistake.key for mistake in caught.value.mistakes] == ["bodies.plate.material"]


def test_mistakes_in_python_values_have_their_keys(simple):
    deck = python_values(simple)
    deck["bodies.plate.fixed.1"] = "rin"
    deck["listeners.ear.position"] = [0, 0]
    deck["listeners.ear.colour"] = "red"
    with pytest.raises(idiophone.DeckError) as caught:
        deck.check()
    assert [mistake.key for mistake in caught.value.mistakes] == ["listeners.ear.position", "listeners.ear.colour"]
    assert list(simple._path.parent.glob(".*.yaml")) == []


def test_python_values_sound_as_the_file_does(simple, result, tmp_path):
    same = python_values(simple).run(tmp_path)
    assert same.sound().values.tobytes() == result.sound().values.tobytes()


def test_runs_on_two_ranks_with_progress(simple, result, tmp_path):
    done = []
    same = simple.run(tmp_path, ranks=2, progress=done.append)
    assert same.sound().values.tobytes() == result.sound().values.tobytes()
    assert same.facts.jobs[0].ranks == 2
    assert done == sorted(done) and done[-1] == 1


def test_errors_on_two_ranks_have_no_notes_of_mpirun(simple, tmp_path):
    simple["loads.tap.radius"] = 1e-6
    with pytest.raises(idiophone.DeckError) as caught:
        simple.run(tmp_path, ranks=2)
    assert len(caught.value.mistakes) == 1 and "no surface node lies within" in str(caught.value)
    simple["loads.tap.radius"] = 0
    simple["bodies.plate.model"] = {"type": "modal", "count": 1}
    with pytest.raises(idiophone.ProgramError, match=r"^idiophone: rank 0: 2 ranks are too many.*run on at most 1$"):
        simple.run(tmp_path, ranks=2)


def test_modes_are_those_of_the_program(simple):
    modes = simple.modes(count=4)
    assert len(modes) == 4 and modes.shape.shape == (4, len(modes.nodes), 3)
    assert np.all(np.diff(modes.frequency) >= 0) and modes.kinds[0] == "(0, 0)"
    assert modes.rigid_motions == 0 and modes.mesh_error.shape == (4,)
    np.testing.assert_allclose(modes.frequency[1], modes.frequency[2], rtol=0.02)
    with pytest.raises(idiophone.IdiophoneError, match="plat"):
        simple.modes("plat")


def test_modes_have_bounds():
    bar = idiophone.Deck.read(VERIFICATION / "bar.yaml")
    bar["bodies.bar.element"] = "hex"
    bar["bodies.bar.parameters.size"] = 0.15
    bounds = bar.modes(count=1, estimate=False, bounds=True).bounds
    assert bounds.lower[0] < 574.403 < bounds.upper[0] < bounds.separation  # Hz, by 3-D elasticity
    assert bounds.modes_below >= 1
    assert bar.modes(count=1, estimate=False).bounds is None


def test_ctrl_c_stops_a_run_that_goes_on_later(simple, result, tmp_path):
    simple["time.duration"] = 0.5
    whole = simple.run(tmp_path / "whole")
    with pytest.raises(KeyboardInterrupt):
        simple.run(tmp_path / "parts", progress=lambda done: os.kill(os.getpid(), signal.SIGINT))
    assert subprocess.run(["pgrep", "-f", str(tmp_path)]).returncode == 1, "the program goes on"
    resumed = simple.run(tmp_path / "parts", resume=True)
    assert len(resumed.facts.jobs) == 2
    assert resumed.sound().values.tobytes() == whole.sound().values.tobytes()


def test_another_thread_stops_a_run(simple, tmp_path):
    simple["time.duration"] = 100
    stop = threading.Event()
    threading.Timer(1, stop.set).start()
    with pytest.raises(idiophone.Stopped):
        simple.run(tmp_path, ranks=2, stop=stop)
    assert subprocess.run(["pgrep", "-f", str(tmp_path)]).returncode == 1, "the program goes on"


def test_other_errors_have_the_words_of_the_program(simple, tmp_path):
    (tmp_path / "file").touch()
    with pytest.raises(idiophone.ProgramError, match="file"):
        simple.run(tmp_path / "file")
    with pytest.raises(ValueError, match="ranks"):
        simple.run(tmp_path, ranks=0)
    with pytest.raises(OSError, match=r"none\.yaml"):
        idiophone.Deck.read("none.yaml")


def test_a_missing_program_is_named(simple, monkeypatch):
    monkeypatch.setenv("IDIOPHONE", "")
    monkeypatch.setenv("PATH", "")
    monkeypatch.setattr("idiophone.program.__file__", "/a/b/c/d/e/f.py")
    with pytest.raises(idiophone.ProgramError, match="scripts/build"):
        simple.check()


def test_ranks_have_the_environment_of_the_scripts():
    lines = (pathlib.Path(__file__).resolve().parents[2] / "scripts/mpi_environment").read_text().splitlines()
    settings = [setting for line in lines if line.startswith("export ") for setting in line.split()[1:]]
    assert idiophone.program.MPI == dict(setting.split("=") for setting in settings)
