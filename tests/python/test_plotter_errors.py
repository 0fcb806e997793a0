"""``plotter.packing.add`` refuses what cannot be meant, and leaves the plotter as it was."""

import numpy as np
import pytest
import pyvista as pv
from drawing import packing, plotter


def stretched(*scales):
    return {"user_matrix": np.diag([*scales, 1.0])}


def bar(**kwargs):
    return {"scalars": "height", "scalar_bar_args": kwargs}


SHEAR = np.eye(4)
SHEAR[0, 1] = 1.0
PERSPECTIVE = np.eye(4)
PERSPECTIVE[3, 2] = 1.0
HEIGHT = {"scalars": "height"}
VELOCITY = {"scalars": "velocity"}
LOG = HEIGHT | {"log_scale": True}

BAD = [
    (
        KeyError,
        "radius: the packing has no point array 'width', .* radius, height",
        {"radius": "width"},
    ),
    (TypeError, "radius: .*'kind'", {"radius": "kind"}),
    (ValueError, "radius: found 3 components that differ in 'velocity'", {"radius": "velocity"}),
    (ValueError, "radius: found 2 values, expected one for each of 3", {"radius": [1.0, 2.0]}),
    (ValueError, "radius: .*nan at point 1, expected", {"radius": [1.0, np.nan, 1.0]}),
    (ValueError, "radius: .*inf at point 2, expected", {"radius": [1.0, 1.0, np.inf]}),
    (ValueError, "radius: .*-1 at point 0, expected", {"radius": [-1.0, 1.0, 1.0]}),
    (ValueError, "radius: .*-1 at point 0, expected", {"radius": -1.0}),
    (TypeError, "radius: found <U1 values, expected real numbers", {"radius": ["a", "b", "c"]}),
    (TypeError, "radius: found object values", {"radius": [None] * 3}),
    (KeyError, "scalars: the packing has no point array 'width'", {"scalars": "width"}),
    (ValueError, "scalars: found 2 values, expected one for each of 3", {"scalars": [1.0, 2.0]}),
    (ValueError, "scalars: found a single value", {"scalars": 1.0}),
    (
        ValueError,
        r"rgb: found scalars of shape \(3,\), expected",
        {"scalars": "height", "rgb": True},
    ),
    (ValueError, "rgb: found no scalars", {"rgb": True}),
    (ValueError, "opacity: found 1.5, expected values from 0 to 1", {"opacity": 1.5}),
    (ValueError, "opacity: found .*nan", {"opacity": np.nan}),
    (ValueError, "opacity: a transfer function needs scalars", {"opacity": "linear"}),
    (TypeError, "unexpected keyword argument 'colour'", {"colour": "red"}),
    (ValueError, "nonsense", {"color": "nonsense"}),
    (ValueError, "nonsense", {"scalars": "height", "cmap": "nonsense"}),
    # user_matrix
    (ValueError, "user_matrix: .*finite", {"user_matrix": np.full((4, 4), np.nan)}),
    (ValueError, r"user_matrix: .*\(5, 5\).*\(4, 4\)", {"user_matrix": np.eye(5)}),
    (ValueError, "user_matrix: .*4x4", {"user_matrix": "nonsense"}),
    (ValueError, "user_matrix: found the scales 2, 1, 1, expected one", stretched(1, 1, 2)),
    (ValueError, "user_matrix: found the scales 1.618.*, expected one", {"user_matrix": SHEAR}),
    (ValueError, "user_matrix: found a scale of 0, expected", stretched(0, 0, 0)),
    (ValueError, r"user_matrix: found a scale of 1e\+200", stretched(1e200, 1e200, 1e200)),
    (ValueError, "user_matrix: .* as its last row", {"user_matrix": np.diag([1.0, 1, 1, 0])}),
    (ValueError, "user_matrix: .* as its last row", {"user_matrix": PERSPECTIVE}),
    (ValueError, "lighting: found 'a', expected True, False or None", {"lighting": "a"}),
    # clim
    (ValueError, r"clim: found \(2, 1\), expected", {"clim": (2, 1)}),
    (ValueError, r"clim: found \(nan, 1\), expected", {"clim": (np.nan, 1)}),
    (ValueError, r"clim: found \(0, inf\), expected", {"clim": (0, np.inf)}),
    (ValueError, r"clim: found \(1, 2, 3\), expected", {"clim": (1, 2, 3)}),
    (ValueError, "clim: found -1, expected", {"clim": -1}),
    (ValueError, "clim: found 'ab', expected", {"clim": "ab"}),
    # the colour map
    (ValueError, "n_colors: found 0, expected an integer from 1 to", {"n_colors": 0}),
    (ValueError, "n_colors: found -1, expected an integer from 1 to", {"n_colors": -1}),
    (TypeError, "n_colors: found 2.5, expected an integer", {"n_colors": 2.5}),
    (TypeError, "n_colors: found 'many', expected an integer", {"n_colors": "many"}),
    (ValueError, "categories: found -1, expected an integer from 1 to", {"categories": -1}),
    (TypeError, "categories: found 'a', expected an integer from 1 to", {"categories": "a"}),
    (ValueError, r"cmap: found \[\], expected", {"cmap": []}),
    (ValueError, "cmap: found 'nonsense', expected", {"cmap": "nonsense"}),
    (ValueError, r"cmap: found \['nonsense'\], expected", {"cmap": ["nonsense"]}),
    (ValueError, "cmap: found 3, expected", {"cmap": 3}),
    (TypeError, "annotations: found 3, expected a dict", {"annotations": 3}),
    (ValueError, "annotations: found 'a', expected a number", {"annotations": {"a": "b"}}),
    (TypeError, "annotations: found 2 beside 1, expected a text", {"annotations": {1: 2}}),
    (ValueError, "nan_opacity: found 2, expected a number from 0 to 1", {"nan_opacity": 2}),
    (ValueError, "nan_opacity: found -0.1, expected", {"nan_opacity": -0.1}),
    (ValueError, "nan_opacity: found nan, expected", {"nan_opacity": np.nan}),
    (ValueError, "nan_opacity: found 'a', expected", {"nan_opacity": "a"}),
    (ValueError, "nan_color: found 'nonsense', expected", {"nan_color": "nonsense"}),
    (ValueError, "above_color: found 'nonsense', expected", {"above_color": "nonsense"}),
    (ValueError, "below_color: found 'nonsense', expected", {"below_color": "nonsense"}),
    (ValueError, "log_scale: found scalars from -1 to 1, expected", LOG | {"scalars": [-1, 0, 1]}),
    (ValueError, "log_scale: found scalars from 0 to 2, expected", LOG),
    (ValueError, "log_scale: found a clim from 0 to 1, expected", LOG | {"clim": (0, 1)}),
    (ValueError, "log_scale: found scalars of bool", LOG | {"scalars": [True, False, True]}),
    (ValueError, "component: found 3, expected .* 0 to 2", VELOCITY | {"component": 3}),
    (ValueError, "component: found -1, expected .* 0 to 2", VELOCITY | {"component": -1}),
    (ValueError, "component: found 1.0, expected", VELOCITY | {"component": 1.0}),
    (ValueError, "component: found 1, expected .* 0 to 0", {"scalars": "height", "component": 1}),
    # scalars
    (TypeError, "scalars: found complex128 values, expected", {"scalars": [1j, 2, 3]}),
    (TypeError, "scalars: found object values, expected", {"scalars": [1, "a", None]}),
    (TypeError, "scalars: found datetime64", {"scalars": np.zeros(3, "M8[s]")}),
    (ValueError, "scalars: found texts .* beyond ASCII", {"scalars": ["é", "b", "c"]}),
    (ValueError, "scalars: found texts .* beyond ASCII", {"scalars": [b"\xe9", b"b", b"c"]}),
    (ValueError, r"scalars: found the shape \(3, 2, 2\)", {"scalars": np.zeros((3, 2, 2))}),
    (ValueError, r"scalars: found the shape \(3, 0\)", {"scalars": np.zeros((3, 0))}),
    (ValueError, r"scalars: found the shape \(3, 2\)", {"scalars": [["a", "b"]] * 3}),
    (ValueError, "scalars: found values from 1 to inf", {"scalars": [np.inf, 1, 2]}),
    (ValueError, "rgb: found 2.0 as float64, expected", {"scalars": 2.0 * np.eye(3), "rgb": True}),
    (
        ValueError,
        "rgb: found -1 as int64, expected",
        {"scalars": -np.eye(3, dtype=int), "rgb": True},
    ),
    (TypeError, "rgb: found bool values", {"scalars": np.eye(3, dtype=bool), "rgb": True}),
    # opacity
    (ValueError, r"opacity: found an array of shape \(0,\)", {"opacity": []} | HEIGHT),
    (ValueError, r"opacity: found an array of shape \(2, 2\)", {"opacity": np.eye(2)} | HEIGHT),
    (ValueError, r"opacity: found .*\(257,\).* up to 256", {"opacity": np.zeros(257)} | HEIGHT),
    (ValueError, "opacity: found 0 to 256 along", {"opacity": 256.0 * np.eye(256)[0]} | HEIGHT),
    (ValueError, "opacity: found .* finite", {"opacity": [0, np.nan]} | HEIGHT),
    (TypeError, "opacity: found complex128", {"opacity": [0, 1j]} | HEIGHT),
    (TypeError, "opacity: found <U1", {"opacity": "kind"} | HEIGHT),
    (ValueError, "opacity: .*nonsense", {"opacity": "nonsense"} | HEIGHT),
    (
        ValueError,
        "opacity: found one for each sphere beside rgb",
        {"scalars": np.eye(3), "rgb": True, "opacity": [0.1, 0.2, 0.3]},
    ),
    # radii
    (ValueError, "radius: found .* that double", {"radius": np.ones(3, np.longdouble) / 3}),
    (ValueError, "radius: found .* that double", {"radius": np.longdouble("1e400")}),
    # the scalar bar
    (ValueError, "scalar_bar_args: found 'nonsense', expected one of .*title", bar(nonsense=1)),
    (ValueError, "scalar_bar_args: found 'mapper', expected one of", bar(mapper=None)),
    (ValueError, "scalar_bar_args: found .*'pink-ish'", bar(color="pink-ish")),
    (ValueError, "scalar_bar_args: found .*'n_labels': 'a'", bar(n_labels="a")),
    (ValueError, "scalar_bar_args: found .*'title': 5", bar(title=5)),
    (ValueError, "scalar_bar_args: found .*'font_family'", bar(font_family="nonsense")),
    (TypeError, "scalar_bar_args: found 3, expected a dict", HEIGHT | {"scalar_bar_args": 3}),
    # material and actor
    (ValueError, "ambient: found 5, expected a number from 0 to 1", {"ambient": 5}),
    (ValueError, "diffuse: found nan, expected a number from 0 to 1", {"diffuse": np.nan}),
    (ValueError, "specular: found 'a', expected a number", {"specular": "a"}),
    (ValueError, "specular_power: found 129, expected .* 0 to 128", {"specular_power": 129}),
    (ValueError, "name: found 5, expected a text", {"name": 5}),
    (ValueError, "name: found '', expected a text", {"name": ""}),
]


def state(scene):
    """Return what `add` may change of a plotter."""
    return (
        dict(scene.actors),
        dict(scene.scalar_bars.items()),
        scene.mapper.scalar_range,
        scene.mesh,
        scene.mapper,
        scene.camera_position,
        scene.renderer.camera_set,
    )


@pytest.mark.parametrize(("kind", "message", "kwargs"), BAD, ids=[str(b[2]) for b in BAD])
def test_one_error_and_the_plotter_as_it_was(capfd, kind, message, kwargs):
    mesh = packing(height=[0, 1, 2], velocity=np.eye(3), kind=["a", "b", "a"])
    arrays = mesh.point_data.keys()
    with plotter() as scene:
        scene.set_color_cycler(["red", "lime", "blue"])
        scene.packing.add(mesh, scalars="height", name="first")
        before = state(scene)
        with pytest.raises(kind, match=message):
            scene.packing.add(mesh, **{"name": "first"} | kwargs)
        assert state(scene) == before
        assert scene.render_window.GetNeverRendered()
        assert scene.packing.add(mesh).prop.color == "lime"
    assert mesh.point_data.keys() == arrays
    assert capfd.readouterr().err == ""


def test_an_eleventh_scalar_bar():
    mesh = packing(height=[0, 1, 2])
    with plotter() as scene:
        for i in range(pv.MAX_N_COLOR_BARS):
            scene.packing.add(mesh, scalars="height", scalar_bar_args={"title": str(i)})
        before = state(scene)
        with pytest.raises(ValueError, match="found 10 scalar bars already, expected position_x"):
            scene.packing.add(mesh, scalars="height")
        assert state(scene) == before
        place = {"position_x": 0.1, "position_y": 0.9}
        scene.packing.add(mesh, scalars="height", scalar_bar_args=place)
        assert len(scene.scalar_bars) == pv.MAX_N_COLOR_BARS + 1


def test_interactive_scalar_bar_in_several_views():
    mesh = packing(height=[0, 1, 2])
    with plotter(shape=(1, 2)) as scene:
        before = dict(scene.actors)  # some versions of PyVista draw the borders of the views
        with pytest.raises(ValueError, match=r"interactive in a plotter of shape \(1, 2\)"):
            scene.packing.add(mesh, scalars="height", scalar_bar_args={"interactive": True})
        assert dict(scene.actors) == before


def test_a_stretched_scene():
    with plotter() as scene:
        scene.set_scale(zscale=2.0)
        with pytest.raises(
            ValueError, match=r"the plotter's scale: found .*2.0.*, expected the same"
        ):
            scene.packing.add(packing())
        assert not scene.actors


def test_what_is_stretched_later_is_not_saved_as_a_picture(tmp_path, capfd):
    path = tmp_path / "a.png"
    with plotter() as scene:
        actor = scene.packing.add(packing())
        actor.user_matrix = np.diag([1.0, 1.0, 2.0, 1.0])
        with pytest.raises(RuntimeError, match="the spheres cannot be drawn: the actor's matrix"):
            scene.packing.screenshot(path)
        assert not path.exists()
        actor.user_matrix = np.eye(4)
        scene.render()
        assert scene.packing.screenshot(path).std() > 20
    capfd.readouterr()  # VTK tells it on stderr as well


def test_what_has_changed_since_the_last_picture_is_drawn_or_told(tmp_path, capfd):
    path = tmp_path / "a.png"
    mesh = packing()
    with plotter() as scene:
        scene.packing.add(mesh)
        before = scene.packing.screenshot(path)
        mesh["radius"][1] = 0.1
        mesh.Modified()
        after = scene.packing.screenshot(path)
        assert 0 < (after > 0).sum() < 0.8 * (before > 0).sum()
        path.unlink()
        mesh["radius"][1] = -1.0
        mesh.Modified()
        with pytest.raises(RuntimeError, match=r"the spheres cannot be drawn: .*-1 at point 1"):
            scene.packing.screenshot(path)
        assert not path.exists()
    capfd.readouterr()  # VTK tells it on stderr as well


@pytest.mark.parametrize(
    "kwargs",
    [
        {"window_size": (0, 10)},
        {"window_size": (-1, 5)},
        {"window_size": (10,)},
        {"window_size": (40000, 10)},
        {"scale": 0},
        {"scale": 400},
    ],
)
def test_sizes_that_no_picture_has(tmp_path, kwargs):
    with plotter() as scene:
        scene.packing.add(packing())
        with pytest.raises(ValueError, match=r"(window_size|scale): found .*expected"):
            scene.packing.screenshot(tmp_path / "a.png", **kwargs)
    assert not (tmp_path / "a.png").exists()


def test_a_hidden_packing_is_no_error(tmp_path):
    mesh = packing()
    with plotter() as scene:
        actor = scene.packing.add(mesh)
        mesh["radius"][1] = -1.0
        mesh.Modified()
        actor.visibility = False
        assert scene.packing.screenshot(tmp_path / "a.png").max() == 0


@pytest.mark.parametrize("thing", [None, 3, np.zeros((4, 3)), pv.Table(), "file.spheres"])
def test_what_is_no_packing(thing):
    with (
        plotter() as scene,
        pytest.raises(TypeError, match=r"packing: found an? .*expected a PolyD"),
    ):
        scene.packing.add(thing)


def test_a_center_that_is_not_finite():
    mesh = packing()
    mesh.points[1, 2] = np.nan
    with plotter() as scene, pytest.raises(ValueError, match=r"centre of point 1 .*nan"):
        scene.packing.add(mesh)


def test_a_cell_array_is_hinted_at():
    mesh = pv.PolyData(np.eye(3))
    mesh.point_data["radius"] = np.ones(3)
    mesh.cell_data["height"] = np.ones(3)
    with plotter() as scene, pytest.raises(KeyError, match="there is a cell array of that name"):
        scene.packing.add(mesh, scalars="height")


def test_closed_plotter():
    with plotter() as scene:
        component = scene.packing
    with pytest.raises(RuntimeError, match="has been closed"):
        component.add(packing())
