"""The C++ sphere mapper with the manners of :class:`pyvista.DataSetMapper`."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pyvista as pv

from ..backend import vtkOpenGLSpherePackingMapper

if TYPE_CHECKING:
    from pyvista.plotting.themes import Theme

if TYPE_CHECKING:
    _PythonHalf = pv.DataSetMapper
else:
    # The half of DataSetMapper that is written in Python: scalars, lookup table, scalar range.
    _PythonHalf = pv.DataSetMapper.__bases__[0]


class SpherePackingMapper(_PythonHalf, vtkOpenGLSpherePackingMapper):
    """Draws each point of a packing as an exact ray-cast sphere.

    Parameters
    ----------
    dataset : pyvista.PolyData, optional
        Packing to draw.
    theme : pyvista.plotting.themes.Theme, optional
        Theme of the plotter, for colour map and the like.
    radius : str, default: "radius"
        Name of the point array that holds the radii, in the unit of the points.
    """

    def __init__(
        self,
        dataset: pv.PolyData | None = None,
        theme: Theme | None = None,
        radius: str = "radius",
    ) -> None:
        super().__init__(theme=theme)
        self.SetRadiusArrayName(radius)
        if dataset is not None:
            self.dataset = dataset
