"""Every text format against values written down by hand or parsed by Python."""

import numpy as np
import pytest

ROWS = np.array([[1.5, -2.25, 3.0, 0.75], [0.1, 0.2, 0.3, 0.4], [1e3, -1e-3, 12345.678, 0.0]])


def check(packing, rows=ROWS):
    assert packing.points.tolist() == rows[:, :3].tolist()
    assert packing["radius"].tolist() == rows[:, 3].tolist()
    assert packing.active_scalars_name == "radius"


def table(separator, end="\n"):
    lines = [separator.join(repr(v) for v in row) for row in ROWS.tolist()]
    return end.join(lines) + end


@pytest.mark.parametrize("separator", [" ", "\t", ",", ";", ", ", " ; ", " \t  "])
@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"], ids=["lf", "crlf", "cr"])
def test_separators_and_line_ends(read_text, separator, end):
    check(read_text(table(separator, end)))


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"], ids=["lf", "crlf", "cr"])
def test_comments_blank_lines_and_byte_order_mark(read_text, end):
    lines = table(" ").split("\n")[:3]
    text = ["# made by hand", "", lines[0] + " # the largest", "  ", "#", "\t" + lines[1]]
    text += ["   # 9 9 9 9", lines[2] + "#end", "", ""]
    check(read_text(b"\xef\xbb\xbf" + end.join(text).encode()))


def test_further_columns_of_numbers_and_text_ride_along(read_text):
    packing = read_text("0. 0 0 1 7 red 1e300\n1 0 0 2 -8 blue -inf\n2 0 0 3 9 Größe nan\n")
    assert packing.array_names == ["radius", "column_5", "column_6", "column_7"]
    assert packing["column_6"].tolist() == ["red", "blue", "Größe"]
    assert packing["column_5"].tolist() == [7, -8, 9]
    assert packing["column_7"].tolist()[:2] == [1e300, -np.inf]
    assert np.isnan(packing["column_7"][2])


@pytest.mark.parametrize("chunk", [1, 64, 1 << 18])
def test_a_column_that_turns_out_to_be_text_is_text_from_the_first_row_on(read_text, chunk):
    rows = [f"{i}.5 0 0 1 {i}.0 {i * 2}" for i in range(1000)]
    rows[998] = "998.5 0 0 1 12B 7"
    packing = read_text("\n".join(rows), chunk=chunk)
    assert packing.points[:, 0].tolist() == [i + 0.5 for i in range(1000)]
    assert packing.array_names == ["radius", "column_5", "column_6"]
    texts = [f"{i}.0" for i in range(998)] + ["12B", "999.0"]
    assert packing["column_5"].tolist() == texts
    assert packing["column_6"].tolist() == [i * 2 for i in range(998)] + [7, 1998]


@pytest.mark.parametrize(
    "header", ["x y z r", "# X Y Z Radius", "#x,y,z,r", "# d of it\n# x y z r"]
)
def test_a_header_names_the_columns_of_plain_text(read_text, header):
    check(read_text(header + "\n" + table(" ")))


@pytest.mark.parametrize("header", ["z m y d x", "# Z mass y DIAMETER X"])
def test_a_header_gives_the_order_and_diameters_are_halved(read_text, header):
    packing = read_text(header + "\n3 7 2 10 1\n6 8 5 1 4\n")
    assert packing.points.tolist() == [[1, 2, 3], [4, 5, 6]]
    assert packing["radius"].tolist() == [5, 0.5]
    assert packing[header.split()[-4]].tolist() == [7, 8]


@pytest.mark.parametrize(
    "comment",
    [
        "# x y z diameter (mm)",
        "# x y z diameter(mm)",
        "# X,Y,Z,D [m]",
        "# columns: x y z diameter",
        "#X Y Z Diam",
        "# x y z diameter\n# lengths in mm\n#",
        "# x y z r m\n# x: y: z: d:",
    ],
)
@pytest.mark.parametrize("name", ["p.spheres", "p.xyzr", "p.txt"])
def test_a_comment_names_a_diameter(read_text, comment, name):
    assert read_text(f"{comment}\n1 2 3 4\n", name)["radius"].tolist() == [2]


def test_a_comment_of_another_length_names_the_first_four(read_text):
    packing = read_text("# x y z r and so on\n1 2 3 4 5\n")
    assert packing.points.tolist() == [[1, 2, 3]]
    assert packing["radius"].tolist() == [4]


def test_the_last_comment_that_names_columns_counts(read_text):
    packing = read_text("# x y z d id\n# id x y z radius\n# 1 2 3 4\n9 1 2 3 4\n")
    assert packing.points.tolist() == [[1, 2, 3]]
    assert packing["radius"].tolist() == [4]


def test_a_header_with_units(read_text):
    packing = read_text("x [mm],y [mm],z (mm),diameter [mm]\n1,2,3,4\n", "p.csv")
    assert packing["radius"].tolist() == [2]


def test_xyzr_takes_the_last_four_columns_of_numbers(read_text):
    text = "A 3 N 6.444 3.101 48.834 1.7\nB 4 CA 7 8 9 2\n"
    packing = read_text(text, "balls.xyzr")
    assert packing.points.tolist() == [[6.444, 3.101, 48.834], [7, 8, 9]]
    assert packing["radius"].tolist() == [1.7, 2]
    assert packing.array_names == ["radius", "column_1", "column_2", "column_3"]
    assert packing["column_1"].tolist() == ["A", "B"]
    assert packing["column_2"].tolist() == [3, 4]
    assert packing["column_3"].tolist() == ["N", "CA"]


def test_xyzr_with_text_at_the_end(read_text):
    packing = read_text("5 1 2 3 4.0 CA\n6 5 6 7 8 N\n", "balls.xyzr")
    assert packing.points.tolist() == [[1, 2, 3], [5, 6, 7]]
    assert packing["radius"].tolist() == [4, 8]
    assert packing["column_1"].tolist() == [5, 6]


def test_yade_columns(read_text):
    packing = read_text("#format id_x_y_z_r_matId\n# two\n10 1 2 3 4 0\n11 5 6 7 8 1\n", "p.txt")
    assert packing.points.tolist() == [[1, 2, 3], [5, 6, 7]]
    assert packing["radius"].tolist() == [4, 8]
    assert packing["id"].tolist() == [10, 11]
    assert packing["matId"].tolist() == [0, 1]


def test_yade_attributes_take_the_names_of_the_last_comment(read_text):
    text = "#format x_y_z_r_attrs\n# x y z r speed mass\n1\t2\t3\t4\t5\t6\n"
    packing = read_text(text, "p.txt")
    assert (packing["speed"][0], packing["mass"][0]) == (5, 6)


def test_yade_attributes_without_names(read_text):
    packing = read_text("#format x_y_z_r_attrs\n1\t2\t3\t4\t5\t6\n", "p.txt")
    assert packing.array_names == ["radius", "attrs_1", "attrs_2"]
    assert packing["attrs_2"].tolist() == [6]
    assert read_text("#format x_y_z_r_attrs\n1\t2\t3\t4\n", "p.txt").array_names == ["radius"]


@pytest.mark.parametrize("delimiter", [",", ";", "\t", ", "])
@pytest.mark.parametrize(
    ("size", "factor"), [("r", 1), ("Radius", 1), ("D", 0.5), ("diameter", 0.5)]
)
def test_csv_header(read_text, delimiter, size, factor):
    header = delimiter.join(["Y", size, "temperature", "x", "z"])
    rows = [[2, 4, 300, 1, 3], [6, 8, 301.5, 5, 7]]
    text = "\n".join([header] + [delimiter.join(map(str, row)) for row in rows])
    packing = read_text(text, "p.csv")
    assert packing.points.tolist() == [[1, 2, 3], [5, 6, 7]]
    assert packing["radius"].tolist() == [4 * factor, 8 * factor]
    assert packing.array_names == ["radius", "temperature"]
    assert packing["temperature"].tolist() == [300, 301.5]


def test_csv_with_a_radius_and_a_diameter(read_text):
    packing = read_text("x,y,z,d,r\n1,2,3,10,4\n", "p.csv")
    assert packing["radius"].tolist() == [4]
    assert packing["d"].tolist() == [10]


def test_csv_quotes_empty_values_and_an_index(read_text):
    text = ',x,y,"z",r,"a, b",note,m\n0,"1",2,3,4,,"one, two",\n1,5,6,7,8,-1,"x",2 \n'
    packing = read_text(text, "p.csv")
    assert packing.points.tolist() == [[1, 2, 3], [5, 6, 7]]
    assert packing["radius"].tolist() == [4, 8]
    assert packing.array_names == ["radius", "column_1", "a, b", "note", "m"]
    assert packing["note"].tolist() == ["one, two", "x"]
    np.testing.assert_array_equal(packing["a, b"], [np.nan, -1])
    np.testing.assert_array_equal(packing["m"], [np.nan, 2])


def test_csv_by_numpy(read, tmp_path):
    path = tmp_path / "p.csv"
    np.savetxt(path, ROWS, delimiter=",", header="x,y,z,r")
    check(read(path), np.loadtxt(path, delimiter=","))


def test_csv_by_another_name(read_text):
    packing = read_text("x,y,z,r,m\n1,2,3,4,\n5,6,7,8,9\n", "p.txt")
    assert packing["radius"].tolist() == [4, 8]
    np.testing.assert_array_equal(packing["m"], [np.nan, 9])


def test_pqr(read_text):
    text = (
        "REMARK   1 x y z\n"
        "ATOM      1  N   GLY     1      -1.477  -0.797  33.156 -0.3300 2.0000\n"
        "HETATM    2  CA  GLY A   1      -2.382  -0.163  32.198  0.3300 0.0000  \n"
        "TER\nEND\n"
    )
    packing = read_text(text, "p.pqr")
    assert packing.points.tolist() == [[-1.477, -0.797, 33.156], [-2.382, -0.163, 32.198]]
    assert packing["radius"].tolist() == [2, 0]
    assert packing["charge"].tolist() == [-0.33, 0.33]


def test_the_content_tells_where_the_extension_does_not(read_text):
    pqr = "REMARK 1\nATOM 1 N GLY 1 1 2 3 0.5 4\n"
    assert read_text(pqr, "p.txt")["charge"].tolist() == [0.5]
    assert read_text("1 2 3 4\n", "p").n_points == 1
    assert read_text("1 2 3 4\n", "p.SPHERES").n_points == 1
    assert read_text("7 1 2 3 4.\n", "p.dat", fmt="XYZR")["radius"].tolist() == [4]


@pytest.mark.parametrize(
    ("header", "name"),
    [
        ("größe".encode(), "größe"),
        ("größe".encode("latin-1"), r"gr\xf6\xdfe"),
        (b"a\0b", r"a\x00b"),
    ],
)
def test_names_of_arrays_are_unicode(read_text, header, name):
    packing = read_text(b"x,y,z,r," + header + b"\n1,2,3,4,5\n", "p.csv")
    assert packing.array_names == ["radius", name]


def test_one_sphere(read_text):
    assert read_text("1 2 3 4").points.tolist() == [[1, 2, 3]]


def test_pyvista_sees_a_vertex_for_each_sphere(read_text):
    packing = read_text(table(" "))
    assert packing.n_cells == packing.n_verts == 3
    assert packing.verts.tolist() == [1, 0, 1, 1, 1, 2]
    assert packing.threshold(0.5, scalars="radius").n_points == 1


def test_single_precision(read_text):
    packing = read_text("x y z d id\n0.1 0.2 0.3 0.8 16777217\n", single=True)
    assert packing.points.dtype == packing["radius"].dtype == np.float32
    assert packing["radius"][0] == np.float32(0.4)
    assert packing["id"].tolist() == [16777217], "ids beyond 2^24 survive"
