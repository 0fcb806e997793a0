"""Units in lines of their own beside names of columns."""

import pytest

ROWS = "1.5 2.5 3.5 0.5\n4 5 6.5 0.25\n"
BY_PLACE = [[1.5, 2.5, 3.5, 0.5], [4, 5, 6.5, 0.25]]


def spheres(packing):
    return [
        [*center, radius]
        for center, radius in zip(packing.points.tolist(), packing["radius"].tolist(), strict=True)
    ]


@pytest.fixture
def refused(read_error, tmp_path):
    """Read a text that has to be refused: the message without the name of the file."""

    def read(text, name="p.txt", **options):
        path = tmp_path / name
        path.write_text(text)
        message, _ = read_error(path, **options)
        return message.removeprefix(str(path))

    return read


@pytest.mark.parametrize(
    ("text", "name", "line"),
    [
        ("# x y z r\n# m m m mm\n" + ROWS, "p.txt", 2),
        ("# x y z r\n# [m] [m] [m] [mm]\n" + ROWS, "p.txt", 2),
        ("# units: m, m, m, mm\n# x y z r\n" + ROWS, "p.txt", 1),
        ("# m m m m\n# x_mm y_mm z_mm r_mm\n" + ROWS, "p.txt", 1),
        ("# units: x,y,z in m; radius in mm\nx,y,z,radius\n1.5,2,3,4\n", "p.csv", 1),
        ("# positions in m, radii in mm\nx y z r\n" + ROWS, "p.txt", 1),
        ("# positions in m, radii in mm\n# x y z r\n" + ROWS, "p.txt", 1),
        ("x,y,z,r\nm,m,m,mm\n1,2,3,4\n", "p.csv", 2),
        ("x [mm],y [mm],z [mm],r [mm]\nm,m,m,m\n1,2,3,4\n", "p.csv", 2),
        ("x y z r\n(m) (m) (m) (cm)\n" + ROWS, "p.txt", 2),
    ],
)
def test_units_that_differ(refused, read_text, text, name, line):
    message = refused(text, name)
    assert message.startswith(f", line {line}: found several units of length in ")
    assert 'columns="x y z r" (--columns)' in message
    assert read_text(text, name, columns="x y z r").n_points > 0


@pytest.mark.parametrize(
    "units",
    ["m,m,m,m", "[m],[m],[m],[m]", "(mm),(mm),(mm),(mm)", "um,um,um,micron", "µm,µm,µm,µm"],
)
@pytest.mark.parametrize("form", ["csv", "semicolons", "blanks", "tabs", "comment"])
def test_a_line_of_one_unit(read_text, units, form):
    between = {"csv": ",", "semicolons": ";", "tabs": "\t"}.get(form, " ")
    lines = ["x,y,z,r", units, *ROWS.replace(" ", ",").splitlines()]
    text = "\n".join(lines).replace(",", between) + "\n"
    if form == "comment":
        text = "# " + text.replace("\n", "\n# ", 1)
    name = "p.csv" if form in ("csv", "semicolons") else "p.txt"
    assert spheres(read_text(text, name)) == BY_PLACE


def test_units_of_further_columns(read_text):
    text = "x,y,z,r,mass,depth,n\nmm,mm,mm,mm,kg,m,-\n1.5,2.5,3.5,0.5,7,8,9\n"
    packing = read_text(text, "p.csv")
    assert spheres(packing) == BY_PLACE[:1]
    assert packing["depth"].tolist() == [8]
    packing = read_text("# x y z r h\n# mm mm mm mm m\n1.5 2.5 3.5 0.5 7\n", "p.txt")
    assert packing["h"].tolist() == [7]


@pytest.mark.parametrize(
    "comment",
    [
        *("box 10 cm, radius 0.5 mm", "density in kg/m^3, lengths in mm", "all in mm"),
        *("x (mm) y (mm) z (mm) r (mm)", "from m to mm: 1000"),
    ],
)
def test_remarks_that_agree(read_text, comment):
    assert spheres(read_text(f"# {comment}\n# x y z r\n{ROWS}")) == BY_PLACE
    text = f"# {comment}\nx,y,z,r\n" + ROWS.replace(" ", ",")
    assert spheres(read_text(text, "p.csv")) == BY_PLACE


def test_a_name_with_a_unit_for_another_column(read_text):
    text = "# x (mm) y (mm) z (mm) r (mm) h (m)\n1.5 2.5 3.5 0.5 7\n"
    assert spheres(read_text(text)) == BY_PLACE[:1]
