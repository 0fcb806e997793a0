"""``plotter.packing.path_trace``: the traced picture among what else is in the scene."""

import subprocess
import sys
import time

import numpy as np
import pytest
import pyvista as pv
import spherepacking
from spherepacking.accessor import PackingAccessor
from spherepacking.backend import vtkSpherePackingPicturePass
from spherepacking.trace.path_trace import PathTracer

SIZE = (160, 120)
OPTIONS = {"samples": 4, "sky": (0.3, 0.9), "sun": (1, 0, 1)}


@pytest.fixture
def scene():
    """Return a plotter without anything in it, seen from (3, 3, 3)."""
    plotter = pv.Plotter(off_screen=True, window_size=SIZE)
    plotter.render_window.SetMultiSamples(0)
    plotter.set_background("black")
    plotter.camera_position = [(3, 3, 3), (0, 0, 0), (0, 0, 1)]
    yield plotter
    plotter.close()


@pytest.fixture
def spheres():
    return spherepacking.apollonian(3)


def drawn(plotter):
    """Render and return what the window holds, from the lower left corner."""
    plotter.render_window.Render()
    reader = pv._vtk.vtkWindowToImageFilter()
    reader.SetInput(plotter.render_window)
    reader.ReadFrontBufferOff()
    reader.ShouldRerenderOff()
    reader.Update()
    return np.array(pv.wrap(reader.GetOutput())["ImageScalars"], int)


def traced(spheres, plotter, **kwargs):
    image = PackingAccessor(spheres).path_trace(
        plotter.camera, SIZE, sky_visible=False, **(OPTIONS | kwargs)
    )
    return np.array(image["color"], int), np.array(image["depth"])


def assert_shown(found, spheres, plotter, **kwargs):
    """Assert that pixels are those of a picture traced of the plotter's view, on black."""
    color, _ = traced(spheres, plotter, **kwargs)
    assert np.abs(found - color[:, 3:] / 255 * color[:, :3]).max() <= 1


@pytest.mark.parametrize("parallel", [False, True])
def test_the_window_shows_the_picture(scene, spheres, parallel):
    live = scene.packing.path_trace(spheres, reset_camera=False, **OPTIONS)
    if parallel:
        scene.enable_parallel_projection()
        scene.camera.parallel_scale = 1.2
    found = drawn(scene)
    assert live.finished
    assert live.samples == 4
    color, _ = traced(spheres, scene)
    share = color[:, 3:] / 255
    assert (share == 1).sum() > 1000
    assert ((share > 0) & (share < 1)).sum() > 100
    assert np.abs(found - share * color[:, :3]).max() <= 1
    # Another view, another picture.
    scene.camera.azimuth += 30
    found = drawn(scene)
    assert_shown(found, spheres, scene)


@pytest.mark.parametrize("parallel", [False, True])
def test_other_actors_are_before_and_behind(scene, spheres, parallel):
    """A disc through the middle, square to the view, is hidden where spheres are before it."""
    live = scene.packing.path_trace(spheres, reset_camera=False, **OPTIONS)
    disc = pv.Disc(inner=0.0, outer=5.0, normal=(1, 1, 1), c_res=60)
    scene.add_mesh(disc, color=(0, 0, 255), lighting=False, reset_camera=False)
    if parallel:
        scene.enable_parallel_projection()
        scene.camera.parallel_scale = 1.2
    found = drawn(scene)
    color, depth = traced(spheres, scene)
    distance = np.sqrt(27)
    before = (color[:, 3] == 255) & (depth < distance - 0.02)
    # At edges a pixel whose middle misses has the depth of its neighbours.
    behind = (depth > distance + 0.02) & (np.isfinite(depth) | (color[:, 3] == 0))
    assert min(before.sum(), behind.sum()) > 200
    assert np.abs(found - color[:, :3])[before].max() <= 1
    assert (found[behind] == [0, 0, 255]).all()
    assert live.finished


def test_what_is_transparent_comes_after(scene, spheres):
    scene.packing.path_trace(spheres, reset_camera=False, **OPTIONS)
    plane = pv.Plane(center=(1.5, 1.5, 1.5), direction=(1, 1, 1), i_size=9, j_size=9)
    scene.add_mesh(plane, color=(0, 0, 255), opacity=0.5, lighting=False, reset_camera=False)
    found = drawn(scene)
    color, _ = traced(spheres, scene)
    expected = 0.5 * color[:, 3:] / 255 * color[:, :3] + [0, 0, 127.5]
    assert np.abs(found - expected).max() <= 2


def test_the_hierarchy_is_built_once(scene, spheres, monkeypatch):
    """The tracer that checks the arguments makes the pictures, too, on what it has built."""
    tracers, sizes, seconds = set(), [], set()
    trace = PathTracer.trace

    def recorded(self, *args):
        image = trace(self, *args)
        tracers.add(self)
        sizes.append(image.dimensions[:2])
        seconds.add(float(image.field_data["build_seconds"][0]))
        return image

    monkeypatch.setattr(PathTracer, "trace", recorded)
    scene.packing.path_trace(
        spheres, scalars="level", show_scalar_bar=False, reset_camera=False, **OPTIONS
    )
    drawn(scene)
    scene.camera.azimuth += 30
    drawn(scene)
    assert sizes == [(1, 1), SIZE, SIZE]
    assert len(tracers) == 1
    assert len(seconds) == 1, "the time of one build, to the last digit"
    assert seconds.pop() > 0
    # The counter would notice another build.
    spheres["radius"] *= 0.5
    drawn(scene)
    assert len(seconds) == 1
    tracers.clear()


def test_changed_radii_are_seen(scene, spheres):
    scene.packing.path_trace(spheres, reset_camera=False, **OPTIONS)
    first = drawn(scene)
    spheres["radius"][:] *= 0.5
    found = drawn(scene)
    assert (found != first).any()
    assert_shown(found, spheres, scene)


@pytest.mark.parametrize(
    "change",
    [
        lambda plotter: plotter.camera.SetWindowCenter(0.5, 0),
        lambda plotter: plotter.camera.SetViewShear(0.3, 0, 1),
        lambda plotter: plotter.camera.SetUseHorizontalViewAngle(True),
    ],
)
def test_whatever_the_camera_does_is_seen(scene, spheres, change):
    scene.packing.path_trace(spheres, reset_camera=False, **OPTIONS)
    first = drawn(scene)
    change(scene)
    found = drawn(scene)
    assert (found != first).any()
    assert_shown(found, spheres, scene)


@pytest.mark.parametrize(
    "change",
    [
        lambda mesh: mesh["height"].__setitem__(slice(None), 0.0),
        lambda mesh: mesh.__setitem__("height", -np.array(mesh["height"])),
        lambda mesh: np.multiply(mesh["height"], -1, mesh["height"].view(np.ndarray)),
        lambda mesh: np.multiply(mesh.points, 0.9, mesh.points.view(np.ndarray)),
        lambda mesh: mesh.__setitem__("height", np.multiply(mesh["height"], -1, mesh["height"])),
        lambda mesh: mesh.__setitem__("radius", np.multiply(mesh["radius"], 0.5, mesh["radius"])),
    ],
)
def test_changed_arrays_are_seen(scene, spheres, change):
    spheres["height"] = np.array(spheres.points[:, 2])
    kwargs = OPTIONS | {"scalars": "height", "clim": (-1, 1)}
    scene.packing.path_trace(spheres, reset_camera=False, show_scalar_bar=False, **kwargs)
    first = drawn(scene)
    change(spheres)
    found = drawn(scene)
    assert (found != first).any()
    assert_shown(found, spheres.copy(), scene, scalars="height", clim=(-1, 1))


def test_changed_light_and_tables_are_seen(scene, spheres):
    spheres["height"] = np.array(spheres.points[:, 2])
    table = pv.LookupTable("viridis", scalar_range=(-1, 1))
    sky = np.full((4, 8, 3), 0.5, np.float32)
    look = {"scalars": "height", "cmap": table}
    scene.packing.path_trace(
        spheres, reset_camera=False, show_scalar_bar=False, **OPTIONS | look | {"sky": sky}
    )
    first = drawn(scene)
    table.scalar_range = (-0.2, 0.2)
    second = drawn(scene)
    assert (second != first).any()
    sky[:2] = 2.0
    third = drawn(scene)
    assert (third != second).any()
    assert_shown(third, spheres, scene, sky=sky, **look)


def test_larger_screenshots(scene, spheres):
    """VTK makes them of parts."""
    scene.packing.path_trace(spheres, reset_camera=False, **OPTIONS)
    drawn(scene)
    found = scene.screenshot(return_img=True, scale=2)
    assert found.shape == (240, 320, 3)
    image = PackingAccessor(spheres).path_trace(
        scene.camera, (320, 240), sky_visible=False, **(OPTIONS | {"samples": 64})
    )
    color = np.array(image["color"], int).reshape(240, 320, 4)[::-1]
    expected = color[..., 3:] / 255 * color[..., :3]
    assert np.abs(found - expected).mean() < 6


def test_actors_that_go_take_their_picture_along(scene, spheres):
    live = scene.packing.path_trace(spheres, reset_camera=False, **OPTIONS)
    first = drawn(scene)
    live.actor.visibility = False
    assert (drawn(scene) == 0).all()
    live.actor.visibility = True
    assert (drawn(scene) == first).all()
    live.actor.position = (0.5, 0.0, 0.0)
    moved = drawn(scene)
    assert (moved != first).any()
    assert not live.shown
    live.actor.position = (0.0, 0.0, 0.0)
    assert (drawn(scene) == first).all()
    scene.remove_actor(live.actor)
    assert (drawn(scene) == 0).all()
    again = scene.packing.path_trace(spheres, reset_camera=False, **OPTIONS)
    assert (drawn(scene) == first).all()
    scene.clear()
    assert (drawn(scene) == 0).all()
    assert again.abandoned


def test_other_passes_come_and_go(scene, spheres):
    live = scene.packing.path_trace(spheres, reset_camera=False, **OPTIONS)
    first = drawn(scene)
    scene.enable_eye_dome_lighting()
    drawn(scene)
    assert not live.shown
    scene.disable_eye_dome_lighting()
    scene.renderer.SetPass(None)
    assert (drawn(scene) == first).all()
    assert live.finished


def test_a_noise_target_finishes(scene, spheres):
    live = scene.packing.path_trace(
        spheres, reset_camera=False, **(OPTIONS | {"samples": 256, "noise_target": 0.3})
    )
    drawn(scene)
    assert live.finished
    assert live.samples < 256


def test_ctrl_c_is_no_end_of_the_process(spheres):
    """While VTK calls Python it would be."""
    code = """
import os, signal, threading
import pyvista as pv, spherepacking
# Processes in the background of a shell would not hear it.
signal.signal(signal.SIGINT, signal.default_int_handler)
plotter = pv.Plotter(off_screen=True, window_size=(300, 200))
live = plotter.packing.path_trace(spherepacking.apollonian(3), samples=100_000)
threading.Timer(1.0, os.kill, (os.getpid(), signal.SIGINT)).start()
try:
    plotter.render_window.Render()
    for _ in range(100_000_000):
        pass
except KeyboardInterrupt:
    print("caught", live.samples)
finally:
    plotter.close()
    print("closed")
"""
    result = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=False, timeout=120
    )
    assert result.stdout.split()[::2] == ["caught", "closed"], result.stderr
    assert result.returncode == 0


def test_errors_while_tracing_are_told(scene, spheres, tmp_path):
    live = scene.packing.path_trace(
        spheres, scalars="level", reset_camera=False, show_scalar_bar=False, **OPTIONS
    )
    drawn(scene)
    del spheres.point_data["level"]
    with pytest.raises(RuntimeError, match=r"the spheres cannot be traced: .*level"):
        scene.packing.screenshot(tmp_path / "a.png")
    assert isinstance(live.error, KeyError)
    assert not (tmp_path / "a.png").exists()


def test_in_a_window_it_refines_while_the_camera_rests(scene, spheres):
    live = scene.packing.path_trace(spheres, reset_camera=False, step=0.01, **OPTIONS)
    # As if there were someone to look at it, and a timer.
    scene.off_screen = False
    mapper = live.actor.mapper
    drawn(scene)
    assert (live.samples, mapper.GetDrawn()) == (0, True)
    live._tick()
    assert not live.shown, "it has just come to rest"
    time.sleep(0.05)
    live._tick()
    assert live.shown
    assert (drawn(scene) > 0).any()
    assert not mapper.GetDrawn()
    for _ in range(100):
        if live.finished:
            break
        live._tick()
    assert live.samples == 4
    found = drawn(scene)
    assert_shown(found, spheres, scene)
    # It moves: the mapper, at once.
    scene.camera.azimuth += 10
    drawn(scene)
    assert (live.samples, mapper.GetDrawn()) == (0, True)
    time.sleep(0.05)
    live._tick()
    assert live.shown
    scene.off_screen = True


def test_closing_leaves_the_spheres_to_the_mapper(scene, spheres):
    live = scene.packing.path_trace(spheres, reset_camera=False, **OPTIONS)
    first = drawn(scene)
    live.close()
    live.close()
    assert not live.shown
    with pytest.raises(RuntimeError, match="has been closed"):
        live.refine()
    assert scene.renderer.GetPass() is None
    second = drawn(scene)
    assert (first != second).any()
    assert (second > 0).any()
    # And there may be another one.
    again = scene.packing.path_trace(spheres, name="again", reset_camera=False, **OPTIONS)
    assert again is not live
    scene.remove_actor(live.actor)
    assert np.abs(drawn(scene) - first).max() <= 1


def test_refusals_change_nothing(scene, spheres):
    scene.packing.path_trace(spheres, reset_camera=False, **OPTIONS)
    for kwargs, error, found in (
        ({}, ValueError, "render pass: found one"),
        ({"samples": 0}, ValueError, "render pass"),
    ):
        with pytest.raises(error, match=found):
            scene.packing.path_trace(spheres, **kwargs)
    other = pv.Plotter(off_screen=True, window_size=SIZE)
    try:
        for kwargs, error, found in (
            ({"samples": 0}, ValueError, "samples: found 0"),
            ({"step": 0}, ValueError, "step: found 0"),
            ({"sky": -1}, ValueError, "sky: found -1"),
            ({"albedo": 2}, ValueError, "albedo: found 2"),
            ({"time_budget": 1.0}, TypeError, "time_budget: found one"),
            ({"scalars": "mass"}, KeyError, "mass"),
            ({"nonsense": 1}, TypeError, "nonsense"),
        ):
            with pytest.raises(error, match=found):
                other.packing.path_trace(spheres, **kwargs)
        assert not other.renderer.actors
        assert other.renderer.GetPass() is None
    finally:
        other.close()


def test_a_pass_without_a_picture_draws_nothing(scene):
    from spherepacking.trace.live import steps_with

    picture = vtkSpherePackingPicturePass()
    scene.renderer.SetPass(steps_with(picture))
    assert (drawn(scene) == 0).all()
    picture.SetPicture(pv.ImageData(dimensions=(4, 4, 1)))
    assert (drawn(scene) == 0).all()
    image = pv.ImageData(dimensions=(2, 2, 1))
    image["color"] = np.array([[255, 0, 0, 255]] * 4, np.uint8)
    image["depth"] = np.full(4, 5.0, np.float32)
    picture.SetPicture(image)
    assert (drawn(scene) == [255, 0, 0]).all()
    image["color"][:] = [0, 255, 0, 255]
    image.GetPointData().GetArray("color").Modified()
    assert (drawn(scene) == [0, 255, 0]).all()
    scene.renderer.SetPass(None)
    picture.ReleaseGraphicsResources(scene.render_window)


def test_the_first_picture_comes_soon():
    """Within seconds even on a busy machine; how soon is what the benchmark measures."""
    packing = spherepacking.apollonian(6)
    plotter = pv.Plotter(off_screen=True, window_size=(400, 400))
    live = plotter.packing.path_trace(packing, samples=10_000)
    plotter.off_screen = False
    plotter.render()
    start = time.perf_counter()
    assert live.refine(0.05) < 10_000
    assert live.shown
    assert time.perf_counter() - start < 5
    plotter.off_screen = True
    plotter.close()
