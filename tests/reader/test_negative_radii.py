"""Radii below zero are refused, however close to zero they are rounded."""

import struct

import numpy as np
import pytest
import pyvista as pv
import spherepacking

BOX = "ITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\n"
DUMP = f"ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\n{BOX}ITEM: ATOMS id x y z radius\n"
# Each holds two spheres, the second of radius or diameter R.
FILES = {
    "p.spheres": "0 0 0 1\n1 2 3 R\n",
    "p.xyzr": "0 0 0 1\n1 2 3 R\n",
    "p.csv": "x,y,z,radius\n0,0,0,1\n1,2,3,R\n",
    "quoted.csv": 'x,y,z,radius\n0,0,0,1\n1,2,3,"R"\n',
    "diameter.csv": "x,y,z,diameter\n0,0,0,1\n1,2,3,R\n",
    "p.txt": "x y z r\n0 0 0 1\n1 2 3 R\n",
    "p.dump": DUMP + "1 0 0 0 1\n2 1 2 3 R\n",
    "p.xyz": "2\nProperties=species:S:1:pos:R:3:radius:R:1\nA 0 0 0 1\nB 1 2 3 R\n",
    "p.pqr": "ATOM 1 N ALA 1 0.0 0.0 0.0 0.1 1.0\nATOM 2 N ALA 1 1.0 2.0 3.0 0.1 R\n",
    "p.ma": "2 0 0\nv 0 0 0 1\nv 1 2 3 R\n",
}


def write(tmp_path, name, radius):
    head, _, tail = FILES[name].rpartition("R")
    text = head + radius + tail
    if name == "p.spheres":
        # Far from the end of the text the reader goes faster ways.
        text += 40 * "7.25 8.5 9.75 0.5\n"
    path = tmp_path / name
    path.write_text(text)
    return path


@pytest.mark.parametrize("precision", ["single", "double"])
@pytest.mark.parametrize("radius", ["-1e-222", "-1e-46", "-5e-324", "-0.00001e-400", "-1E-9999"])
@pytest.mark.parametrize("name", FILES)
def test_a_number_that_is_rounded_to_zero(tmp_path, name, radius, precision):
    """In single precision -1e-222 was taken, in double -1e-400."""
    path = write(tmp_path, name, radius)
    with pytest.raises(spherepacking.PackingFileError, match="expected a number that is not neg"):
        spherepacking.read(path, precision=precision)


@pytest.mark.parametrize("precision", ["single", "double"])
@pytest.mark.parametrize("radius", ["-0", "-0.0", "-0e5", "-00.000E-12", "1e-222", "0"])
@pytest.mark.parametrize("name", FILES)
def test_what_is_not_below_zero(tmp_path, name, radius, precision):
    packing = spherepacking.read(write(tmp_path, name, radius), precision=precision)
    expected = 1e-222 / (2 if name == "diameter.csv" else 1) if radius == "1e-222" else 0.0
    assert packing["radius"][1] == (0.0 if precision == "single" else expected)


@pytest.mark.parametrize("precision", ["single", "double"])
def test_binary_diameters(tmp_path, precision):
    path = tmp_path / "p.xyzd"
    path.write_bytes(struct.pack("<8d", 0, 0, 0, 1, 1, 2, 3, -5e-324))
    with pytest.raises(spherepacking.PackingFileError, match=r"diameter, expected .* not neg"):
        spherepacking.read(path, precision=precision)


@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_arrays_of_diameters(kind):
    """Half of the least number is 0."""
    points = pv.PolyData(np.eye(3))
    points["diameter"] = np.array([1, 1, -np.finfo(kind).smallest_subnormal], kind)
    with pytest.raises(ValueError, match=r"radius: found -.* in 'diameter', expected .* not neg"):
        points.packing.bounds  # noqa: B018


def test_radii_of_types():
    points = pv.PolyData(np.eye(3))
    points["type"] = [1, 2, 1]
    tiny = -np.finfo(np.longdouble).smallest_subnormal
    with pytest.raises(ValueError, match=r"radius: found -.*, expected a number that is not neg"):
        points.packing.ray_cast([(9, 0, 0), (0, 0, 0), (0, 0, 1)], (4, 4), radius={1: 1, 2: tiny})
