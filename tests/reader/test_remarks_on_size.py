"""What remarks say of the sizes and units of rows, in forms that are lists and in others."""

import time

import numpy as np
import pytest

FOUR = "1.5 2.5 3.5 0.5\n4 5 6.5 0.25\n"
FIVE = "1.5 2.5 3.5 0.5 7.25\n4 5 6.5 0.25 9\n"
BY_PLACE = [[1.5, 2.5, 3.5, 0.5], [4, 5, 6.5, 0.25]]
HALVED = [[1.5, 2.5, 3.5, 0.25], [4, 5, 6.5, 0.125]]
HINT = 'expected columns="x y z d" or columns="x y z r" (--columns)'


def spheres(packing):
    return np.column_stack([packing.points, packing["radius"]]).tolist()


@pytest.fixture
def refused(read_error, tmp_path):
    """Read a text that has to be refused: the message without the name of the file."""

    def read(text, name="p.txt", **options):
        path = tmp_path / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        message, _ = read_error(path, **options)
        return message.removeprefix(str(path))

    return read


LISTS = [
    *("[x, y, z, {}]", "(x,y,z,{})", "{{x,y,z,{}}}", "<x y z {}>", '"x y z {}"'),
    *("[x y z {}] in mm", "[x y z {}] (mm)", "fields: [x, y, z, {}]", "(x y z) ({})"),
    *("[x y z] [{}]", "x y z ({})", "names = ['x', 'y', 'z', '{}']", '("x", "y", "z", "{}")'),
    *("x/y/z/{}", "x|y|z|{}", "x | y | z | {}", "| x | y | z | {} |", "x : y : z : {}"),
    *("x-y-z-{}", "x+y+z+{}", "x_y_z_{}", "x.y.z.{}", "x / y / z / {}", "x & y & z & {}"),
    *("[x/y/z/{}]", "x\u00a0y\u00a0z\u00a0{}", "x,\u00a0y,\u00a0z,\u00a0{}"),
]


@pytest.mark.parametrize("form", LISTS)
def test_a_list_in_any_form_is_read(read_text, form):
    for letter in "dD":
        assert spheres(read_text(f"# {form.format(letter)}\n{FOUR}")) == HALVED
    assert spheres(read_text(f"# {form.format('r')}\n{FOUR}")) == BY_PLACE


@pytest.mark.parametrize(
    "names", ["xyzd", "XYZD", "X_Y_Z_D", "[x, y, z, diameter]", "(x, y, z, dp)"]
)
def test_further_lists_with_a_diameter(read_text, names):
    assert spheres(read_text(f"# {names}\n{FOUR}")) == HALVED


@pytest.mark.parametrize("names", ["rxyz", "[r, x, y, z]", "r/x/y/z", "(r) (x y z)", "[r x y z]"])
def test_lists_in_another_order(read_text, names):
    expected = [[2.5, 3.5, 0.5, 1.5], [5, 6.5, 0.25, 4]]
    assert spheres(read_text(f"# {names}\n{FOUR}")) == expected


@pytest.mark.parametrize(
    "names",
    ["[id, x, y, z, d]", "id xyzd", "(id) (x y z) (d)", "id | x | y | z | d", "id/x/y/z/d"],
)
def test_lists_over_five_columns(read_text, names):
    rows = "1 1.5 2.5 3.5 0.5\n7 4 5 6.5 0.25\n"
    packing = read_text(f"# {names}\n{rows}")
    assert spheres(packing) == HALVED
    assert packing["id"].tolist() == [1, 7]


@pytest.mark.parametrize(
    "names",
    [
        *("[x, y, z, mass]", "x/y/z/m", "(x,y,z,volume)", "[x, y, z, D50]", "[x y z] [m]"),
        *("[id, x, y, z]", "x | y | z | T", "row col slice r", "x,y,z in mm", "x y z in mm"),
    ],
)
def test_lists_of_other_names(refused, names):
    message = refused(f"# {names}\n{FOUR}")
    assert message.startswith(", line 1: found ")
    assert 'columns="x y z r" (--columns)' in message


@pytest.mark.parametrize(
    "names",
    [
        *("r/x/y/z", "z/y/x/r", "x/y/z/m", "r/x/y/z mass", "[x, y, z, mass] mass", "x/y/z"),
        *("u v w r", "i j k r", "lon lat h r", "row col slice r"),
    ],
)
def test_lists_of_other_names_over_more_columns(refused, names):
    for rows in (FIVE, FIVE.replace("\n", " 1.5\n")):
        if names != "r/x/y/z mass" or rows != FIVE:
            assert refused(f"# {names}\n{rows}").startswith(", line 1: found ")


DIAMETERS = [
    *("center[0] center[1] center[2] diameter", "r[3] d", "diameter=2r", "diameters", "DIAMETER"),
    *("4th column is the diameter", "diameters of spheres: d", "centre of sphere diameter"),
    *("diameter 2.0", "Dia. in mm", "mean dia", "Kugeldurchmesser", "diamètre des sphères"),
    *("diámetro", "DIÁMETRO", "diâmetro", "Диаметры", "ДИАМЕТР", "直径", "średnica", "průměr"),
    *("sizes: Ø", "⌀ in mm", "2*r", "size = 2 * r", "size is 2r", "twice the radius", "2·r"),
    *("d", "D [um]", "the fourth is d", "d = 4", "d: 3", "column 4 d", "P d"),
    *("x1 x2 x3 d", "(x_i, y_i, z_i, d_i)", "x·y·z·d", "x→y→z→d", "'p' 'd'", "r_x r_y r_z d"),
    *("columns: x=1,y=2,z=3,d=4", "{'x':0,'y':1,'z':2,'d':3}", "x:1 y:2 z:3 d:4", "xyz+d"),
    *("from packing.xyzd", "radius = diameter/2", "diameter distribution lognormal", "d/2"),
]


@pytest.mark.parametrize("remark", DIAMETERS)
def test_a_remark_that_may_speak_of_diameters(refused, read_text, remark):
    text = f"# by hand\n# {remark}\n# of today\n{FOUR}"
    message = refused(text)
    assert message.startswith(", line 2: found '# ")
    assert "which may speak of diameters" in message
    assert HINT in message
    assert spheres(read_text(text, columns="x y z d")) == HALVED
    assert spheres(read_text(text, columns="x y z r")) == BY_PLACE
    assert spheres(read_text(f"# x y z r\n{text}")) == BY_PLACE, "names are certain"


def test_a_remark_over_more_columns(refused, read_text):
    text = "# diameter is column 4\n" + FIVE
    assert 'columns="x y z d -" or columns="x y z r -"' in refused(text)
    assert spheres(read_text(text, columns="x y z d -")) == HALVED


@pytest.mark.parametrize(
    "remark", ["Durchmesser f\xfcr alle", "di\xe1metro", "di\xc1metro", "diam\xe8tre"]
)
def test_a_remark_in_latin_1(refused, remark):
    assert "may speak of diameters" in refused(f"# {remark}\n{FOUR}".encode("latin-1"))


@pytest.mark.parametrize("chunk", [1, 9, 1 << 20])
def test_a_remark_behind_rows(refused, chunk):
    for text in (FOUR + "# diameters\n" + FOUR, FOUR + "# mean diameter 0.5"):
        message = refused(text, chunk=chunk)
        assert message.startswith(", line 3: found '# ")
        assert HINT in message
    message = refused("1.5 2.5 3.5 0.5 # centre, diameter\n4 5 6.5 0.25\n", chunk=chunk)
    assert message.startswith(", line 1: found ")


@pytest.mark.parametrize(
    "remark",
    [
        *("3-d packing", "2 D packing", "3D", "d'Alembert", "d’Alembert", "d = 0.5", "d=0.5 mm"),
        *(
            "J. D. Smith",
            "D. Smith 1999",
            "Ph.D. of J.D.",
            "Appendix D",
            "a diamond lattice",
            "diamonds",
            "D = 1",
        ),
        *("made on D:\\data\\x.txt", "/mnt/d/run", "d 0.25", "format %d %g", "id: d41d8cd9"),
        *("dense random packing", "3d scan", "d3 = 5", "x-ray scan", "xyzr format", "Radius"),
    ],
)
def test_a_remark_that_speaks_of_something_else(read_text, remark):
    assert spheres(read_text(f"# {remark}\n{FOUR}")) == BY_PLACE


@pytest.mark.parametrize(
    "names", ["x y z r (diameter)", "x y z r(diameter)", "x y z radius (= d)", "x y z r = d/2"]
)
def test_a_radius_that_is_called_a_diameter(refused, names):
    assert refused(f"# {names}\n{FOUR}").startswith(", line 1: found ")


def test_a_radius_that_is_called_a_diameter_in_a_header(refused):
    text = "x,y,z,r (diameter)\n1.5,2.5,3.5,0.5\n"
    assert "a radius and a diameter in 'r (diameter)'" in refused(text, "p.csv")


def test_radii_that_the_user_gives_outrank_remarks(read_text):
    packing = read_text("# diameters\n" + FOUR, optional=True)
    assert packing.points.tolist() == [row[:3] for row in BY_PLACE]


TWO_UNITS = [
    *("x/m y/m z/m r/mm", "x_m y_m z_m r_mm", "x:m y:m z:m r:mm", "x.m y.m z.m r.mm"),
    *("x-m y-m z-m r-mm", "x_m y_mm z_m r", "x{m} y{m} z{m} r{mm}", "x<m> y<m> z<m> r<mm>"),
    *("positions (m) radius (mm)", "position [m] diameter [mm]", "coordinates/m radius/mm"),
    *("positions in m, radii in mm", "center: m; radius: mm", "(x, y, z) [m], r [mm]"),
    *("x y z [m] r [mm]", "[x y z] (m) [r] (mm)", "x (voxel) y (voxel) z (voxel) r (um)"),
    *("x [px] y [px] z [slice] r [px]", "x(m) y(m) z(m) r(in mm)", "x y z in m, r in mm"),
    *("coordinates in\u00a0m, radii in\u00a0mm", "x / m, y / m, z / m, r / mm"),
    *("x: [m]\n# y: [m]\n# z: [m]\n# r: [mm]", "lengths: m\n# r: mm", "box in m\n# all in mm"),
    *("positions in m\n# radii in mm", "unit of x, y, z: m\n# unit of r: mm"),
]


@pytest.mark.parametrize("remark", TWO_UNITS)
def test_units_that_differ(refused, read_text, remark):
    text = f"# {remark}\n{FOUR}"
    message = refused(text)
    assert ": found " in message
    assert message.startswith((", line 1:", f", line {text.count('#')}:"))
    assert "(--columns)" in message
    assert spheres(read_text(text, columns="x y z r")) == BY_PLACE


@pytest.mark.parametrize(
    "remark",
    [
        *("x/mm y/mm z/mm r/mm", "x_mm y_mm z_mm r_mm", "x:mm y:mm z:mm r:mm", "x y z r in mm"),
        *("positions (mm) radius (mm)", "(x, y, z) [mm], r [mm]", "positions and radii in mm"),
        *("box 10 cm, radius 0.5 mm", "3 voxels, coordinates in um", "x y z r (1 px = 3 um)"),
        *("positions in mm, density 2500 kg/m^3", "positions in mm, velocities in m/s"),
        *("radius in mm, volume in cm^3, area in cm²", "positions\u00a0in\u00a0mm, r in mm"),
        *("x (px) y (px) z (px) r (px)", "x.m y.m z.m r.m", "lengths in mm", "all in m"),
    ],
)
def test_units_that_agree(read_text, remark):
    assert spheres(read_text(f"# {remark}\n{FOUR}")) == BY_PLACE


@pytest.mark.parametrize(
    ("header", "names"),
    [
        ("x (px),y (px),z (slice),r (px)", "'x (px)' and 'z (slice)'"),
        ("x,y (px),z (slice),r", "'y (px)' and 'z (slice)'"),
        ("x (east),y (north),z (up),r (m)", "'x (east)' and 'r (m)'"),
        ("x/m,y/m,z/m,r/mm", "'x/m' and 'r/mm'"),
        ("x_px,y_px,z_px,r_um", "'x_px' and 'r_um'"),
        ("x (m),y (m),z (m),r (in mm)", "'x (m)' and 'r (in mm)'"),
        ("x_m,y_mm,z_m,r", "'x_m' and 'y_mm'"),
    ],
)
def test_units_that_differ_in_a_header(refused, header, names):
    message = refused(header + "\n1.5,2.5,3.5,0.5\n", "p.csv")
    assert message.startswith(f", line 1: found the units of {names}, expected one unit")


@pytest.mark.parametrize(
    "header",
    [
        *("x/mm,y/mm,z/mm,r/mm", "x:mm,y:mm,z:mm,r:mm", "x (in mm),y [mm],z (mm),r"),
        *("x (east),y (north),z (up),r", "x (1),y (2),z (3),r (4)", "x [L],y [L],z [L],r [L]"),
        *("x\u00a0,y\u00a0,z\u00a0,r\u00a0", "x\u00a0(mm),y\u00a0(mm),z\u00a0(mm),r\u00a0(mm)"),
    ],
)
def test_units_that_agree_in_a_header(read_text, header):
    assert spheres(read_text(header + "\n" + FOUR.replace(" ", ","), "p.csv")) == BY_PLACE


def test_blanks_that_do_not_break_between_numbers(refused):
    """They look like others, so that the message shows their bytes."""
    message = refused(FOUR.replace(" ", "\u00a0"))
    assert r"found 1 column '1.5\xc2\xa02.5\xc2\xa03.5\xc2\xa00.5', expected at least 4" in message


@pytest.mark.parametrize(
    "make",
    [
        lambda n: "#" + " d" * n,
        lambda n: "#" + " x" * n,
        lambda n: "# " + "(" * n,
        lambda n: "# " + "(x)" * n,
        lambda n: "# " + "(" * n + ")",
        lambda n: "# " + "di\xe1" * n,
        lambda n: "# " + "d 1 " * n,
        lambda n: "# x y z (" * n,
        lambda n: "# " + "x|" * n,
        lambda n: "# " + "m/" * n,
    ],
)
def test_time_is_linear_in_a_remark(reader_for, tmp_path, make):
    def seconds(count):
        path = tmp_path / "p.txt"
        path.write_text(make(count) + "\n" + FOUR)
        reader = reader_for(path)
        reader.AddObserver("ErrorEvent", lambda *_: None)
        start = time.perf_counter()
        reader.Update()
        return time.perf_counter() - start

    few = min(seconds(20000) for _ in range(3))
    many = min(seconds(160000) for _ in range(2))
    assert many < 24 * few + 0.01, "8 times as long; quadratic time would be 64"
