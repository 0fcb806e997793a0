"""``radius="NAME"`` with the name that the file gives the column of its radii."""

import gzip

import numpy as np
import pytest
import spherepacking
from spherepacking.cli.main import main
from spherepacking.files.errors import PackingFileError

DUMP = (
    "ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n"
    "0 9\n0 9\n0 9\nITEM: ATOMS id x y z {name}\n7 1.5 2 3 4\n"
)
LAMMPS = "LAMMPS data file\n\n1 atoms\n\nAtoms # sphere\n\n1 1 4 1.5 1 2 3\n"
XYZ = "1\nProperties=species:S:1:pos:R:3:{property}\nC 1.5 2 3 {row}\n"

# Each a file whose sphere is of radius 4, or of diameter 4.
FILES = [
    *(("a.csv", f"x,y,z,{name}\n1.5,2,3,4\n", name, 4.0) for name in ("r", "R", "Radius", "Rp")),
    *(("a.csv", f"x,y,z,{name}\n1.5,2,3,4\n", name, 4.0) for name in ("radius_mm", "r_eff")),
    *(("a.csv", f"x,y,z,{name}\n1.5,2,3,4\n", name, 2.0) for name in ("d", "diameter", "d_eq")),
    *(
        ("a.csv", f"x,y,z,{name}\n1.5,2,3,4\n", name, 2.0)
        for name in ("Durchmesser", "pore.diameter")
    ),
    ("a.csv", '"x [mm]","y [mm]","z [mm]","r [mm]"\n1.5,2,3,4\n', "r [mm]", 4.0),
    ("a.txt", "# x y z d\n1.5 2 3 4\n", "d", 2.0),
    ("a.txt", "#format x_y_z_r\n1.5 2 3 4\n", "r", 4.0),
    ("a.dump", DUMP.format(step=0, name="diameter"), "diameter", 2.0),
    ("a.xyz", XYZ.format(property="diameter:R:1", row="4"), "diameter", 2.0),
    ("a.xyz", XYZ.format(property="d:R:1", row="4"), "d", 2.0),
    ("a.xyz", XYZ.format(property="radii:R:3", row="4 4 4"), "radii", 4.0),
    ("a.data", LAMMPS, "diameter", 2.0),
]


@pytest.mark.parametrize(("name", "text", "column", "radius"), FILES)
def test_the_name_of_the_column_that_became_the_radii(tmp_path, name, text, column, radius):
    path = tmp_path / name
    path.write_text(text)
    without = spherepacking.read(path)
    packing = spherepacking.read(path, radius=column)
    assert packing["radius"].tolist() == without["radius"].tolist() == [radius]
    assert packing.point_data.keys() == without.point_data.keys()
    assert packing.point_data.active_scalars_name == "radius"
    single = spherepacking.read(path, radius=column, precision="single")
    assert single["radius"].tolist() == [radius]


def test_a_name_that_the_user_gave(tmp_path):
    path = tmp_path / "a.txt"
    path.write_text("7 1.5 2 3 4\n")
    packing = spherepacking.read(path, columns="id x y z d", radius="d")
    assert packing["radius"].tolist() == [2.0]


def test_a_name_beside_a_plainer_one(tmp_path):
    path = tmp_path / "a.csv"
    path.write_text("x,y,z,radius,d,Rp\n1.5,2,3,4,5,6\n")
    for name, radius in (("radius", 4.0), ("d", 2.5), ("Rp", 6.0)):
        assert spherepacking.read(path, radius=name)["radius"].tolist() == [radius]


def test_in_each_step_and_compressed(tmp_path):
    path = tmp_path / "a.dump.gz"
    both = DUMP.format(step=0, name="diameter") + DUMP.format(step=1, name="radius")
    path.write_bytes(gzip.compress(both.encode()))
    steps = spherepacking.steps(path, radius="diameter")
    assert steps[0]["radius"].tolist() == [2.0]
    # The other step has no such column; what the one before was called does not count.
    with pytest.raises(PackingFileError, match=r"'diameter', its point arrays are: radius, id"):
        steps[1]
    assert steps[0]["radius"].tolist() == [2.0]


def test_in_a_gsd_file(tmp_path):
    hoomd = pytest.importorskip("gsd.hoomd")
    frame = hoomd.Frame()
    frame.particles.N = 1
    frame.particles.position = [[0, 0, 0]]
    frame.particles.diameter = [4.0]
    frame.configuration.box = [9, 9, 9, 0, 0, 0]
    with hoomd.open(str(tmp_path / "a.gsd"), "w") as file:
        file.append(frame)
    packing = spherepacking.read(tmp_path / "a.gsd", radius="diameter")
    assert packing["radius"].tolist() == [2.0]


def test_other_names_are_still_refused(tmp_path):
    path = tmp_path / "a.csv"
    path.write_text("x,y,z,Durchmesser\n1.5,2,3,4\n")
    for name in ("durchmesser", "Durchmesse", "", "x"):
        with pytest.raises(PackingFileError, match="no point array"):
            spherepacking.read(path, radius=name)


def test_on_the_command_line(tmp_path, capfd):
    path = tmp_path / "d.csv"
    path.write_text("x,y,z,diameter\n1.5,2,3,4\n9,9,9,4\n")
    assert main(["info", str(path), "--radius", "diameter"]) == 0
    assert "radius   2 .. 2" in capfd.readouterr().out


def test_the_reader_has_the_name(tmp_path):
    from spherepacking.vtkSpherePackingCore import vtkSpherePackingReader

    path = tmp_path / "a.csv"
    path.write_text("x,y,z,Durchmesser\n1.5,2,3,4\n")
    reader = vtkSpherePackingReader()
    assert reader.GetRadiusName() == ""
    reader.SetFileName(str(path))
    reader.Update()
    assert reader.GetRadiusName() == "Durchmesser"
    assert np.isclose(reader.GetOutput().GetPointData().GetArray("radius").GetValue(0), 2.0)
    path.write_text("x,y,z,w\n1.5,2,3,4\n")
    reader.SetRadiusOptional(True)
    reader.Modified()
    reader.Update()
    assert reader.GetRadiusName() == ""
