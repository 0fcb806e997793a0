"""What the arrays in VTK's files in XML announce, which its readers believe.

Upstream: VTK 9.7 ends the process when it cannot allocate what they ask for, when the last block of
a compressed array is larger than blocks are, and when an array of texts has fewer of them than is
said, see https://github.com/enthought/mayavi/issues/65.
"""

from __future__ import annotations

import base64
import binascii
import lzma
import re
import zlib
from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

from .vtk_numbers import numbers
from .vtk_xml import Element

if TYPE_CHECKING:
    import mmap
    from collections.abc import Iterable, Iterator

# Bytes of a value in the file; of a text they are not known.
_SIZES = {
    **{f"{sign}Int{bits}": bits // 8 for sign in ("", "U") for bits in (8, 16, 32, 64)},
    "Float32": 4,
    "Float64": 8,
}
_NUMBERS = {**{name: name.lower() for name in _SIZES}, "Bit": "uint8"}
_COMPRESSORS = ("vtkZLibDataCompressor", "vtkLZ4DataCompressor", "vtkLZMADataCompressor")
_WORDS = {None: 4, "UInt32": 4, "UInt64": 8}
# Up to this size a block is believed, of which a short array fills a part.
_LARGEST_BLOCK = 256 << 20
# How many bytes one byte of zlib may stand for.
LARGEST_RATIO = 1032
_LETTERS = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"
_CHUNK = 1 << 20
_BLANKS = re.compile(rb"\s*")


class ArrayData:
    """Finds the bytes of arrays in a file in XML.

    Parameters
    ----------
    data : mmap.mmap
        The file.
    elements : list[Element]
        Its elements.

    Raises
    ------
    ValueError
        If they are in no way that VTK writes.
    """

    def __init__(self, data: mmap.mmap, elements: list[Element]) -> None:
        self._data = data
        root = elements[0].attributes
        header, self._compressor = root.get("header_type"), root.get("compressor")
        if header not in _WORDS:
            raise ValueError(f"found header_type={str(header)[:40]!r}, expected UInt32 or UInt64")
        if self._compressor is not None and self._compressor not in _COMPRESSORS:
            raise ValueError(
                f"found compressor={self._compressor[:40]!r}, expected {', '.join(_COMPRESSORS)}"
            )
        order = ">" if root.get("byte_order") == "BigEndian" else "<"
        self._kind = np.dtype(f"{order}u{_WORDS[header]}")
        self._appended, self._raw = len(data), False
        last = elements[-1]
        if last.name == "AppendedData":
            blanks = _BLANKS.match(data, last.content)
            begin = blanks.end() if blanks else last.content
            if data[begin : begin + 1] != b"_":
                raise ValueError(
                    f"found {data[begin : begin + 10]!r} before appended data, expected _"
                )
            self._appended = begin + 1
            self._raw = last.attributes.get("encoding") == "raw"

    @property
    def is_compressed(self) -> bool:
        """Whether arrays that are not text are compressed."""
        return self._compressor is not None

    def check(self, array: Element, values: int | None) -> None:
        """Raise a ValueError unless an array is as long as it must be.

        Parameters
        ----------
        array : Element
            An array.
        values : int or None
            How many values it must have; None if that is not known.
        """
        kind = array.attributes.get("type", "")
        if kind not in _SIZES and kind not in ("String", "Bit"):
            raise ValueError(f"found the type {kind[:40]!r}, expected one of VTK")
        if values == 0:
            return
        place = self._place(array)
        if place is None:
            if kind == "String":
                _check_texts(self._ascii_texts(array), values)
            else:
                self._check_numbers(array, values)
            return
        begin, raw = place
        size, stored = self._announced(begin, raw=raw)
        if values is not None and kind != "String":
            expected = (values + 7) // 8 if kind == "Bit" else values * _SIZES[kind]
            if size != expected:
                raise ValueError(f"found {size:,} bytes of values, expected {expected:,}")
        if not raw and stored:
            self._check_letters(self._blocks(begin, stored, raw=raw), sum(stored))
        elif not raw:
            self._check_letters(begin, self._kind.itemsize + size)
        if kind == "String":
            _check_texts(self._bytes(begin, size, stored, raw=raw), values)

    def last_of(self, array: Element) -> int | None:
        """Return the last value of an array of integers that has been checked; None without any."""
        place = self._place(array)
        kind = array.attributes.get("type", "")
        if "Int" not in kind or kind not in _SIZES:
            raise ValueError(f"found offsets of the type {kind}, expected integers")
        if place is None:
            end = self._data.find(b"<", array.content)
            words = self._data[array.content : max(end, array.content)].rsplit(None, 1)
            if words and not words[-1].strip().isdigit():
                raise ValueError("found no number at the end of offsets, expected one")
            return int(words[-1]) if words else None
        size, stored = self._announced(place[0], raw=place[1])
        if size < _SIZES[kind]:
            return None
        number = np.dtype(f"{'u' if kind[0] == 'U' else 'i'}{_SIZES[kind]}")
        last = self._end(place[0], size, stored, raw=place[1])[-_SIZES[kind] :]
        if len(last) < _SIZES[kind]:
            raise ValueError("found a number in two blocks, expected it in one")
        return int(np.frombuffer(last, number.newbyteorder(self._kind.byteorder))[0])

    def _place(self, array: Element) -> tuple[int, bool] | None:
        """Where the bytes begin, and whether they are raw; None if they are numbers in text."""
        # An offset goes before what the format is said to be.
        offset = array.integer("offset")
        if offset is not None:
            if not 0 <= offset <= len(self._data) - self._appended:
                raise ValueError(f"found the offset {offset:,}, expected one in the file")
            return self._appended + offset, self._raw
        if array.attributes.get("format") == "binary":
            blanks = _BLANKS.match(self._data, array.content)
            return (blanks.end() if blanks else array.content), False
        return None

    def _announced(self, begin: int, *, raw: bool) -> tuple[int, list[int]]:
        """Bytes that the values take, and of a compressed array those of each block in the file."""
        if not self.is_compressed:
            size = int(self._words(begin, 1, raw=raw)[0])
            self._check_inside(begin, self._kind.itemsize + size, raw=raw)
            return size, []
        blocks, size, last = map(int, self._words(begin, 3, raw=raw))
        if not blocks:
            return 0, []
        # Of a short array the whole of a block is allocated.
        most = max(_LARGEST_BLOCK, len(self._data) * LARGEST_RATIO)
        self._check_inside(begin, (3 + blocks) * self._kind.itemsize, raw=raw)
        if size < 1 or blocks * size > most or last > size:
            raise ValueError(
                f"found {blocks:,} blocks of {size:,} bytes, the last of {last:,}, expected what "
                f"a file of {len(self._data):,} bytes holds"
            )
        stored = self._words(begin, 3 + blocks, raw=raw)[3:].tolist()
        self._check_inside(begin, (3 + blocks) * self._kind.itemsize + sum(stored), raw=raw)
        return (blocks - 1) * size + (last or size), stored

    def _check_inside(self, begin: int, size: int, *, raw: bool) -> None:
        there = len(self._data) - begin
        if (size if raw else 4 * (size // 3)) > there:
            raise ValueError(
                f"found {size:,} bytes of values in a file of {len(self._data):,} bytes, expected "
                "no more than these hold"
            )

    def _check_letters(self, begin: int, size: int) -> None:
        """Raise a ValueError if base64 has other letters: VTK leaves values behind them unset."""
        end = begin + 4 * ((size + 2) // 3)
        padding = -size % 3
        last = self._data[end - padding : end]
        wrong = b"" if last == b"=" * padding else last
        for i in range(begin, end - padding, _CHUNK):
            wrong += self._data[i : min(i + _CHUNK, end - padding)].translate(None, _LETTERS)
        if wrong:
            raise ValueError(f"found {wrong[:10]!r} in base64, expected letters of it")

    def _words(self, begin: int, count: int, *, raw: bool) -> np.ndarray:
        """So many numbers at the begin of an array."""
        found = self._read(begin, count * self._kind.itemsize, raw=raw)
        return np.frombuffer(found, self._kind)

    def _read(self, begin: int, size: int, *, raw: bool, skip: int = 0) -> bytes:
        """So many bytes, from `skip` bytes behind there on."""
        if raw:
            found = self._data[begin + skip : begin + skip + size]
        else:
            # Three bytes are four letters.
            first = begin + skip // 3 * 4
            text = self._data[first : begin + 4 * ((skip + size + 2) // 3)]
            try:
                found = base64.b64decode(text, validate=True)[skip % 3 :][:size]
            except binascii.Error:
                found = b""
        if len(found) < size:
            raise ValueError(f"found no {size:,} bytes of values, expected them")
        return found

    def _bytes(self, begin: int, size: int, stored: list[int], *, raw: bool) -> Iterator[bytes]:
        """All bytes of an array of texts, block by block."""
        word = self._kind.itemsize
        if not self.is_compressed:
            yield self._read(begin, size, raw=raw, skip=word)
            return
        packed = self._read(self._blocks(begin, stored, raw=raw), sum(stored), raw=raw)
        whole = int(self._words(begin, 2, raw=raw)[1])
        left, at = size, 0
        for length in stored:
            block = self._unpacked(packed[at : at + length], min(whole, left))
            yield block
            at, left = at + length, left - len(block)

    def _end(self, begin: int, size: int, stored: list[int], *, raw: bool) -> bytes:
        """The last bytes of an array that is not empty: of a compressed one, the last block."""
        word = self._kind.itemsize
        if not self.is_compressed:
            length = min(size, 8)
            return self._read(begin, length, raw=raw, skip=word + size - length)
        at = self._blocks(begin, stored, raw=raw)
        packed = self._read(at, stored[-1], raw=raw, skip=sum(stored[:-1]))
        whole = int(self._words(begin, 2, raw=raw)[1])
        return self._unpacked(packed, size - (len(stored) - 1) * whole)

    def _blocks(self, begin: int, stored: list[int], *, raw: bool) -> int:
        """Where the blocks of a compressed array begin."""
        head = (3 + len(stored)) * self._kind.itemsize
        return begin + (head if raw else 4 * ((head + 2) // 3))

    def _unpacked(self, block: bytes, size: int) -> bytes:
        """A block of so many bytes."""
        # One byte more than there should be, so that the checksum behind them is looked at.
        try:
            if self._compressor == "vtkLZ4DataCompressor":
                return _unpacked_by_lz4(block, size)
            zipped = self._compressor == "vtkZLibDataCompressor"
            unpacker = zlib.decompressobj() if zipped else lzma.LZMADecompressor(lzma.FORMAT_XZ)
            found = unpacker.decompress(block, size + 1)
        except (zlib.error, lzma.LZMAError) as error:
            raise ValueError(
                f"found a block that is damaged ({error}), expected a whole one"
            ) from None
        if not unpacker.eof:
            raise ValueError("found a block that is damaged, expected a whole one")
        if len(found) != size:
            raise ValueError(f"found a block of {len(found):,} bytes, expected {size:,}")
        return found

    def _check_numbers(self, array: Element, values: int | None) -> None:
        """Raise a ValueError unless an array has so many numbers in text, and nothing else."""
        kind = np.dtype(_NUMBERS[array.attributes["type"]])
        end = max(array.content, self._data.find(b"<", array.content))
        count = sum(len(part) for _, part in numbers(self._data, array.content, end, kind))
        if values is not None and count != values:
            raise ValueError(f"found {count:,} values, expected {values:,}")

    def _ascii_texts(self, array: Element) -> Iterator[bytes]:
        """Texts that are written as the numbers of their bytes."""
        end = self._data.find(b"<", array.content)
        words = self._data[array.content : max(end, array.content)].split()
        if any(not word.isdigit() or len(word) > 3 or int(word) > 255 for word in words):
            raise ValueError("found no numbers of bytes, expected those of texts")
        yield bytes(map(int, words))


def _check_texts(blocks: Iterable[bytes], values: int | None) -> None:
    """Raise a ValueError unless these are so many texts, each of which a zero ends."""
    if values is None:
        raise ValueError("found texts of an unknown number, expected NumberOfTuples of them")
    count, last = 0, b""
    for block in blocks:
        count += block.count(b"\0")
        last = block[-1:] or last
    if count != values or last.strip(b"\0"):
        raise ValueError(f"found {count:,} texts, expected {values:,}")


def _unpacked_by_lz4(block: bytes, size: int) -> bytes:
    """What a block of LZ4 holds."""
    from ..backend import vtkLZ4DataCompressor

    with pv.vtk_verbosity("off"), pv.VtkErrorCatcher():
        found = vtkLZ4DataCompressor().Uncompress(block, len(block), size)
    if found is None or found.GetNumberOfValues() != size:
        raise ValueError("found a block that is damaged, expected a whole one")
    return bytes(memoryview(found))
