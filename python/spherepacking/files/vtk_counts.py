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
from .vtk_blocks import sizes_in_heads

if TYPE_CHECKING:
    from pathlib import Path

# How many bytes one byte of zlib may stand for.
_LARGEST_RATIO = 1032
# A point or value takes so many bytes in memory, at least.
_LEAST_SIZE = 8
# Writers ask for blocks of 32 to 64 KiB, and of some MiB at most.
_LARGEST_BLOCK = 256 << 20
_XML = re.compile(
    rb"NumberOf(?:Points|Cells|Verts|Lines|Strips|Polys|Tuples)\s*=\s*[\"']\s*([-+]?\d+)"
)
_PIECE = re.compile(rb"NumberOf(Points|Cells|Verts|Lines|Strips|Polys)\s*=\s*[\"']\s*\+?(\d+)")
# What arrays belong to, and arrays.
_TAG = re.compile(rb"<(Piece|PointData|CellData|Points|FieldData|Coordinates|P?DataArray)\b([^>]*)")
_COMPONENTS = re.compile(rb"NumberOfComponents\s*=\s*[\"']\s*([-+]?\d+)")
_EXTENT = re.compile(rb"Extent\s*=\s*[\"']\s*([-+]?\d+(?:\s+[-+]?\d+){5})")


def check_counts(path: Path) -> None:
    """Raise a PackingFileError if a file in XML cannot hold what it counts.

    Parameters
    ----------
    path : pathlib.Path
        File to look at; files of other formats are left to their readers.
    """
    size = path.stat().st_size
    if not size:
        return
    with path.open("rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as data:
        head = data[:4096]
        if b"<VTKFile" not in head:
            return
        appended = data.find(b"<AppendedData")
        end = len(data) if appended < 0 else appended
        counts = _in_xml(data, end)
        compressed = b"compressor" in head
        ratio = _LARGEST_RATIO if compressed else 1
        heads = list(sizes_in_heads(data, end)) if compressed else []
    memory = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    most = min(size * ratio, memory // _LEAST_SIZE)
    wrong = [count for count in counts if not 0 <= count <= most]
    wrong += [taken for taken, _ in heads if taken > size]
    # Of a short array the whole of a block is claimed.
    wrong += [whole for _, whole in heads if whole > max(size * ratio, _LARGEST_BLOCK)]
    if wrong:
        raise PackingFileError(
            f"{path}: found the count {wrong[0]:,} in a file of {size:,} bytes, expected no more "
            "than these hold"
        )


def _in_xml(data: mmap.mmap, end: int) -> list[int]:
    """Counts of a file in XML; what is appended, from `end` on, has none."""
    counts = [int(match[1]) for match in _XML.finditer(data, 0, end)]
    for match in _EXTENT.finditer(data, 0, end):
        low, high = (list(map(int, match[1].split()[i::2])) for i in (0, 1))
        counts.append(math.prod(max(0, b - a + 1) for a, b in zip(low, high, strict=True)))
    counts += _values_of_arrays(data, end)
    return [sum(counts) if min(counts, default=0) >= 0 else min(counts), *counts]


def _values_of_arrays(data: mmap.mmap, end: int) -> list[int]:
    """Numbers of values of arrays: their components, times the points or cells they are of."""
    found = []
    points = cells = tuples = 1
    for tag in _TAG.finditer(data, 0, end):
        name, attributes = tag[1], tag[2]
        if name == b"Piece":
            counts = {kind: int(number) for kind, number in _PIECE.findall(attributes)}
            points = max(1, counts.pop(b"Points", 1))
            cells = max(1, sum(counts.values()))
        elif not name.endswith(b"DataArray"):
            tuples = {b"PointData": points, b"Points": points, b"CellData": cells}.get(name, 1)
        elif components := _COMPONENTS.search(attributes):
            found.append(int(components[1]) * tuples)
    return found
