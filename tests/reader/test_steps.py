"""Time steps: their values, those that a stopped run has cut, all formats that have them."""

import numpy as np
import pytest
from test_dump import step

ROW = "1.5 2.5 3.5 0.25"
ROWS = ["1.5 2.5 3.5 0.25", "4.5 5.5 6.5 0.15"]


def dump(*times, rows=ROWS):
    return "".join(step(time, "x y z radius", rows) for time in times)


def xyz(*comments, rows=ROWS):
    lines = [row.split() for row in rows]
    body = "".join(f"A {x} {y} {z} {r}\n" for x, y, z, r in lines)
    properties = "Properties=species:S:1:pos:R:3:radius:R:1"
    return "".join(f"{len(rows)}\n{properties} {comment}\n{body}" for comment in comments)


def mercury(*times, rows=ROWS):
    lines = [row.split() for row in rows]
    body = "".join(f"{x} {y} {z} 0 0 0 {r} 0 0 0 0 0 0 0 \n" for x, y, z, r in lines)
    return "".join(f"{len(rows)} {time} 0 0 0 9 9 9 \n{body}" for time in times)


FORMATS = {
    "p.dump": dump,
    "p.xyz": lambda *times, rows=ROWS: xyz(*(f"Time={t}" for t in times), rows=rows),
    "p.data": mercury,
}


@pytest.mark.parametrize("name", FORMATS)
@pytest.mark.parametrize(
    ("numbers", "values"),
    [
        ([0], [0]),
        ([5], [5]),
        ([0, 100, 250], [0, 100, 250]),
        ([0, 100, 100], [0, 1, 2]),
        ([5, 5], [0, 1]),
        ([0, 100, 50], [0, 1, 2]),
        ([-1.5, 2.25], [-1.5, 2.25]),
    ],
)
def test_values(tmp_path, read_steps, name, numbers, values):
    (tmp_path / name).write_text(FORMATS[name](*numbers))
    times, packings = read_steps(tmp_path / name)
    assert times == values
    assert [packing.field_data["TimeValue"][0] for packing in packings] == numbers
    for packing in packings:
        assert packing["radius"].tolist() == [0.25, 0.15]


def test_steps_of_one_number_are_told_apart(tmp_path, read_steps):
    text = dump(5) + dump(5).replace("1.5 2.5", "7 8")
    (tmp_path / "p.dump").write_text(text)
    _, packings = read_steps(tmp_path / "p.dump")
    assert [packing.points[0].tolist() for packing in packings] == [[1.5, 2.5, 3.5], [7, 8, 3.5]]


def test_frames_without_a_time(tmp_path, read_steps):
    (tmp_path / "p.xyz").write_text(xyz("", "Time=7", ""))
    times, packings = read_steps(tmp_path / "p.xyz")
    assert times == [0, 1, 2]
    assert ["TimeValue" in packing.field_data for packing in packings] == [False, True, False]


@pytest.mark.parametrize("name", FORMATS)
def test_steps_without_spheres(tmp_path, read_steps, name):
    make = FORMATS[name]
    text = make(0, rows=[]) + make(1) + make(2, rows=[])
    (tmp_path / name).write_text(text)
    times, packings = read_steps(tmp_path / name)
    assert times == [0, 1, 2]
    assert [packing.n_points for packing in packings] == [0, 2, 0]
    assert all("radius" in packing.point_data for packing in packings)


@pytest.mark.parametrize("name", FORMATS)
def test_a_file_cut_anywhere(tmp_path, read_steps, name):
    """The last step is an error that says where the file ends, or left out."""
    whole = FORMATS[name](0, 100)
    second = len(FORMATS[name](0))
    path = tmp_path / name
    listed = 0
    for length in range(second, len(whole)):
        path.write_text(whole[:length])
        times, (first, *later) = read_steps(path)
        assert times == [0, 100][: 1 + len(later)]
        assert first["radius"].tolist() == [0.25, 0.15], whole[:length]
        for message in later:
            listed += 1
            assert message.startswith(f"{path}, line ")
            assert "found the end of the " in message or "follow, expected as many" in message
    assert listed > len(ROWS[1])


@pytest.mark.parametrize(
    ("name", "end"), [("p.dump", 2), ("p.xyz", 2), ("p.data", 3), ("p.dump", 1), ("p.xyz", 1)]
)
def test_a_last_number_that_is_cut(tmp_path, read_steps, name, end):
    (tmp_path / name).write_text(FORMATS[name](0, 1)[:-end])
    times, (first, message) = read_steps(tmp_path / name)
    assert times == [0, 1]
    assert first.n_points == 2
    lines = FORMATS[name](0, 1).count("\n")
    assert f"line {lines}: found the end of the file within the row '" in message
    assert "expected a line end after every row" in message


def test_a_lone_step_that_is_cut(tmp_path, read_error):
    for text, line in [("ITEM: TIMESTEP\n", 2), ("ITEM: TIMESTEP\n1", 2), ("ITEM: TIMESTEP", 2)]:
        (tmp_path / "p.dump").write_text(text)
        message, _ = read_error(tmp_path / "p.dump")
        assert f"line {line}: found the end of the file, expected the time step" in message


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"], ids=["lf", "crlf", "cr"])
@pytest.mark.parametrize("name", ["p.xyz", "p.data"])
def test_frames_across_blocks_of_the_search(tmp_path, read_steps, name, end):
    # Blocks have 1 MiB; the lines of a frame lie across every cut in one file or another.
    rng = np.random.default_rng(5)
    counts = rng.integers(10_000, 30_000, 5)
    for shift in range(0, 60, 7):
        row = "0" * shift + ROW
        text = "".join(FORMATS[name](i, rows=[row] * n) for i, n in enumerate(counts))
        (tmp_path / name).write_bytes(text.replace("\n", end).encode())
        times, packings = read_steps(tmp_path / name)
        assert times == [0, 1, 2, 3, 4]
        assert [packing.n_points for packing in packings] == counts.tolist()


def test_a_line_longer_than_a_block_of_the_search(tmp_path, read_steps):
    text = xyz("Time=1 note='" + "n" * 3_000_000 + "'", "Time=2")
    (tmp_path / "p.xyz").write_text(text)
    times, packings = read_steps(tmp_path / "p.xyz")
    assert times == [1, 2]
    assert [packing.n_points for packing in packings] == [2, 2]
