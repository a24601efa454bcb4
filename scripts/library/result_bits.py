#!/usr/bin/python3
"""result_bits.py FILE: digest of the numbers of a result or recording, and whether all are finite, as JSON."""

import hashlib
import json
import sys

import h5py
import numpy


def series(path):
    """Bytes of the sound, the motion, the mesh and the frames, by path; without the texts, which may differ."""
    return {name: values.tobytes() for name, values in arrays(path).items()}


def arrays(path):
    """Datasets of numbers by path."""
    found = {}
    with h5py.File(path) as file:
        file.visititems(lambda name, item: found.update({name: item[()]}) if isinstance(item, h5py.Dataset) else None)
    return {name: values for name, values in found.items() if values.dtype.kind in "fiu"}


def level_of_difference(base, other):
    """How far two signals are from each other: "-120 dB" of the base's energy, "same samples", or "other sizes"."""
    if base.shape != other.shape:
        return "other sizes"
    base, other = base.astype(float), other.astype(float)
    energy, difference = numpy.square(base).sum(), numpy.square(other - base).sum()
    if difference == 0:
        return "same samples"
    return f"{10 * numpy.log10(difference / energy):.0f} dB" if energy > 0 else "silent before"


def digest(path):
    """SHA-256 of the series with their paths."""
    total = hashlib.sha256()
    for name, values in sorted(series(path).items()):
        total.update(f"{name} {len(values)}\n".encode())
        total.update(values)
    return total.hexdigest()


def main():
    path = sys.argv[1]
    finite = all(numpy.isfinite(values).all() for values in arrays(path).values())
    print(json.dumps({"digest": digest(path), "finite": bool(finite)}))


if __name__ == "__main__":
    main()
