"""Scenes that are drawn and compared with float64 rays."""

from contextlib import contextmanager
from dataclasses import dataclass, field

import numpy as np
import pyvista as pv
from spherepacking.testing import accuracy, reference


@dataclass
class Camera:
    position: tuple = (3.0, 3.0, 3.0)
    focal_point: tuple = (0.0, 0.0, 0.0)
    up: tuple = (0.0, 0.0, 1.0)
    view_angle: float = 40.0
    parallel_scale: float | None = None
    clipping_range: tuple | None = None
    settings: dict = field(default_factory=dict)

    def apply(self, plotter):
        camera = plotter.camera
        camera.position = self.position
        camera.focal_point = self.focal_point
        camera.up = self.up
        camera.view_angle = self.view_angle
        if self.parallel_scale is not None:
            camera.parallel_projection = True
            camera.parallel_scale = self.parallel_scale
        for name, value in self.settings.items():
            getattr(camera, name)(*value)
        if self.clipping_range is None:
            plotter.renderer.ResetCameraClippingRange()
        else:
            camera.clipping_range = self.clipping_range


def make_packing(centers, radii):
    packing = pv.PolyData()
    points = pv._vtk.vtkPoints()
    points.SetData(pv.convert_array(np.ascontiguousarray(centers)))
    packing.SetPoints(points)
    packing.point_data["radius"] = np.asarray(radii)
    return packing


@contextmanager
def show(packing, camera, size=(400, 400), *, samples=None, **kwargs):
    """Show a packing unlit on black, by default in colours that tell the spheres' numbers.

    With PyVista's default of several samples a pixel, surfaces are found first and lit later; with
    ``samples=0`` spheres are drawn straight into the window.
    """
    plotter = pv.Plotter(off_screen=True, window_size=size)
    if samples is not None:
        plotter.render_window.SetMultiSamples(samples)
    plotter.set_background("black")
    kwargs.setdefault("lighting", False)
    if "color" not in kwargs and "scalars" not in kwargs:
        kwargs |= {"scalars": accuracy.id_colors(packing.n_points), "rgb": True}
    actor = plotter.packing.add(packing, show_scalar_bar=False, **kwargs)
    camera.apply(plotter)
    plotter.show(auto_close=False, interactive=False)
    camera.apply(plotter)
    plotter.render()
    try:
        yield plotter, actor
    finally:
        plotter.close()


def draw_and_cast(centers, radii, camera, size=(400, 400), **kwargs):
    """Draw a packing, cast the same view in float64 and return both pictures."""
    with show(make_packing(centers, radii), camera, size, **kwargs) as (plotter, _):
        drawn = accuracy.read(plotter)
        to_device = reference.projection(plotter.renderer)
    return drawn, reference.cast(centers, radii, to_device, size)
