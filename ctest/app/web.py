"""What tests need of npm: playwright-core for web pages, and the glTF validator."""
import json
import os
import pathlib
import subprocess

import program

MODULES = pathlib.Path(os.environ["IDIOPHONE_WEB_MODULES"])


def install_modules():
    wanted = json.loads((program.SOURCE / "ctest/web/package.json").read_text())["dependencies"]
    if not all((MODULES / "node_modules" / name).exists() for name in wanted):
        MODULES.mkdir(parents=True, exist_ok=True)
        packages = [f"{name}@{version}" for name, version in wanted.items()]
        subprocess.run(["npm", "install", "--silent", "--no-save", "--no-package-lock", *packages], cwd=MODULES, check=True)


def in_browser(script, *arguments):
    """What a script of ctest/web prints, as JSON, after it used a page in Chromium, or a file."""
    install_modules()
    answer = subprocess.run(["node", program.SOURCE / "ctest/web" / script, *map(str, arguments)],
                            env={**os.environ, "WEB_MODULES": str(MODULES)}, capture_output=True, text=True, timeout=program.TIMEOUT)
    assert answer.returncode == 0, answer.stdout + answer.stderr
    return json.loads(answer.stdout)


def page_of_room(folder, deck, bodies, up_to):
    """The Sonic Explorer of a deck called `room`, and the sound maps of its bodies.

    :param deck: its text
    :param up_to: Hz, the highest mode
    """
    path, page = folder / "room.yaml", folder / "explorer.html"
    path.write_text(deck)
    job = program.idiophone("map", path, "--up-to", up_to, "--output-folder", folder)
    assert job.returncode == program.FINISHED, job.stdout + job.stderr
    maps = [folder / f"room_{body}.map.h5" for body in bodies]
    job = program.idiophone("explore", *maps, "-o", page)
    assert job.returncode == program.FINISHED, job.stdout + job.stderr
    return page, maps


if __name__ == "__main__":
    install_modules()
