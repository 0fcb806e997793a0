"""The float64 reference itself, against solutions in closed form and long double brute force."""

import numpy as np
import pytest
from scenes import Camera, make_packing, show
from spherepacking.testing import reference


def brute_force(centers, radii, rays):
    """Return first hit parameter and sphere of every ray, all pairs in long double."""
    origin = rays.origin.astype(np.longdouble)
    direction = rays.direction.astype(np.longdouble)
    best = np.full(len(origin), np.inf, dtype=np.longdouble)
    ids = np.full(len(origin), -1)
    a = np.sum(direction**2, axis=1)
    for index, (center, radius) in enumerate(zip(centers, radii, strict=True)):
        offset = origin - center.astype(np.longdouble)
        b = np.sum(offset * direction, axis=1)
        c = np.sum(offset**2, axis=1) - np.longdouble(radius) ** 2
        inside = b * b - a * c
        with np.errstate(invalid="ignore"):
            root = np.sqrt(inside)
        near = (-b - root) / a
        t = np.where(near >= 0, near, (-b + root) / a)
        better = (inside >= 0) & (t >= 0) & (t <= 1) & (t < best)
        best[better] = t[better]
        ids[better] = index
    return best, ids


@pytest.mark.parametrize("parallel_scale", [None, 2.0])
def test_cast_equals_long_double_brute_force(rng, parallel_scale):
    centers = rng.uniform(-1, 1, (300, 3))
    radii = rng.uniform(0.01, 0.3, 300)
    camera = Camera(parallel_scale=parallel_scale)
    size = (120, 90)
    with show(make_packing(centers, radii), camera, size) as (plotter, _):
        to_device = reference.projection(plotter.renderer)
    picture = reference.cast(centers, radii, to_device, size)
    x, y = np.meshgrid(np.arange(size[0]), np.arange(size[1]))
    rays = reference.pixel_rays(to_device, size, x.ravel(), y.ravel())
    t, ids = brute_force(centers, radii, rays)
    assert np.array_equal(picture.sphere_id.ravel(), ids)
    depth = reference.depth_values(to_device, rays, t.astype(float))
    np.testing.assert_allclose(picture.depth.ravel(), depth, rtol=0, atol=1e-13)


def test_projected_disc_in_parallel_view():
    size = (200, 200)
    with show(
        make_packing([[0.0, 0.0, 0.0]], [1.0]),
        Camera((0, 0, 5), up=(0, 1, 0), parallel_scale=2.0),
        size,
    ) as (plotter, _):
        to_device = reference.projection(plotter.renderer)
        near, far = plotter.camera.clipping_range
    picture = reference.cast([[0.0, 0.0, 0.0]], [1.0], to_device, size)
    x = (np.arange(200) + 0.5) / 50.0 - 2.0
    rho2 = x[None, :] ** 2 + x[:, None] ** 2
    assert np.array_equal(picture.sphere_id == 0, rho2 <= 1.0)
    depth = (5.0 - np.sqrt(1.0 - rho2[rho2 <= 1.0]) - near) / (far - near)
    np.testing.assert_allclose(picture.depth[rho2 <= 1.0], depth, atol=1e-12)
