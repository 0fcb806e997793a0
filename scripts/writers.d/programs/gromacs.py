"""GROMACS: the PQR file that editconf -mead writes of a peptide."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from truth import Written, table

from .pdb2pqr import PEPTIDE

if TYPE_CHECKING:
    from pathlib import Path

    from installed import Installed

_FORCE_FIELD = ["-ff", "amber99sb", "-water", "none", "-ignh"]


def write(installed: Installed, folder: Path) -> tuple[str, list[Written]]:
    (folder / "in.pdb").write_text(PEPTIDE.partition("HETATM")[0])
    (folder / "run.mdp").write_text("; as it is by default\n")
    steps = [
        ["pdb2gmx", "-f", "in.pdb", "-o", "in.gro", *_FORCE_FIELD],
        ["editconf", "-f", "in.gro", "-o", "boxed.gro", "-box", "200", "200", "200", "-noc"],
        ["grompp", "-f", "run.mdp", "-c", "boxed.gro", "-p", "topol.top", "-maxwarn", "9"],
        ["editconf", "-f", "topol.tpr", "-mead", "atoms.pqr"],
    ]
    for step in steps:
        printed = installed.run_debian(["gmx", *step], folder)
    version = re.search(r"GROMACS - gmx editconf, ([\d.]+)", printed)
    text = (folder / "atoms.pqr").read_text().splitlines()
    rows = (line.split()[-5:] for line in text if line.startswith("ATOM"))
    return version[1] if version else "?", [Written("atoms.pqr", [table(rows, "x y z q r")])]
