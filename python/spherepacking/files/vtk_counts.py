"""Counts in the files of VTK, which its readers believe before they have seen the data.

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

if TYPE_CHECKING:
    from pathlib import Path

# How many bytes one byte of zlib may stand for.
_LARGEST_RATIO = 1032
# A point or value takes so many bytes in memory, at least.
_LEAST_SIZE = 8
_XML = re.compile(rb"NumberOf(?:Points|Cells|Verts|Lines|Strips|Polys|Tuples)\s*=\s*[\"'](-?\d+)")
_EXTENT = re.compile(rb"Extent\s*=\s*[\"'](-?\d+(?:\s+-?\d+){5})")
_LEGACY = re.compile(
    rb"^[ \t]*(?:POINTS|POINT_DATA|CELL_DATA|CELLS|CELL_TYPES|VERTICES|LINES|POLYGONS|FIELD \S+"
    rb"|TRIANGLE_STRIPS|[XYZ]_COORDINATES|LOOKUP_TABLE \S+|DIMENSIONS|OFFSETS|CONNECTIVITY)"
    rb"[ \t]+(-?\d+(?:[ \t]+-?\d+){0,2})",
    re.MULTILINE | re.IGNORECASE,
)
_FIELD = re.compile(rb"^\S+[ \t]+(-?\d+)[ \t]+(-?\d+)[ \t]+[a-z_]+\d*[ \t]*\r?$", re.MULTILINE)


def check_counts(path: Path) -> None:
    """Raise a PackingFileError if a file of VTK cannot hold what its header counts.

    Parameters
    ----------
    path : pathlib.Path
        File in XML or of the legacy format; others are not looked at.
    """
    size = path.stat().st_size
    if not size:
        return
    with path.open("rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as data:
        head = data[:4096]
        if b"<VTKFile" in head:
            counts = _in_xml(data)
            ratio = _LARGEST_RATIO if b"compressor" in head else 1
        elif head.startswith(b"# vtk DataFile"):
            counts, ratio = _in_legacy(data), 1
        else:
            return
    memory = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    most = min(size * ratio, memory // _LEAST_SIZE)
    wrong = [count for count in counts if not 0 <= count <= most]
    if wrong:
        raise PackingFileError(
            f"{path}: found the count {wrong[0]:,} in a file of {size:,} bytes, expected no more "
            "than these hold"
        )


def _in_xml(data: mmap.mmap) -> list[int]:
    """Counts of a file in XML; what is appended raw is no text, but has no attributes either."""
    counts = [int(match[1]) for match in _XML.finditer(data)]
    for match in _EXTENT.finditer(data):
        low, high = (list(map(int, match[1].split()[i::2])) for i in (0, 1))
        counts.append(math.prod(max(0, b - a + 1) for a, b in zip(low, high, strict=True)))
    return [sum(counts) if min(counts, default=0) >= 0 else min(counts), *counts]


def _in_legacy(data: mmap.mmap) -> list[int]:
    """Counts of a file of the legacy format."""
    counts: list[int] = []
    for match in _LEGACY.finditer(data):
        numbers = list(map(int, match[1].split()))
        counts += numbers
        if b"DIMENSIONS" in match[0].upper():
            counts.append(math.prod(numbers))
    for match in _FIELD.finditer(data):
        counts += [int(match[1]), int(match[2]), int(match[1]) * int(match[2])]
    return counts
