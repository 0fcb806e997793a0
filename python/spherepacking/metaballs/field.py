"""Fields of metaballs on grids."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

from .. import checks
from ..vtk_tools import errors_raised, update
from .arguments import field_filter

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ..backend import vtkMetaballField
    from ..look.look import Look
    from .arguments import FieldOptions


def metaball_field(
    packing: pv.PolyData,
    options: FieldOptions,
    threshold: float | None,
    *,
    gradient: bool,
    strongest: bool,
    blend: bool,
    look: Look,
    progress: bool,
) -> pv.ImageData:
    """Sum a field; the arguments are those of ``packing.packing.metaball_field``."""
    algorithm = field_filter(packing, options, threshold)
    algorithm.SetComputeGradient(checks.flag_of("gradient", gradient))
    algorithm.SetComputeStrongest(checks.flag_of("strongest", strongest))
    checks.flag_of("log_scale", look.log_scale)
    if checks.flag_of("blend", blend):
        _color_by(algorithm, packing, look)
    return _run(algorithm, progress)


def surface_field(
    packing: pv.PolyData,
    options: FieldOptions,
    threshold: float,
    coloring: str | None,
    look: Look,
    progress: bool,
) -> tuple[pv.ImageData, np.ndarray | None]:
    """Sum what a surface and its colours need.

    Parameters
    ----------
    packing : pyvista.PolyData
        Centres (n, 3) and point array ``radius`` (n,).
    options : FieldOptions
        What the field depends on.
    threshold : float
        Value of the surface that is to close inside, unless there are bounds.
    coloring : {"blend", "strongest"}, optional
        Where the colours come from.
    look : Look
        What the spheres are coloured by.
    progress : bool
        Show a progress bar.

    Returns
    -------
    tuple[pyvista.ImageData, numpy.ndarray or None]
        The field, and the colours (n, 3) of the spheres if they differ and are asked for.
    """
    algorithm = field_filter(packing, options, threshold)
    algorithm.ComputeGradientOn()
    algorithm.SetComputeStrongest(coloring == "strongest")
    colors = _color_by(algorithm, packing, look)
    if coloring != "blend":
        algorithm.SetColorArrayName("")
    return _run(algorithm, progress), None if coloring is None else colors


def grid_bounds(packing: pv.PolyData, options: FieldOptions, threshold: float) -> np.ndarray:
    """Bounds (6,) of the grid that `surface_field` would choose; nothing is summed."""
    from ..backend import vtkDataObject, vtkStreamingDemandDrivenPipeline

    algorithm = field_filter(packing, options, threshold)
    with errors_raised(algorithm):
        algorithm.UpdateInformation()
    information = algorithm.GetOutputInformation(0)
    extent = information.Get(vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT())
    origin = np.array(information.Get(vtkDataObject.ORIGIN()))
    spacing = np.array(information.Get(vtkDataObject.SPACING()))
    ends = np.array(extent).reshape(3, 2)
    return (origin[:, None] + spacing[:, None] * ends).ravel()


def touches_sides(field: pv.ImageData, threshold: float) -> bool:
    """Whether the surface is cut by the sides of the grid."""
    values = field["field"].reshape(field.dimensions[::-1])
    return any(
        bool((side >= threshold).any())
        for axis in range(3)
        for side in (np.take(values, 0, axis), np.take(values, -1, axis))
    )


def fills(field: pv.ImageData, bounds: Sequence[float] | np.ndarray) -> bool:
    """Whether a box is at least half as long as the grid, which is wasted otherwise."""
    lengths = np.array(field.spacing) * (np.array(field.dimensions) - 1)
    box = np.asarray(bounds, dtype=float)
    return bool((box[1::2] - box[::2]).max() >= 0.5 * lengths.max())


def mixed(ranges: list[pv.ImageData], weights: Sequence[float]) -> pv.ImageData:
    """Field, gradient and blend of all ranges of spheres, each times its weight."""
    field = pv.ImageData()
    field.CopyStructure(ranges[0])
    whole = sum(w * part["field"] for w, part in zip(weights, ranges, strict=True))
    field["gradient"] = sum(w * part["gradient"] for w, part in zip(weights, ranges, strict=True))
    if "blend" in ranges[0].point_data:
        parts = (
            (w * np.asarray(part["field"]))[:, None] * part["blend"]
            for w, part in zip(weights, ranges, strict=True)
        )
        mean = sum(parts) / np.where(np.asarray(whole) > 0, whole, 1)[:, None]
        field["blend"] = np.round(mean).astype(np.uint8)
    field["field"] = whole
    return field


def _color_by(algorithm: vtkMetaballField, packing: pv.PolyData, look: Look) -> np.ndarray | None:
    """Give the filter the colours (n, 3) that spheres have in a plotter; None if all are alike."""
    colors = look.sphere_colors(packing)
    if colors is None:
        return None
    data = packing.copy(deep=False)
    data.GetPointData().AddArray(colors)
    algorithm.SetInputData(data)
    algorithm.SetColorArrayName(colors.GetName())
    return pv.convert_array(colors)[:, :3]


def _run(algorithm: vtkMetaballField, progress: bool) -> pv.ImageData:
    """Run the filter; what it reports is a ValueError."""
    update(algorithm, "summing the field", progress=checks.flag_of("progress", progress))
    image = pv.ImageData()
    image.ShallowCopy(algorithm.GetOutput())
    return image
