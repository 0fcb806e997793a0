"""Counts in VTK's files in XML, which its readers believe before they have seen the data.

Upstream: VTK 9.7 ends the process when it cannot allocate what a header asks for, see
https://github.com/enthought/mayavi/issues/65.
"""

from __future__ import annotations

import math
import mmap
import os
import re
from typing import TYPE_CHECKING

from .errors import PackingFileError
from .vtk_arrays import LARGEST_RATIO, ArrayData
from .vtk_xml import Element, elements_of

if TYPE_CHECKING:
    from pathlib import Path

# A point or value takes so many bytes in memory, at least.
_LEAST_SIZE = 8
_CELLS = ("Verts", "Lines", "Strips", "Polys")
_COUNTS = tuple(
    f"NumberOf{what}" for what in ("Points", "Cells", *_CELLS, "Tuples", "Rows", "Components")
)
_EXTENTS = ("WholeExtent", "Extent")
_ARRAYS = ("DataArray", "Array")
_EXTENT = re.compile(r"\s*[-+]?[0-9]{1,18}(?:\s+[-+]?[0-9]{1,18}){5}\s*")
# Attributes that name further files.
_FILES = ("Source", "file", "fileName")


def check_counts(path: Path) -> list[Path]:
    """Raise a PackingFileError if a file in XML cannot hold what it counts.

    Parameters
    ----------
    path : pathlib.Path
        File to look at.

    Returns
    -------
    list[pathlib.Path]
        Files that it names and that exist.
    """
    size = path.stat().st_size
    if not size:
        return []
    with path.open("rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as data:
        try:
            elements = elements_of(data)
            _check_elements(data, elements)
        except ValueError as error:
            raise PackingFileError(f"{path}: {error}") from None
    named = [
        path.parent / element.attributes[name]
        for element in elements
        for name in _FILES
        if name in element.attributes
    ]
    return [file for file in dict.fromkeys(named) if file.is_file()]


def _check_elements(data: mmap.mmap, elements: list[Element]) -> None:
    arrays = ArrayData(data, elements)
    ratio = LARGEST_RATIO if arrays.is_compressed else 1
    memory = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    most = min(len(data) * ratio, memory // _LEAST_SIZE)
    counts = [
        element.integer(name) or 0
        for element in elements
        for name in _COUNTS
        if name in element.attributes and not element.name.startswith("PData")
    ]
    counts += [
        _points_in(element, name)
        for element in elements
        for name in _EXTENTS
        if name in element.attributes
    ]
    # Blocks up to that of an index are allocated.
    blocks = [
        element.integer("index") or 0 for element in elements if "index" in element.attributes
    ]
    wrong = [count for count in blocks if not 0 <= count <= len(data)]
    wrong += [count for count in [*counts, sum(counts)] if not 0 <= count <= most]
    if wrong:
        raise ValueError(
            f"found the count {wrong[0]:,} in a file of {len(data):,} bytes, expected no more than "
            "these hold"
        )
    for element in elements:
        if element.name not in _ARRAYS:
            continue
        values = _values_of(element)
        if values is None and _name(element) == "connectivity":
            values = _connected(element, arrays)
        if values is not None and not 0 <= values <= most:
            raise ValueError(
                f"found an array of {values:,} values in a file of {len(data):,} bytes, expected "
                "no more than these hold"
            )
        try:
            arrays.check(element, values)
        except ValueError as error:
            name = element.attributes.get("Name", "without a name")
            raise ValueError(f"array {name!r}: {error}") from None


def _extent(element: Element, name: str) -> list[int]:
    """Numbers of points along the axes of an extent."""
    text = element.attributes[name]
    if _EXTENT.fullmatch(text) is None:
        raise ValueError(f"found {name}={text[:60]!r}, expected six integers")
    bounds = list(map(int, text.split()))
    return [max(0, b - a + 1) for a, b in zip(bounds[::2], bounds[1::2], strict=True)]


def _points_in(element: Element, name: str) -> int:
    return math.prod(_extent(element, name))


def _values_of(array: Element) -> int | None:
    """Number of values of an array; None if nothing says it."""
    tuples = _tuples_of(array)
    components = array.integer("NumberOfComponents", 1) or 0
    if components < 1:
        raise ValueError(f"found {components} components of an array, expected one or more")
    return None if tuples is None else tuples * components


def _connected(array: Element, arrays: ArrayData) -> int | None:
    """Number of points in all cells, which the last of their offsets is."""
    group = array.parent
    offsets = [] if group is None else [a for a in group.children if _name(a) == "offsets"]
    if len(offsets) != 1:
        return None
    if _values_of(offsets[0]) == 0:
        return 0
    last = arrays.last_of(offsets[0])
    return 0 if last is None else last


def _name(array: Element) -> str:
    return array.attributes.get("Name", "").lower()


def _tuples_of(array: Element) -> int | None:
    group = array.parent
    if group is None:
        return None
    piece = group.parent
    if group.name == "FieldData" or piece is None or piece.name != "Piece":
        return array.integer("NumberOfTuples")
    name = _name(array)
    if group.name in ("PointData", "Points"):
        return _points_of(piece)
    if group.name == "CellData":
        return _cells_of(piece)
    if group.name == "Cells" and name in ("offsets", "types"):
        return _cells_of(piece)
    if group.name in _CELLS and name == "offsets":
        return piece.integer(f"NumberOf{group.name}", 0)
    if group.name == "Coordinates" and "Extent" in piece.attributes:
        at = group.children.index(array)
        return _extent(piece, "Extent")[at] if at < 3 else None
    return None


def _points_of(piece: Element) -> int | None:
    if "Extent" in piece.attributes:
        return _points_in(piece, "Extent")
    return piece.integer("NumberOfPoints")


def _cells_of(piece: Element) -> int | None:
    if "Extent" in piece.attributes:
        counts = _extent(piece, "Extent")
        return math.prod(max(1, count - 1) for count in counts) if all(counts) else 0
    counts = [piece.integer(f"NumberOf{kind}", 0) or 0 for kind in _CELLS]
    return piece.integer("NumberOfCells", sum(counts))
