"""What is raised about files."""

from __future__ import annotations


class PackingFileError(ValueError):
    """A file is no sphere packing; the message names file and line, what was found and expected."""
