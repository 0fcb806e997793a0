"""Whether a packing has changed, also behind VTK's back."""

import subprocess
import sys

import numpy as np
import pytest
import pyvista as pv
import spherepacking
from spherepacking.datasets import with_radii
from spherepacking.packing import ChangeDetector, check_radii, modified_times


@pytest.fixture
def packing():
    return spherepacking.apollonian(1)


def test_times_of_what_does_not_change_are_equal(packing):
    assert modified_times(packing) == modified_times(packing)
    assert modified_times(packing) != modified_times(packing.copy())


@pytest.mark.parametrize(
    ("change", "moves"),
    [
        (lambda p: setattr(p, "points", p.points + 1.0), True),
        (lambda p: p.GetPoints().GetData().Modified(), True),
        (lambda p: p.point_data.__setitem__("radius", p["radius"] * 2.0), True),
        (lambda p: p.point_data.__setitem__("weight", p["radius"] * 2.0), False),
        (lambda p: p.Modified(), False),
    ],
)
def test_changes_that_vtk_knows_of(packing, change, moves):
    before = modified_times(packing)
    change(packing)
    after = modified_times(packing)
    assert after != before
    assert (after.geometry != before.geometry) == moves


@pytest.mark.parametrize("packing", [pv.PolyData(), pv.PolyData([[0.0, 0.0, 0.0]])])
def test_nothing_is_known_of_packings_without_spheres_or_radii(packing):
    assert modified_times(packing) is None
    assert ChangeDetector(hash_contents=True).modified_times(packing) is None


@pytest.mark.parametrize("name", ["points", "radius"])
@pytest.mark.parametrize("hash_contents", [False, True])
def test_changes_behind_the_back_of_vtk(packing, name, hash_contents):
    detector = ChangeDetector(hash_contents=hash_contents)
    before = detector.modified_times(packing)
    assert detector.modified_times(packing) == before
    values = np.asarray(packing.points if name == "points" else packing["radius"])
    values *= 0.5
    after = detector.modified_times(packing)
    assert (after.geometry != before.geometry) == hash_contents
    assert detector.modified_times(packing) == after


def test_radii_changed_in_place_are_found_once_another_change_is_told(packing):
    """PyVista tells the point data of the assignment, and nobody of the new values."""
    detector = ChangeDetector(hash_contents=False)
    before = detector.modified_times(packing)
    packing["radius"] *= 0.5
    assert detector.modified_times(packing).geometry != before.geometry


def test_an_array_beside_the_radii_is_no_change_of_geometry(packing):
    detector = ChangeDetector(hash_contents=True)
    before = detector.modified_times(packing)
    packing["weight"] = np.zeros(packing.n_points)
    after = detector.modified_times(packing)
    assert (after.geometry, after.arrays > before.arrays) == (before.geometry, True)


def test_radii_by_value_leave_the_packing_alone(packing):
    copy, name = with_radii(packing, 2.0)
    assert (copy[name] == 2.0).all()
    assert packing["radius"].max() == 0.5
    assert np.shares_memory(copy.points, packing.points)
    with pytest.raises(KeyError, match="radius: the packing has no point array 'width'"):
        check_radii(packing, "width")


def test_packings_are_pickled(tmp_path):
    """In a process that has imported no more than what reads the packing."""
    code = """
import pickle, sys
import spherepacking
packing = spherepacking.read(sys.argv[1])
back = pickle.loads(pickle.dumps(packing))
assert back == packing and back["radius"].tolist() == [2.0]
"""
    path = tmp_path / "one.xyzr"
    path.write_text("0 0 0 2\n")
    done = subprocess.run(
        [sys.executable, "-c", code, path], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
