"""Files cut within their last number, of programs that end every line and of people who do not."""

import pytest

ATOM = "ATOM      1  N   ALA A   1      -0.750  -1.125  -0.375  0.1414 1.8240\n"
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
        assert "expected a line end after every row" in message


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
        ("p.csv", "x,y,z,r\n1,2,3,4\n5,6,7,0.25"),
        ("p.xyzr", "1 2 3 4\n5 6 7 0.25"),
        # The real one ends so.
        ("p.sph", "0.25 4\n1\n2\n1 2 3 4\n5 6 7 0.25"),
    ],
)
def test_people_may_leave_out_the_last_line_end(read_text, name, text):
    assert read_text(text, name)["radius"].tolist() == [4, 0.25]


def test_plain_xyz_by_people(read_text):
    packing = read_text("1\nplain\nC 1 2 3 0.25", "p.xyz", columns="element x y z r")
    assert packing["radius"].tolist() == [0.25]
