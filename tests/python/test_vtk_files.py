"""Packings in files of VTK; the values are those of the texts here."""

import re

import numpy as np
import pytest
import pyvista as pv
import spherepacking
from spherepacking.datasets import packing_of

LEGACY = """# vtk DataFile Version 3.0
made up
ASCII

DATASET POLYDATA
POINTS 2 float
0.5 0.25 0
2 0 0.75

POINT_DATA 2
SCALARS {name} double 1
LOOKUP_TABLE default
0.04938271605
0.125
"""
XML = """<?xml version="1.0"?>
<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian">
<PolyData>
<Piece NumberOfPoints="2" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="0">
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">0.5 0.25 0  2 0 0.75
</DataArray></Points>
<PointData><DataArray type="Float64" Name="{name}" format="ascii">0.5 0.125</DataArray></PointData>
</Piece>
</PolyData>
</VTKFile>
"""
POINTS = np.array([[0.5, 0.25, 0.0], [2.0, 0.0, 0.75]])
RADII = [0.5, 0.125]


def check(packing, radii=RADII):
    assert isinstance(packing, pv.PolyData)
    assert packing.points.tolist() == POINTS.tolist()
    assert packing.points.dtype == np.float64
    assert packing["radius"].tolist() == radii
    assert packing.point_data.active_scalars_name == "radius"
    assert packing.n_verts == packing.n_cells == 2


def dataset(kind):
    points = pv.PolyData(POINTS)
    if kind == "UnstructuredGrid":
        points = points.cast_to_unstructured_grid()
    points["radius"] = RADII
    points["id"] = [7, 9]
    points["velocity"] = np.arange(6.0).reshape(2, 3)
    return points


def test_points_without_vertices_and_floats_beside_doubles(tmp_path):
    (tmp_path / "a.vtk").write_text(LEGACY.format(name="radius"))
    check(spherepacking.read(tmp_path / "a.vtk"), [0.04938271605, 0.125])
    single = spherepacking.read(tmp_path / "a.vtk", precision="single")
    assert single.points.dtype == np.float32


@pytest.mark.parametrize("name", ["radius", "Radius", "radii"])
def test_xml_in_text(tmp_path, name):
    (tmp_path / "a.vtp").write_text(XML.format(name=name))
    check(spherepacking.read(tmp_path / "a.vtp"))


def test_diameters_are_halved(tmp_path):
    (tmp_path / "a.vtp").write_text(XML.format(name="Diameter"))
    check(spherepacking.read(tmp_path / "a.vtp"), [0.25, 0.0625])


@pytest.mark.parametrize(
    ("kind", "extension"),
    [
        ("PolyData", ".vtp"),
        ("PolyData", ".vtk"),
        ("PolyData", ".vtkhdf"),
        ("UnstructuredGrid", ".vtu"),
        ("UnstructuredGrid", ".vtk"),
        ("UnstructuredGrid", ".vtkhdf"),
    ],
)
def test_files_that_pyvista_wrote(tmp_path, kind, extension):
    path = tmp_path / f"a{extension}"
    dataset(kind).save(path)
    packing = spherepacking.read(path)
    check(packing)
    assert packing["id"].tolist() == [7, 9]
    assert packing["velocity"].tolist() == [[0, 1, 2], [3, 4, 5]]


def test_blocks(tmp_path):
    second = dataset("UnstructuredGrid")
    second.points = second.points + 10.0
    pv.MultiBlock([dataset("PolyData"), second]).save(tmp_path / "a.vtm")
    packing = spherepacking.read(tmp_path / "a.vtm")
    assert packing.points.tolist() == [*POINTS.tolist(), *(POINTS + 10.0).tolist()]
    assert packing["radius"].tolist() == RADII * 2
    assert packing["id"].tolist() == [7, 9, 7, 9]


def test_blocks_of_which_one_has_no_radii(tmp_path):
    wall = pv.Plane(i_resolution=1, j_resolution=1)
    pv.MultiBlock({"grains": dataset("PolyData"), "wall": wall}).save(tmp_path / "a.vtm")
    expected = r"found no radii in the block 'wall', but in 'grains', expected"
    with pytest.raises(spherepacking.PackingFileError, match=expected):
        spherepacking.read(tmp_path / "a.vtm")
    with pytest.raises(spherepacking.PackingFileError, match=expected):
        spherepacking.read(tmp_path / "a.vtm", radius="radius")
    with pytest.raises(ValueError, match=expected):
        packing_of(pv.read(tmp_path / "a.vtm"))
    assert spherepacking.read(tmp_path / "a.vtm", radius=0.5).n_points == 6
    assert packing_of(pv.read(tmp_path / "a.vtm")["grains"]).n_points == 2


def test_an_image(tmp_path):
    image = pv.ImageData(dimensions=(2, 1, 1), spacing=(3.0, 1.0, 1.0))
    image["radius"] = RADII
    image.save(tmp_path / "a.vti")
    packing = spherepacking.read(tmp_path / "a.vti")
    assert packing.points.tolist() == [[0, 0, 0], [3, 0, 0]]
    assert packing["radius"].tolist() == RADII


def test_pieces(tmp_path):
    dataset("UnstructuredGrid").save(tmp_path / "piece.vtu")
    (tmp_path / "a.pvtu").write_text(
        '<VTKFile type="PUnstructuredGrid" version="0.1"><PUnstructuredGrid GhostLevel="0">'
        '<PPoints><PDataArray type="Float64" NumberOfComponents="3"/></PPoints>'
        '<PPointData><PDataArray type="Float64" Name="radius"/></PPointData>'
        '<Piece Source="piece.vtu"/></PUnstructuredGrid></VTKFile>'
    )
    check(spherepacking.read(tmp_path / "a.pvtu"))
    (tmp_path / "piece.vtu").unlink()
    with pytest.raises(spherepacking.PackingFileError, match=r"a\.pvtu: found no dataset that VTK"):
        spherepacking.read(tmp_path / "a.pvtu")


@pytest.mark.parametrize("radius", [None, 0.5, "d", {1: 0.5}])
def test_no_spheres_are_a_packing(tmp_path, radius):
    pv.PolyData().save(tmp_path / "a.vtp")
    # So LIGGGHTS writes the first step of a run that pours.
    (tmp_path / "a.vtk").write_text(
        "# vtk DataFile Version 2.0\nx\nASCII\nDATASET POLYDATA\n"
        "POINTS 0 float\nVERTICES 0 0\nPOINT_DATA 0\n"
    )
    for name in ("a.vtp", "a.vtk"):
        packing = spherepacking.read(tmp_path / name, radius=radius)
        assert packing.n_points == 0
        assert packing["radius"].tolist() == []


VELOCITIES = {
    "v": ["v"],
    "vel": ["vel"],
    "velo": ["velo"],
    "Velocity": ["Velocity"],
    "parts": ["vx", "vy", "vz"],
    "Parts": ["Vx", "Vy", "Vz"],
    "brackets": ["velocity[0]", "velocity[1]", "velocity[2]"],
    "numbers": ["vel_0", "vel_1", "vel_2"],
    "letters": ["v_x", "v_y", "v_z"],
    "colons": ["velocity:0", "velocity:1", "velocity:2"],
}


@pytest.mark.parametrize("case", VELOCITIES)
def test_velocities_by_any_name(tmp_path, case):
    velocity = np.array([[1.0, 2.0, 3.0], [-4.0, 0.5, 0.25]])
    mesh = dataset("PolyData")
    del mesh.point_data["velocity"]
    names = VELOCITIES[case]
    for name, values in zip(names, [velocity] if len(names) == 1 else velocity.T, strict=True):
        mesh[name] = values
    mesh.save(tmp_path / "a.vtp")
    packing = spherepacking.read(tmp_path / "a.vtp")
    assert packing["velocity"].tolist() == velocity.tolist()
    assert set(names) <= set(packing.point_data)
    mesh["velocity"] = np.zeros((2, 3))
    mesh.save(tmp_path / "a.vtp")
    assert spherepacking.read(tmp_path / "a.vtp")["velocity"].tolist() == [[0, 0, 0]] * 2


def test_a_number_called_v_is_no_velocity(tmp_path):
    mesh = dataset("PolyData")
    del mesh.point_data["velocity"]
    mesh["v"] = [1.0, 2.0]
    mesh.save(tmp_path / "a.vtp")
    assert "velocity" not in spherepacking.read(tmp_path / "a.vtp").point_data


# --- radii that are not there, or given -----------------------------------------------------------


def test_no_radii_names_the_arrays(tmp_path):
    (tmp_path / "a.vtp").write_text(XML.format(name="mass"))
    with pytest.raises(
        spherepacking.PackingFileError, match=r"a\.vtp: .*no point array 'radius'.*mass; radius='NA"
    ):
        spherepacking.read(tmp_path / "a.vtp")
    check(spherepacking.read(tmp_path / "a.vtp", radius="mass"))
    check(spherepacking.read(tmp_path / "a.vtp", radius=[0.5, 0.125]))
    check(spherepacking.read(tmp_path / "a.vtp", radius=2), [2.0, 2.0])
    with pytest.raises(spherepacking.PackingFileError, match=r"a\.vtp: .*'size'.*mass"):
        spherepacking.read(tmp_path / "a.vtp", radius="size")


def test_no_arrays_say_how_to_give_radii(tmp_path):
    pv.PolyData(np.array(POINTS)).save(tmp_path / "a.vtp")
    with pytest.raises(spherepacking.PackingFileError, match=r"none; radius=0\.5 gives all"):
        spherepacking.read(tmp_path / "a.vtp")


def test_an_angle_makes_r_a_distance(tmp_path):
    mesh = pv.PolyData(np.array(POINTS))
    for name in ("r", "theta", "phi"):
        mesh[name] = RADII
    mesh.save(tmp_path / "a.vtp")
    with pytest.raises(
        spherepacking.PackingFileError, match=r"a\.vtp: .* the array r beside theta"
    ):
        spherepacking.read(tmp_path / "a.vtp")
    assert spherepacking.read(tmp_path / "a.vtp", radius="r")["radius"].tolist() == RADII


@pytest.mark.parametrize("name", ["d", "D"])
def test_a_diameter_is_halved_when_named(tmp_path, name):
    (tmp_path / "a.vtp").write_text(XML.format(name=name))
    for radius in (None, name):
        check(spherepacking.read(tmp_path / "a.vtp", radius=radius), [0.25, 0.0625])


def test_a_surface_is_not_a_packing(tmp_path):
    pv.Sphere().save(tmp_path / "a.vtp")
    with pytest.raises(spherepacking.PackingFileError, match=r"Normals; .*spherepacking pack"):
        spherepacking.read(tmp_path / "a.vtp")


# --- damaged files --------------------------------------------------------------------------------

DAMAGED = {
    "cut.vtp": XML.format(name="radius")[:300],
    "short.vtp": XML.format(name="radius").replace("0.5 0.125", "0.5"),
    "points.vtp": XML.format(name="radius").replace("  2 0 0.75", ""),
    "large.vtp": XML.format(name="radius").replace('Points="2"', 'Points="99999999999"'),
    "cut.vtk": LEGACY.format(name="radius")[:100],
    "large.vtk": LEGACY.format(name="radius").replace("POINTS 2", "POINTS 99999999999"),
    "large-data.vtk": LEGACY.format(name="radius").replace("DATA 2", "DATA 99999999999"),
    "nothing.vtk": "",
    "text.vtu": "0 0 0 1\n",
    "negative.vtp": XML.format(name="radius").replace("0.125", "-1"),
    "nan.vtk": LEGACY.format(name="radius").replace("0.125", "nan"),
    "hdf.vtkhdf": "\x89HDF",
}


@pytest.mark.parametrize("name", DAMAGED)
def test_one_error_names_the_file(tmp_path, capfd, name):
    (tmp_path / name).write_text(DAMAGED[name])
    with pytest.raises(spherepacking.PackingFileError) as caught:
        spherepacking.read(tmp_path / name)
    assert re.match(rf"{re.escape(str(tmp_path / name))}(, line \d+)?: ", str(caught.value))
    assert "\n" not in str(caught.value)
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize("binary", [False, True])
@pytest.mark.parametrize("attribute", ["Components", "Points", "Tuples"])
@pytest.mark.parametrize("value", ["-1", " -1", "+3000000000", "500000000", "-3000000000"])
def test_counts_that_would_end_the_process(tmp_path, binary, attribute, value):
    mesh = dataset("PolyData")
    mesh.field_data["t"] = [1.0]
    mesh.save(tmp_path / "a.vtp", binary=binary)
    text = (tmp_path / "a.vtp").read_bytes()
    wrong, count = re.subn(
        rf'NumberOf{attribute}="\d+"'.encode(), f'NumberOf{attribute}="{value}"'.encode(), text
    )
    assert count
    (tmp_path / "b.vtp").write_bytes(wrong)
    with pytest.raises(spherepacking.PackingFileError, match=r"b\.vtp: found (the count|\S+ comp)"):
        spherepacking.read(tmp_path / "b.vtp")


@pytest.mark.parametrize("text", [False, True])
@pytest.mark.parametrize("binary", [False, True])
@pytest.mark.parametrize("kind", ["PolyData", "UnstructuredGrid"])
def test_a_legacy_file_that_ends_early_is_never_read_wrongly(tmp_path, kind, binary, text):
    """VTK takes what memory holds for the values that are not there."""
    mesh = dataset(kind)
    mesh["stress"] = np.arange(18.0).reshape(2, 9)
    if text:
        mesh["element"] = ["C", "helium"]
    whole, cut = tmp_path / "a.vtk", tmp_path / "b.vtk"
    mesh.save(whole, binary=binary)
    data = whole.read_bytes()
    check(spherepacking.read(whole))
    refused = 0
    for end in range(0, len(data), 3):
        cut.write_bytes(data[:end])
        try:
            check(spherepacking.read(cut))
        except spherepacking.PackingFileError:
            refused += 1
    # All but some ends of sections behind the radii.
    assert refused > 0.9 * len(data) / 3


def test_names_of_columns_are_for_tables(tmp_path):
    (tmp_path / "a.vtp").write_text(XML.format(name="radius"))
    with pytest.raises(spherepacking.PackingFileError, match="names of columns for a file of"):
        spherepacking.read(tmp_path / "a.vtp", columns="x y z r")
