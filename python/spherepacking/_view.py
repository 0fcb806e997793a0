"""Where the command line's camera stands."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    import pyvista as pv

    Vector = tuple[float, float, float]


def aim(
    camera: pv.Camera, position: Vector | None, focal: Vector | None, up: Vector | None
) -> None:
    """Place the camera; what is not given stays as it is.

    Parameters
    ----------
    camera : pyvista.Camera
        Camera to place.
    position, focal : tuple[float, float, float], optional
        Where it stands and what it looks at, in the unit of the scene.
    up : tuple[float, float, float], optional
        Direction that is up in the picture. By default the present one, or another one if that is
        the direction of view.

    Raises
    ------
    ValueError
        If there is no direction of view, or `up` is that direction.
    """
    # Not set before they are known to differ: VTK moves a camera that stands where it looks at.
    position = camera.position if position is None else position
    focal = camera.focal_point if focal is None else focal
    view = np.subtract(focal, position)
    if not view.any():
        raise ValueError("--camera: the camera stands where it looks at, expected another --focal")
    if up is None:
        up = camera.up if np.cross(view, camera.up).any() else (0.0, 1.0, 0.0)
    if not np.cross(view, up).any():
        raise ValueError("--up: found the direction of view, expected another one")
    camera.focal_point = focal
    camera.position = position
    camera.up = up


def fit(camera: pv.Camera, packing: pv.PolyData, size: tuple[int, int], fraction: float) -> None:
    """Narrow the view until the spheres fill a fraction of the picture.

    PyVista fits the ball around the bounding box, which leaves a round packing small.

    Parameters
    ----------
    camera : pyvista.Camera
        Camera that sees the whole packing from outside, and looks at its middle.
    packing : pyvista.PolyData
        Centres (n, 3), n > 0, and point array ``radius`` (n,).
    size : tuple[int, int]
        Width and height of the picture in pixels.
    fraction : float
        Part of the height or of the width, whichever is reached first, in (0, 1].
    """
    eye = np.asarray(camera.position)
    towards = np.subtract(camera.focal_point, eye)
    towards /= np.linalg.norm(towards)
    right = np.cross(towards, camera.up)
    right /= np.linalg.norm(right)
    axes = np.stack([right, np.cross(right, towards), towards])
    x, y, depth = axes @ (np.asarray(packing.points, dtype=float) - eye).T
    radius = np.asarray(packing.point_data["radius"], dtype=float)

    slope = 0.0
    for across, pixels in ((x, size[0]), (y, size[1])):
        # The tangents from the eye to a sphere, seen along the other axis of the picture.
        angle = np.arctan2(np.abs(across), depth) + np.arcsin(radius / np.hypot(across, depth))
        slope = max(slope, np.tan(angle.max()) * size[1] / pixels)
    if slope > 0.0:
        camera.view_angle = np.degrees(2.0 * np.arctan(slope / fraction))
