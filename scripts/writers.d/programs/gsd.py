"""GSD, the files of HOOMD-blue: steps with diameters, without them, and in two dimensions."""

from __future__ import annotations

from typing import TYPE_CHECKING

from truth import Written, told, with_and_without_radius

if TYPE_CHECKING:
    from pathlib import Path

    from installed import Installed

_SCRIPT = """
import json
import gsd.hoomd
import gsd.version
import numpy as np

lx, ly, lz, xy, xz, yz = box = [4, 5, 6, 0.125, 0.25, 0.5]
flat = [4, 5, 0, 0, 0, 0]

def frame(step, diameters, box=box):
    made = gsd.hoomd.Frame()
    made.configuration.step = step
    made.configuration.box = box
    made.configuration.dimensions = 3 if box[2] else 2
    particles = made.particles
    particles.N = 3
    particles.position = np.float32([[0.1, 0.2, 0.3], [-1.5, 2, 2.5], [1.25, -2.25, -1]])
    particles.position = particles.position + np.float32(0.001 * step)
    if not box[2]:
        particles.position[:, 2] = 0
    particles.types = ["A", "B"]
    particles.typeid = [0, 1, 0]
    particles.image = [[0, 0, 0], [1, 0, 0], [0, -1, 0]]
    particles.velocity = [[1, 0, 0]] * 3
    if diameters:
        particles.diameter = [0.5, 0.75, 1 / 3]
    return made

files = {
    "steps.gsd": [frame(0, True), frame(100, True)],
    "absent.gsd": [frame(0, False)],
    "flat.gsd": [frame(0, True, flat)],
}
said = {}
for name, frames in files.items():
    with gsd.hoomd.open(name, "w") as file:
        file.extend(frames)
    vectors = [[lx, 0, 0], [xy * ly, ly, 0], [xz * lz, yz * lz, lz]]
    origin = (-0.5 * np.sum(vectors, axis=0)).tolist()
    cell = dict(vectors=vectors, origin=origin, periodic=[True] * 3)
    said[name] = []
    with gsd.hoomd.open(name) as file:
        for read in file:
            radii = None if name == "absent.gsd" else read.particles.diameter.astype(float) / 2
            said[name].append(dict(
                positions=read.particles.position.astype(float).tolist(),
                radii=None if radii is None else radii.tolist(),
                cell=None if name == "flat.gsd" else cell))
with open("told.json", "w") as file:
    json.dump(said, file)
print("version", gsd.version.version)
"""


def write(installed: Installed, folder: Path) -> tuple[str, list[Written]]:
    version = installed.run_python(_SCRIPT, folder).split("version ")[1].split()[0]
    files = {file.name: file for file in told(folder / "told.json")}
    absent = files.pop("absent.gsd")
    return version, [*files.values(), *with_and_without_radius("absent.gsd", absent.steps)]
