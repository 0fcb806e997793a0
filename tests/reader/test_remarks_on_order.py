"""Remarks that contradict the order x y z radius, or that the fourth column is a radius."""

import time

import pytest

FOUR = "1.5 2.5 3.5 0.5\n1.25 2 3 0.75\n"
BY_PLACE = [[1.5, 2.5, 3.5], [1.25, 2, 3]]


@pytest.fixture
def refused(read_error, tmp_path):
    """Read a text that has to be refused: the message without the name of the file."""

    def read(text, name="p.txt", **options):
        path = tmp_path / name
        path.write_text(text)
        message, _ = read_error(path, **options)
        return message.removeprefix(str(path))

    return read


ORDER = [
    *("coordinates (zyx) and radius", "Radius first, then the centre", "r in the first column"),
    *("RADIUS FIRST", "the first column is the radius", "first the radius, then the position"),
    *("order: zyx", "xzy", "radius, then centre", "radii before positions", "column 1: r"),
    *("centres behind the radius", "radius followed by centre", "zxyr", "in ZYX order"),
    *("radius in column 1", "1st: radius, 2nd to 4th: centre"),
]
SIZE = [
    *("squared radius in the last column", "x, y, z are centres; fourth is the sphere width"),
    *("radius squared", "log of the radius", "r^2", "r**2", "r²", "radius (log10)", "log10 r"),
    *("fourth column: weight", "the last column holds sizes", "column 4 is the mass", "ln(r)"),
    *("half the radius", "x y z r^2", "x y z r squared", "radii are normalized", "col 4: volume"),
]
OTHER = [
    *("xyz and radius", "xyzr", "first three columns: centre", "first four are x, y, z and radius"),
    *("first line is the largest radius", "log-normal radii", "lognormal radii", "fourth is r"),
    *("first x y z then the radius", "square box of edge 10", "first version"),
    *("the last column is the radius", "4th order, radius by hand", "last step"),
    *("positions followed by radii", "x, y, z; the last column is r", "log file: run.log"),
    *("first the centre, then the radius", "the fourth step", "inverse problem"),
]


@pytest.mark.parametrize("remark", ORDER)
@pytest.mark.parametrize("optional", [False, True])
def test_another_order(refused, read_text, remark, optional):
    text = f"# by hand\n# {remark}\n{FOUR}"
    message = refused(text, optional=optional)
    assert ", line 2: found " in message
    assert "columns=" in message
    packing = read_text(text, columns="r z y x")
    assert packing.points[0].tolist() == [0.5, 3.5, 2.5]
    assert read_text(f"# x y z r\n{text}").points.tolist() == BY_PLACE, "names are certain"


@pytest.mark.parametrize("remark", SIZE)
def test_another_size(refused, read_text, remark):
    text = f"# by hand\n# {remark}\n{FOUR}"
    message = refused(text)
    assert ", line 2: found " in message
    assert "columns=" in message
    assert read_text(text, columns="x y z r")["radius"].tolist() == [0.5, 0.75]
    assert read_text(text, columns="x y z mass", optional=True)["mass"].tolist() == [0.5, 0.75]


@pytest.mark.parametrize("remark", OTHER)
def test_remarks_that_agree(read_text, remark):
    packing = read_text(f"# {remark}\n{FOUR}")
    assert packing.points.tolist() == BY_PLACE
    assert packing["radius"].tolist() == [0.5, 0.75]


@pytest.mark.parametrize("word", ["first ", "then ", "log ", "fourth ", "column 4 r ", "a"])
def test_time_is_linear_in_a_remark(reader_for, tmp_path, word):
    def seconds(count):
        path = tmp_path / "p.txt"
        path.write_text("# " + word * count + "\n" + FOUR)
        reader = reader_for(path)
        reader.AddObserver("ErrorEvent", lambda *_: None)
        start = time.process_time()
        reader.Update()
        return time.process_time() - start

    few = min(seconds(20000) for _ in range(3))
    many = min(seconds(160000) for _ in range(2))
    assert many < 24 * few + 0.05, "8 times as long; quadratic time would be 64"
