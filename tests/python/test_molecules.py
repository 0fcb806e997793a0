"""Atoms of PDB and mmCIF files, against values written down by hand or cut out of columns."""

import gzip
import sys

import numpy as np
import pytest
import pyvista as pv
import spherepacking
from spherepacking.files.errors import PackingFileError
from spherepacking.files.molecules import MoleculeFile

try:
    import gemmi
except ImportError:
    gemmi = None

needs_gemmi = pytest.mark.skipif(gemmi is None, reason="gemmi is not installed (extra 'formats')")

ATOM = (
    "{record:6}{serial:5d} {name:4}{altloc}{residue:>3} {chain}{number:4d}{code}   "
    "{x:8.3f}{y:8.3f}{z:8.3f}{occupancy:6.2f}{b:6.2f}          {element:>2}\n"
)


def atom(name, x, y, z, element, **more):
    defaults = {"record": "ATOM", "serial": 1, "altloc": " ", "residue": "ALA", "chain": "A"}
    defaults |= {"number": 1, "code": " ", "occupancy": 1, "b": 10}
    values = defaults | more
    return ATOM.format(name=name, x=x, y=y, z=z, element=element, **values)


PDB = (
    "HEADER    MADE UP\n"
    "CRYST1   10.000   20.000   30.000  90.00  90.00 120.00 P 1           1\n"
    + atom(" N  ", 12.25, 7.125, -5.375, "N", b=9.5)
    + atom(" CA ", 13.5, 7.625, -4.25, "C", occupancy=0.5, b=12.25)
    + atom("FE  ", -234.567, -200.5, -103.25, "FE", record="HETATM", residue="HEM", number=-7)
    + "END\n"
)
CIF = """data_1ABC
_cell.length_a 10
_cell.length_b 20
_cell.length_c 30
_cell.angle_alpha 90
_cell.angle_beta 90
_cell.angle_gamma 90
loop_
_atom_site.group_PDB
_atom_site.id
_atom_site.type_symbol
_atom_site.label_atom_id
_atom_site.label_alt_id
_atom_site.label_comp_id
_atom_site.label_asym_id
_atom_site.label_seq_id
_atom_site.Cartn_x
_atom_site.Cartn_y
_atom_site.Cartn_z
_atom_site.occupancy
_atom_site.B_iso_or_equiv
_atom_site.auth_seq_id
_atom_site.auth_asym_id
_atom_site.pdbx_PDB_model_num
ATOM 1 N N . ALA A 1 1.5 2.5 3.5 1.0 10 17 Q 1
HETATM 2 O O . HOH B 1 0.1 0.2 0.3 0.5 11 18 Q 1
"""


@pytest.fixture
def write(tmp_path):
    def write_file(text, name="p.pdb"):
        path = tmp_path / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    return write_file


@needs_gemmi
@pytest.mark.parametrize("name", ["p.pdb", "p.ENT", "p.pdb.gz"])
def test_atoms_of_a_pdb_file(write, name):
    path = write(gzip.compress(PDB.encode()) if name.endswith("gz") else PDB, name)
    file = MoleculeFile(path)
    assert file.times == [1]
    packing = file.read()
    assert packing.points.dtype == np.float64
    assert packing.points.tolist() == [
        *([12.25, 7.125, -5.375], [13.5, 7.625, -4.25], [-234.567, -200.5, -103.25]),
    ]
    assert packing["radius"].tolist()[:2] == [1.55, 1.7]  # Bondi's
    assert packing.active_scalars_name == "radius"
    assert packing.n_cells == packing.n_verts == 3
    assert packing["name"].tolist() == ["N", "CA", "FE"]
    assert packing["element"].tolist() == ["N", "C", "Fe"]
    assert packing["atomic_number"].tolist() == [7, 6, 26]
    assert packing["residue"].tolist() == ["ALA", "ALA", "HEM"]
    assert packing["chain"].tolist() == ["A"] * 3
    assert packing["residue_id"].tolist() == [1, 1, -7]
    assert packing["occupancy"].tolist() == [1, 0.5, 1]
    assert packing["b_factor"].tolist() == [9.5, 12.25, 10]
    assert "insertion_code" not in packing.point_data
    assert packing["rgb"].dtype == np.uint8
    assert packing["rgb"].tolist()[:2] == [[13, 13, 255], [128, 128, 128]]


@needs_gemmi
def test_unit_cell(write):
    data = MoleculeFile(write(PDB)).read().field_data
    # b makes an angle of 120 degrees with a, in the plane of x and y.
    expected = [[10, 0, 0], [-10, 20 * np.sqrt(0.75), 0], [0, 0, 30]]
    np.testing.assert_allclose(data["cell_vectors"], expected, atol=1e-12)
    assert data["cell_origin"].tolist() == [0, 0, 0]
    assert data["cell_periodic"].tolist() == [1, 1, 1]
    without = PDB.replace("CRYST1", "REMARK")
    assert "cell_vectors" not in MoleculeFile(write(without)).read().field_data


@needs_gemmi
def test_models_are_steps(write):
    models = "".join(
        f"MODEL     {i:4d}\n" + atom(" N  ", i, 0, 0, "N") * (i - 3) + "ENDMDL\n" for i in (4, 5, 7)
    )
    file = MoleculeFile(write(models))
    assert file.times == [4, 5, 7]
    assert [file.read(i).n_points for i in range(3)] == [1, 2, 4]
    assert file.read(2).points[0].tolist() == [7, 0, 0]
    for index in (3, -1):
        with pytest.raises(IndexError, match=f"index: found {index}, expected 0 to 2"):
            file.read(index)


@needs_gemmi
def test_alternative_locations(write):
    text = (
        atom(" N  ", 1, 0, 0, "N")
        + atom(" CA ", 2, 0, 0, "C", altloc="A", occupancy=0.4)
        + atom(" CA ", 3, 0, 0, "C", altloc="B", occupancy=0.6)
        + atom(" CB ", 4, 0, 0, "C", altloc="A", occupancy=0.4)
        + atom(" CB ", 5, 0, 0, "C", altloc="B", occupancy=0.6)
        + atom(" OG ", 6, 0, 0, "O", altloc="C", occupancy=0.5)  # by itself
        + atom(" N  ", 7, 0, 0, "N", altloc="A", occupancy=0.5, number=2)  # equal: the first
        + atom(" N  ", 8, 0, 0, "N", altloc="B", occupancy=0.5, number=2)
        + atom(" N  ", 9, 0, 0, "N", altloc="A", occupancy=0.3, number=3, residue="SER")
        + atom(" OG ", 10, 0, 0, "O", altloc="A", occupancy=0.3, number=3, residue="SER")
        + atom(" N  ", 11, 0, 0, "N", altloc="B", occupancy=0.7, number=3, residue="ALA")
    )
    packing = MoleculeFile(write(text)).read()
    assert packing.points[:, 0].tolist() == [1, 3, 5, 6, 7, 11]


@needs_gemmi
def test_insertion_codes(write):
    text = atom(" N  ", 1, 0, 0, "N", number=52) + atom(" N  ", 2, 0, 0, "N", number=52, code="A")
    packing = MoleculeFile(write(text)).read()
    assert packing["insertion_code"].tolist() == ["", "A"]
    assert packing["residue_id"].tolist() == [52, 52]


@needs_gemmi
def test_the_order_of_the_file_is_kept(write):
    text = "".join(
        atom(" N  ", i, 0, 0, "N", chain=chain, number=i) for i, chain in enumerate("ABAB")
    )
    packing = MoleculeFile(write(text)).read()
    assert packing.points[:, 0].tolist() == [0, 1, 2, 3]
    assert packing["chain"].tolist() == ["A", "B", "A", "B"]


@needs_gemmi
@pytest.mark.parametrize("name", ["p.cif", "p.mmCIF", "p.cif.gz"])
def test_atoms_of_an_mmcif_file(write, name):
    path = write(gzip.compress(CIF.encode()) if name.endswith("gz") else CIF, name)
    packing = MoleculeFile(path).read()
    assert packing.points.tolist() == [[1.5, 2.5, 3.5], [0.1, 0.2, 0.3]]
    assert packing["radius"].tolist() == [1.55, 1.52]
    assert packing["chain"].tolist() == ["Q", "Q"]
    assert packing["residue_id"].tolist() == [17, 18]
    assert packing.field_data["cell_vectors"].tolist() == [[10, 0, 0], [0, 20, 0], [0, 0, 30]]


@needs_gemmi
def test_a_small_molecule(write):
    text = (
        "data_salt\n_cell_length_a 10\n_cell_length_b 20\n_cell_length_c 40\n"
        "_cell_angle_alpha 90\n_cell_angle_beta 90\n_cell_angle_gamma 90\n"
        "loop_\n_atom_site_label\n_atom_site_type_symbol\n"
        "_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n"
        "Na1 Na 0.25 0.5 0.125(3)\nCl1 Cl 0 0 0\n"
    )
    packing = MoleculeFile(write(text, "p.cif")).read()
    assert packing.points.tolist() == [[2.5, 10, 5], [0, 0, 0]]
    assert packing["element"].tolist() == ["Na", "Cl"]
    assert packing["name"].tolist() == ["Na1", "Cl1"]
    assert packing.field_data["cell_vectors"].tolist() == [[10, 0, 0], [0, 20, 0], [0, 0, 40]]


@needs_gemmi
def test_content_that_is_at_hand(tmp_path):
    file = MoleculeFile(tmp_path / "absent.pdb.xz", data=PDB.encode())
    assert file.read().n_points == 3


@needs_gemmi
def test_a_real_file(data_file):
    path = data_file("protein.pdb")
    lines = [line for line in path.read_text().splitlines() if line[:6] in ("ATOM  ", "HETATM")]
    assert len({line[16] for line in lines}) == 1
    packing = MoleculeFile(path).read()
    columns = [[float(line[i : i + 8]) for i in (30, 38, 46)] for line in lines]
    assert packing.points.tolist() == columns
    assert packing["name"].tolist() == [line[12:16].strip() for line in lines]
    assert packing["chain"].tolist() == [line[21].strip() for line in lines]
    assert packing["residue_id"].tolist() == [int(line[22:26]) for line in lines]
    radii = {"H": 1.2, "C": 1.7, "N": 1.55, "O": 1.52, "S": 1.8, "P": 1.8}
    assert packing["radius"].tolist() == [radii[line[76:78].strip()] for line in lines]


# --- elements -------------------------------------------------------------------------------------


@needs_gemmi
@pytest.mark.parametrize("name", ["D", "DEUTERIUM1"])
def test_deuterium_is_hydrogen(write, name):
    path = write(CIF.replace("1 N N .", f"1 D {name} ."), "p.cif")
    packing = spherepacking.read(path)
    assert packing["radius"].tolist() == [1.2, 1.52]  # Bondi's
    assert packing["element"].tolist() == ["D", "O"]
    assert packing["atomic_number"].tolist() == [1, 8]
    hydrogen = spherepacking.read(write(CIF.replace("1 N N .", "1 H H ."), "h.cif"))
    assert packing["rgb"].tolist() == hydrogen["rgb"].tolist()


@needs_gemmi
@pytest.mark.parametrize(("element", "called"), [("X", "X"), ("Q", "X"), ("Lv", "Lv")])
def test_elements_without_radius(write, element, called):
    path = write(CIF.replace("1 N N .", f"1 {element} N ."), "p.cif")
    with pytest.raises(PackingFileError, match=f"atoms of {called}, .* radius={{'{called}': 1.5}}"):
        spherepacking.read(path)
    assert spherepacking.read(path, radius=0.5)["radius"].tolist() == [0.5, 0.5]
    assert spherepacking.read(path, radius={called: 0.75})["radius"].tolist() == [0.75, 1.52]
    both = {called: 0.75, "O": 2.0}
    assert spherepacking.read(path, radius=both)["radius"].tolist() == [0.75, 2.0]
    with pytest.raises(PackingFileError, match="no radius for"):
        spherepacking.read(path, radius={"O": 2.0})


@needs_gemmi
def test_an_unknown_element_is_told_by_its_atom(write):
    line = "ATOM      1  QX  ALA A   7      12.250   7.125  -5.375  1.00  9.50           Q\n"
    path = write(line.replace(" Q\n", " N\n").replace("QX", "N ") + line, "p.pdb")
    with pytest.raises(PackingFileError) as caught:
        spherepacking.read(path)
    assert str(caught.value) == (
        f"{path}: found atoms of X, which has no van der Waals radius (X stands for elements that "
        "are not known, as of the atom QX of residue ALA 7), expected one, such as "
        "radius={'X': 1.5}"
    )


@needs_gemmi
def test_all_elements_without_radius_are_named(write):
    path = write(CIF.replace("1 N N .", "1 X N .").replace("2 O O", "2 Og O"), "p.cif")
    with pytest.raises(PackingFileError, match="atoms of Og, X, which"):
        spherepacking.read(path)
    with pytest.raises(PackingFileError, match=r"of Og, which has no .* radius, expected"):
        spherepacking.read(path, radius={"X": 1.0})
    with pytest.raises(PackingFileError, match=r"atoms of X, .* radius=\{'X': 1.5\}"):
        spherepacking.read(path, radius={"Og": 1.0})


@needs_gemmi
@pytest.mark.parametrize(
    ("old", "new"),
    [(" N .", " ABCDEFGHIJK ."), (" ALA A", " ALANINEXYZ A"), (" 17 Q ", " 17 QRSTUVWXYZ ")],
)
def test_long_names(write, old, new):
    """The format mmCIF sets no limit to the length of names."""
    packing = spherepacking.read(write(CIF.replace(old, new), "p.cif"))
    assert packing.points.tolist() == [[1.5, 2.5, 3.5], [0.1, 0.2, 0.3]]
    assert packing["radius"].tolist() == [1.55, 1.52]
    assert packing["element"].tolist() == ["N", "O"]
    assert packing["name"].tolist() == ["ABCDEFGHIJK" if old == " N ." else "N", "O"]
    assert packing["residue"].tolist() == ["ALANINEXYZ" if "ALA" in old else "ALA", "HOH"]
    assert packing["chain"].tolist() == ["QRSTUVWXYZ" if "Q" in old else "Q", "Q"]
    assert packing["residue_id"].tolist() == [17, 18]
    assert packing["occupancy"].tolist() == [1, 0.5]
    assert packing["b_factor"].tolist() == [10, 11]


SMALL = """data_x
_cell_length_a 10
_cell_length_b 20.0(1)
_cell_length_c 30
_cell_angle_alpha 90
_cell_angle_beta 90
_cell_angle_gamma 90
loop_
_atom_site_label
_atom_site_type_symbol
_atom_site_fract_x
_atom_site_fract_y
_atom_site_fract_z
C1 C 0.5 0.25 0.1
"""


@needs_gemmi
@pytest.mark.parametrize("name", ["length_a", "length_b", "angle_gamma"])
def test_fractions_need_their_cell(write, name):
    assert spherepacking.read(write(SMALL, "p.cif")).points.tolist() == [[5, 5, 3]]
    for gone in (f"_cell_{name}_gone", f"_cell_{name} ? _x"):
        path = write(SMALL.replace(f"_cell_{name}", gone), "q.cif")
        with pytest.raises(PackingFileError, match=f"_cell_{name}, expected the whole cell"):
            spherepacking.read(path)


BAD = {
    "coordinate": (PDB.replace(" 7.125", " 7.x25"), 3, "7.x25", "columns 31 to 54"),
    "nan": (PDB.replace(" 7.125", "   nan"), 3, "nan", "columns 31 to 54"),
    "blank": (PDB.replace(" 7.625", "      "), 4, "CA", "columns 31 to 54"),
    "short": (PDB[: PDB.index("  7.625") + 4] + "\n", 4, "CA", "columns 31 to 54"),
    "cut": (PDB[: PDB.index(" 12.25")], 3, "the end of the file within", "add one if the file is"),
    "misspelt": (PDB.replace("HETATM", "HETAMT"), 5, "HETAMT", "ATOM, HETATM"),
    "hole": (
        "ATOM      1  QSS SPH S   0       1.250  -2.500   3.750  1.40  1.40\n",
        *(1, "QSS SPH", "the name .sph"),
    ),
    "no atoms": ("HEADER\nEND\n", None, "no atoms", "ATOM or HETATM"),
}
BAD_CIF = {
    "cif, empty": ("", None, "no atoms", "_atom_site"),
    "cif, prose": ("hello\n", 1, "no text of that format", "an mmCIF file"),
    "cif, cut": (CIF[:-3], CIF.count("\n"), "the end of the file within", "a line end after every"),
    "cif, short": (CIF[:-3] + "\n", None, "no text of that format", "an mmCIF file"),
    "cif, no atoms": ("data_x\n_cell.length_a 10\n", None, "no atoms", "_atom_site"),
    "cif, coordinate": (CIF.replace(" 2.5 ", " x "), None, "nan", "finite numbers"),
    "cif, unknown": (CIF.replace(" 2.5 ", " ? "), None, "nan", "finite numbers"),
}


@needs_gemmi
@pytest.mark.parametrize("case", [*BAD, *BAD_CIF])
def test_bad_files(write, case):
    text, line, found, expected = (BAD | BAD_CIF)[case]
    path = write(text, "p.cif" if case in BAD_CIF else "p.pdb")
    with pytest.raises(PackingFileError) as error:
        MoleculeFile(path).read()
    message = str(error.value)
    assert message.startswith(str(path) + (f", line {line}: " if line else ""))
    before, _, after = message.partition(", expected ")
    assert found in before and expected in after


@needs_gemmi
@pytest.mark.parametrize(("name", "text"), [("p.pdb", PDB), ("p.cif", CIF)])
def test_a_file_cut_at_every_byte(write, name, text):
    """Nothing tells that whole lines are missing; of END and TER the line need not end."""
    whole = MoleculeFile(write(text, name)).read().points.tolist()
    for length in range(1, len(text)):
        path = write(text[:length], name)
        try:
            points = MoleculeFile(path).read().points.tolist()
        except PackingFileError:
            continue
        last = text[:length].rpartition("\n")[2]
        assert points == whole[: len(points)] and last in ("", "E", "EN", "END"), last


@needs_gemmi
def test_a_damaged_gzip_file(write):
    path = write(gzip.compress(PDB.encode())[:-9], "p.pdb.gz")
    with pytest.raises(PackingFileError, match="no whole gzip file"):
        MoleculeFile(path)


def test_without_gemmi(write, monkeypatch):
    monkeypatch.setitem(sys.modules, "gemmi", None)
    with pytest.raises(ImportError, match=r"pip install 'spherepacking\[formats\]'"):
        MoleculeFile(write(PDB))


@pytest.mark.parametrize("name", ["p.swc", "p.geo", "p.ma", "p.mdpa"])
def test_pyvista_reads_other_files_by_extension(write, name):
    texts = {
        "p.swc": "1 1 0 0 0 1 -1\n",
        "p.geo": "LSMGeometry 1.2\nBeginParticles\nSimple\n1\n0 0 0 1 0 0\nEndParticles\n",
        "p.ma": "1 0 0\nv 0 0 0 1\n",
        "p.mdpa": "Begin Nodes\n1 0 0 0\nEnd Nodes\nBegin NodalData RADIUS\n1 0 1\nEnd NodalData\n",
    }
    path = write(texts[name], name)
    for packing in (pv.read(path), spherepacking.read(path)):
        assert packing.n_points == 1 and packing["radius"].tolist() == [1]


ROWS = """data_x
loop_
_atom_site.{}
{}
"""
COLUMNS = {
    "id": ("1", "2"),
    "type_symbol": ("C", "N"),
    "label_atom_id": ("CA", "N"),
    "label_alt_id": (".", "."),
    "label_comp_id": ("ALA", "GLY"),
    "label_asym_id": ("A", "B"),
    "Cartn_x": ("1.5", "4"),
    "Cartn_y": ("2", "5"),
    "Cartn_z": ("3", "6"),
}


def atoms_of(path, *absent):
    columns = {name: values for name, values in COLUMNS.items() if name not in absent}
    rows = "\n".join(" ".join(row) for row in zip(*columns.values(), strict=True))
    path.write_text(ROWS.format("\n_atom_site.".join(columns), rows))
    return spherepacking.read(path)


@needs_gemmi
@pytest.mark.parametrize(
    "absent",
    [
        (),
        ("id",),
        ("label_alt_id",),
        ("label_asym_id",),
        ("label_atom_id", "label_comp_id"),
        ("id", "label_alt_id", "label_asym_id", "label_atom_id", "label_comp_id"),
    ],
)
def test_columns_that_mmcif_may_leave_out(tmp_path, absent):
    packing = atoms_of(tmp_path / "a.cif", *absent)
    assert packing.points.tolist() == [[1.5, 2, 3], [4, 5, 6]]
    assert packing["element"].tolist() == ["C", "N"]
    if "label_asym_id" not in absent:
        assert packing["chain"].tolist() == ["A", "B"]


@needs_gemmi
def test_atoms_of_no_element(tmp_path):
    with pytest.raises(
        spherepacking.PackingFileError, match=r"a\.cif: found no _atom_site\.type_s"
    ):
        atoms_of(tmp_path / "a.cif", "type_symbol")


@needs_gemmi
def test_an_incomplete_cell_is_one_sentence(tmp_path):
    path = tmp_path / "a.cif"
    path.write_text(
        "data_x\n_cell_length_a 10\nloop_\n_atom_site_label\n_atom_site_fract_x\n"
        "_atom_site_fract_y\n_atom_site_fract_z\nC1 0.1 0.2 0.3\n"
    )
    with pytest.raises(spherepacking.PackingFileError) as caught:
        spherepacking.read(path)
    assert str(caught.value) == (
        f"{path}: found no _cell_length_b, expected the whole cell that the coordinates are "
        "fractions of"
    )
