"""Files that the readers accept, with which the fuzzer begins."""
import base64
import json
import pathlib
import shutil
import struct
import subprocess
import wave

import h5py
import netCDF4
import numpy

HOME = pathlib.Path(__file__).resolve().parents[2]
SHIPPED = {
    "deck": ["inputs/**/*.yaml", "ctest/app/decks/*.yaml"], "table": ["ctest/app/decks/*.csv", "inputs/**/*.csv"],
    "score": ["ctest/app/decks/score.yaml"], "ideal": ["inputs/ideal/*.yaml"], "sonic_scene": ["inputs/timbre/*.yaml"],
    "timbre_tree": ["inputs/**/*.tt"]}
SMALL = {  # for readers of which no file is shipped
    "event": b"{at: [0, 0, 1], direction: [0, 0, 1], mass: 0.1, hardness: 1e8, speed: 1, body: plate}",
    "override": b"loads.tap.force=[0, 0, -3]",
    "lines": b"mass: 0.1\nuncertainty: 5\nlines: [202, {frequency: 405, uncertainty: 6, decay_time: 0.6}, 584]\n",
    "cuts": b"side: -z\ncuts: [{tool: \"router:0.003\", place: 0.0135, depth: 0.0004}]\n"
            b"taps: [{cuts: 1, lines: [233.3, 918], uncertainties: [1, 2], at: [0.165, 0, 0.01]}]\n",
    "velocities": b"frequency,x,y,z,vx,vx_imaginary,vy,vy_imaginary,vz,vz_imaginary\n800,0,0,1,0,0,0.6,-0.8,1e-3,0\n",
    "obj": b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1/1 2//2 -1/1/1\nf 1 4 3\nf 2 3 4\n",
    "messages": b"\x90\x3c\x40\x00\xe0\x00\x40\x00",
    "midi": b"MThd\x00\x00\x00\x06\x00\x00\x00\x01\x00\x60MTrk\x00\x00\x00\x14\x00\xff\x51\x03\x0f\x42\x40\x00\x90\x3c\x40"
            b"\x60\x80\x3c\x00\x00\xff\x2f\x00",
    "osc": b"/tune\x00\x00\x00,sff\x00\x00\x00\x00plate\x00\x00\x00\x3f\x80\x00\x00\x3f\x80\x00\x00"}


def glb(document, data=b""):
    """A binary glTF file: its JSON, and the bytes of its buffer."""
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text
    if data:
        chunks += struct.pack("<I4s", len(data), b"BIN\0") + data
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def put_gltf(folder):
    """A tetrahedron with a material and a mass, as text and as binary file."""
    corners = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], "<f4").tobytes()
    faces = numpy.array([0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3], "<u2").tobytes()
    audio = {"modalModels": [{"material": 0, "massProperties": {"mass": 3}}],
             "acousticMaterials": [{"name": "steel", "density": 7850, "youngsModulus": 2e11, "poissonRatio": 0.3}]}
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"name": "cup", "children": [1]}, {"mesh": 0, "scale": [1, 2, 1], "extensions": {
            "KHR_physics_rigid_bodies": {"motion": {"mass": 2.5}}, "KHR_audio_rigid_bodies": {"modalModel": 0}}}],
        "meshes": [{"name": "wall", "primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
        "materials": [{"name": "steel"}], "extensions": {"KHR_audio_rigid_bodies": audio},
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1]},
                      {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": len(corners)},
                        {"buffer": 0, "byteOffset": len(corners), "byteLength": len(faces)}],
        "buffers": [{"byteLength": len(corners + faces)}]}
    (folder / "binary").write_bytes(glb(document, corners + faces))
    document["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64.b64encode(corners + faces).decode()
    (folder / "text").write_text(json.dumps(document))


def put_head(folder):
    """A head with six directions and eight taps for each ear."""
    with netCDF4.Dataset(folder / "head.sofa", "w") as file:
        needed = ("APIName", "APIVersion", "AuthorContact", "DatabaseName", "DateCreated", "DateModified", "License", "ListenerShortName",
                  "Organization", "RoomType", "Title")
        file.setncatts({"Conventions": "SOFA", "Version": "1.0", "SOFAConventions": "SimpleFreeFieldHRIR",
                        "SOFAConventionsVersion": "1.0", "DataType": "FIR"} | dict.fromkeys(needed, "-"))
        for name, size in {"I": 1, "C": 3, "R": 2, "E": 1, "N": 8, "M": 6}.items():
            file.createDimension(name, size)

        def add(name, dimensions, values, **attributes):
            variable = file.createVariable(name, "f8", list(dimensions))
            variable.setncatts(attributes)
            variable[:] = values

        metres = {"Type": "cartesian", "Units": "metre"}
        add("ListenerPosition", "IC", 0, **metres)
        add("ListenerView", "IC", [[1, 0, 0]], **metres)
        add("ListenerUp", "IC", [[0, 0, 1]], **metres)
        add("ReceiverPosition", "RCI", numpy.array([[0, 0.09, 0], [0, -0.09, 0]])[:, :, None], **metres)
        add("EmitterPosition", "EC", 0, **metres)
        add("SourcePosition", "MC", numpy.vstack([numpy.eye(3), -numpy.eye(3)]), **metres)
        add("Data.SamplingRate", "I", 44100, Units="hertz")
        add("Data.Delay", "IR", 0)
        add("Data.IR", "MRN", numpy.eye(8)[0])


def put_tone(folder):
    with wave.open(str(folder / "tone.wav"), "wb") as file:
        file.setparams((1, 2, 8000, 0, "NONE", ""))
        file.writeframes(b"".join((i * 997 % 20000 - 10000).to_bytes(2, "little", signed=True) for i in range(2000)))


LAST_MADE = "velocities.h5"  # of what make_stored() makes


def make_stored(made, program, environment):
    """Makes small HDF5 files of each kind, a voice and a proxy."""
    deck = HOME / "ctest/app/decks/simple.yaml"
    recorded = ["--set", "output.surface_motion=true", "--set", "output.checkpoint.every_minutes=1e-9",
                "--set", "time.duration=0.004"]

    def call(*arguments):
        subprocess.run([program, *arguments], env=environment, check=True, stdout=subprocess.DEVNULL)

    for command, *options in ["run", *recorded], ["map", "--modes", "3"], ["radiate", "--modes", "1"]:
        call(command, deck, "--output-folder", made, *options)
    call("mesh", deck, "-o", made / "small.mesh.h5")
    call("export", next(made.glob("*.map.h5")), "--voice", made / "small.voice")
    call("export", deck, "--proxy", made / "small.proxy")
    with h5py.File(made / LAST_MADE, "w") as file:
        file["frequency"], file["position"], file["velocity"] = [800.0], numpy.eye(3), numpy.ones((1, 3, 3, 2))


def put_stored(folder, extension, made, largest, program, environment):
    """Copies files of one extension that the program makes. They are made once, in the folder `made`."""
    if not (made / LAST_MADE).exists():
        shutil.rmtree(made, ignore_errors=True)
        make_stored(made, program, environment)
    for path in made.rglob(f"*{extension}"):
        if path.stat().st_size < largest:
            shutil.copy(path, folder)


MADE = {"gltf": put_gltf, "model": put_gltf, "head": put_head, "sound": put_tone}


def put(reader, folder):
    """Puts the files that the reader accepts into a folder, but for those that the program makes."""
    for pattern in SHIPPED.get(reader, ()):
        for path in HOME.glob(pattern):
            shutil.copy(path, folder)
    if reader in SMALL:
        (folder / "small").write_bytes(SMALL[reader])
    if reader in MADE:
        MADE[reader](folder)
