"""The camera of the command line."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..accessor import PackingAccessor
from ..checks import EXTENT_LIMITS, FINEST_EXTENT

if TYPE_CHECKING:
    import pyvista as pv

    from .options import Vector


def check_extent(name: str, packing: pv.PolyData) -> None:
    """Raise a ValueError that starts with `name` if a picture cannot hold the packing.

    Parameters
    ----------
    name : str
        What to call the packing.
    packing : pyvista.PolyData
        Centres (n, 3) and point array ``radius`` (n,).
    """
    if not packing.n_points or not packing.point_data["radius"].any():
        return
    low, high = np.reshape(PackingAccessor(packing).bounds, (3, 2)).T
    with np.errstate(over="ignore"):
        extent = np.max(high - low)
    farthest = np.max(np.abs([low, high]))
    least, most = EXTENT_LIMITS
    if not least <= extent <= most:
        raise ValueError(
            f"{name}: found spheres over a length of {extent:g}, expected {least:g} to {most:g}: "
            "pictures are computed in single precision"
        )
    if extent < FINEST_EXTENT * farthest:
        raise ValueError(
            f"{name}: found spheres over a length of {extent:g} at coordinates up to {farthest:g}, "
            f"expected at least {FINEST_EXTENT:g} of these: double precision holds no more digits"
        )


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
        If a number is not finite, the position is the focal point or too far from it, or `up` is 0
        or the direction of view.
    """
    for name, vector in (("--camera", position), ("--focal", focal), ("--up", up)):
        if vector is not None and not np.isfinite(vector).all():
            raise ValueError(f"{name}: found {_text_of(vector)}, expected three finite numbers")
    # Not set before they are known to differ: vtkCamera moves a focal point that is the position.
    position = camera.position if position is None else position
    focal = camera.focal_point if focal is None else focal
    distance = math.dist(position, focal)
    if distance == 0.0:
        raise ValueError(
            f"--camera: found the position {_text_of(position)} at the focal point, expected "
            "another one"
        )
    least, most = EXTENT_LIMITS
    if not least <= distance <= most:
        raise ValueError(
            f"--camera: found a distance of {distance:g} from the focal point, expected {least:g} "
            f"to {most:g}"
        )
    view = np.subtract(focal, position)
    if up is None:
        up = (0.0, 1.0, 0.0) if _parallel(view, np.asarray(camera.up)) else camera.up
    elif not any(up):
        raise ValueError("--up: found 0 0 0, expected a direction")
    # Large and tiny numbers would not survive being squared.
    direction = np.divide(up, np.max(np.abs(up)))
    if _parallel(view, direction):
        raise ValueError("--up: found the direction of view, expected another one")
    camera.focal_point = focal
    camera.position = position
    camera.up = direction


def _text_of(vector: Vector) -> str:
    return " ".join(f"{number:g}" for number in vector)


def _parallel(first: np.ndarray, second: np.ndarray) -> bool:
    """Whether two vectors are as good as parallel; neither is 0."""
    sine = np.linalg.norm(np.cross(first, second))
    return sine <= 1e-9 * np.linalg.norm(first) * np.linalg.norm(second)


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
