"""All techniques that can be measured."""

from __future__ import annotations

from contextlib import suppress
from functools import partial
from typing import TYPE_CHECKING

from . import peers
from .rays import PATH_SAMPLES, PathTrace, RayCast
from .technique import Technique
from .window import Window

if TYPE_CHECKING:
    import numpy as np
    import pyvista as pv
    from numpy.typing import NDArray


def _add_spheres(
    plotter: pv.Plotter, packing: pv.PolyData, colors: NDArray[np.uint8] | None
) -> None:
    scalars, rgb = ("radius", None) if colors is None else (colors, True)
    plotter.packing.add(
        packing, scalars=scalars, rgb=rgb, lighting=colors is None, show_scalar_bar=False
    )


def own() -> list[Technique]:
    """Return the techniques of this package."""
    made = [Technique("OpenGL", "", 1, partial(Window, add=_add_spheres))]
    for structure, samples in (("bvh", 1), ("bvh", 2), ("bvh", 3), ("grid", 1), ("none", 1)):
        cast = partial(RayCast, structure=structure, samples=samples)
        made.append(Technique("ray cast", structure, samples**2, cast))
    for samples in PATH_SAMPLES:
        trace = partial(PathTrace, structure="bvh", samples=samples)
        made.append(Technique("path trace", "bvh", samples, trace, once=True))
    return made


def everything() -> list[Technique]:
    """Return the techniques of this package and of all others that are installed."""
    made = [*own(), *peers.vtk()]
    # Raises an ImportError where the package was built without it.
    with suppress(ImportError):
        from . import embree

        made.extend(embree.techniques())
    return made
