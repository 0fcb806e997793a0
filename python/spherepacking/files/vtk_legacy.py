"""Whether a legacy file of VTK holds all the values that it announces.

Upstream: VTK 9.7's readers of these files take what memory happens to hold for values that a file
ends before, and end the process when they cannot allocate what a count asks for, see
https://github.com/enthought/mayavi/issues/65.
"""

from __future__ import annotations

import mmap
import re
from typing import TYPE_CHECKING, NoReturn

import numpy as np

from ..printable import quoted
from .errors import PackingFileError

if TYPE_CHECKING:
    from pathlib import Path

# Bytes that a value takes in a binary file; vtkIdType is written as int.
_SIZES = {
    **dict.fromkeys((b"char", b"signed_char", b"unsigned_char"), 1),
    **dict.fromkeys((b"short", b"unsigned_short"), 2),
    **dict.fromkeys((b"int", b"unsigned_int", b"float", b"vtkidtype"), 4),
    **dict.fromkeys((b"long", b"unsigned_long", b"double"), 8),
    **{
        b"vtktype%sint%d" % (sign, bits): bits // 8
        for sign in (b"", b"u")
        for bits in (8, 16, 32, 64)
    },
}
_TEXTS = (b"string", b"utf8_string", b"variant")
_CELLS = (b"vertices", b"lines", b"polygons", b"triangle_strips", b"cells")
# Attributes NAME TYPE of so many components.
_ATTRIBUTES = {
    b"vectors": 3,
    b"normals": 3,
    b"tensors": 9,
    b"tensors6": 6,
    b"global_ids": 1,
    b"pedigree_ids": 1,
    b"edge_flags": 1,
}
_WORD = re.compile(rb"\S+")
_CHUNK = 1 << 20


def check_legacy(path: Path) -> None:
    """Raise a PackingFileError if a legacy file ends before all values that it announces.

    Parameters
    ----------
    path : pathlib.Path
        File to look at; files of other formats are left to their readers.
    """
    if not path.stat().st_size:
        return
    with path.open("rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as data:
        if data[:14] == b"# vtk DataFile":
            _Walk(path, data).check()


class _Walk:
    """Goes through a file keyword by keyword."""

    def __init__(self, path: Path, data: mmap.mmap) -> None:
        self._path, self._data = path, data
        self._at, self._binary = 0, False
        version = re.match(rb"# vtk DataFile Version[ \t]+(\d{1,3})\.\d+\s", data)
        if version is None:
            # Which of two ways the cells are written in depends on it.
            self._refuse(quoted(data[:40].splitlines()[0]), "# vtk DataFile Version and its number")
        self._offsets = int(version[1]) >= 5
        title = data.find(b"\n", data.find(b"\n") + 1)
        self._at = title + 1 if title > 0 else len(data)
        self._tuples = 0

    def check(self) -> None:
        """Look at everything, up to a keyword that is not known here."""
        self._binary = self._word().lower() == b"binary"
        passed: set[bytes] = set()
        while (word := self._word().lower()) and self._section(word):
            passed.add(word)
        if not passed & {b"points", b"dimensions"}:
            self._refuse(quoted(word, 30), "POINTS or DIMENSIONS")

    def _section(self, word: bytes) -> bool:
        """Pass what follows a keyword; False if that is not known."""
        if word in (b"dataset", b"dimensions", b"extent", b"spacing", b"origin", b"aspect_ratio"):
            self._line()
        elif word == b"points":
            self._values(3 * self._count(), self._word())
        elif word in (b"x_coordinates", b"y_coordinates", b"z_coordinates"):
            self._values(self._count(), self._word())
        elif word in _CELLS:
            self._cells()
        elif word == b"cell_types":
            self._values(self._count(), b"int")
        elif word in (b"point_data", b"cell_data"):
            self._tuples = self._count()
        elif word in _ATTRIBUTES:
            self._word()
            self._values(_ATTRIBUTES[word] * self._tuples, self._word())
        elif word == b"scalars":
            self._scalars()
        elif word == b"color_scalars":
            self._word()
            self._values(self._count() * self._tuples, b"unsigned_char")
        elif word == b"texture_coordinates":
            self._word()
            components = self._count()
            self._values(components * self._tuples, self._word())
        elif word == b"lookup_table":
            self._word()
            self._values(4 * self._count(), b"unsigned_char")
        elif word == b"field":
            self._field()
        elif word == b"metadata":
            self._metadata()
        else:
            return False
        return True

    def _cells(self) -> None:
        offsets, size = self._count(), self._count()
        if not self._offsets:
            self._values(size, b"int")
            return
        for count in (offsets, size):
            if self._word().lower() not in (b"offsets", b"connectivity"):
                self._refuse("no offsets and connectivity of cells", "them")
            self._values(count, self._word())

    def _scalars(self) -> None:
        self._word()
        kind = self._word()
        components = self._line().strip() or b"1"
        if not components.isdigit():
            self._refuse("no number of components of scalars", "one")
        before = self._at
        if self._word().lower() == b"lookup_table":
            self._word()
        else:
            self._at = before
        self._values(int(components) * self._tuples, kind)

    def _field(self) -> None:
        self._word()
        for _ in range(self._count()):
            if self._word().lower() == b"metadata":
                self._metadata()
                self._word()
            components, tuples = self._count(), self._count()
            self._values(components * tuples, self._word())

    def _metadata(self) -> None:
        """Pass lines up to an empty one."""
        self._line()
        while self._at < len(self._data) and self._line().strip():
            pass

    def _values(self, count: int, kind: bytes) -> None:
        """Pass so many values of a type."""
        kind = kind.lower()
        if kind in _TEXTS:
            self._texts(count)
        elif kind != b"bit" and kind not in _SIZES:
            self._refuse(f"the type {quoted(kind, 30)}", "one of VTK")
        elif self._binary:
            self._line()
            size = (count + 7) // 8 if kind == b"bit" else count * _SIZES[kind]
            if self._at + size > len(self._data):
                self._refuse_early(count)
            self._at += size
        else:
            self._numbers(count)

    def _numbers(self, count: int) -> None:
        """Pass so many words, which are counted in chunks."""
        left, before = count, True  # whether a space was before
        while left > 0:
            chunk = np.frombuffer(self._data[self._at : self._at + _CHUNK], np.uint8)
            if not chunk.size:
                self._refuse_early(count)
            space = chunk <= 32
            first = ~space & np.concatenate([[before], space[:-1]])
            found = int(first.sum())
            if found >= left:
                # The word itself is passed with the next one that is looked for.
                start = self._at + int(np.flatnonzero(first)[left - 1])
                match = _WORD.match(self._data, start)
                self._at = match.end() if match else start
                if self._at == len(self._data):
                    # The number may have been longer.
                    self._refuse("its end right after a number", "a line end")
                return
            left -= found
            before = bool(space[-1])
            self._at += chunk.size

    def _texts(self, count: int) -> None:
        """Pass so many texts: lines, or in a binary file with their lengths before them."""
        self._line()
        for _ in range(count):
            if self._at >= len(self._data):
                self._refuse_early(count)
            if not self._binary:
                self._line()
                continue
            # The two highest bits say how many bytes the length has.
            size = (8, 4, 2, 1)[self._data[self._at] >> 6]
            length = int.from_bytes(self._data[self._at : self._at + size], "big")
            self._at += size + (length & ((1 << (8 * size - 2)) - 1))
        if self._at > len(self._data):
            self._refuse_early(count)

    def _word(self) -> bytes:
        """Pass blanks and a word, and return it; empty at the end."""
        match = _WORD.search(self._data, self._at)
        self._at = len(self._data) if match is None else match.end()
        return b"" if match is None else match[0]

    def _line(self) -> bytes:
        """Pass the rest of a line, and return it."""
        end = self._data.find(b"\n", self._at)
        start, self._at = self._at, len(self._data) if end < 0 else end + 1
        return self._data[start : self._at]

    def _count(self) -> int:
        word = self._word()
        if not word:
            self._refuse("its end", "a count")
        if not word.isdigit() or len(word) > 18:
            self._refuse(quoted(word, 30), "a count")
        return int(word)

    def _refuse_early(self, count: int) -> NoReturn:
        self._refuse("its end", f"{count:,} values")

    def _refuse(self, found: str, expected: str) -> NoReturn:
        line = self._data[: self._at].count(b"\n") + 1
        place = f" at byte {self._at}" if self._binary else f", line {line}"
        raise PackingFileError(f"{self._path}{place}: found {found}, expected {expected}")
