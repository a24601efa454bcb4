"""Mutated scores, maps, trees, scenes, lines and sounds: the commands beside `run` end with an answer or a message."""

import shutil
import warnings
from dataclasses import dataclass

import numpy
import scipy.io.wavfile

from . import mutations, scenes
from .decks import NAMES
from .program import FINISHED, Wrong

NOTES = (b"MThd\0\0\0\x06\0\0\0\x01\0\x60MTrk\0\0\0\x0d"  # one track, 96 ticks a quarter
         b"\0\x90\x3c\x64\x60\x80\x3c\0\0\xff\x2f\0\0")
LINES = "mass: 0.88\nuncertainty: 5\nlines: [202, {frequency: 424, uncertainty: 6, decay_time: 0.6}, 584]\n"
MAP, MESH, SOUND = "simple_plate.map.h5", "plate.mesh.h5", "sound.wav"


@dataclass(frozen=True)
class Case:
    """A command, and its files that are mutated, one at a time."""
    mutated: tuple
    command: tuple


CASES = (
    Case(("score.yaml", MAP), ("play", MAP, "--score", "score.yaml", "--output", "heard.wav")),
    Case(("notes.mid",), ("play", MAP, "--score", "score.yaml", "--midi", "notes.mid", "--output", "heard.wav")),
    Case((MAP,), ("info", MAP)),
    Case((MAP,), ("export", MAP, "--faust", "map.dsp", "--gltf", "map.gltf")),
    Case((MAP,), ("explore", MAP)),
    Case(("score.yaml", "deck.yaml"), ("proxies", "deck.yaml", "--score", "score.yaml", "--output", "heard.wav")),
    Case(("collision.tt", "wind.tt", "wind.yaml"), ("timbre", "wind.yaml", "-o", "heard.wav")),
    Case(("bee.tt", "bee.yaml"), ("timbre", "bee.yaml", "-o", "heard.wav")),
    Case(("collision.tt", SOUND), ("evolve", "collision.tt", "--target", SOUND, "--population", "4", "--generations", "2")),
    Case(("lines.yaml", "deck.yaml"), ("identify", "deck.yaml", "--measured", "lines.yaml")),
    Case(("lines.yaml", "deck.yaml"), ("bench", "deck.yaml", "--target", "1:2.91", "--mode-numbers", "1,4", "--measured", "lines.yaml")),
    Case((SOUND,), ("analyze", SOUND)),
    Case((SOUND,), ("abx", SOUND, SOUND)),
    Case(("results/simple.h5",), ("report", "results/simple.h5")),
    Case(("deck.yaml",), ("radiate", "deck.yaml", "--modes", "2")),
    Case(("deck.yaml",), ("map", "deck.yaml", "--modes", "3")),
    Case(("deck.yaml",), ("mesh", "deck.yaml", "--output", MESH)),
    Case((MESH,), ("info", MESH)),
)


class Commands:
    SHARE = 4

    def __init__(self, program, work):
        self.program = program
        self.made = work / "inputs_of_commands"
        shutil.copytree(scenes.straight(program, work, "simple").folder, self.made)
        for file in (scenes.HOME / "inputs/timbre").glob("*.[ty]*"):
            shutil.copy(file, self.made)
        program.call(self.made, "map", "deck.yaml", "--modes", 5, "--output-folder", ".", allowed=(FINISHED,))
        for name, text in ("score.yaml", scenes.text_of("score")), ("lines.yaml", LINES):
            (self.made / name).write_text(text)
        (self.made / "notes.mid").write_bytes(NOTES)
        program.call(self.made, *CASES[0].command, allowed=(FINISHED,))
        shutil.copy(self.made / "heard.wav", self.made / SOUND)
        for case in CASES:
            program.call(self.made, *case.command, allowed=(FINISHED,))

    def trial(self, random, folder):
        case = random.choice(CASES)
        shutil.copytree(self.made, folder, dirs_exist_ok=True,
                        ignore=shutil.ignore_patterns("commands", "stdout", "stderr"))
        file = folder / random.choice(case.mutated)
        if file.suffix in (".yaml", ".tt"):
            file.write_bytes(mutations.text(random, file.read_text()).encode(errors="replace"))
        else:
            file.write_bytes(mutations.damaged(random, file.read_bytes()))
        job = self.program.call(folder, *case.command)
        heard = folder / "heard.wav"
        if job.status == FINISHED and heard.exists() and not numpy.isfinite(samples(heard)).all():
            raise Wrong(f"the sound is not finite\n{job.text()}")
        return f"{case.command[0]} {NAMES[job.status]}"


def samples(path):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", scipy.io.wavfile.WavFileWarning)  # of chunks beside the samples
        return scipy.io.wavfile.read(path)[1]
