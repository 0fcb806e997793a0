"""Spheres cut by the near plane or by clipping planes show their inside."""

import numpy as np
import pytest
import pyvista as pv
from scenes import Camera, draw_and_cast, make_packing, show
from spherepacking.testing import accuracy, reference


@pytest.mark.parametrize("samples", [None, 0])
@pytest.mark.parametrize("parallel_scale", [None, 1.3])
def test_near_plane_shows_the_inside(rng, parallel_scale, samples):
    centers = rng.uniform(-1, 1, (300, 3))
    radii = rng.uniform(0.05, 0.4, 300)
    camera = Camera(
        (0, 0, 4), up=(0, 1, 0), parallel_scale=parallel_scale, clipping_range=(4.0, 6.0)
    )
    drawn, expected = draw_and_cast(centers, radii, camera, samples=samples)
    errors = accuracy.compare(drawn, expected)
    assert errors.good, errors
    assert errors.sphere_wrong <= 10
    # The scene is one where that matters: some visible hits are on the far side of their sphere.
    center_depth = 4.0 - centers[expected.sphere_id[expected.sphere_id >= 0], 2]
    assert (center_depth < 4.0).mean() > 0.05


def test_far_plane_cuts(rng):
    centers = rng.uniform(-1, 1, (300, 3))
    camera = Camera((0, 0, 4), up=(0, 1, 0), clipping_range=(1.0, 3.5))
    drawn, expected = draw_and_cast(centers, np.full(300, 0.3), camera)
    errors = accuracy.compare(drawn, expected)
    assert errors.good, errors


@pytest.mark.parametrize("samples", [None, 0])
@pytest.mark.parametrize("parallel_scale", [None, 1.5])
def test_clipping_planes_cut_per_pixel(parallel_scale, samples):
    """Two planes leave a wedge of one sphere; every pixel equals the float64 solution."""
    size = (300, 300)
    radius = 1.0
    planes = [((0.2, 0.0, 0.0), (1.0, 0.3, 0.0)), ((0.0, -0.1, 0.3), (0.0, 0.2, -1.0))]
    camera = Camera((1.0, 2.0, 4.0), parallel_scale=parallel_scale)
    packing = make_packing([[0.0, 0.0, 0.0]], [radius])
    with show(packing, camera, size, samples=samples) as (plotter, actor):
        for origin, normal in planes:
            actor.mapper.AddClippingPlane(_plane(origin, normal))
        plotter.render()
        drawn = accuracy.read(plotter)
        to_device = reference.projection(plotter.renderer)
    x, y = np.meshgrid(np.arange(size[0]), np.arange(size[1]))
    rays = reference.pixel_rays(to_device, size, x, y)
    expected = np.full(x.shape, np.inf)
    margin = np.full(x.shape, np.inf)  # how near a decision was
    a = np.sum(rays.direction**2, axis=-1)
    b = np.sum(rays.origin * rays.direction, axis=-1)
    inside = b * b - a * (np.sum(rays.origin**2, axis=-1) - radius**2)
    root = np.sqrt(np.maximum(inside, 0.0))
    margin = np.minimum(margin, np.abs(inside) / a)
    for t in ((-b + root) / a, (-b - root) / a):
        points = rays.origin + t[..., None] * rays.direction
        kept = inside >= 0
        for origin, normal in planes:
            side = (points - origin) @ np.asarray(normal)
            kept &= side >= 0
            margin = np.minimum(margin, np.abs(side))
        expected = np.where(kept, t, expected)
    hit = np.isfinite(expected)
    assert 0.02 < hit.mean() < 0.6
    wrong = (drawn.sphere_id >= 0) != hit
    assert not np.any(wrong & (margin > 1e-6))
    depth = reference.depth_values(to_device, rays, expected)
    steps = np.abs(drawn.depth - depth)[hit & ~wrong] * (2.0**drawn.depth_bits - 1)
    assert np.quantile(steps, 0.999) <= 2.0


def _plane(origin, normal):
    plane = pv._vtk.vtkPlane()
    plane.SetOrigin(origin)
    plane.SetNormal(normal)
    return plane


def test_removing_a_clipping_plane_shows_the_whole_sphere():
    packing = make_packing([[0.0, 0.0, 0.0]], [1.0])
    with show(packing, Camera(), (100, 100)) as (plotter, actor):
        whole = accuracy.read(plotter).sphere_id >= 0
        actor.mapper.AddClippingPlane(_plane((0, 0, 0), (0, 0, 1)))
        plotter.render()
        half = accuracy.read(plotter).sphere_id >= 0
        actor.mapper.RemoveAllClippingPlanes()
        plotter.render()
        again = accuracy.read(plotter).sphere_id >= 0
    assert half.sum() < 0.9 * whole.sum()
    assert np.array_equal(whole, again)
