"""Reading packing files through ``pyvista.read``."""

from __future__ import annotations

import math
from contextlib import nullcontext
from numbers import Real
from typing import TYPE_CHECKING, NamedTuple

import pyvista as pv

from ..checks import index_in, shown, some_of
from ..printable import printable
from ..vtk_tools import ErrorLog, errors_raised, progress_bar
from .errors import PackingFileError

if TYPE_CHECKING:
    from typing import Literal

    from ..backend import vtkSpherePackingReader


class _Times(NamedTuple):
    """Times of the steps of a file: when VTK found them, and the steps of each time."""

    made_at: int
    values: list[float]
    steps: dict[float, list[int]]


# PyVista 0.48, which some builds run on, has no generic one.
class SpherePackingReader(pv.BaseReader, pv.TimeReader):  # type: ignore[type-arg]
    """Reader of sphere packings.

    ``pyvista.read`` and ``pyvista.get_reader`` use it for the extensions that PyVista does not
    read itself. The steps of a LAMMPS or LIGGGHTS dump are its time points; other files have none.

    Parameters
    ----------
    path : str or pathlib.Path
        File to read.

    Raises
    ------
    FileNotFoundError
        If there is no such file.
    IsADirectoryError
        If `path` is a directory.
    ImportError
        If PyVista runs on another VTK than the one that this package was built with.

    Examples
    --------
    >>> import pyvista as pv
    >>> reader = pv.get_reader("packing.spheres")  # doctest: +SKIP
    >>> reader.precision = "single"  # doctest: +SKIP
    >>> packing = reader.read()  # doctest: +SKIP
    """

    @staticmethod
    def _class_reader() -> vtkSpherePackingReader:
        # Called by BaseReader to make its VTK reader; imported here, see backend.
        from ..backend import vtkSpherePackingReader

        return vtkSpherePackingReader()

    def _set_defaults(self) -> None:
        self._index = 0
        self._times: _Times | None = None
        self._found_at = -1

    def _set_directory(self, directory: str) -> None:
        raise IsADirectoryError(
            printable(f"{directory}: found a directory, expected a file with a packing")
        )

    def _update_information(self) -> None:
        # Upstream: PyVista 0.49 calls this when a reader is made, and passes on no error of VTK.
        # Time steps are looked for when they are asked for.
        pass

    @property
    def precision(self) -> Literal["single", "double"]:
        """Return or set the precision of the centres, ``"double"`` by default."""
        single = self.reader.GetOutputPointsPrecision() == self.reader.SINGLE_PRECISION
        return "single" if single else "double"

    @precision.setter
    def precision(self, precision: Literal["single", "double"]) -> None:
        if precision not in ("single", "double"):
            raise ValueError(f"precision: found {shown(precision)}, expected 'single' or 'double'")
        single = precision == "single"
        self.reader.SetOutputPointsPrecision(
            self.reader.SINGLE_PRECISION if single else self.reader.DOUBLE_PRECISION
        )

    @property
    def time_values(self) -> list[float]:
        """Return the times of the steps; empty for files without steps.

        They are those of the file, as in `spherepacking.steps` and in ``TimeValue`` of what is
        read, even where they repeat or run backwards after a restart, and NaN for a step without
        one; 0, 1, 2 and so on where no step has one.
        """
        return list(self._known_times().values)

    def _known_times(self) -> _Times:
        """Times of the steps, made anew only when the reader has found others."""
        self._find_steps()
        times = self.reader.GetStepTimes()
        if self._times is None or self._times.made_at != times.GetMTime():
            own: list[float] = pv.convert_array(times).tolist()
            if all(map(math.isnan, own)):
                own = [float(i) for i in range(len(own))]
            steps: dict[float, list[int]] = {}
            for i, value in enumerate(own):
                if not math.isnan(value):
                    steps.setdefault(value, []).append(i)
            self._times = _Times(times.GetMTime(), own, steps)
        return self._times

    def _find_steps(self) -> int:
        """Find the steps, and return how many there are."""
        # What is wrong with the file is raised when it is read.
        # Upstream: VTK 9.7's Python layer remembers every observer that there ever was, and each
        # further one takes longer. So there are none where nothing is to be done.
        if self._found_at != self.reader.GetMTime():
            with ErrorLog(self.reader):
                self.reader.UpdateInformation()
            self._found_at = self.reader.GetMTime()
        count: int = self.reader.GetStepTimes().GetNumberOfTuples()
        return count

    @property
    def number_time_points(self) -> int:
        """Return the number of time steps."""
        return self._find_steps()

    def time_point_value(self, time_point: int) -> float:
        """Return the time step at an index, or raise an IndexError."""
        values = self._known_times().values
        return values[index_in(range(len(values)), "time_point", time_point)]

    @property
    def active_time_value(self) -> float | None:  # type: ignore[override]  # other files have none
        """Return the time step that is read; the first by default, None without any."""
        values = self._known_times().values
        return values[self._index] if self._index < len(values) else None

    def set_active_time_value(self, time_value: float) -> None:
        """Choose the time step to read, one of `time_values`, or raise a ValueError.

        A time that several steps have chooses none: use :meth:`set_active_time_point`.
        """
        times = self._known_times()
        found: list[int] = []
        if isinstance(time_value, Real):
            found = times.steps.get(time_value, found)
        if not found:
            raise ValueError(
                f"time_value: found {shown(time_value)}, expected one of [{some_of(times.values)}]"
            )
        if len(found) > 1:
            raise ValueError(
                f"time_value: found {time_value}, which is that of the time points "
                f"{', '.join(map(str, found[:10]))}, expected set_active_time_point() with one"
            )
        self._index = found[0]

    def set_active_time_point(self, time_point: int) -> None:
        """Choose the time step to read by its index, or raise an IndexError."""
        self._index = index_in(range(self.number_time_points), "time_point", time_point)

    def read(self, *, validate: bool | None = None) -> pv.PolyData:
        """Read the file.

        Parameters
        ----------
        validate : bool, optional
            Passed to :func:`pyvista.wrap`.

        Returns
        -------
        pyvista.PolyData
            What :func:`spherepacking.read` returns, and it raises the same PackingFileError.
        """
        # Upstream: pyvista.read() of 0.49 observes the reader, too, and logs what is raised here.
        self.reader.RemoveObservers("ErrorEvent")
        bar = progress_bar(self.reader, self._progress_msg or "")
        count = self._find_steps()
        with (
            errors_raised(self.reader, PackingFileError),
            bar if self._progress_bar else nullcontext(),
        ):
            if count:
                # VTK calls the steps by their times where these increase, or else by 0, 1, 2.
                key = self.reader.GetExecutive().TIME_STEPS()
                information = self.reader.GetOutputInformation(0)
                self.reader.UpdateTimeStep(information.Get(key, range(count)[self._index]))
            else:
                self.reader.Update()
        return pv.wrap(self.reader.GetOutput(), validate=validate)


def _read_function(path: str) -> pv.PolyData:
    """Read `path`."""
    return SpherePackingReader(path).read()


# Upstream: PyVista before 0.49 takes functions only, no classes, from entry points:
# https://github.com/pyvista/pyvista/pull/8950.
entry_point = SpherePackingReader if pv.version_info >= (0, 49) else _read_function
