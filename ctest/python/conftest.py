"""What the tests of the Python module share."""
import pathlib

import pytest

import idiophone

DECKS = pathlib.Path(__file__).resolve().parents[1] / "app/decks"


@pytest.fixture
def simple():
    """A small plate that is struck: 100 samples."""
    return idiophone.Deck.read(DECKS / "simple.yaml")


@pytest.fixture(scope="session")
def result(tmp_path_factory):
    """The result of its run."""
    return idiophone.Deck.read(DECKS / "simple.yaml").run(tmp_path_factory.mktemp("result"))
