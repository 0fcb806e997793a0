"""What gemmi reads without a word: numbers that are none, damaged records, files that were cut."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import numpy as np

from .errors import PackingFileError

if TYPE_CHECKING:
    from pathlib import Path

# Columns 31 to 54 hold x, y and z, eight characters each (wwPDB, "Atomic Coordinate Entry Format
# Description", version 3.3, 2012).
_ATOM = re.compile(rb"^(?:ATOM  |HETATM).*$", re.IGNORECASE | re.MULTILINE)
_COORDINATES = slice(30, 54)
# Other records have no three numbers with three decimals there, except for the deviations of an
# older format.
_DAMAGED = re.compile(
    rb"^(?!ATOM|HETATM|SIGATM|REMARK).{30}(?:[ \d+-]{4}\.\d{3}){3}.*$", re.IGNORECASE | re.MULTILINE
)


def check_pdb_lines(path: Path, data: bytes) -> None:
    """Check that the coordinates are numbers, and that no other line holds any.

    Parameters
    ----------
    path : pathlib.Path
        File, for the message.
    data : bytes
        Its content.

    Raises
    ------
    PackingFileError
        If a coordinate is no finite number, a record that is not of an atom holds coordinates, the
        file ends within a line, or the atoms are the spheres of HOLE, whose radii are not those of
        elements.
    """
    check_not_cut(path, data, (b"END", b"TER", b"MASTER", b"CONECT"))
    if damaged := _DAMAGED.search(data):
        raise PackingFileError(
            f"{path}, line {_line(data, damaged.start())}: found {_quoted(damaged[0])}, expected "
            "ATOM, HETATM or a record without coordinates"
        )
    if (first := _ATOM.search(data)) and first[0][13:20] in (b"QSS SPH", b"QC1 SPH"):
        raise PackingFileError(
            f"{path}, line {_line(data, first.start())}: found {_quoted(first[0])}, the spheres of "
            "a pore by HOLE, expected atoms; such a file is read by the name .sph"
        )
    records = [(match.start(), match[0]) for match in _ATOM.finditer(data)]
    fields = np.array([record[_COORDINATES].ljust(24) for _, record in records], "S24")
    try:
        finite = bool(np.isfinite(fields.view("S8").astype(float)).all())
    except ValueError:
        finite = False
    if finite:
        return
    for start, record in records:
        if not _has_coordinates(record):
            raise PackingFileError(
                f"{path}, line {_line(data, start)}: found {_quoted(record)}, expected x y z in "
                "columns 31 to 54, 8 characters each"
            )


def check_not_cut(path: Path, data: bytes, kept: tuple[bytes, ...]) -> None:
    """Check that a file does not end within a line, unless nothing can be missing there.

    Parameters
    ----------
    path : pathlib.Path
        File, for the message.
    data : bytes
        Its content.
    kept : tuple of bytes
        What a last line may begin with, or be the beginning of, that has no line end.

    Raises
    ------
    PackingFileError
        If it ends within another line.
    """
    begin = max(data.rfind(b"\n"), data.rfind(b"\r")) + 1
    last = data[begin:]
    if last.strip() and not any(last.startswith(word) or word.startswith(last) for word in kept):
        raise PackingFileError(
            f"{path}, line {_line(data, begin)}: found the end of the file within "
            f"{_quoted(last)}, expected a line end after every line (add one if the file is "
            "complete)"
        )


def _has_coordinates(record: bytes) -> bool:
    """Whether the three fields of a record are finite numbers."""
    field = record[_COORDINATES].ljust(24)
    try:
        return bool(np.isfinite([float(field[i : i + 8]) for i in (0, 8, 16)]).all())
    except ValueError:
        return False


def _line(data: bytes, at: int) -> int:
    """Number of the line that a byte lies in."""
    return data.count(b"\n", 0, at) + 1


def _quoted(record: bytes) -> str:
    return repr(record.decode("ascii", "backslashreplace").rstrip()[:60])
