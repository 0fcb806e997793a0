"""Voro++: lists of particles, and of the volumes of their cells, with -r for radii."""

from __future__ import annotations

import gzip
from typing import TYPE_CHECKING

from truth import Written, lines, table

if TYPE_CHECKING:
    from pathlib import Path

    from installed import Installed

_PARTICLES = "1 2.3 1.25 0.7 0.5\n12 3.5 2.125 1.9 0.3\n3 1.1 2 3 0.6123456789\n"


def write(installed: Installed, folder: Path) -> tuple[str, list[Written]]:
    (folder / "in.txt").write_text(_PARTICLES)
    installed.run_debian(["voro++", "-r", "0", "5", "0", "5", "0", "5", "in.txt"], folder)
    files = [("in.txt", "id x y z r"), ("in.txt.vol", "id x y z volume r")]
    changes = installed.debian / "usr/share/doc/voro++/changelog.Debian.gz"
    version = gzip.decompress(changes.read_bytes()).decode().split("(")[1].split(")")[0]
    return version.split("to-")[-1].split("+")[0], [
        Written(name, [table(lines(folder / name), names)], {"columns": names})
        for name, names in files
    ]
