"""Files in a series that are one run to a user: patterns, lists, .series and .pvd."""

from __future__ import annotations

import glob
import json
import os
import re
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from ..printable import printable
from .errors import PackingFileError
from .vtk_files import parts_by_time

if TYPE_CHECKING:
    from collections.abc import Sequence


class Entry(NamedTuple):
    """Files of one point of time, whose spheres belong together.

    Attributes
    ----------
    files : list[pathlib.Path]
        One or more.
    time : float or None
        The time that the series says; None if the file knows it better.
    number : float or None
        Number in the name, which serves where no file knows a time.
    named_by : pathlib.Path or None
        File that names them.
    """

    files: list[Path]
    time: float | None = None
    number: float | None = None
    named_by: Path | None = None

    @property
    def is_there(self) -> bool:
        """Whether all files that an index names exist; others are not looked for."""
        return self.named_by is None or all(file.exists() for file in self.files)

    def check(self) -> None:
        """Raise a FileNotFoundError if one that an index names does not exist."""
        for file in self.files:
            if self.named_by is not None and not file.exists():
                raise FileNotFoundError(
                    printable(
                        f"{self.named_by}: found the file {file} in it, which does not exist, "
                        "expected one that does; step= and --step take other steps"
                    )
                )


def entries_of(path: str | os.PathLike[str] | Sequence[str | os.PathLike[str]]) -> list[Entry]:
    """Files that a path stands for.

    Parameters
    ----------
    path : str, os.PathLike or sequence of these
        A file; a list of files, in this order; a pattern with ``*``, ``?`` or ``[]``, or with one
        ``%d`` or ``%04d``, whose files are put in the order of the numbers in their names; or a
        file ``.series`` or ``.pvd`` that names others.

    Returns
    -------
    list[Entry]
        Not empty.

    Raises
    ------
    FileNotFoundError
        If no file fits a pattern.
    PackingFileError
        If a file that names others is none, or the files of two runs fit a pattern.
    ValueError
        If the list is empty.
    """
    if not isinstance(path, (str, os.PathLike)):
        files = [Path(item).expanduser() for item in path]
        if not files:
            raise ValueError("path: found no file in the list, expected one or more")
        return _numbered(files)
    single = Path(path).expanduser()
    if single.exists():
        if single.suffix.lower() == ".series":
            return _from_series(single)
        if single.suffix.lower() == ".pvd":
            return [Entry(files, time, named_by=single) for time, files in parts_by_time(single)]
        return [Entry([single])]
    fitting = _fitting(str(single))
    return [Entry([single])] if fitting is None else _numbered(fitting)


def _fitting(pattern: str) -> list[Path] | None:
    """Files that fit a pattern, in order; None if it is none."""
    number = re.search(r"%(0\d+)?d", pattern)
    if number is not None:
        before, after = pattern[: number.start()], pattern[number.end() :]
        width = int(number[1] or 0)
        found = [
            name
            for name in glob.glob(f"{glob.escape(before)}*{glob.escape(after)}")
            if (digits := name[len(before) : len(name) - len(after)]).isdigit()
            and len(digits) >= width
            and (len(digits) == width or digits[0] != "0" or digits == "0")
        ]
    elif glob.has_magic(pattern):
        found = [name for name in glob.glob(pattern) if not Path(name).is_dir()]
        _check_one_run(pattern, sorted(found, key=_natural))
    else:
        return None
    if not found:
        raise FileNotFoundError(printable(f"{pattern}: there is no file whose name fits"))
    return [Path(name) for name in sorted(found, key=_natural)]


def _check_one_run(pattern: str, names: list[str]) -> None:
    """Raise a PackingFileError if files have the same numbers in names that differ otherwise.

    LIGGGHTS writes ``part_boundingBox_100.vtk`` beside ``part_100.vtk``.
    """
    first: dict[tuple[str, ...], str] = {}  # by numbers
    seen: set[tuple[str, ...]] = set()
    for name in names:
        parts = re.split(r"(\d+)", name)
        other = first.setdefault(tuple(parts[1::2]), name)
        stem, other_stem = (tuple(re.split(r"\d+", n)) for n in (name, other))
        if stem != other_stem and (*stem, *other_stem) in seen:
            raise PackingFileError(
                f"{pattern}: found the files of two runs, such as {Path(other).name} and "
                f"{Path(name).name}, expected those of one: {'[0-9]*'.join(other_stem)} or "
                f"{'[0-9]*'.join(stem)}"
            )
        seen.add((*stem, *other_stem))


def _natural(name: str) -> list[tuple[int, str]]:
    """Key that sorts numbers in names by their values."""
    parts = re.split(r"(\d+)", name)
    return [(int(part), "") if i % 2 else (0, part) for i, part in enumerate(parts)]


def _numbered(files: list[Path]) -> list[Entry]:
    """Entries of files, with the number by which their names differ."""
    if len(files) == 1:
        return [Entry(files)]
    parts = [re.split(r"(\d+)", file.name) for file in files]
    if len({len(p) for p in parts}) == 1:
        differ = [i for i in range(len(parts[0])) if len({p[i] for p in parts}) > 1]
        if len(differ) == 1 and differ[0] % 2:
            return [
                Entry([file], number=float(part[differ[0]]))
                for file, part in zip(files, parts, strict=True)
            ]
    return [Entry([file]) for file in files]


def _from_series(path: Path) -> list[Entry]:
    """Entries of ParaView's .series, a JSON file."""
    try:
        files = json.loads(path.read_text("utf-8"))["files"]
        entries = [
            Entry([path.parent / file["name"]], float(file["time"]), named_by=path)
            for file in files
        ]
    except (ValueError, KeyError, TypeError) as error:
        raise PackingFileError(
            f"{path}: found no list of files with times, expected one in JSON: {error}"
        ) from None
    if not entries:
        raise PackingFileError(f"{path}: found no file in it, expected one or more")
    return entries
