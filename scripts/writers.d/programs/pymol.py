"""PyMOL: PQR files, and the atoms of PDB and mmCIF files, which have no radii but elements."""

from __future__ import annotations

from typing import TYPE_CHECKING

from truth import Written, table

from .pdb2pqr import PEPTIDE

if TYPE_CHECKING:
    from pathlib import Path

    from installed import Installed

_SCRIPT = """
from pymol import cmd

cmd.load("in.pdb")
cmd.alter("all", "partial_charge = 0.25")
cmd.alter("all", "elec_radius = vdw + 0.0625")  # 0 unless one says what it is
for name in ("atoms.pqr", "atoms.pdb", "atoms.cif"):
    cmd.save(name)
print("version", cmd.get_version()[0])
"""
# Radii of van der Waals by A. Bondi, "van der Waals Volumes and Radii", J. Phys. Chem. 68, 1964.
_BONDI = {"C": "1.7", "N": "1.55", "O": "1.52"}


def write(installed: Installed, folder: Path) -> tuple[str, list[Written]]:
    (folder / "in.pdb").write_text(PEPTIDE)
    version = installed.run_python(_SCRIPT, folder).split("version ")[1].split()[0]

    def atoms(name: str) -> list[str]:
        text = (folder / name).read_text().splitlines()
        return [line for line in text if line.startswith(("ATOM", "HETATM"))]

    # From 1000 on, coordinates in its PQR files have fewer decimals, which leaves room for a blank.
    pqr = [line.split()[-5:] for line in atoms("atoms.pqr")]
    pdb = [
        [line[30:38], line[38:46], line[46:54], _BONDI[line[76:78].strip()]]
        for line in atoms("atoms.pdb")
    ]
    header = (folder / "atoms.cif").read_text().split("_atom_site.group_PDB")[1].split("ATOM")[0]
    names = ["group_PDB", *(word.removeprefix("_atom_site.") for word in header.split())]
    columns = [names.index(name) for name in ("Cartn_x", "Cartn_y", "Cartn_z", "type_symbol")]
    cif = [[line.split()[column] for column in columns] for line in atoms("atoms.cif")]
    return version, [
        Written("atoms.pqr", [table(pqr, "x y z q r")]),
        Written("atoms.pdb", [table(pdb, "x y z r")]),
        Written("atoms.cif", [table(([*row[:3], _BONDI[row[3]]] for row in cif), "x y z r")]),
    ]
