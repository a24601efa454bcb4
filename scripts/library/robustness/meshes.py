"""Mutated geometries and meshes: `check` and `run` end with a sound or a message."""

import subprocess
import sys

import gmsh

from . import mutations, scenes
from .decks import NAMES
from .program import FINISHED, RESUMABLE

DECK = """name: part
time: {{duration: 0.002}}
materials: {{rubber: {{young: 5.0e7, poisson: 0.4, density: 1100}}}}
bodies:
  part:
    mesh: {mesh}
    parameters: {{{parameters}}}
    element: {element}
    material: rubber
    spin: [10, 20, 0]
    meshing: {{time_limit: 10, memory_limit: 1e9}}
gravity: [0, 0, -9.81]
listeners: {{ear: {{type: mono, position: [0, 0, 2]}}}}
audio: {{rate: 8000, max_frequency: 4000}}
"""
VERSIONS = (2.2, 4.1)  # of .msh files


class Meshes:
    SHARE = 4

    def __init__(self, program, work):
        self.program = program
        folder = work / "parts"
        subprocess.run([sys.executable, scenes.HOME / "ctest/solids/mesher/make_parts.py", folder], check=True,
                       stdout=subprocess.DEVNULL)
        for kind in ("tetrahedra", "hexahedra"):
            for version in VERSIONS:
                for binary in (0, 1):
                    write_msh(folder / f"{kind}_{version}_{binary}.msh", kind == "hexahedra", version, binary)
        self.files = sorted(path for path in (*folder.iterdir(), *(scenes.HOME / "meshes").glob("*.geo"))
                            if path.stat().st_size < 1e6)

    def trial(self, random, folder):
        ending = random.choice(sorted({path.suffix for path in self.files}))
        original = random.choice([path for path in self.files if path.suffix == ending])
        mesh = folder / original.name
        if ending == ".msh" or random.random() < 0.3:
            mesh.write_bytes(mutations.damaged(random, original.read_bytes()))
        else:
            text = mutations.text(random, original.read_text(errors="replace"))
            mesh.write_bytes(text.encode(errors="replace"))
        parameters = {".msh": "", ".geo": ""}.get(ending, "size: 0.02")
        element = "hex" if "hexahedra" in mesh.name else random.choice(("tet4", "tet10", "tet10", "hex"))
        (folder / "deck.yaml").write_text(DECK.format(mesh=mesh.name, parameters=parameters, element=element))
        job = self.program.call(folder, random.choice(("check", "run")), "deck.yaml", "--output-folder", "results")
        if job.status in (FINISHED, RESUMABLE):
            for result in (folder / "results").glob("*.h5"):
                self.program.bits(result)
        return NAMES[job.status]


def write_msh(path, hexahedra, version, binary):
    gmsh.initialize(["-setnumber", "hexahedra", str(int(hexahedra)), "-setnumber", "size", "0.1"], False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.open(str(scenes.HOME / "meshes/square_plate.geo"))
        gmsh.model.mesh.generate(3)
        gmsh.option.setNumber("Mesh.MshFileVersion", version)
        gmsh.option.setNumber("Mesh.Binary", binary)
        gmsh.write(str(path))
    finally:
        gmsh.finalize()
