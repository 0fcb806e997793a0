"""OVITO: what it exports of spheres in a triclinic box with an origin."""

from __future__ import annotations

from typing import TYPE_CHECKING

from truth import Cell, Step, Written, dump, table, told

if TYPE_CHECKING:
    from pathlib import Path

    from installed import Installed

_SCRIPT = """
import json
import numpy as np
import ovito
from ovito.data import DataCollection
from ovito.io import export_file

def spheres(origin, periodic):
    data = DataCollection()
    particles = data.create_particles(count=3)
    particles.create_property("Position", data=[[0.1, 0.2, 0.3], [1 / 3, 2.5, 3.5], [-0.25, 1, 4]])
    particles.create_property("Radius", data=[0.5, 0.123456789012345, 0.25])
    particles.create_property("Particle Identifier", data=[3, 1, 2])
    particles.create_property("Velocity", data=[[1, 0, 0]] * 3)
    data.create_cell(np.array([[4, 0.5, 0], [0, 5, 0], [0, 0, 6]]) @ np.eye(3, 4)
                     + np.outer(origin, [0, 0, 0, 1]), pbc=periodic)
    return data

data = spheres([-1, 0, 0], (True, True, False))
columns = ["Particle Identifier", "Position.X", "Position.Y", "Position.Z", "Radius",
           "Velocity.X", "Velocity.Y", "Velocity.Z"]
export_file(data, "general.dump", "lammps/dump", columns=columns)
export_file(data, "restricted.dump", "lammps/dump", columns=columns, restricted_triclinic=True)
export_file(data, "extended.xyz", "xyz", columns=columns)
export_file(data, "precise.xyz", "xyz", columns=columns, precision=17)
export_file(data, "sphere.data", "lammps/data", atom_style="sphere")
export_file(data, "exported.imd", "imd", columns=columns)
data = spheres([-2.25, -2.5, -3], (True, True, True))  # around zero, as that format has it
export_file(data, "exported.gsd", "gsd/hoomd")
particles = data.particles
positions = np.float32(particles.positions).astype(float).tolist()
radii = (0.5 * np.float32(2 * np.array(particles["Radius"])).astype(float)).tolist()
cell = dict(vectors=data.cell[:, :3].T.tolist(), origin=data.cell[:, 3].tolist(),
            periodic=[True, True, True])
with open("told.json", "w") as file:
    json.dump({"exported.gsd": [dict(positions=positions, radii=radii, cell=cell)]}, file)
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
