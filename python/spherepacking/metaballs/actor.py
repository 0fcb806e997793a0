"""Metaballs in a plotter, which follow changes of their threshold, weights and count."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

from ..trace.ray_cast import state_of
from . import field as _field
from .accessor import colored_surface

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


# A surface that grew may grow on to what it is at the threshold over this.
_ROOM = 1.5
# Bytes of fields of ranges that are kept.
_KEPT = 2**31


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
    look : dict
        What the spheres are coloured by, as in ``packing.packing.metaballs``.
    words : dict
        Other arguments of ``packing.packing.metaballs``.
    """

    def __init__(
        self,
        packing: pv.PolyData,
        threshold: float,
        coloring: str | None,
        look: dict[str, object],
        words: dict[str, object],
    ) -> None:
        self.actor: pv.Actor | None = None
        self.surface = pv.PolyData()
        """The triangles that are shown, see ``packing.packing.metaballs``."""
        self.sums = 0
        """How many fields have been summed, each over the whole grid."""
        self._packing = packing
        self._coloring = _field.coloring_of(coloring)
        numbers = None if words["weights"] is None else _field.weights_of(words["weights"])
        self._look, self._words = look, words | {"weights": numbers}
        self._threshold = _field.threshold_of(threshold)
        self._colors: np.ndarray | None = None
        self._field: pv.ImageData | None = None
        self._ranges: list[pv.ImageData] = []
        self._state: tuple[int, ...] = ()
        self.update()

    @property
    def threshold(self) -> float:
        """Value of the surface, above 0."""
        return self._threshold

    @threshold.setter
    def threshold(self, threshold: float) -> None:
        before = self._threshold
        self._threshold = _field.threshold_of(threshold)
        try:
            self._show()
        except BaseException:
            self._threshold = before
            raise

    @property
    def count(self) -> int | None:
        """How many of the largest spheres are used; None for all."""
        return self._words["count"]

    @count.setter
    def count(self, count: int | None) -> None:
        self._change("count", count)

    @property
    def weights(self) -> tuple[float, ...]:
        """Weights of the ranges of spheres, from the largest to the smallest; empty for 1."""
        return tuple(self._words["weights"] or ())

    @weights.setter
    def weights(self, weights: ArrayLike | None) -> None:
        empty = weights is None or np.size(weights) == 0
        numbers = [] if empty else _field.weights_of(weights)
        before, field = self._words["weights"], self._field
        self._words["weights"] = tuple(numbers) or None
        try:
            if self._coloring == "strongest" or not numbers or self._state != self._now():
                self.update()
                return
            if len(self._ranges) != len(numbers):
                grew, fits = self._compare()
                if not fits or not self._may_keep(len(numbers)):
                    self._renew(grew)
                    return
                ones = np.eye(len(numbers))
                self._ranges = [self._sum(one, same_grid=True) for one in ones]
            self._field = _mixed(self._ranges, numbers)
            self._show()
        except BaseException:
            self._words["weights"], self._field = before, field
            raise

    def update(self) -> None:
        """Make field and surface anew, on a grid that holds it, from the packing as it now is."""
        state = self._now()
        self._field = self._sum(self._words["weights"], same_grid=False)
        self._ranges = []
        self._state = state
        self._take(self._contour())

    def _renew(self, grew: bool) -> None:
        """Update, with room if the surface has grown."""
        self._field = self._sum(
            self._words["weights"], same_grid=False, room=_ROOM if grew else 1.0
        )
        self._ranges = []
        self._take(self._contour())

    def _needed(self) -> np.ndarray:
        """Bounds of the grid that the surface would be given."""
        return _field.grid_bounds(self._packing, self._threshold, self._words)

    def _compare(self) -> tuple[bool, bool]:
        """Whether the surface has outgrown the grid, and whether that is still one for it."""
        if self._words["bounds"] is not None:
            return False, True
        box = self._needed()
        grid = np.array(self._field.bounds)
        grew = bool((box[::2] < grid[::2]).any() or (box[1::2] > grid[1::2]).any())
        return grew, not grew and _field.fills(self._field, box)

    def _may_keep(self, number: int) -> bool:
        """Whether there is room for the fields of so many ranges."""
        data = self._field.point_data
        return number * sum(data[name].nbytes for name in data) <= _KEPT

    def _change(self, name: str, value: object) -> None:
        before = self._words[name]
        self._words[name] = value
        try:
            self.update()
        except BaseException:
            self._words[name] = before
            raise

    def _now(self) -> tuple[int, ...]:
        """When the packing was last changed."""
        packing = self._packing
        told = packing.GetMTime(), packing.GetPointData().GetMTime()
        return *told, *(state_of(packing) or ())

    def _show(self) -> None:
        """Show the surface in the field, or in a new one if the grid does not suit it."""
        if self._state != self._now():
            self.update()
            return
        if self._words["bounds"] is not None:
            self._take(self._contour())
            return
        grew = _field.touches_sides(self._field, self._threshold)
        if not grew:
            with warnings.catch_warnings():
                # On a grid of its own there may be one.
                warnings.filterwarnings("ignore", "metaballs: ", UserWarning)
                surface = self._contour()
            shown = surface.n_points > 0 and _field.fills(self._field, surface.bounds)
            if shown or _field.fills(self._field, self._needed()):
                self._take(surface if shown else self._contour())
                return
        self._renew(grew)

    def _sum(
        self, weights: ArrayLike | None, *, same_grid: bool, room: float = 1.0
    ) -> pv.ImageData:
        words = self._words | {"weights": weights}
        if same_grid:
            words |= {"bounds": self._field.bounds, "dimensions": self._field.dimensions}
            words["spacing"] = None
        field, self._colors = _field.surface_field(
            self._packing, self._threshold / room, self._coloring, self._look, words, False
        )
        self.sums += 1
        return field

    def _contour(self) -> pv.PolyData:
        return colored_surface(self._field, self._threshold, self._coloring, self._colors)

    def _take(self, surface: pv.PolyData) -> None:
        # The mapper of the actor keeps this one.
        self.surface.copy_from(surface)


def _mixed(ranges: list[pv.ImageData], weights: list[float]) -> pv.ImageData:
    """Field, gradient and blend of all ranges, each times its weight."""
    field = pv.ImageData()
    field.CopyStructure(ranges[0])
    whole = sum(w * part["field"] for w, part in zip(weights, ranges, strict=True))
    field["gradient"] = sum(w * part["gradient"] for w, part in zip(weights, ranges, strict=True))
    if "blend" in ranges[0].point_data:
        parts = (
            (w * part["field"])[:, None] * part["blend"]
            for w, part in zip(weights, ranges, strict=True)
        )
        mean = sum(parts) / np.where(whole > 0, whole, 1)[:, None]
        field["blend"] = np.round(mean).astype(np.uint8)
    field["field"] = whole
    return field
