"""Packings from plain arrays, of the very types that are given."""

import numpy as np
import pyvista as pv


def packing_of(centers, radii, name="radius"):
    packing = pv.PolyData()
    points = pv._vtk.vtkPoints()
    points.SetData(pv.convert_array(np.ascontiguousarray(centers)))
    packing.SetPoints(points)
    packing.GetPointData().AddArray(pv.convert_array(np.asarray(radii), name=name))
    return packing
