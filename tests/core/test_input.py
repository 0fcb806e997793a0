"""vtkSpherePackingInput: which arrays are radii, and the box around spheres."""

import numpy as np
import pytest
import pyvista as pv
from arrays import packing_of
from spherepacking.backend import vtkSpherePackingInput


def refusal(packing, name="radius"):
    check = vtkSpherePackingInput()
    assert check.FindRadii(packing, name) is None
    return check.GetMessage()


def test_good_radii_are_the_array_itself():
    packing = packing_of(np.zeros((3, 3)), [0.0, 1.0, 2.0])
    check = vtkSpherePackingInput()
    assert check.FindRadii(packing, "radius") is packing.GetPointData().GetArray("radius")
    assert check.GetMessage() == ""


def test_no_points_need_no_radii():
    assert refusal(pv.PolyData()) == ""
    assert refusal(None) == ""


def test_message_is_forgotten_after_good_input():
    check = vtkSpherePackingInput()
    check.FindRadii(packing_of(np.zeros((1, 3)), [1.0], "size"), "radius")
    assert "radius" in check.GetMessage()
    check.FindRadii(packing_of(np.zeros((1, 3)), [1.0]), "radius")
    assert check.GetMessage() == ""


@pytest.mark.parametrize("count", [1, 2, 1000, 100_003])
def test_first_bad_radius_is_named_whatever_the_threads(count, rng):
    radii = rng.random(count)
    bad = np.sort(rng.integers(0, count, 5))
    radii[bad] = -1.0
    assert f"at point {bad[0]}," in refusal(packing_of(np.zeros((count, 3)), radii))


@pytest.mark.parametrize("axis", [0, 1, 2])
@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
def test_first_bad_center_is_named(axis, value):
    centers = np.zeros((10, 3))
    centers[7, axis] = value
    message = refusal(packing_of(centers, np.ones(10)))
    assert "centre of point 7" in message
    assert "finite" in message


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("radius_type", [np.float32, np.float64, np.uint8, np.int64])
def test_bounds_equal_numpy(rng, dtype, radius_type):
    centers = rng.uniform(-100, 100, (5000, 3)).astype(dtype)
    radii = rng.uniform(0, 50, 5000).astype(radius_type)
    packing = packing_of(centers, radii)
    bounds = [0.0] * 6
    vtkSpherePackingInput.ComputeBounds(packing, packing.GetPointData().GetArray("radius"), bounds)
    centers, radii = centers.astype(float), radii.astype(float)[:, None]
    np.testing.assert_array_equal(bounds[::2], (centers - radii).min(axis=0))
    np.testing.assert_array_equal(bounds[1::2], (centers + radii).max(axis=0))


def test_bounds_of_nothing_are_uninitialized():
    bounds = [0.0] * 6
    vtkSpherePackingInput.ComputeBounds(pv.PolyData(), None, bounds)
    assert bounds[0] > bounds[1]
