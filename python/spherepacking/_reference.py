"""Float64 rays against spheres: what every faster picture is measured against.

Simple on purpose. Rays come from inverting the camera's whole projection matrix, not from the
formulas of the shaders, and hits from a quadratic relative to the sphere's centre.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

if TYPE_CHECKING:
    import pyvista as pv
    from numpy.typing import ArrayLike, NDArray


class Picture(NamedTuple):
    """What float64 rays through pixel centres see; rows from the bottom, as VTK."""

    sphere_id: NDArray[np.int64]
    """Index of the sphere seen first, -1 for none; ``(height, width)``."""
    depth: NDArray[np.float64]
    """Depth buffer value of the hit, 1 where there is none; ``(height, width)``."""
    second: NDArray[np.float64]
    """Depth buffer value of the next sphere behind, 1 where there is none; ``(height, width)``."""


class Rays(NamedTuple):
    """Rays through pixel centres: ``origin + t * direction``, 0 <= t <= 1 between near and far."""

    origin: NDArray[np.float64]
    direction: NDArray[np.float64]


def projection(renderer: pv.Renderer) -> NDArray[np.float64]:
    """Return the 4x4 matrix from world to normalised device coordinates."""
    matrix = renderer.GetActiveCamera().GetCompositeProjectionTransformMatrix(
        renderer.GetTiledAspectRatio(), -1, 1
    )
    return np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])


def pixel_rays(
    to_device: NDArray[np.float64], size: tuple[int, int], x: ArrayLike, y: ArrayLike
) -> Rays:
    """Return the rays through the centres of pixels ``x``, ``y`` (from the lower left)."""
    from_device = np.linalg.inv(to_device)
    ndc_x = 2.0 * (np.asarray(x) + 0.5) / size[0] - 1.0
    ndc_y = 2.0 * (np.asarray(y) + 0.5) / size[1] - 1.0
    ends = []
    for ndc_z in (-1.0, 1.0):
        device = np.stack([ndc_x, ndc_y, np.full_like(ndc_x, ndc_z), np.ones_like(ndc_x)], axis=-1)
        world = device @ from_device.T
        ends.append(world[..., :3] / world[..., 3:])
    return Rays(ends[0], ends[1] - ends[0])


def hit(rays: Rays, center: NDArray[np.float64], radius: float) -> NDArray[np.float64]:
    """Return t of the first hit between the near and the far plane, inf where there is none."""
    offset = rays.origin - center
    length2 = np.sum(rays.direction**2, axis=-1)
    along = np.sum(offset * rays.direction, axis=-1) / length2
    miss = offset - along[..., None] * rays.direction
    half2 = (radius**2 - np.sum(miss**2, axis=-1)) / length2
    half = np.sqrt(np.maximum(half2, 0.0))
    t = -along - half
    t = np.where(t >= 0.0, t, -along + half)
    return np.where((half2 >= 0.0) & (t >= 0.0) & (t <= 1.0), t, np.inf)


def depth_values(
    to_device: NDArray[np.float64], rays: Rays, t: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Return the depth buffer's values in [0, 1] at parameter ``t`` of the rays."""
    finite = np.isfinite(t)
    points = rays.origin + np.where(finite, t, 0.0)[..., None] * rays.direction
    z = points @ to_device[2, :3] + to_device[2, 3]
    w = points @ to_device[3, :3] + to_device[3, 3]
    return np.where(finite, 0.5 * (z / w) + 0.5, 1.0)


def _pixel_box(
    to_device: NDArray[np.float64],
    center: NDArray[np.float64],
    radius: float,
    size: tuple[int, int],
) -> tuple[int, int, int, int]:
    """Return pixels (x0, x1, y0, y1) outside which the sphere is not seen; generous."""
    corners = center + radius * (np.indices((2, 2, 2)).reshape(3, 8).T * 2.0 - 1.0)
    clip = corners @ to_device[:, :3].T + to_device[:, 3]
    if np.any(clip[:, 3] <= 0.0):  # reaches behind the eye
        return 0, size[0], 0, size[1]
    box = []
    for axis in range(2):
        pixels = (clip[:, axis] / clip[:, 3] + 1.0) * 0.5 * size[axis]
        box.append(int(np.clip(np.floor(pixels.min()) - 1, 0, size[axis])))
        box.append(int(np.clip(np.ceil(pixels.max()) + 2, 0, size[axis])))
    return box[0], box[1], box[2], box[3]


def cast(
    centers: ArrayLike, radii: ArrayLike, to_device: NDArray[np.float64], size: tuple[int, int]
) -> Picture:
    """Cast a ray through every pixel centre.

    Parameters
    ----------
    centers : array_like of float, shape (n, 3)
        Centres in world space.
    radii : array_like of float, shape (n,)
        Radii in world space.
    to_device : ndarray of float, shape (4, 4)
        World to normalised device coordinates, see :func:`projection`.
    size : (int, int)
        Width and height in pixels.

    Returns
    -------
    Picture
        The spheres seen and their depths.

    """
    centers = np.asarray(centers, dtype=np.float64)
    radii = np.asarray(radii, dtype=np.float64)
    shape = (size[1], size[0])
    nearest = np.full(shape, np.inf)
    following = np.full(shape, np.inf)
    ids = np.full(shape, -1, dtype=np.int64)
    every = pixel_rays(to_device, size, *np.meshgrid(np.arange(size[0]), np.arange(size[1])))
    for index in range(len(radii)):
        if radii[index] == 0.0:
            continue
        x0, x1, y0, y1 = _pixel_box(to_device, centers[index], radii[index], size)
        if x0 >= x1 or y0 >= y1:
            continue
        box = np.s_[y0:y1, x0:x1]
        t = hit(Rays(every.origin[box], every.direction[box]), centers[index], radii[index])
        first = t < nearest[box]
        following[box] = np.where(first, nearest[box], np.minimum(following[box], t))
        nearest[box] = np.where(first, t, nearest[box])
        ids[box] = np.where(first, index, ids[box])
    return Picture(
        ids, depth_values(to_device, every, nearest), depth_values(to_device, every, following)
    )
