"""Surfaces in PLY, the polygon file format of Stanford, as text or binary."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

from .ply_bodies import BinaryBody, TextBody
from .ply_header import read_ply_header
from .surface_rows import (
    checked_faces,
    finite_points,
    in_single_precision,
    refuse,
)

if TYPE_CHECKING:
    from pathlib import Path

_LISTS = ("vertex_indices", "vertex_index")


def read_ply(path: Path) -> pv.PolyData:
    """Read a PLY file: points and polygons; all else is passed over.

    Parameters
    ----------
    path : pathlib.Path
        File to read.

    Returns
    -------
    pyvista.PolyData
        The surface.

    Raises
    ------
    SurfaceFileError
        If it is no such file.
    """
    data = path.read_bytes()
    header = read_ply_header(path, data)
    of_names = {element.name: element for element in header.elements}
    vertex, face = of_names.get("vertex"), of_names.get("face")
    if vertex is None or face is None:
        refuse(path, "no elements vertex and face in its header", "both")
    axes = [p for p in vertex.properties if p.name in ("x", "y", "z") and p.count is None]
    if len(axes) != 3:
        refuse(path, "no three properties x, y and z of its points", "these numbers")
    lists = [p.name for p in face.properties if p.name in _LISTS and p.count is not None]
    if len(lists) != 1 or any(p.name == lists[0] and p.kind.kind == "f" for p in face.properties):
        refuse(path, "no list vertex_indices of its polygons", "one of integers")
    wanted = {"vertex": ["x", "y", "z"], "face": lists}
    body = (BinaryBody if header.order else TextBody)(path, data, header)
    found = {}
    for element in header.elements:
        has_lists = any(p.count is not None for p in element.properties)
        read = body.lists if has_lists else body.numbers
        found[element.name] = read(element, wanted.get(element.name, []))
    body.end()
    points = finite_points(path, np.array(found["vertex"]).reshape(-1, 3))
    faces = checked_faces(path, found["face"], len(points))
    return pv.PolyData(in_single_precision(points), faces=faces if len(faces) else None)
