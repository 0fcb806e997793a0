"""Reading packings: one, or the steps of a run, whether in one file or in many."""

from __future__ import annotations

import math
import os
from collections.abc import Iterable, Sequence
from numbers import Real
from typing import TYPE_CHECKING, Literal, overload

import numpy as np
import pyvista as pv

from ..checks import index_in, integer_of, shown
from ..datasets import centres_of
from .errors import PackingFileError
from .packing_file import CompressedFile, has_one_step, open_file
from .series import entries_of
from .source import Request

if TYPE_CHECKING:
    from pathlib import Path

    from ..radii import RadiusLike
    from .series import Entry
    from .source import PackingSource

PathLike = str | os.PathLike[str] | Sequence[str | os.PathLike[str]]


def read(
    path: PathLike,
    *,
    step: int | None = None,
    time: float | None = None,
    radius: RadiusLike | None = None,
    columns: str | Sequence[str] | None = None,
    precision: Literal["single", "double"] = "double",
    progress: bool = False,
) -> pv.PolyData:
    """Read a sphere packing whatever its file is called.

    The format follows from the extension and, where that says nothing, from the content. Files may
    be compressed by gzip, bzip2, xz or zstandard.

    Parameters
    ----------
    path : str, os.PathLike or sequence of these
        File to read, or several that :func:`steps` takes.
    step : int, optional
        Index of the step to read, negative from the end; by default the first one.
    time : float, optional
        Instead of `step`, the time that the file gives the step to read, and no other.
    radius : str, float, array_like or mapping, optional
        Radii, for files without or instead of theirs: the name of a column or array, one number
        for all spheres, one per sphere, or one per type, by numbers of the array ``type`` or by
        texts of ``type_name``, ``element`` or another, such as ``{"C": 1.7, "H": 1.1}``.
    columns : str or sequence of str, optional
        Names of the columns of a table in text, separated by blanks, such as ``"id x y z r"``, or
        one by one.
    precision : {"double", "single"}, default: "double"
        Precision of the centres.
    progress : bool, default: False
        Show a progress bar on stderr if reading takes longer than half a second.

    Returns
    -------
    pyvista.PolyData
        Centres as points (n, 3), radii as active point array ``radius`` (n,), what else the file
        holds about each sphere as further point arrays. Units are those of the file. Field arrays,
        where the file has them: ``TimeValue``, and ``cell_vectors`` (3, 3), ``cell_origin``,
        ``cell_periodic`` of the simulation cell.

    Raises
    ------
    FileNotFoundError
        If there is no such file.
    ImportError
        If the library for a format is not installed.
    IsADirectoryError
        If `path` is a directory.
    OSError
        If it is a pipe or a device.
    PackingFileError
        If the file holds no packing. The message names file and line, what was found and what was
        expected.
    ValueError
        If there is no such step.

    Examples
    --------
    >>> import spherepacking
    >>> packing = spherepacking.read("packing.spheres")  # doctest: +SKIP
    >>> last = spherepacking.read("run.dump", step=-1)  # doctest: +SKIP
    >>> atoms = spherepacking.read("run.xyz", radius={"C": 1.7, "H": 1.1})  # doctest: +SKIP
    """
    found = steps(path, radius=radius, columns=columns, precision=precision, progress=progress)
    try:
        return found[found.index_of(step, time)]
    finally:
        found.close()


def steps(
    path: PathLike,
    *,
    radius: RadiusLike | None = None,
    columns: str | Sequence[str] | None = None,
    precision: Literal["single", "double"] = "double",
    progress: bool = False,
) -> PackingSteps:
    """Find the steps of a run, to read one after the other.

    Parameters
    ----------
    path : str, os.PathLike or sequence of these
        A file with any number of steps; a ``.pvd`` or ``.series`` of ParaView; a list of files; or
        a pattern, ``"dump.*.lammpstrj"`` or ``"run_%04d.vtu"``, whose files are put in the order of
        the numbers in their names.
    radius, columns, precision, progress
        As in :func:`read`.

    Returns
    -------
    PackingSteps
        A sequence of packings, each of which is read when it is asked for.

    Raises
    ------
    FileNotFoundError, ImportError, IsADirectoryError, OSError, PackingFileError
        As :func:`read`.

    Examples
    --------
    >>> import spherepacking
    >>> for packing in spherepacking.steps("run.dump")[::10]:  # doctest: +SKIP
    ...     print(packing.packing.volume)
    """
    if precision not in ("single", "double"):
        raise ValueError(f"precision: found {shown(precision)}, expected 'single' or 'double'")
    request = Request(radius, _columns_of(columns), precision, progress)
    entries = entries_of(path)
    if len(entries) == 1 and entries[0].time is None and len(entries[0].files) == 1:
        source: PackingSource = open_file(entries[0].files[0], request)
        count = max(1, len(source.times))
    else:
        source = series = _Series(entries, request)
        count = series.count
    name = str(path) if isinstance(path, (str, os.PathLike)) else str(entries[0].files[0])
    return PackingSteps(source, name, range(count))


def _columns_of(columns: str | Sequence[str] | None) -> str | None:
    """Names of columns, separated by blanks."""
    if columns is None or isinstance(columns, str):
        return columns
    names = list(columns) if isinstance(columns, Iterable) else None
    if names is None or not all(isinstance(name, str) for name in names):
        raise TypeError(
            f"columns: found {shown(columns)}, "
            "expected names separated by blanks or a list of names"
        )
    wrong = [name for name in names if len(name.split()) != 1]
    if wrong or not names:
        found = shown(wrong[0]) if wrong else "no name"
        raise ValueError(f"columns: found {found}, expected names without blanks")
    return " ".join(names)


class PackingSteps(Sequence[pv.PolyData]):
    """The packings of a run, read when they are asked for; what :func:`steps` returns.

    It has a length, can be iterated over, and indexed: ``steps[-1]`` is the last packing, and
    ``steps[::10]`` every tenth as a sequence that has not been read either.

    Parameters
    ----------
    source : PackingSource
        Where they come from.
    name : str
        What the user calls it.
    indices : range
        Which of its steps these are.
    """

    def __init__(self, source: PackingSource, name: str, indices: range) -> None:
        self._source = source
        self._name = name
        self._indices = indices

    @property
    def times(self) -> list[float]:
        """Times of the steps as the files give them, or else the numbers of the time steps.

        These may repeat or run backwards where a run was restarted, and are NaN for steps without.
        Empty if no step has one.
        """
        times = self._source.times
        own = [times[i] for i in self._indices] if times else []
        return [] if all(map(math.isnan, own)) else own

    def __len__(self) -> int:
        return len(self._indices)

    @overload
    def __getitem__(self, index: int) -> pv.PolyData: ...
    @overload
    def __getitem__(self, index: slice) -> PackingSteps: ...
    def __getitem__(self, index: int | slice) -> pv.PolyData | PackingSteps:
        if isinstance(index, slice):
            return PackingSteps(self._source, self._name, self._indices[index])
        return self._source.read(index_in(self._indices, "steps", index))

    def __repr__(self) -> str:
        return f"<{len(self)} steps of {self._name}>"

    def close(self) -> None:
        """Remove temporary files; they go away with the last sequence of these steps, too."""
        if isinstance(self._source, (CompressedFile, _Series)):
            self._source.close()

    def index_of(self, step: int | None = None, time: float | None = None) -> int:
        """Find the index of a step.

        Parameters
        ----------
        step : int, optional
            Its index, negative from the end.
        time : float, optional
            Its time, instead; without both it is the first.

        Returns
        -------
        int
            From 0 on.

        Raises
        ------
        ValueError
            If there is no such step, or several are of that time.
        """
        if step is not None and time is not None:
            raise ValueError("time: found step and time, expected one of them")
        if time is not None:
            return self._at_time(time)
        count = len(self)
        if step is None:
            return 0
        step = integer_of("step", step)
        if not -count <= step < count:
            there = f"{count} steps" if count > 1 else "one step"
            raise ValueError(
                f"step: found {step}, expected {-count} to {count - 1}: {self._name} has {there}"
            )
        return range(count)[step]

    def _at_time(self, time: float) -> int:
        if not isinstance(time, Real) or isinstance(time, bool) or math.isnan(time):
            raise TypeError(f"time: found {shown(time)}, expected a number")
        times = self.times
        known = [t for t in times if not math.isnan(t)]
        # Times in texts are rounded.
        found = [i for i, t in enumerate(times) if t == time] or [
            i for i, t in enumerate(times) if math.isclose(t, time, rel_tol=1e-9)
        ]
        if len(found) == 1:
            return found[0]
        if found:
            raise ValueError(
                f"time: found {time:g}, expected one that {self._name} has once: it is that of the "
                f"steps {', '.join(map(str, found[:10]))}"
            )
        if not times:
            raise ValueError(f"time: found {time:g}, expected step: {self._name} tells no times")
        if len(known) > 10:
            near = known[int(np.argmin(np.abs(np.array(known) - time)))]
            there = f"one of {len(known)} from {min(known):g} to {max(known):g}, such as {near:g}"
        else:
            there = f"one of {', '.join(f'{t:g}' for t in known)}"
        raise ValueError(f"time: found {shown(time)}, expected {there}, as {self._name} has")


class _Series:
    """Steps in several files. The one that was read last stays open."""

    def __init__(self, entries: list[Entry], request: Request) -> None:
        self._entries = entries
        self._request = request
        self._opened: tuple[Path, PackingSource] | None = None
        # The entry of each step, the step within its files, and its time.
        self._steps: list[tuple[int, int]] = []
        times: list[float] = []
        for i, entry in enumerate(entries):
            own = self._times_in(entry)
            self._steps += [(i, k) for k in range(max(1, len(own)))]
            times += own or [math.nan if entry.time is None else entry.time]
        if all(map(math.isnan, times)) and len(self._steps) == len(entries):
            numbers = [entry.number for entry in entries]
            times = [math.nan if number is None else float(number) for number in numbers]
        self.count = len(self._steps)
        self.times = times

    def _times_in(self, entry: Entry) -> list[float]:
        """Times that the files of an entry know; empty where the series says the time."""
        if all(has_one_step(file) for file in entry.files) or not entry.is_there:
            return []
        times = [self._open(file).times for file in entry.files]
        for file, found in zip(entry.files, times, strict=True):
            if (entry.time is not None or len(times) > 1) and len(found) > 1:
                raise PackingFileError(
                    f"{file}: found {len(found)} steps in a file of one point of time, expected one"
                )
        return [] if entry.time is not None or len(times) > 1 else list(times[0])

    def _open(self, file: Path) -> PackingSource:
        if self._opened is None or self._opened[0] != file:
            self.close()
            self._opened = file, open_file(file, self._request)
        return self._opened[1]

    def close(self) -> None:
        """Close the file that is open."""
        opened, self._opened = self._opened, None
        if opened is not None and isinstance(opened[1], CompressedFile):
            opened[1].close()

    def read(self, index: int) -> pv.PolyData:
        """Read the packing of a step."""
        at, within = self._steps[index]
        self._entries[at].check()
        parts = [self._open(file).read(within) for file in self._entries[at].files]
        packing = parts[0] if len(parts) == 1 else centres_of(pv.MultiBlock(parts))
        if packing.n_points:
            packing.set_active_scalars("radius", preference="point")
        known = not math.isnan(self.times[index])
        if known and "TimeValue" not in packing.field_data:
            packing.field_data["TimeValue"] = [self.times[index]]
        return packing
