"""Pictures in and out, and how much two differ, through OpenImageIO.

Alpha is straight (unassociated) on both sides: colours are not multiplied by it.
"""

from __future__ import annotations

import mmap
import os
from itertools import chain
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import OpenImageIO as oiio

from ..checks import half_of_memory
from ..printable import printable
from .replace import check_replaceable, replace_file

if TYPE_CHECKING:
    from collections.abc import Iterable
    from typing import Any

_FORMATS = {
    np.dtype(np.uint8): "uint8",
    np.dtype(np.uint16): "uint16",
    np.dtype(np.float16): "half",
    np.dtype(np.float32): "float",
    np.dtype(np.float64): "double",
}
_STRAIGHT_ALPHA = "oiio:UnassociatedAlpha"
_ROOM_TO_CHECK = 2**26
"""Bytes of pixels that are read at a time when a picture is checked."""


class ImageDifference(NamedTuple):
    """How much two pictures differ, over all channels, on a scale where white is 1.

    Attributes
    ----------
    mean, rms, maximum : float
        Mean, root mean square and largest absolute difference.
    psnr : float
        Peak signal to noise ratio in dB, infinite for equal pictures.
    """

    mean: float
    rms: float
    maximum: float
    psnr: float


def _create(path: Path) -> oiio.ImageOutput:
    check_replaceable(path)
    shown = printable(str(path))
    output = oiio.ImageOutput.create(f"picture{path.suffix}")
    if output is None:
        reason = oiio.geterror().strip()
        raise ValueError(f"{shown}: no picture format of that extension can be written: {reason}")
    if output.format_name() in ("null", "term"):
        raise ValueError(f"{shown}: no picture format of that extension can be written to a file")
    return output


def check_output(path: str | os.PathLike[str]) -> None:
    """Raise unless a picture could be written to `path`; nothing is written.

    Raises
    ------
    OSError
        If the folder does not exist, or it or the file cannot be written to.
    ValueError
        If no format has that extension.
    """
    _create(Path(path).expanduser())


def write_image(path: str | os.PathLike[str], pixels: np.ndarray) -> None:
    """Write a picture in the format of the extension of `path`.

    Parameters
    ----------
    path : str or os.PathLike
        File to write, for example ``.png``, ``.tif``, ``.exr``, ``.jpg``.
    pixels : numpy.ndarray
        (height, width) or (height, width, channels), top row first; uint8 or uint16 over their
        whole range, or floats where white is 1. Formats without floats round and clamp them.

    Raises
    ------
    OSError
        If the folder does not exist or the file cannot be written; an earlier file is as it was.
    TypeError
        If the pixels have another type.
    ValueError
        If no format has that extension, or the array has no pixels or no shape of a picture.
    """
    pixels = np.ascontiguousarray(pixels)
    if pixels.ndim not in (2, 3) or not pixels.size:
        raise ValueError(
            f"pixels: found shape {pixels.shape}, expected (height, width[, channels])"
        )
    pixels = np.atleast_3d(pixels)
    write_strips(path, pixels.shape, pixels.dtype, [pixels])


def write_strips(
    path: str | os.PathLike[str],
    shape: tuple[int, ...],
    dtype: np.dtype[Any],
    strips: Iterable[np.ndarray],
) -> None:
    """Write a picture that need not be in memory as a whole.

    Parameters
    ----------
    path : str or os.PathLike
        As in :func:`write_image`.
    shape : tuple[int, int, int]
        Height, width and channels.
    dtype : numpy.dtype
        Type of the pixels, as in :func:`write_image`.
    strips : iterable of numpy.ndarray
        (rows, width, channels), from the top; together they have the picture's height.

    Raises
    ------
    OSError
        If the folder does not exist or the file cannot be written; an earlier file is as it was.
    TypeError
        If the pixels have another type.
    ValueError
        If no format has that extension.
    """
    path = Path(path).expanduser()
    if dtype not in _FORMATS:
        raise TypeError(f"pixels: found {dtype}, expected uint8, uint16 or floats")
    height, width, channels = shape
    spec = oiio.ImageSpec(width, height, channels, _FORMATS[dtype])
    if channels == 4:
        spec.attribute(_STRAIGHT_ALPHA, 1)
    _write_whole(path, _create(path), spec, strips)


def write_channels(
    path: Path, pixels: np.ndarray, names: list[str], attributes: dict[str, str | float]
) -> None:
    """Write floats (height, width, channels) with the channels' names and attributes."""
    height, width, channels = pixels.shape
    spec = oiio.ImageSpec(width, height, channels, _FORMATS[pixels.dtype])
    spec.channelnames = names
    spec.z_channel = names.index("Z")
    for name, value in attributes.items():
        # Integer attributes of OpenImageIO have 32 bits and a sign.
        spec.attribute(name, str(value) if isinstance(value, int) and value >= 2**31 else value)
    _write_whole(path, _create(path), spec, [pixels])


def _write_whole(
    path: Path, output: oiio.ImageOutput, spec: oiio.ImageSpec, strips: Iterable[np.ndarray]
) -> None:
    """Encode in memory, then replace the file at once.

    Upstream: when a disk is full, OpenImageIO 3.2's writers of PNG, BMP and GIF report success, and
    that of JPEG ends the process, since it leaves libjpeg its own error handler, which exits. So
    the encoder writes to memory, what it wrote is read back, and Python puts the file on the disk.
    In C++ OpenImageIO writes to memory by itself, but its Python module has no IOProxy:
    https://github.com/AcademySoftwareFoundation/OpenImageIO/pull/1931.
    """
    shown = printable(str(path))
    # Upstream: OpenImageIO 3.2's writer of JPEG 2000 goes by the extension of the file that it
    # opens, and writes nothing without one, so the memory needs a name that has it.
    with TemporaryDirectory() as folder, os.fdopen(os.memfd_create("picture"), "rb") as memory:
        try:
            # A limit on the size of files holds for memory, too: the most that it needs must fit.
            os.truncate(memory.fileno(), 2 * spec.image_bytes() + 65536)
            os.truncate(memory.fileno(), 0)
        except OSError as error:
            raise OSError(f"{shown}: the picture cannot be written ({error.strerror})") from error
        name = Path(folder, f"picture{path.suffix}")
        name.symlink_to(f"/proc/self/fd/{memory.fileno()}")
        # Encoders complain on their own about what they were opened for and did not get, so the
        # first strip, where most of what is wrong is found, comes before.
        rest = iter(strips)
        first = next(rest)
        try:
            written = output.open(str(name), spec) and _write_rows(output, chain([first], rest))
        finally:
            # Closing flushes, so it is part of writing and may fail as well.
            closed = output.close()
        if not (closed and written):
            raise OSError(f"{shown}: the picture cannot be written: {output.geterror().strip()}")
        if not _can_be_read(name):
            raise OSError(
                f"{shown}: the picture cannot be written: what was encoded cannot be read back"
            )
        with mmap.mmap(memory.fileno(), 0, access=mmap.ACCESS_READ) as encoded:
            replace_file(path, encoded)


def _write_rows(output: oiio.ImageOutput, strips: Iterable[np.ndarray]) -> bool:
    """Write rows from the top; whether that was possible."""
    row = 0
    for strip in strips:
        end = row + len(strip)
        if not output.write_scanlines(row, end, 0, np.ascontiguousarray(strip)):
            return False
        row = end
    return True


def _can_be_read(path: Path) -> bool:
    """Whether every pixel of a picture can be read, a few rows at a time."""
    source = oiio.ImageInput.open(str(path))
    if source is None:
        return False
    try:
        spec = source.spec()
        rows = max(1, _ROOM_TO_CHECK // (spec.scanline_bytes() or 1))
        if spec.tile_width or rows >= spec.height:
            return source.read_image(spec.format) is not None
        return all(
            source.read_scanlines(
                row, min(row + rows, spec.height), 0, 0, spec.nchannels, spec.format
            )
            is not None
            for row in range(0, spec.height, rows)
        )
    finally:
        source.close()


def read_image(path: str | os.PathLike[str]) -> np.ndarray:
    """Read a picture.

    Parameters
    ----------
    path : str or os.PathLike
        File to read.

    Returns
    -------
    numpy.ndarray
        (height, width, channels), top row first, in the type of the file.

    Raises
    ------
    FileNotFoundError
        If there is no such file.
    OSError
        If it cannot be read, or takes more than half of the memory.
    """
    return read_small_image(path)


def read_small_image(
    path: str | os.PathLike[str], *, bytes_per_pixel: int = 0, most: int | None = None
) -> np.ndarray:
    """Read a picture, unless its header says that it is too large.

    Parameters
    ----------
    path : str or os.PathLike
        File to read.
    bytes_per_pixel : int, default: 0
        Memory that a pixel takes, if it is more than that of the picture itself.
    most : int, optional
        How many pixels it may have where memory sets no limit.

    Returns
    -------
    numpy.ndarray
        As of :func:`read_image`.

    Raises
    ------
    FileNotFoundError
        If there is no such file.
    OSError
        If it cannot be read, or is too large.
    """
    path = Path(path).expanduser()
    shown = printable(str(path))
    if not path.exists():
        raise FileNotFoundError(f"{shown}: no such file")
    config = oiio.ImageSpec()
    config.attribute(_STRAIGHT_ALPHA, 1)
    source = oiio.ImageInput.open(str(path), config)
    if source is None:
        raise OSError(f"{shown}: the picture cannot be read: {oiio.geterror().strip()}")
    try:
        spec = source.spec()
        check_pixels(shown, spec.width, spec.height, max(spec.pixel_bytes(), bytes_per_pixel), most)
        pixels = source.read_image(spec.format)
        if pixels is None:
            raise OSError(f"{shown}: the picture cannot be read: {source.geterror().strip()}")
    finally:
        source.close()
    return np.atleast_3d(pixels)


def check_pixels(
    name: str, width: int, height: int, bytes_per_pixel: int, most: int | None = None
) -> None:
    """Raise an OSError that starts with `name` if a picture is too large.

    Parameters
    ----------
    name : str
        What to call the picture.
    width, height : int
        Its pixels.
    bytes_per_pixel : int
        Memory that each takes.
    most : int, optional
        How many there may be where memory sets no limit.
    """
    room = half_of_memory() // bytes_per_pixel
    if most is not None and width * height > most <= room:
        raise OSError(f"{name}: found {width} x {height} pixels, expected at most {most} of them")
    if width * height > room:
        raise OSError(
            f"{name}: found {width} x {height} pixels, which take more than half of the memory, "
            f"expected at most {room} of them"
        )


def compare_images(first: np.ndarray, second: np.ndarray) -> ImageDifference:
    """Compare two pictures of the same size.

    Parameters
    ----------
    first, second : numpy.ndarray
        (height, width[, channels]); integers count as fractions of their largest value.

    Returns
    -------
    ImageDifference
        Mean, rms and largest difference, and the signal to noise ratio.

    Raises
    ------
    ValueError
        If the shapes differ.
    """
    first, second = (np.atleast_3d(np.ascontiguousarray(a)) for a in (first, second))
    if first.shape != second.shape:
        raise ValueError(
            f"second: found shape {second.shape}, expected that of first, {first.shape}"
        )
    result = oiio.ImageBufAlgo.compare(oiio.ImageBuf(first), oiio.ImageBuf(second), 0.0, 0.0)
    return ImageDifference(
        float(result.meanerror),
        float(result.rms_error),
        float(result.maxerror),
        float(result.PSNR),
    )
