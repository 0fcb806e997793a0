"""Writing packing files, through ``PolyData.save`` and by :func:`write`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import pyvista as pv

from ..checks import kind_of
from ..vtk_tools import errors_raised
from .errors import PackingFileError

if TYPE_CHECKING:
    import os


def write(packing: pv.PolyData, path: str | os.PathLike[str]) -> None:
    """Write a packing in the format of the extension of `path`.

    ``.spheres`` and ``.xyzr`` are text, ``.xyzd`` is binary, ``.txt`` is YADE's text. ``.csv``, a
    LAMMPS ``.dump`` and extended ``.xyz`` also hold the other point arrays, the latter two the cell
    and the time, too. A ``.spheres`` file has the largest sphere first. Numbers read back exactly.
    ``packing.save(path)`` does the same, except for ``.txt``.

    Parameters
    ----------
    packing : pyvista.PolyData
        Centres as points (n, 3) and a point array ``radius`` (n,).
    path : str or os.PathLike
        File to write. An existing file is replaced.

    Raises
    ------
    TypeError
        If `packing` is not a PolyData.
    FileNotFoundError
        If the folder of `path` does not exist.
    PackingFileError
        If the packing has no usable radii or the file cannot be written.

    Examples
    --------
    >>> import spherepacking
    >>> spherepacking.write(spherepacking.apollonian(2), "apollonian.spheres")  # doctest: +SKIP
    """
    from ..backend import vtkSpherePackingWriter

    if not isinstance(packing, pv.PolyData):
        raise TypeError(f"packing: found {kind_of(packing)}, expected a PolyData")
    path = Path(path).expanduser()
    if not path.parent.is_dir():
        raise FileNotFoundError(f"{path}: there is no folder {path.parent}")
    if path.is_dir():
        raise IsADirectoryError(f"{path}: found a directory, expected a file name")
    writer = vtkSpherePackingWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(packing)
    with errors_raised(writer, PackingFileError):
        writer.Write()
