"""Pictures that are larger than one framebuffer: drawn in tiles, the same as in one piece."""

import subprocess
import sys

import numpy as np
import pytest
import pyvista as pv
import spherepacking
from spherepacking.backend import vtkSpherePackingTiles, vtkSpherePackingWindowCheck
from spherepacking.checks import LARGEST_DRAWN_SIDE, half_of_memory
from spherepacking.cli import techniques
from spherepacking.cli.main import main
from spherepacking.draw import picture
from spherepacking.files.image import read_image

SIZE = (801, 603)


@pytest.fixture
def tiles(monkeypatch):
    """Draw whatever is larger than 250 pixels in tiles of 250, and count them."""
    drawn = []
    pixels_of = picture._pixels_of

    def counted(*args):
        drawn.append(args)
        return pixels_of(*args)

    monkeypatch.setattr(picture, "_LARGEST_PIECE", 250)
    monkeypatch.setattr(picture, "_TILE", 250)
    monkeypatch.setattr(picture, "_STEP", 200)
    monkeypatch.setattr(picture, "_pixels_of", counted)
    return drawn


def add_text(plotter):
    plotter.add_text("Top left", position="upper_left", font_size=20)
    plotter.add_text("at 300, 190", position=(300, 190), font_size=14)


def add_subplot(plotter):
    plotter.subplot(0, 1)
    plotter.packing.add(spherepacking.apollonian(2), color="red")


def make_parallel(plotter):
    plotter.enable_parallel_projection()
    plotter.camera.parallel_scale = 1.2


def make_translucent(plotter):
    plotter.render_window.SetMultiSamples(1)
    plotter.enable_depth_peeling()
    plotter.add_mesh(pv.Cube().translate((0.7, 0, 0)), color="red", opacity=0.4)


def use_explicit_projection(plotter):
    camera = plotter.camera
    camera.position, camera.focal_point = (3, 3, 3), (0, 0, 0)
    camera.is_set = True
    plotter.renderer.ResetCameraClippingRange()
    matrix = pv._vtk.vtkMatrix4x4()
    matrix.DeepCopy(camera.GetProjectionTransformMatrix(SIZE[0] / SIZE[1], -1.0, 1.0))
    camera.SetExplicitProjectionTransformMatrix(matrix)
    camera.SetUseExplicitProjectionTransformMatrix(True)


def use_filter(plotter):
    plotter.render_window.SetMultiSamples(0)
    plotter.renderer.SetUseFXAA(True)


SCENES = {
    "one sample": lambda plotter: plotter.render_window.SetMultiSamples(0),
    "eight samples": lambda plotter: plotter.render_window.SetMultiSamples(8),
    "text": add_text,
    "axes": lambda plotter: plotter.add_axes(),
    "subplot": add_subplot,
    "parallel": make_parallel,
    "moved centre": lambda plotter: plotter.camera.SetWindowCenter(0.3, -0.2),
    "horizontal angle": lambda plotter: plotter.camera.SetUseHorizontalViewAngle(True),
    "explicit projection": use_explicit_projection,
    "filter": use_filter,
    "translucent": make_translucent,
    "mesh": lambda plotter: plotter.add_mesh(pv.Cube().translate((1, 0, 0)), color="red"),
}


def drawn(name, path, **kwargs):
    plotter = pv.Plotter(
        off_screen=True, window_size=SIZE, shape=(1, 2 if name == "subplot" else 1)
    )
    try:
        plotter.packing.add(
            spherepacking.apollonian(4), scalars="radius", log_scale=True, specular=0.3
        )
        SCENES[name](plotter)
        if name == "translucent":
            # VTK puts labels beside their places when it peels for the first time.
            plotter.screenshot(None)
        return plotter.packing.screenshot(path, **kwargs).astype(int)
    finally:
        plotter.close()


@pytest.mark.parametrize("name", SCENES)
def test_tiles_are_not_seen(name, tiles, tmp_path, monkeypatch):
    """All pixels are those of a picture in one piece, but for a few at edges of triangles."""
    found = drawn(name, tmp_path / "tiles.png")
    assert len(tiles) == 12
    monkeypatch.undo()
    expected = drawn(name, tmp_path / "whole.png")
    assert len(tiles) == 12
    assert found.shape == expected.shape == (SIZE[1], SIZE[0], 3)
    assert expected.std() > 10
    assert (np.abs(found - expected).max(axis=2) > 0).sum() <= 4
    assert (read_image(tmp_path / "tiles.png") == found).all()


def test_a_gradient_is_continuous(tiles, tmp_path, monkeypatch):
    """VTK dithers by half a step."""
    SCENES["gradient"] = lambda plotter: plotter.set_background("red", top="blue")
    try:
        found = drawn("gradient", tmp_path / "tiles.png")
        monkeypatch.undo()
        assert np.abs(found - drawn("gradient", tmp_path / "whole.png")).max() <= 1
    finally:
        del SCENES["gradient"]


def test_transparent_pictures(tiles, tmp_path, monkeypatch):
    found = drawn("one sample", tmp_path / "tiles.png", transparent_background=True)
    assert tiles
    monkeypatch.undo()
    expected = drawn("one sample", tmp_path / "whole.png", transparent_background=True)
    assert found.shape[2] == 4
    assert 0 < (found[..., 3] == 0).mean() < 1
    assert (found != expected).any(axis=2).sum() <= 4


def test_scaled_pictures(tiles, tmp_path, monkeypatch):
    """VTK's own tiles have seams, and see with an angle in single precision."""
    found = drawn("axes", tmp_path / "tiles.png", scale=2)
    assert tiles
    monkeypatch.undo()
    expected = drawn("axes", tmp_path / "whole.png", scale=2)
    assert found.shape == (2 * SIZE[1], 2 * SIZE[0], 3)
    assert (np.abs(found - expected).max(axis=2) > 2).mean() < 1e-3


def test_supersampling_is_on_one_grid(monkeypatch, tmp_path):
    """305 pixels are 682.0007 samples: tiles at multiples of that have the samples of the whole."""

    def smooth(tile, step):
        for name, value in (("_LARGEST_PIECE", 200), ("_TILE", tile), ("_STEP", step)):
            monkeypatch.setattr(picture, name, value)
        plotter = pv.Plotter(off_screen=True, window_size=(915, 610))
        try:
            plotter.enable_anti_aliasing("ssaa")
            plotter.packing.add(spherepacking.apollonian(4), scalars="radius", specular=0.3)
            add_text(plotter)
            return plotter.packing.screenshot(tmp_path / "a.png").astype(int)
        finally:
            plotter.close()

    assert np.abs(smooth(610, 305) - smooth(1000, 1000)).max() <= 2


def test_supersampling_neither_stretches_nor_repeats(monkeypatch):
    """A white right half ends where it should, and does not shine through at the left edge."""

    def profile(drawn):
        plotter = pv.Plotter(off_screen=True, window_size=(200, 150))
        try:
            plotter.enable_anti_aliasing("ssaa")
            plotter.set_background("black")
            plotter.enable_parallel_projection()
            half = pv.Plane(center=(0.5, 0, 0), direction=(0, 0, 1), i_size=1.0, j_size=2.0)
            plotter.add_mesh(half, color="white", lighting=False)
            plotter.camera_position = [(0, 0, 1), (0, 0, 0), (0, 1, 0)]
            plotter.camera.parallel_scale = 0.75
            (strip,) = drawn(plotter)
            return strip[:, :, 0].astype(int)
        finally:
            plotter.close()

    tiled = profile(lambda p: picture._in_tiles(p, (200, 150), False, 1, 400, 400))
    assert tiled[:, :98].max() == 0
    assert tiled[:, 102:].min() == 255
    whole = profile(lambda p: [picture._in_one_piece(p, (200, 150), False, 1)])
    # Upstream: VTK's fault in the same picture; once it is gone, TiledSupersampling can go.
    assert whole[:, 0].max() > 0


def test_a_live_picture_is_traced_once(tiles, tmp_path, monkeypatch):
    def traced(path):
        plotter = pv.Plotter(off_screen=True, window_size=(400, 300))
        try:
            plotter.render_window.SetMultiSamples(0)
            live = plotter.packing.path_trace(spherepacking.apollonian(3), samples=1)
            pixels = plotter.packing.screenshot(path).astype(int)
            assert live.samples == 1
            return pixels
        finally:
            plotter.close()

    found = traced(tmp_path / "tiles.png")
    assert tiles
    monkeypatch.undo()
    expected = traced(tmp_path / "whole.png")
    assert (np.abs(found - expected).max(axis=2) > 1).sum() <= 4


def test_the_plotter_is_as_it_was(tiles, tmp_path):
    plotter = pv.Plotter(off_screen=True, window_size=(200, 150))
    try:
        plotter.packing.add(spherepacking.apollonian(3))
        before = plotter.packing.screenshot(tmp_path / "a.png")
        camera, position = plotter.renderer.GetActiveCamera(), plotter.camera_position
        plotter.packing.screenshot(tmp_path / "b.png", window_size=(600, 450))
        assert tiles
        assert tuple(plotter.window_size) == (200, 150)
        assert plotter.renderer.GetActiveCamera() is camera
        assert plotter.camera_position == position
        assert plotter.renderer.GetViewport() == (0, 0, 1, 1)
        assert plotter.render_window.GetTileScale() == (1, 1)
        assert (plotter.packing.screenshot(tmp_path / "c.png") == before).all()
    finally:
        plotter.close()


@pytest.mark.parametrize("kind", ["off-axis", "stereo"])
def test_a_view_that_cannot_be_divided(kind, tiles, tmp_path):
    plotter = pv.Plotter(off_screen=True, window_size=(300, 200))
    try:
        plotter.packing.add(spherepacking.apollonian(3))
        if kind == "off-axis":
            plotter.camera.SetUseOffAxisProjection(True)
        else:
            plotter.render_window.StereoRenderOn()
        with pytest.raises(
            RuntimeError, match=r"off-axis projection or .*, expected .* most 250 p"
        ):
            plotter.packing.screenshot(tmp_path / "a.png")
    finally:
        plotter.close()
    assert not (tmp_path / "a.png").exists()


def test_no_picture_is_begun():
    tiles = vtkSpherePackingTiles()
    assert not tiles.Begin(None, (10, 10), (5, 5), 1)
    plotter = pv.Plotter(off_screen=True, window_size=(30, 20))
    try:
        for numbers in (((0, 9), (5, 5), 1), ((9, 9), (5, -1), 1), ((9, 9), (5, 5), 0)):
            assert not tiles.Begin(plotter.render_window, *numbers)
        assert tuple(plotter.window_size) == (30, 20)
    finally:
        plotter.close()


# Such a picture was black, and no error.
_TOO_LARGE = """
import sys
import pyvista as pv, spherepacking
from spherepacking.checks import LARGEST_DRAWN_SIDE, half_of_memory
from spherepacking.cli import techniques
from spherepacking.cli.main import main
from spherepacking.draw import picture
picture._LARGEST_PIECE = 10**6
plotter = pv.Plotter(off_screen=True, window_size=(20000, 4))
if sys.argv[2] == "ssaa":
    plotter.enable_anti_aliasing("ssaa")
plotter.packing.add(spherepacking.apollonian(2))
monkey = picture._largest_side
picture._largest_side = lambda window: 10**6
try:
    plotter.packing.screenshot(sys.argv[1])
except RuntimeError as error:
    print("found:", error)
"""


@pytest.mark.parametrize("smoothing", ["none", "ssaa"])
def test_what_cannot_be_drawn_is_an_error(smoothing, tmp_path):
    path = tmp_path / "a.png"
    run = subprocess.run(
        [sys.executable, "-c", _TOO_LARGE, path, smoothing],
        capture_output=True,
        text=True,
        check=True,
    )
    assert "found: the picture cannot be drawn: " in run.stdout
    assert not path.exists()


def test_the_limit_of_opengl():
    plotter = pv.Plotter(off_screen=True, window_size=(40, 30))
    try:
        assert vtkSpherePackingWindowCheck.GetLargestSide(plotter.render_window) >= 4096
        check = vtkSpherePackingWindowCheck()
        check.Begin(plotter.render_window)
        plotter.packing.add(spherepacking.apollonian(2))
        plotter.screenshot(None)
        assert check.End() == ""
    finally:
        plotter.close()


def test_rendering_what_has_not_begun(capfd):
    vtkSpherePackingTiles().Render(0, 0)
    assert "expected Begin() before Render()" in capfd.readouterr().err


@pytest.mark.parametrize("size", [("7411", "3"), ("3", "16500"), ("32768", "2")])
def test_the_command_draws_long_pictures(size, tmp_path):
    """From about 7400 pixels on they were black, and refused from 8192 on."""
    path = tmp_path / "a.png"
    spherepacking.write(spherepacking.apollonian(2), tmp_path / "a.spheres")
    arguments = ["render", tmp_path / "a.spheres", "-o", path, "--size", *size]
    view = ["--camera", "0.1", "0", "0", "--focal", "-1", "0", "0", "--no-scalar-bar"]
    subprocess.run([sys.executable, "-m", "spherepacking", *arguments, *view], check=True)
    pixels = read_image(path)
    assert pixels.shape == (int(size[1]), int(size[0]), 3)
    # From within a sphere no pixel is background.
    assert (pixels.reshape(-1, 3) != pixels[0, 0]).any(axis=1).mean() > 0.5 or pixels.std() > 5
    assert pixels.reshape(-1, 3).sum(axis=1).min() > 0


@pytest.mark.parametrize("parallel", [False, True])
def test_rays_are_cast_strip_by_strip(parallel, monkeypatch):
    camera = pv.Camera()
    camera.position, camera.focal_point, camera.up = (3, 2, 2.5), (0, 0, 0.1), (0, 0, 1)
    camera.parallel_projection, camera.parallel_scale = parallel, 1.3
    camera.SetWindowCenter(0.1, -0.2)
    accessor = spherepacking.apollonian(4).packing

    def cast(camera, width, height):
        image = accessor.ray_cast(camera, (width, height), samples=2, color="red")
        return np.asarray(image["color"]).reshape(height, width, 4)[::-1]

    monkeypatch.setattr(techniques, "_STRIP_PIXELS", 203 * 30)
    strips = [
        cast(view, 203, rows) for view, rows in techniques._views_of_strips(camera, (203, 157))
    ]
    assert [len(strip) for strip in strips] == [30, 30, 30, 30, 30, 7]
    whole = cast(camera, 203, 157)
    assert whole.std() > 20
    assert (np.vstack(strips) == whole).all()


@pytest.mark.parametrize(
    ("options", "found"),
    [
        (["--size", "32769", "10"], "--size: found 32769 10, expected numbers of pixels from 1 to"),
        (["--size", "32768", "32768", "--technique", "pathtrace"], "expected at most"),
    ],
)
def test_the_command_refuses_what_is_too_large(options, found, tmp_path, monkeypatch):
    if "pathtrace" in options and half_of_memory() > 32768**2 * 64:
        pytest.skip("this machine has the memory")
    spherepacking.write(spherepacking.apollonian(2), tmp_path / "a.spheres")
    run = subprocess.run(
        [sys.executable, "-m", "spherepacking", "render", "a.spheres", "-o", "a.png", *options],
        cwd=tmp_path,
        capture_output=True,
        text=True,
    )
    assert run.returncode == 2
    assert found in run.stderr
    assert run.stderr.count("\n") == 1
    assert not (tmp_path / "a.png").exists()


def test_a_window_that_is_too_large_is_not_shown(tmp_path):
    with pytest.raises(
        ValueError, match=r"found 5000 x 20, expected at most 4096 .*screenshot makes"
    ):
        spherepacking.apollonian(2).packing.plot(
            off_screen=True, window_size=(5000, 20), screenshot=tmp_path / "a.png"
        )
    assert not (tmp_path / "a.png").exists()


def test_a_live_picture_that_is_no_texture(monkeypatch, tmp_path):
    """It would be drawn as nothing; it is refused before it is traced."""
    plotter = pv.Plotter(off_screen=True, window_size=(40, 30))
    try:
        plotter.packing.path_trace(spherepacking.apollonian(2), samples=1)
        largest = vtkSpherePackingWindowCheck.GetLargestSide(plotter.render_window)
        if largest >= LARGEST_DRAWN_SIDE:
            pytest.skip("OpenGL has textures of any size that is drawn")
        with pytest.raises(RuntimeError, match=rf"cannot be traced: .* at most {largest} pixels"):
            plotter.packing.screenshot(tmp_path / "a.png", window_size=(largest + 1, 2))
        assert not (tmp_path / "a.png").exists()
        assert plotter.packing.screenshot(tmp_path / "a.png").std() > 5
    finally:
        plotter.close()


def test_the_command_says_that_it_cannot_draw(monkeypatch, tmp_path, capsys):
    spherepacking.write(spherepacking.apollonian(2), tmp_path / "a.spheres")
    monkeypatch.setattr(picture, "_LARGEST_PIECE", 10**6)
    monkeypatch.setattr(picture, "_largest_side", lambda window: 10**6)
    arguments = ["render", str(tmp_path / "a.spheres"), "-o", str(tmp_path / "a.png")]
    assert main([*arguments, "--size", "20000", "4"]) == 2
    said = capsys.readouterr().err.splitlines()[-1]
    assert said.startswith("spherepacking: the picture cannot be drawn: ")
    assert not (tmp_path / "a.png").exists()


@pytest.mark.parametrize(
    ("arguments", "found"),
    [
        (((0, 10), False), "size: found 0"),
        (((40000, 10), False), "size: found 40000"),
        (((10, 10), 1), "transparent: found 1"),
        (((10, 10), True, 0), "scale: found 0"),
        (((10, 11), True, 2), "size: found 10 x 11, expected multiples of 2"),
    ],
)
def test_wrong_arguments_of_strips(arguments, found):
    plotter = pv.Plotter(off_screen=True, window_size=(40, 30))
    try:
        with pytest.raises((TypeError, ValueError), match=found):
            plotter.packing.strips(*arguments)
    finally:
        plotter.close()


def test_a_picture_that_is_given_up(tiles):
    plotter = pv.Plotter(off_screen=True, window_size=(300, 280))
    try:
        plotter.packing.add(spherepacking.apollonian(3))
        strips = plotter.packing.strips((900, 840), False)
        next(strips)
        strips.close()
        assert tuple(plotter.window_size) == (300, 280)
        assert plotter.renderer.GetViewport() == (0, 0, 1, 1)
        assert plotter.renderer.GetDraw()
    finally:
        plotter.close()


def test_a_picture_that_fills_the_memory(monkeypatch, tmp_path):
    plotter = pv.Plotter(off_screen=True, window_size=(300, 280))
    try:
        plotter.packing.add(spherepacking.apollonian(2))
        monkeypatch.setattr(picture, "half_of_memory", lambda: 10**6)
        with pytest.raises(
            ValueError, match=r"window_size: found 800 x 500, .* at most 333333 pix"
        ):
            plotter.packing.screenshot(tmp_path / "a.png", window_size=(800, 500))
        with pytest.raises(ValueError, match=r"at most 250000 pixels"):
            plotter.packing.screenshot(
                tmp_path / "a.png", window_size=(400, 250), scale=2, transparent_background=True
            )
        assert not (tmp_path / "a.png").exists()
    finally:
        plotter.close()
