"""What the pictures of one or many steps have in common: colours and extent."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import pyvista as pv

from ..accessor import PackingAccessor
from ..granular.cell import cell_of, outline_of
from ..look.look import Look
from ..look.scalars import means_colors
from .camera import check_extent

if TYPE_CHECKING:
    from collections.abc import Iterable

    from pyvista.plotting._typing import ColorLike

    from .options import RenderOptions

# Radii that spread over more than this ratio are coloured by their logarithm.
_WIDE = 20.0


class Scene(NamedTuple):
    """What is the same in all pictures.

    Attributes
    ----------
    look : Look
        What the spheres are coloured by, and in which range.
    bounds : tuple[float, ...] or None
        Box around all spheres; None without any.
    """

    look: Look
    bounds: tuple[float, ...] | None


class _Range:
    """Smallest and largest of the numbers that it is shown; infinite before the first."""

    def __init__(self) -> None:
        self.low, self.high = np.inf, -np.inf

    def add(self, values: np.ndarray) -> None:
        """Take note of numbers; those that are not finite do not count."""
        values = values[np.isfinite(values)]
        if values.size:
            self.low = min(self.low, float(values.min()))
            self.high = max(self.high, float(values.max()))

    @property
    def limits(self) -> tuple[float, float] | None:
        """Both, if they differ."""
        return (self.low, self.high) if self.low < self.high else None


def scene_of(
    packings: Iterable[pv.PolyData], names: Iterable[str], options: RenderOptions, *, several: bool
) -> Scene:
    """Find the colours that were asked for, and else those that suit the radii.

    Parameters
    ----------
    packings : iterable of pyvista.PolyData
        What is drawn, one after the other.
    names : iterable of str
        What to call each of them.
    options : RenderOptions
        What was asked for.
    several : bool
        Whether colours have to mean the same in several pictures.

    Returns
    -------
    Scene
        The look, and the bounds of all.

    Raises
    ------
    ValueError
        If there is no such array, or a picture cannot hold a packing.
    """
    radii, positive, values = _Range(), _Range(), _Range()
    box: np.ndarray | None = None
    for packing, name in zip(packings, names, strict=True):
        check_extent(name, packing)
        if options.cell:
            corners = _cell_corners_of(packing, name)
            here = np.stack([corners.min(axis=0), corners.max(axis=0)])
            box = _both(box, here)
        if not packing.n_points:
            continue
        radius = np.asarray(packing.point_data["radius"], dtype=float)
        radii.add(radius)
        positive.add(radius[radius > 0.0])
        if options.scalars is not None:
            values.add(_numbers_of(packing, options.scalars, several))
        low, high = np.reshape(PackingAccessor(packing).bounds, (3, 2)).T
        box = _both(box, np.stack([low, high]))
    look = _look_of(radii, positive, values, options, several)
    return Scene(look, None if box is None else tuple(box.T.ravel().tolist()))


def cell_corners(packing: pv.PolyData) -> np.ndarray:
    """Corners (8, 3) of the cell of a packing, or a ValueError if it has none."""
    return np.asarray(outline_of(cell_of(packing)).points, dtype=float)


def _cell_corners_of(packing: pv.PolyData, name: str) -> np.ndarray:
    """The same, with an error that names the option and the file."""
    try:
        return cell_corners(packing)
    except (KeyError, ValueError) as error:
        raise ValueError(f"--cell: {name}: {error.args[0]}") from None


def _both(box: np.ndarray | None, other: np.ndarray) -> np.ndarray:
    """The box around two boxes (2, 3)."""
    if box is None:
        return other
    return np.stack([np.minimum(box[0], other[0]), np.maximum(box[1], other[1])])


def _numbers_of(packing: pv.PolyData, scalars: str, several: bool) -> np.ndarray:
    """Numbers that a colour map maps: those of an array, or the lengths of its rows."""
    if scalars not in packing.point_data:
        there = ", ".join(packing.point_data.keys())
        raise ValueError(f"--scalars: found no array {scalars!r}, expected one of: {there}")
    values = np.asarray(packing.point_data[scalars])
    if values.dtype.kind not in "biuf":
        if several:
            raise ValueError(
                f"--scalars: found texts in {scalars!r}, expected numbers with --steps: texts may "
                "differ from step to step"
            )
        return np.empty(0)
    return np.linalg.norm(values, axis=1) if values.ndim > 1 else values.astype(float)


def _look_of(
    radii: _Range, positive: _Range, values: _Range, options: RenderOptions, several: bool
) -> Look:
    """The look, from the ranges over all packings."""
    scalars, clim, log_scale = options.scalars, options.clim, options.log_scale
    color: ColorLike | None = options.color
    unasked = scalars is None and options.cmap is None and clim is None
    if color is None and unasked and radii.limits is None:
        color = pv.global_theme.color  # there is nothing to colour by
    by_radius = color is None and scalars in (None, "radius")
    if log_scale is None and by_radius:
        log_scale = positive.high > _WIDE * positive.low
        if log_scale and clim is None:
            # Zero has no logarithm, and nothing that is drawn has that radius.
            clim = positive.limits
    if several and color is None and clim is None and not means_colors(scalars or ""):
        clim = (positive if by_radius and log_scale else radii if by_radius else values).limits
    return Look(
        scalars=scalars, cmap=options.cmap, clim=clim, log_scale=bool(log_scale), color=color
    )
