"""Frames of an offscreen window, as benchmarks see them."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pyvista as pv

from ..draw.picture import drawing_checked
from ..testing import accuracy
from ..testing.scenes import depths_of
from ..vtk_tools import window_of
from .technique import Seen

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    type AddPacking = Callable[[pv.Plotter, pv.PolyData, NDArray[np.uint8] | None], None]


class Window:
    """Frames of an offscreen window with one headlight and one sample per pixel.

    Parameters
    ----------
    packing : pyvista.PolyData
        Centres (n, 3) and point array ``radius`` (n,).
    camera : pyvista.Camera
        Camera to copy.
    size : (int, int)
        Width and height in pixels.
    add : callable
        Adds the packing to a plotter, coloured by the given array, or by the radii if it is None.
    """

    def __init__(
        self,
        packing: pv.PolyData,
        camera: pv.Camera,
        size: tuple[int, int],
        add: AddPacking,
    ) -> None:
        self.build_seconds = self.memory_bytes = np.nan
        self._make = lambda colors: _show(packing, camera, size, add, colors)
        self._plotter = self._make(None)

    def frame(self) -> None:
        """Render and wait until it is done."""
        window = window_of(self._plotter)
        window.MakeCurrent()
        self._plotter.render()
        window.WaitForCompletion()

    def seen(self) -> Seen:
        """Draw once more, in colours that say which sphere it is."""
        plotter = self._make(accuracy.id_colors)
        try:
            drawn = accuracy.read(plotter)
            return Seen(drawn.sphere_id, _eye_depth(plotter, drawn.depth))
        finally:
            plotter.close()

    def close(self) -> None:
        """Close the window."""
        self._plotter.close()


def _show(
    packing: pv.PolyData,
    camera: pv.Camera,
    size: tuple[int, int],
    add: AddPacking,
    colors: Callable[[int], NDArray[np.uint8]] | None,
) -> pv.Plotter:
    plotter = pv.Plotter(off_screen=True, window_size=list(size), lighting="none")
    window_of(plotter).SetMultiSamples(0)
    plotter.background_color = pv.Color("black")
    plotter.add_light(pv.Light(light_type="headlight"))
    add(plotter, packing, None if colors is None else colors(packing.n_points))
    plotter.camera.position = camera.position
    plotter.camera.focal_point = camera.focal_point
    plotter.camera.up = camera.up
    plotter.camera.view_angle = camera.view_angle
    # Not all mappers know how far their spheres reach.
    depths = depths_of(packing, camera)
    try:
        with drawing_checked(window_of(plotter)):
            plotter.show(auto_close=False, interactive=False)
            plotter.camera.clipping_range = depths
            plotter.render()
    except BaseException:
        plotter.close()
        raise
    return plotter


def _eye_depth(plotter: pv.Plotter, depth: NDArray[np.float64]) -> NDArray[np.float64]:
    """Distances along the direction of view of depth buffer values, in perspective."""
    near, far = plotter.camera.clipping_range
    return near * far / (far - depth * (far - near))
