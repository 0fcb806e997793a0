"""What a VTK user expects of a mapper: colours, lights, opacity, picking, bounds, transforms."""

import importlib
import subprocess
import sys

import numpy as np
import pytest
import pyvista as pv
from scenes import Camera, draw_and_cast, make_packing, show
from spherepacking.backend import VTK_ROOT, vtkOpenGLSpherePackingMapper
from spherepacking.testing import accuracy

ROW = np.array([[-2.5, 0.0, 0.0], [0.0, 0.0, 0.0], [2.5, 0.0, 0.0]])
FRONT = Camera((0, 0, 20), up=(0, 1, 0), parallel_scale=4.0)
SIZE = (400, 400)
COLUMNS = [75, 200, 325]  # the middles of the spheres of ROW in this view


def vtk_module(name):
    """Return a module of the VTK that PyVista runs on."""
    return importlib.import_module(f"{VTK_ROOT}.{name}")


def at_middles(picture):
    return picture[200, COLUMNS, :3].astype(int)


# --- radii and bounds -----------------------------------------------------------------------------


@pytest.mark.parametrize(
    "dtype", [np.float32, np.float64, np.int8, np.uint8, np.int16, np.int32, np.int64, np.uint64]
)
def test_radii_of_type(dtype):
    radii = np.array([1, 2, 3], dtype=dtype)
    centers = ROW * 3
    drawn, expected = draw_and_cast(centers, radii, Camera((0, 5, 30)))
    assert accuracy.compare(drawn, expected).good


def test_radius_array_by_another_name():
    packing = make_packing(ROW, [0.1, 0.1, 0.1])
    packing.point_data["size"] = [1.0, 1.0, 1.0]
    with show(packing, FRONT, SIZE, radius="size") as (plotter, _):
        assert (accuracy.read(plotter).sphere_id >= 0).mean() > 0.1


def test_zero_radius_draws_nothing():
    drawn, expected = draw_and_cast(ROW, [1.0, 0.0, 0.0], FRONT, SIZE)
    assert set(np.unique(drawn.sphere_id)) == {-1, 0}
    assert np.array_equal(drawn.sphere_id, expected.sphere_id)


def test_bounds_include_the_radii(rng):
    centers = rng.uniform(-1, 1, (1000, 3))
    radii = rng.uniform(0, 1, 1000)
    mapper = vtkOpenGLSpherePackingMapper()
    mapper.SetInputDataObject(make_packing(centers, radii))
    bounds = np.array(mapper.GetBounds())
    low = (centers - radii[:, None]).min(axis=0)
    high = (centers + radii[:, None]).max(axis=0)
    np.testing.assert_array_equal(bounds, np.stack([low, high], axis=1).ravel())


def test_bounds_follow_the_radii():
    packing = make_packing([[0.0, 0.0, 0.0]], [1.0])
    mapper = vtkOpenGLSpherePackingMapper()
    mapper.SetInputDataObject(packing)
    assert mapper.GetBounds()[1] == 1.0
    packing.point_data["radius"][0] = 2.0
    packing.Modified()
    assert mapper.GetBounds()[1] == 2.0


def test_no_points():
    empty = pv.PolyData()
    mapper = vtkOpenGLSpherePackingMapper()
    mapper.SetInputDataObject(empty)
    assert mapper.GetErrorMessage() == ""
    with show(empty, FRONT, (50, 50), color="red") as (plotter, _):
        assert plotter.screenshot(return_img=True).max() == 0


# --- bad input ------------------------------------------------------------------------------------


def with_radii(values, name="radius"):
    packing = make_packing(ROW, [1.0, 1.0, 1.0])
    packing.point_data.clear()
    array = pv.convert_array(np.asarray(values, dtype=float), name=name)
    packing.GetPointData().AddArray(array)
    return packing


def named_strings():
    packing = make_packing(ROW, [1.0, 1.0, 1.0])
    packing.point_data.clear()
    strings = pv._vtk.vtkStringArray()
    strings.SetName("radius")
    for text in "abc":
        strings.InsertNextValue(text)
    packing.GetPointData().AddArray(strings)
    return packing


@pytest.mark.parametrize(
    ("packing", "words"),
    [
        (with_radii([1, 1, 1], name="size"), ["no point array 'radius'"]),
        (with_radii([1, 1]), ["'radius'", "2 values", "3 points"]),
        (with_radii([[1, 1]] * 3), ["'radius'", "2 components", "expected 1"]),
        (with_radii([1, -2, 1]), ["'radius'", "-2", "point 1", "not negative"]),
        (with_radii([1, 1, np.nan]), ["'radius'", "nan", "point 2", "finite"]),
        (with_radii([np.inf, 1, 1]), ["'radius'", "inf", "point 0"]),
        (named_strings(), ["'radius'", "vtkStringArray", "numeric"]),
        (make_packing([[0, 0, 0], [0, np.nan, 0.0]], [1, 1]), ["centre of point 1", "nan"]),
    ],
    ids=["missing", "short", "pairs", "negative", "nan", "inf", "strings", "nan centre"],
)
def test_bad_input_is_one_error_and_draws_nothing(packing, words):
    mapper = vtkOpenGLSpherePackingMapper()
    errors = []
    mapper.AddObserver("ErrorEvent", lambda *_: errors.append(mapper.GetErrorMessage()))
    mapper.SetInputDataObject(packing)
    actor = pv._vtk.vtkActor()
    actor.SetMapper(mapper)
    plotter = pv.Plotter(off_screen=True, window_size=(50, 50))
    plotter.set_background("black")
    plotter.renderer.AddActor(actor)
    plotter.show(auto_close=False, interactive=False)
    for _ in range(3):
        plotter.render()
    picture = plotter.screenshot(return_img=True)
    plotter.close()
    mapper.RemoveAllObservers()
    assert picture.max() == 0
    assert len(errors) == 1
    for word in words:
        assert word in errors[0]


TOO_LITTLE_MEMORY = """
import resource
import numpy as np, pyvista as pv, spherepacking
packing = pv.PolyData(np.random.default_rng(0).random((1_000_000, 3), np.float32))
packing["radius"] = np.full(packing.n_points, 0.01, np.float32)
plotter = pv.Plotter(off_screen=True, window_size=(50, 50))
plotter.set_background("black")
plotter.show(auto_close=False, interactive=False)
mapper = plotter.packing.add(packing, color="white", lighting=False, render=False).mapper
mapper.AddObserver("ErrorEvent", lambda *_: print(mapper.GetErrorMessage()))
used = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (used + 2**23, -1))
plotter.render()
plotter.render()
resource.setrlimit(resource.RLIMIT_AS, (-1, -1))
plotter.render()
print(plotter.screenshot(return_img=True).max(), repr(mapper.GetErrorMessage()))
mapper.RemoveAllObservers()
"""


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="limits memory as Linux does")
def test_too_little_memory_is_one_error():
    done = subprocess.run(
        [sys.executable, "-c", TOO_LITTLE_MEMORY], capture_output=True, text=True, check=True
    )
    assert done.stdout == "the spheres do not fit in the memory that is free\n255 ''\n"


def test_stretching_matrix_is_an_error():
    packing = make_packing(ROW, [1.0, 1.0, 1.0])
    with show(packing, FRONT, (50, 50), color="white") as (plotter, actor):
        errors = []
        actor.mapper.AddObserver("ErrorEvent", lambda *_: errors.append(1))
        actor.scale = (1.0, 2.0, 1.0)
        plotter.render()
        plotter.render()
        assert plotter.screenshot(return_img=True).max() == 0
        message = actor.mapper.GetErrorMessage()
        actor.mapper.RemoveAllObservers()
    assert len(errors) == 1
    assert "uniform scale" in message


def test_camera_in_its_focal_point_is_an_error():
    with show(make_packing(ROW, [1.0, 1.0, 1.0]), FRONT, (50, 50), color="white") as (
        plotter,
        actor,
    ):
        errors = []
        actor.mapper.AddObserver("ErrorEvent", lambda *_: errors.append(1))
        plotter.camera.focal_point = plotter.camera.position
        plotter.render()
        message = actor.mapper.GetErrorMessage()
        actor.mapper.RemoveAllObservers()
    assert len(errors) == 1
    assert "camera" in message
    assert "focal point" in message


def test_rotation_translation_and_scale_of_the_actor():
    matrix = pv.Transform().rotate_z(30).rotate_x(-50).scale(1.7).translate((0.3, -0.2, 0.4)).matrix
    radii = np.array([1.0, 0.5, 1.2])
    moved = ROW @ matrix[:3, :3].T + matrix[:3, 3]
    drawn, _ = draw_and_cast(ROW, radii, Camera((0, 1, 12)), user_matrix=matrix)
    straight, expected = draw_and_cast(moved, 1.7 * radii, Camera((0, 1, 12)))
    errors = accuracy.compare(straight, expected)
    assert errors.good, errors
    assert np.mean(drawn.sphere_id != straight.sphere_id) < 1e-4


# --- colours and lights ---------------------------------------------------------------------------


def test_scalars_through_a_color_map():
    packing = make_packing(ROW, [1.0, 1.0, 1.0])
    packing.point_data["height"] = [0.0, 0.5, 1.0]
    with show(packing, FRONT, SIZE, scalars="height", cmap="viridis") as (plotter, _):
        seen = at_middles(plotter.screenshot(return_img=True))
    expected = [
        pv.LookupTable("viridis", scalar_range=(0, 1)).map_value(v)[:3] for v in (0.0, 0.5, 1.0)
    ]
    np.testing.assert_allclose(seen, np.array(expected) * 255, atol=1)


@pytest.mark.parametrize("components", [3, 4])
def test_direct_colors(components):
    packing = make_packing(ROW, [1.0, 1.0, 1.0])
    colors = np.array([[255, 0, 10, 255], [0, 200, 30, 255], [7, 8, 250, 255]], dtype=np.uint8)
    with show(packing, FRONT, SIZE, scalars=colors[:, :components], rgb=True) as (plotter, _):
        seen = at_middles(plotter.screenshot(return_img=True))
    np.testing.assert_array_equal(seen, colors[:, :3])


def test_colors_change_without_a_new_actor():
    packing = make_packing(ROW, [1.0, 1.0, 1.0])
    packing.point_data["height"] = [0.0, 0.5, 1.0]
    with show(packing, FRONT, SIZE, scalars="height", cmap="gray") as (plotter, _):
        before = at_middles(plotter.screenshot(return_img=True))
        packing["height"] = [1.0, 0.5, 0.0]
        plotter.render()
        after = at_middles(plotter.screenshot(return_img=True))
    np.testing.assert_array_equal(before, after[::-1])


def normals(picture_size):
    """Return view normals of a unit sphere in a parallel view 2.5 wide, and its mask."""
    x = ((np.arange(picture_size) + 0.5) / picture_size - 0.5) * 2.5
    xx, yy = np.meshgrid(x, x)
    z2 = 1.0 - xx**2 - yy**2
    return np.stack([xx, yy, np.sqrt(np.maximum(z2, 0))], axis=-1), z2 > 0


def lit(lights, samples=0, **kwargs):
    """Draw a white unit sphere under lights in a parallel view 2.5 wide, rows from the bottom."""
    plotter = pv.Plotter(off_screen=True, window_size=(200, 200), lighting="none")
    plotter.render_window.SetMultiSamples(samples)
    plotter.set_background("black")
    for light in lights:
        plotter.add_light(light)
    packing = make_packing([[0.0, 0.0, 0.0]], [1.0])
    kwargs = {"ambient": 0.0, "diffuse": 1.0} | kwargs
    plotter.packing.add(packing, color="white", show_scalar_bar=False, **kwargs)
    plotter.camera_position = [(0, 0, 10), (0, 0, 0), (0, 1, 0)]
    plotter.enable_parallel_projection()
    plotter.camera.parallel_scale = 1.25
    picture = plotter.screenshot(return_img=True)[::-1, :, 0] / 255.0
    plotter.close()
    return picture


def scene_light(position):
    return pv.Light(position=position, focal_point=(0, 0, 0), light_type="scene light")


@pytest.mark.parametrize("samples", [0, 8])
def test_headlight(samples):
    picture = lit([pv.Light(light_type="headlight")], samples)
    n, mask = normals(200)
    np.testing.assert_allclose(picture[mask], n[mask][:, 2], atol=1.5 / 255)


def test_two_directional_lights():
    lights = [scene_light((1, 2, 3)), scene_light((-3, 0, 1))]
    lights[1].intensity = 0.5
    picture = lit(lights, specular=0.0)
    n, mask = normals(200)
    expected = 0.0
    for light, intensity in zip(lights, (1.0, 0.5), strict=True):
        direction = np.array(light.position) / np.linalg.norm(light.position)
        expected = expected + intensity * np.maximum(n[mask] @ direction, 0.0)
    np.testing.assert_allclose(picture[mask], np.minimum(expected, 1.0), atol=1.5 / 255)


def test_positional_light_with_attenuation():
    light = scene_light((0, 3, 2))
    light.positional = True
    light.cone_angle = 90
    light.attenuation_values = (0.5, 0.1, 0.05)
    picture = lit([light])
    n, mask = normals(200)
    away = np.array([0, 3, 2]) - n[mask]
    distance = np.linalg.norm(away, axis=1)
    facing = np.maximum(np.sum(away * n[mask], axis=1) / distance, 0)
    expected = facing / (0.5 + 0.1 * distance + 0.05 * distance**2)
    np.testing.assert_allclose(picture[mask], np.minimum(expected, 1.0), atol=2 / 255)


def test_specular_highlight_is_where_the_light_reflects():
    plain = lit([scene_light((1, 0, 1))], diffuse=0.1)
    # Another light: PyVista before 0.49 asks a used one for what its closed plotter had.
    shiny = lit([scene_light((1, 0, 1))], diffuse=0.1, specular=0.8, specular_power=50)
    brightest = np.unravel_index(np.argmax(shiny - plain), plain.shape)
    n, _ = normals(200)
    half = np.array([np.sin(np.pi / 8), 0, np.cos(np.pi / 8)])
    assert n[brightest] @ half > 0.99


# --- opacity --------------------------------------------------------------------------------------


def blended(opacity, **kwargs):
    packing = make_packing([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]], [0.5, 0.8])
    colors = np.array([[255, 0, 0], [0, 0, 255]], dtype=np.uint8)
    with show(packing, FRONT, (200, 200), scalars=colors, rgb=True, opacity=opacity, **kwargs) as (
        plotter,
        actor,
    ):
        # VTK peels nothing from a window with several samples per pixel, meshes included:
        # https://github.com/pyvista/pyvista/issues/8273
        plotter.render_window.SetMultiSamples(0)
        plotter.enable_depth_peeling(8)
        plotter.render()
        picture = plotter.screenshot(return_img=True)
        actor.prop.culling = "back"
        plotter.render()
        culled = plotter.screenshot(return_img=True)
    return picture[100, 100].astype(int), culled[100, 100].astype(int)


def test_opacity_blends_all_surfaces_in_order():
    seen, culled = blended(0.5)
    red, blue = np.array([255, 0, 0]), np.array([0, 0, 255])
    # Front to back: red near, red far side, blue near, blue far side, half of what is left each.
    expected = 0.5 * red + 0.25 * red + 0.125 * blue + 0.0625 * blue
    np.testing.assert_allclose(seen, expected, atol=2)
    np.testing.assert_allclose(culled, 0.5 * red + 0.25 * blue, atol=2)


def test_transparent_background():
    packing = make_packing([[0.0, 0.0, 0.0]], [1.0])
    with show(packing, FRONT, (200, 200), color="white") as (plotter, _):
        picture = plotter.screenshot(None, return_img=True, transparent_background=True)
    assert picture.shape[2] == 4
    assert picture[100, 100, 3] == 255
    assert picture[0, 0, 3] == 0


# --- picking --------------------------------------------------------------------------------------


def selected_ids(selector, x, y):
    """Return the ids that a selector captured at a pixel."""
    selection = selector.GenerateSelection(x, y, x, y)
    if selection.GetReferenceCount() > 1:
        # Upstream: VTK 9.7: GenerateSelection() returns a reference that its caller owns, but has
        # no VTK_NEWINSTANCE by which Python would know. See also
        # https://github.com/pyvista/pyvista/pull/1394
        selection.UnRegister(None)
    if not selection.GetNumberOfNodes():
        return []
    return list(pv.convert_array(selection.GetNode(0).GetSelectionList()))


@pytest.mark.parametrize("association", ["points", "cells"])
def test_hardware_selection_returns_the_point_id(rng, association):
    centers = rng.uniform(-1, 1, (2000, 3))
    radii = rng.uniform(0.02, 0.2, 2000)
    packing = make_packing(centers, radii)
    size = (150, 150)
    with show(packing, Camera(), size) as (plotter, _):
        seen = accuracy.read(plotter).sphere_id
        selector = vtk_module("vtkRenderingCore").vtkHardwareSelector()
        selector.SetRenderer(plotter.renderer)
        selector.SetFieldAssociation(
            pv._vtk.vtkDataObject.FIELD_ASSOCIATION_POINTS
            if association == "points"
            else pv._vtk.vtkDataObject.FIELD_ASSOCIATION_CELLS
        )
        selector.SetArea(0, 0, size[0] - 1, size[1] - 1)
        selector.CaptureBuffers()
        picked = np.full(seen.shape, -1)
        for y in range(0, size[1], 5):
            for x in range(0, size[0], 5):
                ids = selected_ids(selector, x, y)
                assert len(ids) <= 1
                picked[y, x] = ids[0] if ids else -1
        selector.ClearBuffers()
        again = accuracy.read(plotter).sphere_id
    sample = np.s_[::5, ::5]
    assert (seen[sample] >= 0).mean() > 0.2
    assert np.array_equal(picked[sample], seen[sample])
    assert np.array_equal(seen, again)


# --- scenes with other actors, and changes --------------------------------------------------------


def test_spheres_and_meshes_hide_each_other():
    packing = make_packing([[0.0, 0.0, 0.0]], [1.0])
    with show(packing, FRONT, (200, 200), color="white") as (plotter, _):
        plotter.add_mesh(
            pv.Plane(center=(0, 0, 0.6), i_size=6, j_size=6), color="red", lighting=False
        )
        plotter.render()
        picture = plotter.screenshot(return_img=True).astype(int)
    white = picture[..., 1] > 128
    # The plane leaves the cap above it: a disc of radius 0.8, at 25 pixels a unit.
    assert white.sum() == pytest.approx(np.pi * (0.8 * 25) ** 2, rel=0.02)


def test_moving_the_points_moves_the_spheres():
    packing = make_packing(ROW[1:2], [1.0])
    with show(packing, FRONT, (200, 200), color="white") as (plotter, _):
        before = plotter.screenshot(return_img=True)
        packing.points[0] = (2.0, 0.0, 0.0)
        packing.GetPoints().Modified()
        plotter.render()
        after = plotter.screenshot(return_img=True)
    np.testing.assert_array_equal(np.roll(before, 50, axis=1), after)


@pytest.mark.parametrize("samples", [0, 8])
def test_two_renderers_side_by_side(samples):
    packing = make_packing([[0.0, 0.0, 0.0], [1.4, 0.0, 0.0]], [1.0, 0.01])  # quad and point
    plotter = pv.Plotter(off_screen=True, window_size=(200, 100), shape=(1, 2), border=False)
    plotter.render_window.SetMultiSamples(samples)
    for column in range(2):
        plotter.subplot(0, column)
        plotter.set_background("black")
        plotter.packing.add(packing, color="white", lighting=False, show_scalar_bar=False)
        FRONT.apply(plotter)
    picture = plotter.screenshot(return_img=True)
    plotter.close()
    assert picture.max() == 255
    np.testing.assert_array_equal(picture[:, :100], picture[:, 100:])


@pytest.mark.parametrize("count", [100, 20_001])
def test_one_actor_in_two_windows(rng, count):
    packing = make_packing(rng.random((count, 3)), np.full(count, 0.02))
    camera = Camera((2, 2, 2), (0.5, 0.5, 0.5))
    with show(packing, camera, (200, 200), color="red") as (first, actor):
        before = first.screenshot(return_img=True)
        second = pv.Plotter(off_screen=True, window_size=(200, 200))
        second.set_background("black")
        second.add_actor(actor)
        camera.apply(second)
        second.show(auto_close=False, interactive=False)
        camera.apply(second)
        second.render()
        there = second.screenshot(return_img=True)
        first.render()
        after = first.screenshot(return_img=True)
        second.close()
        actor.prop.color = "lime"
        first.render()
        alone = first.screenshot(return_img=True)
    assert before.max() == 255
    np.testing.assert_array_equal(before, there)
    np.testing.assert_array_equal(before, after)
    np.testing.assert_array_equal(before[..., [1, 0, 2]], alone)


def test_message_goes_when_the_cause_is_gone():
    packing = make_packing(ROW, [1.0, 1.0, 1.0])
    with show(packing, FRONT, (50, 50), color="white") as (plotter, actor):
        actor.mapper.AddObserver("ErrorEvent", lambda *_: None)
        actor.scale = (1.0, 2.0, 1.0)
        plotter.render()
        assert actor.mapper.GetErrorMessage() != ""
        actor.scale = (1.0, 1.0, 1.0)
        plotter.render()
        assert actor.mapper.GetErrorMessage() == ""
        actor.mapper.RemoveAllObservers()


def test_window_size_changes():
    packing = make_packing([[0.0, 0.0, 0.0]], [1.0])
    with show(packing, FRONT, (100, 100), color="white") as (plotter, _):
        small = (plotter.screenshot(return_img=True) > 0).mean()
        plotter.window_size = (300, 300)
        plotter.render()
        large = (plotter.screenshot(return_img=True) > 0).mean()
    assert large == pytest.approx(small, rel=0.05)
