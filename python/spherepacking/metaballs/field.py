"""The field of metaballs: arguments, the C++ filter, and the surface at a threshold."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

from .. import checks as arguments
from ..look.color_map import colour_map_of, special_colours
from ..look.scalars import scalars_of
from ..trace.ray_cast import _colors_of
from ..vtk_tools import progress_bar

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike

KERNELS = ("inverse", "inverse_square", "gaussian", "wyvill")
COLORINGS = ("blend", "strongest")


def weights_of(weights: ArrayLike | None) -> list[float]:
    """`weights` as numbers from 0 on, or a ValueError."""
    if weights is None:
        return []
    try:
        values = np.atleast_1d(np.asarray(weights))
    except ValueError:
        values = np.empty((0, 0))
    values = values.astype(float) if values.dtype.kind in "iuf" else np.empty((0, 0))
    if values.ndim != 1 or not values.size or not ((values >= 0) & (values <= 1e20)).all():
        raise ValueError(f"weights: found {weights!r}, expected numbers from 0 to 1e20")
    return values.tolist()


def coloring_of(coloring: str | None) -> str | None:
    """`coloring` as one of COLORINGS or None, or a ValueError."""
    if not (coloring is None or (isinstance(coloring, str) and coloring in COLORINGS)):
        raise ValueError(f"coloring: found {coloring!r}, expected one of {', '.join(COLORINGS)}")
    return coloring


def threshold_of(threshold: float) -> float:
    """`threshold` as a finite number above 0, or a ValueError."""
    value = arguments.above_zero("threshold", threshold)
    if value == np.inf:
        raise ValueError(f"threshold: found {threshold!r}, expected a finite number above 0")
    return value


def field_filter(
    packing: pv.PolyData,
    *,
    dimensions: Sequence[int] | int | None,
    spacing: Sequence[float] | float | None,
    bounds: Sequence[float] | None,
    threshold: float | None,
    kernel: str,
    weights: ArrayLike | None,
    count: int | None,
    relative_error: float,
) -> object:
    """Make a vtkMetaballField and check what it is given."""
    from ..backend import vtkMetaballField

    if packing.n_points:
        arguments.radii_of(packing, "radius")
    if not (isinstance(kernel, str) and kernel in KERNELS):
        raise ValueError(f"kernel: found {kernel!r}, expected one of {', '.join(KERNELS)}")
    algorithm = vtkMetaballField()
    # Errors are raised, not printed.
    for source in (algorithm, algorithm.GetExecutive()):
        source.AddObserver("ErrorEvent", _ignore)
    algorithm.SetInputData(packing)
    algorithm.SetKernel(KERNELS.index(kernel))
    if (dimensions is None) == (spacing is None):
        raise ValueError(
            f"dimensions: found {dimensions!r} and spacing={spacing!r}, expected one of them"
        )
    if dimensions is not None:
        three = _three(dimensions)
        if len(three) != 3:
            raise ValueError(f"dimensions: found {dimensions!r}, expected one or three integers")
        algorithm.SetDimensions([arguments.count_of("dimensions", n) for n in three])
    else:
        three = _three(spacing)
        if len(three) != 3:
            raise ValueError(f"spacing: found {spacing!r}, expected one or three numbers")
        algorithm.SetSpacing([arguments.above_zero("spacing", step) for step in three])
    if bounds is not None:
        try:
            box = np.asarray(bounds, dtype=float)
        except (TypeError, ValueError):
            box = np.empty(0)
        if box.shape != (6,) or not np.isfinite(box).all() or (box[::2] > box[1::2]).any():
            raise ValueError(
                f"bounds: found {bounds!r}, expected x min, x max, y min, y max, z min and z max"
            )
        algorithm.SetModelBounds(box)
    if threshold is not None:
        algorithm.SetThreshold(threshold_of(threshold))
    numbers = weights_of(weights)
    algorithm.SetNumberOfWeights(len(numbers))
    for i, weight in enumerate(numbers):
        algorithm.SetWeight(i, weight)
    if count is not None:
        algorithm.SetCount(arguments.count_of("count", count))
    error = arguments.number_of("relative_error", relative_error, 0.0, 0.5)
    if 0.0 < error < 2e-5:
        raise ValueError(
            f"relative_error: found {relative_error!r}, expected a number from 2e-5 to 0.5, or 0 "
            "for sums sphere by sphere"
        )
    algorithm.SetRelativeError(error)
    return algorithm


def _three(value: object) -> list[object]:
    """One value three times, or a list of those there are."""
    several = hasattr(value, "__len__") and getattr(value, "ndim", 1) > 0
    one = isinstance(value, str | bytes) or not several
    return [value] * 3 if one else list(value)


def _ignore(*_: object) -> None:
    pass


def color_by(algorithm: object, packing: pv.PolyData, look: dict[str, object]) -> bool:
    """Give the filter the colours that spheres have in a plotter; False if they are all alike."""
    color = look["color"]
    found = scalars_of(packing, look["scalars"], look["rgb"], active=color is None)
    log_scale = arguments.flag_of("log_scale", look["log_scale"])
    words = colour_map_of(found, None, look["cmap"], look["clim"], 256, False, log_scale, None)
    arguments.color_of("color", color)
    if found.values is None or not packing.n_points:
        return False
    special = special_colours(pv.global_theme, None, 1.0, None, None)
    colors = _colors_of(packing, found, words | special)
    data = packing.copy(deep=False)
    data.GetPointData().AddArray(colors)
    algorithm.SetInputData(data)
    algorithm.SetColorArrayName(colors.GetName())
    return True


def colors_of(algorithm: object) -> np.ndarray:
    """Colours (n, 3), uint8, that `color_by` gave the filter."""
    data = algorithm.GetInputDataObject(0, 0).GetPointData()
    return pv.convert_array(data.GetArray(algorithm.GetColorArrayName()))[:, :3]


def surface_field(
    packing: pv.PolyData,
    threshold: float,
    coloring: str | None,
    look: dict[str, object],
    words: dict[str, object],
    progress: bool,
) -> tuple[pv.ImageData, np.ndarray | None]:
    """Sum what a surface and its colours need.

    Parameters
    ----------
    packing : pyvista.PolyData
        Centres (n, 3) and point array ``radius`` (n,).
    threshold : float
        Value of the surface that is to close inside, unless there are bounds.
    coloring : {"blend", "strongest"}, optional
        Where the colours come from.
    look : dict
        What the spheres are coloured by.
    words : dict
        Other arguments of `field_filter`.
    progress : bool
        Show a progress bar.

    Returns
    -------
    tuple[pyvista.ImageData, numpy.ndarray or None]
        The field, and the colours (n, 3) of the spheres if they differ and are asked for.
    """
    algorithm = field_filter(packing, threshold=threshold, **words)
    algorithm.ComputeGradientOn()
    algorithm.SetComputeStrongest(coloring == "strongest")
    colored = color_by(algorithm, packing, look) and coloring is not None
    colors = colors_of(algorithm) if colored else None
    if coloring != "blend":
        algorithm.SetColorArrayName("")
    return run(algorithm, progress), colors


def run(algorithm: object, progress: bool) -> pv.ImageData:
    """Run the filter; its message is a ValueError."""
    delay = 0.0 if arguments.flag_of("progress", progress) else np.inf
    with progress_bar(algorithm, "summing the field", delay=delay):
        algorithm.Update()
    if algorithm.GetErrorMessage():
        raise ValueError(algorithm.GetErrorMessage())
    image = pv.ImageData()
    image.ShallowCopy(algorithm.GetOutput())
    return image


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
    from ..backend import vtkFlyingEdges3D

    if min(field.dimensions) < 2:
        raise ValueError(
            f"dimensions: found {field.dimensions}, expected 2 or more along each axis"
        )
    values = field["field"]
    least, most = float(values.min()), float(values.max())
    surface = pv.PolyData()
    if not least < threshold <= most:
        side = "above" if threshold > most else "not above"
        warnings.warn(
            f"metaballs: the threshold {threshold:g} is {side} all values of the field, {least:g} "
            f"to {most:g}, so the surface is empty",
            stacklevel=4,
        )
    else:
        field = field.copy(deep=False)
        if "blend" in field.point_data:
            # Between small integers the filter's interpolation overflows.
            field.point_data["blend"] = field.point_data["blend"].astype(np.float32)
        # Its points are floats, which would not do far from the origin.
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
        surface.ShallowCopy(edges.GetOutput())
        surface.points = np.asarray(surface.points, float) + center
    data = surface.point_data
    if "gradient" in data:
        data["Normals"] = _normals_of(data["gradient"])
        data.active_normals_name = "Normals"
    if "blend" in data:
        data["color"] = np.round(data["blend"]).astype(np.uint8)
    for name in {"field", "gradient", "blend", "strongest"} & set(data.keys()):
        del data[name]
    return surface


def _normals_of(gradient: np.ndarray) -> np.ndarray:
    """Unit vectors (n, 3) in the direction in which the field falls."""
    # In double precision, where squares of floats neither vanish nor overflow.
    away = -np.asarray(gradient, dtype=float)
    length = np.linalg.norm(away, axis=1, keepdims=True)
    return (away / np.where(length > 0.0, length, 1.0)).astype(np.float32)


def ids_at(field: pv.ImageData, points: np.ndarray) -> np.ndarray:
    """Values (n,) of ``strongest`` at the inner ends of the edges that a surface's `points` cut."""
    places = (points - np.array(field.origin)) / np.array(field.spacing)
    low = np.rint(places).astype(int)
    high = low.copy()
    rows = np.arange(len(places))
    axis = np.abs(places - low).argmax(axis=1)
    low[rows, axis] = np.floor(places[rows, axis])
    high[rows, axis] = np.ceil(places[rows, axis])
    nx, ny, nz = field.dimensions
    ends = []
    for end in (low, high):
        x, y, z = np.clip(end, 0, np.array([nx, ny, nz]) - 1).T
        ends.append(x + nx * (y + ny * z))
    values = field["field"]
    return field["strongest"][np.where(values[ends[0]] > values[ends[1]], *ends)]


def touches_sides(field: pv.ImageData, threshold: float) -> bool:
    """Whether the surface is cut by the sides of the grid."""
    values = field["field"].reshape(field.dimensions[::-1])
    return any(
        (side >= threshold).any()
        for axis in range(3)
        for side in (np.take(values, 0, axis), np.take(values, -1, axis))
    )


def fills(field: pv.ImageData, bounds: Sequence[float]) -> bool:
    """Whether a box is at least half as long as the grid, which is wasted otherwise."""
    lengths = np.array(field.spacing) * (np.array(field.dimensions) - 1)
    box = np.asarray(bounds, dtype=float)
    return bool((box[1::2] - box[::2]).max() >= 0.5 * lengths.max())


def grid_bounds(packing: pv.PolyData, threshold: float, words: dict[str, object]) -> np.ndarray:
    """Bounds (6,) of the grid that `surface_field` would choose; nothing is summed."""
    from ..backend import vtkDataObject, vtkStreamingDemandDrivenPipeline

    algorithm = field_filter(packing, threshold=threshold, **words)
    algorithm.UpdateInformation()
    information = algorithm.GetOutputInformation(0)
    extent = information.Get(vtkStreamingDemandDrivenPipeline.WHOLE_EXTENT())
    origin = np.array(information.Get(vtkDataObject.ORIGIN()))
    spacing = np.array(information.Get(vtkDataObject.SPACING()))
    ends = np.array(extent).reshape(3, 2)
    return (origin[:, None] + spacing[:, None] * ends).ravel()
