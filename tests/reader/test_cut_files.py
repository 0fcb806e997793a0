"""Files cut anywhere, of programs that end every line and of people who do not."""

import pytest
from whole_files import ATOM, WHOLE

# The name, and a text whose last two characters are a digit and a line end.
BY_PROGRAMS = {
    "extended XYZ": (
        "p.xyz",
        "2\nProperties=species:S:1:pos:R:3:radius:R:1\nA 1 2 3 0.5\nN 4 5 6 0.25\n",
    ),
    "PQR": ("p.pqr", ATOM + ATOM.replace("  1  N", "  2  C")),
    "PQR, HETATM": ("p.pqr", "HETATM 1 O HOH 7 1 2 3 -0.8 1.66\n"),
    "IMD": ("p.imd", "#F A 1 0 0 3 0 1\n#C number x y z Radius\n#E\n1 1 2 3 0.5\n2 4 5 6 0.25\n"),
    "PackLSD": ("p.dat", "3\n1 1\n1\n1 0 0\n0 2 0\n0.5 0 3\nT T F\n0 0 0 0.25\n"),
    "tree of the toolkit": ("p.sph", "1 8\n0 0 0 1.5 0.25\n"),
    "Voronota": ("p.xyzr", "A 1 N 1 2 3 1.5\nA 1 C 1 2 4 1.75\n"),
    "MSMS": ("p.xyzr", "1 2 3 4\n5 6 7 0.25\n"),
    "SWC": ("p.swc", "1 1 0 0 0 6.25 -1\n2 3 1 0 0 0.75 11\n"),
    "YADE": ("p.txt", "#format x_y_z_r\n1 2 3 4\n5 6 7 0.25\n"),
    "LIGGGHTS": (
        "p.data",
        "LIGGGHTS data file\n\n1 atoms\n\nAtoms # sphere\n\n1 1 0.5 2.5 1.25 2.25 3.25\n",
    ),
    "DOCK": ("p.sph", "title\ncluster 1 number of spheres in cluster 1\n1 1.5 2 3 0.75\n"),
    "medial axis": ("p.ma", "1 0 0\nv 1 2 3 0.75\n"),
}


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"], ids=["lf", "crlf", "cr"])
@pytest.mark.parametrize("case", BY_PROGRAMS)
def test_programs_end_every_line(read_text, read_error, tmp_path, case, end):
    name, text = BY_PROGRAMS[case]
    assert read_text(text.replace("\n", end), name).n_points > 0
    for cut in (1, 2):
        path = tmp_path / name
        path.write_bytes(text[:-cut].replace("\n", end).encode())
        message, _ = read_error(path)
        assert f"line {text.count(chr(10))}: found the end of the file within the row" in message
        assert "expected a line end after every row (add one if the file is complete)" in message


@pytest.mark.parametrize("cut", ["A", "ATO", "ATOM", "HETA", "HETATM", "HETATM    2  O"])
def test_a_record_of_which_there_is_not_even_a_number(read_error, tmp_path, cut):
    (tmp_path / "p.pqr").write_text(ATOM + cut)
    message, _ = read_error(tmp_path / "p.pqr")
    assert "p.pqr, line 2: found " in message


@pytest.mark.parametrize("last", ["END", "TER\nEND", "TER", "ENDMDL", "", "ENDMDL\nMODEL 2\nATOM"])
def test_not_every_program_ends_the_line_of_end(read_text, last):
    assert read_text(ATOM + last, "p.pqr")["radius"].tolist() == [1.824]


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("p.spheres", "1 2 3 4\n5 6 7 0.25"),
        ("p.spheres", "1 2 3 0.339\n5 6 7 0.25 "),
        ("p.spheres", "1 2 3 0.339\n5 6 7 0.25#"),
        ("p.spheres", "1 2 3 0.339\n5 6 7 0.25\n# comme"),
        ("p.spheres", "1 2 3 3.39e-01\n5 6 7 2.50e-01"),
        ("p.spheres", "1 2 3 4\n5 6 7 8"),
        ("p.spheres", "1 2 3 4"),
        ("p.spheres", "# x y z r name\n1 2 3 4 C1\n5 6 7 8 C2"),
        ("p.csv", "x,y,z,r\n1,2,3,4\n5,6,7,0.25"),
        ("p.csv", '"x","y","z","r"\n"1","2","3","0.339"\n"5","6","7","0.25"'),
        # The real one ends so.
        ("p.sph", "0.25 4\n1\n2\n1 2 3 4\n5 6 7 0.25"),
        ("p.xyz", "2\nplain\n1 1 2 3.00\n1 1 2 4.25"),
        ("p.data", "mine\n\n2 atoms\n\nAtoms # sphere\n\n1 1 2 3 4 5 6.5\n2 1 2 3 4 5 7.5"),
    ],
)
def test_people_may_leave_out_the_last_line_end(read_text, name, text):
    whole = read_text(text + "\n", name, optional=True)
    packing = read_text(text, name, optional=True)
    assert packing.points.tolist() == whole.points.tolist()
    assert [packing[n].tolist() for n in packing.array_names] == [
        whole[n].tolist() for n in whole.array_names
    ]


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("p.spheres", "1 2 3 0.339\n5 6 7 0.3"),
        ("p.spheres", "1 2 3 0.339\n5 6 7 0."),
        ("p.spheres", "1 2 3 0.339\n5 6 7 0"),
        ("p.spheres", "1 2 3 2\n5 6 7 0."),
        ("p.spheres", "1 2 3 22\n5 6 7 3"),
        ("p.spheres", "1 2 3 3.39e-01\n5 6 7 3.33e-0"),
        ("p.spheres", "1 2 3 3.39e-01\n5 6 7 3.33"),
        ("p.spheres", "1 2 3 3.39\n5 6 7 3.33e-0"),
        ("p.spheres", "1.25 2.25 3.25 0.3"),
        ("p.spheres", "# x y z r name\n1 2 3 4 C11\n5 6 7 8 C2"),
        ("p.csv", "x,y,z,r\n1,2,3,0.339\n5,6,7,0.3"),
        ("p.sph", "0.25 4\n1\n2\n1 2 3 0.339\n5 6 7 0.3"),
        ("p.sph", "0.25 4\n2\n1\n1 2 3 0.339\n1\n5 6 7 0.3"),
        ("p.xyz", "2\nplain\n1 1 2 3.25\n1 1 2 4.2"),
        ("p.data", "mine\n\n2 atoms\n\nAtoms # sphere\n\n1 1 2 3 4 5 6.25\n2 1 2 3 4 5 7.2"),
    ],
)
@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"], ids=["lf", "crlf", "cr"])
def test_a_last_number_of_people_that_lacks_digits(read_error, tmp_path, name, text, end):
    (tmp_path / name).write_bytes(text.replace("\n", end).encode())
    message, _ = read_error(tmp_path / name, optional=True)
    assert f"line {text.count(chr(10)) + 1}: found the end of the file within the row" in message
    assert "(add one if the file is complete)" in message


# Where a file that is cut between two lines is one that is whole: no count says what is missing.
WITHOUT_COUNTS = {
    *("table", "csv", "csv of ParaView", "Voronota", "MSMS", "Voro++", "SWC", "YADE", "IMD"),
    *("YADE, SpherePack", "PQR in columns", "PQR between blanks", "HOLE"),
    "DOCK",  # between clusters
    "LAMMPS data and velocities",  # between sections: the spheres are all there
}
# Of which the last line need not end.
BY_PEOPLE = {"table", "csv", "csv of ParaView", "Voro++"}
# The runs that wrote these may have been stopped: a last step that was cut is left out.
WITH_STEPS = {"dump of two steps", "extended XYZ of two frames", "MercuryDPM, two steps"}


@pytest.mark.parametrize("case", WHOLE)
def test_a_file_cut_at_every_byte(read_text, read_steps, tmp_path, case):
    """It is refused, or nothing that it holds is missing or changed."""
    name, text, options = WHOLE[case]
    whole = spheres_of(read_text(text, name, **options))
    path = tmp_path / name
    refused = 0
    for length in range(1, len(text)):
        path.write_bytes(text[:length].encode())
        _, steps = read_steps(path, **options)
        if not steps:
            try:
                steps = [read_text(text[:length], name, **options)]
            except AssertionError:
                refused += 1
                continue
        if isinstance(steps[0], str):
            refused += 1
            continue
        spheres = spheres_of(steps[0])
        # Nor is the line end of TER needed.
        between = text[:length].rpartition("\n")[2] in ("", "T", "TE", "TER")
        if case in BY_PEOPLE or (case in WITHOUT_COUNTS and between):
            assert spheres == whole[: len(spheres)], text[:length][-40:]
        else:
            assert spheres == whole, text[:length][-40:]
        for step in steps[1:]:
            assert isinstance(step, str) or spheres_of(step) == whole
        assert len(steps) == 1 or case in WITH_STEPS
    assert refused > len(text) / 3


def spheres_of(packing):
    rows = packing.points.tolist()
    if "radius" not in packing.point_data:
        return rows
    return [[*row, r] for row, r in zip(rows, packing["radius"].tolist(), strict=True)]
