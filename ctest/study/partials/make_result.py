#!/usr/bin/python3
"""Writes a small result file like a run's: a struck plate of damped sines, with references. make_result.py FILE.h5"""

import sys

import h5py
import numpy as np

rate = 44100
references = 150.3 * np.array([1.0, 2.04, 3.01, 3.66, 4.58])
time = np.arange(int(0.8 * rate)) / rate
left = sum(0.3 ** (k / 2) * np.exp(-time * (8 + 4 * k)) * np.sin(2 * np.pi * f * 1.004 * time)
           for k, f in enumerate(references))
left += 1e-5 * np.random.default_rng(1).standard_normal(len(time))

with h5py.File(sys.argv[1], "w") as file:
    file.attrs["format"], file.attrs["name"] = "idiophone result", "plate"
    audio = file.create_dataset("audio/ears", data=np.stack([left, 0.8 * left], axis=1))
    audio.attrs["rate"] = rate
    audio.attrs["unit"] = "Pa"
    audio.attrs["columns"] = ["ears.left", "ears.right"]
    file["references/000"] = references
    file["references/000"].attrs["name"] = "thin plate"
