"""Surfaces in fields of metaballs."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

from .arguments import coloring_of, threshold_of
from .field import surface_field

if TYPE_CHECKING:
    from ..look.look import Look
    from .arguments import FieldOptions


def metaballs(
    packing: pv.PolyData,
    options: FieldOptions,
    threshold: float,
    coloring: str | None,
    look: Look,
    progress: bool,
) -> pv.PolyData:
    """Make a surface; the arguments are those of ``packing.packing.metaballs``."""
    threshold = threshold_of(threshold)
    coloring = coloring_of(coloring)
    field, colors = surface_field(packing, options, threshold, coloring, look, progress)
    return colored_surface(field, threshold, coloring, colors)


def colored_surface(
    field: pv.ImageData, threshold: float, coloring: str | None, colors: np.ndarray | None
) -> pv.PolyData:
    """Make the surface of a field, and its array ``color``.

    Parameters
    ----------
    field : pyvista.ImageData
        Point arrays ``field`` and ``gradient``, and ``blend`` or ``strongest`` as `coloring` says.
    threshold : float
        Value of the surface.
    coloring : {"blend", "strongest"}, optional
        Where the colours come from.
    colors : numpy.ndarray, optional
        Colours (n, 3) of the spheres, uint8; None for none.

    Returns
    -------
    pyvista.PolyData
        As ``packing.packing.metaballs`` returns it.
    """
    surface = surface_at(field, threshold)
    data = surface.point_data
    if coloring == "strongest" and surface.n_points:
        ids = ids_at(field, surface.points)
        data["sphere_id"] = ids
        if colors is not None:
            data["color"] = colors[ids]
    if "color" in data:
        data.active_scalars_name = "color"
    return surface


def surface_at(field: pv.ImageData, threshold: float) -> pv.PolyData:
    """Triangles of the surface on which `field` is `threshold`, with normals and colours.

    Parameters
    ----------
    field : pyvista.ImageData
        Point arrays ``field`` and ``gradient``, and any others.
    threshold : float
        Value of the surface.

    Raises
    ------
    ValueError
        If the grid is flat.

    Returns
    -------
    pyvista.PolyData
        Triangles that face outwards, with the point arrays ``Normals`` (n, 3), from ``gradient``,
        and ``color`` (n, 3), from ``blend``.
    """
    if min(field.dimensions) < 2:
        raise ValueError(
            f"dimensions: found {field.dimensions}, expected 2 or more along each axis"
        )
    values = field["field"]
    least, most = float(values.min()), float(values.max())
    if least < threshold <= most:
        surface = _flying_edges(field, threshold)
    else:
        surface = pv.PolyData()
        side = "above" if threshold > most else "not above"
        warnings.warn(
            f"metaballs: the threshold {threshold:g} is {side} all values of the field, {least:g} "
            f"to {most:g}, so the surface is empty",
            stacklevel=5,
        )
    data = surface.point_data
    if "gradient" in data:
        data["Normals"] = _normals_of(data["gradient"])
        data.active_normals_name = "Normals"
    if "blend" in data:
        data["color"] = np.round(data["blend"]).astype(np.uint8)
    for name in {"field", "gradient", "blend", "strongest"} & set(data.keys()):
        del data[name]
    return surface


def _flying_edges(field: pv.ImageData, threshold: float) -> pv.PolyData:
    """The surface, with the field's arrays interpolated, in double precision."""
    from ..backend import vtkFlyingEdges3D

    field = field.copy(deep=False)
    # Upstream: VTK 9.7's flying edges make points in single precision, too coarse far from the
    # origin, so the grid is moved there and back.
    center = np.array(field.center)
    field.origin = np.array(field.origin) - center
    edges = vtkFlyingEdges3D()
    edges.SetInputData(field)
    edges.SetInputArrayToProcess(0, 0, 0, 0, "field")
    edges.SetValue(0, threshold)
    edges.ComputeNormalsOff()
    edges.ComputeScalarsOff()
    edges.InterpolateAttributesOn()
    edges.Update()
    surface = pv.PolyData()
    surface.ShallowCopy(edges.GetOutput())
    surface.points = np.asarray(surface.points, float) + center
    return surface


def _normals_of(gradient: np.ndarray) -> np.ndarray:
    """Unit vectors (n, 3) in the direction in which the field falls."""
    # In double precision, where squares of floats neither vanish nor overflow.
    away = -np.asarray(gradient, dtype=float)
    length = np.linalg.norm(away, axis=1, keepdims=True)
    return (away / np.where(length > 0.0, length, 1.0)).astype(np.float32)


def ids_at(field: pv.ImageData, points: np.ndarray) -> np.ndarray:
    """Values (n,) of ``strongest`` at the inner ends of the edges that a surface's `points` cut."""
    steps = (points - np.array(field.origin)) / np.array(field.spacing)
    low = np.rint(steps).astype(int)
    high = low.copy()
    rows = np.arange(len(steps))
    axis = np.abs(steps - low).argmax(axis=1)
    low[rows, axis] = np.floor(steps[rows, axis])
    high[rows, axis] = np.ceil(steps[rows, axis])
    nx, ny, nz = field.dimensions
    ends = []
    for end in (low, high):
        x, y, z = np.clip(end, 0, np.array([nx, ny, nz]) - 1).T
        ends.append(x + nx * (y + ny * z))
    values = field["field"]
    return field["strongest"][np.where(values[ends[0]] > values[ends[1]], *ends)]
