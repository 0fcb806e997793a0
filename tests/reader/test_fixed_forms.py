"""Formats in which a line has its meaning by its place, against values written down by hand."""

import re

import numpy as np
import pytest
import spherepacking


def check(packing, spheres):
    rows = np.column_stack([packing.points, packing["radius"]])
    assert rows.tolist() == [list(map(float, sphere)) for sphere in spheres]
    assert packing.active_scalars_name == "radius"


def texts(packing, name):
    return [str(value) for value in packing[name]]


# --- Sphere-Tree Construction Toolkit -------------------------------------------------------------

TREE = """3 2
0 0 0 1.5 1
0.5 0 0 0.6 0.9
-0.5 0 0 -1 0
0.75 0 0 0.3 0.8
0.25 0 0 0.25 0.7
0 0 0 -1 0
-0.75 0 0 0.125 0.5
"""


def test_tree_of_the_toolkit(read_text):
    packing = read_text(TREE, "p.sph")
    spheres = [
        *((0, 0, 0, 1.5), (0.5, 0, 0, 0.6), (0.75, 0, 0, 0.3)),
        *((0.25, 0, 0, 0.25), (-0.75, 0, 0, 0.125)),
    ]
    check(packing, spheres)
    assert packing["level"].tolist() == [1, 2, 3, 3, 3]
    assert packing["parent"].tolist() == [-1, 0, 1, 1, -1]  # the parent of the last is not there
    assert packing["occupancy"].tolist() == [1, 0.9, 0.8, 0.7, 0.5]
    assert read_text(TREE, "p.txt", fmt="SPHERE_TREE").n_points == 5
    single = read_text(TREE, "p.sph", single=True)
    assert single["radius"].tolist() == packing["radius"].astype(np.float32).tolist()


def test_what_the_commands_of_the_toolkit_append(read_text):
    end = "\n\nOptions :\n\tdepth\t: 3\n\terFact\t: 2.000000\n\n\nEvaluation :\n\tLevel 0\n"
    assert read_text(TREE + end, "p.sph").n_points == 5
    assert read_text(TREE + "Evaluation :\n\t\tNum\t: 1\n", "p.sph").n_points == 5


def test_trees_without_occupancy_and_with_auxiliary_spheres(read_text):
    packing = read_text("2 1\n0 0 0 2\n0 1 0 1\n", "p.sph")
    check(packing, [(0, 0, 0, 2), (0, 1, 0, 1)])
    assert packing.array_names == ["radius", "level", "parent"]
    check(read_text("2 1\n0 0 0 2 9 9 9 9 9\n0 1 0 1\n", "p.sph"), [(0, 0, 0, 2), (0, 1, 0, 1)])
    packing = read_text("2 1\n0 0 0 2 0.5 9 9 9 9 9\n0 1 0 1 0.25\n", "p.sph")
    check(packing, [(0, 0, 0, 2), (0, 1, 0, 1)])
    assert packing["occupancy"].tolist() == [0.5, 0.25]


def test_trees_of_one_level_or_one_child(read_text):
    check(read_text("1 8\n1 2 3 4 1\n", "p.sph"), [(1, 2, 3, 4)])
    packing = read_text("3 1\n0 0 0 3 1\n0 0 0 2 1\n0 0 0 1 1\n", "p.sph")
    assert packing["parent"].tolist() == [-1, 0, 1]


# --- DOCK -----------------------------------------------------------------------------------------

DOCK = """DOCK 3.5 receptor_spheres
red
cluster     1   number of spheres in cluster     2
    7   1.25000  -2.50000   3.75000   1.400   12 1  0
    9  -1.00000   2.00000   0.50000   3.125   15 1  0
cluster     2   number of spheres in cluster     1
   11-123.12500-456.25000-789.50000   1.40099999 2  1
cluster     0   number of spheres in cluster     0
"""


@pytest.mark.parametrize("name", ["p.sph", "p.txt", "p"])
def test_clusters_of_dock(read_text, name):
    packing = read_text(DOCK, name)
    check(packing, [(1.25, -2.5, 3.75, 1.4), (-1, 2, 0.5, 3.125), (-123.125, -456.25, -789.5, 1.4)])
    assert packing["cluster"].tolist() == [1, 1, 2]
    assert packing["atom"].tolist() == [7, 9, 11]
    assert packing["second_atom"].tolist() == [12, 15, 99999]
    assert packing["critical_cluster"].tolist() == [1, 1, 2]
    assert packing["color"].tolist() == [0, 0, 1]


def test_rows_of_dock_by_other_programs(read_text):
    text = "title\ncluster 1 number of spheres in cluster 2\n1 1.5 2 3 0.75\n2 4 5 6 1\n"
    packing = read_text(text, "p.sph")
    check(packing, [(1.5, 2, 3, 0.75), (4, 5, 6, 1)])
    assert packing.array_names == ["radius", "cluster", "atom"]


# --- HOLE -----------------------------------------------------------------------------------------

HOLE = """ATOM      1  QSS SPH S   0       1.250  -2.500   3.750  1.40  1.40
ATOM      1  QSS SPH S  -1       1.250  -2.500   4.000  1.50  0.00
ATOM      1  QSS SPH S-888    -101.250-202.500-304.000  7.25999.99
LAST-REC-END
"""


@pytest.mark.parametrize("name", ["p.sph", "p.pdb", "p.txt"])
def test_spheres_of_hole(read_text, name):
    packing = read_text(HOLE, name)
    spheres = [
        *((1.25, -2.5, 3.75, 1.4), (1.25, -2.5, 4, 1.5), (-101.25, -202.5, -304, 7.25)),
    ]
    check(packing, spheres)
    assert packing["plane"].tolist() == [0, -1, -888]
    assert packing["end"].tolist() == [0, 0, 1]
    assert texts(packing, "name") == ["QSS"] * 3


def test_capsules_of_hole_are_two_spheres(read_text):
    text = (
        "ATOM      1  QC1 SPH S   3       0.000   0.000   0.000  3.00  0.00\n"
        "ATOM      1  QC2 SPH S   3       0.500   0.000   0.000  3.00  0.00\n"
        "SPHBOX    1.0000   2.0000   3.0000\n"
    )
    packing = read_text(text, "p.sph")
    check(packing, [(0, 0, 0, 3), (0.5, 0, 0, 3)])
    assert texts(packing, "name") == ["QC1", "QC2"]


# --- SWC ------------------------------------------------------------------------------------------

SWC = """# ORIGINAL_SOURCE made up
 1 1 0.5 1.5 2.5 6.25 -1
 2 3 1.5 1.5 2.5 0.75 1
 5 3 2.5 1.5 2.5 0.5 2
"""


@pytest.mark.parametrize("name", ["p.swc", "p.SWC", "p.txt", "p"])
def test_samples_of_a_neuron(read_text, name):
    packing = read_text(SWC, name)
    check(packing, [(0.5, 1.5, 2.5, 6.25), (1.5, 1.5, 2.5, 0.75), (2.5, 1.5, 2.5, 0.5)])
    assert packing["id"].tolist() == [1, 2, 5]
    assert packing["type"].tolist() == [1, 3, 3]
    assert packing["parent"].tolist() == [-1, 1, 2]


@pytest.mark.parametrize("ids", [(2, 1), (1, 1)], ids=["backwards", "repeated"])
def test_samples_by_content_in_any_order(read_text, ids):
    text = f"7 1 0 0 0 2 -1\n{ids[0]} 3 1 0 0 0.5 {ids[1]}\n{ids[1]} 3 1 1 0 0.5 7\n"
    assert read_text(text, "p.txt")["radius"].tolist() == [2, 0.5, 0.5]


def test_an_extended_swc_file(read_text):
    text = (
        "#name a\n##n,type,x,y,z,radius,parent,seg_id,level,mode,timestamp,teraflyindex\n"
        "1 2 0.5 1.5 2.5 6.25 -1 0 1 0 16000 7\n2 2 1.5 1.5 2.5 0.5 1 0 2 0 16001 7\n"
    )
    packing = read_text(text, "p.eswc")
    assert packing.points.tolist() == [[0.5, 1.5, 2.5], [1.5, 1.5, 2.5]]
    assert packing["radius"].tolist() == [6.25, 0.5]
    assert packing["parent"].tolist() == [-1, 1]
    assert packing["column_9"].tolist() == [1, 2]
    assert packing["column_11"].tolist() == [16000, 16001]


def test_a_swc_file_by_name_may_be_in_any_order_and_have_further_columns(read_text):
    packing = read_text("2 3 1 0 0 0.5 1 9\n1 1 0 0 0 2 -1 8\n", "p.swc")
    check(packing, [(1, 0, 0, 0.5), (0, 0, 0, 2)])
    assert packing["column_8"].tolist() == [9, 8]


@pytest.mark.parametrize(
    "text",
    [
        "# x y z r a b c\n1 1 0 5 1 6 -1\n2 3 1 5 2 7 1\n",  # a comment names the columns
        "1.0 1 0 5 1 6 -1\n2.0 3 1 5 2 7 1\n",  # no ids
        "1 1 0 5 1 6 -1\n2 3 1 5 2 7 9\n",  # a parent that is not there
    ],
)
def test_other_tables_of_seven_columns_are_no_swc(text, tmp_path, reader_for):
    path = tmp_path / "p.txt"
    path.write_text(text)
    reader = reader_for(path)
    reader.Update()
    names = [
        reader.GetOutput().GetPointData().GetArrayName(i)
        for i in range(reader.GetOutput().GetPointData().GetNumberOfArrays())
    ]
    assert "parent" not in names


# --- GenGeo ---------------------------------------------------------------------------------------

GEO = """LSMGeometry 1.2
BoundingBox -1 -2 -3 10 20 30
PeriodicBoundaries 1 0 0
Dimension 3D
BeginParticles
Simple
2
1 1.5 2 0.5 0 1
3 3.5 4 1e0 1 7
EndParticles
BeginConnect
1
0 1 0
EndConnect
"""


@pytest.mark.parametrize("name", ["p.geo", "p.txt"])
def test_geometry_of_gengeo(read_text, name):
    packing = read_text(GEO, name)
    check(packing, [(1, 1.5, 2, 0.5), (3, 3.5, 4, 1)])
    assert packing["id"].tolist() == [0, 1] and packing["tag"].tolist() == [1, 7]
    assert packing.field_data["cell_origin"].tolist() == [-1, -2, -3]
    assert packing.field_data["cell_vectors"].tolist() == [[11, 0, 0], [0, 22, 0], [0, 0, 33]]
    assert packing.field_data["cell_periodic"].tolist() == [1, 0, 0]


# --- Medial axes ----------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["p.ma", "p.mat"])
def test_medial_mesh(read_text, name):
    text = "3 2 1\nv 0 0.5 0 1\nv 2 0 0 0.5 7\nv 0 2 0 0.25\ne 0 1\ne 0 2\nf 0 1 2\n"
    check(read_text(text, name), [(0, 0.5, 0, 1), (2, 0, 0, 0.5), (0, 2, 0, 0.25)])


def test_medial_mesh_without_letters(read_text):
    text = "2 1 0\n0 0.5 0 1\n2 0 0 0.5\n0 1\n"
    check(read_text(text, "p.ma"), [(0, 0.5, 0, 1), (2, 0, 0, 0.5)])
    assert read_text("1 0 0\n0 0 0 1\n", "p.ma").n_points == 1


# --- Kratos ---------------------------------------------------------------------------------------

MDPA = """Begin ModelPartData
//  VARIABLE_NAME value
End ModelPartData

Begin Properties 1
  Begin Table TIME VELOCITY
  1 2
  End Table
End Properties

Begin Nodes
  5   0.75   0.5   0.25
  8   1e1    0     0
  6   1.75   0.5   0.25 // a node
End Nodes
Begin Nodes
  5   0.75   0.5   0.25
End Nodes
Begin Elements SphericParticle3D// GUI group identifier: dem
  7  1  5
  9  1  6
End Elements
Begin NodalData RADIUS  // GUI group identifier: dem
  6 0 0.125
  5 0 0.5
End NodalData
Begin NodalData COHESIVE_GROUP
  5 0 1
End NodalData
Begin SubModelPart A
  Begin SubModelPart A
  End SubModelPart
  Begin SubModelPartNodes
  5
  End SubModelPartNodes
End SubModelPart
"""


@pytest.mark.parametrize("name", ["p.mdpa", "p.txt"])
def test_nodes_of_kratos_that_have_a_radius(read_text, name):
    packing = read_text(MDPA, name)
    check(packing, [(0.75, 0.5, 0.25, 0.5), (1.75, 0.5, 0.25, 0.125)])
    assert packing["id"].tolist() == [5, 6]


# --- PackLSD --------------------------------------------------------------------------------------

CELL = "1 0 0\n0 2 0\n0.5 0 3\nT T F\n"


def test_packing_of_packlsd_with_a_diameter_each(read_text):
    packing = read_text("3\n3 2\n2 1\n" + CELL + "0 0 0 0.5\n1 1 1 0.25\n2 2 2 1\n", "p.dat")
    check(packing, [(0, 0, 0, 0.25), (1, 1, 1, 0.125), (2, 2, 2, 0.5)])
    assert packing["species"].tolist() == [1, 1, 2]
    assert packing.field_data["cell_vectors"].tolist() == [[1, 0, 0], [0, 2, 0], [0.5, 0, 3]]
    assert packing.field_data["cell_periodic"].tolist() == [1, 1, 0]
    assert packing.field_data["cell_origin"].tolist() == [0, 0, 0]


def test_packing_of_packlsd_with_a_diameter_per_species(read_text):
    text = "3 ! dimension\n3 2\n2 1\n0.5 1.5\n1 0 0 0 2 0 0.5 0 3\nT T F\n0 0 0\n1 1 1\n2 2 2\n"
    check(read_text(text, "p"), [(0, 0, 0, 0.25), (1, 1, 1, 0.25), (2, 2, 2, 0.75)])


# --- Atoms without radii --------------------------------------------------------------------------

PDB = """HEADER    MADE UP
ATOM      1  N   ALA A   1      12.250   7.125  -5.375  1.00  9.50           N  
ATOM      2  CA  ALA A   1      13.500   7.625  -4.250  0.50 12.25           C  
END
"""  # noqa: W291


@pytest.mark.parametrize(
    ("name", "text", "found"),
    [
        ("p.pdb", PDB, "a PDB file, whose last numbers are occupancy and temperature factor"),
        ("p.ENT", PDB, "a PDB file"),
        ("p.txt", PDB, "a PDB file"),
        ("p", PDB.partition("\n")[2], "a PDB file"),
        ("p.cif", "data_1ABC\nloop_\n", "an mmCIF file"),
        ("p.txt", "# by hand\ndata_1ABC\nloop_\n", "an mmCIF file"),
        ("p.gro", "water\n1\n    1SOL OW    1   0.1   0.2   0.3\n1 1 1\n", "GROMACS"),
    ],
)
def test_atoms_without_radii_are_refused(read_error, tmp_path, name, text, found):
    path = tmp_path / name
    path.write_text(text)
    message, _ = read_error(path)
    assert message.startswith(f"{path}: found ") and found in message
    assert "expected a file with radii" in message
    assert ("spherepacking[formats]" in message) == ("GROMACS" not in found)


def test_charges_and_radii_in_the_columns_of_a_pdb_file(read_text, read_error, tmp_path):
    charged = PDB.replace("0.50 12.25", "-0.50 1.25").replace("  -0.50", " -0.50")
    assert read_text(charged, "p.txt")["charge"].tolist() == [1, -0.5]
    # The name says that it is one, but the numbers may not be.
    (tmp_path / "p.pqr").write_text(PDB)
    message, _ = read_error(tmp_path / "p.pqr")
    assert "p.pqr, line 2: found occupancy and temperature factor (B-factor) in" in message
    assert "expected charge and radius; rename the file to .pdb if it is one" in message


ION = "HETATM    1 NA    NA A   1       1.000   2.000   3.000  1.00  3.00\n"


def test_one_ion_of_which_nobody_knows_whether_it_has_a_radius(read_error, tmp_path):
    path = tmp_path / "p.pqr"
    path.write_text(ION)
    message, _ = read_error(path)
    assert 'rename the file to .pdb if it is one, or say radius="radius" (--radius' in message
    packing = spherepacking.read(path, radius="radius")
    check(packing, [(1, 2, 3, 3)])
    assert packing["charge"].tolist() == [1]
    check(spherepacking.read(path, radius=1.5), [(1, 2, 3, 1.5)])
    check(spherepacking.read(path, radius={"NA": 1.25}), [(1, 2, 3, 1.25)])
    other = tmp_path / "p.txt"
    other.write_text(ION)
    message, _ = read_error(other)
    assert message.endswith("; name the file .pqr if these numbers are charge and radius")


@pytest.mark.parametrize(
    "text",
    [
        re.sub(" +[NC]  $", "", PDB, flags=re.MULTILINE),  # old files have no elements
        re.sub(" {11}([NC])  $", r"      PRO1 \1", PDB, flags=re.MULTILINE),  # segments
        "REMARK   3   VDW PROBE RADII: 1.2\n" + PDB.replace("1.00 ", "0.25 "),
        "MODEL        1\n" + PDB.replace("END", "ENDMDL\nMODEL 2\nATOM 1 N A 1 1 2 3 -9 1"),
        PDB.replace("\n", "\r\n"),
    ],
)
def test_pdb_files_by_the_name_of_pqr(read_error, tmp_path, text):
    (tmp_path / "p.pqr").write_text(text)
    assert "found occupancy and temperature factor" in read_error(tmp_path / "p.pqr")[0]


@pytest.mark.parametrize(
    ("text", "charges"),
    [
        (PDB.replace(" 0.50", "-0.50"), [1, -0.5]),
        (PDB.replace(" 0.50", " 1.05"), [1, 1.05]),
        ("REMARK    The B-factors in this file hold atomic radii\n" + PDB, [1, 0.5]),
        # The columns of other programs: %8.4f %7.4f, %8.3f %8.3f, %8.2f %7.2f.
        (PDB.replace("  1.00  9.50", "  1.0000 9.5000").replace("  0.50", "  0.5000"), [1, 0.5]),
        (PDB.replace("  1.00  9.50", "   1.000   9.500"), [1, 0.5]),
        (PDB.replace("  1.00  9.50", "    1.00   9.50"), [1, 0.5]),
        # Two decimals, but neither an element nor an occupancy in full.
        (re.sub(" +[NC]  $", "", PDB.replace("1.00 ", "0.25 "), flags=re.MULTILINE), [0.25, 0.5]),
    ],
)
def test_charges_and_radii_that_look_like_those_of_a_pdb_file(read_text, text, charges):
    packing = read_text(text, "p.pqr")
    assert packing["charge"].tolist() == charges
    assert packing["radius"].tolist() == [9.5, 12.25]


@pytest.mark.parametrize(
    "first", ["Atom x y z r", "# remark\natom x y z r", "MODEL x y z r", "data_id x y z r"]
)
def test_names_of_columns_are_no_records(read_text, first):
    check(read_text(first + "\n1 2 3 4 5\n", "p.txt"), [(2, 3, 4, 5)])


@pytest.mark.parametrize("first", ["", "title\n", "Model 1\n", "CRYST1 1 1 1 90 90 90\n"])
def test_records_of_pqr_by_content(read_text, first):
    check(read_text(first + "Atom 1 N GLY A 1 1 2 3 0.1 1.5\n", "p.txt"), [(1, 2, 3, 1.5)])


# --- Bad files ------------------------------------------------------------------------------------

BAD = {
    "tree, few nodes": ("p.sph", TREE.rpartition("-0.75")[0], 1, "3 levels of 2", "as many"),
    "tree, many nodes": ("p.sph", TREE + "0 0 0 1 1\n", 1, "but 8 lines", "as many"),
    "tree, huge": ("p.sph", "900000 900000\n0 0 0 1 1\n", 1, "but 1 lines", "as many"),
    "tree, no degree": ("p.sph", "1 0\n0 0 0 1 1\n", 1, "'1 0'", "children a node"),
    "tree, columns": ("p.sph", "1 2\n0 0 0 1 1 1\n", 2, "'0 0 0 1 1 1'", "occupancy"),
    "tree, cut row": ("p.sph", TREE.replace(" 0.5\n", "\n"), 8, "'-0.75 0 0 0.125'", "occupancy"),
    "tree, longer row": ("p.sph", "2 1\n0 0 0 1\n0 0 0 1 1\n", 3, "'0 0 0 1 1'", "4 columns"),
    "tree, other text": ("p.sph", TREE + "More :\n", 9, "'More :'", "occupancy"),
    "tree, number": ("p.sph", "1 2\n0 0 x 1 1\n", 2, "'x' as z", "a number"),
    "tree, cut number": ("p.sph", "1 2\n0 0 1e 1 1\n", 2, "'1e' as z", "a number"),
    "tree, all absent": ("p.sph", "1 2\n0 0 0 -1 0\n", None, "no sphere", "not negative"),
    "dock, lies": ("p.sph", DOCK.replace("cluster     2\n    7", "cluster 9\n    7"), 3, "9", "as"),
    "dock, cut": ("p.sph", DOCK.partition("   11-")[0], 6, "but 0 lines", "as many"),
    "dock, word": ("p.sph", DOCK.replace("3.75000", "3.75o00"), 4, "3.75o00", "a number"),
    "dock, negative": ("p.sph", DOCK.replace("  1.400 ", " -1.400 "), 4, "'-1.400'", "not negati"),
    "dock, short": ("p.sph", DOCK.replace("   9  -1.00000", "   9"), 5, "'9   2", "x y z"),
    "dock, cut row": ("p.sph", DOCK.replace("15 1  0", ""), 5, "'9", "3 whole numbers after"),
    "hole, shifted": ("p.sph", HOLE.replace("S  -1 ", "S -1 "), 2, "'ATOM", "columns 23 to 26"),
    "hole, cut": ("p.sph", HOLE[:59], 1, "'ATOM", "in 31 to 54"),
    "hole, wide": ("p.sph", HOLE.replace("  1.50", "******"), 2, "'ATOM", "in 55 to 60"),
    "hole, negative": ("p.sph", HOLE.replace("  1.50", " -1.50"), 2, "'-1.50' as radius", "not"),
    "hole, damaged": (
        "p.sph",
        HOLE.replace("ATOM      1  QSS SPH S  -1", "XTOM      1  QSS SPH S  -1"),
        2,
        "'XTOM",
        "ATOM",
    ),
    "swc, negative": ("p.swc", SWC.replace("0.75 1", "-0.75 1"), 3, "'-0.75' as radius", "not"),
    "swc, cut": ("p.swc", SWC[:-7], 4, "within the row ' 5 3 2.5", "a line end after every row"),
    "swc, short": (
        "p.swc",
        SWC[:-7] + "\n",
        4,
        "columns '5 3 2.5",
        "7 columns: id type x y z radius",
    ),
    "swc, none": ("p.swc", "# nothing\n", None, "no sphere", "id type x y z radius parent"),
    "geo, no end": ("p.geo", GEO.partition("EndP")[0], 9, "the end of the file", "EndParticles"),
    "geo, cut header": ("p.geo", GEO[:40], 2, "'BoundingBox", "two corners"),
    "geo, count": ("p.geo", GEO.replace("\n2\n", "\n3\n"), 7, "3 as the number", "as many"),
    "geo, huge": ("p.geo", GEO.replace("\n2\n", "\n9999999999999\n"), 7, "99999", "as many"),
    "geo, no count": ("p.geo", GEO.replace("\n2\n", "\nx\n"), 7, "'x'", "number of particles"),
    "geo, kind": ("p.geo", GEO.replace("Simple", "Rough"), 6, "'Rough'", "Simple"),
    "geo, row": ("p.geo", GEO.replace("2 0.5 0 1", "2 -0.5 0 1"), 8, "'-0.5' as radius", "not"),
    "geo, other": ("p.geo", "Point(1) = {0, 0, 0, 1};\n", 1, "'Point(1)", "LSMGeometry"),
    "geo, empty": (
        "p.geo",
        GEO.replace("\n2\n", "\n0\n").replace("1 1.5 2 0.5 0 1\n3 3.5 4 1e0 1 7\n", ""),
        None,
        "no sphere",
        "particles",
    ),
    "ma, count": ("p.ma", "2 0 0\nv 0 0 0 1\n", 1, "2 as the number of vertices", "as many"),
    "ma, edges": ("p.ma", "1 2 0\nv 0 0 0 1\ne 0 0\n", 1, "2 as the number of edges", "as many"),
    "ma, maya": ("p.ma", "//Maya ASCII 2020 scene\n", 1, "'//Maya", "the numbers of vertices"),
    "ma, letter": ("p.ma", "1 0 0\nv 0 0 0 1\nx 1\n", 3, "'x 1'", "v, e or f"),
    "ma, short": ("p.ma", "1 0 0\nv 0 0 1\n", 2, "'v 0 0 1'", "v x y z radius"),
    "ma, negative": ("p.ma", "1 0 0\nv 0 0 0 -1\n", 2, "'-1' as radius", "not negative"),
    "mdpa, no radii": ("p.mdpa", MDPA.replace("RADIUS", "RADII"), None, "no sphere", "RADIUS"),
    "mdpa, cut": (
        "p.mdpa",
        MDPA.partition("End NodalData")[0],
        25,
        "the end of the file",
        "End No",
    ),
    "mdpa, node": ("p.mdpa", MDPA.replace("8   1e1 ", "8   1e400 "), 13, "1e400", "finite"),
    "mdpa, unknown node": (
        "p.mdpa",
        MDPA.replace("6 0 0.125", "4 0 0.125"),
        24,
        "'4 0 0.125'",
        "a node that",
    ),
    "mdpa, negative": (
        "p.mdpa",
        MDPA.replace("6 0 0.125", "6 0 -0.125"),
        24,
        "'-0.125' as radius",
        "not",
    ),
    "mdpa, outside": ("p.mdpa", "Nodes\n", 1, "'Nodes'", "Begin and the name of a block"),
    "lsd, two dimensions": ("p", "2\n1 1\n1\n1 0\n0 1\nT T\n0 0 1\n", 1, "'2'", "dimension, 3"),
    "lsd, few": ("p", "3\n2 1\n2\n" + CELL + "0 0 0 1\n", 8, "the end of the file after 1", "2 as"),
    "lsd, many": ("p", "3\n1 1\n1\n" + CELL + "0 0 0 1\n0 0 0 1\n", 9, "'0 0 0 1'", "the end"),
    "lsd, huge": ("p", "3\n999999999999 1\n999999999999\n" + CELL, 7, "after 0 spheres", "9999"),
    "lsd, cell": ("p", "3\n1 1\n1\n1 0 0\nT T T\n0 0 0 1\n", 5, "'T T T'", "9 numbers"),
    "lsd, no letters": (
        "p",
        "3\n1 1\n1\n1 0 0 0 1 0 0 0 1\n0 0 0 1\n2\n",
        5,
        "'0 0 0 1'",
        "T or F",
    ),
    "lsd, negative": ("p", "3\n1 1\n1\n" + CELL + "0 0 0 -1\n", 8, "'-1' as diameter", "not neg"),
}


@pytest.mark.parametrize("case", BAD)
def test_bad_files(read_error, tmp_path, case):
    name, text, line, found, expected = BAD[case]
    path = tmp_path / name
    path.write_text(text)
    message, _ = read_error(path)
    assert message.startswith(str(path) + (f", line {line}: " if line else ": "))
    before, _, after = message.partition(", expected ")
    assert found in before and expected in after


@pytest.mark.parametrize(
    "text", [TREE + "Options\n", DOCK, HOLE, SWC, GEO, MDPA], ids=lambda t: t[:9]
)
@pytest.mark.parametrize("end", ["\r\n", "\r"], ids=["crlf", "cr"])
def test_line_ends(read_text, text, end):
    name = "p.sph" if text.startswith(TREE) else "p.txt"
    packing = read_text(text, name)
    other = read_text("\ufeff" + text.replace("\n", end), name)
    assert other.points.tolist() == packing.points.tolist()
    assert other["radius"].tolist() == packing["radius"].tolist()
