"""Rows whose columns nobody names: which are certain by their numbers, and which are not."""

import numpy as np
import pytest
import pyvista as pv

HINT = 'columns="id x y z r" (--columns)'


def spheres(packing):
    return np.column_stack([packing.points, packing["radius"]]).tolist()


def savetxt(path, rows, **options):
    np.savetxt(path, np.array(rows, float), **options)
    return path


def by_savetxt(tmp_path, rows, **options):
    return savetxt(tmp_path / "p.txt", rows, **options).read_text()


@pytest.fixture
def refused(read_error, tmp_path):
    """Read a text that has to be refused: the message without the name of the file."""

    def read(text, name="p.txt", **options):
        path = tmp_path / name
        path.write_text(text)
        message, _ = read_error(path, **options)
        return message.removeprefix(str(path))

    return read


def rows_of(first, rng):
    """Rows that begin with these numbers: then x, y, z and radius, none of them whole."""
    first = np.array(first, float)
    others = rng.uniform(0.1, 0.9, (len(first), 4)) + np.array([5, -3, 2, 0])
    return np.column_stack([first, others])


FIRST = {
    "ids": range(1, 20),
    "ids from 0": range(20),
    "ids with gaps": [1, 2, 4, 7],
    "ids from 101": range(101, 151),
    "ids of two rows": [1, 2],
    "one id": [5],
    "types": [1, 2, 3, 1, 1, 2, 3, 3],
    "one type": [1] * 9,
    "ids in any order": [900, 3, 17, 555, 4],
    "ids beyond single precision": [20_000_001, 20_000_003],
}
FORMATS = ["%.18e", "%.6f", "%.2f", "%#g"]


@pytest.mark.parametrize("single", [False, True])
@pytest.mark.parametrize("fmt", FORMATS)
@pytest.mark.parametrize("case", FIRST)
def test_ids_or_kinds_with_a_point(refused, read_text, tmp_path, rng, case, fmt, single):
    rows = rows_of(FIRST[case], rng)
    text = by_savetxt(tmp_path, rows, fmt=fmt)
    message = refused(text, single=single)
    assert message.startswith(", line 1: found ")
    assert "in the first column of 5, which may be ids rather than x" in message
    assert HINT in message
    written = np.loadtxt(tmp_path / "p.txt", ndmin=2)
    assert spheres(read_text(text, columns="id x y z r")) == written[:, 1:].tolist()


@pytest.mark.parametrize("fmt", ["%.18e", "%d %.4f %.4f %.4f %.4f %.4f"])
def test_ids_before_more_columns(refused, tmp_path, rng, fmt):
    rows = np.column_stack([rows_of([3, 8, 9], rng), [0.5, 0.25, 0.75]])
    assert "which may be ids" in refused(by_savetxt(tmp_path, rows, fmt=fmt))


@pytest.mark.parametrize(
    "text",
    [
        "1 10 20 30 2.5\n2 11 20 30 2.5\n1 12 20 30 2.5\n",
        "10 20 30 2 7.5\n11 20 30 3 8.5\n10 20 30 2 1.5\n",
        "10 20 30 2 1\n10 20 31 2 1\n",
        "1.0 10.0 20.0 30.0 2.5\n2.0 11.0 20.0 30.0 2.5\n1.0 12.0 20.0 30.0 2.5\n",
        "1.0 0.0 0.0 0.5 0.5\n2.0 1.0 0.0 0.5 0.5\n3.0 2.0 0.0 0.5 0.5\n",
        "1.0 0.0 0.0 0.5 0.5\n2.0 0.0 0.0 1.5 0.5\n",
        "1.0 2.5 0.0 1.5 0.5 sand\n2.0 1.5 0.0 1.5 0.5 clay\n",
    ],
    ids=["types", "wholes", "all whole", "points", "on a plane", "a pile", "text behind"],
)
def test_whole_coordinates_that_may_be_ids(refused, text):
    assert "which may be ids" in refused(text)


@pytest.mark.parametrize(
    "text",
    [
        "10 20 30 2.5 7.5\n11 20 30 3 8.5\n10 20 30 2 1.5\n",
        "0.0 0.0 0.0 0.5 7.5\n0.0 1.0 0.0 0.5 7.5\n1.0 0.0 0.0 0.5 7.5\n",
        "1.0 2.5 3.5 0.5 7\n2.0 1.5 3.5 0.5 8\n",
        "-1.0 2.5 3.5 0.5 7.5\n2.0 1.5 3.5 0.5 8.5\n",
        "1.0 0.0 0.0 0.5 7.25\n2.0 0.0 0.0 0.5 7.5\n",
        "1.0 2.5 3.5 0.5 7.5\n2.25 1.5 3.5 0.5 8.5\n",
        "10 20 30 2\n11 20 30 3\n",
        "10 20 30 2\n",
        "1.0 2.5 3.5 0.5\n2.0 1.5 3.5 0.5\n",
    ],
    ids=[
        "voxels",
        "a grid",
        "a whole label",
        "a sign",
        "a row",
        "one x",
        "four of voxels",
        "one of voxels",
        "four",
    ],
)
def test_coordinates_that_are_certain(read_text, text):
    expected = [[float(field) for field in row.split()[:4]] for row in text.splitlines()]
    assert spheres(read_text(text)) == expected


def test_generated_rows_are_those_written_or_refused(reader_for, tmp_path, rng):
    """Tables of ids, kinds and coordinates without names, by usual formats."""
    read = 0
    for i in range(300):
        count = int(rng.integers(1, 12))
        places = rng.uniform(-20, 20, (count, 3))
        if rng.random() < 0.3:
            places = np.abs(places).round()
        table = np.column_stack([places, rng.uniform(0.3, 0.7, count)])
        first = [None, np.cumsum(rng.integers(1, 4, count)), rng.integers(1, 4, count)]
        first = first[rng.integers(3)]
        extra = rng.uniform(0.1, 9, count)
        columns = [table] if first is None else [first, table]
        columns += [extra] if rng.random() < 0.5 or first is None else []
        path = savetxt(tmp_path / f"{i}.txt", np.column_stack(columns), fmt=rng.choice(FORMATS))
        reader = reader_for(path)
        reader.AddObserver("ErrorEvent", lambda *_: None)
        reader.Update()
        if not reader.GetErrorMessage():
            begin = 0 if first is None else 1
            written = np.loadtxt(path, ndmin=2)[:, begin : begin + 4]
            assert spheres(pv.wrap(reader.GetOutput())) == written.tolist(), path.read_text()
            read += 1
    assert read > 50, "most tables without ids are read"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("1 2.5 3 4 0.5\n2 4.5 5 6 0.25\n", [[2.5, 3, 4, 0.5], [4.5, 5, 6, 0.25]]),
        ("1 7 2.5 3 4 0.5\n2 7 4.5 5 6 0.25\n", [[2.5, 3, 4, 0.5], [4.5, 5, 6, 0.25]]),
        ("2.5 3 4 0.5 1 7\n4.5 5 6 0.25 2 7\n", [[2.5, 3, 4, 0.5], [4.5, 5, 6, 0.25]]),
    ],
)
def test_numbers_around_the_sphere_in_xyzr(read_text, text, expected):
    assert spheres(read_text(text, "p.xyzr")) == expected


@pytest.mark.parametrize(
    "text",
    [
        "1.5 2.5 3.5 0.5 7.25\n2.5 3.5 4.5 0.5 7.5\n",
        "1 2.5 3.5 4.5 0.5 7.25\n2 2.5 3.5 4.5 0.5 7.5\n",
        "1.5 2.5 3.5 0.5 7.25 1\n2.5 3.5 4.5 0.5 7.5 2\n",
        "1.0 2.5 3.5 0.5 7.25\n2.0 3.5 4.5 0.5 7.5\n",
    ],
)
def test_numbers_that_may_be_of_the_sphere_or_not_in_xyzr(refused, text):
    message = refused(text, "p.xyzr")
    assert message.startswith(", line 1: found ")
    assert HINT in message
