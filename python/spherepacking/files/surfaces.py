"""Closed surfaces from files, for packing: of any format that PyVista reads, and OFF."""

from __future__ import annotations

import logging
import re
import warnings
from typing import TYPE_CHECKING, Literal, NoReturn

import numpy as np
import pyvista as pv

if TYPE_CHECKING:
    from pathlib import Path


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
        raise ValueError(f"{path}: found a file that ends early, expected a whole surface")
    else:
        mesh = _read_by_pyvista(path)
    if not mesh.n_faces + mesh.n_strips:
        raise ValueError(f"{path}: found no polygons, expected a closed surface")
    return mesh


def _read_by_pyvista(path: Path) -> pv.PolyData:
    """Read a surface of a format that PyVista knows."""
    # VTK and PyVista print and log what goes wrong besides raising it; here it is raised alone.
    logging.disable(logging.CRITICAL)
    try:
        with pv.vtk_verbosity("off"), warnings.catch_warnings():
            warnings.simplefilter("ignore")
            mesh = pv.read(path)
    except Exception as error:  # readers raise all kinds
        raise ValueError(f"{path}: found no surface that can be read: {error}") from None
    finally:
        logging.disable(logging.NOTSET)
    if isinstance(mesh, pv.MultiBlock):
        mesh = mesh.combine()
    return mesh if isinstance(mesh, pv.PolyData) else mesh.extract_surface(algorithm=None)


# --- OFF ------------------------------------------------------------------------------------------


def read_off(path: Path) -> pv.PolyData:
    """Read an OFF file in text: points and polygons; colours and normals are left out.

    VTK's reader refuses files with colours, normals or comments.

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
    rows = [(i, tokens) for i, tokens in rows if tokens]
    # Some files go on with the numbers in the first line, even without a space.
    head = re.fullmatch(r"(?:ST)?C?N?OFF(\d*)", rows[0][1][0]) if rows else None
    if head is None:
        raise ValueError(f"{path}: found no line that begins OFF, expected an OFF file")
    first, tokens = rows.pop(0)
    counts = [head[1], *tokens[1:]] if head[1] else tokens[1:]
    if not counts and rows:
        first, counts = rows.pop(0)
    try:
        n_points, n_faces = int(counts[0]), int(counts[1])
    except (IndexError, ValueError):
        _refuse_line(path, first, counts, "how many points and polygons there are")
    if min(n_points, n_faces) < 0 or len(rows) < n_points + n_faces:
        raise ValueError(
            f"{path}: found {len(rows)} lines after that with the numbers, expected {n_points} "
            f"points and {n_faces} polygons"
        )
    points = _off_points(path, rows[:n_points])
    faces = _off_faces(path, rows[n_points : n_points + n_faces], n_points)
    return pv.PolyData(points, faces=faces or None)


def _off_points(path: Path, rows: list[tuple[int, list[str]]]) -> np.ndarray:
    """Points (n, 3) from lines of an OFF file."""
    points = np.empty((len(rows), 3))
    for i, (number, tokens) in enumerate(rows):
        try:
            points[i] = [float(tokens[axis]) for axis in range(3)]
        except (IndexError, ValueError):
            _refuse_line(path, number, tokens, "three coordinates")
    return points


def _off_faces(path: Path, rows: list[tuple[int, list[str]]], n_points: int) -> list[int]:
    """Polygons from lines of an OFF file, each its number of points followed by them."""
    faces: list[int] = []
    for number, tokens in rows:
        try:
            ids = [int(token) for token in tokens[: 1 + int(tokens[0])]]
        except ValueError:
            ids = []
        good = len(ids) > 1 and len(ids) == 1 + ids[0]
        if not good or not 0 <= min(ids[1:]) <= max(ids[1:]) < n_points:
            expected = f"how many points a polygon has, and as many from 0 to {n_points - 1}"
            _refuse_line(path, number, tokens, expected)
        faces += ids
    return faces


def _refuse_line(path: Path, line: int, tokens: list[str], expected: str) -> NoReturn:
    found = " ".join(tokens)[:60] or "nothing"
    raise ValueError(f"{path}:{line}: found {found}, expected {expected}") from None


# --- PLY ------------------------------------------------------------------------------------------

_SIZES = {
    **dict.fromkeys(("char", "uchar", "int8", "uint8"), 1),
    **dict.fromkeys(("short", "ushort", "int16", "uint16"), 2),
    **dict.fromkeys(("int", "uint", "float", "int32", "uint32", "float32"), 4),
    **dict.fromkeys(("double", "float64"), 8),
}
_BYTE_ORDERS: dict[str, Literal["little", "big"]] = {
    "binary_little_endian": "little",
    "binary_big_endian": "big",
}


def ends_early(path: Path) -> bool:
    """Whether a binary PLY file has fewer bytes than its header and its lists ask for.

    Upstream: VTK 9.7's vtkPLYReader does not notice that and crashes, as it is known to for files
    in text: https://github.com/f3d-app/f3d/issues/618.

    Parameters
    ----------
    path : pathlib.Path
        File to look at.

    Returns
    -------
    bool
        True if something is not there; False, too, of files that are not binary PLY.
    """
    data = path.read_bytes()
    try:
        order, elements, at = _ply_header(data)
        for count, properties in elements:
            sizes = [[_SIZES[kind] for kind in kinds if kind != "list"] for kinds in properties]
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


def _ply_header(
    data: bytes,
) -> tuple[Literal["little", "big"], list[tuple[int, list[list[str]]]], int]:
    """Byte order; how many of each element, and their properties' types; where the header ends."""
    end = data.index(b"end_header")
    elements: list[tuple[int, list[list[str]]]] = []
    order: Literal["little", "big"] = "little"
    for line in data[:end].decode("ascii", "replace").splitlines():
        first, *tokens = line.split() or [""]
        if first == "format":
            order = _BYTE_ORDERS[tokens[0]]
        elif first == "element":
            elements.append((int(tokens[1]), []))
        elif first == "property":
            elements[-1][1].append(tokens[:-1])
    return order, elements, data.index(b"\n", end) + 1
