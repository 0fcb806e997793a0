"""Whether a PLY file ends early, on which VTK's reader crashes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

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
