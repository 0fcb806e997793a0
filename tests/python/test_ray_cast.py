"""``packing.ray_cast`` and ``packing.pick``: what they show, refuse and keep."""

import os
import signal
import threading

import numpy as np
import pytest
import pyvista as pv
import spherepacking
from spherepacking.accessor import PackingAccessor

VIEW = [(3, 3, 3), (0, 0, 0), (0, 0, 1)]
SIZE = (60, 40)


@pytest.fixture
def spheres():
    return spherepacking.apollonian(3)


def colors(accessor, **kwargs):
    return np.array(accessor.ray_cast(VIEW, SIZE, scalars="radius", **kwargs)["color"])


def test_arrays(spheres):
    image = PackingAccessor(spheres).ray_cast(VIEW, SIZE, random_colors=True)
    assert image.dimensions == (*SIZE, 1)
    found = {name: (image[name].dtype, image[name].shape) for name in image.point_data}
    count = SIZE[0] * SIZE[1]
    assert found == {
        "color": (np.uint8, (count, 4)),
        "depth": (np.float32, (count,)),
        "normal": (np.float32, (count, 3)),
        "sphere_id": (np.int64, (count,)),
    }
    hit = image["sphere_id"] >= 0
    assert 0.1 < hit.mean() < 0.9
    assert (np.isfinite(image["depth"]) == hit).all()


def test_pick_agrees_with_the_picture(spheres):
    accessor = PackingAccessor(spheres)
    ids = np.array(accessor.ray_cast(VIEW, SIZE)["sphere_id"]).reshape(SIZE[::-1])
    for x, y in ((30, 20), (25, 15), (0, 0), (36, 22)):
        found = accessor.pick(VIEW, SIZE, x + 0.5, y + 0.5)
        assert (found.sphere_id if found else -1) == ids[y, x]
        if found:
            center, radius = spheres.points[found.sphere_id], spheres["radius"][found.sphere_id]
            np.testing.assert_allclose(found.point, center + radius * found.normal, atol=1e-12)
            assert np.linalg.norm(found.normal) == pytest.approx(1, abs=1e-14)
            assert found.normal @ np.ones(3) > 0
    assert accessor.pick(VIEW, SIZE, 0, 0) is None


def test_what_changes_is_seen(spheres):
    accessor = PackingAccessor(spheres)
    first = colors(accessor)
    assert (colors(accessor) == first).all()
    for kwargs in (
        {"cmap": "magma"},
        {"clim": (0.2, 0.3)},
        {"log_scale": True},
        {"cmap": ["red", "blue"]},
    ):
        changed = colors(accessor, **kwargs)
        assert (changed != first).any()
        # As if nothing had been kept.
        assert (changed == colors(PackingAccessor(spheres), **kwargs)).all()
        assert (colors(accessor) == first).all()
    table = pv.LookupTable("magma")
    table.scalar_range = (0.0, 1.0)
    before = colors(accessor, cmap=table)
    table.scalar_range = (0.0, 0.1)
    assert (colors(accessor, cmap=table) != before).any()


def test_changed_arrays_are_seen(spheres):
    spheres["weight"] = np.arange(spheres.n_points, dtype=float)
    accessor = PackingAccessor(spheres)

    def cast():
        image = accessor.ray_cast(VIEW, SIZE, scalars="weight")
        return np.array(image["color"]), np.array(image["sphere_id"])

    color, ids = cast()
    spheres["weight"][:] = spheres["weight"][::-1].copy()
    assert (cast()[0] != color).any()
    spheres["weight"] = np.arange(spheres.n_points, dtype=float)
    assert (cast()[0] == color).all()
    spheres["radius"][:5] *= 0.5
    assert (cast()[1] != ids).any()
    spheres.points += [0.3, 0.0, 0.0]
    assert (cast()[1] != ids).any()
    spheres["radius"][0] = -1.0
    with pytest.raises(ValueError, match="holds -1 at point 0"):
        cast()
    spheres["radius"][0] = 0.5
    assert (cast()[1] >= 0).any()


def test_scalars_by_value_are_seen_each_time(spheres):
    accessor = PackingAccessor(spheres)
    values = np.arange(spheres.n_points, dtype=float)
    first = np.array(accessor.ray_cast(VIEW, SIZE, scalars=values)["color"])
    values[:] = values[::-1].copy()
    assert (np.array(accessor.ray_cast(VIEW, SIZE, scalars=values)["color"]) != first).any()


def test_a_picture_is_its_owners(spheres):
    accessor = PackingAccessor(spheres)
    image = accessor.ray_cast(VIEW, SIZE)
    first = np.array(image["color"])
    image["color"][:] = 7
    assert (np.array(accessor.ray_cast(VIEW, SIZE)["color"]) == first).all()


def test_an_empty_packing(spheres):
    image = PackingAccessor(pv.PolyData()).ray_cast(VIEW, SIZE)
    assert (image["sphere_id"] == -1).all()
    assert PackingAccessor(pv.PolyData()).pick(VIEW, SIZE, 1, 1) is None


@pytest.mark.parametrize(
    ("kwargs", "error", "found"),
    [
        ({"structure": "tree"}, ValueError, "structure: found 'tree', expected one of none, grid"),
        ({"cuts": -1, "structure": "grid"}, ValueError, "cuts: found -1"),
        ({"cuts": 99999, "structure": "grid"}, ValueError, "cuts: found 99999, which makes more"),
        ({"window_size": (0, 5)}, ValueError, "window_size: found"),
        ({"window_size": 5}, (TypeError, ValueError), "window_size: found"),
        (
            {"camera": [(0, 0, 0)] * 3},
            ValueError,
            "camera: found the position .* at the focal point",
        ),
        ({"camera": "front"}, TypeError, "camera: found a str"),
        ({"samples": 0}, ValueError, "samples: found 0"),
        ({"samples": 17}, ValueError, "samples: found 17"),
        ({"tile": 0}, ValueError, "tile: found"),
        ({"scalars": "mass"}, KeyError, "mass"),
        ({"clim": (1, 0)}, ValueError, "clim: found"),
        ({"color": "no colour"}, ValueError, "color: found"),
        ({"camera": [(3, 3, 3), (0, 0, 0), (0, 0, 0)]}, ValueError, "camera: found the view-up"),
        ({"log_scale": "x"}, TypeError, "log_scale: found 'x', expected True or False"),
        ({"random_colors": 1}, TypeError, "random_colors: found 1, expected True or False"),
    ],
)
def test_refusals(spheres, kwargs, error, found):
    kwargs = {"camera": VIEW, "window_size": SIZE} | kwargs
    accessor = PackingAccessor(spheres)
    with pytest.raises(error, match=found.replace("(", r"\(")):
        accessor.ray_cast(**kwargs)
    # And works after that.
    assert (accessor.ray_cast(VIEW, SIZE)["sphere_id"] >= 0).any()


def test_no_radii(spheres):
    bare = pv.PolyData(np.array(spheres.points))
    for mesh in (bare, spheres):
        accessor = PackingAccessor(mesh)
        mesh.point_data.pop("radius", None)
        for _ in range(2):
            with pytest.raises(KeyError, match="radius"):
                accessor.ray_cast(VIEW, SIZE)
            with pytest.raises(KeyError, match="radius"):
                accessor.pick(VIEW, SIZE, 1, 1)


@pytest.mark.parametrize(("x", "y"), [(-1, 5), (5, 41), (np.nan, 5)])
def test_pick_outside_of_the_picture(spheres, x, y):
    with pytest.raises(ValueError, match=r"[xy]: found"):
        PackingAccessor(spheres).pick(VIEW, SIZE, x, y)


def test_cameras_of_pyvista(spheres):
    accessor = PackingAccessor(spheres)
    expected = np.array(accessor.ray_cast(VIEW, SIZE)["sphere_id"])
    camera = pv.Camera()
    camera.position, camera.focal_point, camera.up = VIEW
    position = pv.CameraPosition(*VIEW)
    for view in (camera, position, np.array(VIEW)):
        assert (accessor.ray_cast(view, SIZE)["sphere_id"] == expected).all()
        assert accessor.pick(view, SIZE, 30.5, 20.5).sphere_id == expected.reshape(40, 60)[20, 30]


def test_after_ctrl_c_pictures_are_whole(spheres):
    accessor = PackingAccessor(spherepacking.apollonian(5))
    size = (1000, 1000)
    expected = np.array(accessor.ray_cast(VIEW, size)["sphere_id"])
    timer = threading.Timer(0.1, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        accessor.ray_cast(VIEW, size, structure="none")
    timer.join()
    for _ in range(2):
        assert (accessor.ray_cast(VIEW, size)["sphere_id"] == expected).all()


def test_threads_take_turns(spheres):
    accessor = PackingAccessor(spheres)
    sizes = (80, 200, 300)
    expected = {n: np.array(accessor.ray_cast(VIEW, (n, n))["sphere_id"]) for n in sizes}
    wrong = []

    def work(n):
        for _ in range(10):
            image = accessor.ray_cast(VIEW, (n, n), tile=16)
            if image.dimensions != (n, n, 1) or (image["sphere_id"] != expected[n]).any():
                wrong.append(n)

    threads = [threading.Thread(target=work, args=(n,)) for n in sizes]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong


ONE = (300, 300)
SCALARS = {
    "small integers": lambda x: (2 * x).astype(np.uint8),
    "integers": lambda x: (2 * x).astype(np.int16),
    "truth values": lambda x: x % 2 == 1,
    "vectors": lambda x: np.column_stack([0.0 * x, x, 0.0 * x]),
    "texts": lambda x: np.where(x % 2 == 1, "a", "b"),
    "all NaN": lambda x: np.full(x.shape, np.nan),
    "float_rgb": lambda x: np.tile([0.0, 1.0, 0.3], (x.size, 1)),
    "byte_rgb": lambda x: np.column_stack([2 * x, 0 * x, 255 - 2 * x]).astype(np.uint8),
    "float_rgba": lambda x: np.column_stack([x / x.size, 0 * x, 0 * x, 0 * x + 1.0]),
}


@pytest.mark.parametrize("by_value", [False, True])
@pytest.mark.parametrize("name", SCALARS)
def test_colors_are_those_of_the_plotter(spheres, name, by_value):
    values = SCALARS[name](np.arange(spheres.n_points))
    kwargs = {"rgb": name.endswith(("_rgb", "_rgba")), "scalars": values if by_value else name}
    spheres[name] = values
    # The light of a ray cast comes from the camera, and is 1 where the surface faces it.
    image = PackingAccessor(spheres).ray_cast(VIEW, ONE, cmap=["blue", "lime", "red"], **kwargs)
    towards = np.ones(3) / np.sqrt(3)
    facing = image["normal"] @ towards > 0.985
    plotter = pv.Plotter(off_screen=True, window_size=ONE, lighting="none")
    plotter.render_window.SetMultiSamples(0)
    plotter.packing.add(
        spheres, cmap=["blue", "lime", "red"], lighting=False, show_scalar_bar=False, **kwargs
    )
    plotter.camera_position = VIEW
    drawn = plotter.screenshot(return_img=True)[::-1].reshape(-1, 3)
    plotter.close()
    assert facing.sum() > 100
    # Pixels where the two see different spheres are rarer than one in a hundred.
    error = np.abs(image["color"][facing, :3].astype(float) - drawn[facing]).max(axis=1)
    assert np.quantile(error, 0.99) <= 255 * 0.015 + 1


def test_lengths_that_depths_do_not_hold(spheres):
    spheres.points *= 1e35
    spheres["radius"] = 1e35 * spheres["radius"]
    for cast in (
        lambda: spheres.packing.ray_cast(VIEW, SIZE),
        lambda: spheres.packing.pick(VIEW, SIZE, 1, 1),
    ):
        with pytest.raises(ValueError, match="packing: found spheres over a length of"):
            cast()
