"""``spherepacking.write`` and ``PolyData.save``; formats are tested with the C++ writer."""

import numpy as np
import pytest
import pyvista as pv
import spherepacking
from drawing import packing
from spherepacking.files.writers import left_out


def save(mesh, path):
    mesh.save(path)


@pytest.mark.parametrize("write", [spherepacking.write, save])
@pytest.mark.parametrize("extension", ["spheres", "xyzr", "xyzd", "csv"])
def test_round_trip_is_exact(tmp_path, rng, write, extension):
    mesh = pv.PolyData(rng.normal(size=(50, 3)))
    mesh["radius"] = np.sort(rng.random(50))[::-1]
    write(mesh, tmp_path / f"a.{extension}")
    back = pv.read(tmp_path / f"a.{extension}")
    assert np.array_equal(back["radius"], mesh["radius"])
    assert np.array_equal(back.points, mesh.points)


def test_spheres_are_written_largest_first(tmp_path):
    mesh = packing(2)
    mesh["radius"] = [1.0, 2.0]
    spherepacking.write(mesh, tmp_path / "a.spheres")
    assert spherepacking.read(tmp_path / "a.spheres")["radius"].tolist() == [2.0, 1.0]


def test_unknown_extension(tmp_path):
    with pytest.raises(spherepacking.PackingFileError, match=r"a\.nonsense"):
        spherepacking.write(packing(), tmp_path / "a.nonsense")


def test_what_is_no_packing(tmp_path):
    with pytest.raises(TypeError, match="packing: found a ndarray, expected a PolyData"):
        spherepacking.write(np.eye(3), tmp_path / "a.spheres")


def test_missing_folder(tmp_path):
    with pytest.raises(FileNotFoundError, match="there is no folder"):
        spherepacking.write(packing(), tmp_path / "none" / "a.spheres")


def test_folder_instead_of_file(tmp_path):
    (tmp_path / "a.spheres").mkdir()
    with pytest.raises(IsADirectoryError, match=r"a\.spheres: found a directory"):
        spherepacking.write(packing(), tmp_path / "a.spheres")


def test_no_radii(tmp_path, capfd):
    path = tmp_path / "a.spheres"
    path.write_text("precious")
    with pytest.raises(spherepacking.PackingFileError, match="radius"):
        spherepacking.write(pv.PolyData(np.eye(3)), path)
    assert path.read_text() == "precious"
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize("extension", ["vtp", "vtu", "vtk"])
def test_files_of_vtk_hold_everything(tmp_path, rng, extension):
    mesh = pv.PolyData(rng.normal(size=(5, 3)))
    mesh["radius"] = rng.random(5)
    mesh["velocity"] = rng.normal(size=(5, 3))
    mesh["element"] = list("CHCON")
    mesh.field_data["cell_vectors"] = np.diag([1.0, 2.0, 3.0])
    path = tmp_path / f"a.{extension}"
    path.write_text("earlier")
    path.chmod(0o640)
    spherepacking.write(mesh, path)
    assert path.stat().st_mode & 0o777 == 0o640
    assert list(tmp_path.iterdir()) == [path]
    back = spherepacking.read(path)
    assert np.array_equal(back.points, mesh.points)
    for name in ("radius", "velocity", "element"):
        assert np.array_equal(back[name], mesh[name])
    assert np.array_equal(back.field_data["cell_vectors"], np.diag([1.0, 2.0, 3.0]))


def test_any_dataset_with_given_radii(tmp_path):
    path = tmp_path / "a.xyzr"
    grid = pv.ImageData(dimensions=(2, 1, 1))
    spherepacking.write(grid, path, radius=[0.25, 0.5])
    assert spherepacking.read(path)["radius"].tolist() == [0.25, 0.5]
    grid["Diameter"] = [1.0, 4.0]
    spherepacking.write(pv.MultiBlock([grid, grid]), path)
    assert spherepacking.read(path)["radius"].tolist() == [0.5, 2.0] * 2
    with pytest.raises(spherepacking.PackingFileError, match=r"a\.xyzr: .*no point array 'size'"):
        spherepacking.write(grid, path, radius="size")


@pytest.mark.parametrize("time", [2.5, -0.1, 1e300, 0.0, 100.0, -3.0, 2.0**53])
def test_the_time_of_a_dump(tmp_path, time):
    """LAMMPS counts steps by whole numbers; ITEM: TIME is what it writes before them."""
    mesh = packing(2)
    mesh.field_data["TimeValue"] = [time]
    path = tmp_path / "a.dump"
    spherepacking.write(mesh, path)
    lines = path.read_text().splitlines()
    assert lines[lines.index("ITEM: TIMESTEP") + 1].lstrip("-").isdigit()
    assert ("ITEM: TIME" in lines) == (not time.is_integer() or time == 1e300)
    assert spherepacking.read(path).field_data["TimeValue"].tolist() == [time]
    assert spherepacking.steps(path).times == [time]


@pytest.mark.parametrize("extension", ["spheres", "xyzr", "xyzd", "txt", "csv"])
def test_the_time_that_is_left_out_is_named(tmp_path, extension):
    mesh = packing(2)
    mesh.field_data["TimeValue"] = [2.5]
    sentence = left_out(mesh, tmp_path / f"a.{extension}")
    assert sentence.endswith("alone: left out the time")
    assert left_out(mesh, "a.dump") is None
    assert left_out(mesh, "a.xyz") is None
