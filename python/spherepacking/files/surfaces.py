"""Closed surfaces from files, for packing."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..printable import printable
from .obj_files import read_obj
from .off_files import read_off
from .ply_files import read_ply
from .stl_files import read_stl
from .surface_rows import refuse
from .vtk_surfaces import read_vtk_surface

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    import pyvista as pv

# No library reads these four so that a damaged file is refused: VTK's readers may end the process
# (https://github.com/f3d-app/f3d/issues/618), and those that do not pass over what they do not
# understand. None of them opens another file.
_READERS: dict[str, Callable[[Path], pv.PolyData]] = {
    ".off": read_off,
    ".stl": read_stl,
    ".ply": read_ply,
    ".obj": read_obj,
    **dict.fromkeys((".vtp", ".vtu", ".vtk"), read_vtk_surface),
}


def read_surface(path: Path) -> pv.PolyData:
    """Read a surface.

    Parameters
    ----------
    path : pathlib.Path
        File to read, ``.off``, ``.stl``, ``.ply``, ``.obj``, ``.vtp``, ``.vtu`` or ``.vtk``.

    Returns
    -------
    pyvista.PolyData
        The surface.

    Raises
    ------
    FileNotFoundError
        If there is no such file.
    SurfaceFileError
        If the file holds no surface, or its format is another one.
    """
    if not path.is_file():
        raise FileNotFoundError(f"{printable(str(path))}: there is no such file")
    reader = _READERS.get(path.suffix.lower())
    if reader is None:
        *most, last = _READERS
        refuse(
            path,
            f"the extension {printable(path.suffix) or 'of none'}",
            f"{', '.join(most)} or {last}; in Python, pack(pyvista.read(PATH), COUNT) takes others",
        )
    mesh = reader(path)
    if not mesh.n_faces + mesh.n_strips:
        refuse(path, "no polygons", "a closed surface")
    return mesh
