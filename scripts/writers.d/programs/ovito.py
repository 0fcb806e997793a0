"""OVITO: what it exports of spheres in a triclinic box with an origin."""

from __future__ import annotations

from typing import TYPE_CHECKING

from truth import Cell, Step, Written, dump, table, told

if TYPE_CHECKING:
    from pathlib import Path

    from installed import Installed

_SCRIPT = """
import json
import gsd.hoomd
import numpy as np
import ovito
from ovito.data import DataCollection
from ovito.io import export_file

data = DataCollection()
particles = data.create_particles(count=3)
particles.create_property("Position", data=[[0.1, 0.2, 0.3], [1 / 3, 2.5, 3.5], [-0.25, 1, 4]])
particles.create_property("Radius", data=[0.5, 0.123456789012345, 0.25])
particles.create_property("Particle Identifier", data=[3, 1, 2])
particles.create_property("Velocity", data=[[1, 0, 0]] * 3)
data.create_cell(np.array([[4, 0.5, 0, -1], [0, 5, 0, 0], [0, 0, 6, 0]]), pbc=(True, True, False))
columns = ["Particle Identifier", "Position.X", "Position.Y", "Position.Z", "Radius",
           "Velocity.X", "Velocity.Y", "Velocity.Z"]
export_file(data, "general.dump", "lammps/dump", columns=columns)
export_file(data, "restricted.dump", "lammps/dump", columns=columns, restricted_triclinic=True)
export_file(data, "extended.xyz", "xyz", columns=columns)
export_file(data, "precise.xyz", "xyz", columns=columns, precision=17)
export_file(data, "sphere.data", "lammps/data", atom_style="sphere")
export_file(data, "exported.imd", "imd", columns=columns)
export_file(data, "exported.gsd", "gsd/hoomd")
# That format has its box around zero and in terms of its own, and OVITO sorts by identifier.
with gsd.hoomd.open("exported.gsd") as file:
    frame = file[0]
lx, ly, lz, xy, xz, yz = frame.configuration.box.astype(float)
vectors = np.array([[lx, 0, 0], [xy * ly, ly, 0], [xz * lz, yz * lz, lz]])
step = dict(positions=frame.particles.position.astype(float).tolist(),
            radii=(0.5 * frame.particles.diameter.astype(float)).tolist(),
            cell=dict(vectors=vectors.tolist(), origin=(-0.5 * vectors.sum(axis=0)).tolist(),
                      periodic=[True, True, True]))
with open("told.json", "w") as file:
    json.dump({"exported.gsd": [step]}, file)
print("version", ovito.version_string)
"""
_EDGES = [[4, 0, 0], [0.5, 5, 0], [0, 0, 6]]
_CELL = Cell(_EDGES, [-1, 0, 0], [True, True, False])


def write(installed: Installed, folder: Path) -> tuple[str, list[Written]]:
    version = installed.run_python(_SCRIPT, folder).split("version ")[1].split()[0]

    def text(name: str) -> str:
        return (folder / name).read_text()

    def xyz(name: str) -> Step:
        rows = [line.split() for line in text(name).splitlines()[2:]]
        return table(rows, "id x y z r vx vy vz", _CELL)

    body = text("sphere.data").split("# sphere\n")[1].split("Velocities")[0]
    data = table(
        [line.split() for line in body.splitlines() if line.strip()],
        "id type d density x y z",
        Cell(_EDGES, [-1, 0, 0]),
    )
    imd = table(
        [line.split() for line in text("exported.imd").split("#E\n")[1].splitlines()],
        "id x y z vx vy vz r",
    )
    return version, [
        *(Written(name, dump(text(name), _CELL)) for name in ("general.dump", "restricted.dump")),
        *(Written(name, [xyz(name)]) for name in ("extended.xyz", "precise.xyz")),
        Written("sphere.data", [data]),
        Written("exported.imd", [imd]),
        *told(folder / "told.json"),
    ]
