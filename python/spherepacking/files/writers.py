"""Writing packing files, through ``PolyData.save`` and by :func:`write`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import pyvista as pv

from ..datasets import packing_of, with_radii, wrap
from ..packing import snapshot
from ..printable import printable
from ..vtk_tools import errors_raised
from .errors import PackingFileError
from .replace import check_replaceable, replace_file
from .vtk_files import errors_of_vtk

if TYPE_CHECKING:
    import os
    from typing import Any

    from ..radii import RadiusLike

_LONGEST = 1000  # characters of a sentence, which names arrays
# Formats that hold no more than the spheres, and further arrays of which names they hold.
_SPHERES_ALONE = {".spheres": (), ".xyzr": (), ".xyzd": (), ".txt": ("matId",)}

_OF_VTK = (".vtp", ".vtu", ".vtk")


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
        names = []
        what = "arrays of each sphere"
    else:
        return None
    fields = {"the cell": "cell_vectors", "the time": "TimeValue"}
    lost = [*names, *(what for what, name in fields.items() if name in packing.field_data)]
    sentence = f"{path.name} holds {what} alone: left out {', '.join(lost)}"
    return printable(sentence, _LONGEST) if lost else None


def write(
    packing: pv.DataSet | pv.MultiBlock,
    path: str | os.PathLike[str],
    *,
    radius: RadiusLike | None = None,
) -> None:
    """Write a packing in the format of the extension of `path`.

    ``.spheres`` and ``.xyzr`` are text, ``.xyzd`` is binary, ``.txt`` is YADE's text, and ``.csv``
    also holds the other point arrays. A LAMMPS ``.dump`` and extended ``.xyz`` hold these, the cell
    and the time, and so do VTK's ``.vtp``, ``.vtu`` and ``.vtk``. A ``.spheres`` file has the
    largest sphere first. Numbers and names read back exactly; what would not, such as an integer
    beyond 2**53 in text, is refused. ``packing.save(path)`` does the same, except for ``.txt``.

    The file takes the place of an earlier one when it is complete, so that whatever happens the
    name stands for the one or the other. It has the permissions and the group of the earlier one,
    and the owner of any file that is written; links are followed, further hard links keep what the
    earlier file held.

    Parameters
    ----------
    packing : pyvista.DataSet or pyvista.MultiBlock
        Its points are the centres (n, 3).
    path : str or os.PathLike
        File to write. An existing file is replaced, but not a folder, pipe or device.
    radius : str, float, array_like or mapping, optional
        Radii, as in ``packing.packing.with_radius``; by default the point array ``radius``, or one
        that is called so.

    Raises
    ------
    TypeError
        If `packing` has no points.
    FileNotFoundError
        If the folder of `path` does not exist.
    PackingFileError
        If the packing has no usable radii, or the format cannot hold an array as it is, or the file
        cannot be written.

    Examples
    --------
    >>> import spherepacking
    >>> spherepacking.write(spherepacking.apollonian(2), "apollonian.spheres")  # doctest: +SKIP
    """
    from ..backend import vtkSpherePackingWriter

    dataset = wrap(packing)
    path = Path(path).expanduser()
    if not path.parent.is_dir():
        raise FileNotFoundError(printable(f"{path}: there is no folder {path.parent}"))
    if path.is_dir():
        raise IsADirectoryError(printable(f"{path}: found a directory, expected a file name"))
    try:
        spheres, _ = with_radii(packing_of(dataset, radius), "radius")
    except (KeyError, TypeError, ValueError) as error:
        raise PackingFileError(f"{path}: {error.args[0]}") from None
    if path.suffix.lower() in _OF_VTK:
        _write_by_vtk(spheres, path)
        return
    writer = vtkSpherePackingWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(snapshot(spheres))
    with errors_raised(writer, PackingFileError):
        writer.Write()


def check_writable(path: Path) -> None:
    """Raise unless a packing can be written to `path`, as far as that is known without one.

    Parameters
    ----------
    path : pathlib.Path
        File to write; nothing is written.

    Raises
    ------
    OSError
        If the folder does not exist, or it or the file cannot be written to.
    PackingFileError
        If no format has that extension, or an .nfo file beside the file would change the packing.
    """
    from ..backend import vtkSpherePackingWriter

    check_replaceable(path)
    if path.suffix.lower() in _OF_VTK:
        return
    writer = vtkSpherePackingWriter()
    writer.SetFileName(str(path))
    with errors_raised(writer, PackingFileError):
        writer.CheckFile()


def _write_by_vtk(packing: pv.PolyData, path: Path) -> None:
    """Write a file of VTK, which appears under its name when it is complete.

    Upstream: VTK 9.7's writer of XML crashes when a disk is full, since it goes on with the stream
    that it has closed. So VTK writes to memory.
    """
    extension = path.suffix.lower()
    saved = packing.cast_to_unstructured_grid() if extension == ".vtu" else packing
    with errors_of_vtk(f"{path}: the file cannot be written"):
        # As DataObject.save() does it, for which memory is no file.
        saved._store_metadata()
        writer: Any = saved._WRITERS[extension](path, saved)
        writer.data_format = "binary"
        writer.writer.SetWriteToOutputString(True)
        writer.write()
        to_memory = writer.writer
        # Of legacy files the other one ends at the first zero.
        text = (
            to_memory.GetOutputStdString() if extension == ".vtk" else to_memory.GetOutputString()
        )
    replace_file(path, text.encode() if isinstance(text, str) else text)
