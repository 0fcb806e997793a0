"""``plotter.packing.add``: the arguments of ``add_mesh`` on spheres, in pixels."""

import gc
import inspect
import weakref

import numpy as np
import pytest
import pyvista as pv
from drawing import SIZE, drawn_colors, packing, plotter
from spherepacking.plotter import PackingComponent

RED, GREEN, BLUE = (255, 0, 0), (0, 255, 0), (0, 0, 255)
RGB = [RED, GREEN, BLUE]


def close(found, expected, tolerance=1):
    return np.abs(np.asarray(found) - np.asarray(expected)).max() <= tolerance


# --- arguments ------------------------------------------------------------------------------------


def test_words_are_those_of_add_mesh():
    """Same names, same defaults; only what spheres need besides is new."""
    ours = inspect.signature(PackingComponent.add).parameters
    theirs = inspect.signature(pv.Plotter.add_mesh).parameters
    new = ours.keys() - theirs.keys()
    assert new == {"self", "packing", "radius", "show_cell"} - theirs.keys()
    different = {n for n in ours.keys() & theirs.keys() if ours[n].default != theirs[n].default}
    assert different == {"opacity"}  # 1.0 instead of None, which means 1.0


def test_color():
    assert close(drawn_colors(packing(), color="red"), [RED] * 3)


def test_color_of_the_theme():
    expected = pv.Color(pv.global_theme.color).int_rgb
    assert close(drawn_colors(packing()), [expected] * 3)


def test_color_cycler():
    with plotter() as scene:
        scene.set_color_cycler(["red", "lime"])
        assert scene.packing.add(packing()).prop.color == "red"
        assert scene.packing.add(packing()).prop.color == "lime"


def test_scalars_by_name_through_a_color_map():
    found = drawn_colors(packing(height=[0, 1, 2]), scalars="height", cmap=["red", "lime", "blue"])
    assert close(found, RGB)


def test_scalars_as_array_match_scalars_by_name():
    mesh = packing(height=[0.0, 1.0, 2.0])
    kwargs = {"cmap": ["red", "lime", "blue"]}
    named = drawn_colors(mesh, scalars="height", **kwargs)
    assert np.array_equal(drawn_colors(mesh, scalars=[0.0, 1.0, 2.0], **kwargs), named)


def test_active_scalars_unless_there_is_a_color():
    mesh = packing(height=[0, 1, 2])
    mesh.set_active_scalars("height")
    assert close(drawn_colors(mesh, cmap=["red", "lime", "blue"]), RGB)
    assert close(drawn_colors(mesh, color="red"), [RED] * 3)


def test_clim_below_and_above():
    found = drawn_colors(
        packing(height=[0, 1, 2]),
        scalars="height",
        clim=(0.5, 1.5),
        cmap=["lime"],
        below_color="red",
        above_color="blue",
    )
    assert close(found, RGB)


def test_nan_color():
    found = drawn_colors(
        packing(height=[0, np.nan, 0]), scalars="height", cmap=["red"], nan_color="lime"
    )
    assert close(found, [RED, GREEN, RED])


def test_only_nan_scalars():
    assert close(
        drawn_colors(packing(height=[np.nan] * 3), scalars="height", nan_color="lime"), [GREEN] * 3
    )


@pytest.mark.parametrize("opacity", [1, 1.0])
def test_nan_opacity(opacity):
    mesh = packing(height=[0, np.nan, 1])
    found = drawn_colors(mesh, scalars="height", nan_color="lime", nan_opacity=opacity)
    assert close(found[1], GREEN)
    found = drawn_colors(mesh, scalars="height", nan_color="lime", nan_opacity=0 * opacity)
    assert close(found[1], (0, 0, 0))


def test_log_scale_of_clim_draws_the_others_in_the_lowest_color():
    kwargs = {"scalars": "height", "cmap": ["red", "lime", "blue"]}
    mesh = packing(height=[-1.0, 10.0, 100.0])
    assert close(drawn_colors(mesh, log_scale=True, clim=(1, 100), **kwargs), RGB)


def test_log_scale():
    kwargs = {"scalars": "height", "cmap": ["red", "lime", "blue"]}
    mesh = packing(height=[1.0, 10.0, 100.0])
    assert close(drawn_colors(mesh, log_scale=True, **kwargs), RGB)
    assert not close(drawn_colors(mesh, **kwargs), RGB)


def test_flip_scalars():
    found = drawn_colors(
        packing(height=[0, 1, 2]), scalars="height", cmap=["red", "lime", "blue"], flip_scalars=True
    )
    assert close(found, RGB[::-1])


def test_component_and_magnitude():
    mesh = packing(velocity=[[3.0, 4.0, 0.0], [0.0, 0.0, 0.0], [0.0, 5.0, 0.0]])
    kwargs = {"scalars": "velocity", "cmap": ["red", "blue"], "n_colors": 2}
    assert close(drawn_colors(mesh, **kwargs), [BLUE, RED, BLUE])
    assert close(drawn_colors(mesh, component=0, **kwargs), [BLUE, RED, RED])


def test_text_scalars_are_categories():
    mesh = packing(kind=["a", "b", "a"])
    assert close(drawn_colors(mesh, scalars="kind", cmap=["red", "lime"]), [RED, GREEN, RED])


def test_bool_scalars():
    mesh = packing(chosen=[False, True, False])
    assert close(drawn_colors(mesh, scalars="chosen", cmap=["red", "lime"]), [RED, GREEN, RED])


@pytest.mark.parametrize("scale", [1.0, 255])
@pytest.mark.parametrize("named", [True, False])
def test_rgb(scale, named):
    dtype = np.uint8 if scale == 255 else float
    values = (np.array(RGB) / 255 * scale).astype(dtype)
    mesh = packing(tint=values) if named else packing()
    assert close(drawn_colors(mesh, scalars="tint" if named else values, rgb=True), RGB)


def test_rgb_by_name():
    assert close(drawn_colors(packing(tint_rgb=np.array(RGB, np.uint8)), scalars="tint_rgb"), RGB)


def through(*opacities):
    """White spheres over black: each shows its front and, through it, its back."""
    return [[255 * (1 - (1 - opacity) ** 2)] * 3 for opacity in opacities]


def test_opacity_of_the_actor():
    assert close(drawn_colors(packing(), color="white", opacity=0.5), through(0.5), tolerance=2)


def test_opacity_is_that_of_a_meshed_sphere():
    with plotter() as scene:
        scene.add_mesh(pv.Sphere(radius=1.0), color="white", lighting=False, opacity=0.5)
        meshed = scene.screenshot(None, return_img=True)[50, 50]
    assert close(drawn_colors(packing(1), color="white", opacity=0.5), meshed)


@pytest.mark.parametrize("named", [True, False])
@pytest.mark.parametrize("mapped", [True, False])
def test_opacity_of_each_sphere(named, mapped):
    values = np.array([0.0, 0.5, 1.0])
    mesh = packing(clear=values, height=[1.0, 1.0, 1.0])
    look = {"scalars": "height", "cmap": ["white"], "clim": (0, 2)} if mapped else {"color": "w"}
    found = drawn_colors(mesh, opacity="clear" if named else values, **look)
    assert close(found, through(0.0, 0.5, 1.0), tolerance=2)


@pytest.mark.parametrize(
    "opacity",
    ["linear", [0.0, 1.0], np.linspace(0, 1, 256), np.arange(256, dtype=np.uint8)],
    ids=["name", "short", "full", "bytes"],
)
def test_opacity_along_the_color_map(opacity):
    mesh = packing(height=[0.0, 1.0, 2.0])
    found = drawn_colors(mesh, scalars="height", cmap=["white"] * 256, opacity=opacity)
    assert close(found, through(0.0, 0.5, 1.0), tolerance=3)


def test_opacity_along_a_color_map_of_categories():
    mesh = packing(kind=["a", "b", "c"])
    found = drawn_colors(mesh, scalars="kind", cmap=["white"] * 3, opacity="linear")
    assert close(found, through(0.0, 0.5, 1.0), tolerance=3)


def test_opacity_of_each_sphere_on_equal_scalars():
    mesh = packing(height=[1.0, 1.0, 1.0])
    found = drawn_colors(mesh, scalars="height", cmap=["white"], opacity=[0.0, 0.5, 1.0])
    assert close(found, through(0.0, 0.5, 1.0), tolerance=2)


@pytest.mark.parametrize("radius", ["half", [0.5, 0.5, 0.5], 0.5, np.float32(0.5)])
def test_radius(radius):
    mesh = packing(half=np.full(3, 0.5))
    with plotter() as scene:
        actor = scene.packing.add(mesh, color="white", lighting=False, radius=radius)
        picture = scene.screenshot(None, return_img=True)
        assert actor.bounds == pytest.approx((-3.5, 3.5, -0.5, 0.5, -0.5, 0.5))
    covered = (picture[..., 0] > 127).sum() * (10 / SIZE) ** 2
    assert covered == pytest.approx(3 * np.pi * 0.25, rel=0.05)


@pytest.mark.parametrize("kind", ["f2", "g", ">f8", ">i4", "u1"])
def test_radii_and_scalars_of_any_width_and_byte_order(kind):
    """They become what VTK stores, and the caller's array stays as it is."""
    radii, heights = np.array([1, 2, 1], kind), np.array([0, 1, 2], kind)
    with plotter() as scene:
        mesh = packing()
        actor = scene.packing.add(mesh, radius=radii, scalars=heights)
        drawn = actor.mapper.dataset
        assert drawn["radius"].tolist() == [1, 2, 1]
        assert drawn[pv.DEFAULT_SCALARS_NAME].tolist() == [0, 1, 2]
    assert (radii.tolist(), heights.tolist()) == ([1, 2, 1], [0, 1, 2])
    assert radii.dtype == heights.dtype == np.dtype(kind)


def test_one_sphere_and_none():
    assert close(drawn_colors(packing(1), color="red"), [RED])
    with plotter() as scene:
        actor = scene.packing.add(packing(0))
        assert scene.screenshot(None, return_img=True).max() == 0
        assert actor.mapper.dataset.n_points == 0


def test_user_matrix():
    with plotter() as scene:
        matrix = np.diag([1.0, 1.0, 1.0, 1.0])
        matrix[1, 3] = 2.0
        actor = scene.packing.add(packing(1), user_matrix=matrix)
        assert actor.bounds == pytest.approx((-1, 1, 1, 3, -1, 1))


def test_homogeneous_user_matrix():
    """As in PyVista's example: the last number divides."""
    with plotter() as scene:
        scene.packing.add(packing(1), color="w", lighting=False, user_matrix=np.diag([1, 1, 1, 2]))
        covered = (scene.screenshot(None, return_img=True)[..., 0] > 127).sum() * (10 / SIZE) ** 2
    assert covered == pytest.approx(np.pi * 0.25, rel=0.05)


def test_a_mirrored_packing_is_the_packing_of_mirrored_centers(rng):
    mesh = pv.PolyData(rng.normal(size=(40, 3)))
    mesh["radius"] = rng.uniform(0.1, 0.6, 40)
    pictures = []
    for sign, matrix in ((1, np.diag([-1, 1, 1, 1])), (-1, None)):
        moved = mesh.copy()
        moved.points[:, 0] *= sign
        with plotter() as scene:
            scene.packing.add(moved, specular=0.5, show_scalar_bar=False, user_matrix=matrix)
            pictures.append(scene.screenshot(None, return_img=True))
    assert pictures[0].std() > 20
    assert close(*(picture.astype(int) for picture in pictures))


def test_material_and_pickable():
    with plotter() as scene:
        actor = scene.packing.add(
            packing(), ambient=0.1, diffuse=0.2, specular=0.3, specular_power=4.0, pickable=False
        )
        prop = actor.prop
        assert (prop.ambient, prop.diffuse, prop.specular, prop.specular_power) == (
            0.1,
            0.2,
            0.3,
            4.0,
        )
        assert not actor.pickable


# --- scene ----------------------------------------------------------------------------------------


def test_name_replaces():
    with plotter() as scene:
        scene.packing.add(packing(), name="spheres")
        scene.packing.add(packing(1), name="spheres")
        scene.packing.add(packing())
        assert len(scene.actors) == 2
        assert scene.actors["spheres"].mapper.dataset.n_points == 1


def test_scalar_bar():
    with plotter() as scene:
        actor = scene.packing.add(packing(height=[0, 1, 2]), scalars="height")
        assert list(scene.scalar_bars.keys()) == ["height"]
        scene.update_scalar_bar_range((5, 7))
        assert actor.mapper.scalar_range == (5, 7)
        scene.update_scalar_bar_range((1, 2), "height")
        assert actor.mapper.scalar_range == (1, 2)
        scene.remove_actor(actor)
        assert len(scene.scalar_bars) == 0


@pytest.mark.parametrize(
    "kwargs", [{"color": "red"}, {"show_scalar_bar": False}, {"scalars": "tint", "rgb": True}]
)
def test_no_scalar_bar(kwargs):
    with plotter() as scene:
        mesh = packing(height=[0, 1, 2], tint=np.array(RGB, np.uint8))
        mesh.set_active_scalars("height")
        scene.packing.add(mesh, **kwargs)
        assert len(scene.scalar_bars) == 0


def test_scalar_bar_args_are_used_and_not_changed():
    args = {"title": "Height", "n_labels": 2}
    with plotter() as scene:
        scene.packing.add(packing(height=[0, 1, 2]), scalars="height", scalar_bar_args=args)
        assert scene.scalar_bars["Height"].GetNumberOfLabels() == 2
    assert args == {"title": "Height", "n_labels": 2}


def test_camera_fits_the_spheres_not_only_their_centers():
    scene = pv.Plotter(off_screen=True, window_size=(SIZE, SIZE))
    scene.packing.add(packing(1), color="white", lighting=False, radius=100.0)
    alpha = scene.screenshot(None, return_img=True, transparent_background=True)[..., 3]
    scene.close()
    assert alpha[0].max() == alpha[-1].max() == alpha[:, 0].max() == alpha[:, -1].max() == 0
    assert 0.2 < (alpha > 0).mean() < 0.9


def test_camera_that_is_set_stays():
    with plotter() as scene:
        before = scene.camera_position
        scene.packing.add(packing())
        scene.screenshot(None)
        scene.packing.add(packing(1))
        assert scene.camera_position == before


def test_named_arrays_stay_connected():
    mesh = packing(height=[0.0, 1.0, 2.0])
    with plotter() as scene:
        scene.packing.add(mesh, color="white", lighting=False)
        before = scene.screenshot(None, return_img=True)
        mesh["radius"] = [0.0, 0.5, 0.0]
        scene.render()
        after = scene.screenshot(None, return_img=True)
    assert (after > 0).sum() < (before > 0).sum() / 6


@pytest.mark.parametrize(
    "kwargs",
    [
        {},
        {"scalars": "height"},
        {"scalars": [3.0, 2.0, 1.0]},
        {"scalars": "velocity"},
        {"scalars": "kind"},
        {"scalars": np.array(RGB, np.uint8), "rgb": True},
        {"radius": [1.0, 2.0, 3.0]},
        {"opacity": [0.1, 0.2, 0.3]},
        {"scalars": "height", "opacity": [0.1, 0.2, 0.3]},
    ],
)
def test_the_packing_is_not_changed(kwargs):
    mesh = packing(height=[0.0, 1.0, 2.0], velocity=np.eye(3), kind=["a", "b", "a"])
    mesh.set_active_scalars("height")
    before, keys = mesh.copy(), mesh.point_data.keys()
    with plotter() as scene:
        scene.packing.add(mesh, **kwargs)
        scene.screenshot(None)
    assert mesh.point_data.keys() == keys
    assert mesh == before
    assert mesh.active_scalars_name == "height"


def test_two_actors_color_one_packing_differently():
    mesh = packing(1, low=[0.0], high=[1.0])
    with plotter() as scene:
        kwargs = {"cmap": ["red", "blue"], "clim": (0, 1), "lighting": False}
        move = np.eye(4)
        move[0, 3] = 3.0
        scene.packing.add(mesh, scalars="low", show_scalar_bar=False, **kwargs)
        scene.packing.add(mesh, scalars="high", show_scalar_bar=False, user_matrix=move, **kwargs)
        picture = scene.screenshot(None, return_img=True)
    assert close(picture[50, 50], RED)
    assert close(picture[50, 80], BLUE)


# --- lifetime -------------------------------------------------------------------------------------


def test_everything_goes_with_the_plotter():
    mesh = packing(height=[0, 1, 2])
    with plotter() as scene:
        actor = scene.packing.add(mesh, scalars="height", radius=[1.0, 2.0, 1.0])
        scene.screenshot(None)
        watched = [weakref.ref(thing) for thing in (actor, actor.mapper, scene.packing)]
    del actor, scene
    gc.collect()
    assert [ref() for ref in watched] == [None] * 3


def test_mapper_copies():
    with plotter() as scene:
        actor = scene.packing.add(packing(half=np.full(3, 0.5)), radius="half")
        copy = actor.copy()
        assert copy.mapper.GetRadiusArrayName() == "half"
        assert copy.bounds == actor.bounds
