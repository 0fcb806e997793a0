"""Surfaces from files, for packing: what PyVista reads, and OFF with colours, normals, comments."""

from __future__ import annotations

import logging
import re
import warnings
from typing import TYPE_CHECKING, Literal

import numpy as np
import pyvista as pv

if TYPE_CHECKING:
    from pathlib import Path

_SIZES = {
    **dict.fromkeys(("char", "uchar", "int8", "uint8"), 1),
    **dict.fromkeys(("short", "ushort", "int16", "uint16"), 2),
    **dict.fromkeys(("int", "uint", "float", "int32", "uint32", "float32"), 4),
    **dict.fromkeys(("double", "float64"), 8),
}
_ORDERS: dict[str, Literal["little", "big"]] = {
    "binary_little_endian": "little",
    "binary_big_endian": "big",
}


def read_surface(path: Path) -> pv.PolyData:
    """Read a surface of any format that PyVista reads, or OFF.

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
    FileNotFoundError
        If there is no such file.
    ValueError
        If the file holds no surface.
    """
    if not path.is_file():
        raise FileNotFoundError(f"{path}: there is no such file")
    if path.suffix.lower() == ".off":
        mesh = read_off(path)
    elif path.suffix.lower() == ".ply" and ends_early(path):
        raise ValueError(f"{path}: is no surface that can be read: the file ends early")
    else:
        # What goes wrong is said below, once.
        logging.disable(logging.CRITICAL)
        try:
            with pv.vtk_verbosity("off"), warnings.catch_warnings():
                warnings.simplefilter("ignore")
                mesh = pv.read(path)
        except Exception as error:  # readers raise all kinds
            raise ValueError(f"{path}: is no surface that can be read: {error}") from None
        finally:
            logging.disable(logging.NOTSET)
        if isinstance(mesh, pv.MultiBlock):
            mesh = mesh.combine()
        if not isinstance(mesh, pv.PolyData):
            mesh = mesh.extract_surface(algorithm=None)
    if not mesh.n_faces + mesh.n_strips:
        raise ValueError(f"{path}: found no polygons, expected a closed surface")
    return mesh


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


def ends_early(path: Path) -> bool:
    """Whether a binary PLY file has fewer bytes than its header and its lists ask for.

    Parameters
    ----------
    path : pathlib.Path
        File to look at.

    Returns
    -------
    bool
        True if something is not there; False, too, of files that are no binary PLY.
    """
    data = path.read_bytes()
    try:
        order, elements, at = _header(data)
        for count, properties in elements:
            sizes = [[_SIZES[word] for word in words if word != "list"] for words in properties]
            if all(len(size) == 1 for size in sizes):
                at += count * sum(size for (size,) in sizes)
                continue
            for _ in range(count):
                if at >= len(data):
                    return True
                for first, *item in sizes:
                    if item:
                        at += item[0] * int.from_bytes(data[at : at + first], order)
                    at += first
    except (LookupError, ValueError):
        return False
    return at > len(data)


def _header(
    data: bytes,
) -> tuple[Literal["little", "big"], list[tuple[int, list[list[str]]]], int]:
    """Byte order; how many of each element, and their properties' types; where the header ends."""
    end = data.index(b"end_header")
    elements: list[tuple[int, list[list[str]]]] = []
    order: Literal["little", "big"] = "little"
    for line in data[:end].decode("ascii", "replace").splitlines():
        first, *words = line.split() or [""]
        if first == "format":
            order = _ORDERS[words[0]]
        elif first == "element":
            elements.append((int(words[1]), []))
        elif first == "property":
            elements[-1][1].append(words[:-1])
    return order, elements, data.index(b"\n", end) + 1
