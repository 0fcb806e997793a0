"""LAMMPS data files: styles of atoms, boxes, velocities, sections of no interest, bad ones."""

import pytest

FORMAT = 20005
HEADER = "made up\n\n2 atoms\n1 atom types\n\n0 2 xlo xhi\n-1 3 ylo yhi\n0 2 zlo zhi\n\n"
SPHERES = "1 1 0.5 2500 1 0.5 0.25\n2 1 0.25 2500 1.5 1.5 0.75\n"
VELOCITIES = "\nVelocities\n\n2 1 2 3 4 5 6\n1 7 8 9 10 11 12\n"


def data(rows=SPHERES, style="# sphere", rest="", header=HEADER):
    return f"{header}Atoms {style}\n\n{rows}{rest}"


@pytest.mark.parametrize("name", ["p.data", "data.granular", "p.lmp", "p.txt", "p.LAMMPS", "data"])
@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"], ids=["lf", "crlf", "cr"])
def test_spheres(read_text, name, end):
    packing = read_text(data().replace("\n", end), name)
    assert packing.points.tolist() == [[1, 0.5, 0.25], [1.5, 1.5, 0.75]]
    assert packing["radius"].tolist() == [0.25, 0.125]
    assert packing.point_data.keys() == ["radius", "id", "type", "density"]
    assert packing["density"].tolist() == [2500, 2500]
    assert packing.field_data["cell_vectors"].tolist() == [[2, 0, 0], [0, 4, 0], [0, 0, 2]]
    assert packing.field_data["cell_origin"].tolist() == [0, -1, 0]
    assert packing.field_data["cell_periodic"].tolist() == [1, 1, 1]


@pytest.mark.parametrize(
    ("style", "row"),
    [
        ("granular", "1 2 0.5 2500 1 2 3"),
        ("sphere/kk", "1 2 0.5 2500 1 2 3"),
        ("bpm/sphere", "1 7 2 0.5 2500 1 2 3"),
        ("hybrid sphere charge", "1 2 1 2 3 0.5 2500 -0.1"),
        ("hybrid charge sphere", "1 2 1 2 3 -0.1 0.5 2500"),
        ("hybrid dipole full sphere", "1 2 1 2 3 -0.1 4 5 6 7 0.5 2500"),
    ],
)
@pytest.mark.parametrize("images", ["", " 0 -1 2", " 0 -1 2 # a remark"])
def test_styles(read_text, style, row, images):
    header = HEADER.replace("2 atoms", "1 atoms")
    packing = read_text(data(row + images + "\n", f"# {style}", header=header), "p.data")
    assert packing.points.tolist() == [[1, 2, 3]]
    assert packing["radius"].tolist() == [0.25]
    assert [packing[name][0] for name in ("id", "type", "density")] == [1, 2, 2500]
    if images:
        assert [packing[name][0] for name in ("ix", "iy", "iz")] == [0, -1, 2]
    if "charge" in style or "full" in style:
        assert packing["q"].tolist() == [-0.1]
    if "full" in style or "bpm" in style:
        assert packing["molecule"].tolist() == [7]


def test_type_labels(read_text):
    labels = "\nAtom Type Labels\n\n1 sand\n\n"
    text = data("1 sand 0.5 1 1 2 3\n2 sand 0.5 1 4 5 6\n", header=HEADER + labels)
    assert read_text(text, "p.data")["type"].tolist() == ["sand", "sand"]


def test_a_tilted_box(read_text):
    header = HEADER.replace("0 2 zlo zhi", "0 2 zlo zhi\n0.5 -0.25 0.75 xy xz yz")
    vectors = read_text(data(header=header), "p.data").field_data["cell_vectors"]
    assert vectors.tolist() == [[2, 0, 0], [0.5, 4, 0], [-0.25, 0.75, 2]]


def test_a_general_box(read_text):
    header = (
        "# made up\n\n2 atoms # all\n\n1 2 3 avec\n-1 1 0 bvec\n0 1 4 cvec\n10 20 30 abc origin\n\n"
    )
    field = read_text(data(header=header), "p.data").field_data
    assert field["cell_vectors"].tolist() == [[1, 2, 3], [-1, 1, 0], [0, 1, 4]]
    assert field["cell_origin"].tolist() == [10, 20, 30]


def test_sections_of_no_interest(read_text):
    before = "Masses\n\n1 5.0\n\nPair Coeffs # gran/hooke\n\n1 2 3\n\nPairIJ Coeffs\n\n1 1 2\n\n"
    after = "\nBonds\n\n1 1 1 2\n\nBodies\n\n1 1 3\n2\n1.0 2.0 3.0\n"
    packing = read_text(data(rest=after, header=HEADER + before), "p.data")
    assert packing["radius"].tolist() == [0.25, 0.125]


@pytest.mark.parametrize("first", [False, True])
def test_velocities_by_id(read_text, first):
    # LAMMPS wants them after the atoms; nothing depends on it here.
    text = data(header=HEADER + VELOCITIES + "\n") if first else data(rest=VELOCITIES)
    packing = read_text(text, "p.data")
    assert packing["velocity"].tolist() == [[7, 8, 9], [1, 2, 3]]
    assert packing["angular_velocity"].tolist() == [[10, 11, 12], [4, 5, 6]]


def test_velocities_of_atoms_in_any_order(read_text, rng):
    ids = rng.permutation(500) + 7
    others = rng.permutation(ids)
    rows = "".join(f"{i} 1 0.5 1 1 2 3\n" for i in ids)
    velocities = "\nVelocities\n\n" + "".join(f"{i} {i} {2 * i} 0.5\n" for i in others)
    header = HEADER.replace("2 atoms", "500 atoms")
    packing = read_text(data(rows, rest=velocities, header=header), "p.data")
    assert packing["id"].tolist() == ids.tolist()
    assert packing["vx"].tolist() == ids.tolist()
    assert packing["vy"].tolist() == (2 * ids).tolist()


@pytest.mark.parametrize(
    "text",
    [
        data(style="", rest=VELOCITIES),
        data(style="# mine", rest=VELOCITIES),
        data(style="", header=HEADER.replace("made up", "LAMMPS data file, version LIGGGHTS 3.8")),
    ],
)
def test_without_a_style_if_it_can_be_no_other(read_text, text):
    assert read_text(text, "p.data")["radius"].tolist() == [0.25, 0.125]


def test_names_given(read_text):
    packing = read_text(data(style=""), "p.data", columns="id type d density x y z")
    assert packing["radius"].tolist() == [0.25, 0.125]


def test_without_radii(read_text):
    rows = "1 1 1 0.5 0.25\n2 1 1.5 1.5 0.75\n"
    packing = read_text(data(rows, "# atomic"), "p.data", optional=True)
    assert packing.points.tolist() == [[1, 0.5, 0.25], [1.5, 1.5, 0.75]]
    assert packing.point_data.keys() == ["id", "type"]


def test_no_line_end_after_the_last_row(read_text, read_error, tmp_path):
    assert read_text(data()[:-1], "p.data")["radius"].tolist() == [0.25, 0.125]
    header = HEADER.replace("made up", "LAMMPS data file via write_data, version 1")
    (tmp_path / "p.data").write_text(data(header=header)[:-1])
    message, _ = read_error(tmp_path / "p.data")
    assert "line 13: found the end of the file within the row '2 1 0.25" in message


MORE = HEADER.replace("2 atoms", "3 atoms")
BAD = {
    "no diameter": (data("1 1 1 2 3\n" * 2, "# atomic"), 10, "atom_style atomic, which", "sphere"),
    "no style": (data(style=""), 10, "rows of 7 columns and no atom_style", "Atoms # sphere"),
    "full": (data("1 1 1 0.5 1 2 3\n" * 2, ""), 10, "no atom_style", "Atoms # sphere"),
    "peri": (data(style="", rest=VELOCITIES.replace(" 4 5 6", "")), 10, "no atom_st", "# sphere"),
    "count too large": (data(header=MORE), 3, "3 as the number of atoms, but 2 lines", "as many"),
    "count too small": (
        data(header=HEADER.replace("2 atoms", "1 atoms")),
        3,
        "1 as the number of atoms, but 2",
        "as many",
    ),
    "bad count": (data(header=HEADER.replace("2 atoms", "-2 atoms")), 3, "'-2 atoms'", "number of"),
    "no atoms": (HEADER + "Masses\n\n1 5\n", 3, "2 atoms and no section Atoms", "one"),
    "atoms twice": (data(rest="\nAtoms\n\n1 2\n"), 15, "a second section Atoms", "as in line 10"),
    "bad box": (data(header=HEADER.replace("0 2 xlo", "0 x xlo")), 6, "'0 x xlo xhi'", "2 numbers"),
    "other columns": (data("1 1 1 2 3\n" * 2), 12, "5 columns", "7 columns: id type diameter"),
    "bad row": (data("1 1 0.5 1 1 y 2\n2 1 1 1 1 1 1\n"), 12, "'y' as y in column 6", "a number"),
    "negative": (data(SPHERES.replace("0.25 2500", "-1 2500")), 13, "'-1' as diam", "not negative"),
    "velocities": (data(rest="\nVelocities\n\n1 2 3 4\n"), 15, "2 as the number of", "as many"),
    "velocity of none": (
        data(rest=VELOCITIES.replace("\n2 1", "\n3 1")),
        15,
        "velocities of an atom 3 that is not there",
        "each atom",
    ),
    "velocity twice": (
        data(rest=VELOCITIES.replace("\n2 1", "\n1 1")),
        15,
        "velocities of an atom 1 that is not there or there twice",
        "each atom",
    ),
    "bad velocity": (data(rest=VELOCITIES.replace("8", "v")), 18, "'v' as vy", "a number"),
}


@pytest.mark.parametrize("case", BAD, ids=[case.replace(" ", "-") for case in BAD])
def test_bad_lammps_data(read_error, tmp_path, case):
    text, line, found, expected = BAD[case]
    path = tmp_path / "p.data"
    path.write_text(text)
    message, code = read_error(path)
    assert message.startswith(f"{path}, line {line}: found ")
    assert found in message
    assert expected in message[message.index("expected") :]
    assert code == FORMAT


def test_a_file_cut_anywhere(tmp_path, reader_for):
    """Never other spheres: the whole is read, or there is an error."""
    header = HEADER.replace("made up", "LAMMPS data file via write_data, version 1")
    whole = data(header=header, rest=VELOCITIES)
    for length in range(len(whole)):
        path = tmp_path / "p.data"
        path.write_text(whole[:length] or "x")
        reader = reader_for(path, fmt="LAMMPS_DATA")
        reader.AddObserver("ErrorEvent", lambda *_: None)
        reader.Update()
        if not reader.GetErrorMessage():  # cut where the velocities would begin
            assert whole[:length].endswith("0.75\n") or "Velocities" not in whole[:length]
            assert reader.GetOutput().GetPointData().GetArray("radius").GetTuple1(1) == 0.125


def test_a_line_that_ends_with_a_comma(read_error, tmp_path):
    """Of which the last field is empty, while it is looked for what the file may be."""
    path = tmp_path / "p.dat"
    path.write_text("1.5 2 3 4\n5 ,\n")
    message, _ = read_error(path)
    assert message.startswith(f"{path}, line 2: found ")
