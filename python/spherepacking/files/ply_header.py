"""What the header of a PLY file says that follows it."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal

import numpy as np

from ..printable import printable
from .surface_rows import SurfaceRows, refuse

if TYPE_CHECKING:
    from pathlib import Path

_KINDS = {
    **{"char": "i1", "int8": "i1", "uchar": "u1", "uint8": "u1"},
    **{"short": "i2", "int16": "i2", "ushort": "u2", "uint16": "u2"},
    **{"int": "i4", "int32": "i4", "uint": "u4", "uint32": "u4"},
    **{"float": "f4", "float32": "f4", "double": "f8", "float64": "f8"},
}
_ORDERS: dict[bytes, Literal["", "<", ">"]] = {
    b"ascii": "",
    b"binary_little_endian": "<",
    b"binary_big_endian": ">",
}
# Lines that headers of whole files have at most; their ends may be those of any system.
_LONGEST = 1 << 20


@dataclass(frozen=True)
class PlyProperty:
    """A number, or a list of numbers, of each thing of a kind.

    Attributes
    ----------
    name : str
        Name.
    kind : numpy.dtype
        Type of the numbers.
    count : numpy.dtype or None
        Type of how many numbers a list has; None for a single number.
    """

    name: str
    kind: np.dtype
    count: np.dtype | None


@dataclass(frozen=True)
class PlyElement:
    """Things of a kind, such as all points.

    Attributes
    ----------
    name : str
        Name, such as ``vertex``.
    count : int
        How many.
    properties : list[PlyProperty]
        What each of them has.
    """

    name: str
    count: int
    properties: list[PlyProperty] = field(default_factory=list)


@dataclass(frozen=True)
class PlyHeader:
    """A header.

    Attributes
    ----------
    order : {"", "<", ">"}
        Order of bytes, or none for text.
    elements : list[PlyElement]
        What follows, in its order.
    size : int
        Bytes of the header.
    lines : int
        Lines of the header.
    """

    order: Literal["", "<", ">"]
    elements: list[PlyElement]
    size: int
    lines: int


def read_ply_header(path: Path, data: bytes) -> PlyHeader:
    """Read the header of a PLY file.

    Parameters
    ----------
    path : pathlib.Path
        File, for errors.
    data : bytes
        Its contents.

    Returns
    -------
    PlyHeader
        What it says.

    Raises
    ------
    SurfaceFileError
        If it is none.
    """
    end_of_line = next((e for e in (b"\r\n", b"\n", b"\r") if data.startswith(b"ply" + e)), None)
    if end_of_line is None:
        refuse(path, "no line ply at its begin", "a PLY file")
    end = data.find(end_of_line + b"end_header" + end_of_line, 0, _LONGEST)
    if end < 0:
        refuse(path, "no line end_header", "a PLY file, whose header ends with it")
    rows = SurfaceRows(path, data[:end])
    rows.next_row()
    words = rows.next_row()
    if len(words) != 3 or words[0] != b"format" or words[1] not in _ORDERS or words[2] != b"1.0":
        rows.refuse("format ascii, binary_little_endian or binary_big_endian, and 1.0")
    order = _ORDERS[words[1]]
    elements: list[PlyElement] = []
    for words in rows:
        if words[0] == b"element" and len(words) == 3 and words[2].isdigit():
            count = rows.integers(words[2:], "how many there are")[0]
            elements.append(PlyElement(words[1].decode("utf-8", "replace"), count))
        elif words[0] == b"property" and elements and _is_property(words):
            elements[-1].properties.append(_property(words, order))
        elif words[0] not in (b"comment", b"obj_info"):
            rows.refuse("element NAME COUNT, property TYPE NAME or comment")
    size = end + 2 * len(end_of_line) + len(b"end_header")
    header = PlyHeader(order, elements, size, len(data[:size].splitlines()))
    _check(path, header)
    return header


def _is_property(words: list[bytes]) -> bool:
    kinds = [word.decode("ascii", "replace") for word in words[1:-1]]
    if kinds[:1] == ["list"]:
        return len(kinds) == 3 and _KINDS.get(kinds[1], "f")[0] in "iu" and kinds[2] in _KINDS
    return len(kinds) == 1 and kinds[0] in _KINDS


def _property(words: list[bytes], order: str) -> PlyProperty:
    kinds = [word.decode() for word in words[1:-1]]
    name = words[-1].decode("utf-8", "replace")
    of_numbers = np.dtype(order + _KINDS[kinds[-1]])
    of_count = np.dtype(order + _KINDS[kinds[1]]) if len(kinds) == 3 else None
    return PlyProperty(name, of_numbers, of_count)


def _check(path: Path, header: PlyHeader) -> None:
    """Refuse what cannot be told apart, and counts of nothing."""
    names = [element.name for element in header.elements]
    for things in (names, *([p.name for p in e.properties] for e in header.elements)):
        if len(set(things)) < len(things):
            refuse(path, "the same name twice in its header", "each once")
    for element in header.elements:
        if element.count and not element.properties:
            refuse(
                path,
                f"the element {printable(element.name, 40)} without properties",
                "one at least",
            )
