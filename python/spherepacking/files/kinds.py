"""What a file is that holds no packing, and what to do with it."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pathlib import Path

_FILL = "spheres (`spherepacking pack` fills a closed surface with them)"
_POSITIONS = "positions with radii; convert it to .pdb, .pqr or extended XYZ and give radius="
# What the extension stands for, and what is expected instead.
_BY_EXTENSION = {
    **dict.fromkeys(
        (".obj", ".stl", ".ply", ".off", ".3ds", ".glb", ".gltf", ".wrl", ".vrml"),
        ("a surface", _FILL),
    ),
    ".gro": ("a GROMACS file, which has no radii", _POSITIONS),
    **dict.fromkeys((".xtc", ".trr", ".dcd", ".nc"), ("a trajectory without radii", _POSITIONS)),
    ".mol2": ("a file of molecules without radii", _POSITIONS),
    ".sdf": ("a file of molecules without radii", _POSITIONS),
    ".json": ("a file in JSON", "text: x y z radius"),
    ".yaml": ("a file in YAML", "a packing in text, such as `dump custom` of LAMMPS writes"),
}
# The same of zip archives.
_ARCHIVES = {
    ".npz": ("arrays of NumPy", "text: numpy.savetxt(PATH, array) with x y z radius"),
    ".xlsx": ("a workbook of Excel", "the sheet with the spheres, saved as CSV"),
    ".xlsm": ("a workbook of Excel", "the sheet with the spheres, saved as CSV"),
    ".ods": ("a spreadsheet", "the sheet with the spheres, saved as CSV"),
}
# Objects, or lists in lists, perhaps in further lists.
_JSON = re.compile(rb"[\s\[]*\{\s*\"|\s*\[\s*\[\s*[-+.\deE]+\s*,")
# What the first bytes say, whatever the name is.
_BY_CONTENT = (
    (b"\x89HDF\r\n\x1a\n", "an HDF5 file", ".vtkhdf, or the spheres as text: x y z radius"),
    (b"PK\x03\x04", "a zip archive", "the file in it that holds the spheres"),
    (b"PK\x05\x06", "an empty zip archive", "a file with spheres"),
    (b"Rar!", "a rar archive", "the file in it that holds the spheres"),
    (b"7z\xbc\xaf\x27\x1c", "a 7z archive", "the file in it that holds the spheres"),
    (b"\x04\x22\x4d\x18", "a file that is compressed by lz4", "it uncompressed, or by gzip"),
    (b"\x1f\x9d", "a file that is compressed by compress", "it uncompressed, or by gzip"),
    (b"\xdfe\xdfe\xdfe\xdfe", "a GSD file", "the extension .gsd"),
    (b"# vtk DataFile", "a file of VTK", "the extension .vtk"),
    (b"\x89PNG", "a picture", "a packing"),
    (b"\xff\xd8\xff", "a picture", "a packing"),
    (b"GIF8", "a picture", "a packing"),
    (b"II*\x00", "a picture", "a packing"),
    (b"MM\x00*", "a picture", "a packing"),
    (b"%PDF", "a PDF document", "a packing"),
    (b"\x93NUMPY", "an array of NumPy", "text: numpy.savetxt(PATH, array) with x y z radius"),
    (b"CDF\x01", "a NetCDF file", "text, such as `dump custom` of LAMMPS writes"),
    (b"CDF\x02", "a NetCDF file", "text, such as `dump custom` of LAMMPS writes"),
    (b"PAR1", "a Parquet file", "text: x y z radius"),
    (b"SQLite format 3\x00", "an SQLite database", "text: x y z radius"),
    (b"\x7fELF", "a program", "a packing"),
)


def what_else(path: Path) -> str | None:
    """Say what a file is whose spheres could not be read.

    Parameters
    ----------
    path : pathlib.Path
        The file.

    Returns
    -------
    str or None
        A sentence, or None if nothing better than the reader's error is known.
    """
    with path.open("rb") as file:
        head = file.read(4096)
    if head.startswith(b"PK\x03\x04") and (archive := _ARCHIVES.get(path.suffix.lower())):
        return f"{path}: found {archive[0]}, expected {archive[1]}"
    if _JSON.match(head):
        return f"{path}: found a file in JSON, expected text: x y z radius"
    for magic, what, expected in _BY_CONTENT:
        if head.startswith(magic):
            return f"{path}: found {what}, expected {expected}"
    if head.startswith(b"<") and b"<VTKFile" in head:
        kind = head.partition(b"type=")[2][1:30].partition(head.partition(b"type=")[2][:1])[0]
        return (
            f"{path}: found a file of VTK ({kind.decode('ascii', 'replace')}), expected its own "
            "extension, such as .vtp or .vtu"
        )
    known = _BY_EXTENSION.get(path.suffix.lower())
    return None if known is None else f"{path}: found {known[0]}, expected {known[1]}"
