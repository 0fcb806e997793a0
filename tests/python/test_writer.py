"""``spherepacking.write`` and ``PolyData.save``; formats are tested with the C++ writer."""

import numpy as np
import pytest
import pyvista as pv
import spherepacking
from drawing import packing


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
