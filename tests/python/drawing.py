"""Small scenes whose pixels are known beforehand."""

from contextlib import contextmanager

import numpy as np
import pyvista as pv

SIZE = 100
MIDDLE = SIZE // 2


def packing(n=3, **arrays):
    """Return n unit spheres in a row along x, 3 apart, the middle one in the origin if n is odd."""
    centers = np.zeros((n, 3))
    centers[:, 0] = 3.0 * (np.arange(n) - (n - 1) / 2)
    mesh = pv.PolyData()
    mesh.points = centers
    mesh.point_data["radius"] = np.ones(n)
    for name, values in arrays.items():
        mesh.point_data[name] = np.asarray(values)
    mesh.set_active_scalars(None)
    return mesh


@contextmanager
def plotter(**kwargs):
    """Make a plotter that sees x and y from -5 to 5 in 100 by 100 pixels, background black."""
    scene = pv.Plotter(off_screen=True, window_size=(SIZE, SIZE), **kwargs)
    scene.set_background("black")
    scene.camera_position = [(0.0, 0.0, 20.0), (0.0, 0.0, 0.0), (0.0, 1.0, 0.0)]
    scene.enable_parallel_projection()
    scene.camera.parallel_scale = 5.0
    try:
        yield scene
    finally:
        scene.close()


def at_spheres(picture, n=3):
    """Return colours (n, channels) in the middle of each sphere of packing(n)."""
    columns = np.round(MIDDLE + 10 * 3.0 * (np.arange(n) - (n - 1) / 2)).astype(int)
    return np.asarray(picture)[MIDDLE, columns]


def drawn_colors(mesh, **kwargs):
    """Return colours (n, 3) of the unlit spheres of `mesh` as `add` draws them with `kwargs`."""
    with plotter() as scene:
        scene.packing.add(mesh, lighting=False, show_scalar_bar=False, **kwargs)
        return at_spheres(scene.screenshot(None, return_img=True), mesh.n_points).astype(int)
