"""Any dataset of VTK as a packing: its points as centres, the radii where they are to be found."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

from .checks import kind_of
from .packing import check_radii, no_such_array
from .radii import given_radii, radii_from, radius_name_in
from .size_names import diameters_in

if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Any

    from .radii import RadiusLike


def packing_of(dataset: object, radius: RadiusLike | None = None) -> pv.PolyData:
    """Make a packing of any dataset.

    Parameters
    ----------
    dataset : vtkDataSet or vtkCompositeDataSet
        Its points are the centres. The blocks of a composite one are joined.
    radius : str, float, array_like or mapping, optional
        See :func:`spherepacking.radii.given_radii`. By default the array ``radius``, or else the
        one that is called radii, diameter or the like.

    Returns
    -------
    pyvista.PolyData
        Centres (n, 3) and point array ``radius`` (n,): `dataset` itself if it is that, else another
        one that shares its arrays. The radii are not checked. One without points may have none.

    Raises
    ------
    KeyError
        If there is no such array.
    TypeError
        If it is no such dataset, or the radii are not real numbers.
    ValueError
        If several arrays may hold the radii, or there is not one radius per sphere.
    """
    wrapped = wrap(dataset)
    if isinstance(wrapped, pv.PolyData) and radius is None and _has_radii(wrapped):
        return wrapped
    if isinstance(wrapped, pv.PolyData):
        packing = wrapped.copy(deep=False)
        if radius is None or (isinstance(radius, str) and radius not in packing.point_data):
            _take_cell_arrays(packing, wrapped)
    else:
        check_blocks(wrapped, radius)
        packing = centres_of(wrapped, radius if isinstance(radius, str) else None)
    return with_radius_array(packing, radius)


def plain_packing(dataset: object) -> pv.PolyData:
    """`dataset` if it is a PolyData, else its points as one, with all arrays as they are."""
    wrapped = wrap(dataset)
    return wrapped if isinstance(wrapped, pv.PolyData) else centres_of(wrapped)


def wrap(dataset: object) -> Any:
    """`dataset` as one of PyVista's, or a TypeError unless it has points."""
    wrapped = pv.wrap(dataset) if hasattr(dataset, "IsA") else dataset
    if not isinstance(wrapped, (pv.DataSet, pv.MultiBlock, pv.PartitionedDataSet)):
        raise TypeError(
            f"packing: found {kind_of(dataset)}, expected a PolyData or another dataset whose "
            "points are the centres of the spheres"
        )
    return wrapped


def with_radius_array(packing: pv.PolyData, radius: RadiusLike | None) -> pv.PolyData:
    """Give a packing the point array ``radius``.

    Parameters
    ----------
    packing : pyvista.PolyData
        Centres (n, 3); it is changed.
    radius : str, float, array_like or mapping, optional
        As in :func:`packing_of`.

    Returns
    -------
    pyvista.PolyData
        `packing`. The array of one without points is empty.
    """
    if radius is not None:
        values = given_radii(packing, radius)
    elif packing.n_points:
        name = radius_name_in(packing.point_data.keys())
        if name is None:
            raise no_such_array("radius", "radius", packing)
        values = radii_from(name, packing.point_data[name])
    else:
        values = np.empty(0)
    if not packing.n_points:
        if "radius" not in packing.point_data:
            # PyVista takes no empty array.
            packing.GetPointData().AddArray(pv.convert_array(values, name="radius"))
        return packing
    if values is not packing.point_data.get("radius"):
        active = packing.point_data.active_scalars_name
        packing.point_data["radius"] = values
        packing.set_active_scalars(active, preference="point")
    return packing


def with_radii(dataset: object, radius: RadiusLike | None) -> tuple[pv.PolyData, str]:
    """Check the radii and return the packing to draw and the name of its radius array.

    Parameters
    ----------
    dataset : vtkDataSet or vtkCompositeDataSet
        As in :func:`packing_of`.
    radius : str, float, array_like or mapping, optional
        As in :func:`packing_of`.

    Returns
    -------
    tuple[pyvista.PolyData, str]
        `dataset` itself if it is a PolyData and `radius` the name of an array of radii, so that
        they stay connected; else another one that shares its arrays.

    Raises
    ------
    KeyError, TypeError, ValueError
        As :func:`packing_of` and :func:`spherepacking.packing.check_radii`.
    """
    wrapped = wrap(dataset)
    if isinstance(wrapped, pv.PolyData) and isinstance(radius, str) and _is_plain(wrapped, radius):
        packing, name = wrapped, radius
    else:
        packing, name = packing_of(wrapped, radius), "radius"
    check_radii(packing, name)
    return packing, name


def _has_radii(packing: pv.PolyData) -> bool:
    array = packing.GetPointData().GetAbstractArray("radius")
    return array is not None and array.GetNumberOfComponents() == 1


def _is_plain(packing: pv.PolyData, name: str) -> bool:
    """Whether the array holds radii as they are, or is not there."""
    array = packing.GetPointData().GetAbstractArray(name)
    if array is None:
        return name not in packing.cell_data
    return array.GetNumberOfComponents() == 1 and diameters_in(name) == "no"


# --- points of datasets ---------------------------------------------------------------------------

# Datasets whose points are an object of their own.
_WITH_POINTS = (pv.PolyData, pv.UnstructuredGrid, pv.StructuredGrid, pv.PointSet)


def centres_of(dataset: Any, radius: str | None = None) -> pv.PolyData:
    """The points of a dataset as vertices, with its point and field arrays.

    Parameters
    ----------
    dataset : pyvista.DataSet or pyvista.MultiBlock
        Where it is composite, its blocks are joined: an array that some of them lack is NaN, or an
        empty text, there.
    radius : str, optional
        Name of the array with the radii, which is looked for in each block.

    Returns
    -------
    pyvista.PolyData
        Shares the arrays of a dataset that is not composite. Each sphere that is a cell of its own
        has the cell's arrays, too.
    """
    if isinstance(dataset, pv.DataSet):
        return _points_of(dataset)
    blocks = [_points_of(block) for block in _blocks_of(dataset)]
    if len(blocks) > 1:
        # Each may call its radii otherwise.
        for block in blocks:
            if radius is None and block.n_points and radius_name_in(block.point_data.keys()):
                with_radius_array(block, None)
        filled = [block for block in blocks if block.n_points]
        blocks = [_joined(filled)] if filled else blocks[:1]
    packing = blocks[0] if blocks else pv.PolyData()
    _add_field_arrays(packing, dataset)
    return packing


def check_blocks(dataset: Any, radius: RadiusLike | None) -> None:
    """Raise a ValueError if some blocks have radii and others none.

    Parameters
    ----------
    dataset : pyvista.DataSet or pyvista.MultiBlock
        Where it is composite, each block with points must have them, or none.
    radius : str, float, array_like or mapping, optional
        As in :func:`packing_of`: only what names an array, or nothing, is looked for in blocks.
    """
    if isinstance(dataset, pv.DataSet) or not (radius is None or isinstance(radius, str)):
        return
    having: list[str | int] = []
    lacking: list[str | int] = []
    for name, block in _named_blocks(dataset):
        arrays = [*block.point_data, *block.cell_data]
        found = radius in arrays if radius is not None else radius_name_in(arrays) is not None
        if block.n_points:
            (having if found else lacking).append(name)
    if having and lacking:
        raise ValueError(
            f"radius: found no radii in the block {lacking[0]!r}, but in {having[0]!r}, expected "
            "radii in every block, or the blocks with spheres alone, such as "
            f"pyvista.read(PATH)[{having[0]!r}]"
        )


def _named_blocks(dataset: Any) -> Iterator[tuple[str | int, pv.DataSet]]:
    """All datasets in a composite one, in order, by name or else by number."""
    for i, block in enumerate(dataset):
        name = dataset.get_block_name(i) if isinstance(dataset, pv.MultiBlock) else None
        if isinstance(block, pv.DataSet):
            yield i if name is None else name, block
        elif isinstance(block, (pv.MultiBlock, pv.PartitionedDataSet)):
            yield from _named_blocks(block)


def _blocks_of(dataset: Any) -> Iterator[pv.DataSet]:
    """All datasets with points in a composite one, in order."""
    for block in dataset:
        if isinstance(block, pv.DataSet):
            yield block
        elif isinstance(block, (pv.MultiBlock, pv.PartitionedDataSet)):
            yield from _blocks_of(block)
        elif block is not None:
            raise TypeError(
                f"packing: found a block that is a {type(block).__name__}, expected datasets whose "
                "points are the centres of the spheres"
            )


def _points_of(dataset: pv.DataSet) -> pv.PolyData:
    """The points of one dataset as vertices; arrays are shared."""
    packing = pv.PolyData()
    if isinstance(dataset, _WITH_POINTS):
        packing.SetPoints(dataset.GetPoints() or packing.GetPoints())
    else:
        packing.points = np.asarray(dataset.points)
    count = packing.n_points
    packing.verts = np.column_stack([np.ones(count, np.int64), np.arange(count)]).ravel()
    packing.GetPointData().ShallowCopy(dataset.GetPointData())
    packing.GetFieldData().ShallowCopy(dataset.GetFieldData())
    _take_cell_arrays(packing, dataset)
    return packing


def _take_cell_arrays(packing: pv.PolyData, dataset: pv.DataSet) -> None:
    """Make arrays of cells those of points, if each point is one cell and each cell one point."""
    names = [name for name in dataset.cell_data if name not in packing.point_data]
    if not names or dataset.n_cells != dataset.n_points:
        return
    if isinstance(dataset, pv.PolyData):
        if dataset.n_verts != dataset.n_cells or len(dataset.verts) != 2 * dataset.n_cells:
            return
        ids: np.ndarray = np.asarray(dataset.verts[1::2])
    elif isinstance(dataset, pv.UnstructuredGrid):
        if not (dataset.celltypes == pv.CellType.VERTEX).all():
            return
        ids = np.asarray(dataset.cell_connectivity)
    else:
        return
    wrong = ids[(ids < 0) | (ids >= dataset.n_points)]
    if wrong.size:
        raise ValueError(
            f"packing: found a cell of the point {wrong[0]}, expected one of {dataset.n_points}"
        )
    at = np.full(dataset.n_points, -1)
    at[ids] = np.arange(len(ids))
    if (at < 0).any():
        return
    for name in names:
        packing.point_data[name] = np.asarray(dataset.cell_data[name])[at]


def _joined(blocks: list[pv.PolyData]) -> pv.PolyData:
    """One packing of several, none of them empty."""
    packing = pv.PolyData(np.concatenate([np.asarray(block.points) for block in blocks]))
    for name in dict.fromkeys(name for block in blocks for name in block.point_data):
        parts = [np.asarray(b.point_data[name]) if name in b.point_data else None for b in blocks]
        known = next(part for part in parts if part is not None)
        if any(part is not None and part.shape[1:] != known.shape[1:] for part in parts):
            raise ValueError(f"packing: found blocks whose arrays {name!r} differ in components")
        absent = "" if known.dtype.kind in "US" else np.nan
        packing.point_data[name] = np.concatenate(
            [
                np.full((block.n_points, *known.shape[1:]), absent) if part is None else part
                for block, part in zip(blocks, parts, strict=True)
            ]
        )
    for block in blocks:
        _add_field_arrays(packing, block)
    return packing


def _add_field_arrays(packing: pv.PolyData, dataset: Any) -> None:
    """Share the field arrays that the packing lacks; those of blocks tend to be the same."""
    there, further = packing.GetFieldData(), dataset.GetFieldData()
    for i in range(further.GetNumberOfArrays() if further else 0):
        array = further.GetAbstractArray(i)
        if there.GetAbstractArray(array.GetName()) is None:
            there.AddArray(array)


class DatasetPacking:
    """The packing of a dataset, the same object and arrays for as long as these do not change.

    Parameters
    ----------
    dataset : pyvista.DataSet or pyvista.MultiBlock
        Its points are the centres.
    """

    def __init__(self, dataset: Any) -> None:
        self._dataset = dataset
        self._made: pv.PolyData | None = None

    def modified(self) -> None:
        """Notify VTK that points and arrays of the dataset have changed, whichever that are."""
        self._made = None
        blocks = [self._dataset]
        if not isinstance(self._dataset, pv.DataSet):
            blocks = list(_blocks_of(self._dataset))
        for block in blocks:
            points = block.GetPoints() if isinstance(block, _WITH_POINTS) else None
            if points is not None:
                points.GetData().Modified()
                points.Modified()
            for data in (block.GetPointData(), block.GetCellData(), block.GetFieldData()):
                for i in range(data.GetNumberOfArrays()):
                    data.GetAbstractArray(i).Modified()
            block.Modified()
        self._dataset.Modified()

    def with_radius(self, radius: RadiusLike | None = None) -> pv.PolyData:
        """Return the packing, as :func:`packing_of`."""
        packing, before = packing_of(self._dataset, radius), self._made
        if packing is self._dataset:
            return packing
        # What hangs on centres and radii, such as a hierarchy, is made anew when VTK's objects are
        # others. Those of before serve as long as they hold the same numbers.
        if before is not None and before.n_points == packing.n_points:
            if np.array_equal(before.points, packing.points):
                packing.SetPoints(before.GetPoints())
            radii = before.GetPointData().GetAbstractArray("radius")
            if radii is not None and np.array_equal(before["radius"], packing["radius"]):
                packing.GetPointData().AddArray(radii)
        self._made = packing
        return packing
