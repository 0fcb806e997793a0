"""Comments that list names of columns, in some languages and ways to write them, and later ones."""

import numpy as np
import pytest


def spheres(packing):
    return np.column_stack([packing.points, packing["radius"]]).tolist()


@pytest.fixture
def refused(read_error, tmp_path):
    """Read a text that has to be refused: the message without the name of the file."""

    def read(text, name="p.txt", **options):
        path = tmp_path / name
        path.write_text(text, encoding="utf-8")
        message, _ = read_error(path, **options)
        assert message.startswith(str(path))
        return message.removeprefix(str(path))

    return read


HINT = 'columns="id x y z r" (--columns)'
FOUR = "1.5 2.5 3.5 0.5\n4 5 6.5 0.25\n"
FIVE = "1.5 2.5 3.5 0.5 7.25\n4 5 6.5 0.25 9\n"
BY_PLACE = [[1.5, 2.5, 3.5, 0.5], [4, 5, 6.5, 0.25]]
HALVED = [[1.5, 2.5, 3.5, 0.25], [4, 5, 6.5, 0.125]]
RADIUS_FIRST = [[2.5, 3.5, 0.5, 1.5], [5, 6.5, 0.25, 4]]
DIAMETER_FIRST = [[2.5, 3.5, 0.5, 0.75], [5, 6.5, 0.25, 2]]


@pytest.mark.parametrize(
    "names", ["Rayon X Y Z", "raggio x y z", "Radio x y z", "Радиус x y z", "半径 x y z"]
)
def test_radius_in_other_languages(read_text, names):
    assert spheres(read_text(f"# {names}\n{FOUR}")) == RADIUS_FIRST


def test_names_of_places_in_other_languages(read_text):
    names = "# Radius X-Koordinate Y-Koordinate Z-Koordinate\n"
    assert spheres(read_text(names + FOUR)) == RADIUS_FIRST


@pytest.mark.parametrize(
    "names",
    [
        "x y z Durchmesser",
        "x y z diametro",
        "x y z diámetro",
        "x y z diamètre",
        "x y z диаметр",
        "x y z 直径",
        "x, y, z, Durchmesser [mm]",
        "x;y;z;Durchmesser",
    ],
)
def test_diameter_in_other_languages(read_text, names):
    assert spheres(read_text(f"# {names}\n{FOUR}")) == HALVED


def test_diameter_first_in_another_language(read_text):
    assert spheres(read_text("# Durchmesser x y z\n" + FOUR)) == DIAMETER_FIRST


@pytest.mark.parametrize("names", ["Centre(x,y,z) Diameter", "(x, y, z) d", "xyz and diameter"])
def test_one_name_for_the_position_over_four_columns(read_text, names):
    assert spheres(read_text(f"# {names}\n{FOUR}")) == HALVED


@pytest.mark.parametrize(
    "names",
    [
        "position diameter density",
        "Positions (x y z), diameter, density",
        "xyz d rho",
        "'x' 'y' 'z' 'd' 'rho'",
        "`x` `y` `z` `d` `rho`",
        r"$x$ $y$ $z$ $d$ $\rho$",
    ],
)
def test_names_with_a_diameter_over_five_columns(read_text, names):
    assert spheres(read_text(f"# {names}\n{FIVE}")) == HALVED


@pytest.mark.parametrize(
    "names",
    [
        "mass x y z",
        "t x y z",
        "d50 x y z",
        "a x y z",
        "x y z mass",
        "x y z type",
        "x y z id",
        "x y z T",
        "x y z 2r",
        "x y z 2*r",
        "x y z log(r)",
        "x y z m",
        "x, y, z and mass",
        "vx vy vz r",
        "theta phi rho r",
        "lat lon r z",
        "a b c r",
        "x y z : mass",
        "xyz mass",
        "position, mass",
        "position and velocity",
    ],
)
def test_lists_of_other_names_over_four_columns(refused, names):
    message = refused(f"# made by hand\n# {names}\n# of today\n{FOUR}")
    assert message.startswith(", line 2: found ")
    assert 'columns="x y z r"' in message


@pytest.mark.parametrize(
    "names",
    [
        "vx vy vz r m",
        "particle positions diameter",
        "sphere centre diameter",
        "positions m d",
        "id positions r m",
    ],
)
def test_lists_of_other_names_over_five_columns(refused, names):
    rows = "".join(f"{row} 1\n" for row in FIVE.splitlines()) if names[0] == "p" else FIVE
    assert refused(f"# {names}\n{rows}").startswith(f", line 1: found the names '# {names}'")


@pytest.mark.parametrize(
    "words",
    [
        "the x axis points up",
        "x axis points up",
        "spheres in x, y, z and their radius",
        "made by a script",
        "packing of spheres radius",
        "radius of all spheres",
        "sphere radius 0.5 mm",
        "x, y, z, radius of the sphere",
        "x1 x2 x3 r",
        "x y z and r",
        "x / y / z / r and more",
        "xyzr of the spheres",
        "positions and radii",
        "sphere center radius",
    ],
)
def test_sentences_and_what_fits_by_place(read_text, words):
    assert spheres(read_text(f"# {words}\n{FOUR}")) == BY_PLACE


@pytest.mark.parametrize(
    ("name", "factor"),
    [
        *((name, 1) for name in ["R_eff", "r_eff", "Rp", "R_p", "rp", "Reff", "radius_mm"]),
        *((name, 0.5) for name in ["d_eq", "D_eff", "dp", "d_p", "diameter_um", "Diameter/mm"]),
        *((name, 1) for name in ["inscribed_radius", "Effective radius", "radius/mm"]),
        ("equivalent_sphere_diameter", 0.5),
    ],
)
def test_sizes_that_are_certain_by_their_parts(read_text, name, factor):
    expected = [[*row[:3], row[3] * factor] for row in BY_PLACE]
    header = f"x,y,z,{name}\n"
    assert spheres(read_text(header + FOUR.replace(" ", ","), "p.csv")) == expected
    assert spheres(read_text("# " + header + FOUR)) == expected


@pytest.mark.parametrize("axes", ["px,py,pz", "p_x,p_y,p_z", "xp,yp,zp", "X_p,Y_p,Z_p"])
def test_coordinates_of_particles(read_text, axes):
    for names in (f"{axes},radius", f"{axes},r"):
        assert spheres(read_text(f"{names}\n{FOUR}".replace(" ", ","), "p.csv")) == BY_PLACE
        assert spheres(read_text(f"# {names}\n{FOUR}".replace(",", " "))) == BY_PLACE
    assert spheres(read_text(f"# radius,{axes}\n{FOUR}".replace(",", " "))) == RADIUS_FIRST


@pytest.mark.parametrize(
    ("header", "radius"),
    [
        *(("x,y,z,radius,R_eff", 4), ("x,y,z,R_eff,r", 5), ("x,y,z,r,Rp", 4), ("x,y,z,dp,d", 2.5)),
        *(("x,y,z,radius_mm,radius", 5), ("x,y,z,r,radius_mm", 4), ("x,y,z,d_eq,Rp", 5)),
        *(("x,y,z,Rp,diameter", 2.5), ("x,y,z,radius_mm,diameter", 2.5), ("x,y,z,dp,radius_mm", 5)),
        *(("x_mm,y_mm,z_mm,r_um,r", 5), ("x_mm,y_mm,z_mm,r_mm,radius_um", 4)),
    ],
)
def test_plain_names_win(read_text, header, radius):
    packing = read_text(header + "\n1,2,3,4,5\n", "p.csv")
    assert packing["radius"].tolist() == [radius]
    assert packing.n_arrays == 2, "the other stays"


@pytest.mark.parametrize("axes", ["x,y,z", "pos_x,pos_y,pos_z"])
def test_a_momentum_beside_a_place(read_text, axes):
    packing = read_text(f"{axes},px,py,pz,r\n1,2,3,4,5,6,7\n", "p.csv")
    assert spheres(packing) == [[1, 2, 3, 7]]
    assert packing["px"].tolist() == [4]


@pytest.mark.parametrize("name", ["r_i", "R_s", "r_m", "d_m", "r_cm", "radial", "rxx", "r_um"])
def test_names_that_may_be_something_else(refused, name):
    message = refused(f"x,y,z,{name}\n1,2,3,4\n", "p.csv")
    assert message.startswith(f", line 1: found the columns 'x,y,z,{name}', expected a header")


def test_two_names_of_parts(refused):
    message = refused("x,y,z,r_eff,Rp\n1,2,3,4,5\n", "p.csv")
    assert "'r_eff' and 'Rp', which name one thing twice" in message


@pytest.mark.parametrize("angle", ["theta", "phi"])
def test_the_user_may_call_a_distance_a_radius(read_text, angle):
    packing = read_text(FIVE, columns=f"x y z r {angle}")
    assert spheres(packing) == BY_PLACE
    assert packing[angle].tolist() == [7.25, 9]


@pytest.mark.parametrize("angle", ["theta", "phi", "azimuth", "polar", "θ"])
@pytest.mark.parametrize("begin", ["", "# "])
def test_r_beside_an_angle_is_a_distance(refused, read_text, angle, begin):
    for names, rows in (("r {} z x y", "1 2 3 4 5\n"), ("x y z r {}", "4.5 5 3 1 2\n")):
        text = begin + names.format(angle) + "\n" + rows
        message = refused(text)
        assert "'r', which is a distance" in message
        assert 'or radius="r" (--radius) if it is one' in message
    text = f"{begin}x y z radius {angle}\n4.5 5 3 1 2\n"
    assert spheres(read_text(text)) == [[4.5, 5, 3, 1]]


class TestLaterComments:
    """Names further down, as where two files became one."""

    @pytest.mark.parametrize(
        ("text", "line"),
        [
            ("#format id_x_y_z_r\n1 2 3 4 .5\n#format x_y_z_r_id\n2 3 4 .5 1\n", 3),
            ("# x y z r t\n1.5 2 3 .5 7\n# r x y z t\n.5 1.5 2 3 7\n", 3),
            ("x y z r t\n1.5 2 3 .5 7\n\n# r x y z t\n.5 1.5 2 3 7\n", 4),
            ("# x y z r\n" + FOUR + "# x y z d\n" + FOUR, 4),
            (FOUR + "# written by hand\n# r x y z\n" + FOUR, 4),
            (FOUR + "# x y z mass\n" + FOUR, 3),
            (FOUR + "# r\n# x\n# y\n# z\n" + FOUR, 3),
            (FOUR + "# positions and diameters\n" + FOUR, 3),
            ("x,y,z,r\n1,2,3,4\n# x,y,z,diameter\n1,2,3,4\n", 3),
            ("# x y z r t\n" + FIVE + "# id x y z r\n1 1.5 2 3 .5\n", 4),
            ("# x y z r t\n" + FIVE + "# id x y z r vx vy\n1 1.5 2 3 .5\n", 4),
            ("##PERIODIC:: 5 5 5\n" + FOUR + "##PERIODIC:: 5 5 6\n" + FOUR, 4),
            (FOUR + "##PERIODIC:: 5 5 6\n" + FOUR, 3),
        ],
    )
    @pytest.mark.parametrize("chunk", [1, 9, 1 << 20])
    def test_that_disagree(self, refused, text, line, chunk):
        message = refused(text, "p.csv" if text[1] == "," else "p.txt", chunk=chunk)
        assert message.startswith(f", line {line}: found the comment '#")
        assert message.endswith("expected the same columns in all rows")

    @pytest.mark.parametrize(
        "text",
        [
            "#format x_y_z_r\n# d\n1.5 2.5 3.5 0.5\n#format x_y_z_r\n# x y z d\n4 5 6.5 0.25\n",
            "# x y z r\n1.5 2.5 3.5 0.5\n#x, y, z, radius\n4 5 6.5 0.25\n#\n",
            "1.5 2.5 3.5 0.5\n# the z axis, and y, point up by x\n4 5 6.5 0.25\n",
            "1.5 2.5 3.5 0.5\n# x y z radius of the rest\n# r of box 5\n4 5 6.5 0.25\n",
            "1.5 2.5 3.5 0.5\n# 1 2 3 4\n#\n\n4 5 6.5 0.25\n# x y z r",
            "##PERIODIC:: 5 5 5\n1.5 2.5 3.5 0.5\n##PERIODIC:: 5 5 5\n4 5 6.5 0.25\n",
        ],
    )
    @pytest.mark.parametrize("chunk", [1, 9, 1 << 20])
    def test_that_agree(self, read_text, text, chunk):
        assert spheres(read_text(text, chunk=chunk)) == BY_PLACE

    def test_columns_outrank_them(self, read_text):
        text = "1.5 2.5 3.5 0.5\n# r x y z\n4 5 6.5 0.25\n"
        assert spheres(read_text(text, columns="x y z r")) == BY_PLACE


@pytest.mark.parametrize(
    "text",
    [
        "     x    y    z     r\n0  1.5  2.5  3.5  0.50\n1  4.0  5.0  6.5  0.25\n",
        "     x    y    z     r\n1  1.5  2.5  3.5  0.50\n2  4.0  5.0  6.5  0.25\n",
        '"x" "y" "z" "r"\n"1" 1.5 2.5 3.5 0.5\n"2" 4 5 6.5 0.25\n',
        '"x"\t"y"\t"z"\t"r"\n"1"\t1.5\t2.5\t3.5\t0.5\n"2"\t4\t5\t6.5\t0.25\n',
        '"x","y","z","r"\n"1",1.5,2.5,3.5,0.5\n"2",4,5,6.5,0.25\n',
        "x y z r\n1 1.5 2.5 3.5 0.5\n2 4 5 6.5 0.25\n3 4 5 6.5 0.25\n",
    ],
    ids=["to_string", "from 1", "write.table", "tabs", "commas", "without quotes"],
)
def test_an_index_without_a_name(read_text, text):
    """As DataFrame.to_string of pandas and write.table of R write it by default."""
    for name in ["p.txt", "p.csv"] if '",' in text or "\t" in text else ["p.txt"]:
        packing = read_text(text, name)
        assert spheres(packing)[:2] == BY_PLACE
        assert packing.array_names == ["radius"]


@pytest.mark.parametrize("name", ["p.txt", "p.csv"])
@pytest.mark.parametrize("second", ["2", "1"])
def test_what_may_be_an_index_without_a_name(refused, second, name):
    text = f"x,y,z,r\n1,1.5,2.5,3.5,0.5\n{second},4,5,6.5,0.25\n"
    message = refused(text, name)
    assert ("an index without a name" in message) == (second == "2")
    assert message.startswith(", line 1: found the 4 names 'x,y,z,r' over rows of 5 columns")
    assert HINT in message


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("     x    y    z     r\n0  1.5  2.5  3.5  0.50\n4  4.0  5.0  6.5  0.25\n", "p.txt"),
        ('"x" "y" "z" "r"\n"a" 1.5 2.5 3.5 0.5\n"b" 4 5 6.5 0.25\n', "p.txt"),
        ('"x"\t"y"\t"z"\t"r"\n"a"\t1.5\t2.5\t3.5\t0.5\n"b"\t4\t5\t6.5\t0.25\n', "p.txt"),
        ('"x","y","z","r"\n"a",1.5,2.5,3.5,0.5\n"b",4,5,6.5,0.25\n', "p.csv"),
        ("x,y,z,r\n3,1.5,2.5,3.5,0.5\n5,4,5,6.5,0.25\n", "p.csv"),
    ],
    ids=["pandas", "R", "R with tabs", "R with commas", "numbers with gaps"],
)
def test_an_index_that_does_not_count(refused, read_text, text, name):
    message = refused(text, name)
    assert message.startswith(", line 1: found the 4 names ")
    assert " over rows of 5 columns, expected a name for each column, or " + HINT in message
    assert spheres(read_text(text, name, columns="id x y z r")) == BY_PLACE


@pytest.mark.parametrize("name", ["radius_{}", "Radius:{}", "diameter_{}"])
def test_a_radius_of_three_equal_components(read_text, refused, name):
    """As ParaView writes an array of three components."""
    header = ",".join(["Points:0", "Points:1", "Points:2", *map(name.format, range(3)), "m"])
    packing = read_text(
        header + '\n1.5,2.5,3.5,0.5,"0.50",.5,7\n4,5,6.5,0.25,0.25,0.25,8\n', "p.csv"
    )
    assert spheres(packing) == (HALVED if "dia" in name else BY_PLACE)
    assert packing.array_names == ["radius", "m"]
    rows = "1.5,2.5,3.5,0.5,0.5,0.5,7\n4,5,6.5,0.25,0.25,{},8\n"
    for other in ("0.5", "", "a"):
        message = refused(header + "\n" + rows.format(other), "p.csv")
        assert message.startswith(", line 3: found a radius of different components in '4,5,")


@pytest.mark.parametrize("name", ["p.csv", "p.txt"])
@pytest.mark.parametrize("separator", ";,\t")
def test_the_separator_line_of_excel(read_text, separator, name):
    text = "sep=;\r\nx;y;z;r\r\n1.5;2.5;3.5;0.5\r\n4;5;6.5;0.25\r\n".replace(";", separator)
    assert spheres(read_text(text, name)) == BY_PLACE
