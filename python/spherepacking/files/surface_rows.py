"""Rows of a surface in text: words and numbers, and what is said of those that are wrong."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, NoReturn

import numpy as np

from ..printable import quoted
from .errors import SurfaceFileError

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence
    from pathlib import Path

# Words of these letters alone are numbers of ASCII if float() takes them: it takes others, too,
# such as 1_6, nan and infinity.
_OF_NUMBERS = re.compile(rb"[-+.0-9eE]*")
# Of the size of a surface: as far as points may move that single precision rounds.
_TOLERANCE = 1e-6
_MARK = b"\xef\xbb\xbf"  # of UTF-8


class SurfaceRows:
    """Goes through the lines of a text that are not blank.

    Parameters
    ----------
    path : pathlib.Path
        File, for errors.
    data : bytes
        The text.
    comment : bytes, optional
        What begins a comment, up to the end of the line.
    first : int, default: 1
        Number of the first line.
    goes_on : bytes, optional
        What ends a line that goes on in the next one.

    Attributes
    ----------
    line : int
        Number of the row that was handed out last.
    """

    def __init__(
        self,
        path: Path,
        data: bytes,
        comment: bytes = b"",
        first: int = 1,
        goes_on: bytes = b"",
    ) -> None:
        # What is nowhere need not be looked for in each line.
        self._path = path
        self._comment = comment if comment in data else b""
        self._goes_on = goes_on if goes_on in data else b""
        self._underlined = b"_" in data
        self._lines = data.removeprefix(_MARK).splitlines()
        self._next = 0
        self._first = first
        self._row: list[bytes] = []
        self.line = first

    def __iter__(self) -> Iterator[list[bytes]]:
        """Hand out the words of each row, from where an earlier loop has ended."""
        lines, comment, goes_on = self._lines, self._comment, self._goes_on
        while self._next < len(lines):
            line = lines[self._next]
            self._next += 1
            if goes_on and line.endswith(goes_on):
                line = self._with_next(line)
            if comment and comment in line:
                line = line.partition(comment)[0]
            if words := line.split():
                self.line = self._next - 1 + self._first
                self._row = words
                yield words

    def _with_next(self, line: bytes) -> bytes:
        """Join a line with those in which it goes on."""
        parts = [line]
        while parts[-1].endswith(self._goes_on) and self._next < len(self._lines):
            parts[-1] = parts[-1].removesuffix(self._goes_on)
            parts.append(self._lines[self._next])
            self._next += 1
        return b" ".join(parts)

    def next_row(self) -> list[bytes]:
        """Hand out the words of the next row, none at the end of the text."""
        for words in self:
            return words
        self.line = len(self._lines) - 1 + self._first
        self._row = []
        return []

    def count(self) -> int:
        """How many rows there are from here on."""
        here = self._next, self.line, self._row
        count = sum(1 for _ in self)
        self._next, self.line, self._row = here
        return count

    def numbers(self, words: Sequence[bytes], expected: str) -> list[float]:
        """Take words of a row for numbers, or refuse the row."""
        try:
            if _OF_NUMBERS.fullmatch(b"".join(words)):
                return list(map(float, words))
        except ValueError:
            pass
        self.refuse(expected)

    def integers(self, words: Sequence[bytes], expected: str) -> list[int]:
        """Take words of a row for integers, of which there must be one, or refuse the row."""
        try:
            # Of what int() takes underlines alone are odd.
            if words and not (self._underlined and b"_" in b"".join(words)):
                return list(map(int, words))
        except ValueError:
            pass
        self.refuse(expected)

    def refuse(self, expected: str) -> NoReturn:
        """Say that the row that was handed out last is wrong."""
        found = quoted(b" ".join(self._row), 60) if self._row else "the end of the file"
        refuse(self._path, found, expected, self.line)


def refuse(path: Path, found: str, expected: str, line: int | None = None) -> NoReturn:
    """Say that a file, or a line of it, is wrong.

    Parameters
    ----------
    path : pathlib.Path
        File.
    found, expected : str
        What is there, and what should be.
    line : int, optional
        Number of the line, from 1 on.

    Raises
    ------
    SurfaceFileError
        Always.
    """
    place = str(path) if line is None else f"{path}, line {line}"
    raise SurfaceFileError(f"{place}: found {found}, expected {expected}") from None


def finite_points(path: Path, points: np.ndarray) -> np.ndarray:
    """Points (n, 3), all of which must be finite.

    Parameters
    ----------
    path : pathlib.Path
        File, for errors.
    points : numpy.ndarray
        Coordinates (n, 3).

    Returns
    -------
    numpy.ndarray
        `points`.
    """
    wrong = np.flatnonzero(~np.isfinite(points).all(axis=1))
    if wrong.size:
        found = ", ".join(f"{value:g}" for value in points[wrong[0]])
        refuse(path, f"the coordinates {found} of point {wrong[0]}", "finite numbers")
    return points


def in_single_precision(points: np.ndarray) -> np.ndarray:
    """Points as VTK's readers round them, unless that moves one visibly.

    Parameters
    ----------
    points : numpy.ndarray
        Coordinates (n, 3), float64.

    Returns
    -------
    numpy.ndarray
        float32 if no point moves by more than a millionth of the size of all, else `points`.
    """
    if not points.size:
        return points
    with np.errstate(over="ignore"):
        single = points.astype(np.float32)
        moved = np.abs(single - points).max()
        return single if moved <= _TOLERANCE * np.ptp(points, axis=0).max() else points


def checked_faces(path: Path, faces: np.ndarray, n_points: int) -> np.ndarray:
    """Polygons, each its number of points followed by these, all of which must be there.

    Parameters
    ----------
    path : pathlib.Path
        File, for errors.
    faces : numpy.ndarray
        Rows (n, 1 + corners) of polygons of as many corners each, or one after the other.
    n_points : int
        How many points there are.

    Returns
    -------
    numpy.ndarray
        `faces`, one after the other.
    """
    ids = faces[:, 1:].ravel() if faces.ndim == 2 else faces[_are_ids(faces)]
    wrong = ids[(ids < 0) | (ids >= n_points)]
    if wrong.size:
        refuse(path, f"a polygon of point {wrong[0]}", f"points from 0 to {n_points - 1}")
    return faces.ravel()


def _are_ids(faces: np.ndarray) -> np.ndarray:
    """Which numbers of polygons are points."""
    are_ids = np.ones(len(faces), bool)
    at = 0
    counts = faces.tolist()
    while at < len(counts):
        are_ids[at] = False
        at += 1 + counts[at]
    return are_ids
