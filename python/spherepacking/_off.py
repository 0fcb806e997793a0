"""Surfaces from OFF files, also with colours, normals or comments, which VTK's reader refuses."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

if TYPE_CHECKING:
    from pathlib import Path


def read_off(path: Path) -> pv.PolyData:
    """Read an OFF file in text: points and polygons; colours and normals are left out.

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
    ValueError
        If it is no such file; the message names file and line, what was found and expected.
    """
    lines = path.read_text("utf-8", "replace").splitlines()
    rows = [(i, line.partition("#")[0].split()) for i, line in enumerate(lines, 1)]
    rows = [(i, words) for i, words in rows if words]
    # Some files go on with the numbers in the first line, even without a space.
    head = re.fullmatch(r"(?:ST)?C?N?OFF(\d*)", rows[0][1][0]) if rows else None
    if head is None:
        raise ValueError(f"{path}: is no OFF file that can be read: found no line that begins OFF")
    first, words = rows.pop(0)
    counts = [head[1], *words[1:]] if head[1] else words[1:]
    if not counts and rows:
        first, counts = rows.pop(0)
    try:
        n_points, n_faces = int(counts[0]), int(counts[1])
    except (IndexError, ValueError):
        raise _error(path, first, counts, "how many points and polygons there are") from None
    if min(n_points, n_faces) < 0 or len(rows) < n_points + n_faces:
        raise ValueError(
            f"{path}: is no OFF file that can be read: found {len(rows)} lines after that with the "
            f"numbers, expected {n_points} points and {n_faces} polygons"
        )
    points = np.empty((n_points, 3))
    for i, (number, words) in enumerate(rows[:n_points]):
        try:
            points[i] = [float(words[axis]) for axis in range(3)]
        except (IndexError, ValueError):
            raise _error(path, number, words, "three coordinates") from None
    faces: list[int] = []
    for number, words in rows[n_points : n_points + n_faces]:
        try:
            ids = [int(word) for word in words[: 1 + int(words[0])]]
        except ValueError:
            ids = []
        good = len(ids) > 1 and len(ids) == 1 + ids[0]
        if not good or not 0 <= min(ids[1:]) <= max(ids[1:]) < n_points:
            expected = f"how many points a polygon has, and as many from 0 to {n_points - 1}"
            raise _error(path, number, words, expected)
        faces += ids
    return pv.PolyData(points, faces=faces or None)


def _error(path: Path, line: int, words: list[str], expected: str) -> ValueError:
    found = " ".join(words)[:60] or "nothing"
    return ValueError(
        f"{path}:{line}: is no OFF file that can be read: found {found}, expected {expected}"
    )
