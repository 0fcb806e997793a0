"""MDAnalysis: a PQR file whose fields blanks divide."""

from __future__ import annotations

from typing import TYPE_CHECKING

from truth import Written, table

if TYPE_CHECKING:
    from pathlib import Path

    from installed import Installed

_SCRIPT = """
import MDAnalysis

universe = MDAnalysis.Universe.empty(3, n_residues=1, atom_resindex=[0] * 3, trajectory=True)
attributes = dict(
    names=["N", "CA", "O"], resnames=["ALA"], resids=[1], segids=["A"], record_types=["ATOM"] * 3,
    charges=[-0.3, 0.1, 0.2], radii=[1.55, 1.7, 1.52345678])
for name, values in attributes.items():
    universe.add_TopologyAttr(name, values)
universe.atoms.positions = [[0.1, 0.2, 0.3], [1234.567, 2200.5, -3103.25], [-0.25, 1, 4]]
universe.atoms.write("atoms.pqr")
print("version", MDAnalysis.__version__)
"""


def write(installed: Installed, folder: Path) -> tuple[str, list[Written]]:
    version = installed.run_python(_SCRIPT, folder).split("version ")[1].split()[0]
    text = (folder / "atoms.pqr").read_text().splitlines()
    rows = (line.split()[-5:] for line in text if line.startswith("ATOM"))
    return version, [Written("atoms.pqr", [table(rows, "x y z q r")])]
