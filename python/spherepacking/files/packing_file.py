"""One file of a packing, whichever format and compression it has."""

from __future__ import annotations

from contextlib import nullcontext
from dataclasses import replace
from typing import TYPE_CHECKING

import pyvista as pv

from ..printable import printable
from ..vtk_tools import progress_bar
from .compressed import Uncompressed, compression_of, inner_name
from .errors import PackingFileError
from .gsd_files import GsdFile
from .kinds import what_else
from .molecules import EXTENSIONS as MOLECULES
from .molecules import MoleculeFile, radius_of_atoms
from .readers import SpherePackingReader
from .source import finished, without_own_name
from .vtk_files import EXTENSIONS as VTK_EXTENSIONS
from .vtk_files import INDICES, SINGLE_STEP, VtkFile

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from .source import PackingSource, Request

# Seconds before a progress bar appears, so that short work shows none.
_BAR_DELAY = 0.5


def open_file(path: Path, request: Request) -> PackingSource:
    """Open a file of any format, compressed or not.

    Parameters
    ----------
    path : pathlib.Path
        File to read.
    request : Request
        How to read it.

    Returns
    -------
    PackingSource
        Its steps.

    Raises
    ------
    FileNotFoundError
        If there is no such file.
    ImportError
        If a library is missing.
    IsADirectoryError
        If `path` is a directory.
    OSError
        If it is a pipe or a device.
    PackingFileError
        If it is no such file.
    """
    shown = printable(str(path))
    if path.is_dir():
        raise IsADirectoryError(f"{shown}: found a directory, expected a file with a packing")
    if not path.exists():
        raise FileNotFoundError(f"{shown}: there is no such file")
    if not path.is_file():
        raise OSError(f"{shown}: found a pipe or a device, expected a file")
    compression = compression_of(path)
    if compression is None:
        return _open(path, path, request)
    return CompressedFile(path, compression, request)


def has_one_step(path: Path) -> bool:
    """Whether the name of a file says that it holds no more than one step."""
    return inner_name(path).lower().endswith(SINGLE_STEP)


def _open(path: Path, shown: Path, request: Request) -> PackingSource:
    """Open a file that is not compressed and that the user calls `shown`."""
    reader = _READERS.get(path.suffix.lower())
    if reader is None:
        return _PlainFile(path, shown, request)
    if request.columns is not None:
        raise PackingFileError(
            f"{path}: found names of columns for a file of the extension {path.suffix}, expected "
            "them for a table in text"
        )
    return reader(path, request)


class _PlainFile:
    """A file that the C++ reader reads."""

    def __init__(self, path: Path, shown: Path, request: Request) -> None:
        self._path, self._shown, self._request = path, shown, request
        self._reader = SpherePackingReader(path)
        self._reader.precision = request.precision
        self._reader.reader.SetColumns(request.columns or "")
        self._reader.reader.SetRadiusOptional(request.radius is not None)
        # The file's own, NaN where a step has none.
        self._has_steps = self._reader.number_time_points > 0
        self.times: list[float] = pv.convert_array(self._reader.reader.GetStepTimes()).tolist()

    def read(self, index: int) -> pv.PolyData:
        """Read the packing of a step."""
        reader = self._reader
        if self._has_steps:
            reader.set_active_time_point(index)
        # What was read before belongs to whoever asked for it.
        reader.reader.Modified()
        bar = progress_bar(reader.reader, f"Reading {printable(self._shown.name)}", _BAR_DELAY)
        try:
            with bar if self._request.progress else nullcontext():
                packing = reader.read()
        except PackingFileError as error:
            sentence = what_else(self._path)
            hinted = "radius=" in str(error)
            if sentence is None and not hinted and self._lacks_radii_alone():
                sentence = f"{error}; radius= gives radii (--radius)"
            if sentence is None:
                raise
            raise PackingFileError(sentence) from None
        if self._request.radius is None:
            return packing
        own = reader.reader.GetRadiusName()
        return finished(packing, self._path, without_own_name(self._request, packing, own))

    def _lacks_radii_alone(self) -> bool:
        """Whether a file that was refused is read when it need not have radii."""
        if self._request.radius is not None:
            return False
        reader = self._reader
        reader.reader.SetRadiusOptional(True)
        try:
            packing = reader.read()
            return packing.n_points > 0 and "radius" not in packing.point_data
        except PackingFileError:
            return False
        finally:
            reader.reader.SetRadiusOptional(False)


class _Molecules:
    """A file of molecules, read by gemmi; each model is a step."""

    def __init__(self, path: Path, request: Request) -> None:
        self._path, self._request = path, request
        self._file = MoleculeFile(path)
        self.times = self._file.times

    def read(self, index: int) -> pv.PolyData:
        """Read the packing of a model."""
        packing = self._file.read(index)
        radius = radius_of_atoms(packing, self._path, self._request.radius)
        return finished(packing, self._path, replace(self._request, radius=radius))


class CompressedFile:
    """A file in a temporary folder, which goes away with this object.

    Parameters
    ----------
    path : pathlib.Path
        Compressed file.
    compression : str
        What it is compressed by.
    request : Request
        How to read it.
    """

    def __init__(self, path: Path, compression: str, request: Request) -> None:
        self._path = path
        if inner_name(path).lower().endswith(INDICES):
            raise PackingFileError(
                f"{path}: found a compressed file that names others, expected it uncompressed"
            )
        self._file = Uncompressed(path, compression)
        try:
            with self._file.named():
                self._source = _open(self._file.path, path, request)
            self.times = self._source.times
        except BaseException:
            self.close()
            raise

    def read(self, index: int) -> pv.PolyData:
        """Read the packing of a step."""
        with self._file.named():
            return self._source.read(index)

    def close(self) -> None:
        """Remove the temporary file."""
        self._file.remove()


# What reads that which the C++ reader does not, by extension.
_READERS: dict[str, Callable[[Path, Request], PackingSource]] = {
    **dict.fromkeys(VTK_EXTENSIONS, VtkFile),
    **dict.fromkeys(MOLECULES, _Molecules),
    ".gsd": GsdFile,
}
