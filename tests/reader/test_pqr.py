"""PQR files in the forms that programs write, against values written down by hand."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

# Lines of PDB2PQR, Open Babel, GROMACS, ProDy and fpocket, as far as their forms differ.
ALANINE = "ATOM      1  N   ALA A   1      -0.750  -1.125  -0.375  0.1414 1.8240\n"


def check(packing, spheres, charges):
    assert packing.points.tolist() == [list(sphere[:3]) for sphere in spheres]
    assert packing["radius"].tolist() == [sphere[3] for sphere in spheres]
    assert packing["charge"].tolist() == charges


def texts(packing, name):
    return [str(value) for value in packing[name]]


def test_columns_become_arrays(read_text):
    text = ALANINE + "HETATM    2  O   HOH   -12      1.500   2.500   3.250 -0.8340 0.0000\n"
    packing = read_text(text, "p.pqr")
    check(packing, [(-0.75, -1.125, -0.375, 1.824), (1.5, 2.5, 3.25, 0)], [0.1414, -0.834])
    assert texts(packing, "name") == ["N", "O"]
    assert texts(packing, "residue") == ["ALA", "HOH"]
    assert texts(packing, "chain") == ["A", ""]
    assert packing["residue_id"].tolist() == [1, -12]
    assert packing.active_scalars_name == "radius"
    # What no record has is no array.
    assert sorted(packing.array_names) == [
        *("chain", "charge", "name", "radius", "residue", "residue_id"),
    ]


def test_serial_numbers_touch_their_record(read_text):
    text = (
        "HETATM10000  O   HOH   901      41.500  32.250  27.125 -0.8340 1.6612\n"
        "HETATM10001  H1  HOH A1001      42.000  32.750  27.125  0.4170 1.0000\n"
        "HETATM10002 H2 HOH 7 42.0 33.0 27.0 0.4 1.2\n"
        "ATOM  100000  O   HOH  3331      41.500  32.250  27.125 -0.8340 1.6612\n"
        "ATOM100001  O   HOH  3332      41.500  32.250  27.125 -0.8340 1.6612\n"
    )
    packing = read_text(text, "p.pqr")
    assert packing["radius"].tolist() == [1.6612, 1, 1.2, 1.6612, 1.6612]
    assert packing.points[:3].tolist() == [[41.5, 32.25, 27.125], [42, 32.75, 27.125], [42, 33, 27]]
    assert texts(packing, "name") == ["O", "H1", "H2", "O", "O"]
    assert texts(packing, "chain") == ["", "A", "", "", ""]
    assert packing["residue_id"].tolist() == [901, 1001, 7, 3331, 3332]


def test_coordinates_and_names_touch(read_text):
    text = (
        "HETATM    1  O   HOH  1236    1234.5672200.5003103.250 -0.8340 1.6612\n"
        "HETATM    2  O   HOH  1237    -234.567-200.500-103.250-12.0000 1.5000\n"
        "ATOM      3 HG11AVAL B1238A      1.000   2.000   3.000  0.5000 1.0000\n"
    )
    packing = read_text(text, "p.pqr")
    spheres = [(1234.567, 2200.5, 3103.25, 1.6612), (-234.567, -200.5, -103.25, 1.5), (1, 2, 3, 1)]
    check(packing, spheres, [-0.834, -12, 0.5])
    assert texts(packing, "name") == ["O", "O", "HG11"]
    assert texts(packing, "residue") == ["HOH", "HOH", "AVAL"]
    assert texts(packing, "chain") == ["", "", "B"]
    assert packing["residue_id"].tolist() == [1236, 1237, 1238]
    assert texts(packing, "insertion_code") == ["", "", "A"]


def test_wide_coordinates_between_blanks_shift_the_columns(read_text):
    line = "ATOM      1  N   ALA A   1   -10750.125 -1.125  -0.375  0.1414 1.8240\n"
    check(read_text(line, "p.pqr"), [(-10750.125, -1.125, -0.375, 1.824)], [0.1414])


def test_an_element_after_the_radius(read_text):
    text = (
        "ATOM      1  N   ALA A  10      -0.750  -1.125  -0.375  0.00000000   1.550  N  \n"
        "HETATM    2 NA   NA  C   3       5.500   2.500   3.250  0.00000000   2.270 Na  \n"
        "ATOM 3 C GLY 1 1.0 2.0 3.0 -0.5 1.7 C\n"
        "ATOM      4  CA  GLY A   1       2.000   3.000   4.000 -0.10  1.70           N1+\n"
        "ATOM 5 C GLY 1 1.0 2.0 3.0 -0.5 1.7\n"
    )
    packing = read_text(text, "p.pqr")
    assert packing["radius"].tolist() == [1.55, 2.27, 1.7, 1.7, 1.7]
    assert packing["charge"].tolist() == [0, 0, -0.5, -0.1, -0.5]
    assert texts(packing, "element") == ["N", "Na", "C", "N1+", ""]


def test_insertion_codes(read_text):
    text = (
        "ATOM       1  N    ALA  A   10 A     -0.750   -1.125   -0.375  0.1000  1.5000\n"
        "ATOM 2 N ALA A 11B 1 2 3 0.1 1.5\n"
        "ATOM 3 N ALA 12 C 1 2 3 0.1 1.5\n"
        "ATOM 4 N ALA 13 1 2 3 0.1 1.5\n"
    )
    packing = read_text(text, "p.pqr")
    assert texts(packing, "insertion_code") == ["A", "B", "C", ""]
    assert packing["residue_id"].tolist() == [10, 11, 12, 13]
    assert texts(packing, "chain") == ["A", "A", "", ""]
    assert packing.points[0].tolist() == [-0.75, -1.125, -0.375]


def test_a_residue_without_a_number_is_nan(read_text):
    packing = read_text("ATOM 1 N ALA A B4XX 1 2 3 0.1 1.5\n" + ALANINE, "p.pqr")
    assert np.isnan(packing["residue_id"][0]) and packing["residue_id"][1] == 1


def test_records_in_any_case_and_after_blanks(read_text):
    text = "Atom 1 N GLY A 1 1 2 3 0.1 1.5\n  hetatm 2 C GLY A 1 4 5 6 0.2 1.7\nter\nend\n"
    check(read_text(text, "p.pqr"), [(1, 2, 3, 1.5), (4, 5, 6, 1.7)], [0.1, 0.2])


def test_records_without_atoms_and_prose_are_left_out(read_text):
    text = (
        "written on 2 May 1999 by version 3 of 4 programs\n"
        "# 1.0 2.0 3.0 4.0\n"
        "CRYST1   20.000   20.000   20.000  90.00  90.00  90.00 P 1           1\n"
        "SCALE1      0.050000  0.000000  0.000000        0.00000\n"
        "TITLE     1.5 2.5 3.5\n" + ALANINE + "ANISOU    1  N   ALA A   1     2 3 4 5 6 7\n"
        "CONECT10000 1.0 2.0 3.0\n"
        "\n"
    )
    assert read_text(text, "p.pqr").n_points == 1


def test_the_first_of_several_models(read_text):
    models = "".join(
        f"MODEL {i}\nATOM 1 N GLY 1 {i} 0 0 0.5 1\nATOM 2 N GLY 1 {i} 1 0 0.5 1\nENDMDL\n"
        for i in (1, 2, 3)
    )
    packing = read_text("REMARK\n" + models + "END\n", "p.pqr")
    assert packing.points.tolist() == [[1, 0, 0], [1, 1, 0]]
    assert packing.field_data["models"].tolist() == [3]
    one = read_text("MODEL 1\n" + ALANINE + "ENDMDL\nEND\n", "p.pqr")
    assert one.n_points == 1 and "models" not in one.field_data
    # Without ENDMDL, the next MODEL ends a model.
    assert read_text(models.replace("ENDMDL\n", ""), "p.pqr").n_points == 2


@pytest.mark.parametrize("swap", [True, False])
def test_remarks_that_say_where_the_radius_is(read_text, swap):
    radii, charges = ("55-62", "63-70") if swap else ("63-70", "55-62")
    text = (
        f"REMARK  atom radii in columns {radii}\nREMARK  Atom Charges in columns {charges}\n"
        "ATOM      1  N   MET     1      10.000  20.000  30.000  1.8240  0.1592\n"
    )
    values = (0.1592, 1.824) if swap else (1.824, 0.1592)
    check(read_text(text, "p.pqr"), [(10, 20, 30, values[1])], [values[0]])


def test_remarks_of_pdb2pqr_and_gromacs_change_nothing(read_text):
    text = (
        "REMARK   1 PQR file generated by PDB2PQR\n"
        "REMARK   6 Total charge on this biomolecule: -2.0000 e\n"
        "REMARK    The B-factors in this file hold atomic radii\n"
        "REMARK    The occupancy in this file hold atomic charges\n"
    )
    check(read_text(text + ALANINE, "p.pqr"), [(-0.75, -1.125, -0.375, 1.824)], [0.1414])


def test_single_precision_and_small_chunks(read_text):
    rows = [f"ATOM {i} N GLY A {i} 0.1 {i}.7 0 0.1 1.1\n" for i in range(500)]
    packing = read_text("".join(rows), "p.pqr", chunk=40)
    assert packing["residue_id"].tolist() == list(range(500))
    single = read_text("".join(rows), "p.pqr", single=True)
    assert single.points.dtype == np.float32
    assert (single.points == packing.points.astype(np.float32)).all()


def test_text_that_is_not_ascii_is_escaped(read_text):
    packing = read_text(b"ATOM 1 C\xe4 GLY A 1 1 2 3 0.1 1.5\n", "p.pqr")
    assert texts(packing, "name") == ["C\\xe4"]


BAD = {
    "misspelt": ("ATAM 2 C GLY A 1 2.0 2.0 3.0 0.16 1.7\n", 2, "'ATAM 2 C", "ATOM, HETATM"),
    "no name": ("2 C GLY A 1 2.0 2.0 3.0 0.16 1.7\n", 2, "'2 C GLY", "ATOM, HETATM"),
    "two names in one": ("ATOMS 2 C GLY A 1 2.0 2.0 3.0 0.16 1.7\n", 2, "'ATOMS 2", "ATOM"),
    "no radius, chain with a digit": (
        "ATOM      2  N   ALA 1  10      -0.750  -1.125  -0.375  0.1414\n",
        2,
        "whose blanks say other coordinates than columns 31 to 54",
        "x y z charge radius",
    ),
    "no radius behind an insertion code": (
        "ATOM 2 N ALA A 10 A -0.75 -1.125 -0.375 0.1414\n",
        2,
        "'A' as x",
        "a number",
    ),
    "cut after charge": (
        "ATOM      2  N   ALA A   1      -0.750  -1.125  -0.375  0.1414\n",
        2,
        "10 columns",
        "the last of them to be the number of the residue, x y z charge radius",
    ),
    "cut after z": (ALANINE[:54] + "\n", 2, "9 columns", "x y z charge radius"),
    "touching, not in columns": (
        "ATOM 2 O HOH 1236 1234.5672200.5003103.250 -0.8340 1.6612\n",
        2,
        "8 columns",
        "10 to 13",
    ),
    "a number too many": (
        "ATOM 2 N GLY 1 1.5 2.5 3.5 0.16 1.7 9\n",
        2,
        "11 columns",
        "the last of them to be the number of the residue, x y z charge radius",
    ),
    "numbers too many": ("ATOM 2 N GLY A 1 1 2 3 0.1 1.5 7 8 9\n", 2, "14 columns", "10 to 13"),
    "not finite": ("ATOM 2 N GLY A 1 1 2 inf 0.1 1.5\n", 2, "'inf' as z", "a finite number"),
    "stars": (
        "ATOM 2 N GLY A 1 1 2 3 0.1 ****\n",
        2,
        "'****' as radius in a record that ends with x y z charge radius and perhaps an element",
        "a number",
    ),
    "no charge": ("ATOM 2 N GLY A 1 1 2 3 none 1.5\n", 2, "'none' as charge", "a number"),
    "negative": ("ATOM 2 N GLY A 1 1 2 3 0.1 -1.5\n", 2, "'-1.5' as radius", "not negative"),
    "text at the end": ("ATOM 2 N GLY A 1 1 2 3 0.1 1.5 NX x\n", 2, "'NX' as radius", "a number"),
    "atoms in the second model alone": (
        "MODEL 1\nENDMDL\nMODEL 2\nATOM 1 N\n",
        5,
        "3 columns 'ATOM 1 N'",
        "10 to 13",
    ),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_records(read_error, tmp_path, name):
    text, line, found, expected = BAD[name]
    path = tmp_path / "p.pqr"
    path.write_text(ALANINE + text)
    if name.startswith("atoms in"):
        path.write_text("REMARK\n" + text)
    message, _ = read_error(path)
    assert message.startswith(f"{path}, line {line}: found ")
    before, _, after = message.partition(", expected ")
    assert found in before and expected in after


# --- Atoms in every form that programs write ------------------------------------------------------

NAMES = st.from_regex(r"[A-Z][A-Z0-9]{0,3}", fullmatch=True)
ATOMS = st.fixed_dictionaries(
    {
        "serial": st.integers(1, 99999),
        "record": st.sampled_from(["ATOM", "HETATM"]),
        "name": NAMES,
        "residue": st.from_regex(r"[A-Z0-9][A-Z0-9]{2}", fullmatch=True),
        "chain": st.sampled_from("AZa"),
        "number": st.integers(-999, 9999),
        "center": st.tuples(*[st.integers(-999_999, 9_999_999)] * 3),  # in thousandths
        "charge": st.integers(-99_999, 99_999),  # in ten thousandths
        "radius": st.integers(0, 99_999),
        "element": st.sampled_from(["N", "Fe"]),
    }
)


def columns_of(atom, *, element):
    """The record in the columns of a PDB file, as PDB2PQR and Open Babel write it."""
    numbers = "".join(f"{v / 1000:8.3f}" for v in atom["center"])
    tail = f" {atom['charge'] / 10000:8.4f} {atom['radius'] / 10000:7.4f}"
    return (
        f"{atom['record']:6}{atom['serial']:5} {atom['name']:4} {atom['residue']} {atom['chain']}"
        f"{atom['number']:4}    {numbers}{tail}" + f"          {atom['element']:>2}" * element
    )


def blanks_of(atom, *, element):
    """The record with a blank between any two fields."""
    numbers = [f"{v / 1000}" for v in atom["center"]]
    fields = [atom[key] for key in ("record", "serial", "name", "residue", "chain", "number")]
    fields += [*numbers, f"{atom['charge'] / 10000}", f"{atom['radius'] / 10000}"]
    return " ".join(map(str, fields)) + f" {atom['element']}" * element


@pytest.mark.parametrize("form", [columns_of, blanks_of])
@pytest.mark.parametrize("element", [True, False])
@settings(max_examples=40, deadline=None)
@given(atoms=st.lists(ATOMS, min_size=1, max_size=40))
def test_any_atom(read_text, form, element, atoms):
    text = "".join(form(atom, element=element) + "\n" for atom in atoms)
    packing = read_text(text, "p.pqr")
    # The quotients of integers are the numbers that the text holds, rounded to the nearest.
    spheres = [(*(v / 1000 for v in a["center"]), a["radius"] / 10000) for a in atoms]
    check(packing, spheres, [a["charge"] / 10000 for a in atoms])
    assert texts(packing, "name") == [a["name"] for a in atoms]
    assert texts(packing, "residue") == [a["residue"] for a in atoms]
    assert texts(packing, "chain") == [a["chain"] for a in atoms]
    assert packing["residue_id"].tolist() == [a["number"] for a in atoms]
    assert not element or texts(packing, "element") == [a["element"] for a in atoms]
