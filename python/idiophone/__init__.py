"""Idiophone in Python: decks, runs, modes, sound maps and results.

    import idiophone

    deck = idiophone.Deck.read("inputs/square_plate_off_center.yaml")
    deck["bodies.plate.parameters.side"] = 0.8
    print(deck.check().costs.memory_bytes)
    result = deck.run(ranks=2)
    result.audio["ears"].values        # [samples x channels], Pa
    result.plot_spectrum()

The program `idiophone` computes in processes of its own. It is that of this source tree, or the installed one; the
environment variable IDIOPHONE names another one. All numbers are in SI units. All errors are IdiophoneError.
"""
from .deck import Deck
from .errors import DeckError, IdiophoneError, Mistake, ProgramError, Stopped
from .facts import Facts
from .modes import FrequencyBounds, Modes
from .radiation import Radiation
from .result import Result
from .series import Series
from .sofa import write_sofa
from .sound_map import Hammer, SoundMap
from .studies import Constant, Identification, InTune, Line, ModeScatter, TunedMode, Tuning
from .uff import Function, write_uff

__all__ = ["Constant", "Deck", "DeckError", "Facts", "FrequencyBounds", "Function", "Hammer", "Identification",
           "IdiophoneError", "InTune", "Line", "Mistake", "ModeScatter", "Modes", "ProgramError", "Radiation",
           "Result", "Series", "SoundMap", "Stopped", "TunedMode", "Tuning", "write_sofa", "write_uff"]
