"""Results: what a run, `listen` or `modes` wrote (docs/use/result_file.md)."""
from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import h5py
import numpy as np

from . import program
from .errors import IdiophoneError
from .facts import Facts
from .files import text
from .modes import FrequencyBounds, Modes
from .series import Series

if TYPE_CHECKING:
    import meshio
    from matplotlib.axes import Axes

CELLS = {4: "tetra", 8: "hexahedron", 10: "tetra10"}


class _Named(Mapping[str, Any]):
    """Series of a result by name; each is read when it is asked for."""

    def __init__(self, result: Result, paths: dict[str, str]):
        self._result, self._paths = result, paths

    def __getitem__(self, name: str) -> Series:
        if name not in self._paths:
            raise KeyError(f"{self._result.path} has no {name}; it has: {', '.join(self._paths) or 'none'}")
        return self._result.series(self._paths[name])

    def __iter__(self) -> Iterator[str]:
        return iter(self._paths)

    def __len__(self) -> int:
        return len(self._paths)

    def __repr__(self) -> str:
        return f"<{', '.join(self)}>"


class Result:
    """A result file. It is open only while something is read, so a run may go on writing it.

    Raises IdiophoneError if the file can't be read or is of another kind.
    """

    def __init__(self, path: str | Path):
        self.path = Path(path)
        with self.open() as file:
            if (kind := text(file.attrs.get("format", ""))) != "idiophone result":
                raise IdiophoneError(f"{path} is not a result of idiophone" + (f", but an {kind}" if kind else ""))
            if "name" not in file.attrs:
                raise IdiophoneError(f"{path} is incomplete: it has no name")
            self.name = text(file.attrs["name"])
            self._series: list[str] = []
            file.visititems(lambda name, item: self._series.append(f"/{name}") if "columns" in item.attrs else None)

    def open(self) -> h5py.File:
        """The HDF5 file, for all that this class does not name. Raises IdiophoneError."""
        if not self.path.is_file():
            raise IdiophoneError(f"there is no file {self.path}")
        try:
            return h5py.File(self.path)
        except OSError as error:
            raise IdiophoneError(f"{self.path} can't be read: {error}") from None

    @property
    def audio(self) -> Mapping[str, Series]:
        """The sounds by the names of the listeners."""
        return _Named(self, {path.removeprefix("/audio/"): path for path in self._series if path.startswith("/audio/")})

    @property
    def channels(self) -> Mapping[str, Series]:
        """All other series by their paths, e.g. "contacts/hit/force" or "motion/plate/velocity"."""
        return _Named(self, {path[1:]: path for path in self._series if not path.startswith("/audio/")})

    @property
    def energy(self) -> Series:
        """The energies of all bodies, J: kinetic, elastic, contact, gravitational and the work of loads."""
        return self.channels["energy"]

    def series(self, path: str) -> Series:
        """A series by its path in the file. Raises KeyError."""
        with self.open() as file:
            data = file[path]
            facts = data.attrs
            return Series(path, data[()].reshape(len(data), -1), float(facts["rate"]), text(facts["unit"]),
                          [text(column) for column in facts["columns"]], text(facts.get("description", "")),
                          facts.get("positions"))

    @property
    def deck(self) -> str:
        """The text of the deck that was run."""
        with self.open() as file:
            return text(file["deck"][0])

    @property
    def references(self) -> dict[str, np.ndarray]:
        """Expected frequencies, Hz, ascending, by the names of their sources."""
        with self.open() as file:
            return {text(data.attrs.get("name", name)): np.sort(data[()]) for name, data in file.get("references", {}).items()}

    @property
    def facts(self) -> Facts:
        """What the run was: the group /run of docs/use/result_file.md."""
        with self.open() as file:
            return _facts(file["run"]) if "run" in file else Facts()

    @property
    def bodies(self) -> list[str]:
        """The names of the bodies whose mesh it has."""
        with self.open() as file:
            return list(file.get("mesh", {}))

    @property
    def modes(self) -> dict[str, Modes]:
        """Body -> its modes, of a file of `idiophone modes`. Raises IdiophoneError if it has none."""
        with self.open() as file:
            if "modes" not in file:
                raise IdiophoneError(f"{self.path} has no modes; `idiophone modes` finds them")
            return {body: Modes(group["frequency"][()], group["damping_ratio"][()], group["decay_time"][()], group["shape"][()],
                                self.nodes(body), self.elements(body), group["mesh_error"][()] if "mesh_error" in group else None,
                                int(group["frequency"].attrs["rigid_motions"]),
                                kinds=[text(kind) for kind in group["kind"]] if "kind" in group else [],
                                bounds=_bounds(group["bounds"]) if "bounds" in group else None,
                                kinetic_share=group["kinetic_share"][()] if "kinetic_share" in group else None)
                    for body, group in file["modes"].items()}

    @property
    def frame_times(self) -> np.ndarray:
        """[frames], s; empty without frames."""
        with self.open() as file:
            return file["frames/time"][()] if "frames" in file else np.empty(0)

    def displacement(self, body: str, frame: int | None = None) -> np.ndarray:
        """[nodes x 3], m, from the undeformed body in a frame; [frames x nodes x 3] in all of them by default. Raises KeyError."""
        with self.open() as file:
            data = file["frames"][body]["displacement"]
            return data[()].astype(float) if frame is None else data[frame].astype(float)

    def nodes(self, body: str) -> np.ndarray:
        """[nodes x 3], m, of the undeformed body. Raises KeyError."""
        with self.open() as file:
            return file["mesh"][body]["nodes"][()]

    def elements(self, body: str) -> np.ndarray:
        """[cells x 4, 8 or 10]: node numbers in VTK's order. Raises KeyError."""
        with self.open() as file:
            return file["mesh"][body]["elements"][()]

    def mesh(self, body: str, frame: int | None = None) -> meshio.Mesh:
        """A body in a frame, undeformed by default, as a mesh of meshio. Raises KeyError."""
        import meshio
        nodes, elements = self.nodes(body), self.elements(body)
        moved = None if frame is None else self.displacement(body, frame)
        return meshio.Mesh(nodes if moved is None else nodes + moved, [(CELLS[elements.shape[1]], elements)],
                           point_data={} if moved is None else {"displacement": moved})

    def partials(self, **options: object) -> Facts:
        """What `idiophone analyze` finds (docs/use/analyze.md): `channels`, each with its `partials`.

        options: those of the command, e.g. highest=5000. Raises ProgramError.
        """
        return program.answer("analyze", self.path, *program.options(**options))

    def plot_spectrum(self, listener: str | None = None, column: str | int = 0, axes: Axes | None = None) -> Axes:
        """Draws the spectrum of a sound (default: the first column of the first listener) and the expected frequencies."""
        from . import plots
        return plots.plot_spectrum(self.sound(listener), column, self.references, axes)

    def plot_spectrogram(self, listener: str | None = None, column: str | int = 0, window: float = 0.05,
                         axes: Axes | None = None) -> Axes:
        """Draws the spectrogram of a sound under windows of so many seconds; darker is louder."""
        from . import plots
        return plots.plot_spectrogram(self.sound(listener), column, window, axes)

    def sound(self, listener: str | None = None) -> Series:
        """What a listener (default: the first) heard. Raises IdiophoneError if there is none."""
        if not self.audio:
            raise IdiophoneError(f"{self.path} has no audio")
        if listener and listener not in self.audio:
            raise IdiophoneError(f"{self.path} has no listener {listener}; it has: {', '.join(self.audio)}")
        return self.audio[listener or next(iter(self.audio))]

    def __repr__(self) -> str:
        return f"<Result {self.path}: {self.name}, sounds {self.audio!r}, channels {self.channels!r}>"

    def _repr_html_(self) -> str:
        """In Jupyter: a player for each listener."""
        return f"<h4>{self.name}</h4>" + "".join(sound._repr_html_() for sound in self.audio.values())


def _bounds(group: h5py.Group) -> FrequencyBounds:
    return FrequencyBounds(group["lower"][()], group["upper"][()], int(group.attrs["modes_below"]), float(group.attrs["separation"]))


def _facts(group: h5py.Group) -> Facts:
    """Attributes and groups of a group; numbers of jobs become a list."""
    found = Facts({name: text(value) if isinstance(value, (bytes, str)) else value.item() for name, value in group.attrs.items()})
    for name, item in group.items():
        if isinstance(item, h5py.Group):
            below = _facts(item)
            found[name] = list(below.values()) if name == "jobs" else below
    return found
