"""What is written reads back exactly, or is refused: names, large integers, texts."""

import numpy as np
import pytest
import pyvista as pv
import spherepacking
from spherepacking import PackingFileError

IN_TEXT = pytest.mark.parametrize("extension", ["csv", "dump", "xyz"])


def packing(**arrays):
    mesh = pv.PolyData(np.arange(9.0).reshape(3, 3))
    mesh["radius"] = [3.0, 2.0, 1.0]
    for name, values in arrays.items():
        mesh[name] = values
    return mesh


def read_back(mesh, path):
    spherepacking.write(mesh, path)
    back = spherepacking.read(path)
    np.testing.assert_array_equal(back.points, mesh.points)
    return back


# --- integers -------------------------------------------------------------------------------------


@IN_TEXT
@pytest.mark.parametrize("kind", [np.int64, np.uint64])
def test_integers_that_double_precision_holds(tmp_path, extension, kind):
    for value in (0, 1, 2**53, 2**60, 3 * 2**61, 2**63 - 2**10, (2**53 - 1) * 2**9):
        ids = np.array([0, value, 1], kind)
        back = read_back(packing(ids=ids), tmp_path / f"a.{extension}")
        assert [int(v) for v in back["ids"]] == ids.tolist()
    if kind is np.int64:
        ids = np.array([-(2**63), -(2**53), -1])
        back = read_back(packing(ids=ids), tmp_path / f"a.{extension}")
        assert [int(v) for v in back["ids"]] == ids.tolist()


@IN_TEXT
@pytest.mark.parametrize(
    ("value", "kind"),
    [
        (2394307880636977758, np.int64),
        (2**53 + 1, np.int64),
        (-(2**53) - 1, np.int64),
        (2**63 - 1, np.int64),
        (2**53 + 1, np.uint64),
        (2**64 - 1, np.uint64),
    ],
)
def test_other_integers_are_refused(tmp_path, extension, value, kind):
    path = tmp_path / f"a.{extension}"
    path.write_text("earlier")
    found = rf"the point array 'ids' holds {value} at point 1, expected integers that double prec"
    with pytest.raises(PackingFileError, match=found):
        spherepacking.write(packing(ids=np.array([0, value, 1], kind)), path)
    vectors = np.array([[0, 0], [0, value], [0, 0]], kind)
    with pytest.raises(PackingFileError, match=f"'ids' holds {value} at point 1"):
        spherepacking.write(packing(ids=vectors), path)
    assert path.read_text() == "earlier"
    # What has no place for the array, and what holds it.
    spherepacking.write(packing(ids=np.array([0, value, 1], kind)), tmp_path / "a.spheres")
    back = read_back(packing(ids=np.array([0, value, 1], kind)), tmp_path / "a.vtp")
    assert back["ids"].tolist() == [0, value, 1]


@pytest.mark.parametrize("head", ["x,y,z,radius,id", "id x y z radius", None])
def test_integers_of_others_that_double_precision_does_not_hold(tmp_path, head):
    """Identifiers of 64 bits were rounded; they are kept as texts, whichever row they are in."""
    ids = ["7", "2394307880636977758", "-9007199254740993", "+0018446744073709551615", "1e300"]
    rows = [f"{i},2,3,4,{value}" for i, value in enumerate(ids)]
    path = tmp_path / "a.csv"
    if head is None:
        path = tmp_path / "a.dump"
        head = f"ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n{len(ids)}\nITEM: ATOMS x y z radius id"
        rows = [row.replace(",", " ") for row in rows]
    elif head.startswith("id"):
        path = tmp_path / "a.txt"
        rows = [f"{value} {i} 2 3 4" for i, value in enumerate(ids)]
    path.write_text("\n".join([head, *rows, ""]))
    assert spherepacking.read(path)["id"].tolist() == ids


def test_large_numbers_are_numbers(tmp_path, rng):
    """What double precision holds, and what is written with a point or an exponent."""
    values = [2**53, 2**60, -(2**62), 3 * 2**70, 10**22, 2**1023, "1e300", "123456789012345678.5"]
    values += ["2394307880636977758.", "2394307880636977758e0", "-0", "00000000000000000000000001"]
    values += [int(v) for v in np.ldexp(rng.integers(2**52, 2**53, 200), rng.integers(0, 900, 200))]
    path = tmp_path / "a.csv"
    path.write_text("x,y,z,radius,a\n" + "".join(f"1,2,3,4,{value}\n" for value in values))
    back = spherepacking.read(path)
    assert back["a"].dtype == float
    assert back["a"].tolist() == [float(value) for value in values]
    mesh = pv.PolyData(np.zeros((500, 3)))
    mesh["radius"] = np.ones(500)
    mesh["a"] = np.ldexp(rng.integers(2**52, 2**53, 500), rng.integers(0, 900, 500))
    np.testing.assert_array_equal(read_back(mesh, path)["a"], mesh["a"])


# --- names ----------------------------------------------------------------------------------------


@IN_TEXT
def test_an_array_without_a_name_is_refused(tmp_path, extension):
    """It was left out without a word, or as the last one made a file that the reader refused."""
    for arrays in ([""], ["a", ""], ["", "a"]):
        mesh = packing(**{name: [1.0, 2.0, 3.0] for name in arrays})
        with pytest.raises(PackingFileError, match="found a point array without a name, expected"):
            spherepacking.write(mesh, tmp_path / f"a.{extension}")
    spherepacking.write(mesh, tmp_path / "a.xyzr")


@IN_TEXT
@pytest.mark.parametrize("name", [" a", "a ", " ", "\x1b", "a\x7f", "a\x9bb", "\u202ea", "a\u200b"])
def test_names_that_would_be_read_as_others(tmp_path, extension, name):
    with pytest.raises(PackingFileError, match="the point array"):
        spherepacking.write(packing(**{name: [1.0, 2.0, 3.0]}), tmp_path / f"a.{extension}")


@pytest.mark.parametrize(
    ("name", "components"),
    [
        *(("Radius", 1), ("radii", 1), ("RADII", 1), ("position", 3), ("Positions", 3)),
        *(("'a'", 1), ("{a", 1), ("a}", 1)),
    ],
)
def test_names_of_extended_xyz(tmp_path, name, components):
    """The reader would take them for the radii or the centres, or for quotes."""
    values = np.ones((3, components)) if components > 1 else ["a", "b", "c"]
    for held in (values, np.ones(values.shape) if components > 1 else np.ones(3)):
        with pytest.raises(PackingFileError, match=f"name|{name}"):
            spherepacking.write(packing(**{name: held}), tmp_path / "a.xyz")


LETTERS = "abxyzrR_0123 .:;,#\"'\\/()[]{}<>=+-*%&$@!?^~|\t\n\x1b\x7f\x9b\u202eé球\u00a0\u2003"
WORDS = (
    *("Radius", "x", "id", "vx", "1", "1e5", "nan", "velocity", "a_0", "a_1", "a_2", "type", "#a"),
    *("[m]", "a [m]", "index", "mass", "x_0", "r", "d", "diameter", "pos", "cell", "time", "X"),
)


@IN_TEXT
def test_any_names(tmp_path, rng, extension):
    path = tmp_path / f"a.{extension}"
    kept = 0
    for _ in range(300):
        mesh = packing()
        for _ in range(rng.integers(1, 5)):
            word = "".join(rng.choice(list(LETTERS), rng.integers(1, 5)))
            name = str(rng.choice(WORDS)) if rng.random() < 0.5 else word
            values = (rng.random(3), rng.random((3, 3)), np.array(["p", "q", "r"]))
            mesh[name] = values[rng.integers(3)]
        try:
            spherepacking.write(mesh, path)
        except PackingFileError:
            continue
        back = spherepacking.read(path)
        np.testing.assert_array_equal(back.points, mesh.points)
        for name in mesh.point_data:
            np.testing.assert_array_equal(back[name], mesh[name])
        kept += 1
    assert kept > 50
