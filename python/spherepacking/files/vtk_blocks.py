"""Heads of compressed arrays in VTK's files in XML, which its readers believe.

Upstream: VTK 9.7 ends the process when it cannot allocate what they ask for, see
https://github.com/enthought/mayavi/issues/65.
"""

from __future__ import annotations

import base64
import binascii
import re
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    import mmap
    from collections.abc import Iterator

_FORMAT = re.compile(rb"<DataArray\b([^>]*)>\s*")
_OFFSET = re.compile(rb"\boffset\s*=\s*[\"'](\d+)")
_ENCODING = re.compile(rb"<AppendedData[^>]*encoding\s*=\s*[\"'](\w+)[^>]*>\s*_")


def sizes_in_heads(data: mmap.mmap, end: int) -> Iterator[tuple[int, int]]:
    """Bytes that compressed arrays take.

    Parameters
    ----------
    data : mmap.mmap
        File that names a compressor.
    end : int
        Where what is appended begins, or the end of the file.

    Yields
    ------
    tuple[int, int]
        Of each array, the bytes in the file and those that they stand for.
    """
    head = data[:4096]
    word = 8 if re.search(rb"header_type\s*=\s*[\"']UInt64", head) else 4
    order = ">" if b"BigEndian" in head else "<"
    appended = _ENCODING.search(data, end)
    for tag in _FORMAT.finditer(data, 0, end):
        offset = _OFFSET.search(tag[1])
        if b"binary" in tag[1]:
            start, raw = tag.end(), False
        elif appended is not None and offset is not None:
            start, raw = appended.end() + int(offset[1]), appended[1] == b"raw"
        else:
            continue
        # Number of blocks, the size of each, and that of the last; then those in the file.
        first = _words(data, start, 3, f"{order}u{word}", raw=raw)
        if len(first) < 3:
            continue
        blocks, size, _ = map(int, first)
        taken = blocks * word
        if taken < len(data):
            taken += sum(_words(data, start, 3 + blocks, f"{order}u{word}", raw=raw)[3:].tolist())
        yield taken, blocks * size


def _words(data: mmap.mmap, start: int, count: int, kind: str, *, raw: bool) -> np.ndarray:
    """So many numbers from there on, or none if they are not there."""
    size = count * np.dtype(kind).itemsize
    if raw:
        found = data[start : start + size]
    else:
        try:
            found = base64.b64decode(data[start : start + 4 * ((size + 2) // 3)], validate=True)
        except binascii.Error:
            found = b""
    return np.frombuffer(found[:size], kind) if len(found) >= size else np.empty(0, kind)
