"""Files that hold no packing: a sentence says what they are."""

import pytest
import spherepacking

OTHERS = {
    "a.obj": (b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "found a surface, .*spherepacking pack"),
    "a.stl": (b"solid a\nendsolid a\n", "found a surface, .*spherepacking pack"),
    "a.ply": (b"ply\nformat ascii 1.0\nend_header\n", "found a surface, .*spherepacking pack"),
    "a.off": (b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "found a surface"),
    "a.gro": (b"water\n1\n    1SOL OW 1 0.1 0.2 0.3\n 1 1 1\n", "no radii, .*radius="),
    "a.h5": (b"\x89HDF\r\n\x1a\n" + bytes(100), "found an HDF5 file"),
    "a.npz": (b"PK\x03\x04" + bytes(100), "found arrays of NumPy, .*savetxt"),
    "a.xlsx": (b"PK\x03\x04" + bytes(100), "found a workbook of Excel, .*saved as CSV"),
    "a.txt": (b'[{"x":1,"y":2,"z":3,"r":1},{"x":1,"y":2,"z":3,"r":1}]\n', "found a file in JSON"),
    "a.csv": (b'{\n  "spheres": [[1, 2, 3, 1]]}\n', "found a file in JSON, expected text: x y z r"),
    "a.xyzr": (b"[[1, 2, 3, 0.5],\n [1, 2, 3, 0.5]]\n", "found a file in JSON"),
    "a.json": (b"[1, 2, 3, 0.5]\n", "found a file in JSON"),
    "a.zip": (b"PK\x03\x04" + bytes(100), "found a zip archive"),
    "a.spheres": (b"\x89PNG\r\n\x1a\n" + bytes(100), "found a picture"),
    "a.npy": (b"\x93NUMPY\x01\x00", "found an array of NumPy, .*savetxt"),
    "a.dat": (b"# vtk DataFile Version 3.0\nx\nASCII\n", r"file of VTK, expected .*\.vtk"),
    "a.xml": (b'<?xml version="1.0"?>\n<VTKFile type="PolyData">\n', r"file of VTK \(PolyData\)"),
    "traj.bin": (b"\xdfe\xdfe\xdfe\xdfe" + bytes(300), "found a GSD file"),
}


@pytest.mark.parametrize("name", OTHERS)
def test_a_sentence_says_what_a_file_is(tmp_path, name):
    data, message = OTHERS[name]
    (tmp_path / name).write_bytes(data)
    with pytest.raises(spherepacking.PackingFileError, match=message) as caught:
        spherepacking.read(tmp_path / name)
    assert str(caught.value).startswith(f"{tmp_path / name}: ")


def test_spheres_by_the_name_of_a_surface_are_read(tmp_path):
    (tmp_path / "a.obj").write_text("1 2 3 4\n")
    assert spherepacking.read(tmp_path / "a.obj")["radius"].tolist() == [4.0]


@pytest.mark.parametrize("text", ["[[1 2 3 4]\n [5 6 7 8]]\n", "[x, y, z, d]\n1 2 3\n", "{1,2}\n"])
def test_other_brackets_are_no_json(tmp_path, text):
    (tmp_path / "a.txt").write_text(text)
    with pytest.raises(spherepacking.PackingFileError) as caught:
        spherepacking.read(tmp_path / "a.txt")
    assert "JSON" not in str(caught.value)
