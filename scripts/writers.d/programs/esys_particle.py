"""ESyS-Particle: snapshots of a run, and the geometry file that dump2geo makes of them."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from truth import Cell, Written, table

if TYPE_CHECKING:
    from pathlib import Path

    from installed import Installed

_GEOMETRY = """LSMGeometry 1.2
BoundingBox -20 -20 -20 20 20 20
PeriodicBoundaries 0 0 0
Dimension 3D
BeginParticles
Simple
3
-5.123456789 5 -5 1.2345678901 0 1
5 0.3333333333333333 5 1.5 7 2
1.25 2.5 -3.75 0.625 3 1
EndParticles
BeginConnect
0
EndConnect
"""
_SCRIPT = """
from esys.lsm import *
from esys.lsm.util import Vec3, BoundingBox
sim = LsmMpi(numWorkerProcesses=1, mpiDimList=[1, 1, 1])
sim.initNeighbourSearch(particleType="{kind}", gridSpacing=4.0, verletDist=0.5)
sim.setNumTimeSteps(20)
sim.setTimeStepSize(0.01)
sim.setSpatialDomain(BoundingBox(Vec3(-20, -20, -20), Vec3(20, 20, 20)))
if {read}:
    sim.readGeometry("in.geo")
else:
    for n, x, y, z, radius in ((0, -5.123456789, 5, -5, 1.2345678901), (7, 5, 1 / 3, 5, 1.5)):
        particle = {kind}(id=n, posn=Vec3(x, y, z), radius=radius, mass=2.0)
        particle.setLinearVelocity(Vec3(1, -1, 0.25))
        sim.createParticle(particle)
sim.createCheckPointer(CheckPointPrms(fileNamePrefix="{prefix}", beginTimeStep=0, endTimeStep=20,
    timeStepIncr=20))
sim.run()
"""
_CELL = Cell([[40, 0, 0], [0, 40, 0], [0, 0, 40]], [-20, -20, -20], [False] * 3)


def write(installed: Installed, folder: Path) -> tuple[str, list[Written]]:
    (folder / "in.geo").write_text(_GEOMETRY)
    for prefix, kind, read in (("made", "NRotSphere", False), ("read", "RotSphere", True)):
        (folder / "run.py").write_text(_SCRIPT.format(prefix=prefix, kind=kind, read=read))
        command = ["mpirun.openmpi", "-np", "2", "esysparticle", "run.py"]
        installed.run_debian(command, folder)
    # Upstream: Debian's build of 2.3.5 has no revision to write behind this, and dump2geo, which
    # expects it, would write no particle and a box of whatever is in memory. Of the others the head
    # stays as it is.
    for head in folder.glob("read_*_0.txt"):
        head.write_text(re.sub(r"(bzr_rev\.) \n", r"\1 1\n", head.read_text()))
    tool = ["dump2geo", "-i", "read", "-o", "dump", "-t", "0", "1", "20", "-rot"]
    installed.run_debian(tool, folder)
    files = []
    for name in ("in.geo", "dump0.geo"):
        rows = _after(folder / name, "Simple")
        files.append(Written(name, [table(rows, "x y z r id tag", _CELL)]))
    for prefix in ("made", "read"):
        rows = _after(folder / f"{prefix}_t=20_1.txt", None)
        files.append(Written(f"{prefix}_t=20_0.txt", [table(rows, _SNAPSHOT, _CELL)]))
    head = (folder / "made_t=20_0.txt").read_text()
    return head.split("ESyS-Particle_")[1].split("_")[0], files


_SNAPSHOT = "x y z r id tag mass"  # and initial and old positions, velocity, force, …


def _after(path: Path, word: str | None) -> list[list[str]]:
    """Return the rows that follow a number of rows: the first line, or that after `word`."""
    text = path.read_text().splitlines()
    start = 0 if word is None else text.index(word) + 1
    return [line.split() for line in text[start + 1 : start + 1 + int(text[start])]]
