"""``packing.metaball_field``, ``packing.metaballs`` and ``plotter.packing.add_metaballs``."""

import signal
import threading
import warnings

import matplotlib as mpl
import numpy as np
import pytest
import pyvista as pv
import spherepacking
from spherepacking.testing.fields import exact_sums
from spherepacking.testing.scenes import knot_tube

KERNELS = ("inverse", "inverse_square", "gaussian", "wyvill")


@pytest.fixture
def packing():
    return knot_tube(300)


def one_sphere(center=(0.1, 0.2, 0.3), radius=0.7):
    sphere = pv.PolyData([center])
    sphere["radius"] = [radius]
    return sphere


def volume_of(surface):
    """By the divergence theorem: negative where triangles face inwards."""
    a, b, c = (np.asarray(surface.points, float)[surface.regular_faces[:, i]] for i in range(3))
    return np.einsum("ij,ij->", a, np.cross(b, c)) / 6


def edges_are_shared_by_two(surface):
    faces = surface.regular_faces
    edges = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
    _, number = np.unique(edges, axis=0, return_counts=True)
    return (number == 2).all()


# Surfaces ------------------------------------------------------------------------------------


@pytest.mark.parametrize("kernel", KERNELS)
def test_one_sphere_is_its_own_surface(kernel):
    """The error of its radius falls with the square of the grid's step."""
    sphere = one_sphere()
    errors = []
    for count in (16, 32, 64):
        surface = sphere.packing.metaballs(1.0, kernel=kernel, dimensions=count)
        away = np.asarray(surface.points, float) - sphere.points[0]
        distance = np.linalg.norm(away, axis=1, keepdims=True)
        errors.append(np.abs(distance - 0.7).max())
        assert volume_of(surface) == pytest.approx(4 / 3 * np.pi * 0.7**3, rel=20 / count**2 * 4)
        assert ((surface["Normals"] * away / distance).sum(axis=1) > 1 - 10 / count**2).all()
    assert errors[0] < 0.05
    assert errors[1] < errors[0] / 2.5
    assert errors[2] < errors[1] / 2.5


def test_one_sphere_far_away_and_small():
    """Coordinates in double precision keep it round."""
    sphere = one_sphere((1e5, -1e5, 2e5), 1e-3)
    sphere.points = np.array([[1e5, -1e5, 2e5]])
    field = sphere.packing.metaball_field(33, threshold=1.0)
    index = np.indices(field.dimensions[::-1]).reshape(3, -1)[::-1].T
    points = np.array(field.origin) + index * np.array(field.spacing)
    distance = np.linalg.norm(points - sphere.points[0], axis=1)
    expected = 1e-3 / np.maximum(distance, 1e-3 / 1024)
    np.testing.assert_allclose(field["field"], expected, rtol=1e-3)


@pytest.mark.parametrize("kernel", KERNELS)
@pytest.mark.parametrize("threshold", [0.5, 3.0])
def test_surfaces_are_closed_and_face_outwards(packing, kernel, threshold):
    surface = packing.packing.metaballs(threshold, kernel=kernel, dimensions=40)
    assert edges_are_shared_by_two(surface)
    assert surface.n_open_edges == 0
    assert volume_of(surface) > 0
    # Out of what is above the threshold: against the gradient of the field.
    cells = surface.compute_normals(
        point_normals=False, auto_orient_normals=False, consistent_normals=False
    )
    corners = surface["Normals"][surface.regular_faces].mean(axis=1)
    facing = (cells.cell_data["Normals"] * corners).sum(axis=1)
    assert np.mean(facing > 0) > 0.97


@pytest.mark.parametrize("offset", [0.0, 1e7])
@pytest.mark.parametrize("radius", [1.0, 0.05])
def test_surfaces_far_from_the_origin(offset, radius):
    """Points are as exact as the field."""
    sphere = one_sphere((0.0, 0.0, 0.0), radius)
    sphere.points = np.array([[offset, -offset, offset]])
    surface = sphere.packing.metaballs(1.0, dimensions=32)
    distance = np.linalg.norm(surface.points - sphere.points[0], axis=1)
    # A straight line through two values of r / d, h apart, is off by h^2 / 4 r there.
    assert np.abs(distance / radius - 1).max() < 1.1 * (2.1 / 31) ** 2 / 4
    moved = surface.translate(-sphere.points[0])
    assert volume_of(moved) == pytest.approx(4 / 3 * np.pi * radius**3, rel=1e-2)


def hard_packings():
    rng = np.random.default_rng(5)
    spread = rng.uniform(-1, 1, (200, 3))
    yield "coincident", np.zeros((20, 3)), np.full(20, 0.3)
    yield "concentric", np.zeros((5, 3)), np.linspace(0.1, 1, 5)
    yield "touching", [[-1, 0, 0], [1, 0, 0]], [1, 1]
    yield "ratio 1e6", spread, np.where(np.arange(200) < 3, 0.5, 5e-7)
    yield "far away", 1e7 + spread, np.full(200, 0.1)
    yield "in a plane", spread * [1, 1, 0], np.full(200, 0.1)


@pytest.mark.parametrize("kernel", KERNELS)
@pytest.mark.parametrize("case", list(hard_packings()), ids=lambda case: case[0])
def test_surfaces_of_hard_packings(case, kernel):
    _, centers, radii = case
    packing = pv.PolyData(np.asarray(centers, float), force_float=False)
    packing["radius"] = np.asarray(radii, float)
    surface = packing.packing.metaballs(0.8, kernel=kernel, dimensions=30, coloring=None)
    assert surface.n_cells > 0
    assert edges_are_shared_by_two(surface)
    assert volume_of(surface.translate(-np.mean(packing.points, axis=0))) > 0


def test_two_touching_spheres_grow_together():
    pair = pv.PolyData([[-1.0, 0, 0], [1.0, 0, 0]])
    pair["radius"] = [1.0, 1.0]
    together = pair.packing.metaballs(1.5, dimensions=48)
    assert together.split_bodies().n_blocks == 1
    apart = pair.packing.metaballs(2.5, dimensions=48)
    assert apart.split_bodies().n_blocks == 2


def test_concentric_spheres_add_up():
    spheres = pv.PolyData(np.zeros((3, 3)))
    spheres["radius"] = [0.5, 0.3, 0.2]
    surface = spheres.packing.metaballs(1.0, dimensions=65)
    distance = np.linalg.norm(surface.points, axis=1)
    assert np.abs(distance - 1.0).max() < 2e-3


def test_normals_are_those_of_the_field(packing):
    surface = packing.packing.metaballs(20.0, dimensions=64)
    chosen = np.random.default_rng(0).integers(0, surface.n_points, 200)
    _, gradient = exact_sums(packing, np.asarray(surface.points, float)[chosen], 1)
    expected = -gradient / np.linalg.norm(gradient, axis=1, keepdims=True)
    cosine = (surface["Normals"][chosen] * expected).sum(axis=1)
    assert np.median(cosine) > 0.999
    assert cosine.min() > 0.8
    np.testing.assert_allclose(np.linalg.norm(surface["Normals"], axis=1), 1.0, rtol=1e-5)


def test_surface_lies_on_the_threshold(packing):
    """To second order in the grid's spacing, as it is made of straight triangles."""
    errors = []
    for count in (40, 80):
        surface = packing.packing.metaballs(20.0, dimensions=count)
        chosen = np.random.default_rng(0).integers(0, surface.n_points, 300)
        value, gradient = exact_sums(packing, np.asarray(surface.points, float)[chosen], 1)
        errors.append(np.median(np.abs(value - 20.0) / np.linalg.norm(gradient, axis=1)))
    assert errors[1] < errors[0] / 2.5


@pytest.mark.parametrize("threshold", [1e6, 1e-9])
def test_an_empty_surface_is_said_to_be_empty(packing, threshold):
    bounds = packing.packing.bounds
    with pytest.warns(UserWarning, match="metaballs: the threshold .* so the surface is empty"):
        surface = packing.packing.metaballs(threshold, dimensions=10, bounds=bounds)
    assert surface.n_points == surface.n_cells == 0


def test_weights_of_0_have_no_surface():
    with pytest.warns(UserWarning, match="the surface is empty"):
        assert one_sphere().packing.metaballs(1.0, dimensions=8, weights=[0]).n_cells == 0


def test_a_flat_grid_has_no_surface(packing):
    with pytest.raises(ValueError, match=r"dimensions: found \(8, 8, 1\)"):
        packing.packing.metaballs(10.0, dimensions=(8, 8, 1))


def test_no_spheres_have_no_surface():
    with pytest.warns(UserWarning, match="the surface is empty"):
        assert pv.PolyData().packing.metaballs(1.0, dimensions=8).n_cells == 0


# Colours -------------------------------------------------------------------------------------


def test_blend_is_between_the_colors():
    pair = pv.PolyData([[-1.0, 0, 0], [1.0, 0, 0]])
    pair["radius"] = [1.0, 1.0]
    pair["paint_rgb"] = np.array([[255, 0, 0], [0, 0, 255]], np.uint8)
    surface = pair.packing.metaballs(1.2, dimensions=48, scalars="paint_rgb")
    points = np.asarray(surface.points, float)
    near, far = (1 / np.linalg.norm(points - center, axis=1) for center in pair.points)
    share = near / (near + far)
    assert np.abs(surface["color"][:, 0] - 255 * share).max() < 3
    assert np.abs(surface["color"][:, 2] - 255 * (1 - share)).max() < 3
    assert (surface["color"][:, 1] == 0).all()


def test_strongest_is_the_nearer_of_equals():
    pair = pv.PolyData([[-1.0, 0, 0], [1.0, 0, 0]])
    pair["radius"] = [1.0, 1.0]
    pair["paint_rgb"] = np.array([[255, 0, 0], [0, 0, 255]], np.uint8)
    surface = pair.packing.metaballs(1.2, dimensions=48, scalars="paint_rgb", coloring="strongest")
    x = surface.points[:, 0]
    sure = np.abs(x) > 0.1
    assert (surface["sphere_id"][sure] == (x[sure] > 0)).all()
    assert (surface["color"] == pair["paint_rgb"][surface["sphere_id"]]).all()


def test_strongest_is_somebody_on_a_coarse_grid():
    """Also where the nearest grid point is one that nothing reaches."""
    pair = pv.PolyData([[0.0, 0, 0], [50, 0, 0]])
    pair["radius"] = [1.0, 1.0]
    pair["paint_rgb"] = np.array([[255, 0, 0], [0, 0, 255]], np.uint8)
    kwargs = {"coloring": "strongest", "scalars": "paint_rgb", "kernel": "wyvill"}
    surface = pair.packing.metaballs(0.01, dimensions=(160, 12, 12), **kwargs)
    assert surface.n_points
    assert (surface["sphere_id"] == (surface.points[:, 0] > 25)).all()


def test_colors_are_those_of_the_plotter(packing):
    one = packing.extract_points([0], include_cells=False)
    one = pv.PolyData(one.points, force_float=False)
    one["radius"] = [0.5]
    one.point_data.active_scalars_name = "radius"
    surface = one.packing.metaballs(1.0, dimensions=24, cmap="viridis", clim=(0, 1))
    expected = np.round(255 * np.array(mpl.colormaps["viridis"](0.5)[:3]))
    assert np.abs(surface["color"].astype(int) - expected).max() <= 2


@pytest.mark.parametrize("kwargs", [{"coloring": None}, {"color": "red"}])
def test_without_colors(packing, kwargs):
    surface = packing.packing.metaballs(10.0, dimensions=24, **kwargs)
    assert "color" not in surface.point_data


# Fields and arguments ------------------------------------------------------------------------


def test_field_has_what_is_asked_for(packing):
    image = packing.packing.metaball_field((8, 9, 10))
    assert image.dimensions == (8, 9, 10)
    assert image.point_data.keys() == ["field"]
    assert image.active_scalars_name == "field"
    kwargs = {"gradient": True, "strongest": True, "blend": True}
    image = packing.packing.metaball_field(spacing=0.4, **kwargs)
    assert set(image.point_data.keys()) == {"field", "gradient", "strongest", "blend"}
    assert image.spacing == (0.4, 0.4, 0.4)


def test_packing_is_not_changed(packing):
    before = packing.copy()
    packing.packing.metaballs(10.0, dimensions=16)
    packing.packing.metaball_field(8, blend=True)
    assert packing == before


BAD = [
    ({"dimensions": 0}, ValueError, "dimensions: found 0"),
    ({"dimensions": (4, 4)}, ValueError, "dimensions: found"),
    ({"dimensions": 4.5}, TypeError, "dimensions: found 4.5"),
    ({"dimensions": 10**6}, ValueError, "dimensions: found"),
    ({"dimensions": 4, "spacing": 1.0}, ValueError, "dimensions: found 4 and spacing=1.0"),
    ({"spacing": 0.0}, ValueError, "spacing: found"),
    ({"spacing": (1, 2)}, ValueError, "spacing: found"),
    ({"spacing": np.nan}, ValueError, "spacing: found"),
    ({"kernel": "cubic"}, ValueError, "kernel: found 'cubic'"),
    ({"weights": [1, np.nan]}, ValueError, "weights: found"),
    ({"weights": -1}, ValueError, "weights: found -1"),
    ({"weights": []}, ValueError, "weights: found"),
    ({"weights": "heavy"}, ValueError, "weights: found 'heavy'"),
    ({"weights": "12"}, ValueError, "weights: found '12'"),
    ({"weights": True}, ValueError, "weights: found True"),
    ({"weights": 10**400}, ValueError, "weights: found 1000"),
    ({"kernel": np.array(["a", "b"])}, ValueError, "kernel: found"),
    ({"dimensions": ((8,), 8, 8)}, TypeError, "dimensions: found"),
    ({"dimensions": None, "spacing": "0.1"}, ValueError, "spacing: found '0.1'"),
    ({"relative_error": False}, ValueError, "relative_error: found False"),
    ({"count": 0}, ValueError, "count: found 0"),
    ({"count": 1.5}, TypeError, "count: found 1.5"),
    ({"relative_error": -1}, ValueError, "relative_error: found -1"),
    ({"relative_error": 1e-5}, ValueError, "relative_error: found 1e-05"),
    ({"relative_error": np.nan}, ValueError, "relative_error: found nan"),
    ({"bounds": (0, 1, 0, 1)}, ValueError, "bounds: found"),
    ({"bounds": (1, 0, 0, 1, 0, 1)}, ValueError, "bounds: found"),
    ({"bounds": (0, np.inf, 0, 1, 0, 1)}, ValueError, "bounds: found"),
    ({"bounds": "abc"}, ValueError, "bounds: found 'abc'"),
    ({"spacing": "a"}, ValueError, "spacing: found 'a'"),
    ({"threshold": True}, ValueError, "threshold: found True"),
    ({"threshold": 1e-40}, ValueError, "threshold: found 1e-40"),
    ({"threshold": 0}, ValueError, "threshold: found 0"),
    ({"threshold": np.inf}, ValueError, "threshold: found inf"),
    ({"scalars": "mass"}, KeyError, "mass"),
    ({"progress": 1}, TypeError, "progress: found 1"),
]


@pytest.mark.parametrize(("kwargs", "error", "found"), BAD)
def test_refusals(packing, kwargs, error, found):
    given = kwargs if "spacing" in kwargs else {"dimensions": 4} | kwargs
    with pytest.raises(error, match=found):
        packing.packing.metaball_field(**given, blend=True)
    threshold = given.pop("threshold", 10.0)
    with pytest.raises(error, match=found):
        packing.packing.metaballs(threshold, **given)
    plotter = pv.Plotter(off_screen=True)
    if "progress" not in kwargs:
        with pytest.raises(error, match=found):
            plotter.packing.add_metaballs(packing, threshold, **given)
    assert not plotter.renderer.actors
    plotter.close()


def test_other_refusals(packing):
    with pytest.raises(ValueError, match="coloring: found 'random'"):
        packing.packing.metaballs(1.0, coloring="random")
    with pytest.raises(ValueError, match="dimensions: found None"):
        packing.packing.metaball_field()
    with pytest.raises(TypeError, match="gradient: found 1"):
        packing.packing.metaball_field(4, gradient=1)
    with pytest.raises(KeyError, match="radius"):
        pv.PolyData([[0.0, 0, 0]]).packing.metaballs(1.0)
    packing["radius"][0] = -1
    with pytest.raises(ValueError, match="radius"):
        packing.packing.metaball_field(4)


def test_ctrl_c_stops_it():
    packing = knot_tube(50_000)
    timer = threading.Timer(0.3, signal.raise_signal, [signal.SIGINT])
    timer.start()
    # Longer than the timer, by far.
    with pytest.raises(KeyboardInterrupt):
        packing.packing.metaball_field(256, relative_error=0.0)
    timer.join()


# In a plotter --------------------------------------------------------------------------------


@pytest.fixture
def plotter():
    made = pv.Plotter(off_screen=True, window_size=(120, 100))
    yield made
    made.close()


def picture(plotter):
    plotter.render()
    return np.asarray(plotter.screenshot(None, return_img=True)).astype(int)


OPTIONS = {"kernel": "inverse_square", "dimensions": 32}


def test_a_threshold_needs_no_new_field(plotter, packing):
    balls = plotter.packing.add_metaballs(packing, 8.0, **OPTIONS)
    before = picture(plotter)
    bounds = balls._field.bounds
    balls.threshold = 9.0
    assert balls.sums == 1
    expected = packing.packing.metaballs(9.0, bounds=bounds, **OPTIONS)
    assert np.abs(balls.surface.points - expected.points).max() < 1e-4
    assert np.abs(picture(plotter) - before).mean() > 0.1
    balls.threshold = 8.0
    assert balls.sums == 1
    assert (picture(plotter) == before).all()


@pytest.mark.parametrize("change", [{"threshold": 1.0}, {"weights": [0.01]}])
def test_a_surface_that_shrinks_gets_a_finer_grid(plotter, change):
    """It is as fine as one that was asked for in the first place."""
    first = 0.01 if "threshold" in change else 1.0
    balls = plotter.packing.add_metaballs(one_sphere(), first, dimensions=32)
    (name, value), *_ = change.items()
    setattr(balls, name, value)
    kwargs = {"threshold": first} | change
    expected = one_sphere().packing.metaballs(kwargs.pop("threshold"), dimensions=32, **kwargs)
    assert (balls.surface.points == expected.points).all()


def test_a_surface_that_grows_gets_a_larger_grid(plotter, packing):
    balls = plotter.packing.add_metaballs(packing, 10.0, **OPTIONS)
    balls.threshold = 0.5
    assert balls.sums == 2
    assert balls.surface.n_open_edges == 0
    assert balls.threshold == 0.5


def test_weights_reuse_the_fields_of_the_ranges(plotter, packing):
    balls = plotter.packing.add_metaballs(packing, 10.0, **OPTIONS)
    bounds = balls._field.bounds
    balls.weights = [1.0, 0.5, 0.2]
    sums = balls.sums
    assert sums == 4
    balls.weights = (0.9, 0.0, 0.6)
    assert balls.sums == sums
    assert balls.weights == (0.9, 0.0, 0.6)
    direct = packing.packing.metaballs(10.0, weights=(0.9, 0.0, 0.6), bounds=bounds, **OPTIONS)
    assert balls.surface.n_points == direct.n_points
    assert np.abs(balls.surface.points - direct.points).max() < 1e-2
    assert np.abs(balls.surface["color"].astype(int) - direct["color"]).mean() < 2


def test_weights_that_grow_find_room(plotter, packing):
    """A grid that a surface grew out of is followed by one with room, and by no waste of sums."""
    balls = plotter.packing.add_metaballs(packing, 10.0, weights=[1, 1, 1, 1], **OPTIONS)
    balls.weights = [1.2, 1.2, 1.2, 1.2]
    assert balls.sums == 2
    balls.weights = [1.3, 1.2, 1.2, 1.2]
    assert balls.sums == 6
    balls.weights = [1.5, 1.5, 1.5, 1.4]
    assert balls.sums == 6
    assert balls.surface.n_open_edges == 0
    for weights in ([1000] * 4, [1] * 4, [1000] * 4):
        before = balls.sums
        balls.weights = weights
        assert balls.sums == before + 1


def test_surfaces_that_no_grid_fits_better(plotter):
    """A grid for Wyvill's kernel reaches to where it ends, however small the surface is."""
    balls = plotter.packing.add_metaballs(one_sphere(), 1.7, kernel="wyvill", dimensions=32)
    for threshold in (1.75, 1.8, 1.75):
        balls.threshold = threshold
        assert balls.surface.n_points
    assert balls.sums == 1


def test_weights_after_the_packing_changed(plotter, packing):
    """Fields of before and after are not mixed."""
    balls = plotter.packing.add_metaballs(packing, 5.0, weights=[1, 1], **OPTIONS)
    balls.weights = [1, 0.9]
    packing.points[0] = [9.0, 0.0, 0.0]
    packing.Modified()
    balls.weights = [0.9, 1]
    expected = packing.packing.metaballs(5.0, weights=[0.9, 1], **OPTIONS)
    assert (balls.surface.points == expected.points).all()


def test_weights_are_a_copy_and_can_be_taken_away(plotter, packing):
    weights = np.array([1.0, 2.0])
    balls = plotter.packing.add_metaballs(packing, 5.0, weights=weights, **OPTIONS)
    weights[:] = 7
    assert balls.weights == (1.0, 2.0)
    balls.weights = None
    assert balls.weights == ()
    balls.weights = balls.weights
    assert (balls.surface.points == packing.packing.metaballs(5.0, **OPTIONS).points).all()


def test_update_after_the_packing_changed(plotter, packing):
    balls = plotter.packing.add_metaballs(packing, 5.0, **OPTIONS)
    packing["radius"] *= 0.5
    balls.update()
    assert (balls.surface.points == packing.packing.metaballs(5.0, **OPTIONS).points).all()


def test_count(plotter, packing):
    balls = plotter.packing.add_metaballs(packing, 5.0, count=50, **OPTIONS)
    assert balls.count == 50
    balls.count = 5
    assert (balls.surface.points == packing.packing.metaballs(5.0, count=5, **OPTIONS).points).all()


@pytest.mark.parametrize(
    ("name", "value", "error"),
    [
        ("threshold", -1, ValueError),
        ("threshold", "high", ValueError),
        ("weights", [np.nan], ValueError),
        ("count", 0, ValueError),
        ("count", "all", TypeError),
    ],
)
def test_a_refused_change_changes_nothing(plotter, packing, name, value, error):
    balls = plotter.packing.add_metaballs(packing, 5.0, count=50, weights=[1, 2], **OPTIONS)
    before, points = getattr(balls, name), np.array(balls.surface.points)
    with pytest.raises(error, match=f"{name}: found"):
        setattr(balls, name, value)
    assert getattr(balls, name) == before
    assert (balls.surface.points == points).all()


def test_strongest_follows_weights(plotter, packing):
    balls = plotter.packing.add_metaballs(packing, 5.0, coloring="strongest", **OPTIONS)
    balls.weights = [0.0, 1.0]
    half = np.argsort(-packing["radius"], kind="stable")[150:]
    assert np.isin(balls.surface["sphere_id"], half).all()


def test_an_empty_surface_in_a_plotter(plotter, packing):
    with pytest.warns(UserWarning, match="the surface is empty"):
        balls = plotter.packing.add_metaballs(packing, 1e9, **OPTIONS)
    blank = picture(plotter)
    balls.threshold = 5.0
    plotter.reset_camera()
    assert np.abs(picture(plotter) - blank).mean() > 1


def test_names_replace(plotter, packing):
    for color in ("red", "blue"):
        plotter.packing.add_metaballs(packing, 5.0, color=color, name="balls", **OPTIONS)
    assert len(plotter.renderer.actors) == 1
    assert tuple(plotter.renderer.actors["balls"].prop.color.int_rgb) == (0, 0, 255)


def test_progress_is_shown(packing, capsys):
    packing.packing.metaball_field(8, progress=True)
    assert "summing the field" in capsys.readouterr().err


def test_saved_packings_keep_their_surface(packing, tmp_path):
    spherepacking.write(packing, tmp_path / "p.spheres")
    again = spherepacking.read(tmp_path / "p.spheres")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        one, other = (p.packing.metaballs(10.0, dimensions=24) for p in (packing, again))
    np.testing.assert_allclose(one.points, other.points, atol=1e-5)
