"""The sounds of `play`, `proxies`, `timbre` and `listen`: commands for compare_sound, which runs them with two programs.

What they read (sound maps, results, recordings) is made once, by the program of the base. Options that have other names
in older programs are translated for them.
"""
import dataclasses
import functools
import io
import pathlib
import subprocess
import warnings

from scipy.io import wavfile

from library.result_bits import level_of_difference

BLOW = "{time: 0.01, at: [0.02, 0.01, 0.01], direction: [0, 0, -1], mass: 0.01, hardness: 1e8, speed: 1}"
SCRAPE = ("{type: scrape, time: 0.1, from: [-0.02, 0, 0.01], to: [0.02, 0, 0.01], direction: [0, 0, -1], speed: 0.2, load: 1,"
          " mass: 0.01, hardness: 1e9, friction: 0.2, roughness: {height: 1e-6}}")
ROLL = ("{type: roll, time: 0.3, from: [0.02, 0, 0.01], to: [-0.02, 0.02, 0.01], direction: [0, 0, -1], speed: 0.2, load: 0.5,"
        " mass: 0.05, hardness: 1e10, size: 2e-4, roughness: {height: 1e-7}}")
FORCE = "{type: force, time: 0.2, at: [0, 0, 0.01], force: [0, 0, -20], shape: half_sine, duration: 1e-3}"
TUNE = "{type: tune, time: 0.15, size: 1.2, friction: 3}"
NOTE = "{note: 60, at: [0.02, 0.01, 0.01], direction: [0, 0, -1], mass: 0.01, hardness: 1e8, speed: 1}"
STILL = "{type: stereo, position: [0.3, 0, 1], look: [0, 0, -1], up: [0, 1, 0]}"
WALK = "{type: stereo, path: [[0, -1, 0, 1], [0.5, 1, 0, 1]], look: [0, 0, -1], up: [0, 1, 0]}"
HEAD = ("{type: binaural, path: [[0, -1, 0, 1], [0.5, 1, 0, 1]], look: [0, 0, -1], up: [0, 1, 0],"
        " hrtf: /usr/share/libmysofa/MIT_KEMAR_normal_pinna.sofa}")
SCORES = {
    "blow": ([BLOW], None), "strokes": ([BLOW, SCRAPE, ROLL, FORCE], STILL), "tuned": ([BLOW, SCRAPE, TUNE, FORCE], None),
    "walk": ([BLOW, SCRAPE, TUNE, ROLL], WALK), "head": ([BLOW, SCRAPE], HEAD),
}
# One track: note 60 twice and note 64 once, at 96 ticks a quarter of half a second.
MIDI = (b"MThd\x00\x00\x00\x06\x00\x00\x00\x01\x00\x60MTrk\x00\x00\x00\x14"
        b"\x00\x90\x3c\x40\x20\x90\x3c\x7f\x10\x90\x40\x7f\x10\x80\x3c\x00\x00\xff\x2f\x00")
SCENES = ("bee", "bee_stages", "wind", "cubes", "lamp", "coin", "chimes")
MOTIONS = ("cubes", "lamp", "coin", "chimes")  # scenes that are bound to the motion of a run
QUICK_SCENES = ("bee_stages", "cubes", "lamp")
SURFACE = ["--set", "output.surface_motion=true"]


@dataclasses.dataclass(frozen=True)
class Sounding:
    """A command that writes sounds into a folder."""
    name: str
    arguments: tuple  # of the program; FOLDER stands for the folder
    needs: tuple = ()  # names of what preparation() makes

    def __str__(self):
        return self.name


def scores(folder):
    """Writes the scores and the MIDI file."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, (events, listener) in SCORES.items():
        lines = ["duration: 0.5", "events:", *(f"  - {event}" for event in events), "notes:", f"  - {NOTE}"]
        lines += [f"listener: {listener}"] if listener else []
        (folder / f"{name}.yaml").write_text("\n".join(lines) + "\n")
    (folder / "notes.mid").write_bytes(MIDI)


def preparation(tree, given, quick):
    """What the commands read: its file in the folder `given` -> the arguments that make it there."""
    decks = tree / "ctest/app/decks"
    made = {
        "simple_plate.map.h5": ["map", decks / "simple.yaml", "--modes", 30],
        "bounce.h5": ["run", decks / "bounce.yaml", "--progress", "log"],
        "simple_surface.h5": ["run", decks / "simple.yaml", "--progress", "log", *SURFACE],
    }
    for scene in MOTIONS:
        if not quick or scene in QUICK_SCENES:
            made[f"{scene}_motion.h5"] = ["run", tree / f"inputs/timbre/{scene}_motion.yaml", "--progress", "log"]
    return {name: [*arguments, "--output-folder", given] for name, arguments in made.items()}


def soundings(tree, given, quick):
    """The commands. @param given  the folder of scores() and preparation()"""
    decks, plate = tree / "ctest/app/decks", given / "simple_plate.map.h5"
    found = []
    for name in SCORES:
        score = ["--score", given / f"{name}.yaml", "--output", "FOLDER/sound.wav"]
        found.append(Sounding(f"play {name}", ("play", plate, *score)))
        found.append(Sounding(f"proxies {name}", ("proxies", decks / "simple.yaml", *score)))
    score = ["--score", given / "tuned.yaml", "--output", "FOLDER/sound.wav"]
    found.append(Sounding("play midi", ("play", plate, *score, "--midi", given / "notes.mid", "--rate", 44100)))
    for name, options in {"levels": ["--levels", 2, "--lowest-rate", 4], "deviation": ["--sound", "deviation"],
                          "heun": ["--integrator", "improved_euler"], "loudness": ["--priority", "loudness"]}.items():
        found.append(Sounding(f"proxies {name}", ("proxies", decks / "simple.yaml", *score, *options)))
    driven = ("--contacts", given / "bounce.h5", "--output", "FOLDER/sound.wav")
    found.append(Sounding("proxies contacts", ("proxies", decks / "bounce.yaml", *driven)))
    found.append(Sounding("proxies result", ("proxies", decks / "simple.yaml", "--score", given / "blow.yaml",
                                             "--output-folder", "FOLDER")))
    found.append(Sounding("listen kirchhoff", ("listen", given / "simple.h5", "--set", "radiation.model=kirchhoff",
                                               "--output-folder", "FOLDER")))
    for scene in QUICK_SCENES if quick else SCENES:
        motion = [given / f"{scene}_motion.h5"] if scene in MOTIONS else []
        found.append(Sounding(f"timbre {scene}", ("timbre", tree / f"inputs/timbre/{scene}.yaml", *motion, "-o", "FOLDER/sound.wav")))
    return found


@functools.cache
def options_of(program, command):
    """The help of a command."""
    return subprocess.run([program, command, "--help"], capture_output=True, text=True).stdout


def spelt(program, arguments):
    """The arguments in the spelling of the program, which may be older than 0.3.0."""
    old = {"--output-folder": "--result" if arguments[0] == "proxies" else "--output", "--modes": "--count"}
    known = options_of(program, arguments[0])
    return [old.get(word, word) if word not in known else word for word in map(str, arguments)]


def call(program, arguments, environment):
    """Runs the program. @throws RuntimeError with its words if it fails"""
    arguments = spelt(program, arguments)
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, env=environment)
    if done.returncode != 0:
        raise RuntimeError(f"status {done.returncode}: {' '.join(map(str, arguments))}\n{done.stdout[-2000:]}{done.stderr[-2000:]}")


def prepare(tree, given, program, quick, environment):
    """Makes what the commands read, unless a former call did."""
    scores(given)
    for name, arguments in preparation(tree, given, quick).items():
        if not (given / name).exists():
            call(program, arguments, environment)


def sounds(sounding, program, folder, environment):
    """The bytes of every WAV and MIDI file that a command writes, by name."""
    folder.mkdir(parents=True)
    call(program, [str(argument).replace("FOLDER", str(folder)) for argument in sounding.arguments], environment)
    return written(folder)


def written(folder):
    """The bytes of the WAV and MIDI files of a folder, by name."""
    return {path.name: path.read_bytes() for path in sorted(pathlib.Path(folder).iterdir()) if path.suffix in (".wav", ".mid")}


def wrong_sounds(base, head):
    """What differs between two answers of sounds()."""
    if not base:
        return "no sound was written"
    if set(base) != set(head):
        return f"other files: {sorted(set(base) ^ set(head))}"
    return ", ".join(f"{name} ({distance(base[name], head[name])})" for name in base if base[name] != head[name])


def distance(base, head):
    """How far the sounds of two WAV files are from each other; of other files, only that they differ."""
    if not base.startswith(b"RIFF"):
        return "differs"
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", wavfile.WavFileWarning)  # of chunks beside the samples
        return level_of_difference(*(wavfile.read(io.BytesIO(sound))[1] for sound in (base, head)))
