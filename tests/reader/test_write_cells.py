"""Dumps and extended XYZ as written: cell, time, all arrays, each read back to the last bit."""

import hypothesis
import hypothesis.strategies as st
import numpy as np
import pytest
import pyvista as pv

EXTENSIONS = ["dump", "lammpstrj", "liggghts", "xyz", "extxyz", "exyz"]


def packing_of(points=((1.0, 2.0, 3.0), (4.0, 5.0, 6.5)), radii=(0.5, 2.0)):
    packing = pv.PolyData(np.array(points))
    packing["radius"] = np.array(radii)
    return packing


def set_cell(packing, vectors, origin=(0, 0, 0), periodic=(1, 1, 1), time=None):
    packing.field_data["cell_vectors"] = np.asarray(vectors, float)
    packing.field_data["cell_origin"] = np.asarray(origin, float)
    packing.field_data["cell_periodic"] = np.asarray(periodic, np.uint8)
    if time is not None:
        packing.field_data["TimeValue"] = [time]
    return packing


def add_texts(packing, name, texts):
    array = pv._vtk.vtkStringArray()
    array.SetName(name)
    for text in texts:
        array.InsertNextValue(text)
    packing.GetPointData().AddArray(array)


def texts_of(packing, name):
    array = packing.GetPointData().GetAbstractArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())]


def check_same(back, packing):
    for name in ("cell_vectors", "cell_origin", "cell_periodic", "TimeValue"):
        if name in packing.field_data:
            assert np.array_equal(back.field_data[name], packing.field_data[name]), name
        else:
            assert name not in back.field_data or name == "TimeValue"
    assert np.array_equal(back.points, packing.points)
    for name in packing.point_data:
        assert np.asarray(back[name]).tolist() == np.asarray(packing[name]).tolist(), name


# --- the text, by the formats' own rules ----------------------------------------------------------


def test_the_text_of_a_dump(write, tmp_path):
    packing = set_cell(packing_of(), np.diag([10, 20, 30]), (-1, 0, 1), (1, 0, 1), 2500)
    packing["id"] = [7, 8]
    packing["velocity"] = np.arange(6.0).reshape(2, 3)
    packing["stress"] = np.arange(6.0).reshape(2, 3)
    add_texts(packing, "element", ["Fe", "Ω-3"])
    assert write(packing, tmp_path / "p.dump") == (True, "")
    assert (tmp_path / "p.dump").read_text("utf-8").splitlines() == [
        "ITEM: TIMESTEP",
        "2500",
        "ITEM: NUMBER OF ATOMS",
        "2",
        "ITEM: BOX BOUNDS pp ff pp",
        "-1 9",
        "0 20",
        "1 31",
        "ITEM: ATOMS x y z radius id vx vy vz stress_0 stress_1 stress_2 element",
        "1 2 3 0.5 7 0 1 2 0 1 2 Fe",
        "4 5 6.5 2 8 3 4 5 3 4 5 Ω-3",
    ]


def test_the_bounds_of_a_tilted_box(write, tmp_path):
    # LAMMPS: xlo_bound = xlo + min(0, xy, xz, xy + xz), ylo_bound = ylo + min(0, yz), and so on.
    packing = set_cell(packing_of(), [[8, 0, 0], [-2, 8, 0], [1, -3, 8]], (1, 2, 3))
    assert write(packing, tmp_path / "p.dump") == (True, "")
    assert (tmp_path / "p.dump").read_text().splitlines()[4:8] == [
        "ITEM: BOX BOUNDS xy xz yz pp pp pp",
        "-1 10 -2",
        "-1 10 1",
        "3 11 -3",
    ]


def test_a_box_that_is_turned(write, tmp_path):
    packing = set_cell(packing_of(), [[0, 8, 0], [8, 0, 0], [0, 0, 8]], (1, 2, 3))
    assert write(packing, tmp_path / "p.dump") == (True, "")
    assert (tmp_path / "p.dump").read_text().splitlines()[4:8] == [
        "ITEM: BOX BOUNDS abc origin pp pp pp",
        "0 8 0 1",
        "8 0 0 2",
        "0 0 8 3",
    ]


def test_a_dump_without_cell_and_time(write, tmp_path):
    assert write(packing_of(), tmp_path / "p.dump") == (True, "")
    assert (tmp_path / "p.dump").read_text().splitlines() == [
        "ITEM: TIMESTEP",
        "0",
        "ITEM: NUMBER OF ATOMS",
        "2",
        "ITEM: ATOMS x y z radius",
        "1 2 3 0.5",
        "4 5 6.5 2",
    ]


def test_the_text_of_extended_xyz(write, tmp_path):
    packing = set_cell(packing_of(), [[8, 0, 0], [-2, 8, 0], [1, -3, 8]], (1, 2, 3), (1, 1, 0), 0.5)
    packing["id"] = [7, 8]
    packing["velocity"] = np.arange(6.0).reshape(2, 3)
    add_texts(packing, "species", ["Fe", "Ω-3"])
    assert write(packing, tmp_path / "p.xyz") == (True, "")
    assert (tmp_path / "p.xyz").read_text("utf-8").splitlines() == [
        "2",
        'Lattice="8 0 0 -2 8 0 1 -3 8" Origin="1 2 3" pbc="T T F" Time=0.5 '
        "Properties=species:S:1:pos:R:3:radius:R:1:id:I:1:velocity:R:3",
        "Fe 1 2 3 0.5 7 0 1 2",
        "Ω-3 4 5 6.5 2 8 3 4 5",
    ]


def test_extended_xyz_without_cell_and_time(write, tmp_path):
    assert write(packing_of(), tmp_path / "p.xyz") == (True, "")
    assert (tmp_path / "p.xyz").read_text().splitlines() == [
        "2",
        "Properties=pos:R:3:radius:R:1",
        "1 2 3 0.5",
        "4 5 6.5 2",
    ]


# --- there and back -------------------------------------------------------------------------------

CELLS = {
    "orthogonal": np.diag([0.1, 20.3, 1e-7]),
    "tilted": [[0.1, 0, 0], [0.03, 0.7, 0], [-0.011, 0.3, 0.9]],
    "general": [[0.1, 0.2, 0.3], [-0.5, 0.7, 0.1], [0.2, 0.1, -0.9]],
    "flat": [[1, 0, 0], [0, 1, 0], [0, 0, 0]],
    "negative": np.diag([1.0, -1.0, 1.0]),
}


@pytest.mark.parametrize("extension", EXTENSIONS)
@pytest.mark.parametrize("cell", CELLS)
def test_all_is_read_back(rng, write, read, tmp_path, extension, cell):
    packing = packing_of(rng.normal(size=(50, 3)) * 1e3, rng.random(50))
    set_cell(packing, CELLS[cell], rng.normal(size=3), rng.integers(0, 2, 3), 0.1 + 0.2)
    packing["id"] = np.arange(50)
    packing["density"] = rng.normal(size=50)
    packing["velocity"] = rng.normal(size=(50, 3))
    packing["stress"] = rng.normal(size=(50, 3))
    add_texts(packing, "material", ["steel", "1", "glass", "ä", "x"] * 10)
    path = tmp_path / f"p.{extension}"
    assert write(packing, path) == (True, "")
    back = read(path)
    check_same(back, packing)
    assert texts_of(back, "material") == texts_of(packing, "material")
    # What was read has the parts as well, and is written and read again as it is.
    again_path = tmp_path / f"q.{extension}"
    assert write(back, again_path) == (True, "")
    again = read(again_path)
    check_same(again, back)
    assert set(again.point_data.keys()) == set(back.point_data.keys())
    # Only integers have become real numbers, as which all numbers are read.
    assert again_path.read_bytes() == path.read_bytes().replace(b"id:I", b"id:R")


@hypothesis.settings(suppress_health_check=[hypothesis.HealthCheck.function_scoped_fixture])
@hypothesis.given(
    values=st.lists(st.floats(-1e300, 1e300), min_size=12, max_size=12),
    zeros=st.sets(st.integers(0, 8)),
    extension=st.sampled_from(["dump", "xyz"]),
)
def test_any_cell_is_read_back(write, read, tmp_path, values, zeros, extension):
    vectors = np.array(values[:9])
    vectors[list(zeros)] = 0.0
    packing = set_cell(packing_of(), vectors.reshape(3, 3), values[9:])
    path = tmp_path / f"p.{extension}"
    assert write(packing, path) == (True, "")
    check_same(read(path), packing)


@pytest.mark.parametrize("extension", ["csv", "dump", "xyz"])
def test_parts_and_their_vector_are_written_once(write, read, read_text, tmp_path, extension):
    packing = read_text(
        "x,y,z,radius,vx,vy,vz,a_x,a_y,a_z,b_0,b_1,b_2\n1,2,3,4,5,6,7,8,9,10,11,12,13\n", "p.csv"
    )
    assert packing["velocity"].tolist() == [[5, 6, 7]]
    path = tmp_path / f"p.{extension}"
    assert write(packing, path) == (True, "")
    check_same(read(path), packing)
    assert len(path.read_text().splitlines()[-1].replace(",", " ").split()) == 13


@pytest.mark.parametrize("extension", ["csv", "dump", "xyz"])
def test_a_vector_that_is_not_its_parts_is_kept(write, read, tmp_path, extension):
    packing = packing_of()
    for name, value in zip(("vx", "vy", "vz"), (1.0, 2.0, 3.0), strict=True):
        packing[name] = np.full(2, value)
    packing["velocity"] = np.full((2, 3), 9.0)
    path = tmp_path / f"p.{extension}"
    good, message = write(packing, path)
    if extension == "dump":
        assert not good and "'vx' and 'vx', which name one thing twice" in message
    else:
        assert good
        assert 9 in [float(x) for x in path.read_text().splitlines()[-1].replace(",", " ").split()]


def test_texts_in_csv(write, read, tmp_path):
    packing = packing_of()
    add_texts(packing, "name", ["two words", "ä"])
    assert write(packing, tmp_path / "p.csv") == (True, "")
    assert texts_of(read(tmp_path / "p.csv"), "name") == ["two words", "ä"]


def test_single_precision_is_read_back(rng, write, read, tmp_path):
    packing = pv.PolyData(rng.random((20, 3)).astype(np.float32))
    packing["radius"] = rng.random(20).astype(np.float32)
    assert write(packing, tmp_path / "p.dump") == (True, "")
    back = read(tmp_path / "p.dump", single=True)
    assert np.array_equal(back.points, packing.points)
    assert np.array_equal(back["radius"], packing["radius"])


# --- what is refused ------------------------------------------------------------------------------


def spoiled(**fields):
    packing = packing_of()
    for name, value in fields.items():
        packing.field_data[name] = value
    return packing


def with_array(name):
    packing = packing_of()
    packing[name] = np.zeros(2)
    return packing


def with_texts(*texts):
    packing = packing_of()
    add_texts(packing, "name", texts)
    return packing


@pytest.mark.parametrize(
    ("packing", "extension", "message"),
    [
        (spoiled(cell_vectors=np.eye(2)), "dump", "cell_vectors: found 4 values, expected 9"),
        (spoiled(cell_vectors=np.full((3, 3), np.nan)), "xyz", "cell_vectors: found nan"),
        (spoiled(TimeValue=[np.inf]), "dump", "TimeValue: found inf, expected a finite number"),
        (spoiled(TimeValue=[np.nan]), "xyz", "TimeValue: found nan, expected a finite number"),
        (with_array("a b"), "dump", "'a b' has a separator"),
        (with_array("a:b"), "xyz", "'a:b' has a separator"),
        (with_array("pos"), "xyz", "found the name 'pos' twice, expected once"),
        (with_array("x"), "dump", "'x' and 'x', which name one thing twice"),
        (with_texts("a", "two words"), "dump", "'name' holds 'two words' at point 1"),
        (with_texts("a", "two words"), "xyz", "'name' holds 'two words' at point 1"),
        (with_texts("a", ""), "xyz", "'name' holds '' at point 1"),
        (with_texts("a", "b,c"), "csv", "'name' holds 'b,c' at point 1"),
        (with_texts("12", "b"), "dump", "expected texts without numbers at the first point"),
    ],
)
def test_what_would_not_be_read_back_is_refused(write, tmp_path, packing, extension, message):
    path = tmp_path / f"p.{extension}"
    path.write_text("earlier work")
    good, found = write(packing, path)
    assert not good
    assert str(path) in found and message in found
    assert path.read_text() == "earlier work"
