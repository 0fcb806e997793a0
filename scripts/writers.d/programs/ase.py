"""ASE: extended XYZ with an array of radii, and files of formats that have none."""

from __future__ import annotations

from typing import TYPE_CHECKING

from truth import Cell, Step, Written, lines, table, with_and_without_radius

if TYPE_CHECKING:
    from pathlib import Path

    from installed import Installed

_SCRIPT = """
import ase
import numpy as np
from ase.io import write

atoms = ase.Atoms("H2O", positions=[[0.1, 0.2, 0.3], [1 / 3, 2.5, 3.5], [-0.25, 1, 4]],
                  cell=[[4, 0, 0], [0.5, 5, 0], [0, 0, 6]], pbc=(True, True, False))
atoms.arrays["radius"] = np.array([0.5, 0.123456789012345, 0.25])
atoms.set_velocities([[1, 0, 0]] * 3)
atoms.info["time"] = 2.5
later = atoms.copy()
later.positions += 1
write("steps.extxyz", [atoms, later])
write("extended.xyz", atoms)
write("plain.xyz", atoms, format="xyz")
write("atomic.data", atoms, format="lammps-data")
print("version", ase.__version__)
"""
_CELL = Cell([[4, 0, 0], [0.5, 5, 0], [0, 0, 6]], [0, 0, 0], [True, True, False])


def write(installed: Installed, folder: Path) -> tuple[str, list[Written]]:
    version = installed.run_python(_SCRIPT, folder).split("version ")[1].split()[0]

    def xyz(name: str) -> list[Step]:
        rows = [line.split() for line in (folder / name).read_text().splitlines()]
        size = 2 + int(rows[0][0])
        starts = range(0, len(rows), size)
        return [table(rows[s + 2 : s + size], "species x y z r", _CELL) for s in starts]

    plain = table(lines(folder / "plain.xyz")[1:], "species x y z")
    body = (folder / "atomic.data").read_text().split("# atomic\n")[1]
    data = table((line.split() for line in body.splitlines() if line.strip()), "id type x y z")
    return version, [
        Written("steps.extxyz", xyz("steps.extxyz")),
        Written("extended.xyz", xyz("extended.xyz")),
        *with_and_without_radius("plain.xyz", [plain]),
        *with_and_without_radius("atomic.data", [data]),
    ]
