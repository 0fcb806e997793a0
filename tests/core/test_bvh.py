"""vtkSpherePackingBVH: every sphere in one leaf, exact boxes, and the splits that SAH asks for."""

import heapq
import itertools
import os
import subprocess
import sys

import numpy as np
import pytest
import pyvista as pv
from arrays import packing_of
from boxes import CASES, boxes_of, one_a_box, refusal
from spherepacking.backend import vtkSpherePackingBVH
from spherepacking.testing.scenes import knot_tube

HARD = CASES | {
    "denormal lengths": lambda rng: (1e-310 * rng.random((50, 3)), np.full(50, 1e-312)),
    "exponential distances": lambda rng: (2.0 ** -np.arange(1000)[:, None] * [1, 1, 0], [0] * 1000),
    "a sphere far away": lambda rng: (np.vstack([rng.random((99, 3)), [1e4] * 3]), [0.1] * 100),
    "one sphere": lambda rng: ([[1, 2, 3]], [0.5]),
    "two of a kind": lambda rng: ([[1, 2, 3]] * 2, [0.5] * 2),
}


def bvh_of(*, number=None, depth=None, leaves_only=True, lines=False):
    bvh = vtkSpherePackingBVH()
    if number is not None:
        bvh.SetNumberOfBoxes(number)
    if depth is not None:
        bvh.SetDepth(depth)
    bvh.SetLeavesOnly(leaves_only)
    bvh.SetBoxesAsLines(lines)
    return bvh


class Tree:
    """All levels of a hierarchy: boxes (m, 3), depths, counts, parents, and what is a leaf (m,)."""

    def __init__(self, packing, **options):
        self.output = boxes_of(bvh_of(leaves_only=False, **options), packing)
        corners = self.output.points.reshape(-1, 8, 3)
        self.low, self.high = corners.min(axis=1), corners.max(axis=1)
        self.depths = one_a_box(self.output, "depth")
        self.counts = one_a_box(self.output, "count")
        self.leaf_of_sphere = self.output.field_data["leaf_of_sphere"]
        # Depth first, so the parent is the last node before that is one level higher.
        np.testing.assert_array_equal(one_a_box(self.output, "box_id"), np.arange(len(self.depths)))
        self.parents = np.full(len(self.depths), -1)
        path = []
        for node, depth in enumerate(self.depths):
            assert depth <= len(path)
            path[depth:] = [node]
            self.parents[node] = path[depth - 1] if depth else -1
        children = np.bincount(self.parents[1:], minlength=len(self.depths))
        assert set(children) <= {0, 2}
        self.is_leaf = children == 0

    def areas(self):
        x, y, z = (self.high - self.low).T
        return 2.0 * (x * y + y * z + z * x)

    def children(self, node):
        return np.flatnonzero(self.parents == node)


def check(centers, radii, **options):
    centers, radii = np.asarray(centers, float), np.asarray(radii, float)[:, None]
    tree = Tree(packing_of(centers, radii[:, 0]), **options)
    leaves = np.flatnonzero(tree.is_leaf)
    assert tree.leaf_of_sphere.shape == (len(radii),)
    assert np.isin(tree.leaf_of_sphere, leaves).all()
    held = np.bincount(tree.leaf_of_sphere, minlength=len(tree.counts))
    np.testing.assert_array_equal(held[leaves], tree.counts[leaves])
    assert held[leaves].min() > 0

    for leaf in leaves:
        mine = tree.leaf_of_sphere == leaf
        np.testing.assert_array_equal(tree.low[leaf], (centers - radii)[mine].min(axis=0))
        np.testing.assert_array_equal(tree.high[leaf], (centers + radii)[mine].max(axis=0))
    for node in np.flatnonzero(~tree.is_leaf):
        children = tree.children(node)
        np.testing.assert_array_equal(tree.low[node], tree.low[children].min(axis=0))
        np.testing.assert_array_equal(tree.high[node], tree.high[children].max(axis=0))
        assert tree.counts[node] == tree.counts[children].sum()

    # The boxes of double precision contain the spheres up to the rounding of one sum.
    wide, wide_radii = centers.astype(np.longdouble), radii.astype(np.longdouble)
    low, high = tree.low[tree.leaf_of_sphere], tree.high[tree.leaf_of_sphere]
    assert (low - (wide - wide_radii) <= 0.501 * np.spacing(np.abs(low))).all()
    assert (wide + wide_radii - high <= 0.501 * np.spacing(np.abs(high))).all()
    return tree


@pytest.mark.parametrize("number", [1, 7, 15, 100_000])
@pytest.mark.parametrize("case", HARD)
def test_wanted_numbers_of_boxes(rng, case, number):
    centers, radii = HARD[case](rng)
    tree = check(centers, radii, number=number)
    assert np.count_nonzero(tree.is_leaf) == min(number, len(radii))


@pytest.mark.parametrize("depth", [0, 1, 5, 2**31 - 1])
@pytest.mark.parametrize("case", HARD)
def test_depths(rng, case, depth):
    centers, radii = HARD[case](rng)
    tree = check(centers, radii, depth=depth)
    assert tree.depths.max() <= depth
    assert (tree.counts[tree.is_leaf & (tree.depths < depth)] == 1).all()


def test_the_default_is_15_boxes_and_depth_comes_first(rng):
    packing = packing_of(rng.random((100, 3)), rng.random(100))
    assert boxes_of(bvh_of(), packing).n_cells == 6 * 15
    assert boxes_of(bvh_of(depth=2, number=50), packing).n_cells == 6 * 4
    assert boxes_of(bvh_of(depth=-1, number=50), packing).n_cells == 6 * 50


def test_leaves_are_the_same_nodes_without_the_others(rng):
    packing = packing_of(rng.random((100, 3)), rng.random(100) * 0.1)
    tree = Tree(packing, number=15)
    leaves = boxes_of(bvh_of(number=15), packing)
    lines = boxes_of(bvh_of(number=15, lines=True), packing)
    assert lines.n_lines == 12 * 15
    for output in (leaves, lines):
        for name in ("box_id", "depth", "count"):
            every = one_a_box(tree.output, name)
            np.testing.assert_array_equal(one_a_box(output, name), every[tree.is_leaf])
        corners = tree.output.points.reshape(-1, 8, 3)[tree.is_leaf]
        np.testing.assert_array_equal(output.points, corners.reshape(-1, 3))
        np.testing.assert_array_equal(output.field_data["leaf_of_sphere"], tree.leaf_of_sphere)


def test_the_leaf_that_gains_most_is_split_first():
    packing = knot_tube(2000)
    full = Tree(packing, depth=1000)
    areas = full.areas()

    def entry(node):
        children = full.children(node)
        gain = areas[node] * full.counts[node] - areas[children] @ (full.counts[children] + 1)
        return -gain, node

    # The splits are those of the full tree; which of them are made is computed here.
    leaves = [entry(0)]
    for number in range(1, 60):
        tree = Tree(packing, number=number)
        expected = sorted(map(tuple, np.hstack([full.low, full.high])[[n for _, n in leaves]]))
        found = sorted(map(tuple, np.hstack([tree.low, tree.high])[tree.is_leaf]))
        assert found == expected
        _, best = heapq.heappop(leaves)
        for child in full.children(best):
            heapq.heappush(leaves, entry(child))


def x_median_cost(centers, radii, depth):
    """SAH cost of halving the spheres by their x, over and over."""
    order = np.argsort(centers[:, 0])
    low, high = (centers - radii[:, None])[order], (centers + radii[:, None])[order]

    def area(part):
        x, y, z = high[part].max(axis=0) - low[part].min(axis=0)
        return x * y + y * z + z * x

    cost = 0.0
    for level in range(depth + 1):
        ends = np.linspace(0, len(radii), 2**level + 1).astype(int)
        for first, last in itertools.pairwise(ends):
            tests = last - first if level == depth else 0
            cost += area(slice(first, last)) * (1 + tests)
    return cost / area(slice(None))


@pytest.mark.parametrize("depth", [1, 3, 4, 8])
def test_cost_is_below_that_of_splits_along_x(depth):
    packing = knot_tube(20_000)
    centers, radii = packing.points.astype(float), packing["radius"].astype(float)
    bvh = bvh_of(number=2**depth)
    cost = boxes_of(bvh, packing).field_data["sah_cost"][0]
    assert cost < x_median_cost(centers, radii, depth)


@pytest.mark.parametrize("case", ["random", "small radii far away", "one plane", "a knot"])
def test_field_data(rng, case):
    centers, radii = CASES[case](rng)
    tree = check(centers, radii, number=20)
    fields = tree.output.field_data
    shares = tree.areas() / tree.areas()[0]
    cost = shares.sum() + (shares * tree.counts)[tree.is_leaf].sum()
    assert fields["sah_cost"][0] == pytest.approx(cost, rel=1e-12)
    volumes = (tree.high - tree.low).prod(axis=1)
    share = volumes[tree.is_leaf].sum() / volumes[0]
    assert fields["occupied_share"][0] == pytest.approx(share, rel=1e-12)
    assert fields["memory_bytes"][0] == 80 * len(shares) + 4 * len(radii)
    assert 0 < fields["build_seconds"][0] < 60


def test_the_cost_counts_what_random_rays_meet(rng):
    centers, radii = CASES["a knot"](rng)
    tree = check(centers, radii, number=7)
    # Through two points of a sphere around all: lines spread as in the heuristic's model.
    middle = 0.5 * (tree.low[0] + tree.high[0])
    size = np.linalg.norm(tree.high[0] - tree.low[0])
    ends = rng.normal(size=(2, 1_000_000, 3))
    ends /= np.linalg.norm(ends, axis=2, keepdims=True)
    start, other = middle + 0.5 * size * ends
    direction = other - start
    met = np.empty((len(tree.low), len(start)), bool)
    for node, (low, high) in enumerate(zip(tree.low, tree.high, strict=True)):
        t = np.stack([(low - start) / direction, (high - start) / direction])
        met[node] = t.min(axis=0).max(axis=1) <= t.max(axis=0).min(axis=1)
    tests = met.T @ (1 + tree.is_leaf * tree.counts)
    tests = tests[met[0]]
    error = tests.std() / np.sqrt(len(tests))
    assert tree.output.field_data["sah_cost"][0] == pytest.approx(tests.mean(), abs=5 * error)


@pytest.mark.parametrize("case", ["no extent", "flat without radii", "one line"])
def test_flat_scenes_have_no_volume_and_lines_no_surface(rng, case):
    centers, _ = CASES[case](rng)
    fields = check(centers, np.zeros(len(centers)), number=4).output.field_data
    assert fields["occupied_share"][0] == 0
    if case == "flat without radii":
        assert 1 < fields["sah_cost"][0] <= len(centers) + 7
    else:
        assert fields["sah_cost"][0] == 0


@pytest.mark.parametrize("case", ["tiny lengths", "large lengths"])
def test_cost_and_share_do_not_depend_on_the_unit(rng, case):
    centers, radii = CASES[case](rng)
    scale = 1.0 / np.abs(centers).max()
    found = check(centers, radii, number=9).output.field_data
    expected = check(centers * scale, radii * scale, number=9).output.field_data
    for name in ("sah_cost", "occupied_share"):
        assert found[name][0] == pytest.approx(expected[name][0], rel=1e-9)


@pytest.mark.parametrize("dtype", [np.float32, np.float64, np.int32])
@pytest.mark.parametrize("radii_dtype", [np.float32, np.float64, np.int32, np.uint8])
def test_any_numeric_arrays(rng, dtype, radii_dtype):
    centers = rng.integers(-100, 100, (50, 3)).astype(dtype)
    radii = rng.integers(0, 9, 50).astype(radii_dtype)
    found = Tree(packing_of(centers, radii), number=7)
    expected = check(centers, radii, number=7)
    np.testing.assert_array_equal(found.output.points, expected.output.points)
    np.testing.assert_array_equal(found.leaf_of_sphere, expected.leaf_of_sphere)


def test_an_empty_packing_has_no_boxes():
    for options in ({}, {"depth": 3}, {"number": 1}):
        boxes = boxes_of(bvh_of(**options), pv.PolyData())
        assert boxes.n_cells == boxes.n_points == 0
        for name in ("sah_cost", "occupied_share", "memory_bytes"):
            assert boxes.field_data[name][0] == 0
        assert boxes.field_data["leaf_of_sphere"].size == 0


MANY = """
import hashlib, sys
sys.path[:0] = sys.argv[1:]
from test_bvh import bvh_of, boxes_of, knot_tube
boxes = boxes_of(bvh_of(number=100), knot_tube(300_000))
leaves = boxes.field_data["leaf_of_sphere"]
print(hashlib.sha256(boxes.points.tobytes() + leaves.tobytes()).hexdigest())
"""


def test_the_tree_does_not_depend_on_the_threads():
    here = os.path.dirname(__file__)
    found = {
        subprocess.run(
            [sys.executable, "-c", MANY, here],
            env=os.environ | {"VTK_SMP_BACKEND_IN_USE": backend, "VTK_SMP_MAX_THREADS": threads},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for backend, threads in [("Sequential", "1"), ("STDThread", "3")]
    }
    assert len(found) == 1


def test_refusals():
    good = packing_of(np.zeros((1, 3)), [1.0])
    assert refusal(bvh_of(number=0), good) == "boxes: found 0, expected 1 or more"
    assert refusal(bvh_of(number=-7), good) == "boxes: found -7, expected 1 or more"
    message = "depth: found -2, expected 0 or more, or -1 for a number of boxes"
    assert refusal(bvh_of(depth=-2), good) == message
    nameless = packing_of(np.zeros((1, 3)), [1.0], "size")
    assert "point array 'radius'" in refusal(bvh_of(), nameless)
    assert "at point 0" in refusal(bvh_of(), packing_of(np.zeros((1, 3)), [-1.0]))
    far = packing_of([[-1e308, 0, 0], [1e308, 0, 0]], [1.0, 1.0])
    assert "packing: found spheres from -1e+308 to 1e+308 along x" in refusal(bvh_of(), far)


def test_more_boxes_than_fit_are_refused():
    memory = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    # Zeros that nobody reads take no memory.
    many = packing_of(np.zeros((memory // 1280, 3), np.int8), [])
    assert "depth: found 64, which makes more boxes than fit" in refusal(bvh_of(depth=64), many)
    assert "which makes more boxes" in refusal(bvh_of(number=2**31 - 1), many)
    assert "point array 'radius'" in refusal(bvh_of(depth=8), packing_of(many.points, [], "size"))
