"""What stands in brackets behind the names of columns."""

import pytest

ROWS = "1.5 2.5 3.5 0.5\n4 5 6.5 0.25\n"
BY_PLACE = [[1.5, 2.5, 3.5, 0.5], [4, 5, 6.5, 0.25]]
HALVED = [[1.5, 2.5, 3.5, 0.25], [4, 5, 6.5, 0.125]]


def spheres(packing):
    return [
        [*center, radius]
        for center, radius in zip(packing.points.tolist(), packing["radius"].tolist(), strict=True)
    ]


@pytest.fixture
def refused(read_error, tmp_path):
    """Read a text that has to be refused: the message without the name of the file."""

    def read(text, name="p.csv", **options):
        path = tmp_path / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        message, _ = read_error(path, **options)
        return message.removeprefix(str(path))

    return read


def as_csv(names):
    return ",".join(names) + "\n" + ROWS.replace(" ", ",")


# Names by commas, by blanks, and in a comment.
FORMS = {
    "csv": (as_csv, "p.csv"),
    "header": (lambda names: " ".join(names) + "\n" + ROWS, "p.txt"),
    "comment": (lambda names: "# " + " ".join(names) + "\n" + ROWS, "p.txt"),
    "commas": (lambda names: "# " + ", ".join(names) + "\n" + ROWS, "p.txt"),
}


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize(
    "size",
    [
        *("r (log10)", "r (squared)", "R (x1000)", "r (normalized)", "r (%)", "r [10^-3 m]"),
        *("radius (log)", "r (LN)", "r(log10)", "r [log10]", "r (Squared)", "radius (sqrt)"),
        *("r (r^2)", "r (r²)", "r (*1e3)", "r (×1000)", "r (x 10)", "r (Normalised)", "r (scaled)"),
        *("d (radius)", "r (diameter)", "r (weight)", "diameter (log10)", "d (foo)", "r (volume)"),
        *("r (1/mm)", "r (per mm)", "r (log10 mm)"),
    ],
)
def test_a_size_in_no_unit(refused, read_text, form, size):
    make, file = FORMS[form]
    text = make(["x", "y", "z", size])
    message = refused(text, file)
    assert message.startswith(", line 1: found ")
    assert "columns=" in message
    assert "(--columns)" in message
    assert spheres(read_text(text, file, columns="x y z r")) == BY_PLACE


@pytest.mark.parametrize("form", ["csv", "header", "comment", "commas"])
@pytest.mark.parametrize(
    "text", ["log10", "squared", "%", "normalized", "ln", "fractional", "log(mm)"]
)
@pytest.mark.parametrize("size", ["r", "r ({})"])
def test_coordinates_that_are_no_lengths(refused, form, text, size):
    make, file = FORMS[form]
    names = [f"{axis} ({text})" for axis in "xyz"]
    assert ", line 1: found " in refused(make([*names, size.format(text)]), file)


@pytest.mark.parametrize("form", ["csv", "header", "comment", "commas"])
def test_coordinates_of_another_scale(refused, form):
    make, file = FORMS[form]
    names = [f"{axis} (x1000)" for axis in "xyz"]
    assert ", line 1: found " in refused(make([*names, "r"]), file)


@pytest.mark.parametrize("form", ["csv", "header", "comment", "commas"])
@pytest.mark.parametrize(
    "unit", ["10^-3 m", "x1000", "L", "foo", "a.u.", "σ", "mm", "A", "in", "µm", "lattice units"]
)
def test_one_unit_for_all(read_text, form, unit):
    make, file = FORMS[form]
    names = [f"{axis} [{unit}]" for axis in "xyz"]
    assert spheres(read_text(make([*names, f"r [{unit}]"]), file)) == BY_PLACE
    assert spheres(read_text(make([*names, f"d [{unit}]"]), file)) == HALVED


@pytest.mark.parametrize("form", ["csv", "header", "comment", "commas"])
@pytest.mark.parametrize(
    "bracket", ["mm", "in mm", "-", "LJ", "equivalent", "sphere", "vdW", "A", "σ", "a.u."]
)
def test_a_size_that_is_one(read_text, form, bracket):
    make, file = FORMS[form]
    assert spheres(read_text(make(["x", "y", "z", f"r ({bracket})"]), file)) == BY_PLACE
    assert spheres(read_text(make(["x", "y", "z", f"d ({bracket})"]), file)) == HALVED


@pytest.mark.parametrize(
    ("names", "expected"),
    [("radius (r)", BY_PLACE), ("diameter (d)", HALVED), ("r (radius)", BY_PLACE)],
)
def test_a_name_and_its_letter(read_text, names, expected):
    assert spheres(read_text(as_csv(["x", "y", "z", names]), "p.csv")) == expected


@pytest.mark.parametrize(
    "names", ["x y z r (one sphere a line)", "x y z r (all in SI units)", "x y z r (1 px = 3 um)"]
)
def test_brackets_of_a_whole_comment(read_text, names):
    assert spheres(read_text(f"# {names}\n{ROWS}", "p.txt")) == BY_PLACE


def test_two_units_of_few_letters(refused):
    for units in (("nm", "A"), ("mm", "in"), ("kpc", "pc")):
        text = as_csv([*(f"{axis} [{units[0]}]" for axis in "xyz"), f"r [{units[1]}]"])
        assert "expected one unit for coordinates and radii" in refused(text)


def test_brackets_behind_other_columns(read_text):
    text = "x,y,z,r,mass (log10),slope (%)\n1.5,2.5,3.5,0.5,3,4\n"
    assert spheres(read_text(text, "p.csv")) == BY_PLACE[:1]


@pytest.mark.parametrize("name", ["promień", "raio", "straal", "yarıçap", "반지름"])
def test_radii_in_other_languages(read_text, name):
    assert spheres(read_text(as_csv(["x", "y", "z", name]), "p.csv")) == BY_PLACE


@pytest.mark.parametrize("name", ["średnica", "çap", "지름", "diamètre", "diámetro"])
def test_diameters_in_other_languages(read_text, name):
    assert spheres(read_text(as_csv(["x", "y", "z", name]), "p.csv")) == HALVED


@pytest.mark.parametrize("name", ["diamètre", "diámetro"])
def test_diameters_in_latin_1(read_text, name):
    text = as_csv(["x", "y", "z", name]).encode("latin-1")
    assert spheres(read_text(text, "p.csv")) == HALVED
