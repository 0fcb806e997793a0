"""``PolyData.packing``."""

import numpy as np
import pytest
import pyvista as pv
import spherepacking
from drawing import packing

if pv.version_info < (0, 49):
    # There, a dataset whose accessor has been used is never freed.
    pytestmark = pytest.mark.allow_leaks


def test_count_centers_radii():
    mesh = packing()
    assert mesh.packing.n_spheres == 3
    assert np.shares_memory(mesh.packing.centers, mesh.points)
    assert np.shares_memory(mesh.packing.radii, mesh["radius"])


def test_bounds_contain_the_spheres(rng):
    mesh = pv.PolyData(rng.normal(size=(1000, 3)))
    mesh["radius"] = rng.random(1000)
    low = (mesh.points - mesh["radius"][:, None]).min(axis=0)
    high = (mesh.points + mesh["radius"][:, None]).max(axis=0)
    expected = np.column_stack([low, high]).ravel()
    assert np.array(mesh.packing.bounds) == pytest.approx(expected, rel=1e-6)


def test_volume():
    mesh = packing()
    mesh["radius"] = [1.0, 2.0, 0.0]
    assert mesh.packing.volume == pytest.approx(4 / 3 * np.pi * 9)


def test_no_spheres():
    mesh = pv.PolyData()
    assert (mesh.packing.n_spheres, mesh.packing.volume) == (0, 0.0)
    assert mesh.packing.radii.shape == (0,)
    assert mesh.packing.bounds == mesh.bounds


@pytest.mark.parametrize("name", ["radii", "bounds", "volume"])
def test_no_radii(name):
    with pytest.raises(KeyError, match="radius: the packing has no point array 'radius'"):
        getattr(pv.PolyData(np.eye(3)).packing, name)


def test_save(tmp_path):
    mesh = packing()
    mesh.packing.save(tmp_path / "a.spheres")
    back = spherepacking.read(tmp_path / "a.spheres")
    assert np.array_equal(back.points, mesh.points)
    assert np.array_equal(back["radius"], mesh["radius"])


def test_plot_leaves_a_picture_and_no_window(tmp_path):
    path = tmp_path / "a.png"
    packing().packing.plot(
        off_screen=True,
        window_size=(120, 90),
        background="black",
        color="red",
        lighting=False,
        cpos="xy",
        screenshot=path,
    )
    picture = spherepacking.read_image(path)
    assert picture.shape[:2] == (90, 120)
    colors = {tuple(c) for c in picture[..., :3].reshape(-1, 3).tolist()}
    assert {(0, 0, 0), (255, 0, 0)} <= colors
    assert not pv.plotting.plotter._ALL_PLOTTERS


def test_plot_with_an_error_leaves_no_window():
    with pytest.raises(KeyError, match="radius: the packing has no point array"):
        pv.PolyData(np.eye(3)).packing.plot(off_screen=True)
    assert not pv.plotting.plotter._ALL_PLOTTERS


def test_plot_with_a_word_that_nobody_knows():
    with pytest.raises(TypeError, match="colour"):
        packing().packing.plot(off_screen=True, colour="red")
    assert not pv.plotting.plotter._ALL_PLOTTERS


def test_grid_boxes_contain_the_spheres():
    mesh = packing()
    boxes = mesh.packing.grid_boxes(3)
    assert boxes.bounds == pytest.approx(mesh.packing.bounds)
    assert boxes.n_cells == 6 * len(np.unique(boxes["box_id"]))
    lines = mesh.packing.grid_boxes(3, as_lines=True)
    assert lines.n_lines == 2 * boxes.n_cells
    assert mesh.packing.grid_boxes().cell_data["box_id"].max() < 7**3


def test_grid_boxes_of_an_empty_packing():
    assert pv.PolyData().packing.grid_boxes(2).n_cells == 0


@pytest.mark.parametrize(
    ("cuts", "error", "found"),
    [
        (-1, ValueError, "cuts: found -1, expected an integer from 0"),
        (2**40, ValueError, "cuts: found 1099511627776, expected an integer from 0"),
        (2**31 - 1, ValueError, "more cells than fit"),
        (1.5, TypeError, "cuts: found 1.5, expected an integer from 0"),
        ("7", TypeError, "cuts: found '7', expected an integer from 0"),
    ],
)
def test_grid_boxes_refuse(cuts, error, found):
    with pytest.raises(error, match=found):
        packing().packing.grid_boxes(cuts)


def test_grid_boxes_that_do_not_fit_in_memory():
    """A sphere in a cube touches more than half of 500 cells cubed."""
    mesh = pv.PolyData([0.0, 0.0, 0.0])
    mesh["radius"] = [1.0]
    with pytest.raises(ValueError, match=r"cuts: found 499, which makes \d+ boxes, more than"):
        mesh.packing.grid_boxes(499)


def test_grid_boxes_need_radii():
    with pytest.raises(KeyError, match="no point array 'radius'"):
        pv.PolyData(np.zeros((2, 3))).packing.grid_boxes(1)


def test_bvh_boxes_contain_the_spheres():
    mesh = spherepacking.apollonian(3)
    boxes = mesh.packing.bvh_boxes(7)
    assert boxes.n_cells == 6 * 7
    assert boxes.bounds == pytest.approx(mesh.packing.bounds)
    assert set(boxes.field_data["leaf_of_sphere"]) == set(boxes["box_id"])
    assert mesh.packing.bvh_boxes(7, as_lines=True).n_lines == 12 * 7
    assert mesh.packing.bvh_boxes(7, leaves_only=False).n_cells == 6 * 13
    assert mesh.packing.bvh_boxes().n_cells == 6 * 15
    assert mesh.packing.bvh_boxes(depth=0).n_cells == 6
    assert mesh.packing.bvh_boxes(depth=3)["depth"].max() == 3


def test_bvh_boxes_of_an_empty_packing():
    assert pv.PolyData().packing.bvh_boxes(2).n_cells == 0


@pytest.mark.parametrize(
    ("arguments", "error", "found"),
    [
        ({"boxes": 0}, ValueError, "boxes: found 0, expected an integer from 1"),
        ({"boxes": 2**31}, ValueError, "boxes: found 2147483648, expected an integer from 1"),
        ({"boxes": 1.5}, TypeError, "boxes: found 1.5, expected an integer from 1"),
        ({"depth": -1}, ValueError, "depth: found -1, expected an integer from 0"),
        ({"depth": "3"}, TypeError, "depth: found '3', expected an integer from 0"),
        ({"leaves_only": "x"}, TypeError, "leaves_only: found 'x', expected True or False"),
        ({"as_lines": None}, TypeError, "as_lines: found None, expected True or False"),
        ({"boxes": 7, "depth": 3}, ValueError, "depth: found 3 beside boxes=7, expected one"),
    ],
)
def test_bvh_boxes_refuse(arguments, error, found):
    with pytest.raises(error, match=found):
        packing().packing.bvh_boxes(**arguments)


def test_bvh_boxes_need_radii():
    with pytest.raises(KeyError, match="no point array 'radius'"):
        pv.PolyData(np.zeros((2, 3))).packing.bvh_boxes()
