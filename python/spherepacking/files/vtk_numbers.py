"""Numbers in the texts of VTK's files, whose readers go wrong at words that are none."""

from __future__ import annotations

import re
import warnings
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    import mmap
    from collections.abc import Iterator

_WORD = re.compile(rb"\S+")
_BLANK = re.compile(rb"\s")
_CHUNK = 1 << 20


class NoNumber(ValueError):
    """A word that is no number.

    Parameters
    ----------
    word : bytes
        The word.
    at : int
        Where it begins.
    """

    def __init__(self, word: bytes, at: int) -> None:
        self.found = repr(word[:30].decode("utf-8", "replace"))
        self.at = at
        super().__init__(f"found {self.found}, expected a number")


def numbers(
    data: mmap.mmap, begin: int, end: int, kind: np.dtype[Any], most: int | None = None
) -> Iterator[tuple[int, np.ndarray]]:
    """Read the numbers of a text in chunks.

    Parameters
    ----------
    data : mmap.mmap
        The file.
    begin, end : int
        Where the text begins and ends.
    kind : numpy.dtype
        What the numbers are to be stored as.
    most : int, optional
        How many are read; by default all.

    Yields
    ------
    tuple[int, numpy.ndarray]
        Where a chunk ends, and its numbers, one or more.

    Raises
    ------
    NoNumber
        If a word is no number, or none of that kind.
    """
    left = end - begin if most is None else most
    while left > 0 and begin < end:
        blank = _BLANK.search(data, begin + _CHUNK, end)
        chunk = data[begin : blank.end() if blank else end]
        values = _values(chunk, kind)
        if most is not None and (values is None or len(values) >= left):
            # What follows is something else.
            chunk = _first_words(chunk, left)
            values = _values(chunk, kind)
        if values is None:
            raise _wrong_word(chunk, begin, kind)
        if values.size:
            left -= len(values)
            yield begin + len(chunk), values
        begin += len(chunk)


def _first_words(text: bytes, count: int) -> bytes:
    """A text up to the end of so many words."""
    space = np.frombuffer(text, np.uint8) <= 32
    first = np.flatnonzero(~space & np.concatenate([[True], space[:-1]]))
    if first.size < count:
        return text
    match = _WORD.match(text, int(first[count - 1]))
    return text[: match.end()] if match else text


def _values(text: bytes, kind: np.dtype[Any]) -> np.ndarray | None:
    """Numbers of a text; None if one of its words is none."""
    if not text or text.isspace():
        # NumPy finds a number in blanks.
        return np.empty(0)
    unsigned = kind.kind == "u" and kind.itemsize == 8
    read_as = np.float64 if kind.kind == "f" else np.uint64 if unsigned else np.int64
    try:
        with warnings.catch_warnings():
            # Older NumPy warns where a newer one raises an error.
            warnings.simplefilter("error", DeprecationWarning)
            values = np.fromstring(text, read_as, sep=" ")
    except (ValueError, DeprecationWarning):
        return None
    if kind.kind in "iu" and kind.itemsize < 8 and values.size:
        bounds = np.iinfo(kind)
        if values.min() < bounds.min or values.max() > bounds.max:
            return None
    return values


def _wrong_word(text: bytes, begin: int, kind: np.dtype[Any]) -> NoNumber:
    """The error of the first word of a text that is no number."""
    for word in _WORD.finditer(text):
        values = _values(word[0], kind)
        if values is None:
            return NoNumber(word[0], begin + word.start())
    return NoNumber(text[:30], begin)
