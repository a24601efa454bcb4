"""What the tests of web pages need: playwright-core, from npm."""
import json
import os
import pathlib
import subprocess

import program

MODULES = pathlib.Path(os.environ["IDIOPHONE_WEB_MODULES"])


def install_modules():
    wanted = json.loads((program.SOURCE / "ctest/web/package.json").read_text())["dependencies"]
    if not (MODULES / "node_modules/playwright-core").exists():
        MODULES.mkdir(parents=True, exist_ok=True)
        packages = [f"{name}@{version}" for name, version in wanted.items()]
        subprocess.run(["npm", "install", "--silent", "--no-save", "--no-package-lock", *packages], cwd=MODULES, check=True)
