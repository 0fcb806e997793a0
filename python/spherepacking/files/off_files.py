"""Surfaces in OFF, the object file format of Geomview."""

from __future__ import annotations

import re
from array import array
from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

from ..printable import quoted
from .surface_rows import SurfaceRows, finite_points, refuse

if TYPE_CHECKING:
    from pathlib import Path

# Some files go on with the numbers in the first line, even without a space.
_HEAD = re.compile(rb"(ST)?(C)?(N)?OFF(\d*)")
_COUNTS = "how many points and polygons there are"
# A polygon's colour: none, an index, or red, green, blue and perhaps alpha.
_COLOURS = (0, 1, 3, 4)


def read_off(path: Path) -> pv.PolyData:
    """Read an OFF file in text: points and polygons; colours and normals are left out.

    VTK's reader refuses files with colours, normals or comments. A row is a point, as almost all
    programs write it; else points may stand in any number of rows, as Geomview's manual says. A
    polygon is a row of its own there, too, since its colour ends with the line.

    Parameters
    ----------
    path : pathlib.Path
        File to read.

    Returns
    -------
    pyvista.PolyData
        The surface, its points in float64.

    Raises
    ------
    SurfaceFileError
        If it is no such file.
    """
    rows = SurfaceRows(path, path.read_bytes(), b"#")
    head = rows.next_row()
    match = _HEAD.fullmatch(head[0]) if head else None
    if match is None:
        found = f"{quoted(head[0])} at its begin" if head else "an empty file"
        refuse(path, found, "an OFF file in text, which begins OFF")
    counts = [match[4], *head[1:]] if match[4] else head[1:]
    counts = counts or rows.next_row()
    if not 2 <= len(counts) <= 3:
        rows.refuse(_COUNTS)
    n_points, n_faces, *_ = rows.integers(counts, _COUNTS)
    if min(n_points, n_faces) < 0:
        rows.refuse(_COUNTS)
    n_rows = rows.count()
    points: np.ndarray | None
    if n_rows == n_points + n_faces:
        points = _points_in_rows(rows, n_points)
    else:
        width = 3 + 3 * bool(match[3]) + 4 * bool(match[2]) + 2 * bool(match[1])
        points = _points_in_any_rows(rows, n_points, width, n_rows - n_faces)
    if points is None or rows.count() != n_faces:
        refuse(
            path,
            f"{n_rows} lines after that with the numbers",
            f"{n_points} points and {n_faces} polygons",
        )
    faces = _faces(rows, n_points)
    return pv.PolyData(finite_points(path, points), faces=faces if len(faces) else None)


def _points_in_rows(rows: SurfaceRows, count: int) -> np.ndarray:
    """Points (n, 3), each a row, which may go on with a normal, a colour, and a place in a picture.

    Not only files that say so in the first line have these.
    """
    expected = "three coordinates, and what the points before it have"
    numbers = array("d")
    width = 0
    if count:
        for words in rows:
            width = width or len(words)
            if len(words) != width or not 3 <= width <= 12:
                rows.refuse(expected if numbers else "three coordinates")
            numbers.extend(rows.numbers(words, "three coordinates")[:3])
            if len(numbers) == 3 * count:
                break
    return np.array(numbers).reshape(count, 3)


def _points_in_any_rows(
    rows: SurfaceRows, count: int, width: int, n_rows: int
) -> np.ndarray | None:
    """Points (n, 3) of `width` numbers each, or None if they do not end where a row does."""
    numbers = array("d")
    for _ in range(n_rows):
        numbers.extend(rows.numbers(rows.next_row(), "coordinates"))
    return np.array(numbers).reshape(-1, width)[:, :3] if len(numbers) == count * width else None


def _faces(rows: SurfaceRows, n_points: int) -> np.ndarray:
    """Polygons, each its number of points followed by these."""
    expected = (
        f"how many points a polygon has, 3 or more, as many from 0 to {n_points - 1}, and perhaps "
        "its colour"
    )
    faces = array("q")
    for words in rows:
        size = rows.integers(words[:1], expected)[0]
        ids = rows.integers(words[1 : 1 + size], expected) if size >= 3 else []
        if len(ids) != size or not 0 <= min(ids, default=-1) <= max(ids) < n_points:
            rows.refuse(expected)
        if len(words) > 1 + size:
            if len(words) - 1 - size not in _COLOURS:
                rows.refuse(expected)
            rows.numbers(words[1 + size :], expected)
        faces.append(size)
        faces.extend(ids)
    return np.array(faces)
