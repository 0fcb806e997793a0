"""VTK's own ways to draw spheres."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

from .technique import Technique
from .window import Window

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ..backend import vtkGlyph3DMapper, vtkPolyDataMapper

_DISC = """//VTK::Color::Impl
  if (dot(offsetVCVSOutput, offsetVCVSOutput) > 1.0) discard;
"""


def add_discs(
    plotter: pv.Plotter, packing: pv.PolyData, colors: NDArray[np.uint8] | None = None
) -> None:
    """Add a packing as flat discs of vtkPointGaussianMapper, in the tightest quads it makes."""
    mapper = pv._vtk.vtkPointGaussianMapper()
    mapper.SetScaleArray("radius")
    mapper.SetScaleFactor(1.0)
    mapper.SetBoundScale(1.0)
    mapper.EmissiveOff()
    mapper.SetSplatShaderCode(_DISC)
    _add(plotter, mapper, packing, colors)


def _add_sphere_mapper(
    plotter: pv.Plotter, packing: pv.PolyData, colors: NDArray[np.uint8] | None
) -> None:
    from ..backend import vtkOpenGLSphereMapper

    mapper = vtkOpenGLSphereMapper()
    mapper.SetScaleArray("radius")
    # Upstream: VTK 9.7's vtkOpenGLSphereMapper draws nothing without cells; made of points alone,
    # a PolyData of PyVista has one for each.
    with_cells = pv.PolyData(np.asarray(packing.points))
    with_cells.point_data["radius"] = packing.point_data["radius"]
    _add(plotter, mapper, with_cells, colors)


def _add_meshes(
    plotter: pv.Plotter, packing: pv.PolyData, colors: NDArray[np.uint8] | None
) -> None:
    from ..backend import vtkGlyph3DMapper

    mapper = vtkGlyph3DMapper()
    mapper.SetSourceData(pv.Sphere(radius=1.0, theta_resolution=8, phi_resolution=8))
    mapper.SetScaleArray("radius")
    mapper.SetScaleModeToScaleByMagnitude()
    _add(plotter, mapper, packing, colors)


def _add(
    plotter: pv.Plotter,
    mapper: vtkPolyDataMapper | vtkGlyph3DMapper,
    packing: pv.PolyData,
    colors: NDArray[np.uint8] | None,
) -> None:
    shown = packing.copy(deep=False)
    name = "radius"
    if colors is None:
        mapper.SetScalarRange(packing.get_data_range("radius"))
    else:
        name = "colors"
        shown.point_data[name] = colors
        mapper.SetColorModeToDirectScalars()
    mapper.SetInputData(shown)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray(name)
    actor = pv._vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetLighting(colors is None)
    plotter.renderer.AddActor(actor)


def vtk() -> list[Technique]:
    """Return the mappers of the VTK that PyVista runs on."""
    from ..backend import vtkOpenGLSphereMapper

    ways = {"VTK discs": add_discs, "VTK meshes of 8 × 8": _add_meshes}
    if vtkOpenGLSphereMapper is not None:
        ways["VTK sphere mapper"] = _add_sphere_mapper
    return [Technique(name, "", 1, partial(Window, add=add)) for name, add in ways.items()]
