"""Computations in the process of Python, by the extension."""
import json
import logging
import pathlib
import signal
import subprocess
import sys

import numpy as np
import pytest
from mpi4py import MPI

import idiophone
from idiophone import native, program


@pytest.fixture
def no_program(monkeypatch):
    """Whoever calls the program fails."""
    assert native.is_built()  # which asks the program whether this processor can run it

    def fail(*arguments, **options):
        raise AssertionError("the program is called")
    monkeypatch.setattr(program, "_call", fail)


def test_modes_are_computed_in_this_process(simple, no_program):
    modes = simple.modes(count=4)
    assert modes.shape.shape == (4, len(modes.nodes), 3) and modes.kinds[0] == "(0, 0)"
    assert modes.shape.flags.c_contiguous and modes.mesh_error.shape == (4,)


def test_modes_are_those_of_the_program(simple, monkeypatch):
    own = simple.modes("plate", count=4)
    monkeypatch.setattr(native, "is_built", lambda: False)
    its = simple.modes("plate", count=4)
    for name in "frequency", "damping_ratio", "decay_time", "nodes":
        np.testing.assert_allclose(getattr(own, name), getattr(its, name), rtol=1e-9)
    np.testing.assert_allclose(own.mesh_error, its.mesh_error, rtol=1e-6)
    np.testing.assert_allclose(own.shape, its.shape, atol=1e-6 * np.abs(its.shape).max())
    np.testing.assert_array_equal(own.elements, its.elements)
    assert own.kinds == its.kinds and own.rigid_motions == its.rigid_motions


def test_mistakes_have_their_places_and_keys(simple, tmp_path, no_program):
    simple["bodies.plate.material"] = "rubbr"
    with pytest.raises(idiophone.DeckError, match="did you mean 'rubber'") as caught:
        simple.modes()
    assert [mistake.key for mistake in caught.value.mistakes] == ["bodies.plate.material"]
    path = tmp_path / "deck.yaml"
    path.write_text(simple._path.read_text().replace("material: rubber", "material: rubbr")
                    .replace("../../../meshes", str(simple._path.parents[3] / "meshes")))
    with pytest.raises(idiophone.DeckError) as caught:
        idiophone.Deck.read(path).modes()
    assert [(mistake.file, mistake.line, mistake.column) for mistake in caught.value.mistakes] == [(str(path), 11, 15)]
    simple["bodies.plate.material"] = "rubber"
    with pytest.raises(idiophone.ProgramError, match="no body 'plat'"):
        simple.modes("plat")
    with pytest.raises(ValueError, match="count"):
        simple.modes(count=0)


def test_a_run_in_this_process_has_the_bits_of_the_program(simple, result, tmp_path, no_program, caplog):
    done = []
    with caplog.at_level(logging.INFO, "idiophone"):
        same = simple.run(tmp_path, communicator=MPI.COMM_WORLD, progress=done.append)
    assert same.sound().values.tobytes() == result.sound().values.tobytes()
    assert done[-1] == 1 and "of computing" in caplog.text
    assert (tmp_path / "simple.wav").read_bytes() == (result.path.parent / "simple.wav").read_bytes()
    with pytest.raises(ValueError, match="neither ranks nor stop"):
        simple.run(tmp_path, ranks=2, communicator=MPI.COMM_WORLD)


def test_ctrl_c_stops_a_run_in_this_process(simple, tmp_path):
    handler = signal.getsignal(signal.SIGINT)
    simple["time.duration"] = 0.5
    whole = simple.run(tmp_path / "whole", communicator=MPI.COMM_SELF)
    with pytest.raises(KeyboardInterrupt):
        simple.run(tmp_path / "parts", communicator=MPI.COMM_SELF, progress=lambda done: signal.raise_signal(signal.SIGINT))
    with pytest.raises(ZeroDivisionError):
        simple.run(tmp_path / "parts", communicator=MPI.COMM_SELF, resume=True, progress=lambda done: 1 / 0)
    with pytest.raises(ZeroDivisionError):  # at the end, where nothing is left to stop
        simple.run(tmp_path / "last", communicator=MPI.COMM_SELF, progress=lambda done: 1 / (1 - done))
    resumed = simple.run(tmp_path / "parts", communicator=MPI.COMM_SELF, resume=True)
    assert len(resumed.facts.jobs) == 3
    assert resumed.sound().values.tobytes() == whole.sound().values.tobytes()
    assert signal.getsignal(signal.SIGINT) is handler
    with pytest.raises(KeyboardInterrupt):
        signal.raise_signal(signal.SIGINT)


def test_a_program_of_two_ranks(result, tmp_path):
    script = pathlib.Path(__file__).with_name("mpi_program.py")
    job = subprocess.run(["mpirun", "--oversubscribe", "--bind-to", "none", "-n", "2", sys.executable, script, tmp_path],
                         env=program._environment(), capture_output=True, text=True, timeout=300)
    assert job.returncode == 0, job.stdout + job.stderr
    first, second = (json.loads((tmp_path / f"rank{rank}.json").read_text()) for rank in (0, 1))
    assert (tmp_path / "simple.wav").read_bytes() == (result.path.parent / "simple.wav").read_bytes()
    assert (first["ranks"], first["samples"], second["samples"], second["alone"]) == (2, 100, 100, True)
    assert first["progress"][-1] == 1 and second["progress"] == []
    assert first["messages"] == second["messages"] and first["program"] == result.facts.nodes
    changed, values, folder, body = first["messages"]
    assert changed[0][0] == values[0][0] == "bodies.plate.material"
    assert "file" in folder and "no body 'plat'" in body
    assert (first["stopped"], second["stopped"], first["resumed"]) == ("KeyboardInterrupt", "Stopped", 2)


def test_without_the_extension_runs_in_this_process_are_refused(simple, tmp_path, monkeypatch):
    monkeypatch.setattr(native, "is_built", lambda: False)
    with pytest.raises(idiophone.ProgramError, match="pybind11-dev"):
        simple.run(tmp_path, communicator=MPI.COMM_WORLD)
