"""``spherepacking.write`` and ``PolyData.save``; formats are tested with the C++ writer."""

import numpy as np
import pytest
import pyvista as pv
import spherepacking
from drawing import packing


def save(mesh, path):
    mesh.save(path)


@pytest.mark.parametrize("write", [spherepacking.write, save])
def test_round_trip_is_exact(tmp_path, rng, write):
    mesh = pv.PolyData(rng.normal(size=(50, 3)))
    mesh["radius"] = rng.random(50)
    write(mesh, tmp_path / "a.spheres")
    back = pv.read(tmp_path / "a.spheres")
    order = np.argsort(-mesh["radius"], kind="stable")
    same = np.array_equal(back["radius"], mesh["radius"])
    expected = slice(None) if same else order
    assert np.array_equal(back["radius"], mesh["radius"][expected])
    assert np.array_equal(back.points, mesh.points[expected])


def test_what_is_no_packing(tmp_path):
    with pytest.raises(TypeError, match="packing is a ndarray, expected a PolyData"):
        spherepacking.write(np.eye(3), tmp_path / "a.spheres")


def test_missing_folder(tmp_path):
    with pytest.raises(FileNotFoundError, match="there is no folder"):
        spherepacking.write(packing(), tmp_path / "none" / "a.spheres")


def test_folder_instead_of_file(tmp_path):
    (tmp_path / "a.spheres").mkdir()
    with pytest.raises(IsADirectoryError, match=r"a\.spheres: is a directory"):
        spherepacking.write(packing(), tmp_path / "a.spheres")


def test_no_radii(tmp_path, capfd):
    path = tmp_path / "a.spheres"
    path.write_text("precious")
    with pytest.raises(spherepacking.PackingFileError, match="radius"):
        spherepacking.write(pv.PolyData(np.eye(3)), path)
    assert path.read_text() == "precious"
    assert capfd.readouterr() == ("", "")
