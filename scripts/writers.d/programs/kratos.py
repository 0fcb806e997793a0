"""Kratos: model parts of the DEM application, with radii as data of nodes."""

from __future__ import annotations

from typing import TYPE_CHECKING

from truth import Written, table

if TYPE_CHECKING:
    from pathlib import Path

    from installed import Installed

_SCRIPT = """
import KratosMultiphysics as Kratos
import KratosMultiphysics.DEMApplication

model = Kratos.Model()
part = model.CreateModelPart("SpheresPart")
part.AddNodalSolutionStepVariable(Kratos.RADIUS)
part.AddNodalSolutionStepVariable(Kratos.VELOCITY)
properties = part.CreateNewProperties(1)
spheres = [(10, 0.1, 0.2, 0.3, 0.05123456789012345), (30, 1 / 3, 2.5, 3.5, 0.25),
           (20, -0.25, 1, 4, 1e-3)]
for element, (number, x, y, z, radius) in enumerate(spheres, 1):
    node = part.CreateNewNode(number, x, y, z)
    node.SetSolutionStepValue(Kratos.RADIUS, radius)
    node.SetSolutionStepValue(Kratos.VELOCITY, [1.0, 0, 0])
    part.CreateNewElement("SphericParticle3D", element, [number], properties)
Kratos.ModelPartIO("spheres", Kratos.IO.WRITE).WriteModelPart(part)
print("version", Kratos.Kernel.Version().replace('"', ""))
"""


def write(installed: Installed, folder: Path) -> tuple[str, list[Written]]:
    version = installed.run_python(_SCRIPT, folder).split("version ")[1].split("-")[0]
    text = (folder / "spheres.mdpa").read_text()

    def block(name: str) -> list[list[str]]:
        body = text.split(f"Begin {name}\n")[1].split("\nEnd ")[0]
        return [line.split() for line in body.splitlines()]

    radii = {row[0]: row[2] for row in block("NodalData\tRADIUS")}
    rows = ([*row, radii[row[0]]] for row in block("Nodes"))
    return version, [Written("spheres.mdpa", [table(rows, "id x y z r")])]
