"""Spheres of a periodic packing, and their images in neighbouring cells."""

from __future__ import annotations

import itertools
import math
from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

from .. import checks
from ..packing import check_radii
from .cell import Cell, cell_of, set_cell

if TYPE_CHECKING:
    from collections.abc import Iterable

# The flags that LAMMPS and others write: how often a sphere has crossed each face.
_FLAGS = ("ix", "iy", "iz")

# Points, shifts, numbers and vertices of a copy, and what is made on the way to them.
_BYTES_OF_A_COPY = 400

# Images per sphere that are tried, far more than of any cell in use.
_MOST_IMAGES = 100_000


def wrapped(packing: pv.PolyData) -> pv.PolyData:
    """Move spheres into the cell by its periodic vectors."""
    cell = cell_of(packing)
    points = np.array(packing.points, float)
    image = np.zeros(points.shape, np.int64)
    # Twice, since a centre just below a face is moved onto the opposite one, by rounding.
    for _ in range(2):
        steps = np.where(cell.periodic, np.floor(cell.fractions(points)), 0.0)
        if not (np.abs(steps) < checks.LARGEST_INT).all():
            raise ValueError(
                f"packing: found a sphere {np.abs(steps).max():g} cells away, expected one within "
                f"{checks.LARGEST_INT}"
            )
        outside = steps.any(axis=1)
        points[outside] -= cell.sums(steps[outside])
        image += steps.astype(np.int64)
    result = packing.copy(deep=False)
    # Not by the property, which would write into the points that both share.
    result.SetPoints(pv.vtk_points(points.astype(packing.points.dtype)))
    arrays = result.point_data
    known = arrays.get("image")
    if known is not None and known.shape == image.shape:
        _add(result, "image", known + image.astype(known.dtype))
    else:
        _add(result, "image", image.astype(np.int32))
    if all(flag in arrays for flag in _FLAGS):
        for axis, flag in enumerate(_FLAGS):
            _add(result, flag, arrays[flag] + image[:, axis].astype(arrays[flag].dtype))
    arrays.active_scalars_name = packing.point_data.active_scalars_name
    return result


def replicated(packing: pv.PolyData, counts: Iterable[int]) -> pv.PolyData:
    """Put so many copies side by side along each vector of the cell, which grows with them."""
    cell = cell_of(packing)
    n = packing.n_points
    counts = list(counts)
    copies = math.prod(counts)
    most = min(checks.LARGEST_INT, checks.half_of_memory() // _bytes_per_copy(packing))
    if copies * max(n, 1) > most:
        raise ValueError(
            f"nx, ny, nz: found {copies} copies of {n} spheres, expected at most {most} spheres, "
            "for which there is memory"
        )
    shifts = np.array(list(itertools.product(*map(range, counts))), np.int32)
    shift = np.repeat(shifts, n, axis=0)
    result = _taken(packing, cell, np.tile(np.arange(n), len(shifts)), shift)
    for name in ("image", *_FLAGS):
        if name in result.point_data:
            del result.point_data[name]
    repeats = shifts[-1] + 1
    set_cell(result, Cell(cell.vectors * repeats[:, None], cell.origin, cell.periodic))
    return result


def _bytes_per_copy(packing: pv.PolyData) -> int:
    """Bytes of a sphere's copy: what is known of it, and what making it takes."""
    data = packing.GetPointData()
    arrays = [data.GetAbstractArray(i) for i in range(data.GetNumberOfArrays())]
    values = sum(
        array.GetNumberOfComponents() * max(array.GetDataTypeSize(), 8) for array in arrays
    )
    return _BYTES_OF_A_COPY + 2 * values


def with_ghosts(packing: pv.PolyData) -> pv.PolyData:
    """Add the images of spheres that reach into the cell through periodic faces."""
    cell = cell_of(packing)
    check_radii(packing)
    n = packing.n_points
    ids, shifts = [np.arange(n)], [np.zeros((n, 3), np.int32)]
    if n:
        # An image reaches into the cell if it does along each vector, as far as its radius does.
        fractions = cell.fractions(np.asarray(packing.points, float))
        radii = np.asarray(packing.point_data["radius"], float)
        reach = radii[:, None] * np.linalg.norm(cell.duals, axis=1)
        low = np.where(cell.periodic, np.ceil(-fractions - reach), 0.0)
        high = np.where(cell.periodic, np.floor(1.0 - fractions + reach), 0.0)
        first, last = low.min(axis=0), high.max(axis=0)
        with np.errstate(over="ignore"):
            images = np.prod(last - first + 1.0)
        if not images <= _MOST_IMAGES:
            raise ValueError(
                f"cell_vectors: found spheres that need images from {first} to {last}, expected "
                f"at most {_MOST_IMAGES} of each; wrap() moves spheres into the cell"
            )
        ranges = (range(int(a), int(b) + 1) for a, b in zip(first, last, strict=True))
        for shift in itertools.product(*ranges):
            moved = fractions + shift
            inside = (~cell.periodic | ((moved > -reach) & (moved < 1.0 + reach))).all(axis=1)
            chosen = np.flatnonzero(inside) if any(shift) else np.empty(0, int)
            ids.append(chosen)
            shifts.append(np.tile(np.array(shift, np.int32), (len(chosen), 1)))
    result = _taken(packing, cell, np.concatenate(ids), np.concatenate(shifts))
    _add(result, "ghost", np.arange(result.n_points) >= n)
    result.point_data.active_scalars_name = packing.point_data.active_scalars_name
    return result


def _add(packing: pv.PolyData, name: str, values: np.ndarray) -> None:
    """Add a point array, which may be empty: PyVista refuses that."""
    if len(values):
        packing.point_data[name] = values
    else:
        plain = values.astype(np.uint8) if values.dtype == bool else values
        packing.GetPointData().AddArray(pv.convert_array(plain, name=name))


def _taken(packing: pv.PolyData, cell: Cell, ids: np.ndarray, shifts: np.ndarray) -> pv.PolyData:
    """The spheres `ids`, moved by `shifts`, with all that is known of them."""
    points = np.asarray(packing.points, float)[ids] + cell.sums(shifts)
    result = pv.PolyData(points.astype(packing.points.dtype))
    data, source = result.GetPointData(), packing.GetPointData()
    for index in range(source.GetNumberOfArrays()):
        array = source.GetAbstractArray(index)
        if array.IsNumeric():
            _add(result, array.GetName(), packing.point_data[array.GetName()][ids])
            continue
        # Upstream: PyVista 0.49 refuses text that is not ASCII, which VTK holds.
        texts = array.NewInstance()
        texts.SetName(array.GetName())
        texts.SetNumberOfValues(len(ids))
        for to, come_from in enumerate(ids.tolist()):
            texts.SetValue(to, array.GetValue(come_from))
        data.AddArray(texts)
    result.GetFieldData().DeepCopy(packing.GetFieldData())
    _add(result, "cell_shift", shifts)
    result.point_data.active_scalars_name = packing.point_data.active_scalars_name
    return result
