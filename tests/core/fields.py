"""Fields of metaballs by their definition, in double precision."""

import numpy as np
import pyvista as pv
from spherepacking.backend import vtkMetaballField

KERNELS = ("inverse", "inverse_square", "gaussian", "wyvill")


def value_of(kernel, distance, radius):
    """What spheres of weight 1 add."""
    far = np.maximum(distance, radius / 1024)
    if kernel == "inverse":
        return radius / far
    if kernel == "inverse_square":
        return (radius / far) ** 2
    if kernel == "gaussian":
        return np.exp(2 - 2 * (distance / radius) ** 2)
    u = (distance / (2 * radius)) ** 2
    return np.where(u < 1, 2 * (1 - u) ** 2 * (1 - 4 * u / 9), 0)


def direct(packing, points, kernel="inverse", weights=None):
    """Sums (n,) over all spheres at points (n, 3), one sphere after the other."""
    centers = np.asarray(packing.points, float)
    radii = np.asarray(packing["radius"], float)
    weights = np.ones(len(radii)) if weights is None else weights
    seen = (radii > 0) & (weights > 0)
    centers, radii, weights = centers[seen], radii[seen], weights[seen]
    return np.array(
        [
            (weights * value_of(kernel, np.linalg.norm(centers - point, axis=1), radii)).sum()
            for point in np.asarray(points, float)
        ]
    )


def filter_of(packing, kernel="inverse", dimensions=(24, 24, 24), error=1e-3, bounds=None):
    algorithm = vtkMetaballField()
    algorithm.SetInputData(packing)
    algorithm.SetKernel(KERNELS.index(kernel))
    algorithm.SetDimensions(dimensions)
    algorithm.SetRelativeError(error)
    if bounds is not None:
        algorithm.SetModelBounds(bounds)
    return algorithm


def field_of(*args, **kwargs):
    algorithm = filter_of(*args, **kwargs)
    algorithm.Update()
    assert algorithm.GetErrorMessage() == ""
    return pv.wrap(algorithm.GetOutput())
