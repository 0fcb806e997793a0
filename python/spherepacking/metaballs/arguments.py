"""Arguments of metaballs, and the C++ filter that is made of them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import checks
from ..packing import check_radii

if TYPE_CHECKING:
    from collections.abc import Sequence

    import pyvista as pv
    from numpy.typing import ArrayLike

    from ..backend import vtkMetaballField

KERNELS = ("inverse", "inverse_square", "gaussian", "wyvill")
COLORINGS = ("blend", "strongest")


@dataclass(frozen=True, eq=False)
class FieldOptions:
    """What a field depends on beside the packing; arguments of ``packing.packing.metaball_field``.

    One of `dimensions` and `spacing` is None.
    """

    dimensions: Sequence[int] | int | None
    spacing: Sequence[float] | float | None
    kernel: str
    weights: ArrayLike | None
    count: int | None
    relative_error: float
    bounds: Sequence[float] | None


def weights_of(weights: ArrayLike | None) -> list[float]:
    """`weights` as numbers within their limits, or a ValueError; [] for None."""
    if weights is None:
        return []
    low, high = checks.WEIGHT_LIMITS
    found = checks.numbers_of(weights)
    values = np.empty(0) if found is None else np.atleast_1d(found)
    if values.ndim != 1 or not values.size or not ((values >= low) & (values <= high)).all():
        raise ValueError(
            f"weights: found {checks.shown(weights)}, expected numbers from {low:g} to {high:g}"
        )
    return values.tolist()


def coloring_of(coloring: str | None) -> str | None:
    """`coloring` as one of COLORINGS or None, or a ValueError."""
    return None if coloring is None else checks.one_of("coloring", coloring, COLORINGS)


def threshold_of(threshold: float) -> float:
    """`threshold` as a finite number above 0, or a ValueError."""
    value = checks.above_zero("threshold", threshold)
    if value == np.inf:
        raise ValueError(
            f"threshold: found {checks.shown(threshold)}, expected a finite number above 0"
        )
    return value


def field_filter(
    packing: pv.PolyData, options: FieldOptions, threshold: float | None
) -> vtkMetaballField:
    """Make a vtkMetaballField and check what it is given."""
    from ..backend import vtkMetaballField

    if packing.n_points:
        check_radii(packing)
    kernel = checks.one_of("kernel", options.kernel, KERNELS)
    algorithm = vtkMetaballField()
    algorithm.SetInputData(packing)
    algorithm.SetKernel(KERNELS.index(kernel))
    _set_grid(algorithm, options)
    if threshold is not None:
        algorithm.SetThreshold(threshold_of(threshold))
    weights = weights_of(options.weights)
    algorithm.SetNumberOfWeights(len(weights))
    for i, weight in enumerate(weights):
        algorithm.SetWeight(i, weight)
    if options.count is not None:
        algorithm.SetCount(checks.count_of("count", options.count))
    algorithm.SetRelativeError(_relative_error_of(options.relative_error))
    return algorithm


def _set_grid(algorithm: vtkMetaballField, options: FieldOptions) -> None:
    """Check what describes the grid and hand it to the filter."""
    dimensions, spacing, bounds = options.dimensions, options.spacing, options.bounds
    if dimensions is not None and spacing is None:
        counts = _broadcast(dimensions)
        if len(counts) != 3:
            raise ValueError(
                f"dimensions: found {checks.shown(dimensions)}, expected one or three integers"
            )
        algorithm.SetDimensions([checks.count_of("dimensions", n) for n in counts])
    elif dimensions is None and spacing is not None:
        steps = _broadcast(spacing)
        if len(steps) != 3:
            raise ValueError(
                f"spacing: found {checks.shown(spacing)}, expected one or three numbers"
            )
        algorithm.SetSpacing([checks.above_zero("spacing", step) for step in steps])
    else:
        raise ValueError(
            f"dimensions: found {checks.shown(dimensions)} and spacing={checks.shown(spacing)}, "
            "expected one of them"
        )
    if bounds is not None:
        box = checks.numbers_of(bounds)
        if (
            box is None
            or box.shape != (6,)
            or not np.isfinite(box).all()
            or (box[::2] > box[1::2]).any()
        ):
            raise ValueError(
                f"bounds: found {checks.shown(bounds)}, "
                "expected x min, x max, y min, y max, z min and z max"
            )
        algorithm.SetModelBounds(box.tolist())


def _relative_error_of(value: float) -> float:
    """The error that a field may have, or a ValueError; 0 for sums sphere by sphere."""
    least, most = checks.RELATIVE_ERROR_LIMITS
    error = checks.number_of("relative_error", value, 0.0, most)
    if 0.0 < error < least:
        raise ValueError(
            f"relative_error: found {checks.shown(value)}, "
            f"expected a number from {least:g} to {most:g}, or 0 "
            "for sums sphere by sphere"
        )
    return error


def _broadcast(value: Any) -> list[Any]:
    """Broadcast a scalar to x, y, z; else list(value)."""
    several = hasattr(value, "__len__") and getattr(value, "ndim", 1) > 0
    one = isinstance(value, str | bytes) or not several
    return [value] * 3 if one else list(value)
