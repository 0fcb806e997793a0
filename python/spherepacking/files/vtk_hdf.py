"""Heaps of texts in VTK's files in HDF5, in which that library may search for ever.

Upstream: HDF5 1.14 walks a collection of the global heap by the sizes that its objects say, and
does not come to an end where these do not fill it ("HDF5 File Format Specification Version 3.0",
The HDF Group, III.E).
"""

from __future__ import annotations

import mmap
from typing import TYPE_CHECKING

from .errors import PackingFileError

if TYPE_CHECKING:
    from pathlib import Path

_SIGNATURE = b"GCOL\x01"
# Of a collection and of each object: index, references and four bytes, then the size.
_HEAD = 16


def check_heaps(path: Path) -> None:
    """Raise a PackingFileError if objects do not fill a collection of the global heap.

    Parameters
    ----------
    path : pathlib.Path
        File in HDF5 with sizes of 8 bytes, as VTK writes them.
    """
    if not path.stat().st_size:
        return
    with path.open("rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as data:
        at = data.find(_SIGNATURE)
        while at >= 0:
            size = int.from_bytes(data[at + 8 : at + _HEAD], "little")
            if at + size <= len(data) and not _is_filled(data, at + _HEAD, at + size):
                raise PackingFileError(
                    f"{path}: found texts at byte {at} that do not fill the {size:,} bytes of "
                    "their heap, expected such as do"
                )
            at = data.find(_SIGNATURE, at + 1)


def _is_filled(data: mmap.mmap, at: int, end: int) -> bool:
    """Whether objects go on from one place to another; the one of index 0 is free space."""
    while at + _HEAD <= end:
        index = int.from_bytes(data[at : at + 2], "little")
        size = int.from_bytes(data[at + 8 : at + _HEAD], "little")
        if index == 0:
            # Its size has its head in it.
            return at + size == end
        at += _HEAD + (size + 7) // 8 * 8
    return at <= end
