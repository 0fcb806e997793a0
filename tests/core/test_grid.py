"""vtkSpherePackingGrid: exactly the cells that spheres touch, on easy and on hard packings."""

import numpy as np
import pytest
import pyvista as pv
from arrays import packing_of
from boxes import CASES, boxes_of, one_a_box, refusal
from spherepacking.backend import vtkSpherePackingGrid


def grid_of(cuts=1, *, lines=False):
    grid = vtkSpherePackingGrid()
    grid.SetCuts(cuts)
    grid.SetBoxesAsLines(lines)
    return grid


def planes_of(centers, radii, cuts):
    low = (centers - radii[:, None]).min(axis=0)
    high = (centers + radii[:, None]).max(axis=0)
    shares = np.arange(cuts + 2)[:, None] / (cuts + 1)
    planes = low + shares * (high - low)
    planes[-1] = high
    return planes


def clearances(centers, radii, cuts):
    """Distance minus radius of every cell and sphere (cells, n), in long double."""
    planes = planes_of(centers, radii, cuts).astype(np.longdouble)
    squared = np.longdouble(0)
    for axis in range(3):
        low, high = planes[:-1, axis, None], planes[1:, axis, None]
        x = centers[:, axis].astype(np.longdouble)
        outside = np.maximum(np.maximum(low - x, x - high), 0) ** 2  # (cells along the axis, n)
        shape = [1, 1, 1, len(radii)]
        shape[2 - axis] = cuts + 1
        squared = squared + outside.reshape(shape)
    return (np.sqrt(squared) - radii).reshape(-1, len(radii))


def check(centers, radii, cuts):
    centers, radii = np.asarray(centers, float), np.asarray(radii, float)
    boxes = boxes_of(grid_of(cuts), packing_of(centers, radii))
    found = np.zeros((cuts + 1) ** 3, int)
    found[one_a_box(boxes, "box_id")] = one_a_box(boxes, "count")
    distance = clearances(centers, radii, cuts)
    # Where rounding of the float64 coordinates decides, both answers are right.
    band = 8 * np.finfo(float).eps * (np.abs(centers).max() + radii.max())
    certain = (distance < -band).sum(axis=1)
    possible = (distance <= band).sum(axis=1)
    assert (found >= certain).all()
    assert (found <= possible).all()
    return boxes, found


@pytest.mark.parametrize("cuts", [0, 1, 6, 11])
@pytest.mark.parametrize("case", CASES)
def test_cells_are_those_of_long_double_distances(rng, case, cuts):
    check(*CASES[case](rng), cuts)


def test_cells_beside_the_rounding_stay_empty():
    _, found = check([[0, 0, 0]], [1.0], 6)
    assert found[0] == 0  # the corner of the box
    assert found[(7 * 3 + 3) * 7] == 1  # the middle of a face


def test_a_sphere_that_ends_on_a_face_touches_both_sides():
    # Bounds from 0 to 2; the first sphere ends at the plane x = 1.
    _, found = check([[0.5, 1, 1], [1.75, 1, 1]], [0.5, 0.25], 1)
    assert found.tolist() == [1, 2] * 4


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("radii_dtype", [np.float32, np.float64, np.int32, np.uint8])
def test_any_numeric_arrays(dtype, radii_dtype):
    packing = packing_of(np.zeros((1, 3), dtype), np.array([2], radii_dtype))
    assert boxes_of(grid_of(0), packing).bounds == pytest.approx((-2, 2, -2, 2, -2, 2))


def test_quads_are_closed_boxes_that_look_outwards(rng):
    boxes, _ = check(rng.random((50, 3)), rng.random(50) * 0.1, 3)
    assert boxes.n_points == 8 * boxes.n_cells / 6
    volume = 0.0
    for box in np.unique(one_a_box(boxes, "box_id")):
        one = boxes.extract_cells(np.flatnonzero(boxes.cell_data["box_id"] == box))
        closed = one.extract_surface(algorithm=None).triangulate()
        assert closed.is_manifold
        corners = closed.points[closed.regular_faces]
        signed = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])).sum()
        volume += signed / 6.0
    extent = np.ptp(planes_of(boxes.points, np.zeros(boxes.n_points), 0), axis=0)
    assert 0.0 < volume <= extent.prod() * (1 + 1e-9)


def test_lines_are_the_edges(rng):
    packing = packing_of(rng.random((50, 3)), rng.random(50) * 0.1)
    quads, lines = boxes_of(grid_of(3), packing), boxes_of(grid_of(3, lines=True), packing)
    assert lines.n_lines == 2 * quads.n_cells
    np.testing.assert_array_equal(lines.points, quads.points)
    edges = lines.lines.reshape(-1, 3)[:, 1:]
    moved = np.abs(lines.points[edges[:, 0]] - lines.points[edges[:, 1]]) > 0
    assert (moved.sum(axis=1) == 1).all()
    assert len(np.unique(np.sort(edges, axis=1), axis=0)) == len(edges)


def test_field_data():
    boxes, found = check([[0, 0, 0], [3, 3, 3]], [1.0, 1.0], 6)
    share = np.count_nonzero(found) / 7**3
    assert boxes.field_data["occupied_share"][0] == pytest.approx(share)
    assert boxes.field_data["memory_bytes"][0] == 4 * found.sum() + 8 * (7**3 + 1)
    assert boxes.field_data["build_seconds"][0] > 0


def test_an_empty_packing_has_no_boxes():
    boxes = boxes_of(grid_of(3), pv.PolyData())
    assert boxes.n_cells == boxes.n_points == 0
    assert boxes.field_data["occupied_share"][0] == 0


def test_refusals():
    good = packing_of(np.zeros((1, 3)), [1.0])
    assert refusal(grid_of(-1), good) == "cuts: found -1, expected 0 or more"
    assert "more cells than fit" in refusal(grid_of(100_000), good)
    assert "more cells than fit" in refusal(grid_of(2**31 - 1), good)
    nameless = packing_of(np.zeros((1, 3)), [1.0], "size")
    assert "point array 'radius'" in refusal(grid_of(), nameless)
    assert "at point 0" in refusal(grid_of(), packing_of(np.zeros((1, 3)), [np.nan]))
    assert "along y" in refusal(grid_of(), packing_of([[0, -1e308, 0], [0, 1e308, 0]], [1.0, 1.0]))


def test_good_options_after_bad_ones():
    packing = packing_of(np.zeros((1, 3)), [1.0])
    grid = grid_of(-1)
    refusal(grid, packing)
    grid.SetCuts(0)
    grid.RemoveAllObservers()
    assert boxes_of(grid, packing).n_cells == 6
    assert (grid.GetErrorCode(), grid.GetErrorMessage()) == (0, "")
