"""Open Babel: a PQR file with the element behind the radius."""

from __future__ import annotations

from typing import TYPE_CHECKING

from truth import Written, table

from .pdb2pqr import PEPTIDE

if TYPE_CHECKING:
    from pathlib import Path

    from installed import Installed

_SCRIPT = """
from importlib.metadata import version
from openbabel import pybel

molecule = pybel.readstring("pdb", open("in.pdb").read())
molecule.write("pqr", "atoms.pqr", overwrite=True)
print("version", version("openbabel-wheel"))
"""


def write(installed: Installed, folder: Path) -> tuple[str, list[Written]]:
    (folder / "in.pdb").write_text(PEPTIDE)
    version = installed.run_python(_SCRIPT, folder).split("version ")[1].split()[0]
    text = (folder / "atoms.pqr").read_text().splitlines()
    atoms = [line for line in text if line.startswith(("ATOM", "HETATM"))]
    rows = ([line[30:38], line[38:46], line[46:54], *line[54:].split()[:2]] for line in atoms)
    return version, [Written("atoms.pqr", [table(rows, "x y z q r")])]
