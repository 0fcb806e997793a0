"""Fields of metaballs in float64, sphere by sphere, and how far others are from them."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    import pyvista as pv
    from numpy.typing import NDArray

POINTS = 300
"""Number of points at which errors are measured."""


def exact_sums(
    packing: pv.PolyData, points: NDArray[np.float64], power: int
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Sum the inverse kernels in float64, sphere by sphere.

    Parameters
    ----------
    packing : pyvista.PolyData
        Centres (n, 3) and point array ``radius`` (n,).
    points : numpy.ndarray
        Points (m, 3), none of them at a centre.
    power : {1, 2}
        Of the distance.

    Returns
    -------
    tuple of numpy.ndarray
        Values (m,) and gradients (m, 3).
    """
    centers = np.asarray(packing.points, float)
    radii = np.asarray(packing["radius"], float)
    values, gradients = np.empty(len(points)), np.empty((len(points), 3))
    for i, point in enumerate(points):
        away = point - centers
        square = (away**2).sum(axis=1)
        each = (radii / np.sqrt(square)) ** power
        values[i] = each.sum()
        gradients[i] = -power * (each / square) @ away
    return values, gradients


def points_of(image: pv.ImageData, chosen: NDArray[np.int64]) -> NDArray[np.float64]:
    """Points (n, 3) of a grid in float64, which ``image.points`` is not."""
    steps = np.array(np.unravel_index(chosen, image.dimensions, order="F")).T
    return np.array(image.origin) + steps * np.array(image.spacing)


def field_error(packing: pv.PolyData, image: pv.ImageData) -> float:
    """Largest relative error of an inverse field at random points of its grid."""
    chosen = np.random.default_rng(0).integers(0, image.n_points, POINTS)
    exact, _ = exact_sums(packing, points_of(image, chosen), 1)
    values = np.asarray(image["field"])[chosen]
    return float(np.abs(values / exact - 1.0).max())


def distances(packing: pv.PolyData, surface: pv.PolyData, threshold: float) -> NDArray[np.float64]:
    """Distances of random points of triangles from the true surface, to first order (POINTS,)."""
    rng = np.random.default_rng(0)
    corners = surface.points[surface.regular_faces[rng.integers(0, surface.n_cells, POINTS)]]
    barycentric = rng.dirichlet((1.0, 1.0, 1.0), POINTS)
    points = np.einsum("nc,ncx->nx", barycentric, np.asarray(corners, float))
    value, gradient = exact_sums(packing, points, 2)
    return np.abs(value - threshold) / np.linalg.norm(gradient, axis=1)
