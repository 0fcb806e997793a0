"""The writer: formats, order, errors, and that a failing write loses nothing."""

import os
import subprocess
import sys

import numpy as np
import pytest
import pyvista as pv
from spherepacking.vtkSpherePackingCore import vtkSpherePackingWriter


@pytest.fixture
def packing():
    mesh = pv.PolyData(np.array([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.5]]))
    mesh["radius"] = np.array([0.5, 2.0, 0.5])
    mesh["id"] = np.array([10, 11, 2**53 - 1])
    mesh["velocity"] = np.arange(9.0).reshape(3, 3)
    mesh["matId"] = np.array([0, 1, 0], dtype=np.int8)
    return mesh


def test_spheres_are_written_largest_first(packing, write, tmp_path):
    path = tmp_path / "p.spheres"
    assert write(packing, path, sort=True) == (True, "")
    assert path.read_text() == "4 5 6 2\n1 2 3 0.5\n7 8 9.5 0.5\n"
    assert vtkSpherePackingWriter().GetSortByRadius(), "which is the default"


def test_spheres_in_their_own_order(packing, write, tmp_path):
    path = tmp_path / "p.spheres"
    assert write(packing, path, sort=False) == (True, "")
    assert path.read_text() == "1 2 3 0.5\n4 5 6 2\n7 8 9.5 0.5\n"


@pytest.mark.parametrize("extension", ["csv", "xyzr", "txt", "xyzd"])
def test_other_formats_keep_the_order(packing, write, read, tmp_path, extension):
    path = tmp_path / f"p.{extension}"
    assert write(packing, path, sort=True) == (True, "")
    assert read(path)["radius"].tolist() == [0.5, 2, 0.5]


def test_csv_has_all_arrays(packing, write, read, tmp_path):
    path = tmp_path / "p.csv"
    assert write(packing, path) == (True, "")
    assert path.read_text().splitlines()[:2] == [
        "x,y,z,radius,id,velocity_0,velocity_1,velocity_2,matId",
        "1,2,3,0.5,10,0,1,2,0",
    ]
    back = read(path)
    assert back["id"].tolist() == packing["id"].tolist()
    assert back["velocity_2"].tolist() == [2, 5, 8]


def test_yade(packing, write, tmp_path):
    path = tmp_path / "p.txt"
    assert write(packing, path) == (True, "")
    assert path.read_text().splitlines()[:2] == ["#format x_y_z_r_matId", "1 2 3 0.5 0"]
    del packing.point_data["matId"]
    assert write(packing, path) == (True, "")
    assert path.read_text().splitlines()[0] == "#format x_y_z_r"


def test_xyzd_holds_diameters(packing, write, tmp_path):
    path = tmp_path / "p.xyzd"
    assert write(packing, path) == (True, "")
    assert np.fromfile(path, "<f8")[3::4].tolist() == [1, 4, 1]


def test_format_and_radius_array_by_name(packing, write, read, tmp_path):
    packing["size"] = np.array([3, 4, 5], dtype=np.int16)
    del packing.point_data["radius"]
    path = tmp_path / "p.any"
    assert write(packing, path, radius="size", fmt="CSV") == (True, "")
    back = read(path, fmt="CSV")
    assert back["radius"].tolist() == [3, 4, 5]


def test_a_second_write_writes_again(packing, tmp_path):
    writer = vtkSpherePackingWriter()
    writer.SetInputData(packing)
    writer.SetFileName(str(tmp_path / "p.spheres"))
    assert writer.Write() == 1
    (tmp_path / "p.spheres").unlink()
    assert writer.Write() == 1
    assert (tmp_path / "p.spheres").exists()


def bad_radius(value):
    def spoil(mesh):
        mesh["radius"][1] = value

    return spoil


def no_array(mesh):
    del mesh.point_data["radius"]


def vector_radius(mesh):
    mesh["radius"] = np.ones((3, 3))


def bad_center(mesh):
    mesh.points[2, 1] = np.nan


def no_points(mesh):
    mesh.copy_from(pv.PolyData())


def array_called_x(mesh):
    mesh["x"] = np.zeros(3)


def array_with_a_comma(mesh):
    mesh["a,b"] = np.zeros(3)


BAD = {
    "negative-radius": (bad_radius(-1.0), "p.spheres", "holds -1 at point 1"),
    "nan-radius": (bad_radius(np.nan), "p.spheres", "holds nan at point 1"),
    "no-array": (no_array, "p.spheres", "no point array 'radius'"),
    "vector": (vector_radius, "p.spheres", "has 3 components, expected 1"),
    "nan-centre": (bad_center, "p.csv", "centre of point 2 has the coordinate nan"),
    "no-points": (no_points, "p.spheres", "holds no sphere, expected at least one"),
    "pqr": (lambda mesh: None, "p.pqr", "cannot be written, expected the extension .spheres"),
    "no-extension": (lambda mesh: None, "p", "cannot be written, expected the extension .spheres"),
    "array-called-x": (array_called_x, "p.csv", "'x' and 'x', which name one thing twice"),
    "array-with-a-comma": (array_with_a_comma, "p.csv", "'a,b' has a separator"),
    "huge-diameter": (bad_radius(1.5e308), "p.xyzd", "found the radius 1.5e+308 at point 1"),
}


@pytest.mark.parametrize("case", BAD)
def test_bad_packings_leave_the_file_that_was_there(packing, write, tmp_path, case):
    spoil, name, message = BAD[case]
    spoil(packing)
    path = tmp_path / name
    path.write_text("earlier work")
    good, found = write(packing, path)
    assert not good
    assert str(path) in found
    assert message in found
    assert path.read_text() == "earlier work"
    assert os.listdir(tmp_path) == [name], "no other file is left"


def test_places_that_cannot_be_written(packing, write, tmp_path):
    good, message = write(packing, tmp_path / "nowhere" / "p.spheres")
    assert not good and "No such file or directory" in message and "nowhere" in message
    (tmp_path / "p.csv").mkdir()
    good, message = write(packing, tmp_path / "p.csv")
    assert not good and "found a directory, expected a file" in message
    assert os.listdir(tmp_path) == ["p.csv"]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no named pipes here")
def test_a_pipe_is_not_replaced(packing, write, tmp_path):
    os.mkfifo(tmp_path / "p.spheres")
    good, message = write(packing, tmp_path / "p.spheres")
    assert not good and "no regular file" in message
    assert not (tmp_path / "p.spheres").is_file()


def test_no_file_name_and_no_input(packing):
    for writer, expected in [
        (vtkSpherePackingWriter(), "no input"),
        (vtkSpherePackingWriter(), "FileName"),
    ]:
        if expected == "FileName":
            writer.SetInputData(packing)
        writer.AddObserver("ErrorEvent", lambda *_: None)
        assert writer.Write() == 0
        assert expected in writer.GetErrorMessage()
        assert writer.GetErrorCode() != 0


def test_a_link_and_permissions_stay(packing, write, tmp_path):
    target, link = tmp_path / "target.spheres", tmp_path / "link.spheres"
    target.write_text("old")
    target.chmod(0o640)
    link.symlink_to(target)
    assert write(packing, link) == (True, "")
    assert link.is_symlink()
    assert target.read_text().startswith("1 2 3 0.5\n")
    assert target.stat().st_mode & 0o777 == 0o640


def test_links_to_nothing_and_in_a_circle(packing, write, tmp_path):
    (tmp_path / "to_nothing.spheres").symlink_to("new.spheres")
    assert write(packing, tmp_path / "to_nothing.spheres") == (True, "")
    assert (tmp_path / "to_nothing.spheres").is_symlink()
    assert (tmp_path / "new.spheres").is_file()
    (tmp_path / "circle.spheres").symlink_to("circle.spheres")
    good, message = write(packing, tmp_path / "circle.spheres")
    assert not good and "circle.spheres: found links that lead in a circle" in message


def test_the_longest_name(packing, write, tmp_path):
    path = tmp_path / ("a" * 247 + ".spheres")
    assert write(packing, path) == (True, "")
    assert os.listdir(tmp_path) == [path.name]


def test_an_nfo_that_would_scale_the_diameters(packing, write, tmp_path):
    (tmp_path / "p.nfo").write_text("Theoretical Porosity: 0.3\nFinal Porosity: 0.4\n")
    good, message = write(packing, tmp_path / "p.xyzd")
    assert not good and "scales the diameters by 0.9499" in message
    assert not (tmp_path / "p.xyzd").exists()


def test_abort_leaves_the_file_that_was_there(tmp_path):
    mesh = pv.PolyData(np.zeros((100000, 3)))
    mesh["radius"] = np.ones(100000)
    path = tmp_path / "p.csv"
    path.write_text("earlier work")
    writer = vtkSpherePackingWriter()
    writer.SetInputData(mesh)
    writer.SetFileName(str(path))
    seen = []

    def stop(caller, _):
        seen.append(caller.GetProgress())
        if seen[-1] > 0:
            caller.SetAbortExecuteAndUpdateTime()

    tag = writer.AddObserver("ProgressEvent", stop)
    assert writer.Write() == 0
    assert next(p for p in seen if p > 0) < 0.5
    assert writer.GetErrorMessage() == ""
    assert path.read_text() == "earlier work"
    assert os.listdir(tmp_path) == ["p.csv"]

    writer.RemoveObserver(tag)
    writer.SetAbortExecute(0)
    assert writer.Write() == 1
    assert path.read_text().count("\n") == 100001


FULL_DISK = """
import resource, signal, sys
import numpy as np, pyvista as pv
from spherepacking.vtkSpherePackingCore import vtkSpherePackingWriter
mesh = pv.PolyData(np.random.default_rng(0).normal(size=(50000, 3)))
mesh["radius"] = np.ones(50000)
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
resource.setrlimit(resource.RLIMIT_FSIZE, (100000, 100000))
writer = vtkSpherePackingWriter()
writer.SetInputData(mesh)
writer.SetFileName(sys.argv[1])
writer.AddObserver("ErrorEvent", lambda *_: None)
assert writer.Write() == 0
print(writer.GetErrorCode(), writer.GetErrorMessage())
"""


@pytest.mark.skipif(sys.platform == "win32", reason="needs a limit on the size of files")
def test_a_full_disk_loses_nothing(tmp_path):
    path = tmp_path / "p.spheres"
    path.write_text("earlier work")
    done = subprocess.run(
        [sys.executable, "-c", FULL_DISK, str(path)], capture_output=True, text=True, check=True
    )
    assert done.stdout.startswith(f"20007 {path}: writing stopped (File too large)")
    assert path.read_text() == "earlier work"
    assert os.listdir(tmp_path) == ["p.spheres"]
