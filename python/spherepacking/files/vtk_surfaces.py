"""Surfaces in VTK's files, whose cells are checked before a filter of VTK believes them."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

from .surface_rows import finite_points, refuse
from .vtk_child import arrays_from_child, hand_over_arrays
from .vtk_counts import check_counts
from .vtk_files import errors_of_vtk
from .vtk_legacy import check_legacy

if TYPE_CHECKING:
    from pathlib import Path
    from typing import Any

# Corners of linear cells; 0 where cells may have any number, from the least on.
_CORNERS = {
    pv.CellType.VERTEX: 1,
    pv.CellType.POLY_VERTEX: 0,
    pv.CellType.LINE: 2,
    pv.CellType.POLY_LINE: 0,
    pv.CellType.TRIANGLE: 3,
    pv.CellType.TRIANGLE_STRIP: 0,
    pv.CellType.POLYGON: 0,
    pv.CellType.PIXEL: 4,
    pv.CellType.QUAD: 4,
    pv.CellType.TETRA: 4,
    pv.CellType.VOXEL: 8,
    pv.CellType.HEXAHEDRON: 8,
    pv.CellType.WEDGE: 6,
    pv.CellType.PYRAMID: 5,
}
_LEAST = {pv.CellType.TRIANGLE_STRIP: 3, pv.CellType.POLYGON: 3, pv.CellType.POLY_LINE: 2}


def read_vtk_surface(path: Path) -> pv.PolyData:
    """Read a surface from a file of VTK with polygons, or with cells of a volume.

    Parameters
    ----------
    path : pathlib.Path
        File to read, ``.vtk``, ``.vtp`` or ``.vtu``.

    Returns
    -------
    pyvista.PolyData
        The surface, of cells of a volume their outer one.

    Raises
    ------
    SurfaceFileError
        If it is no such file.
    """
    arrays = arrays_from_child(path)
    faces, strips = (arrays[name] if len(arrays[name]) else None for name in ("faces", "strips"))
    return pv.PolyData(arrays["points"], faces=faces, strips=strips)


def hand_over() -> None:
    """Read the file that the command line names, in a process of its own."""
    hand_over_arrays(_arrays)


def _arrays(path: Path) -> dict[str, np.ndarray]:
    """Points, polygons and strips of a file."""
    if path.suffix.lower() == ".vtk":
        check_legacy(path)
    elif check_counts(path):
        refuse(path, "names of other files", "a surface")
    with errors_of_vtk(f"{path}: found no surface that can be read"):
        mesh: Any = pv.get_reader(path).read()
    if not isinstance(mesh, (pv.PolyData, pv.UnstructuredGrid)):
        refuse(path, f"data of kind {type(mesh).__name__}", "polygons, or cells of a volume")
    finite_points(path, np.asarray(mesh.points))
    if isinstance(mesh, pv.UnstructuredGrid):
        _check_cells(path, mesh)
        mesh = mesh.extract_surface(algorithm=None)
    for cells in (mesh.GetPolys(), mesh.GetStrips()):
        sizes = _sizes(path, cells, mesh.n_points)
        if sizes.size and sizes.min() < 3:
            refuse(path, f"a polygon of {sizes.min()} points", "3 or more")
    return {"points": np.asarray(mesh.points), "faces": mesh.faces, "strips": mesh.strips}


def _sizes(path: Path, cells: Any, n_points: int) -> np.ndarray:
    """How many points each cell has; all are checked to be there."""
    offsets = pv.convert_array(cells.GetOffsetsArray()).astype(np.int64)
    ids = pv.convert_array(cells.GetConnectivityArray())
    sizes = np.diff(offsets)
    if offsets.size and (offsets[0] != 0 or offsets[-1] != len(ids) or (sizes < 0).any()):
        refuse(path, "cells that do not follow one another", "the points of one after the other")
    if len(ids) and not 0 <= ids.min() <= ids.max() < n_points:
        wrong = ids[(ids < 0) | (ids >= n_points)][0]
        refuse(path, f"a cell of point {wrong}", f"points from 0 to {n_points - 1}")
    return sizes


def _check_cells(path: Path, mesh: pv.UnstructuredGrid) -> None:
    """Refuse cells of kinds that are not linear, or of too few points."""
    sizes = _sizes(path, mesh.GetCells(), mesh.n_points)
    kinds = mesh.celltypes
    if len(kinds) != len(sizes):
        refuse(path, f"{len(sizes)} cells and {len(kinds)} kinds of them", "one kind for each")
    for kind in np.unique(kinds):
        of_kind = sizes[kinds == kind]
        corners = _CORNERS.get(kind)
        if corners is None:
            refuse(
                path, f"cells of VTK's kind {kind}", "linear ones, such as triangles and tetrahedra"
            )
        least, most = of_kind.min(), of_kind.max()
        if corners and not least == most == corners:
            refuse(path, f"a cell of kind {kind} with {least} to {most} points", f"{corners}")
        if least < _LEAST.get(kind, 1):
            refuse(path, f"a cell of kind {kind} with {least} points", "more")
