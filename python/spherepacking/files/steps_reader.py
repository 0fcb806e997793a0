"""Formats that Python libraries read, through ``pyvista.read`` and ``pyvista.get_reader``."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pyvista as pv
from pyvista.core.utilities.reader import BaseVTKReader

from ..checks import index_in
from .steps import read, steps

if TYPE_CHECKING:
    from .steps import PackingSteps


class _StepsReader(BaseVTKReader):
    """What PyVista takes for a reader of VTK."""

    def __init__(self) -> None:
        super().__init__()
        self.index = 0
        self._steps: PackingSteps | None = None

    @property
    def steps(self) -> PackingSteps:
        """Steps of the file."""
        if self._steps is None:
            self._steps = steps(self._filename)
        return self._steps

    def UpdateInformation(self) -> None:
        """Do nothing: what is wrong with the file is raised when it is read."""

    def Update(self) -> None:
        """Read the step."""
        self._data_object = self.steps[self.index]


# PyVista 0.48, which some builds run on, has no generic one.
class PackingStepsReader(pv.BaseReader, pv.TimeReader):  # type: ignore[type-arg]
    """Reader of the files that :func:`spherepacking.steps` reads by Python libraries.

    Its time points are the steps.

    Parameters
    ----------
    path : str or pathlib.Path
        File to read.

    Examples
    --------
    >>> import pyvista as pv
    >>> reader = pv.get_reader("run.gsd")  # doctest: +SKIP
    >>> reader.set_active_time_point(-1)  # doctest: +SKIP
    >>> packing = reader.read()  # doctest: +SKIP
    """

    _class_reader = _StepsReader

    @property
    def time_values(self) -> list[float]:
        """Return the times of the steps; 0, 1, 2 and so on where the file has none."""
        times: list[float] = self.reader.steps.times
        return times or [float(i) for i in range(self.number_time_points)]

    @property
    def number_time_points(self) -> int:
        """Return the number of steps."""
        return len(self.reader.steps)

    def time_point_value(self, time_point: int) -> float:
        """Return the time of a step, or raise an IndexError."""
        values = self.time_values
        return values[index_in(range(len(values)), "time_point", time_point)]

    @property
    def active_time_value(self) -> float:
        """Return the time of the step that is read; the first by default."""
        return self.time_values[self.reader.index]

    def set_active_time_value(self, time_value: float) -> None:
        """Choose the step to read by its time, or raise a ValueError.

        A time that several steps have chooses none: use :meth:`set_active_time_point`.
        """
        if self.reader.steps.times:
            self.reader.index = self.reader.steps.index_of(time=time_value)
        elif time_value in self.time_values:
            self.reader.index = self.time_values.index(time_value)
        else:
            raise ValueError(f"time_value: found {time_value}, expected one of {self.time_values}")

    def set_active_time_point(self, time_point: int) -> None:
        """Choose the step to read by its index, or raise an IndexError."""
        self.reader.index = index_in(range(self.number_time_points), "time_point", time_point)


# Upstream: PyVista before 0.49 takes functions only, no classes, from entry points:
# https://github.com/pyvista/pyvista/pull/8950.
entry_point = PackingStepsReader if pv.version_info >= (0, 49) else read
