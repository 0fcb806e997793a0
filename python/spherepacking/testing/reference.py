"""Float64 rays against spheres: what every faster picture is measured against.

Simple on purpose. Rays come from inverting the camera's whole projection matrix, not from the
formulas of the shaders, and hits from a quadratic relative to the sphere's centre.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Iterator

    import pyvista as pv
    from numpy.typing import ArrayLike, NDArray

_SPHERES_AT_ONCE = 100_000
_PAIRS_AT_ONCE = 200_000


class Picture(NamedTuple):
    """What float64 rays through pixel centres see; rows from the bottom, as VTK."""

    sphere_id: NDArray[np.int64]
    """Index of the sphere seen first, -1 for none; ``(height, width)``."""
    depth: NDArray[np.float64]
    """Depth buffer value of the hit, 1 where there is none; ``(height, width)``."""
    second: NDArray[np.float64]
    """Depth buffer value of the next sphere behind, 1 where there is none; ``(height, width)``."""
    t: NDArray[np.float64]
    """Of the hit from 0 at the near to 1 at the far plane, inf for none; ``(height, width)``."""


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


def _dot(a: NDArray[np.float64], b: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.einsum("...i,...i->...", a, b)


def hit(
    rays: Rays, center: NDArray[np.float64], radius: NDArray[np.float64] | float
) -> NDArray[np.float64]:
    """Return t of the first hit between the near and the far plane, inf where there is none."""
    offset = rays.origin - center
    length2 = _dot(rays.direction, rays.direction)
    along = _dot(offset, rays.direction) / length2
    miss = offset - along[..., None] * rays.direction
    half2 = (radius**2 - _dot(miss, miss)) / length2
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


def _pixel_boxes(
    to_device: NDArray[np.float64],
    centers: NDArray[np.float64],
    radii: NDArray[np.float64],
    size: tuple[int, int],
) -> NDArray[np.int64]:
    """Return pixels x0, x1, y0, y1 (n, 4) outside which a sphere is not seen; generous."""
    corners = np.indices((2, 2, 2)).reshape(3, 8).T * 2.0 - 1.0
    corners = centers[:, None] + radii[:, None, None] * corners
    clip = corners @ to_device[:, :3].T + to_device[:, 3]
    behind = clip[..., 3] <= 0.0
    boxes = np.empty((len(radii), 4), dtype=np.int64)
    for axis in range(2):
        with np.errstate(divide="ignore", invalid="ignore"):
            pixels = (clip[..., axis] / clip[..., 3] + 1.0) * 0.5 * size[axis]
        # What reaches behind the eye may be anywhere.
        pixels[behind.any(axis=1)] = [0, size[axis]] * 4
        boxes[:, 2 * axis] = np.clip(np.floor(pixels.min(axis=1)) - 1, 0, size[axis])
        boxes[:, 2 * axis + 1] = np.clip(np.ceil(pixels.max(axis=1)) + 2, 0, size[axis])
    boxes[behind.all(axis=1) | (radii == 0.0)] = 0
    return boxes


def _chunks(boxes: NDArray[np.int64], most: int) -> Iterator[slice]:
    """Yield neighbours whose boxes have `most` pixels together, or single larger ones."""
    ends = np.cumsum((boxes[:, 1] - boxes[:, 0]) * (boxes[:, 3] - boxes[:, 2]))
    first = 0
    while first < len(ends):
        before = ends[first - 1] if first else 0
        last = max(int(np.searchsorted(ends, before + most, side="right")), first + 1)
        yield slice(first, last)
        first = last


def _pairs(
    boxes: NDArray[np.int64],
) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.int64]]:
    """Return which sphere meets which pixel: index, x and y of each pair."""
    width = boxes[:, 1] - boxes[:, 0]
    counts = width * (boxes[:, 3] - boxes[:, 2])
    index = np.repeat(np.arange(len(boxes)), counts)
    rank = np.arange(len(index)) - np.repeat(np.cumsum(counts) - counts, counts)
    return index, boxes[index, 0] + rank % width[index], boxes[index, 2] + rank // width[index]


class _Nearest:
    """The first two hits of every pixel so far."""

    def __init__(self, pixels: int) -> None:
        self.t = np.full(pixels, np.inf)
        self.second = np.full(pixels, np.inf)
        self.sphere_id = np.full(pixels, -1, dtype=np.int64)

    def add(
        self, pixel: NDArray[np.int64], t: NDArray[np.float64], sphere: NDArray[np.int64]
    ) -> None:
        """Take more hits, of spheres that come after those taken before."""
        order = np.lexsort((sphere, t, pixel))
        pixel, t, sphere = pixel[order], t[order], sphere[order]
        first = np.flatnonzero(np.diff(pixel, prepend=-1))
        behind = np.full(len(first), np.inf)
        follows = np.diff(first, append=len(pixel)) > 1
        behind[follows] = t[first[follows] + 1]
        at, t, sphere = pixel[first], t[first], sphere[first]
        closer = t < self.t[at]
        self.second[at] = np.where(
            closer, np.minimum(self.t[at], behind), np.minimum(self.second[at], t)
        )
        self.t[at] = np.where(closer, t, self.t[at])
        self.sphere_id[at] = np.where(closer, sphere, self.sphere_id[at])


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
    every = pixel_rays(to_device, size, *np.meshgrid(np.arange(size[0]), np.arange(size[1])))
    flat = Rays(every.origin.reshape(-1, 3), every.direction.reshape(-1, 3))
    nearest = _Nearest(size[0] * size[1])
    for start in range(0, len(radii), _SPHERES_AT_ONCE):
        part = slice(start, start + _SPHERES_AT_ONCE)
        boxes = _pixel_boxes(to_device, centers[part], radii[part], size)
        for chunk in _chunks(boxes, _PAIRS_AT_ONCE):
            sphere, x, y = _pairs(boxes[chunk])
            sphere += start + chunk.start
            pixel = y * size[0] + x
            rays = Rays(flat.origin.take(pixel, axis=0), flat.direction.take(pixel, axis=0))
            t = hit(rays, centers.take(sphere, axis=0), radii.take(sphere))
            found = np.isfinite(t)
            nearest.add(pixel[found], t[found], sphere[found])
    t, second = nearest.t.reshape(shape), nearest.second.reshape(shape)
    return Picture(
        nearest.sphere_id.reshape(shape),
        depth_values(to_device, every, t),
        depth_values(to_device, every, second),
        t,
    )
