"""The mapper against float64 rays: silhouette, sphere and depth in every pixel."""

import numpy as np
import pytest
import spherepacking
from scenes import Camera, draw_and_cast
from spherepacking.testing import accuracy
from spherepacking.testing.scenes import knot_tube


def check(centers, radii, camera, size=(400, 400), sphere_wrong=1e-4):
    """Compare; `sphere_wrong` bounds the share of pixels that show another sphere."""
    for samples in (None, 0):
        drawn, expected = draw_and_cast(
            np.asarray(centers), np.asarray(radii), camera, size, samples=samples
        )
        errors = accuracy.compare(drawn, expected)
        assert errors.hit_pixels > 0
        assert errors.good, errors
        assert errors.sphere_wrong <= sphere_wrong * errors.hit_pixels + 1, errors


ONE = np.zeros((1, 3))


@pytest.mark.parametrize("distance", [1.0001, 1.01, 1.5, 2.9, 3.1, 3.999, 4.001, 20.1, 1e4])
@pytest.mark.parametrize("view_angle", [20.0, 90.0])
def test_one_sphere_from(distance, view_angle):
    camera = Camera((distance, 0.0, 0.0), view_angle=view_angle)
    if distance == 1e4:
        camera.view_angle = 0.02
    check(ONE, [1.0], camera)


@pytest.mark.parametrize("angle", [20.0, 40.0, 60.0])
def test_projected_ellipse_far_from_the_middle_of_the_window(angle):
    # Seen 60 degrees off axis the outline is stretched 4 times.
    away = np.array([[0.0, np.sin(np.radians(angle)), np.cos(np.radians(angle))]])
    camera = Camera((0, 0, 0), (0, 0, 1), (0, 1, 0), view_angle=130.0)
    check(4.0 * away, [0.9], camera, (500, 500))
    check(40.0 * away, [1.5], camera, (500, 500))


def test_inside_a_sphere():
    check(ONE, [1.0], Camera((0.5, 0.1, 0.2)))
    check(ONE, [1.0], Camera((0.0, 0.0, 0.0), (1.0, 0.0, 0.0)))


def test_parallel_view():
    check(ONE, [1.0], Camera(parallel_scale=1.2))


def test_parallel_view_from_1000_extents_away(rng):
    centers = rng.uniform(-1, 1, (400, 3))
    check(centers, rng.uniform(0.02, 0.2, 400), Camera((2000, 500, 300), parallel_scale=1.5))


def test_apollonian_packing_of_mutually_tangent_spheres():
    packing = spherepacking.apollonian(5)
    check(packing.points, packing["radius"], Camera((1.6, 1.2, 1.4)))


@pytest.mark.parametrize(
    "camera",
    [
        Camera(),
        Camera(parallel_scale=1.8),
        Camera((0.9, 0.0, 0.3), (0.0, 0.9, 0.0), view_angle=90.0),
    ],
    ids=["outside", "parallel", "inside the tube"],
)
def test_packing_of_which_most_is_hidden(camera):
    # Enough spheres that those behind what is drawn already are dropped before they are drawn.
    packing = knot_tube(25_000)
    check(packing.points, packing["radius"], camera, (360, 360))


@pytest.mark.parametrize("parallel_scale", [None, 1.5])
def test_radius_ratio_of_a_million(rng, parallel_scale):
    centers = rng.normal(size=(2000, 3))
    centers *= 1.0 / np.linalg.norm(centers, axis=1, keepdims=True)
    radii = 10.0 ** rng.uniform(-6, -1, 2000)
    check(
        np.vstack([ONE, centers]),
        np.concatenate([[1.0], radii]),
        Camera((2, 2, 2), parallel_scale=parallel_scale),
    )


@pytest.mark.parametrize("size", [(1, 1), (7, 300), (300, 7), (257, 129)])
def test_window_of_size(rng, size):
    check(rng.uniform(-1, 1, (50, 3)), np.full(50, 0.4), Camera((1.5, 0, 0), view_angle=80), size)


@pytest.mark.parametrize(
    "settings",
    [
        {"SetWindowCenter": (0.6, -0.3)},  # as tiled displays use it
        {"SetViewShear": (0.1, 0.05, 1.0)},  # and stereo is a shear too
    ],
    ids=lambda settings: " ".join(settings),
)
def test_off_center_projection(rng, settings):
    camera = Camera(settings=settings)
    check(rng.uniform(-1, 1, (200, 3)), np.full(200, 0.2), camera)


def test_spheres_at_the_window_edge(rng):
    centers = rng.uniform(-3, 3, (500, 3))
    check(centers, rng.uniform(0.02, 0.5, 500), Camera((6, 0, 0), view_angle=30))


def test_coincident_and_nested_spheres(rng):
    centers = np.repeat(rng.uniform(-1, 1, (20, 3)), 5, axis=0)
    radii = np.tile([0.1, 0.2, 0.3, 0.3 * (1 - 1e-3), 0.01], 20)
    check(centers, radii, Camera())


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_real_packing(data_file, dtype):
    packing = spherepacking.read(data_file("clump.csv"))
    check(packing.points.astype(dtype).astype(float), packing["radius"], Camera((3, 2, 1)))


def test_real_packing_of_equal_spheres(data_file):
    packing = spherepacking.read(data_file("equal.xyzd"))
    middle = tuple(packing.points.mean(axis=0))
    check(packing.points, packing["radius"], Camera((40, 35, 30), middle), (600, 600))


def test_solar_system(data_file):
    import json

    bodies = json.loads(data_file("planets.json").read_text())["bodies"]
    centers = np.array([body["position"] for body in bodies])
    radii = np.array([body["radius"] for body in bodies])
    # From near the smallest body, across millions of its radii.
    target = int(np.argmin(radii))
    away = centers[target] + radii[target] * np.array([3.0, 1.0, 0.5])
    camera = Camera(tuple(away), tuple(centers[target]), clipping_range=(radii[target], 1e10))
    check(centers, radii, camera)


@pytest.mark.parametrize("parallel_scale", [None, 4e-3])
def test_no_jitter_at_1e7(rng, parallel_scale):
    """Moved by 1e7, spheres of radius 1e-3 look as in the origin, to a thousandth of a pixel."""
    # Multiples of 2^-28 are exact in doubles near 1e7, so both scenes are the same.
    grid = 2.0**-28
    centers = np.round(rng.uniform(-4e-3, 4e-3, (200, 3)) / grid) * grid
    radii = rng.uniform(5e-4, 1e-3, 200)
    offset = np.array([1e7, -1e7, 0.5e7])
    pictures = []
    for shift in (np.zeros(3), offset):
        camera = Camera(
            tuple(shift + grid * np.round(0.02 / grid)),
            tuple(shift),
            view_angle=30,
            parallel_scale=parallel_scale,
            clipping_range=(0.02, 0.06),
        )
        drawn, _ = draw_and_cast(centers + shift, radii, camera)
        pictures.append(drawn)
    ids = [picture.sphere_id for picture in pictures]
    assert (ids[0] >= 0).sum() > 10_000
    assert np.mean(ids[0] != ids[1]) < 1e-4
    both = (ids[0] == ids[1]) & (ids[0] >= 0)
    depth = np.abs(pictures[0].depth - pictures[1].depth)[both]
    # The camera's own matrix holds 1e7 to 1e-9, a millionth of a radius.
    assert np.quantile(depth, 0.999) * 0.04 < 1e-2 * 1e-3


def test_sizes_around_the_largest_point(rng):
    """Spheres a hair smaller and larger than what is drawn as a point are all there."""
    radii = np.linspace(0.97, 1.01, 16)  # 255 pixels are a radius of 0.99 here
    for radius in radii:
        drawn, expected = draw_and_cast(
            ONE, [radius], Camera((0, 0, 10), up=(0, 1, 0), parallel_scale=1.5), (300, 386)
        )
        assert np.array_equal(drawn.sphere_id >= 0, expected.sphere_id >= 0), radius
