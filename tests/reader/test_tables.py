"""What names, comments and the numbers themselves say about the columns of a table."""

import time

import numpy as np
import pytest


def spheres(packing):
    return np.column_stack([packing.points, packing["radius"]]).tolist()


@pytest.fixture
def refused(read_error, tmp_path):
    """Read a text that has to be refused: the message without the name of the file."""

    def read(text, name="p.txt", **options):
        path = tmp_path / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        message, _ = read_error(path, **options)
        assert message.startswith(str(path))
        return message.removeprefix(str(path))

    return read


FOUR = "12.5 3.25 4 0.75\n14 3.25 4.5 0.5\n"
FIVE = "1 12.5 3.25 4 0.75\n2 14.0 3.25 4.5 0.5\n"
FIRST, LAST = [12.5, 3.25, 4, 0.75], [14, 3.25, 4.5, 0.5]

READ = {
    "a wide gap between names": "# Grain number  x  y  z  radius\n" + FIVE,
    "names of two words": "# Particle ID x y z radius\n" + FIVE,
    "a header of two words": "Particle ID x y z radius\n" + FIVE,
    "tabs between names": "Grain number\tx\ty\tz\tradius\n" + FIVE.replace(" ", "\t"),
    "numbers before names": "#1:id 2:x 3:y 4:z 5:r\n" + FIVE,
    "numbers apart": "# 1: id 2: x 3: y 4: z 5: r\n" + FIVE,
    "numbers from 0": "# 0:id 1:x 2:y 3:z 4:r\n" + FIVE,
    "numbers that leave out a column": "# 2:x 3:y 4:z 5:r\n" + FIVE,
    "numbers in brackets": "# [1] id [2] x [3] y [4] z [5] r\n" + FIVE,
    "numbers out of order": "# 5:r 4:z 3:y 2:x 1:id\n" + FIVE,
    "units": "# id x mm y mm z mm r mm\n" + FIVE,
    "a unit for all": "# id x y z r in mm\n" + FIVE,
    "units in brackets": "# id x [mm] y [mm] z [mm] r [mm]\n" + FIVE,
    "units of several words": "# id x (in mm) y (in mm) z (in mm) r (in mm)\n" + FIVE,
    "units joined by _": "id,x_mm,y_mm,z_mm,radius_mm\n" + FIVE.replace(" ", ","),
    "a comment for each column": "# column 1: id\n# column 2: x\n# column 3: y\n# column 4: z\n"
    "# column 5: radius\n" + FIVE,
    "a comment for each column, by number": "# 1 id\n# 2 x\n# 3 y\n# 4 z\n# 5 radius [mm]\n" + FIVE,
    "a comment for each column, and others": "# made by hand\n# id\n# x: in mm\n# y\n# z\n# r\n"
    + FIVE,
    "the names of IMD": "#F A 1 0 0 3 0 1\n#C number x y z Radius\n#E\n" + FIVE,
    "the program's #format": "#format id_x_y_z_r\n# id x y z d\n" + FIVE,
    "the program's #format, after a comment": "# d x y z id\n#format id_x_y_z_r\n" + FIVE,
    "first four names, more columns": "# x y z r\n"
    + FOUR.replace("0.75", "0.75 7 8").replace("0.5\n", "0.5 9 9\n"),
    "first four names, fewer columns": "# x y z r and vx vy vz\n"
    + FOUR.replace("0.75", "0.75 7").replace("0.5\n", "0.5 9\n"),
    "a sentence over four columns": "# the centres x, y, z and radii r of two\n" + FOUR,
    "a sentence before the names": "# 2 spheres: x y z r\n" + FOUR,
    "whole x, y and z": "# spheres: x y z r\n1 0 0 0.5\n2 0 0 0.5\n3 0 0 0.5\n",
    "a whole x in every row of four": "1 0 0 0.5\n2 0 0 0.5\n3 0 0 0.5\n",
    "no blank before the unit": "x(mm) y(mm) z(mm) r(mm)\n" + FOUR,
    "another sign of a comment": "//X Y Z Radius\n" + FOUR,
}


@pytest.mark.parametrize("case", READ, ids=[case.replace(" ", "-") for case in READ])
def test_the_columns_are_certain(read_text, case):
    found = spheres(read_text(READ[case], "p.csv" if "," in READ[case][:12] else "p.txt"))
    if "whole" in case:
        assert found == [[1, 0, 0, 0.5], [2, 0, 0, 0.5], [3, 0, 0, 0.5]]
    else:
        assert found == [FIRST, LAST]


HINT = 'columns="id x y z r" (--columns)'
REFUSED = {
    "more names than columns": ("# id x y z r vx vy vz\n" + FIVE, 1, "'# id x y z r vx vy vz'"),
    "radius first, a name too many": ("# r x y z material\n" + FOUR, 1, "'# r x y z material'"),
    "fewer names than columns": ("# id x y z r\n" + FIVE.replace("\n", " 7\n"), 1, "6 columns"),
    "ids named over four columns": ("# id x y z r\n" + FOUR, 1, "4 columns"),
    "numbers of columns not there": ("# 3:x 4:y 5:z 6:r\n" + FIVE, 1, "over rows of 5"),
    "numbers that may begin at 0 or 1": ("# 1:x 2:y 3:z 4:r\n" + FIVE, 1, "over rows of 5"),
    "comments that do not name all": ("# x\n# y\n# z\n# radius\n" + FIVE, 1, "'# x'"),
    "a name for all columns but no radius": ("# id x y z mass\n" + FIVE, 1, "none of a radius"),
    "a header without a radius": ("x y z mass\n" + FOUR, 1, "names"),
    "ids": (FIVE, 1, "first column"),
    "ids in any order": ("2 1.5 2 3 0.5\n1 4 5 6 0.5\n", 1, "ids"),
    "ids that skip": ("10 1.5 2 3 0.5\n17 4 5 6 0.5\n40 1 1 1 1\n", 1, "ids"),
    "ids from 0 of whole numbers": ("0 1 2 3 4\n1 4 5 6 7\n", 1, "ids"),
    "ids, a volume": ("1 0.5 0.5 0.5 0.94 0.4\n3 0.1 0.1 0.1 0.058 0.05\n", 1, "ids"),
    "kinds": ("1 0.5 0.5 0.5 0.4\n1 0.1 0.1 0.1 0.05\n", 1, "ids"),
    "ids with a point": (
        "".join(f"{i}.00e+00 {i * i % 7}.5 2 3 0.5\n" for i in (3, 2, 1, 8, 7, 6, 5, 4)),
        1,
        "numbers of the rows",
    ),
    "ids by savetxt": (
        "".join(f"{i:.18e} {i * i + 0.5:.18e} {-i:.18e} 3e+00 5e-01\n" for i in (1, 2, 3)),
        1,
        "ids",
    ),
    "ids over four columns": ("# of spheres x y z r\n1 2.5 3 4\n2 3.5 4 5\n", 2, "ids"),
    "red": ("X,Y,Z,R,G,B\n0.5,0,0,255,0,0\n", 1, "'R', which is red"),
    "red in a comment": ("# x y z r g b\n0.5 0 0 255 0 0\n", 1, "'r', which is red"),
    "red over four columns": ("# x y z r g b\n0.5 0 0 255\n", 1, "'r', which is red"),
    "red, small, with opacity": ("x y z r g b a\n0.5 0 0 1 0 0 1\n", 1, "'r', which is red"),
    "a distance": ("x,y,z,r,theta,phi\n1,0,0,1,1.57,0\n", 1, "an angle such as theta or phi"),
    "two places": ("pos_x,pos_y,pos_z,cx,cy,cz,r\n1,2,3,4,5,6,7\n", 1, "'pos_x' and 'cx'"),
    "two units": ("x [m],y [m],z [m],r [mm]\n1,2,3,4\n", 1, "units of 'x [m]' and 'r [mm]'"),
    "two units behind names": ("# x mm y mm z mm r um\n" + FOUR, 1, "found"),
    "two units in brackets": ("# x [mm] y [mm] z [mm] r [um]\n" + FOUR, 1, "found"),
    "two units joined": ("x_mm y_mm z_mm r_um\n" + FOUR, 1, "found"),
    "two short names": ("x y z r rad\n1 2 3 4 5\n", 1, "'r' and 'rad'"),
    "two full names": ("x y z radius Radius\n1 2 3 4 5\n", 1, "'radius' and 'Radius'"),
    "prose": ("Spheres of a run\nwritten by hand\n" + FOUR, 1, "'Spheres of a run', which is"),
    "prose of other letters": ("Größe der Kugeln – 球\n" + FOUR, 1, "'Größe der Kugeln – 球'"),
    "a count": ("2\n" + FOUR, 1, "1 column '2'"),
    "a count and a box": ("2 20 20 20\n" + FOUR, 1, "number of the 2 rows"),
    "a count and a box of cubes": (
        "3 1.0 1.0 1.0\n0.5 0.5 0.5 0.1\n0.1 0.1 0.1 0.1\n0 1 0 0.1\n",
        1,
        "number of the 3 rows",
    ),
    "a count and a box around 0": ("2 4 4 4\n-1.5 1.5 0 0.5\n2 0 0 0.5\n", 1, "the 2 rows"),
    "a box and a count": ("10.0 10.0 10.0 2\n" + FOUR.replace("1", "0"), 1, "the 2 rows"),
    "bounds and a count": (
        "0 10 0 10 0 10 2\n1.5 2 3 0.5 0 0 0\n4.5 5 6 0.5 0 0 0\n",
        1,
        "number of the 2 rows",
    ),
    "a count and bounds": (
        "2 0 10 0 10 0 10\n1.5 2 3 0.5 0 0 0\n4.5 5 6 0.5 0 0 0\n",
        1,
        "number of the 2 rows",
    ),
    "a count and bounds over fewer": ("2 0 10 0 10 0 10\n" + FOUR, 2, "4 columns"),
}


@pytest.mark.parametrize("case", REFUSED, ids=[case.replace(" ", "-") for case in REFUSED])
def test_the_columns_are_not_certain(refused, case):
    text, line, found = REFUSED[case]
    message = refused(text, "p.csv" if "," in text.split("\n")[0] else "p.txt")
    assert message.startswith(f", line {line}: found ")
    assert found in message
    assert ", expected " in message
    if text.startswith("#") or found == "ids" or "prose" in case:
        assert (HINT in message) or 'columns="x y z r" (--columns)' in message


@pytest.mark.parametrize(
    "names",
    [
        "{}",
        "pos_{}",
        "pos{}",
        "position_{}",
        "{}_pos",
        "center_{}",
        "Centre {}",
        "c{}",
        "{}c",
        "coord_{}",
        "Points:{}",
        "Points_{}",
        "Coords:{}",
        "{}-Position",
    ],
)
@pytest.mark.parametrize(
    ("size", "factor"),
    [
        ("radius", 1),
        ("Radii", 1),
        ("Particle Radius", 1),
        ("Equivalent diameter (µm)", 0.5),
        ("sphere_diameter", 0.5),
        ("Diam", 0.5),
    ],
)
def test_names_of_places_and_sizes(read_text, names, size, factor):
    axes = "012" if names.endswith(":{}") or names == "Points_{}" else "XyZ"
    header = [size, "m", *(names.format(axis) for axis in axes)]
    packing = read_text(",".join(header) + "\n4,9,1,2,3\n8,9,5,6,7\n", "p.csv")
    assert spheres(packing) == [[1, 2, 3, 4 * factor], [5, 6, 7, 8 * factor]]
    assert packing.array_names == ["radius", "m"]


def test_plain_names_come_before_places(read_text):
    packing = read_text("pos_x,pos_y,pos_z,x,y,z,r\n9,8,7,1,2,3,4\n", "p.csv")
    assert spheres(packing) == [[1, 2, 3, 4]]
    assert packing["pos"].tolist() == [[9, 8, 7]]


@pytest.mark.parametrize(
    "names",
    [
        *("vx,vy,vz", "Vx,Vy,Vz", "vel_x,vel_y,vel_z", "v_0,v_1,v_2", "velo:0,velo:1,velo:2"),
        *("velocity[0],velocity[1],velocity[2]", "Velocity_x,Velocity_y,Velocity_z"),
    ],
)
def test_velocities(read_text, names):
    packing = read_text(f"x,y,z,r,{names}\n1,2,3,4,5,6,7\n", "p.csv")
    assert packing["velocity"].tolist() == [[5, 6, 7]]
    assert packing[names.split(",")[1]].tolist() == [6]


@pytest.mark.parametrize(
    ("header", "radius"),
    [
        ("x,y,z,r,radius", 5),
        ("x,y,z,radius,R", 4),
        ("x,y,z,d,diameter", 2.5),
        ("x,y,z,diameter,r", 5),
        ("x,y,z,diameter,R", 5),
    ],
)
def test_the_full_word_wins_and_a_radius_over_a_diameter(read_text, header, radius):
    packing = read_text(header + "\n1,2,3,4,5\n", "p.csv")
    assert packing["radius"].tolist() == [radius]
    assert packing.n_arrays == 2, "the other stays"


def test_colors_of_bytes(read_text):
    packing = read_text("X,Y,Z,R,G,B,RADIUS\n1,2,3,255,0,7,0.5\n1,2,3,0,1,2,0.25\n", "p.csv")
    assert packing["radius"].tolist() == [0.5, 0.25]
    assert packing["rgb"].dtype == np.uint8
    assert packing["rgb"].tolist() == [[255, 0, 7], [0, 1, 2]]
    assert packing["R"].tolist() == [255, 0]


def test_colors_of_fractions_with_opacity(read_text):
    packing = read_text("x y z r g b alpha radius\n1 2 3 0.5 0 1 0.25 4\n")
    assert packing["radius"].tolist() == [4]
    assert packing["rgb"].dtype == np.float32
    assert packing["rgb"].tolist() == [[0.5, 0, 1, 0.25]]


def test_bytes_and_an_opacity_up_to_1_are_not_mixed(read_text):
    packing = read_text("x y z red green blue alpha radius\n1 2 3 128 0 64 1 4\n")
    assert packing["rgb"].tolist() == [[128, 0, 64]]


@pytest.mark.parametrize("value", ["256", "-1", "1.5", "nan"])
def test_what_is_no_color(read_text, value):
    packing = read_text(f"x y z red green blue radius\n1 2 3 {value} 0 64 4\n")
    assert "rgb" not in packing.array_names
    assert packing["red"].tolist() == pytest.approx([float(value)], nan_ok=True)


def test_a_distance_beside_a_radius_stays(read_text):
    packing = read_text("x,y,z,r,theta,phi,radius\n1,0,0,1,1.5,0,0.25\n", "p.csv")
    assert packing["radius"].tolist() == [0.25]
    assert packing["r"].tolist() == [1]


def test_flags_after_the_sphere_in_xyzr(read_text):
    text = "12 4.875 10.75 1.4 1 OXT_GLY_9\n11.7 5.1 9.9 1.74 1 C_GLY_9\n"
    packing = read_text(text, "p.xyzr")
    assert spheres(packing) == [[12, 4.875, 10.75, 1.4], [11.7, 5.1, 9.9, 1.74]]
    assert packing["column_6"].tolist() == ["OXT_GLY_9", "C_GLY_9"]


def test_ids_before_the_sphere_in_xyzr(read_text):
    packing = read_text("1 2.5 3 4 0.5\n2 4.5 5 6 0.25\n", "p.xyzr")
    assert spheres(packing) == [[2.5, 3, 4, 0.5], [4.5, 5, 6, 0.25]]


def test_whole_numbers_at_both_ends_of_xyzr(refused):
    assert HINT in refused("1 2.5 3 4 5\n2 4.5 5 6 5\n", "p.xyzr")


@pytest.mark.parametrize(
    "rows",
    [
        "0 0 0 0.5 7.5\n0 1 0 0.5 8\n1 0 0 0.5 9\n",
        "-1 0 0 0.5 7.5\n0 0 0 0.5 8\n1 0 0 0.5 9\n",
        "1.0 0.5 0 0.5 7\n2.0 0.5 0 0.5 8\n",
        "1 0.5 0 0.5 7\n2e0 0.5 0 0.5 8\n",
        "0e0 0 0 0.5 7\n1e0 1 1 0.5 8\n2e0 2 2 0.5 8\n",
        "1e0 0.5 0 0.5 7\n3e0 1.5 0 0.5 8\n2e0 2.5 0 0.5 8\n",
        "".join(f"{i}.0 1.5 2.5 0.5 7\n" for i in range(1, 20)),
        "".join(f"{2 * i}.0 {i}.5 2.5 0.5 7\n" for i in range(1, 20)),
    ],
    ids=[
        "a lattice",
        "a sign",
        "points",
        "an exponent",
        "whole",
        "not in turn",
        "a row",
        "every second",
    ],
)
def test_what_is_no_id(read_text, rows):
    expected = [[float(field) for field in row.split()[:4]] for row in rows.splitlines()]
    assert spheres(read_text(rows)) == expected


def test_the_cell_of_a_packing_by_yade(read_text):
    packing = read_text("##PERIODIC:: 5 6 7.5\n1 2 3 0.5 -1\n4 5 6 0.25 6\n", "p.txt")
    assert spheres(packing) == [[1, 2, 3, 0.5], [4, 5, 6, 0.25]]
    assert packing.field_data["cell_vectors"].tolist() == [[5, 0, 0], [0, 6, 0], [0, 0, 7.5]]
    assert packing.field_data["cell_periodic"].tolist() == [1, 1, 1]


@pytest.mark.parametrize("edges", ["5 5", "5 0 5", "5 nan 5", "5 5 5 5", ""])
def test_a_bad_cell_by_yade(refused, edges):
    assert "three edges" in refused(f"##PERIODIC:: {edges}\n1 2 3 0.5\n")


@pytest.mark.parametrize("encoding", ["utf-16-le", "utf-16-be", "utf-32-le", "utf-32-be"])
@pytest.mark.parametrize("name", ["p.csv", "p.txt", "p.spheres"])
def test_wide_characters(read_text, encoding, name):
    text = "\ufeffx,y,z,r,größe 😀\r\n1,2,3,0.5,7\r\n"
    packing = read_text(text.encode(encoding), name)
    assert spheres(packing) == [[1, 2, 3, 0.5]]
    assert packing.array_names == ["radius", "größe 😀"]


@pytest.mark.parametrize("bad", [b"\x00\xd8x\x00", b"\x00\xdc\n\x00", b"\x00\xd8", b"x"])
def test_broken_wide_characters(refused, bad):
    message = refused("\ufeffx y z r\n1 2 3 4 ".encode("utf-16-le") + bad)
    assert "UTF-16" in message


class TestText:
    def test_in_single_precision_and_small_chunks(self, read_text):
        rows = "".join(f"{i}.5 0 0 1 name{i}\n" for i in range(500))
        packing = read_text(rows, chunk=7, single=True)
        assert packing["column_5"].tolist() == [f"name{i}" for i in range(500)]

    def test_quotes_and_empty_fields(self, read_text):
        packing = read_text('x,y,z,r,t\n1,2,3,4,\n1,2,3,4,"a, ""b"""\n1,2,3,4, c d \n', "p.csv")
        assert packing["t"].tolist() == ["", 'a, "b"', "c d"]

    def test_bytes_that_are_no_characters(self, read_text):
        packing = read_text(b"x,y,z,r,t\n1,2,3,4,a\xff\x01\n", "p.csv")
        assert packing["t"].tolist() == [r"a\xff\x01"]

    def test_an_error_after_a_column_has_turned(self, refused):
        message = refused("x,y,z,r,t\n1,2,3,4,5\n1,2,3,4,a\n1,2,3,b,a\n", "p.csv")
        assert message.startswith(", line 4: found 'b' as radius in column 4")


class TestColumns:
    def test_they_outrank_all_others(self, read_text):
        text = "#format x_y_z_r_id\n# x y z r id\n" + FIVE
        assert spheres(read_text(text, columns="id x y z r")) == [FIRST, LAST]

    @pytest.mark.parametrize("columns", ["id,x,y,z,d", "id, x, y, z, diameter", "- x y z d"])
    def test_their_separators_and_gaps(self, read_text, columns):
        packing = read_text(FIVE, columns=columns)
        assert packing["radius"].tolist() == [0.375, 0.25]
        assert ("id" in packing.array_names) == ("id" in columns)
        assert packing.n_arrays == 1 + ("id" in columns)

    @pytest.mark.parametrize("name", ["p.csv", "p.txt", "p.xyzr", "p.spheres"])
    @pytest.mark.parametrize("delimiter", [",", ";", "\t"])
    def test_of_a_table_with_delimiters(self, read_text, name, delimiter):
        text = delimiter.join(["Nr", "a", "b", "c", "s"]) + "\n" + FIVE.replace(" ", delimiter)
        assert spheres(read_text(text, name, columns="id x y z r")) == [FIRST, LAST]

    def test_prose_before_the_rows_is_skipped(self, read_text):
        text = "Spheres of a run\nwritten: today\n" + FIVE
        assert spheres(read_text(text, columns="id x y z r")) == [FIRST, LAST]

    def test_text_may_come_first(self, read_text):
        packing = read_text("A N 1 2 3 4\nB C 5 6 7 8\n", columns="chain atom x y z r")
        assert spheres(packing) == [[1, 2, 3, 4], [5, 6, 7, 8]]
        assert packing["chain"].tolist() == ["A", "B"]

    @pytest.mark.parametrize(
        ("text", "line", "found"),
        [
            ("2\n" + FIVE, 1, "1 column '2'"),
            (FOUR, 1, "4 columns"),
            ("A 1 x 3 4\n" + FIVE, 1, "'x' as y in column 3"),
            (FIVE + "3 a b c d\n", 3, "'a' as x in column 2"),
        ],
    )
    def test_rows_that_do_not_fit(self, refused, text, line, found):
        message = refused(text, columns="id x y z r")
        assert message.startswith(f", line {line}: found {found}")

    @pytest.mark.parametrize("columns", ["x y r", "x y z r radius radius", "r g b x y z"])
    def test_names_that_do_not_do(self, refused, columns):
        message = refused(FIVE, columns=columns)
        assert message.startswith(": columns: found ")
        assert ", expected " in message

    @pytest.mark.parametrize("columns", ["id x y z", "id x y z 2r"])
    def test_names_without_a_radius(self, refused, columns):
        message = refused(FIVE, columns=columns)
        assert message.startswith(f": columns: found no radius in '{columns}', expected one of r,")
        assert message.endswith("radius= (--radius) to give radii")


class TestRadiusOptional:
    @pytest.mark.parametrize(
        ("text", "name"),
        [
            ("x y z\n1 2 3\n4 5 6\n", "p.txt"),
            ("# x y z\n1 2 3\n4 5 6\n", "p.txt"),
            ("1 2 3\n4 5 6\n", "p.txt"),
            ("1 2 3\n4 5 6\n", "p.xyzr"),
            ("x,y,z,m\n1,2,3,9\n4,5,6,9\n", "p.csv"),
            ("X,Y,Z,R,G,B\n1,2,3,255,0,0\n4,5,6,255,0,0\n", "p.csv"),
            ("x,y,z,r,theta,phi\n1,2,3,9,9,9\n4,5,6,9,9,9\n", "p.csv"),
            ("#format x_y_z\n1 2 3\n4 5 6\n", "p.txt"),
        ],
    )
    @pytest.mark.parametrize("single", [False, True])
    def test_without_radii(self, read_text, text, name, single):
        packing = read_text(text, name, optional=True, single=single)
        assert packing.points.tolist() == [[1, 2, 3], [4, 5, 6]]
        assert "radius" not in packing.array_names

    def test_columns_without_a_radius(self, read_text):
        packing = read_text(FOUR, columns="x y z m", optional=True)
        assert packing["m"].tolist() == [0.75, 0.5]
        assert packing.array_names == ["m"]

    @pytest.mark.parametrize(
        "text", ["# x y z r\n" + FOUR, "x y z d\n1 2 3 4\n", "# r x y z\n1 2 3 4\n"]
    )
    def test_radii_that_are_there_are_read(self, read_text, text):
        optional = read_text(text, optional=True)
        assert spheres(optional) == spheres(read_text(text))

    def test_rows_must_fit_all_the_same(self, refused):
        assert ", line 2: found 2 columns" in refused("1 2 3\n4 5\n", optional=True)


@pytest.mark.parametrize(
    "make",
    [
        lambda n: "0.5 2 3 4" + " 5" * n,
        lambda n: "0.5 2 3 4" + " a" * n,
        lambda n: "0.5 2 3 4" + " 5" * n + "\n0.5 2 3 4" + " a" * n,
        lambda n: "# x y z r " + " ".join(f"a{i}" for i in range(n)) + "\n0.5 2 3 4" + " 5" * n,
        lambda n: (
            "x y z r "
            + " ".join(f"a{i}_{c}" for i in range(n // 3) for c in "xyz")
            + "\n0.5 2 3 4"
            + " 5" * (n // 3 * 3)
        ),
        lambda n: (
            "".join(f"# column {i}: a{i}\n" for i in range(1, n + 1))
            + "".join(f"# column {n + 1 + i}: {c}\n" for i, c in enumerate("xyzr"))
            + "5 " * n
            + "0.5 2 3 4"
        ),
    ],
    ids=["numbers", "text", "turning", "comment", "vectors", "comment-each"],
)
def test_time_is_linear_in_the_columns(read_text, make):
    def seconds(count):
        text = make(count) + "\n"
        start = time.perf_counter()
        packing = read_text(text)
        assert packing.n_arrays >= count
        assert packing.points.tolist()[0] == [0.5, 2, 3]
        return time.perf_counter() - start

    few = min(seconds(4000) for _ in range(3))
    many = min(seconds(32000) for _ in range(2))
    assert many < 24 * few, "8 times as many columns; quadratic time would be 64"


@pytest.mark.parametrize("begin", ["", "x,y,z,r" + ",n" * 32765 + "\n", "# x y z r\n"])
def test_more_columns_than_any_packing_has(refused, begin):
    separator = "," if "," in begin else " "
    message = refused(begin + separator.join(["0.5"] * 32769) + "\n")
    assert message == ": found 32769 columns, expected at most 32768"


# --- IMD ------------------------------------------------------------------------------------------

IMD = """#F A 1 0 0 3 0 1
#C number x y z Radius
#X 4.0 0.0 0.0
#Y 0.5 5.0 0.0
#Z 0.0 -1 6.0
## Generated on Sat Nov 28 06:57:26 2026
#E
1 2.5 3.5 4.5 0.25
"""


def test_the_box_of_imd(read_text):
    packing = read_text(IMD, "p.imd")
    assert spheres(packing) == [[2.5, 3.5, 4.5, 0.25]]
    data = packing.field_data
    assert data["cell_vectors"].tolist() == [[4, 0, 0], [0.5, 5, 0], [0, -1, 6]]
    assert data["cell_origin"].tolist() == [0, 0, 0]
    assert data["cell_periodic"].tolist() == [1, 1, 1]


@pytest.mark.parametrize(
    "text",
    [IMD.replace("#Y 0.5 5.0 0.0\n", ""), IMD.replace("#F A 1", "# 1"), IMD.replace("X", "Q")],
)
def test_no_box_without_all_of_it(read_text, text):
    assert read_text(text, "p.imd").field_data.keys() == []


@pytest.mark.parametrize("bad", ["4.0 0.0", "4.0 0.0 x", "4.0 0.0 0.0 1", "4.0 nan 0"])
def test_a_damaged_box_of_imd(read_error, tmp_path, bad):
    (tmp_path / "p.imd").write_text(IMD.replace("4.0 0.0 0.0", bad))
    message, _ = read_error(tmp_path / "p.imd")
    assert f"line 3: found '#X {bad}', expected the three numbers of a vector" in message
