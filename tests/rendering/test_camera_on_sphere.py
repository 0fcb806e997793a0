"""A camera that is exactly on the surface of a sphere: one rule for all that draws or picks.

Outwards that sphere is not seen, inwards its far side is. Some rays hit it where they started.
"""

import numpy as np
import pytest
import pyvista as pv

SIZE = (60, 60)
RAYS = SIZE[0] * SIZE[1]


def surfaces(rng, count=25):
    """Centre, radius, unit normal, and the point of the surface as doubles have it."""
    for _ in range(count):
        center = rng.uniform(-1, 1, 3) * 10 ** rng.uniform(-2, 3)
        radius = 10 ** rng.uniform(-2, 2)
        normal = rng.normal(size=3)
        normal /= np.linalg.norm(normal)
        yield center, radius, normal, center + radius * normal


def sphere(*centers, radius):
    packing = pv.PolyData(np.array(centers, float))
    packing["radius"] = np.broadcast_to(np.asarray(radius, float), len(centers)).copy()
    return packing


@pytest.mark.parametrize("structure", ["bvh", "grid", "none"])
@pytest.mark.parametrize("samples", [1, 2])
def test_rays_from_the_surface(rng, structure, samples):
    """With a wide angle of view, so that some of them are tangents."""
    for center, radius, normal, point in surfaces(rng):
        packing = sphere(center, radius=radius)
        for towards, seen in ((normal, 0), (-normal, RAYS)):
            camera = pv.Camera()
            camera.position, camera.focal_point = point, point + radius * towards
            camera.up, camera.view_angle = np.roll(normal, 1), 100.0
            image = packing.packing.ray_cast(
                camera, SIZE, structure=structure, samples=samples, color="red"
            )
            assert (image["sphere_id"] >= 0).sum() == seen
            assert (image["color"][:, 3] > 0).sum() == seen
            if not seen:
                continue
            # The chord is 2 r cos(a), and the depth that along the direction of view.
            x, y = np.meshgrid(*((np.arange(60) - 29.5) / 30,) * 2)
            slope = np.tan(np.radians(50.0)) ** 2 * (x**2 + y**2)
            depth = np.asarray(image["depth"]).reshape(60, 60) / radius
            np.testing.assert_allclose(depth, 2 / (1 + slope), rtol=1e-5)


def test_tangents(rng):
    """Square to the normal a ray touches at most: it is no ray into the sphere."""
    for center, radius, normal, point in surfaces(rng):
        packing = sphere(center, radius=radius)
        side = np.cross(normal, np.roll(normal, 1))
        image = packing.packing.ray_cast([point, point + radius * side, normal], SIZE)
        hit = np.asarray(image["sphere_id"]).reshape(60, 60) >= 0
        # The lower half looks into the sphere.
        assert not hit[31:].any()
        assert hit[:29].all()


def test_picks(rng):
    for center, radius, normal, point in surfaces(rng):
        packing = sphere(center, radius=radius)
        up = np.roll(normal, 1)
        assert packing.packing.pick([point, point + normal, up], (3, 3), 1.5, 1.5) is None
        found = packing.packing.pick([point, point - normal, up], (3, 3), 1.5, 1.5)
        assert found.sphere_id == 0
        np.testing.assert_allclose(found.normal, -normal, atol=1e-6)
        np.testing.assert_allclose(found.point, center - radius * normal, atol=1e-6 * radius)


def test_paths(rng):
    for center, radius, normal, point in surfaces(rng, 6):
        packing = sphere(center, radius=radius)
        up = np.roll(normal, 1)
        outwards = packing.packing.path_trace([point, point + normal, up], SIZE, samples=2)
        assert (outwards["coverage"] == 0).all()
        assert (outwards["radiance"] == 1).all()
        inwards = packing.packing.path_trace([point, point - normal, up], SIZE, samples=2)
        assert (inwards["coverage"] == 1).all()


def test_what_is_behind_is_seen(rng):
    """Another sphere in front of a camera on the first."""
    packing = sphere((0, 0, 0), (5, 0, 0), radius=[1.0, 2.0])
    image = packing.packing.ray_cast([(1, 0, 0), (2, 0, 0), (0, 0, 1)], SIZE)
    ids = np.asarray(image["sphere_id"])
    assert set(ids) == {1}
    assert packing.packing.pick([(1, 0, 0), (2, 0, 0), (0, 0, 1)], (3, 3), 1.5, 1.5).sphere_id == 1


def test_a_camera_close_by_is_not_on_it():
    """A billionth of the radius from the surface rays still start inside or outside."""
    packing = sphere((0, 0, 0), radius=1.0)
    for x, depth in ((1 + 1e-9, None), (1 - 1e-9, 1e-9)):
        found = packing.packing.ray_cast([(x, 0, 0), (2, 0, 0), (0, 0, 1)], (1, 1))
        hit = float(found["depth"][0])
        assert np.isinf(hit) if depth is None else abs(hit - depth) < 1e-15


def test_the_mapper(rng):
    for _, radius, normal, point in surfaces(rng, 8):
        packing = sphere((0, 0, 0), radius=radius)
        point = radius * normal
        plotter = pv.Plotter(off_screen=True, window_size=SIZE)
        try:
            plotter.render_window.SetMultiSamples(0)
            plotter.set_background("black")
            plotter.packing.add(packing, color="white", ambient=1.0, diffuse=0.0)
            for towards, seen in ((normal, 0), (-normal, RAYS)):
                plotter.camera_position = [point, point + radius * towards, np.roll(normal, 1)]
                plotter.camera.clipping_range = (1e-3 * radius, 10 * radius)
                plotter.render()
                drawn = plotter.screenshot(None, return_img=True)
                assert (drawn.max(axis=2) > 0).sum() == seen
        finally:
            plotter.close()
