"""Directivities as SOFA files (AES69-2022, convention FreeFieldDirectivityTF 1.1)."""
from __future__ import annotations

import datetime
from pathlib import Path

import h5py
import numpy as np
from numpy.typing import ArrayLike

from . import program
from .sound_map import SoundMap

BLOW = "per newton of a sinusoidal force at ({:g}, {:g}, {:g}) m along ({:g}, {:g}, {:g})"
MODES = "of each mode at its own frequency, for a modal velocity of 1 m sqrt(kg)/s (unit modal mass)"


def write_sofa(sound_map: SoundMap, path: str | Path, frequencies: ArrayLike | None = None, at: ArrayLike | None = None,
               direction: ArrayLike | None = None) -> None:
    """Writes the far field of a body, in all directions of its sound map.

    Without `frequencies`: of each mode, N are their frequencies. With them (Hz): of a sinusoidal force at the vertex nearest to
    `at` (m) along `direction`, Pa/N. Positions are relative to the map's centre; the axes are those of the deck.
    Raises ValueError if only some of the three are given.
    """
    given = [value is not None for value in (frequencies, at, direction)]
    if any(given) and not all(given):
        raise ValueError("frequencies, at and direction belong together: give all of them, or none for the modes")
    if frequencies is None or at is None or direction is None:
        order = np.argsort(sound_map.frequency, kind="stable")
        abscissa, pressure, meaning = sound_map.frequency[order], sound_map.far_field[order], MODES
    else:
        abscissa = np.asarray(frequencies, float)
        pressure = sound_map.far_field_response(abscissa, at, direction)
        meaning = BLOW.format(*np.asarray(at, float), *np.asarray(direction, float))
    with h5py.File(path, "w", track_order=True) as file:
        _write_attributes(file, sound_map, f"Pressure at {sound_map.distance:g} m, Pa, {meaning}")
        _write_variables(file, sound_map, abscissa, pressure)


def _write_attributes(file: h5py.File, sound_map: SoundMap, description: str) -> None:
    now = datetime.datetime.now().strftime("%Y-%m-%d %H:%M:%S")
    version = program.call("--version").split()[-1]
    texts = {
        "Conventions": "SOFA", "Version": "2.1", "SOFAConventions": "FreeFieldDirectivityTF", "SOFAConventionsVersion": "1.1",
        "DataType": "TF", "RoomType": "free field", "Title": f"{sound_map.body} of {sound_map.material}", "DateCreated": now,
        "DateModified": now, "APIName": "h5py", "APIVersion": h5py.__version__, "AuthorContact": "", "Organization": "",
        "License": "No license provided, ask the author for permission", "ApplicationName": "Idiophone",
        "ApplicationVersion": version, "DatabaseName": sound_map.path.name, "Description": description,
        "SourceType": f"{sound_map.body}, a solid body of {sound_map.material}", "SourceManufacturer": "computed by Idiophone"}
    for name, value in texts.items():
        file.attrs[name] = np.bytes_(value.encode())


def _write_variables(file: h5py.File, sound_map: SoundMap, frequencies: np.ndarray, pressure: np.ndarray) -> None:
    """pressure: [frequencies x directions]"""
    sizes = {"I": 1, "C": 3, "R": pressure.shape[1], "E": 1, "M": 1}
    for name, size in sizes.items():
        file.create_dataset(name, (size,), "f4").make_scale(f"This is a netCDF dimension but not a netCDF variable.{size:10d}")
    file["N"] = frequencies
    file["N"].make_scale("N")
    _describe(file["N"], LongName="frequency", Units="hertz")

    def put(name: str, values: np.ndarray, dimensions: str, **texts: str) -> None:
        file[name] = np.asarray(values, float)
        for axis, dimension in enumerate(dimensions):
            file[name].dims[axis].attach_scale(file[dimension])
        _describe(file[name], **texts)

    cartesian = {"Type": "cartesian", "Units": "metre"}
    origin, ahead, above = np.zeros((1, 3)), np.array([[1, 0, 0]]), np.array([[0, 0, 1]])
    x, y, z = sound_map.directions.T
    azimuth, elevation = np.degrees(np.arctan2(y, x)) % 360, np.degrees(np.arcsin(np.clip(z, -1, 1)))
    places = np.transpose([azimuth, elevation, np.full_like(x, sound_map.distance)])
    put("ListenerPosition", origin, "IC", **cartesian)
    put("ListenerView", ahead, "IC", **cartesian)
    put("ListenerUp", above, "IC")
    put("ReceiverPosition", places[:, :, np.newaxis], "RCI", Type="spherical", Units="degree, degree, metre")
    put("SourcePosition", origin, "IC", **cartesian, Reference="The centre of the sound map")
    put("SourceView", ahead, "IC", **cartesian, Reference="The x axis of the deck")
    put("SourceUp", above, "IC", Reference="The z axis of the deck")
    put("EmitterPosition", origin[:, :, np.newaxis], "ECI", **cartesian)
    put("Data.Real", pressure.real.T[np.newaxis], "MRN")
    put("Data.Imag", pressure.imag.T[np.newaxis], "MRN")


def _describe(data: h5py.Dataset, **texts: str) -> None:
    for name, value in texts.items():
        data.attrs[name] = np.bytes_(value.encode())
