"""MorphIO: a branching neuron in SWC."""

from __future__ import annotations

from typing import TYPE_CHECKING

from truth import Written, lines, table

if TYPE_CHECKING:
    from pathlib import Path

    from installed import Installed

_SCRIPT = """
from importlib.metadata import version

import morphio
from morphio import PointLevel, SectionType
from morphio.mut import Morphology

neuron = Morphology()
neuron.soma.points = [[0, 0, 0]]
neuron.soma.diameters = [10.5]
neuron.soma.type = morphio.SomaType.SOMA_SINGLE_POINT
axon = SectionType.axon
stem = neuron.append_root_section(
    PointLevel([[5, 0.1, 0], [6, 1 / 3, 0.25], [7, 1, 2]], [2.25, 1.123456789, 1]), axon)
stem.append_section(PointLevel([[7, 1, 2], [8, 2, 2]], [1, 0.5]), axon)
stem.append_section(PointLevel([[7, 1, 2], [8, -2, 2.125]], [1, 0.75]), axon)
neuron.write("neuron.swc")
print("version", version("morphio"))
"""


def write(installed: Installed, folder: Path) -> tuple[str, list[Written]]:
    version = installed.run_python(_SCRIPT, folder).split("version ")[1].split()[0]
    rows = lines(folder / "neuron.swc")
    return version, [Written("neuron.swc", [table(rows, "id type x y z r parent")])]
