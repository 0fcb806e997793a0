"""The light of an image: bilinear between the middles of its pixels, and integrated as that."""

import struct
import subprocess
import sys
import zlib

import numpy as np
import pytest
import spherepacking
from spherepacking.files import image
from spherepacking.trace.sky import sky_of
from test_energy import facing_sphere
from views import trace

NORMALS = [(0.2, 0.3, 0.9), (1, 0.5, -0.2), (-0.3, 1, 0.1)]


def bilinear(sky, x, y):
    """Radiance at points in pixels from the upper left corner; the image goes around along x."""
    height, width = sky.shape
    left, above = np.floor(x - 0.5).astype(int), np.floor(y - 0.5).astype(int)
    right, below = x - 0.5 - left, y - 0.5 - above

    def pixel(row, column):
        return sky[np.clip(row, 0, height - 1), column % width]

    upper = (1 - right) * pixel(above, left) + right * pixel(above, left + 1)
    lower = (1 - right) * pixel(above + 1, left) + right * pixel(above + 1, left + 1)
    return (1 - below) * upper + below * lower


def reflected(sky, normal, lookup=bilinear, steps=48):
    """What a white surface reflects, by summing over cells of the directions."""
    height, width = sky.shape
    edges = np.cos(np.pi * np.arange(height * steps + 1) / (height * steps))
    polar = np.pi * (np.arange(height * steps) + 0.5) / (height * steps)
    across = (np.arange(width * steps) + 0.5) / (width * steps)
    polar, across = np.meshgrid(polar, across, indexing="ij")
    angle = np.pi - 2 * np.pi * across
    light = np.stack(
        [np.sin(polar) * np.cos(angle), np.sin(polar) * np.sin(angle), np.cos(polar)], axis=-1
    )
    solid = (edges[:-1] - edges[1:])[:, None] * 2 * np.pi / (width * steps)
    radiance = lookup(sky, across * width, polar / np.pi * height)
    return (radiance * np.maximum(light @ normal, 0) * solid).sum() / np.pi


@pytest.mark.parametrize("row", [0, 1, 3, 7])
@pytest.mark.parametrize("direction", NORMALS)
def test_one_bright_pixel(row, direction):
    """It lights as the bilinear image does, also at the poles; not as a pixel of one colour."""
    sky = np.zeros((8, 16))
    sky[row, 5] = 100.0
    packing, camera, normal = facing_sphere(direction)
    expected = reflected(sky, normal)
    colors = sky[..., None] * [1.0, 0.1, 0.01]
    traced = trace(packing, camera, (8, 8), samples=4096, sky=colors, albedo=1.0, max_bounces=1)
    found = traced["radiance"].mean(axis=0)
    error = np.sqrt(traced["variance"].mean() / traced.n_points)
    assert error < 1.5e-3 * expected + 1e-6
    np.testing.assert_allclose(found, expected * np.array([1.0, 0.1, 0.01]), atol=3 * error)
    np.testing.assert_allclose(found[0], expected, rtol=1.5e-3, atol=1e-6)


def test_the_nearest_pixel_would_be_another_sky():
    """By some per cent, for a pixel beside a pole: that is no fault of the sampling."""
    sky = np.zeros((8, 16))
    sky[0, 5] = 100.0
    _, _, normal = facing_sphere(NORMALS[0])
    nearest = reflected(sky, normal, lambda sky, x, y: sky[y.astype(int), x.astype(int)])
    assert abs(nearest / reflected(sky, normal) - 1) > 0.05


def test_what_is_seen_of_the_sky_is_bilinear(rng):
    sky = rng.random((4, 8))
    packing, camera, _ = facing_sphere((1, 0, 0))
    camera.position, camera.focal_point, camera.view_angle = (5, 0, 0), (9, 2, 1), 50.0
    traced = trace(packing, camera, (40, 30), samples=1, sky=np.repeat(sky[..., None], 3, axis=2))
    assert (traced["coverage"] == 0).all()
    towards = np.array([4.0, 2.0, 1.0]) / np.sqrt(21)
    right = np.cross(towards, (0, 0, 1))
    right /= np.linalg.norm(right)
    x, y = np.meshgrid((np.arange(40) - 19.5) / 15, (np.arange(30) - 14.5) / 15)
    slope = np.tan(np.radians(25.0))
    light = towards + slope * (x[..., None] * right + y[..., None] * np.cross(right, towards))
    light /= np.linalg.norm(light, axis=-1, keepdims=True)
    across = (0.5 - np.arctan2(light[..., 1], light[..., 0]) / (2 * np.pi)) * 8
    expected = bilinear(sky, across, np.arccos(light[..., 2]) / np.pi * 4)
    found = np.asarray(traced["radiance"])[:, 0].reshape(30, 40)
    # A ray goes through any point of its pixel.
    np.testing.assert_allclose(found, expected, atol=0.02)


@pytest.fixture
def bomb(tmp_path):
    """The start of a PNG file of 1600 million pixels; what it holds is not read.

    OpenImageIO looks only at the size of the file beside that of the picture.
    """
    path = tmp_path / "bomb.png"
    header = struct.pack(">IIBBBBB", 40000, 40000, 8, 2, 0, 0, 0)
    data = zlib.compress(bytes(10**6))
    chunks = [(b"IHDR", header), (b"juNk", bytes(6 * 10**6)), (b"IDAT", data), (b"IEND", b"")]
    path.write_bytes(
        b"\x89PNG\r\n\x1a\n"
        + b"".join(
            struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
            for kind, body in chunks
        )
    )
    return path


def test_an_image_that_is_too_large_is_refused_by_its_header(bomb, tmp_path):
    """It took 9.6 GB and ended in a MemoryError."""
    spherepacking.write(spherepacking.apollonian(2), tmp_path / "a.spheres")
    options = ["--technique", "pathtrace", "--samples", "1", "--size", "20", "20", "--sky", bomb]
    run = subprocess.run(
        [sys.executable, "-c", _WITH_LITTLE_MEMORY, "render", "a.spheres", "-o", "a.png", *options],
        cwd=tmp_path,
        capture_output=True,
        text=True,
    )
    assert run.returncode == 2, run.stderr
    assert f"{bomb}: found 40000 x 40000 pixels, " in run.stderr
    assert "expected at most" in run.stderr
    assert run.stderr.count("\n") == 1
    assert not (tmp_path / "a.png").exists()


_WITH_LITTLE_MEMORY = """
import resource, sys
from spherepacking.__main__ import main
resource.setrlimit(resource.RLIMIT_DATA, (2 * 10**9, 2 * 10**9))
sys.exit(main())
"""


def test_pictures_that_fill_the_memory_are_refused(bomb, monkeypatch):
    monkeypatch.setattr(image, "half_of_memory", lambda: 10**9)
    with pytest.raises(
        OSError, match=r"found 40000 x 40000 .* half of the memory, expected at mos"
    ):
        spherepacking.read_image(bomb)
    with pytest.raises(OSError, match=r"expected at most 15625000 of them"):
        sky_of(bomb)
    monkeypatch.setattr(image, "half_of_memory", lambda: 10**15)
    with pytest.raises(OSError, match=r"found 40000 x 40000 pixels, expected at most 536870912"):
        sky_of(bomb)
