"""LIGGGHTS: dumps, legacy VTK files and data files of a run whose first step is empty."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from truth import Cell, Step, Written, dump, table

if TYPE_CHECKING:
    from pathlib import Path

    from installed import Installed

_SCRIPT = """
atom_style granular
atom_modify map array
boundary f p f
newton off
communicate single vel yes
units si
region box block -0.5 1 0 1 0 1 units box
create_box 2 box
neighbor 0.1 bin
fix m1 all property/global youngsModulus peratomtype 5.e6 5.e6
fix m2 all property/global poissonsRatio peratomtype 0.45 0.45
fix m3 all property/global coefficientRestitution peratomtypepair 2 0.95 0.95 0.95 0.95
fix m4 all property/global coefficientFriction peratomtypepair 2 0.05 0.05 0.05 0.05
pair_style gran model hertz tangential history
pair_coeff * *
neigh_modify delay 0
timestep 0.0001
fix pull all gravity 9.81 vector 0.0 0.0 -1.0
fix small all particletemplate/sphere 15485863 atom_type 1 density constant 2500 &
  radius constant 0.05
fix large all particletemplate/sphere 15485867 atom_type 2 density constant 2500 &
  radius constant 0.0731
fix mixed all particledistribution/discrete 32452843 2 small 0.3 large 0.7
fix pour all insert/pack seed 32452867 distributiontemplate mixed vel constant 0. -20. -0.5 &
  insert_every once overlapcheck yes all_in yes particles_in_region 20 region box
fix move all nve/sphere
dump 1 all custom 100 run.liggghts id type x y z ix iy iz vx vy vz omegax omegay omegaz radius
dump 2 all custom 100 fractions.dump id type xs ys zs diameter
dump 3 all custom 100 unwrapped.dump id type xu yu zu radius
dump 4 all custom/vtk 300 particles_*.vtk id type x y z vx vy vz radius
run 1
run 300 upto
write_data run.data
"""
_EDGES = [[1.5, 0, 0], [0, 1, 0], [0, 0, 1]]
_CELL = Cell(_EDGES, [-0.5, 0, 0], [False, True, False])


def write(installed: Installed, folder: Path) -> tuple[str, list[Written]]:
    (folder / "in.script").write_text(_SCRIPT)
    printed = installed.run_debian(["liggghts", "-in", "in.script"], folder)
    version = re.search(r"Version LIGGGHTS-PUBLIC ([\d.]+)", printed + _text(folder, "run.data"))
    dumps = ["run.liggghts", "fractions.dump", "unwrapped.dump"]
    return version[1] if version else "?", [
        *(Written(name, dump(_text(folder, name), _CELL)) for name in dumps),
        Written("particles_300.vtk", [_vtk(_text(folder, "particles_300.vtk"))]),
        Written("run.data", [_data(_text(folder, "run.data"))]),
    ]


def _text(folder: Path, name: str) -> str:
    return (folder / name).read_text()


def _vtk(text: str) -> Step:
    """Return what a legacy file holds in ASCII: its words after POINTS and after radius."""
    words = text.split()

    def numbers(start: int, count: int) -> list[str]:
        return words[start : start + count]

    points = words.index("POINTS")
    count = int(words[points + 1])
    xyz = numbers(points + 3, 3 * count)
    radii = numbers(words.index("radius") + 4, count)
    step = table(([*xyz[3 * i : 3 * i + 3], radii[i]] for i in range(count)), "x y z r")
    assert words[points + 2] == "float"
    return replace(step, positions=np.float32(step.positions).astype(float))


def _data(text: str) -> Step:
    body = text.split("\nAtoms\n")[1].split("Velocities")[0]
    rows = [line.split() for line in body.splitlines() if line.strip()]
    return table(rows, "id type d density x y z ix iy iz", Cell(_EDGES, [-0.5, 0, 0]))
