"""Mutated decks: `check` and `run` end with a sound or a message."""

from . import mutations, scenes
from .program import FAILED, FINISHED, RESUMABLE, WRONG_DECK

BASES = ("simple", "rich", "touching", "hexahedra", "shadow")
COMMANDS = 4 * (("check", None), ("run", None)) + (("run", 2),)  # with the ranks; mpirun costs a second
NAMES = {FINISHED: "finished", FAILED: "failed with a message", WRONG_DECK: "refused", RESUMABLE: "stopped"}


class Decks:
    SHARE = 4

    def __init__(self, program, work):
        self.program = program
        self.texts = {name: scenes.text_of(name) for name in BASES}
        self.lines = [line for text in self.texts.values() for line in text.splitlines(keepends=True)]

    def trial(self, random, folder):
        name = random.choice(BASES)
        scenes.lay_out(folder)
        text = mutations.text(random, self.texts[name], self.lines)
        (folder / "deck.yaml").write_bytes(text.encode(errors="replace"))
        command, ranks = random.choice(COMMANDS)
        job = self.program.call(folder, command, "deck.yaml", "--output-folder", "results", ranks=ranks)
        if job.status in (FINISHED, RESUMABLE):
            for result in (folder / "results").glob("*.h5"):
                self.program.bits(result)
        return NAMES[job.status]
