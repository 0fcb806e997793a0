"""Compressed files, uncompressed into a temporary folder for as long as they are read."""

from __future__ import annotations

import bz2
import codecs
import lzma
import os
import shutil
import sys
import tempfile
import weakref
import zlib
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from ..printable import printable
from .errors import PackingFileError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from typing import Any, BinaryIO

# What each format begins with, and the extension that goes away.
_FORMATS = {
    "gzip": (b"\x1f\x8b\x08", ".gz"),
    "bzip2": (b"BZh", ".bz2"),
    "xz": (b"\xfd7zXZ\x00", ".xz"),
    "zstandard": (b"\x28\xb5\x2f\xfd", ".zst"),
}
# What a text is compressed by that has the extension alone.
_NOTHING = "nothing"
# Bytes that are looked at.
_HEAD = 4096
_CHUNK = 1 << 20
# Bytes that stay free in the temporary folder, and that a dictionary of xz may take.
_RESERVE = 64 << 20
_LARGEST_DICTIONARY = 512 << 20
# An uncompressed .xyzd file is made of these; it may begin with any bytes.
_XYZD_ROW = 32
# Bytes that zstandard is given at a time, since it returns up to 32768 times as many.
_ZSTANDARD_INPUT = 2048


def compression_of(path: Path) -> str | None:
    """What a file is compressed by, from its first bytes; None if it is not.

    Parameters
    ----------
    path : pathlib.Path
        File to look at.

    Returns
    -------
    str or None
        ``gzip``, ``bzip2``, ``xz``, ``zstandard`` or None; ``nothing`` if it is text by the name
        of a compressed file, as programs leave it that unpack a file under its name.
    """
    if path.suffix.lower() == ".xyzd" and path.stat().st_size % _XYZD_ROW == 0:
        return None
    with path.open("rb") as file:
        head = file.read(_HEAD)
    for name, (magic, _) in _FORMATS.items():
        # The size of a block follows in bzip2.
        if head.startswith(magic) and (name != "bzip2" or head[3:4].isdigit()):
            return name
    for name, (_, extension) in _FORMATS.items():
        if path.suffix.lower() == extension:
            if _is_text(head):
                return _NOTHING
            raise PackingFileError(
                f"{path}: found a file that is not compressed by {name}, expected one that is"
            )
    return None


def _is_text(head: bytes) -> bool:
    """Whether a file that begins so can be text in UTF-8, and nothing else."""
    try:
        text = codecs.getincrementaldecoder("utf-8")().decode(head)
    except UnicodeDecodeError:
        return False
    return bool(text) and all(c >= " " or c in "\t\n\r\f\v" for c in text)


def inner_name(path: Path) -> str:
    """Name of a file without the extension of its compression."""
    extensions = [extension for _, extension in _FORMATS.values()]
    return path.stem if path.suffix.lower() in extensions else path.name


class Uncompressed:
    """A file that is compressed, uncompressed in a temporary folder while this object is there.

    Parameters
    ----------
    path : pathlib.Path
        Compressed file.
    compression : str
        What it is compressed by, see :func:`compression_of`.

    Attributes
    ----------
    path : pathlib.Path
        The uncompressed file.
    remove : weakref.finalize
        Call it to remove the file before the object goes away.

    Raises
    ------
    ImportError
        If a library is missing.
    PackingFileError
        If the file is damaged, or there is no room for what it holds.
    """

    def __init__(self, path: Path, compression: str) -> None:
        pieces = _PIECES[compression]
        folder = tempfile.mkdtemp(prefix="spherepacking-")
        # Also at the end of the process.
        self.remove = weakref.finalize(self, shutil.rmtree, folder, ignore_errors=True)
        self._source = path
        self.path = Path(folder) / inner_name(path)
        try:
            with path.open("rb") as source, self.path.open("wb") as target:
                _copy(path, compression, pieces(path, source), target)
            # The porosities of an .xyzd file lie beside it.
            beside = path.with_name(inner_name(path)).with_suffix(".nfo")
            if self.path.suffix.lower() == ".xyzd" and os.path.lexists(beside):
                _copy_beside(beside, folder)
        except BaseException:
            self.remove()
            raise

    @contextmanager
    def named(self) -> Iterator[None]:
        """Give errors that are raised in the block the name of the compressed file."""
        try:
            yield
        except (PackingFileError, ImportError) as error:
            text = str(error).replace(printable(str(self.path)), str(self._source))
            text = text.replace(printable(str(self.path.parent)), str(self._source.parent))
            raise type(error)(text) from None


def _copy_beside(path: Path, folder: str) -> None:
    """Copy a file that belongs to the compressed one."""
    if path.exists() and not path.is_file():
        raise PackingFileError(f"{path}: found a folder, pipe or device, expected a file")
    try:
        shutil.copy(path, folder)
    except OSError as error:
        raise PackingFileError(
            f"{path}: cannot read the file ({error.strerror}), expected a readable one"
        ) from None


def _copy(path: Path, compression: str, pieces: Iterator[bytes], target: BinaryIO) -> None:
    """Write the pieces, as long as the temporary folder has room for them."""
    folder = Path(target.name).parent
    written = 0
    try:
        for piece in pieces:
            if len(piece) + _RESERVE > shutil.disk_usage(folder).free:
                raise PackingFileError(
                    f"{path}: found more than {written:,} bytes in it, expected no more than the "
                    f"folder {folder.parent} has room for (TMPDIR names another)"
                )
            target.write(piece)
            written += len(piece)
    except EOFError:
        raise PackingFileError(
            f"{path}: found a {compression} file that ends early, expected a whole one"
        ) from None
    except (lzma.LZMAError, zlib.error, ValueError, OSError) as error:
        if isinstance(error, PackingFileError):
            raise
        raise PackingFileError(
            f"{path}: found a {compression} file that cannot be uncompressed, expected a whole "
            f"one: {error}"
        ) from None


def _pieces_by(make: Callable[[], Any]) -> Callable[[Path, BinaryIO], Iterator[bytes]]:
    """Make a function that uncompresses one stream after the other in a file."""

    def pieces(_: Path, source: BinaryIO) -> Iterator[bytes]:
        rest = source.read(_CHUNK)
        while rest:
            stream = make()
            while not stream.eof:
                if stream.needs_input and not rest and not (rest := source.read(_CHUNK)):
                    raise EOFError
                piece = stream.decompress(rest, _CHUNK)
                rest = b""
                if piece:
                    yield piece
            # Writers of tapes and blocks pad with zeros.
            rest = (stream.unused_data or source.read(_CHUNK)).lstrip(b"\0")

    return pieces


def _plain_pieces(_: Path, source: BinaryIO) -> Iterator[bytes]:
    while piece := source.read(_CHUNK):
        yield piece


def _gzip_pieces(_: Path, source: BinaryIO) -> Iterator[bytes]:
    import gzip

    with gzip.GzipFile(fileobj=source, mode="rb") as file:
        while piece := file.read(_CHUNK):
            yield piece


def _zstandard_pieces(path: Path, source: BinaryIO) -> Iterator[bytes]:
    if sys.version_info >= (3, 14):
        from compression import zstd

        try:
            yield from _pieces_by(zstd.ZstdDecompressor)(path, source)
        except zstd.ZstdError as error:
            raise ValueError(str(error)) from None
        return
    try:
        import zstandard
    except ImportError:
        raise ImportError(
            f"{path}: found a file that is compressed by zstandard, expected the library of that "
            "name to be installed: pip install 'spherepacking[formats]'"
        ) from None
    rest = source.read(_ZSTANDARD_INPUT)
    while rest:
        stream = zstandard.ZstdDecompressor().decompressobj()
        while not stream.eof:
            if not rest and not (rest := source.read(_ZSTANDARD_INPUT)):
                raise EOFError
            try:
                piece = stream.decompress(rest)
            except zstandard.ZstdError as error:
                raise ValueError(str(error)) from None
            rest = b""
            if piece:
                yield piece
        rest = stream.unused_data or source.read(_ZSTANDARD_INPUT)


_PIECES: dict[str, Callable[[Path, BinaryIO], Iterator[bytes]]] = {
    _NOTHING: _plain_pieces,
    "gzip": _gzip_pieces,
    "bzip2": _pieces_by(bz2.BZ2Decompressor),
    "xz": _pieces_by(lambda: lzma.LZMADecompressor(memlimit=_LARGEST_DICTIONARY)),
    "zstandard": _zstandard_pieces,
}
