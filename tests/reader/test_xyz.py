"""Extended XYZ: Properties, Lattice, times, and what has no radius."""

import pytest

FORMAT = 20005
PROPERTIES = "Properties=species:S:1:pos:R:3:radius:R:1"
ROWS = "A 1 1.5 2 0.5\nB 2 2.5 3 0.25\n"


def extended(comment, rows=ROWS):
    return f"{rows.count(chr(10))}\n{comment}\n{rows}"


@pytest.mark.parametrize("name", ["p.xyz", "p.extxyz", "p.exyz", "p.XYZ", "p.txt", "p.7"])
@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"], ids=["lf", "crlf", "cr"])
def test_columns(read_text, name, end):
    packing = read_text(extended(PROPERTIES).replace("\n", end), name)
    assert packing.points.tolist() == [[1, 1.5, 2], [2, 2.5, 3]]
    assert packing["radius"].tolist() == [0.5, 0.25]
    assert packing["species"].tolist() == ["A", "B"]
    assert packing.field_data.keys() == []


def test_further_properties(read_text):
    properties = "id:I:1:radius:R:1:velo:R:3:fixed:L:1:pos:R:3:stress:R:6:name:S:1"
    rows = "7 0.5 1 2 3 T 4 5 6 .1 .2 .3 .4 .5 .6 12\n"
    packing = read_text(extended(f"Properties={properties}", rows), "p.xyz")
    assert packing.points.tolist() == [[4, 5, 6]]
    assert packing["radius"].tolist() == [0.5]
    assert packing["id"].tolist() == [7]
    assert packing["velo"].tolist() == [[1, 2, 3]]
    assert packing["velo_1"].tolist() == [2]
    assert packing["stress_5"].tolist() == [0.6]
    assert packing["fixed"].tolist() == ["T"]
    assert packing["name"].tolist() == ["12"]  # text, though it looks like a number


@pytest.mark.parametrize("name", ["v", "vel", "velo", "velocity"])
def test_velocities(read_text, name):
    properties = f"species:S:1:pos:R:3:radius:R:1:{name}:R:3"
    packing = read_text(extended(f"Properties={properties}", "A 4 5 6 .5 1 2 3\n"), "p.xyz")
    assert packing["velocity"].tolist() == [[1, 2, 3]]
    assert packing[name].tolist() == [[1, 2, 3]]


@pytest.mark.parametrize("name", ["radius", "Radius", "radii", "Radii"])
def test_names_of_the_radius(read_text, name):
    text = extended(f"Properties=species:S:1:pos:R:3:{name}:R:1")
    assert read_text(text, "p.xyz")["radius"].tolist() == [0.5, 0.25]


def test_a_diameter_is_halved_unless_there_is_a_radius(read_text):
    diameter = "Properties=species:S:1:pos:R:3:diameter:R:1"
    assert read_text(extended(diameter), "p.xyz")["radius"].tolist() == [0.25, 0.125]
    packing = read_text(extended(f"{diameter}:radius:R:1", "A 1 2 3 9 0.5\n"), "p.xyz")
    assert packing["radius"].tolist() == [0.5]
    assert packing["diameter"].tolist() == [9]


@pytest.mark.parametrize(
    "comment",
    [
        f'Lattice="5 0 0 1 6 0 2 3 7" {PROPERTIES} pbc="T F T" Origin="-1 -2 -3" Time=2.5',
        f"{PROPERTIES} origin='-1 -2 -3' time=2.5 pbc={{1 0 1}} lattice={{5 0 0 1 6 0 2 3 7}}",
        f"a word {PROPERTIES} LATTICE = [[5, 0, 0], [1, 6, 0], [2, 3, 7]] pbc=[true, false, true] "
        f'Origin="-1, -2, -3" Timestep=9 note="Time=4 \\" pbc=" Time = 2.5',
    ],
)
def test_the_comment(read_text, comment):
    packing = read_text(extended(comment), "p.xyz")
    data = packing.field_data
    assert data["cell_vectors"].tolist() == [[5, 0, 0], [1, 6, 0], [2, 3, 7]]
    assert data["cell_origin"].tolist() == [-1, -2, -3]
    assert data["cell_periodic"].tolist() == [1, 0, 1]
    assert data["TimeValue"].tolist() == [2.5]


@pytest.mark.parametrize(("key", "time"), [("Step=3", 3), ("Timestep=4 Step=3", 4), ("TIME=1", 1)])
def test_the_time(tmp_path, read_steps, key, time):
    (tmp_path / "p.xyz").write_text(extended(f"{PROPERTIES} {key}"))
    times, _ = read_steps(tmp_path / "p.xyz")
    assert times == [time]


@pytest.mark.parametrize(
    ("comments", "values", "numbers"),
    [
        (["Timestep=0 Time=0.000000", "Timestep=100 Time=0.000000"], [0, 100], [0, 100]),
        (["Timestep=0.5 Time=3", "Timestep=0.5 Time=4"], [3, 4], [3, 4]),
        (["Step=5 Time=3", "Step=5 Time=3"], [0, 1], [3, 3]),
        (["Step=5", "Step=7 Time=3"], [5, 7], [5, 7]),
        (["Time=soon", "Time=later"], [0, 1], [None, None]),
    ],
)
def test_the_number_that_increases(tmp_path, read_steps, comments, values, numbers):
    text = "".join(extended(f"{PROPERTIES} {comment}") for comment in comments)
    (tmp_path / "p.xyz").write_text(text)
    times, packings = read_steps(tmp_path / "p.xyz")
    assert times == values
    assert [next(iter(p.field_data.get("TimeValue", [])), None) for p in packings] == numbers


def test_a_lattice_alone_is_periodic(read_text):
    packing = read_text(extended(f'Lattice="5 0 0 0 6 0 0 0 7" {PROPERTIES}'), "p.xyz")
    assert packing.field_data["cell_periodic"].tolist() == [1, 1, 1]
    assert packing.field_data["cell_origin"].tolist() == [0, 0, 0]


def test_blank_lines_between_frames(tmp_path, read_steps):
    text = "\n" + extended(PROPERTIES) + "\n \n" + extended(PROPERTIES) + "\n\n"
    (tmp_path / "p.xyz").write_text(text)
    times, packings = read_steps(tmp_path / "p.xyz")
    assert times == [0, 1]
    assert [packing.n_points for packing in packings] == [2, 2]


def test_a_cloud_of_points_is_a_table(read_text):
    packing = read_text("1.5 2.5 3.5 0.5\n4.5 5.5 6.5 0.25\n", "cloud.xyz")
    assert packing["radius"].tolist() == [0.5, 0.25]


def test_plain_xyz_without_radii(read_text):
    packing = read_text("2\nplain\nC 1 2 3\nN 4 5 6 7\n".replace(" 7", ""), "p.xyz", optional=True)
    assert packing.points.tolist() == [[1, 2, 3], [4, 5, 6]]
    assert packing.point_data.keys() == ["species"]
    assert packing["species"].tolist() == ["C", "N"]


def test_plain_xyz_with_names_given(read_text):
    packing = read_text("1\nplain\n6 1 2 3 0.7 9\n", "p.xyz", columns="Z_nucleus x y z r charge")
    assert packing["radius"].tolist() == [0.7]
    assert packing["Z_nucleus"].tolist() == [6]
    assert packing["charge"].tolist() == [9]


BAD = {
    "plain": ("1\nmade up\nC 1 2 3\n", 2, "no Properties in 'made up', so no radius", "radius:R:1"),
    "plain, a column more": (
        "1\nmade up\nC 1 2 3 0.5\n",
        2,
        "no Properties in 'made up', so no radius",
        'radius:R:1, or columns="element x y z r" (--columns) if the columns are these',
    ),
    "plain, four numbers": (
        "1\nx y z r\n1 2 3 0.5\n",
        2,
        "no Properties in 'x y z r', so no radius",
        'radius:R:1, or columns="x y z r" (--columns) if the columns are these',
    ),
    "no radius": (
        extended("Properties=species:S:1:pos:R:3:vel:R:1"),
        2,
        "Properties without a radius, 'species:S:1:pos:R:3:vel:R:1'",
        "radius:R:1",
    ),
    "no positions": (extended("Properties=species:S:1:v:R:3:radius:R:1"), 2, "no positions", "pos"),
    "no triple": (extended("Properties=species:S"), 2, "'species:S'", "NAME:TYPE:COLUMNS"),
    "no type": (extended("Properties=pos:X:3:radius:R:1"), 2, "'pos:X:3", "S, R, I or L"),
    "no number": (extended("Properties=pos:R:three:radius:R:1"), 2, "'pos:R:three", "NAME:TYPE"),
    "zero columns": (extended("Properties=pos:R:3:radius:R:1:a:R:0"), 2, "a:R:0'", "NAME:TYPE"),
    "one name twice": (
        extended(f"{PROPERTIES}:radius:R:1", "A 1 2 3 4 5\n"),
        2,
        "radius:R:1:ra",
        "NAME:TYPE",
    ),
    "too many": (
        extended(f"{PROPERTIES}:v:R:1000000000000"),
        2,
        "more columns in Properties='species",
        "as many",
    ),
    "too few": (extended(PROPERTIES, "A 1 2 3 4\nB 1 2 3 4 5\n"), 4, "6 columns", "5 columns: sp"),
    "lattice": (extended(f'Lattice="1 2 3" {PROPERTIES}'), 2, "'1 2 3' as lattice", "nine numbers"),
    "no numbers": (extended(f'Lattice="{"x " * 9}" {PROPERTIES}'), 2, "as lattice", "nine numbers"),
    "pbc": (extended(f'Lattice="{"1 " * 9}" {PROPERTIES} pbc="T F"'), 2, "'T F' as pbc", "T or F"),
    "count too large": (
        "3\n" + extended(PROPERTIES)[2:],
        1,
        "3 as the number of atoms, but 2 lines",
        "as many",
    ),
    "count beyond all": (
        f"{10**15}\n" + extended(PROPERTIES)[2:],
        1,
        f"{10**15} as the number of atoms, but 2 lines",
        "as many",
    ),
    "count too small": (
        "1\n" + extended(PROPERTIES)[2:],
        4,
        "'B 2 2.5 3 0.25'",
        "the number of atoms after as many rows as line 1 says",
    ),
    "no count": ("two\n" + extended(PROPERTIES)[2:], 1, "'two'", "the number of atoms"),
    "half a count": ("1.5\n" + extended(PROPERTIES)[2:], 1, "'1.5'", "the number of atoms"),
    "negative count": ("-2\n" + extended(PROPERTIES)[2:], 1, "'-2'", "the number of atoms"),
    "nothing after": ("2\n", 1, "the end of the file", "a comment and atoms"),
    "bad number": (extended(PROPERTIES, "A 1 2 3 0.5\nB 1 y 3 1\n"), 4, "'y' as y", "a number"),
    "negative radius": (extended(PROPERTIES, "A 1 2 3 -1\n"), 3, "'-1' as radius", "not negative"),
    "nan": (extended(PROPERTIES, "A 1 nan 3 1\n"), 3, "'nan' as y", "a finite number"),
}


@pytest.mark.parametrize("case", BAD, ids=[case.replace(" ", "-") for case in BAD])
def test_bad_xyz(read_error, tmp_path, case):
    text, line, found, expected = BAD[case]
    path = tmp_path / "p.xyz"
    path.write_text(text)
    message, code = read_error(path, fmt="XYZ")
    assert message.startswith(f"{path}, line {line}: found ")
    assert found in message
    assert expected in message[message.index("expected") :]
    assert code == FORMAT


@pytest.mark.parametrize(
    ("name", "row", "radius"),
    [
        ("r:R:1", "0.5", 0.5),
        ("d:R:1", "0.5", 0.25),
        ("D:R:1", "0.5", 0.25),
        ("diam:R:1", "0.5", 0.25),
        ("Durchmesser:R:1", "0.5", 0.25),
        ("particle_radius:R:1", "0.5", 0.5),
        ("particle_diameter:R:1", "0.5", 0.25),
        ("r:R:1:d:R:1", "0.5 8", 0.5),
        ("r:R:1:radius:R:1", "8 0.5", 0.5),
        ("r:R:1:diameter:R:1", "8 0.5", 0.25),
        ("radii:R:3", "0.5 0.5 0.5", 0.5),
        ("diameter:R:3", "0.5 0.5 0.50", 0.25),
        ("radii:R:3:radius:R:1", "1 2 3 0.5", 0.5),
    ],
)
def test_sizes_by_other_names(read_text, name, row, radius):
    packing = read_text(extended(f"Properties=pos:R:3:{name}", f"1 2 3 {row}\n"), "p.xyz")
    assert packing["radius"].tolist() == [radius]
    assert not {"radii_1", "radii_2", "diameter_1"} & set(packing.point_data) or "radius:" in name


@pytest.mark.parametrize(
    ("name", "row", "found"),
    [
        ("r:R:1:theta:R:1", "0.5 1", "Properties without a radius"),
        ("r:R:1:g:R:1:b:R:1", "0.5 1 1", "Properties without a radius"),
        ("depth:R:1", "0.5", "Properties without a radius"),
        ("r:R:3", "0.5 0.5 0.5", "Properties without a radius"),
        ("r:S:1", "0.5", "Properties without a radius"),
        ("radius_mm:R:1", "0.5", "Properties without a radius"),
        ("r:R:1:rad:R:1", "0.5 0.5", "r and rad in Properties="),
        ("radii:R:3", "0.5 0.5 0.6", "different components of 'radii' of atom 1"),
        ("radii:R:3", "0.5 x 0.5", "different components of 'radii' of atom 1"),
        ("diameter:R:3", "0.5 0.6 0.5", "different components of 'diameter' of atom 1"),
    ],
)
def test_sizes_that_are_not_certain(read_text, name, row, found):
    with pytest.raises(Exception, match=rf"p\.xyz, line 2: found {found}"):
        read_text(extended(f"Properties=pos:R:3:{name}", f"1 2 3 {row}\n"), "p.xyz")


def test_names_are_not_given_to_columns_that_have_them(read_error, tmp_path):
    path = tmp_path / "p.xyz"
    path.write_text("1\nProperties=species:S:1:pos:R:3:radius:R:1\nC 1 2 3 0.5\n")
    for columns in ("element x y z d", "element x y z radius"):
        message, _ = read_error(path, columns=columns)
        assert message == (
            f"{path}, line 2: found names of columns for atoms whose Properties say what their "
            "columns are, expected none"
        )
