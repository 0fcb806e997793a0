"""vtkSpherePackingContacts: exactly the pairs that brute force finds, on easy and hard packings."""

import itertools

import hypothesis
import hypothesis.strategies as st
import numpy as np
import pytest
import pyvista as pv
from arrays import packing_of
from spherepacking.backend import vtkSpherePackingContacts
from spherepacking.vtk_tools import ErrorLog

NO_VECTORS = np.zeros((3, 3))


def with_cell(packing, vectors, origin=(0, 0, 0), periodic=(1, 1, 1)):
    packing.field_data["cell_vectors"] = np.asarray(vectors, float)
    packing.field_data["cell_origin"] = np.asarray(origin, float)
    packing.field_data["cell_periodic"] = np.asarray(periodic, np.uint8)
    return packing


def contacts_of(packing, gap=0.0):
    finder = vtkSpherePackingContacts()
    finder.SetInputData(packing)
    finder.SetGap(gap)
    finder.Update()
    assert finder.GetErrorMessage() == ""
    return pv.wrap(finder.GetOutput())


def refusal(packing, gap=0.0):
    finder = vtkSpherePackingContacts()
    finder.SetInputData(packing)
    finder.SetGap(gap)
    with ErrorLog(finder):
        finder.Update()
    assert finder.GetErrorCode() != 0
    assert finder.GetOutput().GetNumberOfPoints() == 0
    return finder.GetErrorMessage()


def gaps_of(centers, radii, i, j, shift):
    d = (centers[j] - centers[i]) + shift
    squared = (d[:, 0] * d[:, 0] + d[:, 1] * d[:, 1]) + d[:, 2] * d[:, 2]
    return np.sqrt(squared) - (radii[i] + radii[j])


def brute_force(centers, radii, gap=0.0, vectors=NO_VECTORS, images=(0, 0, 0)):
    """Rows i, j, shift (3), and their gaps, from all pairs and all shifts up to `images`."""
    found, gaps = [], []
    n = len(radii)
    for shift in itertools.product(*(range(-most, most + 1) for most in images)):
        i, j = np.triu_indices(n, 0 if shift > (0, 0, 0) else 1)
        moved = (shift[0] * vectors[0] + shift[1] * vectors[1]) + shift[2] * vectors[2]
        distance = gaps_of(centers, radii, i, j, moved)
        near = distance <= gap
        rows = np.empty((near.sum(), 5), int)
        rows[:, 0], rows[:, 1], rows[:, 2:] = i[near], j[near], shift
        found.append(rows)
        gaps.append(distance[near])
    rows, gaps = np.concatenate(found), np.concatenate(gaps)
    order = np.lexsort(rows.T[::-1])
    return rows[order], gaps[order]


def check(centers, radii, gap=0.0):
    centers, radii = np.asarray(centers, float), np.asarray(radii, float)
    lines = contacts_of(packing_of(centers, radii), gap)
    rows, gaps = brute_force(centers, radii, gap)
    assert np.array_equal(np.column_stack([lines["i"], lines["j"]]), rows[:, :2])
    assert np.array_equal(lines.cell_data["gap"], gaps)
    assert np.array_equal(lines.cell_data["overlap"], np.maximum(-gaps, 0))
    assert np.array_equal(lines.lines.reshape(-1, 3)[:, 1:], rows[:, :2])
    assert np.array_equal(lines.points, centers)
    assert np.array_equal(
        lines["coordination"], np.bincount(rows[:, :2].ravel(), minlength=len(radii))
    )
    return lines


def check_periodic(
    centers, radii, vectors, images, *, gap=0.0, origin=(0, 0, 0), periodic=(1, 1, 1)
):
    centers, radii = np.asarray(centers, float), np.asarray(radii, float)
    vectors = np.asarray(vectors, float)
    lines = contacts_of(with_cell(packing_of(centers, radii), vectors, origin, periodic), gap)
    rows, gaps = brute_force(centers, radii, gap, vectors, images)
    # The images of the brute force are enough.
    assert all(
        np.abs(rows[:, 2 + k]).max(initial=0) < most or not most for k, most in enumerate(images)
    )
    found = np.column_stack([lines["i"], lines["j"], lines["cell_shift"]])
    assert np.array_equal(found, rows)
    assert np.array_equal(lines.cell_data["gap"], gaps)
    ends = lines.points[lines.lines.reshape(-1, 3)[:, 1:]]
    lengths = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    expected = gaps + radii[rows[:, 0]] + radii[rows[:, 1]]
    assert np.allclose(
        lengths, expected, rtol=1e-12, atol=1e-12 * np.abs(lines.points).max(initial=1)
    )
    n = len(radii)
    assert np.array_equal(lines["coordination"][:n], np.bincount(rows[:, :2].ravel(), minlength=n))
    assert np.array_equal(lines["radius"][n:], radii[rows[(rows[:, 2:] != 0).any(axis=1), 1]])
    return lines


# --- by hand --------------------------------------------------------------------------------------


def test_two_spheres_that_overlap_and_one_apart():
    lines = check([[0, 0, 0], [1.5, 0, 0], [0, 4, 0]], [1, 1, 2])
    assert lines["i"].tolist() == [0] and lines["j"].tolist() == [1]
    assert lines.cell_data["gap"].tolist() == [-0.5]
    assert lines.cell_data["overlap"].tolist() == [0.5]
    assert lines["coordination"].tolist() == [1, 1, 0]


def test_a_gap_lets_spheres_touch_that_are_apart():
    lines = check([[0, 0, 0], [1.5, 0, 0], [0, 4, 0]], [1, 1, 2], gap=1.0)
    assert lines.cell_data["gap"].tolist() == [-0.5, 1.0]
    assert lines.cell_data["overlap"].tolist() == [0.5, 0.0]


def test_a_negative_gap_asks_for_overlap():
    centers = [[0, 0, 0], [1.5, 0, 0], [0, 1.75, 0]]
    assert check(centers, [1, 1, 1], gap=-0.5).n_cells == 1
    assert check(centers, [1, 1, 1], gap=-0.25).n_cells == 2


@pytest.mark.parametrize("gap", [-1e3, -3.6e16, -1e25])
def test_more_overlap_than_spheres_can_have(rng, gap):
    lines = check(rng.uniform(-1, 1, (200, 3)), rng.uniform(0.1, 1, 200), gap)
    assert lines.n_lines == 0


def test_the_arrays_of_the_packing_ride_along():
    packing = packing_of([[0.0, 0, 0], [1, 0, 0]], [1.0, 1.0])
    packing["mass"] = [3.0, 4.0]
    packing.field_data["TimeValue"] = [7.0]
    lines = contacts_of(packing)
    assert lines["mass"].tolist() == [3.0, 4.0]
    assert lines.field_data["TimeValue"].tolist() == [7.0]
    assert "coordination" not in packing.point_data


@pytest.mark.parametrize("n", [0, 1])
def test_no_pairs_no_lines(n):
    lines = check(np.zeros((n, 3)), np.ones(n))
    assert lines.n_cells == 0
    assert lines.n_points == n


# --- hard packings --------------------------------------------------------------------------------


@pytest.mark.parametrize("offset", [0.0, 1e6, -123456.0])
def test_a_lattice_of_spheres_that_just_touch(offset):
    n = 9
    grid = np.stack(np.meshgrid(*3 * [np.arange(n)], indexing="ij"), -1).reshape(-1, 3)
    lines = check(grid + offset, np.full(n**3, 0.5))
    assert lines.n_cells == 3 * n * n * (n - 1)
    assert set(lines["coordination"]) == {3, 4, 5, 6}


def distances_of_powers(rng):
    radii = 10.0 ** -np.arange(30)
    return np.column_stack([2.0 * radii, 0 * radii, 0 * radii]), radii


HARD = {
    "concentric": lambda rng: (np.zeros((40, 3)), np.arange(40.0)),
    "all in one place": lambda rng: (np.ones((60, 3)), np.full(60, 0.1)),
    "points": lambda rng: (rng.random((500, 3)), np.zeros(500)),
    "points in one place": lambda rng: (np.full((50, 3), 0.3), np.zeros(50)),
    "points of a lattice": lambda rng: (rng.integers(0, 4, (300, 3)), np.zeros(300)),
    "some radii 0": lambda rng: (
        rng.random((500, 3)), rng.random(500) * rng.integers(0, 2, 500) / 5),
    "on a line": lambda rng: (rng.random((500, 3)) * [1, 0, 0], np.full(500, 1e-3)),
    "in a plane": lambda rng: (rng.random((500, 3)) * [1, 0, 1], np.full(500, 0.02)),
    "sizes over 6 orders": lambda rng: (rng.random((600, 3)), 10 ** rng.uniform(-6, 0, 600)),
    "sizes over 30 orders": distances_of_powers,
    "one giant": lambda rng: (rng.random((600, 3)), np.append(np.full(599, 0.01), 100.0)),
    "large offset": lambda rng: (rng.random((600, 3)) + 1e6, np.full(600, 0.05)),
    "one far away": lambda rng: (
        np.vstack([rng.random((600, 3)), [[1e20, 0, 0]]]), np.full(601, 0.05)),
    "two far apart": lambda rng: (
        np.vstack([rng.random((300, 3)), rng.random((300, 3)) + 1e9]), np.full(600, 0.06)),
    "a diagonal": lambda rng: (np.arange(600)[:, None] * [[1.0, 1, 1]], np.full(600, 0.9)),
    "scattered on an axis": lambda rng: (
        np.vstack([np.arange(400)[:, None] * [[1.0, 0, 0]], rng.random((5, 3)) * 1e7]),
        np.full(405, 0.5)),
    "tiny": lambda rng: (rng.random((300, 3)) * 1e-20, np.full(300, 1e-21)),
    "huge": lambda rng: (rng.random((300, 3)) * 1e25, np.full(300, 1e24)),
}  # fmt: skip


@pytest.mark.parametrize("case", HARD)
@pytest.mark.parametrize("gap", [0.0, 0.03])
def test_pairs_are_those_of_brute_force(rng, case, gap):
    check(*HARD[case](rng), gap)


@pytest.mark.parametrize("factor", [1, 5, 50])
def test_random_packings(rng, factor):
    radii = rng.uniform(1, factor, 2000) if factor < 50 else factor ** rng.random(2000)
    side = (4 / 3 * np.pi * (radii**3).sum() / 0.6) ** (1 / 3)
    lines = check(rng.random((2000, 3)) * side, radii)
    assert lines.n_cells > 500


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_single_precision_is_compared_in_double(rng, dtype):
    centers = rng.random((500, 3)).astype(dtype)
    radii = np.full(500, 0.05, dtype)
    packing = pv.PolyData(centers)
    packing["radius"] = radii
    lines = contacts_of(packing)
    rows, gaps = brute_force(centers.astype(float), radii.astype(float))
    assert np.array_equal(np.column_stack([lines["i"], lines["j"]]), rows[:, :2])
    assert np.array_equal(lines.cell_data["gap"], gaps)


def test_long_double_agrees_where_rounding_does_not_decide(rng):
    centers, radii = rng.random((800, 3)) * 10, 10 ** rng.uniform(-2, 0, 800)
    lines = contacts_of(packing_of(centers, radii))
    i, j = np.triu_indices(800, 1)
    exact = centers.astype(np.longdouble)
    distance = np.sqrt(((exact[i] - exact[j]) ** 2).sum(axis=1)) - radii[i] - radii[j]
    expected = set(zip(i[distance < -1e-14], j[distance < -1e-14], strict=True))
    possible = set(zip(i[distance < 1e-14], j[distance < 1e-14], strict=True))
    found = set(zip(lines["i"], lines["j"], strict=True))
    assert expected <= found <= possible


coordinates = st.floats(-4, 4, width=16)
spheres = st.lists(
    st.tuples(coordinates, coordinates, coordinates, st.floats(0, 4, width=16)), max_size=24
)


@hypothesis.given(spheres=spheres, gap=st.floats(-1, 1, width=16))
def test_any_spheres(spheres, gap):
    values = np.array(spheres, float).reshape(-1, 4)
    check(values[:, :3], values[:, 3], gap)


# --- periodic packings ----------------------------------------------------------------------------


def test_a_pair_across_a_face():
    lines = check_periodic([[0.5, 1, 1], [9.5, 1, 1]], [0.5, 0.6], np.diag([10, 10, 10]), (2, 2, 2))
    assert lines["cell_shift"].tolist() == [[-1, 0, 0]]
    assert lines.points[2].tolist() == [-0.5, 1, 1]
    assert lines["coordination"].tolist() == [1, 1, 1]


def test_only_periodic_faces_count():
    centers, radii = [[0.5, 5, 5], [9.5, 5, 5], [5, 0.5, 5], [5, 9.5, 5]], np.full(4, 0.5)
    cell = np.diag([10, 10, 10])
    lines = check_periodic(centers, radii, cell, (0, 2, 0), periodic=(0, 1, 0))
    assert lines["i"].tolist() == [2]
    bare = contacts_of(with_cell(packing_of(np.array(centers), radii), cell, periodic=(0, 0, 0)))
    assert bare.n_cells == 0 and bare.n_points == 4
    assert "cell_shift" not in bare.cell_data


def test_a_sphere_that_touches_its_own_images():
    lines = check_periodic([[0.3, 0.2, 0.1]], [0.5], np.eye(3), (2, 2, 2))
    assert lines["i"].tolist() == lines["j"].tolist() == [0, 0, 0]
    assert lines["cell_shift"].tolist() == [[0, 0, 1], [0, 1, 0], [1, 0, 0]]
    assert lines["coordination"][0] == 6


def test_two_spheres_that_touch_on_both_sides():
    lines = check_periodic([[0, 0, 0], [1, 0, 0]], [0.5, 0.5], np.diag([2, 9, 9]), (2, 1, 1))
    assert lines["cell_shift"].tolist() == [[-1, 0, 0], [0, 0, 0]]


@pytest.mark.parametrize("radius", [0.5, 0.7, 1.3])
def test_a_lattice_in_its_own_cell(radius):
    n = 4
    grid = np.stack(np.meshgrid(*3 * [np.arange(n)], indexing="ij"), -1).reshape(-1, 3)
    lines = check_periodic(grid, np.full(n**3, radius), n * np.eye(3), (2, 2, 2))
    reach = np.array(list(itertools.product(range(-3, 4), repeat=3)))
    neighbors = (np.sqrt((reach**2).sum(axis=1)) <= 2 * radius).sum() - 1
    assert set(lines["coordination"]) == {neighbors}


CELLS = {
    "orthogonal": np.diag([4.0, 5.0, 6.0]),
    "tilted": np.array([[4.0, 0, 0], [1.5, 5, 0], [-1, 2, 6]]),
    "turned": np.array([[1.0, 3, 2], [-3, 2, 1], [1, -2, 5]]),
    "left-handed": np.array([[0, 4.0, 0], [5, 0, 0], [0, 0, 6]]),
    "very tilted": np.array([[3.0, 0, 0], [2.9, 2, 0], [2.9, 1.9, 3]]),
    "thin": np.diag([0.7, 6.0, 6.0]),
}


@pytest.mark.parametrize("cell", CELLS)
@pytest.mark.parametrize("periodic", list(itertools.product((0, 1), repeat=3)))
def test_any_cell(rng, cell, periodic):
    if not any(periodic):
        periodic = (1, 1, 1)
    vectors = CELLS[cell]
    centers = rng.random((60, 3)) @ vectors + [10, -20, 30]
    radii = rng.uniform(0.05, 0.7, 60)
    images = 8 * np.array(periodic) if cell == "thin" else 5 * np.array(periodic)
    check_periodic(centers, radii, vectors, images, origin=(10, -20, 30), periodic=periodic)


def test_spheres_outside_the_cell(rng):
    vectors = CELLS["tilted"]
    centers = (rng.random((60, 3)) * 5 - 2) @ vectors
    check_periodic(centers, rng.uniform(0.1, 0.6, 60), vectors, (7, 7, 7), gap=0.05)


@pytest.mark.parametrize("offset", [0.0, 1e6, 1e12])
def test_points_in_a_periodic_cell(rng, offset):
    # Rounding at this offset is far larger than what would be a cell of the grid for points.
    centers = rng.integers(0, 8, (200, 3)) / 8.0 + offset
    check_periodic(centers, np.zeros(200), np.eye(3), (2, 2, 2), origin=3 * [offset])


def test_many_small_spheres_and_a_large_one_across_faces(rng):
    centers, radii = rng.random((150, 3)) * 20, np.append(rng.uniform(0.01, 0.3, 149), 9.0)
    check_periodic(centers, radii, 20 * np.eye(3), (2, 2, 2))


def test_wrapping_changes_no_gap_of_whole_numbers(rng):
    # Whole coordinates are moved exactly, so a packing and any of its images have the same gaps.
    vectors = np.array([[16.0, 0, 0], [4, 16, 0], [-4, 8, 16]])
    centers = rng.integers(0, 16, (200, 3)).astype(float)
    radii = rng.integers(1, 4, 200) / 2
    here = contacts_of(with_cell(packing_of(centers, radii), vectors))
    moved = centers + rng.integers(-9, 10, (200, 3)) @ vectors
    there = contacts_of(with_cell(packing_of(moved, radii), vectors))
    for name in ("i", "j"):
        assert np.array_equal(here[name], there[name])
    assert sorted(here.cell_data["gap"]) == sorted(there.cell_data["gap"])
    assert np.array_equal(here["coordination"][:200], there["coordination"][:200])


@hypothesis.given(
    spheres=spheres.filter(lambda s: len(s) < 8),
    tilt=st.tuples(*3 * [st.floats(-1.5, 1.5, width=16)]),
    sides=st.tuples(*3 * [st.floats(2, 6, width=16)]),
    gap=st.floats(0, 0.5, width=16),
)
def test_any_spheres_in_any_cell(spheres, tilt, sides, gap):
    values = np.array(spheres, float).reshape(-1, 4)
    values[:, 3] /= 2
    vectors = np.diag(np.array(sides, float))
    vectors[1, 0], vectors[2, 0], vectors[2, 1] = tilt
    duals = np.linalg.inv(vectors).T
    fractions = values[:, :3] @ duals.T
    spread = np.ptp(fractions, axis=0) if len(values) else np.zeros(3)
    reach = (2 * values[:, 3].max(initial=0) + gap) * np.linalg.norm(duals, axis=1)
    images = np.ceil(spread + reach).astype(int) + 1
    check_periodic(values[:, :3], values[:, 3], vectors, images, gap=gap)


# --- what is refused ------------------------------------------------------------------------------


def test_a_gap_that_is_no_number():
    packing = packing_of(np.zeros((2, 3)), np.ones(2))
    assert refusal(packing, np.nan) == "gap: found nan, expected a finite number"


@pytest.mark.parametrize(
    "vectors",
    [
        np.zeros((3, 3)),
        [[1, 0, 0], [2, 0, 0], [0, 0, 1]],
        [[1, 0, 0], [0, 1, 0], [1, 1, 0]],
        [[1, 0, 0], [0, 0, 0], [0, 0, 1]],
        [[1e200, 0, 0], [0, 1, 0], [0, 0, 1]],
    ],
)
def test_vectors_that_span_no_cell(vectors):
    packing = with_cell(packing_of(np.zeros((2, 3)), np.ones(2)), vectors)
    assert "expected a finite one of some length that the others do not span" in refusal(packing)


def test_a_flat_cell_is_one_where_it_is_not_periodic():
    flat = [[4, 0, 0], [0, 4, 0], [0, 0, 0]]
    check_periodic([[0.1, 1, 0], [3.9, 1, 0]], [0.2, 0.2], flat, (2, 2, 0), periodic=(1, 1, 0))


def test_a_cell_far_smaller_than_a_sphere():
    packing = with_cell(packing_of(np.zeros((1, 3)), np.ones(1)), 0.01 * np.eye(3))
    assert "found a cell so small that a sphere reaches" in refusal(packing)


@pytest.mark.parametrize(
    ("name", "values", "found"),
    [
        ("cell_vectors", np.eye(2), "found 4 values, expected 9 numbers"),
        ("cell_origin", np.zeros(2), "found 2 values, expected 3 numbers"),
        ("cell_origin", np.array([0, np.inf, 0]), "found inf, expected finite numbers"),
        ("cell_periodic", np.ones(1), "found 1 values, expected 3 numbers"),
    ],
)
def test_arrays_that_hold_no_cell(name, values, found):
    packing = with_cell(packing_of(np.zeros((2, 3)), np.ones(2)), np.eye(3))
    packing.field_data[name] = values
    assert refusal(packing) == f"{name}: {found}"


def test_bad_radii():
    packing = packing_of(np.zeros((2, 3)), np.array([1.0, -1.0]))
    assert "-1" in refusal(packing)


def test_abort_leaves_nothing(rng):
    packing = packing_of(rng.random((20_000, 3)), np.full(20_000, 0.02))
    finder = vtkSpherePackingContacts()
    finder.SetInputData(packing)
    finder.AddObserver("ProgressEvent", lambda *_: finder.SetAbortExecute(1))
    finder.Update()
    assert finder.GetErrorMessage() == ""
    assert finder.GetOutput().GetNumberOfPoints() == 0


def test_every_run_gives_the_same_order(rng):
    packing = packing_of(rng.random((20_000, 3)), 10 ** rng.uniform(-4, -1.5, 20_000))
    one, two = contacts_of(packing), contacts_of(packing)
    for name in ("i", "j", "gap"):
        assert np.array_equal(one.cell_data[name], two.cell_data[name])
    pairs = one["i"].astype(int) * 20_000 + one["j"]
    assert (np.diff(pairs) > 0).all()
