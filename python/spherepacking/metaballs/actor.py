"""Metaballs in a plotter, which follow changes of their threshold, weights and count."""

from __future__ import annotations

import warnings
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

from ..packing import modified_times
from .arguments import coloring_of, threshold_of, weights_of
from .field import fills, grid_bounds, mixed, surface_field, touches_sides
from .surface import colored_surface

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ..look.look import Look
    from ..packing import ModifiedTimes
    from .arguments import FieldOptions


# A surface that grew may grow on to what it is at the threshold over this.
_ROOM = 1.5
# Bytes that the fields of all ranges may take.
_LARGEST_RANGES = 2**31


class Metaballs:
    """What ``plotter.packing.add_metaballs`` returns: an actor and what its surface is made of.

    Set :attr:`threshold`, :attr:`weights` or :attr:`count`, and the next rendering shows the new
    surface. A new threshold needs no new field unless the surface grows out of the grid, or so
    small that one of less than half the size would do. One that grew gets a grid with room for
    thresholds down to two thirds.

    The field is linear in the weights. On a grid that suits new ones, the fields of the ranges of
    spheres are summed and kept if they take no more than 2 GiB, and all other weights, if there are
    as many and the grid suits them, need no field. With ``coloring="strongest"``, which is not
    linear, each change needs one. After changes of the packing call :meth:`update`.

    Parameters
    ----------
    packing : pyvista.PolyData
        Centres (n, 3) and point array ``radius`` (n,).
    threshold : float
        Value of the surface.
    coloring : {"blend", "strongest"}, optional
        Where the colours come from.
    look : Look
        What the spheres are coloured by.
    options : FieldOptions
        What the field depends on.
    """

    def __init__(
        self,
        packing: pv.PolyData,
        threshold: float,
        coloring: str | None,
        look: Look,
        options: FieldOptions,
    ) -> None:
        self.actor: pv.Actor | None = None
        self.surface = pv.PolyData()
        """The triangles that are shown, see ``packing.packing.metaballs``."""
        self.sums = 0
        """How many fields have been summed, each over the whole grid."""
        self._packing = packing
        self._coloring = coloring_of(coloring)
        self._look = look
        # A copy, which the caller cannot change.
        weights = None if options.weights is None else weights_of(options.weights)
        self._options = replace(options, weights=weights)
        self._threshold = threshold_of(threshold)
        self._colors: np.ndarray | None = None
        self._ranges: list[pv.ImageData] = []
        self._times: ModifiedTimes | int
        self._field: pv.ImageData
        self.update()

    @property
    def threshold(self) -> float:
        """Value of the surface, above 0."""
        return self._threshold

    @threshold.setter
    def threshold(self, threshold: float) -> None:
        before = self._threshold
        self._threshold = threshold_of(threshold)
        try:
            self._show()
        except BaseException:
            self._threshold = before
            raise

    @property
    def count(self) -> int | None:
        """How many of the largest spheres are used; None for all."""
        return self._options.count

    @count.setter
    def count(self, count: int | None) -> None:
        before = self._options
        self._options = replace(before, count=count)
        try:
            self.update()
        except BaseException:
            self._options = before
            raise

    @property
    def weights(self) -> tuple[float, ...]:
        """Weights of the ranges of spheres, from the largest to the smallest; empty for 1."""
        return tuple(weights_of(self._options.weights))

    @weights.setter
    def weights(self, weights: ArrayLike | None) -> None:
        empty = weights is None or np.size(weights) == 0
        numbers = [] if empty else weights_of(weights)
        options, field = self._options, self._field
        self._options = replace(options, weights=tuple(numbers) or None)
        try:
            if self._coloring == "strongest" or not numbers or self._has_changed():
                self.update()
                return
            if len(self._ranges) != len(numbers):
                grew, fits = self._compare()
                if not fits or not self._may_keep(len(numbers)):
                    self._renew(grew)
                    return
                ones = np.eye(len(numbers))
                self._ranges = [self._sum(self._on_same_grid(one)) for one in ones]
            self._field = mixed(self._ranges, numbers)
            self._show()
        except BaseException:
            self._options, self._field = options, field
            raise

    def update(self) -> None:
        """Make field and surface anew, on a grid that holds it, from the packing as it now is."""
        times = self._present_times()
        self._field = self._sum(self._options)
        self._ranges = []
        self._times = times
        self._take(self._contour())

    def _renew(self, grew: bool) -> None:
        """Update, with room if the surface has grown."""
        self._field = self._sum(self._options, room=_ROOM if grew else 1.0)
        self._ranges = []
        self._take(self._contour())

    def _needed(self) -> np.ndarray:
        """Bounds of the grid that the surface would be given."""
        return grid_bounds(self._packing, self._options, self._threshold)

    def _compare(self) -> tuple[bool, bool]:
        """Whether the surface has outgrown the grid, and whether that is still one for it."""
        if self._options.bounds is not None:
            return False, True
        box = self._needed()
        grid = np.array(self._field.bounds)
        grew = bool((box[::2] < grid[::2]).any() or (box[1::2] > grid[1::2]).any())
        return grew, not grew and fills(self._field, box)

    def _may_keep(self, number: int) -> bool:
        """Whether there is room for the fields of so many ranges."""
        data = self._field.point_data
        return number * sum(data[name].nbytes for name in data) <= _LARGEST_RANGES

    def _present_times(self) -> ModifiedTimes | int:
        """When the packing was last changed; that of all where there are no spheres."""
        times = modified_times(self._packing)
        return self._packing.GetMTime() if times is None else times

    def _has_changed(self) -> bool:
        """Whether the field is that of a packing that has changed since."""
        return self._times != self._present_times()

    def _show(self) -> None:
        """Show the surface in the field, or in a new one if the grid does not suit it."""
        if self._has_changed():
            self.update()
            return
        if self._options.bounds is not None:
            self._take(self._contour())
            return
        grew = touches_sides(self._field, self._threshold)
        if not grew:
            with warnings.catch_warnings():
                # On a grid of its own there may be one.
                warnings.filterwarnings("ignore", "metaballs: ", UserWarning)
                surface = self._contour()
            shown = surface.n_points > 0 and fills(self._field, surface.bounds)
            if shown or fills(self._field, self._needed()):
                self._take(surface if shown else self._contour())
                return
        self._renew(grew)

    def _on_same_grid(self, weights: np.ndarray) -> FieldOptions:
        """Options for a field with other weights on the grid of the present one."""
        return replace(
            self._options,
            weights=weights,
            bounds=self._field.bounds,
            dimensions=self._field.dimensions,
            spacing=None,
        )

    def _sum(self, options: FieldOptions, room: float = 1.0) -> pv.ImageData:
        """Sum a field whose grid has room for the surface at the threshold over `room`."""
        field, self._colors = surface_field(
            self._packing, options, self._threshold / room, self._coloring, self._look, False
        )
        self.sums += 1
        return field

    def _contour(self) -> pv.PolyData:
        return colored_surface(self._field, self._threshold, self._coloring, self._colors)

    def _take(self, surface: pv.PolyData) -> None:
        # The mapper of the actor has this very object.
        self.surface.copy_from(surface)


def actor_of(
    metaballs: Metaballs,
    color: pv.Color,
    colored: bool,
    opacity: float,
    specular: float,
    specular_power: float,
) -> pv.Actor:
    """Make the actor of metaballs, in the colours of their surface or in one colour."""
    mapper = pv.DataSetMapper(metaballs.surface)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("color")
    mapper.SetColorModeToDirectScalars()
    mapper.scalar_visibility = colored
    actor = pv.Actor(mapper=mapper)
    actor.prop.color, actor.prop.opacity = color, opacity
    actor.prop.specular, actor.prop.specular_power = specular, specular_power
    actor.prop.interpolation = "phong"
    return actor
