"""What follows the header of a PLY file, in binary or in text."""

from __future__ import annotations

from array import array
from typing import TYPE_CHECKING

import numpy as np

from ..printable import printable
from .surface_rows import SurfaceRows, refuse

if TYPE_CHECKING:
    from pathlib import Path
    from typing import NoReturn

    from .ply_header import PlyElement, PlyHeader

_LARGEST = 2**62  # so that it is an integer of 64 bits


class BinaryBody:
    """Reads what follows a header in binary, element by element.

    Parameters
    ----------
    path : pathlib.Path
        File, for errors.
    data : bytes
        Its contents.
    header : PlyHeader
        What its header says.
    """

    def __init__(self, path: Path, data: bytes, header: PlyHeader) -> None:
        self._path, self._data = path, data
        self._at = header.size

    def end(self) -> None:
        """Refuse what follows."""
        if self._data[self._at :].strip():
            more = len(self._data) - self._at
            refuse(self._path, f"{more:,} bytes after all that its header counts", "none")

    def numbers(self, element: PlyElement, names: list[str]) -> np.ndarray:
        """Read columns of numbers (n, len(names))."""
        kind = np.dtype([(p.name, p.kind) for p in element.properties])
        size = element.count * kind.itemsize
        if self._at + size > len(self._data):
            self._refuse_early(element)
        records = (
            np.frombuffer(self._data, kind, element.count, self._at) if size else np.empty(0, kind)
        )
        self._at += size
        return (
            np.column_stack([records[name].astype(float) for name in names]) if names else records
        )

    def lists(self, element: PlyElement, names: list[str]) -> np.ndarray:
        """One list after the other, each after its number; or rows where all have the same."""
        if not element.count:
            return np.empty(0, int)
        start = self._at
        _, sizes = self._one(element, names)
        self._at = start
        rows = self._rows(element, sizes, names)
        if rows is not None:
            return rows
        numbers = array("q")
        for _ in range(element.count):
            of_names, _ = self._one(element, names)
            numbers.extend(of_names)
        return np.array(numbers, np.int64)

    def _rows(self, element: PlyElement, sizes: list[int], names: list[str]) -> np.ndarray | None:
        """Lists as rows, each after its number, if those of all have these lengths; else None."""
        fields: list[tuple[str, np.dtype] | tuple[str, np.dtype, tuple[int]]] = []
        for p, size in zip(element.properties, sizes, strict=True):
            if p.count is None:
                fields.append((p.name, p.kind))
            else:
                fields += [(f"count of {p.name}", p.count), (p.name, p.kind, (size,))]
        kind = np.dtype(fields)
        end = self._at + element.count * kind.itemsize
        if end > len(self._data):
            return None
        records = np.frombuffer(self._data, kind, element.count, self._at)
        for p, size in zip(element.properties, sizes, strict=True):
            if p.count is not None and (records[f"count of {p.name}"] != size).any():
                return None
        self._at = end
        if not names:
            return np.empty(0, np.int64)
        ids = records[names[0]].astype(np.int64)
        return np.column_stack([np.full(len(ids), ids.shape[1]), ids])

    def _one(self, element: PlyElement, names: list[str]) -> tuple[list[int], list[int]]:
        """The list of that name of one thing, after its number; and the lengths of its lists."""
        of_names: list[int] = []
        sizes = []
        for p in element.properties:
            size = 1
            if p.count is not None:
                size = int(self._take(element, p.count, 1)[0])
                if size < 0:
                    refuse(self._path, f"a list of {size} numbers at byte {self._at}", "0 or more")
            numbers = self._take(element, p.kind, size)
            if p.name in names:
                of_names = [size, *numbers.tolist()]
                if size < 3:
                    self._refuse_small(element, size)
            sizes.append(size)
        return of_names, sizes

    def _take(self, element: PlyElement, kind: np.dtype, count: int) -> np.ndarray:
        start, self._at = self._at, self._at + count * kind.itemsize
        if self._at > len(self._data):
            self._refuse_early(element)
        return np.frombuffer(self._data, kind, count, start)

    def _refuse_early(self, element: PlyElement) -> NoReturn:
        refuse(
            self._path,
            "a file that ends early",
            f"its header's {element.count:,} of element {printable(element.name, 40)}",
        )

    def _refuse_small(self, element: PlyElement, size: int) -> NoReturn:
        refuse(
            self._path, f"an element {printable(element.name, 40)} of {size} points", "3 or more"
        )


class TextBody:
    """Reads what follows a header in text, element by element: each thing is a row.

    Parameters
    ----------
    path : pathlib.Path
        File, for errors.
    data : bytes
        Its contents.
    header : PlyHeader
        What its header says.
    """

    def __init__(self, path: Path, data: bytes, header: PlyHeader) -> None:
        self._rows = SurfaceRows(path, data[header.size :], first=header.lines + 1)

    def end(self) -> None:
        """Refuse what follows."""
        if self._rows.next_row():
            self._rows.refuse("nothing after all that the header counts")

    def numbers(self, element: PlyElement, names: list[str]) -> np.ndarray:
        """Read columns of numbers (n, len(names))."""
        at = {p.name: i for i, p in enumerate(element.properties)}
        chosen = [at[name] for name in names]
        expected = f"{len(at)} numbers of element {printable(element.name, 40)}"
        numbers = array("d")
        for _ in range(element.count):
            words = self._rows.next_row()
            if len(words) != len(at):
                self._rows.refuse(expected)
            row = self._rows.numbers(words, expected)
            numbers.extend([row[i] for i in chosen])
        return np.array(numbers).reshape(element.count, len(names))

    def lists(self, element: PlyElement, names: list[str]) -> np.ndarray:
        """Read one list after the other, each after its number."""
        name = printable(element.name, 40)
        expected = f"what the header says of element {name}, lists after their lengths"
        numbers = array("q")
        for _ in range(element.count):
            words = self._rows.next_row()
            at = 0
            for p in element.properties:
                size = 1
                if p.count is not None:
                    size = self._rows.integers(words[at : at + 1], expected)[0]
                    at += 1
                part = words[at : at + size] if size >= 0 else []
                if len(part) != size or (p.name in names and size < 3):
                    self._rows.refuse(expected)
                if p.name in names:
                    numbers.append(size)
                    ids = self._rows.integers(part, expected)
                    if max(map(abs, ids)) > _LARGEST:
                        self._rows.refuse(expected)
                    numbers.extend(ids)
                else:
                    self._rows.numbers(part, expected)
                at += size
            if at != len(words):
                self._rows.refuse(expected)
        return np.array(numbers)
