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
from .vtk_numbers import NoNumber, numbers

if TYPE_CHECKING:
    from pathlib import Path

# What values are in a binary file; vtkIdType is written as int.
_KINDS = {
    **dict.fromkeys((b"char", b"signed_char"), ">i1"),
    **{b"unsigned_char": ">u1", b"short": ">i2", b"unsigned_short": ">u2"},
    **{b"int": ">i4", b"vtkidtype": ">i4", b"unsigned_int": ">u4", b"float": ">f4"},
    **{b"long": ">i8", b"unsigned_long": ">u8", b"double": ">f8", b"bit": ">u1"},
    **{
        b"vtktype%sint%d" % (sign, bits): f">{kind}{bits // 8}"
        for sign, kind in ((b"", "i"), (b"u", "u"))
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
_NO_VALUES = np.empty(0, np.int64)


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
        version = re.match(rb"# vtk DataFile Version\s+(\d)\.\d{1,2}(?!\d)", data)
        if version is None:
            raise PackingFileError(
                f"{path}, line 1: found {quoted(data[:40])}, expected "
                "'# vtk DataFile Version 3.0' or the like"
            )
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
        """Pass cells, whose lengths VTK believes."""
        cells, size = self._count(), self._count()
        if not self._offsets:
            values = self._values(size, b"int", keep=True)
            if not _are_cells(values, cells):
                self._refuse(f"lengths of cells that do not fill {size:,} values", "such as do")
            return
        offsets = np.empty(0, np.int64)
        for count, name in ((cells, b"offsets"), (size, b"connectivity")):
            if self._word().lower() != name:
                self._refuse("no offsets and connectivity of cells", "them")
            values = self._values(count, self._word(), keep=name == b"offsets")
            offsets = values if name == b"offsets" else offsets
        if cells and (offsets[0] != 0 or (np.diff(offsets) < 0).any() or offsets[-1] != size):
            self._refuse("offsets of cells that do not end with their connectivity", "such as do")

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

    def _values(self, count: int, kind: bytes, *, keep: bool = False) -> np.ndarray:
        """Pass so many values of a type, and return them if they are to be kept."""
        kind = kind.lower()
        if kind in _TEXTS and not keep:
            self._texts(count)
            return _NO_VALUES
        if kind not in _KINDS:
            self._refuse(f"the type {quoted(kind, 30)}", "one of VTK")
        number = np.dtype(_KINDS[kind])
        if not self._binary:
            return self._numbers(count, number, keep=keep)
        self._line()
        size = (count + 7) // 8 if kind == b"bit" else count * number.itemsize
        if self._at + size > len(self._data):
            self._refuse_early(count)
        begin, self._at = self._at, self._at + size
        values = np.frombuffer(self._data[begin : self._at] if keep else b"", number)
        return values.astype(np.int64) if number.kind in "iu" else values

    def _numbers(self, count: int, number: np.dtype, *, keep: bool) -> np.ndarray:
        """Pass so many numbers."""
        kept, left = [], count
        try:
            for end, values in numbers(self._data, self._at, len(self._data), number, count):
                self._at = end
                left -= len(values)
                if keep:
                    kept.append(values)
        except NoNumber as error:
            self._at = error.at
            self._refuse(error.found, "a number")
        if left:
            self._at = len(self._data)
            self._refuse_early(count)
        if count and self._at == len(self._data):
            # The number may have been longer.
            self._refuse("its end right after a number", "a line end")
        return np.concatenate(kept) if kept else _NO_VALUES

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


def _are_cells(values: np.ndarray, count: int) -> bool:
    """Whether values are so many cells, each with its length before it."""
    if count and len(values) % count == 0:
        length = len(values) // count
        if length and (values[::length] == length - 1).all():
            return True
    at = 0
    lengths = values.tolist()
    for _ in range(count):
        if at >= len(lengths) or lengths[at] < 0:
            return False
        at += 1 + lengths[at]
    return at == len(lengths)
