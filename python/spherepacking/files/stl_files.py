"""Surfaces in STL, as text or binary: triangles without common points."""

from __future__ import annotations

import re
from array import array
from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

from .surface_rows import SurfaceRows, finite_points, in_single_precision, refuse

if TYPE_CHECKING:
    from pathlib import Path

_HEAD = 84  # bytes, of which the last four say how many triangles there are
_TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("more", "<u2")])
# The rows of a triangle: their words, and how many numbers follow these.
_FACET = (
    ([b"facet", b"normal"], 3),
    ([b"outer", b"loop"], 0),
    *(3 * (([b"vertex"], 3),)),
    ([b"endloop"], 0),
    ([b"endfacet"], 0),
)
_VERTICES = (2, 3, 4)
# Normals are not used, and those of triangles without an area are no numbers in some files.
_NORMAL = re.compile(rb"[-+.0-9a-zA-Z#]+")


def read_stl(path: Path) -> pv.PolyData:
    """Read an STL file; normals, names and colours are left out.

    Parameters
    ----------
    path : pathlib.Path
        File to read.

    Returns
    -------
    pyvista.PolyData
        The surface, three points for each triangle.

    Raises
    ------
    SurfaceFileError
        If it is no such file.
    """
    data = path.read_bytes()
    count = int.from_bytes(data[80:_HEAD], "little")
    if len(data) == _HEAD + count * _TRIANGLE.itemsize:
        corners = np.frombuffer(data, _TRIANGLE, count, _HEAD)["corners"].reshape(-1, 3)
        points = finite_points(path, corners)
    elif data[:256].lstrip()[:5].lower() == b"solid" and b"\0" not in data:
        points = in_single_precision(finite_points(path, _corners(path, data)))
    elif len(data) < _HEAD:
        refuse(path, f"{len(data)} bytes that do not begin with solid", "an STL file")
    else:
        refuse(
            path,
            f"{len(data) - _HEAD:,} bytes after a head that counts {count:,} triangles",
            f"{count * _TRIANGLE.itemsize:,}, 50 for each",
        )
    ids = np.arange(len(points)).reshape(-1, 3)
    faces = np.column_stack([np.full(len(ids), 3), ids]).ravel()
    return pv.PolyData(points, faces=faces if len(faces) else None)


def _corners(path: Path, data: bytes) -> np.ndarray:
    """Corners (n, 3) of the triangles in a text."""
    rows = SurfaceRows(path, data)
    numbers = array("d")
    inside, at = False, 0  # a solid; which row of a facet
    for words in rows:
        if at == 0 and words[0].lower() == (b"endsolid" if inside else b"solid"):
            inside = not inside
            continue
        keys, count = _FACET[at] if inside else ([b"solid"], 0)
        n_keys = len(keys)
        if len(words) != n_keys + count or [word.lower() for word in words[:n_keys]] != keys:
            what = " or endsolid" if inside and at == 0 else ""
            rows.refuse(b" ".join(keys).decode() + " and three numbers" * bool(count) + what)
        if at == 0 and not _NORMAL.fullmatch(b"".join(words[2:])):
            rows.refuse("three numbers of a normal")
        if at in _VERTICES:
            numbers.extend(rows.numbers(words[1:], "three coordinates"))
        at = (at + 1) % len(_FACET)
    if inside:
        rows.next_row()
        rows.refuse("endsolid")
    return np.array(numbers).reshape(-1, 3)
