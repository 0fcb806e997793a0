"""What is known of the light without tracing: energy, shadows, occlusion, skies and suns."""

import numpy as np
import pytest
import spherepacking
from spherepacking import Sun
from views import camera_of, cluster, packing_of, trace

FURNACES = {
    "overlapping spheres": lambda rng: (cluster(rng), camera_of((4, 3, 2), angle=40.0)),
    "tangent spheres": lambda rng: (spherepacking.apollonian(4), camera_of((3, 3, 3))),
    "a lattice of tangent spheres": lambda rng: (
        packing_of(np.argwhere(np.ones((5, 5, 5))) - 2.0, 0.5),
        camera_of((9, 7, 5)),
    ),
    "thousands of duplicates": lambda rng: (
        packing_of(np.repeat(rng.uniform(-1, 1, (4, 3)), 1000, axis=0), 0.5),
        camera_of((4, 3, 2), angle=40.0),
    ),
    "from between the spheres": lambda rng: (cluster(rng), camera_of((0, 0, 0.1), (1, 0, 0.2))),
    "centres at 1e7 with radii 1e-3": lambda rng: (
        packing_of(1e7 + 0.01 * rng.random((300, 3)), 1e-3),
        camera_of((1e7 + 0.03,) * 3, (1e7 + 0.005,) * 3),
    ),
    "radius ratio 1e6": lambda rng: (
        packing_of(rng.uniform(-1, 1, (300, 3)), np.logspace(-6, 0, 300) * 0.5),
        camera_of((4, 3, 2), angle=40.0),
    ),
}


@pytest.mark.parametrize("structure", ["bvh", "grid"])
@pytest.mark.parametrize("scene", FURNACES)
def test_furnace(rng, scene, structure):
    """Spheres that swallow nothing cannot be told from the sky, to the last bit."""
    packing, camera = FURNACES[scene](rng)
    image = trace(
        packing,
        camera,
        samples=64,
        max_bounces=100_000,
        albedo=1.0,
        seed=int(rng.integers(2**32)),
        structure=structure,
    )
    assert (image["sphere_id"] >= 0).any()
    assert (image["radiance"] == 1.0).all()
    assert (image["variance"] == 0.0).all()


@pytest.mark.parametrize("albedo", [0.0, 0.3, 0.8, 1.0])
@pytest.mark.parametrize(
    ("center", "radius"), [((0, 0, 0), 1.0), ((1e6, 2e6, -3e6), 1e-3), ((1e7, 0, 0), 1e-3)]
)
def test_one_sphere_reflects_its_albedo(center, radius, albedo):
    """No shadow on itself, and no acne."""
    center = np.array(center, float)
    camera = camera_of(center + radius * np.array([4, 3, 2]), center)
    image = trace(packing_of([center], radius), camera, albedo=albedo, max_bounces=8)
    inside = image["coverage"] == 1.0
    assert 100 < inside.sum() < inside.size
    assert (image["radiance"][inside] == np.float32(albedo)).all()
    assert (image["radiance"][image["coverage"] == 0.0] == 1.0).all()
    edge = (image["coverage"] > 0) & ~inside
    share = image["coverage"][edge, None]
    np.testing.assert_allclose(
        image["radiance"][edge], share * albedo + (1 - share) * np.ones(3), rtol=1e-5
    )


def occlusion(theta, steps=400):
    """Cosine-weighted share of the hemisphere at angle `theta` (n,) that a touching sphere hides.

    By summing over the cone of directions to the other unit sphere, two of them being 2 apart.
    """
    distance = np.sqrt(5 - 4 * np.cos(theta))
    to_other = np.stack([2 - np.cos(theta), -np.sin(theta)], axis=-1) / distance[:, None]
    facing = (to_other * np.stack([np.cos(theta), np.sin(theta)], axis=-1)).sum(axis=-1)
    most = np.sqrt(1 - 1 / distance**2)
    middles = (np.arange(steps) + 0.5) / steps
    cosines = most[:, None] + (1 - most)[:, None] * middles
    sines = np.sqrt(1 - cosines**2)
    along = np.cos(2 * np.pi * middles)
    across = np.sqrt(np.maximum(1 - facing**2, 0))
    toward = (
        cosines[:, :, None] * facing[:, None, None]
        + sines[:, :, None] * along * across[:, None, None]
    )
    return np.maximum(toward, 0).mean(axis=(1, 2)) * 2 * (1 - most)


def test_two_spheres_in_contact(rng):
    """Ambient occlusion along a meridian, from the far pole to close to the point of contact."""
    packing = packing_of([[0, 0, 0], [2, 0, 0]], 1.0)
    samples = 4096
    camera = camera_of((0.1, -6, 0), (0.1, 0, 0), scale=0.02)
    size = (100, 1)
    x = ((np.arange(size[0]) + 0.5) - size[0] / 2) * 0.04 + 0.1
    image = trace(packing, camera, size, samples=samples, max_bounces=1, albedo=1.0)
    seen = (image["sphere_id"] == 0) & (image["coverage"] == 1.0) & (np.abs(x) < 0.95)
    assert seen.sum() > 40
    expected = 1 - occlusion(np.arccos(x[seen]))
    assert expected.min() < 0.6
    assert expected.max() > 0.99
    found = image["radiance"][seen, 0]
    # Of samples that see the sky or do not, if they were independent.
    error = np.sqrt(expected * (1 - expected) / samples)
    np.testing.assert_allclose(np.sqrt(image["variance"][seen]), error, atol=0.002)
    # What the light changes by within a pixel beside its middle, to second order.
    bend = np.abs(np.gradient(np.gradient(expected)))
    assert (np.abs(found - expected) <= 5 * error + bend + 1e-6).all()


def facing_sphere(normal, radius=1.0):
    """A camera that sees one point of a unit sphere, where the normal is as given."""
    normal = np.asarray(normal, float) / np.linalg.norm(normal)
    up = (0, 0, 1) if abs(normal[2]) < 0.9 else (1, 0, 0)
    return packing_of([[0, 0, 0]], radius), camera_of(5 * normal, up=up, angle=1e-4), normal


NORMALS = [(0, 0, 1), (0, 0, -1), (1, 0, 0), (1, 2, 3), (-2, 1, -0.5)]


@pytest.mark.parametrize("normal", NORMALS)
def test_a_sky_that_changes_with_height(normal):
    packing, camera, n = facing_sphere(normal)
    bottom, top = np.array([0.2, 0.5, 1.0]), np.array([3.0, 1.0, 0.0])
    image = trace(packing, camera, (4, 4), samples=1024, sky=(bottom, top), albedo=0.5)
    # The mean of the direction over the hemisphere, weighted by the cosine, is 2/3 of the normal.
    expected = 0.5 * (bottom + (0.5 + n[2] / 3) * (top - bottom))
    np.testing.assert_allclose(image["radiance"].mean(axis=0), expected, rtol=2e-4)


@pytest.mark.parametrize("normal", NORMALS)
def test_an_image_of_that_sky(normal):
    packing, camera, n = facing_sphere(normal)
    height, width = 256, 8
    z = np.cos(np.pi * (np.arange(height) + 0.5) / height)
    sky = np.broadcast_to((0.2 + 0.8 * (0.5 + 0.5 * z))[:, None, None], (height, width, 3))
    image = trace(packing, camera, (4, 4), samples=1024, sky=sky, albedo=0.5)
    expected = 0.5 * (0.2 + 0.8 * (0.5 + n[2] / 3))
    np.testing.assert_allclose(image["radiance"].mean(axis=0), expected, rtol=1e-3)


def test_a_small_light_in_an_image():
    """All light comes from a few pixels; found by sampling them, not by chance."""
    height, width = 64, 128
    sky = np.zeros((height, width, 3), np.float32)
    row, column = 20, 40
    sky[row, column] = [1000.0, 500.0, 0.0]
    # Where that is: rows go from +z down, columns from -x over +y, +x, -y to -x.
    polar = np.pi * (row + 0.5) / height
    angle = np.pi - 2 * np.pi * (column + 0.5) / width
    light = np.array([np.sin(polar) * np.cos(angle), np.sin(polar) * np.sin(angle), np.cos(polar)])
    # Between the middles of pixels the image is linear, so that the light has as much as one pixel.
    solid = 2 * np.pi / width * np.pi / height * np.sin(polar)
    for normal in (light, light + np.array([0.5, -0.2, 0.3])):
        packing, camera, n = facing_sphere(normal)
        image = trace(packing, camera, (8, 8), samples=1024, sky=sky, albedo=1.0)
        expected = np.array([1000.0, 500.0, 0.0]) * solid * (n @ light) / np.pi
        np.testing.assert_allclose(image["radiance"].mean(axis=0), expected, rtol=0.02)
    packing, camera, n = facing_sphere(-light)
    image = trace(packing, camera, (8, 8), samples=16, sky=sky)
    assert image["radiance"].max() < 1e-6


@pytest.mark.parametrize("diameter", [0.0, 0.53, 40.0])
def test_the_sun(diameter):
    direction = np.array([1.0, 2.0, 2.0]) / 3
    sun = Sun(3 * direction, (2.0, 1.0, 0.5), diameter)
    for normal in (direction, direction + np.array([0.3, -0.3, 0.1])):
        packing, camera, n = facing_sphere(normal)
        image = trace(packing, camera, (4, 4), samples=256, sky=0.0, sun=sun, albedo=0.5)
        # The mean of the directions in a cone is along its middle, however wide it is.
        expected = 0.5 * np.array([2.0, 1.0, 0.5]) * (n @ direction)
        np.testing.assert_allclose(image["radiance"].mean(axis=0), expected, rtol=1e-3)
    packing, camera, n = facing_sphere(-direction)
    image = trace(packing, camera, (4, 4), sky=0.0, sun=sun)
    assert (image["radiance"] == 0).all()


def test_the_suns_shadow():
    """Of a small sphere on a large one: in the umbra no light, outside of the penumbra all."""
    packing = packing_of([[0, 0, 0], [0, 0, 1.5]], [1.0, 0.2])
    camera = camera_of((3, 0, 3), (0, 0, 1), scale=0.6)
    diameter = 10.0
    image = trace(
        packing, camera, (64, 64), samples=64, sky=0.0, sun=Sun((0, 0, 1), 1.0, diameter),
        albedo=1.0, max_bounces=1,
    )  # fmt: skip
    own = (image["sphere_id"] == 0) & (image["coverage"] == 1.0)
    normal = np.where(own[:, None], image["normal"], [0, 0, 1])
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    away, gap = np.hypot(normal[:, 0], normal[:, 1]), 1.5 - normal[:, 2]
    half = np.arcsin(0.2 / np.hypot(away, gap))
    off = np.arctan2(away, gap)
    sun, pixel = np.radians(diameter / 2), 0.04
    dark = own & (off < half - sun - pixel)
    light = own & (off > half + sun + pixel) & (normal[:, 2] > 0.3)
    assert min(dark.sum(), light.sum()) > 20
    assert (image["radiance"][dark] == 0).all()
    np.testing.assert_allclose(image["radiance"][light, 0], normal[light, 2], atol=0.01)
    between = own & (np.abs(off - half) < sun / 2)
    assert ((image["radiance"][between, 0] > 0) & (image["radiance"][between, 0] < 0.99)).all()


def test_color_bleeds():
    """Beside a red sphere a white one turns red, more with more bounces."""
    packing = packing_of([[0, 0, 0], [2, 0, 0]], 1.0)
    packing["paint_rgb"] = np.array([[255, 255, 255], [255, 0, 0]], np.uint8)
    camera = camera_of((0.9, -6, 0), (0.9, 0, 0), scale=0.02)
    kwargs = {"scalars": "paint_rgb", "samples": 256, "albedo": 1.0}
    first, more = (
        trace(packing, camera, (8, 1), max_bounces=n, **kwargs)["radiance"] for n in (1, 6)
    )
    # The first pixels see the white sphere.
    np.testing.assert_allclose(first[0, 0], first[0, 1])
    assert more[0, 0] > 1.05 * more[0, 1]
    assert more[0, 0] > first[0, 0]


def test_without_bounces_spheres_are_black():
    packing, camera, _ = facing_sphere((1, 1, 1))
    image = trace(packing, camera, max_bounces=0, sun=(1, 1, 1))
    assert (image["radiance"] == 0).all()
    assert (image["coverage"] == 1).all()
