"""The cell of a packing: wrapping, copies, images, its edges, and contacts from Python."""

import numpy as np
import pytest
import pyvista as pv
import spherepacking
from spherepacking.granular.cell import find_cell

TILTED = np.array([[4.0, 0, 0], [1.5, 5, 0], [-1, 2, 6]])


def packing_of(points, radius=0.5, vectors=None, origin=(0, 0, 0), periodic=(1, 1, 1)):
    packing = pv.PolyData(np.array(points, float))
    packing["radius"] = np.broadcast_to(np.asarray(radius, float), packing.n_points).copy()
    if vectors is not None:
        packing.field_data["cell_vectors"] = np.asarray(vectors, float)
        packing.field_data["cell_origin"] = np.asarray(origin, float)
        packing.field_data["cell_periodic"] = np.asarray(periodic, np.uint8)
    return packing


def with_text(packing, texts):
    array = pv._vtk.vtkStringArray()
    array.SetName("name")
    for text in texts:
        array.InsertNextValue(text)
    packing.GetPointData().AddArray(array)


def texts_of(packing):
    array = packing.GetPointData().GetAbstractArray("name")
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())]


# --- wrap -----------------------------------------------------------------------------------------


def test_wrap_moves_what_is_outside():
    packing = packing_of([[1, 2, 3], [-1, 2, 3], [9, -11, 6]], vectors=np.diag([4, 5, 6]))
    before = packing.points.copy()
    wrapped = packing.packing.wrap()
    assert wrapped.points.tolist() == [[1, 2, 3], [3, 2, 3], [1, 4, 0]]
    assert wrapped["image"].tolist() == [[0, 0, 0], [-1, 0, 0], [2, -3, 1]]
    assert np.array_equal(packing.points, before)
    assert "image" not in packing.point_data


@pytest.mark.parametrize("periodic", [(1, 1, 1), (1, 0, 1), (0, 1, 0), (0, 0, 0)])
def test_wrap_in_a_tilted_cell(rng, periodic):
    origin = np.array([7.0, -3, 2])
    packing = packing_of(
        rng.uniform(-30, 30, (500, 3)), vectors=TILTED, origin=origin, periodic=periodic
    )
    wrapped = packing.packing.wrap()
    fractions = np.linalg.solve(TILTED.T, (wrapped.points - origin).T).T
    inside = fractions[:, np.array(periodic, bool)]
    assert ((inside >= -1e-12) & (inside < 1 + 1e-12)).all()
    assert not wrapped["image"][:, ~np.array(periodic, bool)].any()
    back = wrapped.points + wrapped["image"] @ TILTED
    assert np.allclose(back, packing.points, atol=1e-12)
    again = wrapped.packing.wrap()
    assert np.array_equal(again.points, wrapped.points)
    assert np.array_equal(again["image"], wrapped["image"])


def test_a_centre_just_below_a_face_does_not_end_on_the_other():
    wrapped = packing_of([[-1e-18, 0, 0]], vectors=np.eye(3)).packing.wrap()
    assert wrapped.points.tolist() == [[0, 0, 0]]


def test_flags_go_on_counting():
    packing = packing_of([[5, 0, 0]], vectors=4 * np.eye(3))
    for axis in "xyz":
        packing[f"i{axis}"] = [10.0]
    packing["image"] = np.array([[10, 10, 10]])
    wrapped = packing.packing.wrap()
    assert wrapped["image"].tolist() == [[11, 10, 10]]
    assert [wrapped[f"i{axis}"][0] for axis in "xyz"] == [11, 10, 10]
    assert packing["ix"][0] == 10 and packing["image"].tolist() == [[10, 10, 10]]


def test_wrap_keeps_precision_and_active_scalars():
    packing = pv.PolyData(np.array([[5, 0, 0]], np.float32))
    packing["radius"] = np.ones(1)
    packing.field_data["cell_vectors"] = 4 * np.eye(3)
    packing.set_active_scalars("radius")
    wrapped = packing.packing.wrap()
    assert wrapped.points.dtype == np.float32
    assert wrapped.active_scalars_name == "radius"
    assert wrapped.field_data["cell_vectors"].tolist() == (4 * np.eye(3)).tolist()


# --- replicate ------------------------------------------------------------------------------------


def test_replicate_puts_copies_along_the_vectors(rng):
    packing = packing_of(rng.random((5, 3)) @ TILTED, 0.1, TILTED, (1, 2, 3), (1, 0, 1))
    packing["id"] = np.arange(5)
    with_text(packing, "aäb😀c")
    more = packing.packing.replicate(2, 1, 3)
    assert more.n_points == more.n_verts == 30
    assert np.allclose(more.points, np.tile(packing.points, (6, 1)) + more["cell_shift"] @ TILTED)
    assert np.array_equal(np.unique(more["cell_shift"], axis=0), more["cell_shift"][::5])
    assert more["cell_shift"].max(axis=0).tolist() == [1, 0, 2]
    assert np.array_equal(more["id"], np.tile(np.arange(5), 6))
    assert texts_of(more) == list("aäb😀c") * 6
    cell = find_cell(more)
    assert np.array_equal(cell.vectors, TILTED * [[2], [1], [3]])
    assert cell.origin.tolist() == [1, 2, 3] and cell.periodic.tolist() == [True, False, True]
    assert np.array_equal(find_cell(packing).vectors, TILTED)


def test_a_replica_has_as_many_contacts_a_sphere(rng):
    packing = packing_of(rng.random((40, 3)) @ TILTED, rng.uniform(0.1, 0.8, 40), TILTED)
    one = packing.packing.coordination()
    eight = packing.packing.replicate(2, 2, 2).packing.coordination()
    assert one.any()
    # Rounding of the copies' coordinates decides nothing here: no two surfaces are that close.
    assert np.array_equal(eight, np.tile(one, 8))


def test_replicate_drops_counts_of_another_cell():
    packing = packing_of([[5, 0, 0]], vectors=4 * np.eye(3)).packing.wrap()
    assert "image" not in packing.packing.replicate(2).point_data
    assert packing.packing.replicate().points.tolist() == packing.points.tolist()


@pytest.mark.parametrize(("counts", "error"), [((0, 1, 1), ValueError), ((1.5, 1, 1), TypeError)])
def test_counts_are_whole_numbers(counts, error):
    with pytest.raises(error, match="nx: found"):
        packing_of([[0, 0, 0]], vectors=np.eye(3)).packing.replicate(*counts)


def test_more_copies_than_can_be_numbered():
    packing = packing_of(np.zeros((3000, 3)), vectors=np.eye(3))
    with pytest.raises(ValueError, match="nx, ny, nz: found 1000000 copies of 3000 spheres"):
        packing.packing.replicate(100, 100, 100)
    # The list of copies alone would fill any memory.
    single = packing_of([[0, 0, 0]], vectors=np.eye(3))
    with pytest.raises(ValueError, match="found 1000000000000000000 copies of 1 spheres"):
        single.packing.replicate(10**6, 10**6, 10**6)
    none = packing_of(np.empty((0, 3)), vectors=np.eye(3))
    with pytest.raises(ValueError, match="found 1000000000000000000 copies of 0 spheres"):
        none.packing.replicate(10**6, 10**6, 10**6)


# --- ghosts ---------------------------------------------------------------------------------------


def test_a_sphere_at_a_corner_has_seven_images():
    packing = packing_of([[0, 0, 0], [5, 5, 5]], 1.0, 10 * np.eye(3))
    packing.set_active_scalars("radius")
    ghosts = packing.packing.ghosts()
    assert ghosts.n_points == ghosts.n_verts == 9
    assert ghosts["ghost"].tolist() == 2 * [False] + 7 * [True]
    assert {tuple(p) for p in ghosts.points[2:]} == {
        (x, y, z) for x in (0, 10) for y in (0, 10) for z in (0, 10)
    } - {(0, 0, 0)}
    assert ghosts.active_scalars_name == "radius"


def test_only_spheres_that_cross_a_periodic_face_have_images():
    points = [[0.5, 5, 5], [0.4, 5, 5], [9.6, 5, 5], [5, 0.1, 5]]
    packing = packing_of(points, 0.5, 10 * np.eye(3), periodic=(1, 0, 0))
    ghosts = packing.packing.ghosts()
    assert ghosts.points[4:].tolist() == [[-0.4, 5, 5], [10.4, 5, 5]] or np.allclose(
        ghosts.points[4:], [[-0.4, 5, 5], [10.4, 5, 5]]
    )
    assert ghosts["cell_shift"][4:].tolist() == [[-1, 0, 0], [1, 0, 0]]


@pytest.mark.parametrize("radius", [0.3, 2.5])
def test_with_ghosts_the_cell_is_as_full_as_in_the_middle_of_many(rng, radius):
    # Any point of the cell is in as many spheres as it is in an endless packing.
    packing = packing_of(rng.random((30, 3)) @ TILTED, radius, TILTED)
    ghosts = packing.packing.ghosts()
    many = packing.packing.replicate(5, 5, 5)
    probes = rng.random((300, 3)) @ TILTED

    def depth(packing, points):
        distances = np.linalg.norm(packing.points[None] - points[:, None], axis=2)
        return (distances < packing["radius"]).sum(axis=1)

    middle = probes + np.array([2, 2, 2]) @ TILTED
    assert np.array_equal(depth(ghosts, probes), depth(many, middle))
    assert ghosts.n_points > 30


def test_too_many_images():
    packing = packing_of([[0, 0, 0]], 1.0, 0.01 * np.eye(3))
    with pytest.raises(ValueError, match="found spheres that need images from"):
        packing.packing.ghosts()


# --- contacts -------------------------------------------------------------------------------------


def test_contacts_take_the_cell_as_it_is_or_as_asked():
    packing = packing_of([[0.5, 5, 5], [9.5, 5, 5]], vectors=10 * np.eye(3), periodic=(1, 0, 0))
    assert packing.packing.contacts().n_lines == 1
    assert packing.packing.contacts(periodic=True).n_lines == 1
    assert packing.packing.contacts(periodic=False).n_lines == 0
    assert packing.packing.contacts(periodic=(False, True, True)).n_lines == 0
    assert packing.packing.contacts(periodic=[True, False, False]).n_lines == 1
    assert packing.field_data["cell_periodic"].tolist() == [1, 0, 0]
    assert packing.packing.coordination().tolist() == [1, 1]
    assert packing.packing.coordination(periodic=False).tolist() == [0, 0]
    packing["coordination"] = packing.packing.coordination()
    assert packing["coordination"].tolist() == [1, 1]


def test_contacts_without_a_cell():
    packing = packing_of([[0, 0, 0], [1, 0, 0]])
    assert packing.packing.contacts(periodic=False).n_lines == 1
    with pytest.raises(ValueError, match="packing: found no cell"):
        packing.packing.contacts(periodic=True)


def test_an_apollonian_packing_touches_all_over():
    packing = spherepacking.apollonian(2)
    lines = packing.packing.contacts(gap=1e-12)
    assert np.abs(lines.cell_data["gap"]).max() < 1e-12
    assert packing.packing.coordination(gap=1e-12).min() >= 3


def test_text_rides_along_to_images():
    packing = packing_of([[0.5, 5, 5], [9.5, 5, 5]], vectors=10 * np.eye(3))
    with_text(packing, ["ä b", "c"])
    assert texts_of(packing.packing.contacts()) == ["ä b", "c", "c"]


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ({"gap": np.nan}, ValueError, "gap: found nan"),
        ({"gap": "0"}, ValueError, "gap: found '0'"),
        ({"periodic": 1}, TypeError, "periodic: found 1"),
        ({"periodic": (True, False)}, TypeError, "periodic: found"),
        ({"progress": 1}, TypeError, "progress: found 1"),
    ],
)
def test_arguments_of_contacts(arguments, error, message):
    packing = packing_of([[0, 0, 0]], vectors=np.eye(3))
    with pytest.raises(error, match=message):
        packing.packing.contacts(**arguments)


def test_too_many_contacts_are_an_error_and_no_crash():
    # 3e5 spheres in one place have 4.5e10 contacts. Not under the sanitizers, for which half of the
    # memory is too much.
    with pytest.raises(ValueError, match=r"found more than .* contacts within 0, which do not fit"):
        packing_of(np.zeros((300_000, 3))).packing.contacts()


def test_contacts_need_radii():
    with pytest.raises(KeyError, match="radius"):
        pv.PolyData(np.zeros((2, 3))).packing.contacts()


def test_any_dataset_has_contacts():
    grid = pv.ImageData(dimensions=(3, 3, 3))
    assert grid.packing.contacts(radius=0.5).n_lines == 54
    assert grid.packing.coordination(radius=0.5).tolist().count(6) == 1
    grid.field_data["cell_vectors"] = 3 * np.eye(3)
    assert grid.packing.coordination(radius=0.5).tolist() == 27 * [6]
    assert grid.packing.replicate(2).n_points == 54
    assert grid.packing.wrap().n_points == 27
    assert grid.packing.ghosts(radius=0.5).n_points == 64
    assert grid.packing.cell_outline().length == pytest.approx(3 * 3**0.5)


# --- cells that are none --------------------------------------------------------------------------


@pytest.mark.parametrize("method", ["wrap", "replicate", "ghosts", "cell_outline"])
def test_without_a_cell(method):
    with pytest.raises(ValueError, match="packing: found no cell, expected the field array"):
        getattr(packing_of([[0, 0, 0]]).packing, method)()


@pytest.mark.parametrize("method", ["wrap", "replicate", "ghosts", "contacts"])
@pytest.mark.parametrize(
    ("name", "values"),
    [
        ("cell_vectors", np.eye(2)),
        ("cell_vectors", np.full((3, 3), np.nan)),
        ("cell_vectors", np.ones((3, 3))),
        ("cell_vectors", np.diag([1.0, 1.0, 0.0])),
        ("cell_origin", np.zeros(2)),
        ("cell_periodic", np.ones(1)),
    ],
)
def test_arrays_that_hold_no_cell(method, name, values):
    packing = packing_of([[0, 0, 0]], vectors=np.eye(3))
    packing.field_data[name] = values
    with pytest.raises(ValueError, match=name):
        getattr(packing.packing, method)()


@pytest.mark.parametrize("method", ["wrap", "replicate", "ghosts", "contacts"])
def test_an_empty_packing(method):
    packing = packing_of(np.empty((0, 3)), vectors=np.eye(3))
    assert getattr(packing.packing, method)().n_points == 0


def test_a_flat_cell():
    flat = np.array([[4.0, 0, 0], [1, 4, 0], [0, 0, 0]])
    packing = packing_of([[5.0, 5, 3]], vectors=flat, periodic=(1, 1, 0))
    assert np.allclose(packing.packing.wrap().points, [[4, 1, 3]])


# --- in a plotter ---------------------------------------------------------------------------------


def test_the_edges_of_a_cell():
    packing = packing_of([[0, 0, 0]], vectors=TILTED, origin=(1, 2, 3))
    edges = packing.packing.cell_outline()
    assert edges.n_points == 8 and edges.n_lines == 12
    ends = edges.points[edges.lines.reshape(-1, 3)[:, 1:]]
    lengths = np.sort(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1))
    assert np.allclose(lengths, np.sort(np.repeat(np.linalg.norm(TILTED, axis=1), 4)))
    assert (edges.points == [1, 2, 3]).all(axis=1).any()
    opposite = np.array([1, 2, 3]) + TILTED.sum(axis=0)
    assert np.isclose(edges.points, opposite).all(axis=1).any()


@pytest.fixture
def plotter():
    plotter = pv.Plotter(off_screen=True, window_size=(200, 200))
    yield plotter
    plotter.close()


def test_show_cell(plotter):
    packing = packing_of([[5, 5, 5]], 0.5, 10 * np.eye(3))
    plotter.packing.add(packing, color="white", show_cell="red", name="balls")
    assert len(plotter.actors) == 2
    assert plotter.bounds[:2] == (0, 10)
    picture = plotter.screenshot()
    assert (picture == [255, 0, 0]).all(axis=2).any()
    plotter.packing.add(packing, color="white", show_cell=True, name="balls")
    assert len(plotter.actors) == 2
    plotter.packing.add(packing, color="white", name="balls")
    assert len(plotter.actors) == 1


def test_the_cell_is_where_the_spheres_are(plotter):
    packing = packing_of([[0.5, 0.5, 0.5]], 0.5, np.eye(3))
    plotter.packing.add(packing, show_cell=True, user_matrix=pv.Transform().translate([5, 0, 0]))
    assert np.allclose(plotter.bounds, (5, 6, 0, 1, 0, 1))


@pytest.mark.parametrize(
    ("show_cell", "message"), [(True, "packing: found no cell"), ("no colour", "show_cell: found")]
)
def test_what_cannot_be_shown_changes_nothing(plotter, show_cell, message):
    with pytest.raises(ValueError, match=message):
        plotter.packing.add(packing_of([[0, 0, 0]]), show_cell=show_cell)
    assert not plotter.actors


def test_a_live_picture_has_a_cell(plotter):
    packing = packing_of([[5, 5, 5]], 0.5, 10 * np.eye(3))
    plotter.packing.path_trace(packing, samples=1, show_cell="red")
    plotter.show(auto_close=False)
    assert (plotter.screenshot() == [255, 0, 0]).all(axis=2).any()


def test_contacts_as_tubes(plotter):
    packing = packing_of([[0, 0, 0], [0.9, 0, 0], [0, 3, 0]])
    actor = plotter.packing.add_contacts(packing, tube_radius=0.1)
    assert plotter.bounds == pytest.approx((0, 0.9, -0.1, 0.1, -0.1, 0.1))
    assert actor.mapper.array_name == "gap"
    colored = plotter.packing.add_contacts(packing, scalars="overlap", cmap="hot")
    assert colored.mapper.array_name == "overlap"
    plotter.packing.add_contacts(packing, color="orange", name="tubes")
    assert "tubes" in plotter.actors


def test_no_contacts_no_tubes(plotter):
    plotter.packing.add_contacts(packing_of([[0, 0, 0]]))
    plotter.packing.add_contacts(packing_of(np.empty((0, 3))), color="red")


def test_tubes_have_a_radius(plotter):
    with pytest.raises(ValueError, match="tube_radius: found 0, expected a number above 0"):
        plotter.packing.add_contacts(packing_of([[0, 0, 0]]), tube_radius=0)
