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


# Formats that hold no more than the spheres, and further arrays of which names they hold.
_SPHERES_ALONE = {".spheres": (), ".xyzr": (), ".xyzd": (), ".txt": ("matId",)}
_CELL = ("cell_vectors", "cell_origin", "cell_periodic")


def left_out(packing: pv.PolyData, path: str | os.PathLike[str]) -> str | None:
    """Say what the format of a file cannot hold of a packing.

    Parameters
    ----------
    packing : pyvista.PolyData
        Centres (n, 3) and a point array ``radius`` (n,).
    path : str or os.PathLike
        File to write, or that was written.

    Returns
    -------
    str or None
        A sentence, or None if nothing is left out.

    Examples
    --------
    >>> import spherepacking
    >>> from spherepacking.files.writers import left_out
    >>> left_out(spherepacking.apollonian(1), "a.spheres")
    'a.spheres holds x y z r alone: left out level'
    """
    path = Path(path)
    extension = path.suffix.lower()
    names = [name for name in packing.point_data if name != "radius"]
    held = _SPHERES_ALONE.get(extension)
    if held is not None:
        names = [name for name in names if name not in held]
        what = " ".join(["x y z r", *held])
    elif extension == ".csv":
        names = [name for name in names if packing.point_data[name].dtype.kind in "US"]
        what = "numbers of each sphere"
    else:
        return None
    lost = [*names, *(["the cell"] if _CELL[0] in packing.field_data else [])]
    return f"{path.name} holds {what} alone: left out {', '.join(lost)}" if lost else None


def write(packing: pv.PolyData, path: str | os.PathLike[str]) -> None:
    """Write a packing in the format of the extension of `path`.

    ``.spheres`` and ``.xyzr`` are text, ``.xyzd`` is binary, ``.txt`` is YADE's text, and ``.csv``
    also holds the other point arrays. A ``.spheres`` file has the largest sphere first. Numbers
    read back exactly. ``packing.save(path)`` does the same, except for ``.txt``.

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
