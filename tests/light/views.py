"""Cameras and pictures of the path tracer's tests."""

import numpy as np
import pyvista as pv
from spherepacking.accessor import PackingAccessor


def packing_of(centers, radii):
    packing = pv.PolyData()
    packing.points = np.asarray(centers, dtype=float)
    packing["radius"] = np.broadcast_to(np.asarray(radii, dtype=float), len(packing.points)).copy()
    return packing


def camera_of(position, focal_point=(0, 0, 0), up=(0, 0, 1), angle=30.0, scale=None):
    camera = pv.Camera()
    camera.position, camera.focal_point, camera.up = position, focal_point, up
    camera.view_angle = angle
    if scale is not None:
        camera.parallel_projection, camera.parallel_scale = True, scale
    return camera


def trace(packing, camera, size=(32, 32), **kwargs):
    return PackingAccessor(packing).path_trace(camera, size, **kwargs)


def cluster(rng, n=60):
    """Spheres that overlap, touch, and leave gaps."""
    centers = rng.uniform(-1, 1, (n, 3))
    radii = rng.uniform(0.05, 0.4, n)
    # Two of them touch, two are the same.
    centers[1] = centers[0] + [radii[0] + radii[1], 0, 0]
    centers[2], radii[2] = centers[3], radii[3]
    return packing_of(centers, radii)
