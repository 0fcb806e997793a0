"""``packing.path_trace`` and ``write_render``: arguments, skies, files, denoising."""

import importlib.util
import os
import signal
import sys
import threading
import time

import numpy as np
import OpenImageIO as oiio
import pytest
import pyvista as pv
import spherepacking
from spherepacking import Sun
from spherepacking.accessor import PackingAccessor

VIEW = [(3, 3, 3), (0, 0, 0), (0, 0, 1)]
SIZE = (60, 40)


@pytest.fixture
def spheres():
    return spherepacking.apollonian(3)


def light(spheres, **kwargs):
    return np.array(
        PackingAccessor(spheres).path_trace(VIEW, SIZE, samples=4, **kwargs)["radiance"]
    )


def test_defaults(spheres):
    """White spheres of albedo 0.8 under a white sky, whatever scalars are active."""
    image = spheres.packing.path_trace(VIEW, SIZE)
    assert image.dimensions == (*SIZE, 1)
    assert (image["samples"] == 16).all()
    whole = image["coverage"] == 1
    assert (image["albedo"][whole] == np.float32(0.8)).all()
    assert (image["radiance"][image["coverage"] == 0] == 1).all()
    expected = spheres.packing.path_trace(
        VIEW, SIZE, samples=16, max_bounces=4, albedo=0.8, sky=1.0, sun=None, seed=0
    )
    assert (image["radiance"] == expected["radiance"]).all()


def test_the_same_sky_in_other_words(spheres, tmp_path):
    expected = light(spheres, sky=0.5)
    for sky in (
        np.array([0.5, 0.5]),
        np.full((2, 3), 0.5),
        (0.5, 0.5),
        (0.5, 0.5, 0.5),
        ((0.5, 0.5, 0.5), 0.5),
        np.full(3, 0.5),
    ):
        assert (light(spheres, sky=sky) == expected).all()
    pixels = np.full((8, 16, 3), 0.5, np.float32)
    pixels[2, 3] = [4.0, 2.0, 1.0]
    by_value = light(spheres, sky=pixels)
    assert (by_value != expected).any()
    spherepacking.write_image(tmp_path / "sky.exr", pixels)
    for path in (tmp_path / "sky.exr", str(tmp_path / "sky.exr")):
        assert (light(spheres, sky=path) == by_value).all()
    # Bytes are sRGB: 188 is half of the light.
    coded = light(spheres, sky=np.full((8, 16, 3), 188, np.uint8))
    np.testing.assert_allclose(coded[:50], expected[:50], rtol=0.01)
    np.testing.assert_allclose(coded.mean(), expected.mean(), rtol=0.02)


def test_suns(spheres):
    dark = light(spheres, sky=0.0)
    assert (dark == 0).all()
    one = light(spheres, sky=0.0, sun=(1, 1, 1))
    assert (one == light(spheres, sky=0.0, sun=Sun((1, 1, 1), 1.0, 0.53))).all()
    two = light(spheres, sky=0.0, sun=Sun([1, 1, 1], (2.0, 1.0, 0.0)))
    np.testing.assert_allclose(two[:, 0], 2 * one[:, 0], rtol=1e-5)
    assert (two[:, 2] == 0).all()


def test_an_image_of_a_sky_is_kept(spheres):
    accessor = PackingAccessor(spheres)
    sky = np.random.default_rng(1).random((8, 16, 3))
    accessor.path_trace(VIEW, SIZE, samples=2, sky=sky)
    image = accessor.path_trace(VIEW, SIZE, samples=5, sky=sky.copy())
    assert image.field_data["traced_samples"][0] == 3 * SIZE[0] * SIZE[1]
    sky[0, 0] = 2.0
    image = accessor.path_trace(VIEW, SIZE, samples=5, sky=sky)
    assert image.field_data["traced_samples"][0] == 5 * SIZE[0] * SIZE[1]


def test_colors(spheres):
    albedo = np.array(
        PackingAccessor(spheres).path_trace(VIEW, SIZE, color="#ff8000", albedo=0.5)["albedo"]
    )
    hit = albedo[:, 0] == 0.5
    assert hit.sum() > 100
    linear = ((128 / 255 + 0.055) / 1.055) ** 2.4
    np.testing.assert_allclose(albedo[hit], [[0.5, 0.5 * linear, 0.0]] * hit.sum(), rtol=1e-5)
    for kwargs in ({"scalars": "radius", "cmap": "magma"}, {"random_colors": True}):
        image = spheres.packing.path_trace(VIEW, SIZE, samples=1, **kwargs)
        assert len(np.unique(image["albedo"], axis=0)) > 5


def test_what_is_written_into_a_picture_is_not_kept(spheres):
    accessor = PackingAccessor(spheres)
    first = accessor.path_trace(VIEW, SIZE, samples=4)
    expected = np.array(first["radiance"])
    first["radiance"] *= 0.5
    assert (accessor.path_trace(VIEW, SIZE, samples=4)["radiance"] == expected).all()


def test_a_picture_whose_arrays_are_renamed_is_not_gone_on_with(spheres):
    accessor = PackingAccessor(spheres)
    accessor.path_trace(VIEW, SIZE, samples=2).rename_array("radiance", "light")
    image = accessor.path_trace(VIEW, SIZE, samples=4)
    assert (image["radiance"] == light(spheres)).all()


@pytest.mark.parametrize("name", ["points", "radius"])
def test_arrays_that_are_changed_without_a_word_to_vtk(spheres, name):
    """Samples of two packings are never mixed."""
    accessor = PackingAccessor(spheres)
    accessor.path_trace(VIEW, SIZE, samples=2)
    values = np.asarray(spheres.points if name == "points" else spheres["radius"])
    np.multiply(values, values.dtype.type(0.5), out=values)
    image = accessor.path_trace(VIEW, SIZE, samples=4)
    assert (image["radiance"] == light(spheres.copy())).all()


@pytest.mark.parametrize("method", ["path_trace", "ray_cast"])
def test_radii_that_are_changed_in_place(spheres, method):
    """NumPy changes them, and PyVista says no more than that an array was added."""
    accessor = PackingAccessor(spheres)
    first = getattr(accessor, method)(VIEW, SIZE, samples=1)
    spheres["radius"] *= 0.5
    second = getattr(accessor, method)(VIEW, SIZE, samples=1)
    expected = getattr(PackingAccessor(spheres.copy()), method)(VIEW, SIZE, samples=1)
    assert (second["sphere_id"] != first["sphere_id"]).any()
    assert (second["sphere_id"] == expected["sphere_id"]).all()
    spheres["weight"] = np.arange(spheres.n_points)
    third = getattr(accessor, method)(VIEW, SIZE, samples=1)
    assert third.field_data["build_seconds"][0] == second.field_data["build_seconds"][0]


def test_radii_that_are_texts(spheres):
    spheres["radius"] = np.full(spheres.n_points, "a")
    for _ in range(2):
        with pytest.raises(TypeError, match="radius: "):
            spheres.packing.path_trace(VIEW, SIZE, samples=1)


def test_scalars_by_value_go_on(spheres):
    accessor = PackingAccessor(spheres)
    values = np.arange(spheres.n_points, dtype=float)
    accessor.path_trace(VIEW, SIZE, samples=2, scalars=values)
    image = accessor.path_trace(VIEW, SIZE, samples=5, scalars=values.copy())
    assert image.field_data["traced_samples"][0] == 3 * SIZE[0] * SIZE[1]
    image = accessor.path_trace(VIEW, SIZE, samples=5, scalars=values[::-1])
    assert image.field_data["traced_samples"][0] == 5 * SIZE[0] * SIZE[1]


def test_endless_limits_are_none(spheres):
    image = spheres.packing.path_trace(
        VIEW, SIZE, samples=2, time_budget=np.inf, noise_target=np.inf
    )
    assert (image["samples"] == 2).all()


BAD = [
    ({"samples": 0}, ValueError, "samples: found 0"),
    ({"samples": 1.5}, TypeError, "samples: found 1.5"),
    ({"samples": True}, TypeError, "samples: found True"),
    ({"max_bounces": -1}, ValueError, "max_bounces: found -1"),
    ({"albedo": 1.1}, ValueError, "albedo: found 1.1"),
    ({"albedo": np.nan}, ValueError, "albedo: found nan"),
    ({"sky": -1}, ValueError, "sky: found"),
    ({"sky": (1, 2, 3, 4)}, TypeError, "sky: found"),
    ({"sky": "nowhere.exr"}, FileNotFoundError, "nowhere.exr: no such file"),
    ({"sky": None}, TypeError, "sky: found None"),
    ({"sky": np.full((2, 4, 3), np.nan)}, ValueError, "sky: found nan in an array"),
    ({"sky": np.full((2, 4, 3), 255)}, TypeError, "sky: found an image of int64"),
    ({"sky": 1e16}, ValueError, "sky: found"),
    ({"denoise": 1}, TypeError, "denoise: found 1"),
    ({"sun": (0, 0, 0)}, ValueError, "sun: found the direction"),
    ({"sun": "up"}, TypeError, "sun: found 'up'"),
    ({"sun": Sun((0, 0, 1), -1)}, ValueError, "sun: found -1"),
    ({"sun": Sun((0, 0, 1), 1, 200)}, ValueError, "sun's diameter: found 200"),
    ({"seed": -1}, ValueError, "seed: found -1"),
    ({"seed": 2**32}, ValueError, "seed: found 4294967296"),
    ({"structure": "tree"}, ValueError, "structure: found 'tree'"),
    ({"tile": 0}, ValueError, "tile: found 0"),
    ({"time_budget": 0}, ValueError, "time_budget: found 0"),
    ({"noise_target": -1}, ValueError, "noise_target: found -1"),
    ({"min_samples": 1}, ValueError, "min_samples: found 1"),
    ({"exposure": np.inf}, ValueError, "exposure: found inf"),
    ({"filmic": 1}, TypeError, "filmic: found 1"),
    ({"sky_visible": None}, TypeError, "sky_visible: found None"),
    ({"camera": "front"}, TypeError, "camera: found a str"),
    ({"window_size": (5, 0)}, ValueError, "window_size: found 0"),
    ({"scalars": "mass"}, KeyError, "mass"),
]


@pytest.mark.parametrize(("kwargs", "error", "found"), BAD)
def test_refusals(spheres, kwargs, error, found):
    accessor = PackingAccessor(spheres)
    with pytest.raises(error, match=found.replace("(", r"\(")):
        accessor.path_trace(**({"camera": VIEW, "window_size": SIZE} | kwargs))
    # And works after that.
    assert (accessor.path_trace(VIEW, SIZE, samples=1)["coverage"] > 0).any()


def test_an_unreadable_sky(spheres, tmp_path):
    path = tmp_path / "sky.hdr"
    path.write_text("no picture")
    with pytest.raises(OSError, match=r"sky\.hdr: the picture cannot be read"):
        light(spheres, sky=path)


def test_after_ctrl_c_it_goes_on(spheres):
    accessor = PackingAccessor(spherepacking.apollonian(5))
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        accessor.path_trace(VIEW, (200, 200), samples=100_000)
    timer.join()
    image = accessor.path_trace(VIEW, (200, 200), samples=100_000, time_budget=0.01)
    least = int(image["samples"].max())
    expected = PackingAccessor(spherepacking.apollonian(5)).path_trace(
        VIEW, (200, 200), samples=least
    )
    image = accessor.path_trace(VIEW, (200, 200), samples=least)
    assert image.field_data["traced_samples"][0] < 200 * 200 * least
    assert (image["radiance"] == expected["radiance"]).all()


def test_exr_holds_all_of_it(spheres, tmp_path):
    image = spheres.packing.path_trace(VIEW, SIZE, samples=3, seed=7, max_bounces=2)
    path = tmp_path / "all.exr"
    spherepacking.write_render(path, image)
    source = oiio.ImageInput.open(str(path))
    spec = source.spec()
    pixels = source.read_image("float")[::-1].reshape(SIZE[0] * SIZE[1], -1)
    source.close()
    channels = dict(zip(spec.channelnames, pixels.T, strict=True))
    for array, names in {
        "radiance": "R G B",
        "albedo": "albedo.R albedo.G albedo.B",
        "normal": "normal.X normal.Y normal.Z",
        "depth": "Z",
        "coverage": "coverage.A",
        "variance": "variance.Y",
        "samples": "samples.Y",
    }.items():
        found = np.column_stack([channels[name] for name in names.split()])
        np.testing.assert_array_equal(found, np.asarray(image[array]).reshape(found.shape))
    ids = 65536 * channels["sphere_id.high"] + channels["sphere_id.low"]
    np.testing.assert_array_equal(ids, image["sphere_id"])
    assert spec.getattribute("Software") == f"spherepacking {spherepacking.__version__}"
    assert spec.getattribute("spherepacking:seed") == 7
    assert spec.getattribute("spherepacking:samples") == 3
    assert spec.getattribute("spherepacking:max_bounces") == 2
    assert spec.getattribute("spherepacking:camera_position") == "3.0 3.0 3.0"
    assert spec.getattribute("spherepacking:view_angle") == 30.0


def test_other_formats_hold_the_colors(spheres, tmp_path):
    image = spheres.packing.path_trace(VIEW, SIZE, samples=1, sky_visible=False)
    spherepacking.write_render(tmp_path / "a.png", image)
    pixels = spherepacking.read_image(tmp_path / "a.png")
    np.testing.assert_array_equal(pixels[::-1].reshape(-1, 4), image["color"])
    # Formats without opacity.
    image = spheres.packing.path_trace(VIEW, SIZE, samples=1, seed=2**32 - 1)
    for name in ("a.ppm", "a.hdr", "a.exr"):
        spherepacking.write_render(tmp_path / name, image)
        assert spherepacking.read_image(tmp_path / name).shape[:2] == SIZE[::-1]
    with pytest.raises(ValueError, match="no point array 'color'"):
        spherepacking.write_render(tmp_path / "b.exr", pv.ImageData(dimensions=(2, 2, 1)))
    with pytest.raises(ValueError, match="no picture format"):
        spherepacking.write_render(tmp_path / "b.nothing", image)


def test_without_the_denoiser_it_says_so(spheres, monkeypatch):
    monkeypatch.setitem(sys.modules, "pyoidn", None)
    with pytest.raises(ImportError, match=r"denoise: .*spherepacking\[denoise\]"):
        spheres.packing.path_trace(VIEW, SIZE, samples=1, denoise=True)


needs_denoiser = pytest.mark.skipif(
    not importlib.util.find_spec("pyoidn"),
    reason="the extra 'denoise' is not there, as on other processors than x86-64",
)


@needs_denoiser
def test_a_preview_is_not_denoised(spheres):
    """Its pixels without light would be taken for dark ones."""
    kwargs = {"samples": 8, "time_budget": 1e-9, "preview": True}
    image = PackingAccessor(spheres).path_trace(VIEW, SIZE, denoise=True, **kwargs)
    plain = PackingAccessor(spheres).path_trace(VIEW, SIZE, **kwargs)
    assert (image["samples"] == 0).any()
    assert "denoised" not in image.point_data
    assert (image["color"] == plain["color"]).all()


@needs_denoiser
def test_denoising_comes_closer():
    spheres = spherepacking.apollonian(5)
    size = (160, 120)
    kwargs = {"sky": (0.2, 1.0), "sun": Sun((1, 0, 1), 1.0, 10.0)}
    best = np.array(spheres.packing.path_trace(VIEW, size, samples=2048, **kwargs)["radiance"])
    accessor = PackingAccessor(spheres)
    noisy = accessor.path_trace(VIEW, size, samples=4, seed=1, **kwargs)
    image = accessor.path_trace(VIEW, size, samples=4, seed=1, denoise=True, **kwargs)
    assert image.field_data["traced_samples"][0] == 0
    assert (image["radiance"] == noisy["radiance"]).all()
    before, after = (np.mean((a - best) ** 2) for a in (image["radiance"], image["denoised"]))
    assert after < 0.75 * before
    light = np.clip(image["denoised"].astype(float), 0, 1)
    encoded = np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)
    assert np.abs(image["color"][:, :3] - 255 * encoded).max() <= 0.51
    # What was handed out before has its own colours.
    assert (noisy["color"] != image["color"]).any()


def moving(camera):
    """A function to be asked whether to stop, which moves the camera instead."""

    def stop():
        camera.azimuth += 30
        return False

    return stop


def test_a_camera_that_is_moved_meanwhile(spheres):
    camera = pv.Camera()
    camera.position, camera.focal_point, camera.up = VIEW
    expected = PackingAccessor(spheres).path_trace(VIEW, SIZE, samples=4)
    image = PackingAccessor(spheres).path_trace(
        camera, SIZE, samples=4, tile=8, stop=moving(camera)
    )
    assert np.linalg.norm(np.subtract(camera.position, VIEW[0])) > 0.1
    assert np.allclose(image.field_data["camera"], VIEW)
    assert (image["radiance"] == expected["radiance"]).all()


def test_another_thread_stops_a_trace(spheres):
    accessor = PackingAccessor(spheres)
    stop = threading.Event()
    timer = threading.Timer(0.3, stop.set)
    timer.start()
    start = time.perf_counter()
    image = accessor.path_trace(VIEW, SIZE, samples=10_000_000, stop=stop.is_set)
    timer.join()
    assert time.perf_counter() - start < 5
    assert 1 <= image["samples"].min() < 10_000_000
    # It goes on from there, and what is finished is that of one go.
    most = int(image["samples"].max())
    again = accessor.path_trace(VIEW, SIZE, samples=most)
    assert again.field_data["traced_samples"][0] < most * image.n_points
    whole = PackingAccessor(spheres).path_trace(VIEW, SIZE, samples=most)
    assert (again["radiance"] == whole["radiance"]).all()


def test_a_trace_that_is_to_stop_at_once(spheres):
    image = PackingAccessor(spheres).path_trace(
        VIEW, SIZE, samples=10_000_000, tile=4, stop=lambda: True
    )
    assert image.n_points == SIZE[0] * SIZE[1]
    # The tiles that are at work are finished, which are all where there are many cores.
    assert 0 < image["samples"].max() <= 8
    assert (image["color"][image["samples"] == 0] == 0).all()


def test_what_stop_raises_is_raised(spheres):
    accessor = PackingAccessor(spheres)

    def stop():
        raise ZeroDivisionError("of stop")

    with pytest.raises(ZeroDivisionError, match="of stop"):
        accessor.path_trace(VIEW, SIZE, samples=100, stop=stop)
    with pytest.raises(TypeError, match="stop: found a bool, expected a function"):
        accessor.path_trace(VIEW, SIZE, stop=True)
    assert accessor.path_trace(VIEW, SIZE, samples=2)["samples"].min() == 2
