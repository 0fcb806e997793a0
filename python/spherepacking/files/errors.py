"""What is raised about files."""

from __future__ import annotations

from ..printable import printable

_LONGEST = 1000  # characters of a sentence, which names files, arrays and columns


class FileError(ValueError):
    """A file is not what it should be; the message names it, what was found and expected.

    Parameters
    ----------
    message : str
        A sentence, of which no letter changes how a terminal shows the others.
    """

    def __init__(self, message: str) -> None:
        super().__init__(printable(message, _LONGEST))


class PackingFileError(FileError):
    """A file holds no sphere packing; the message names file, line, what was found and expected."""


class SurfaceFileError(FileError):
    """A file holds no surface; the message names file, line, what was found and expected."""
