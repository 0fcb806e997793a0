"""What is raised about files."""

from __future__ import annotations


class PackingFileError(ValueError):
    """A file holds no sphere packing; the message names file, line, what was found and expected."""


class SurfaceFileError(ValueError):
    """A file holds no surface; the message names file, line, what was found and expected."""
