"""A program of several ranks, for test_native.py: runs a deck, and makes mistakes. Each rank writes what it met."""
import json
import pathlib
import signal
import sys

from conftest import DECKS
from mpi4py import MPI

import idiophone

folder = pathlib.Path(sys.argv[1])
world = MPI.COMM_WORLD
met = {"ranks": world.size, "messages": []}
deck = idiophone.Deck.read(DECKS / "simple.yaml")
met["progress"] = []
result = deck.run(folder, communicator=world, progress=met["progress"].append)
met["samples"] = len(result.sound().values)

# One rank by itself, while the others do something else.
if world.rank == world.size - 1:
    alone = deck.run(folder / "alone", communicator=MPI.COMM_SELF)
    met["alone"] = alone.sound().values.tobytes() == result.sound().values.tobytes()
met["program"] = deck.check().nodes

deck["bodies.plate.material"] = "rubbr"
values = idiophone.Deck(dict(deck._values), DECKS)
for wrong in deck, values:
    try:
        wrong.run(folder, communicator=world)
    except idiophone.DeckError as error:
        met["messages"].append([(mistake.key, mistake.text) for mistake in error.mistakes])
deck["bodies.plate.material"] = "rubber"
(folder / "file").touch()
try:
    deck.run(folder / "file", communicator=world)
except idiophone.ProgramError as error:
    met["messages"].append(str(error))
try:
    deck.modes("plat")
except idiophone.ProgramError as error:
    met["messages"].append(str(error))

# A signal on one rank stops all.
deck["time.duration"] = 0.25
stop = (lambda done: signal.raise_signal(signal.SIGINT)) if world.rank == 0 else None
try:
    deck.run(folder / "parts", communicator=world, progress=stop)
except (KeyboardInterrupt, idiophone.Stopped) as error:
    met["stopped"] = type(error).__name__
met["resumed"] = deck.run(folder / "parts", communicator=world, resume=True).facts.jobs[1].ranks
(folder / f"rank{world.rank}.json").write_text(json.dumps(met))
