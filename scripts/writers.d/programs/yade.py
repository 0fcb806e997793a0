"""YADE: texts of yade.export and SpherePack.save, and VTK files."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from truth import Cell, Written, lines, table, told

if TYPE_CHECKING:
    from pathlib import Path

    from installed import Installed

_SCRIPT = """
import json
import numpy
from yade import pack, export, utils
O.materials.append(FrictMat(label='stone'))
O.bodies.append([utils.sphere((0.1, 0.2, 0.3), 0.05123456789012345),
                 utils.sphere((1.1, -0.2, 2.3), 1.5e-7, color=(1, 0, 0))])
O.bodies.appendClumped([utils.sphere((0.5, 0.5, 0.5), .1), utils.sphere((0.6, 0.5, 0.5), .07)])
O.bodies.append(utils.wall(0, axis=2))
export.text('text.txt')
export.textExt('ids.txt', format='id_x_y_z_r_matId', comment='x y z d\\n')
export.textExt('attributes.txt', format='x_y_z_r_attrs', attrs=('b.state.vel', 'b.state.mass'))
export.textClumps('clumps.txt')
packed = pack.SpherePack([((.1, .2, .3), .05), ((.9, .8, 1 / 3.), .1 / 3)])
packed.cellSize = (1, 2, 3)
packed.save('pack.txt')
export.VTKExporter('exported').exportSpheres(what=dict(speed='b.state.vel.norm()'))
recorder = VTKRecorder(iterPeriod=1, recorders=['spheres', 'colors', 'velocity', 'clumpId'],
                       fileName='recorded-')
O.engines = [ForceResetter(), NewtonIntegrator(), recorder]
O.dt = 1e-4
O.step()
bodies = [b for b in O.bodies if isinstance(b.shape, Sphere)]
step = dict(positions=numpy.float32([list(b.state.pos) for b in bodies]).tolist(),
            radii=[float(b.shape.radius) for b in bodies])
with open('told.json', 'w') as file:
    json.dump({'recorded-spheres.0.vtu': [step]}, file)
"""


def write(installed: Installed, folder: Path) -> tuple[str, list[Written]]:
    (folder / "run.py").write_text(_SCRIPT)
    printed = installed.run_debian(["yade", "-n", "-x", "run.py"], folder)
    version = re.search(r"Welcome to Yade (\S+)", printed)
    cell = Cell([[1, 0, 0], [0, 2, 0], [0, 0, 3]], [0, 0, 0], [True] * 3)
    files = [
        Written(name, [table(lines(folder / name), names, cell if name == "pack.txt" else None)])
        for name, names in (
            ("text.txt", "x y z r"),
            ("ids.txt", "id x y z r material"),
            ("attributes.txt", "x y z r vx vy vz mass"),
            ("clumps.txt", "x y z r clump"),
            ("pack.txt", "x y z r clump"),
        )
    ]
    exported = "exported-spheres-00000000.vtk"
    text = (folder / exported).read_text()
    points = text.split("double\n")[1].split("POINT_DATA")[0].split()
    radii = (
        re.split(r"SCALARS radius.*\nLOOKUP_TABLE default\n", text)[1].split("SCALARS")[0].split()
    )
    rows = ([*points[3 * i : 3 * i + 3], r] for i, r in enumerate(radii))
    files.append(Written(exported, [table(rows, "x y z r")]))
    return version[1] if version else "?", files + told(folder / "told.json")
