"""Surfaces in OBJ, the object format of Wavefront."""

from __future__ import annotations

import warnings
from array import array
from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

from .surface_rows import SurfaceRows, checked_faces, finite_points

if TYPE_CHECKING:
    from pathlib import Path

# Numbers beside those of a surface: places in a texture, normals, points of parameters.
_NUMBERS = {b"vt": (1, 2, 3), b"vn": (3,), b"vp": (1, 2, 3)}
# A point may have a weight, which is that of a rational curve, or a colour, or both.
_POINT = (3, 4, 6, 7)
# Names, of other files too, which are not opened; and how to draw.
_NAMES = frozenset(
    (b"o", b"g", b"mtllib", b"usemtl", b"maplib", b"usemap", b"shadow_obj", b"trace_obj")
)
_DRAWING = frozenset((b"s", b"mg", b"bevel", b"c_interp", b"d_interp", b"lod"))
_LARGEST = 2**62  # so that it stays an integer of 64 bits
_CORNER = "three or more points by their numbers, from 1 on, or from -1 down"


def read_obj(path: Path) -> pv.PolyData:
    """Read an OBJ file: points and polygons; no other file that it names is opened.

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
        If it is no such file, or has free-form curves or surfaces.

    Warns
    -----
    UserWarning
        If no polygon has some of the points, as in a file that ends early: it has no counts.
    """
    rows = SurfaceRows(path, path.read_bytes(), b"#", goes_on=b"\\")
    numbers, faces = array("d"), array("q")
    for words in rows:
        key = words[0]
        if key == b"v":
            if len(words) - 1 not in _POINT:
                rows.refuse("v and three coordinates")
            numbers.extend(rows.numbers(words[1:], "three coordinates")[:3])
        elif key == b"f":
            faces.append(len(words) - 1)
            faces.extend(_corners(rows, words, len(numbers) // 3))
        else:
            _pass_over(rows, words)
    points = finite_points(path, np.array(numbers).reshape(-1, 3))
    polygons = checked_faces(path, np.array(faces, np.int64), len(points))
    surface = pv.PolyData(points, faces=polygons if len(polygons) else None)
    loose = len(points) - np.unique(surface.GetPolys().GetConnectivityArray()).size if faces else 0
    if loose:
        warnings.warn(
            f"{path}: found {loose} points of no polygon; the file may have ended earlier than it "
            "should",
            stacklevel=2,
        )
    return surface


def _corners(rows: SurfaceRows, words: list[bytes], n_points: int) -> list[int]:
    """Points of a polygon, from 0 on; after each a place in a texture and a normal may follow."""
    corners = words[1:]
    if len(corners) < 3:
        rows.refuse(_CORNER)
    if b"/" in corners[0]:
        further: list[bytes] = []
        for i, corner in enumerate(corners):
            corners[i], *more = corner.split(b"/")
            further += [number for number in more if number]
            if len(more) > 2:
                rows.refuse(_CORNER)
        if further:
            rows.integers(further, _CORNER)
    ids = rows.integers(corners, _CORNER)
    if max(ids) > _LARGEST:
        rows.refuse(_CORNER)
    if min(ids) < 1:
        ids = [i + n_points + 1 if i < 0 else i for i in ids]
        if min(ids) < 1:
            rows.refuse(_CORNER)
    return [i - 1 for i in ids]


def _pass_over(rows: SurfaceRows, words: list[bytes]) -> None:
    """Pass over what is no part of a surface, or refuse it."""
    key, *rest = words
    if key in _NUMBERS:
        if len(rest) not in _NUMBERS[key]:
            rows.refuse(f"{key.decode()} and its numbers")
        rows.numbers(rest, "numbers")
    elif key in (b"l", b"p"):
        parts = [part for word in rest for part in word.split(b"/") if part]
        rows.integers(parts, "numbers of points")
    elif key in _NAMES:
        # One letter away from f is g.
        if len(rest) > 2 and b"".join(rest).replace(b"/", b"").isdigit():
            rows.refuse(f"names after {key.decode()}, or a polygon, which begins with f")
    elif key in _DRAWING:
        if len(rest) not in (1, 2):
            rows.refuse(f"{key.decode()} and one word")
    else:
        rows.refuse("v, vt, vn, f, l, p, g, o, s, usemtl or mtllib; no free-form surfaces")
