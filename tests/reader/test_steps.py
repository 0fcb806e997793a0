"""Time steps: their values, those that a stopped run has cut, all formats that have them."""

import os
import time

import numpy as np
import pytest
import pyvista as pv
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


@pytest.mark.parametrize("name", FORMATS)
def test_the_numbers_of_the_file(tmp_path, reader_for, name):
    (tmp_path / name).write_text(FORMATS[name](0, 100, 100, 50))
    reader = reader_for(tmp_path / name)
    reader.UpdateInformation()
    assert list(pv.convert_array(reader.GetStepTimes())) == [0, 100, 100, 50]
    (tmp_path / "p.spheres").write_text(ROW)
    reader.SetFileName(str(tmp_path / "p.spheres"))
    reader.UpdateInformation()
    assert reader.GetStepTimes().GetNumberOfTuples() == 0


@pytest.mark.parametrize(
    ("comments", "times"),
    [
        (["", "Time=7", ""], [np.nan, 7, np.nan]),
        (["", ""], [np.nan, np.nan]),
        # What all have goes before what some have; what increases goes before both.
        (["Time=1 Step=5", "Step=5"], [5, 5]),
        (["Time=1 Step=5", "Time=1 Step=6"], [5, 6]),
        (["Time=1 Step=5", "Time=1 Step=5"], [1, 1]),
    ],
)
def test_numbers_that_are_missing(tmp_path, reader_for, comments, times):
    (tmp_path / "p.xyz").write_text(xyz(*comments))
    reader = reader_for(tmp_path / "p.xyz")
    reader.UpdateInformation()
    np.testing.assert_array_equal(pv.convert_array(reader.GetStepTimes()), times)


TIMED = [f"ITEM: TIME\n{time}\n" + dump(number) for time, number in ((0.5, 0), (1.5, 100))]


@pytest.mark.parametrize(
    ("text", "times"),
    [
        ("".join(TIMED), [0.5, 1.5]),
        ("ITEM: UNITS\nlj\n" + "".join(TIMED).replace("\n", "\r\n"), [0.5, 1.5]),
        # Times that are rounded to the same, or appended to a run without.
        ("".join(TIMED).replace("1.5\nITEM", "0.5\nITEM"), [0, 100]),
        (dump(0) + TIMED[1] + "ITEM: TIME\n2.5\n" + dump(200), [0, 100, 200]),
        (dump(0) + "".join(TIMED), [0, 0, 100]),
        # Another title.
        (dump(0).replace("\n0\n", "\n0\nITEM: TIMER\n0.5\n", 1), [0]),
        ("".join(TIMED) + "ITEM: TIME\n2.5", [0.5, 1.5]),
        ("".join(TIMED) + "ITEM: TIME\n2.5\n", [0.5, 1.5]),
    ],
)
def test_times_of_dumps(tmp_path, read_steps, text, times):
    """As ``dump_modify time yes`` of LAMMPS writes them."""
    (tmp_path / "p.dump").write_bytes(text.encode())
    _, packings = read_steps(tmp_path / "p.dump")
    assert [packing.field_data["TimeValue"][0] for packing in packings] == times
    assert [packing["radius"].tolist() for packing in packings] == [[0.25, 0.15]] * len(times)


def test_a_damaged_time(tmp_path, read_error):
    (tmp_path / "p.dump").write_text("ITEM: TIME\n0,5\n" + dump(0))
    message, _ = read_error(tmp_path / "p.dump")
    assert "p.dump, line 2: found '0,5', expected the time" in message


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


# --- finding them ---------------------------------------------------------------------------------


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"], ids=["lf", "crlf", "cr"])
@pytest.mark.parametrize("name", FORMATS)
def test_time_is_linear_in_the_steps(tmp_path, reader_for, name, end):
    step = "ITEM: TIMESTEP\n1\n" if name == "p.dump" else FORMATS[name](1, rows=ROWS[:1])
    path = tmp_path / name

    def seconds(count):
        path.write_bytes((step * count).replace("\n", end).encode())
        reader = reader_for(path)
        start = time.perf_counter()
        reader.UpdateInformation()
        taken = time.perf_counter() - start
        assert reader.GetStepTimes().GetNumberOfTuples() == count
        return taken

    # Enough that the memory of few comes from the system, too.
    count = 200_000 if name == "p.dump" else 50_000
    few = min(seconds(count) for _ in range(3))
    many = min(seconds(8 * count) for _ in range(2))
    assert many < 40 * few, "8 times as many steps, in new memory; quadratic time would be 64"


@pytest.fixture
def one_thread(vtk_core):
    vtk_core.vtkSMPTools.Initialize(1)
    yield
    vtk_core.vtkSMPTools.Initialize(0)


@pytest.mark.parametrize("name", FORMATS)
@pytest.mark.usefixtures("one_thread")
def test_the_search_reports_and_can_be_stopped(tmp_path, reader_for, name):
    path = tmp_path / name
    rows = ROWS * (400_000 if name == "p.dump" else 100_000)  # which is searched in larger pieces
    path.write_text(FORMATS[name](0, 1, 2, rows=rows))
    reader = reader_for(path)
    seen = []
    reader.AddObserver("ProgressEvent", lambda r, _: seen.append(r.GetProgress()))
    reader.UpdateInformation()
    assert len(seen) >= 3 and seen == sorted(seen) and seen[-1] == 1
    assert reader.GetStepTimes().GetNumberOfTuples() == 3

    reader = reader_for(path)
    reader.AddObserver("ProgressEvent", lambda r, _: r.SetAbortExecute(1))
    reader.UpdateInformation()
    assert reader.GetStepTimes().GetNumberOfTuples() == 0
    assert reader.GetErrorMessage() == ""


@pytest.mark.parametrize("how", ["in place", "renamed"])
def test_a_file_that_was_written_again_in_the_same_second(tmp_path, reader_for, how):
    path = tmp_path / "p.dump"
    path.write_text(dump(0) + dump(1) + dump(2, rows=ROWS * 9))
    stamp = path.stat()
    reader = reader_for(path)
    reader.UpdateTimeStep(1)
    assert reader.GetOutput().GetNumberOfPoints() == 2
    other = tmp_path / "other" if how == "renamed" else path
    other.write_text(dump(0) + dump(1, rows=ROWS * 9) + dump(2))
    os.utime(other, ns=(stamp.st_atime_ns, stamp.st_mtime_ns))
    other.replace(path)
    assert path.stat().st_size == stamp.st_size
    assert path.stat().st_mtime_ns == stamp.st_mtime_ns
    reader.Modified()
    reader.UpdateTimeStep(1)
    assert reader.GetErrorMessage() == ""
    assert reader.GetOutput().GetNumberOfPoints() == 18


@pytest.mark.parametrize("value", ["nan", "inf", "1e400", "5x", "x"])
def test_times_that_are_none(tmp_path, reader_for, read_steps, value):
    """A comment of XYZ may say anything; the head of a step of MercuryDPM may not."""
    (tmp_path / "p.xyz").write_text(xyz("Time=0", f"Time={value}"))
    reader = reader_for(tmp_path / "p.xyz")
    reader.UpdateInformation()
    np.testing.assert_array_equal(pv.convert_array(reader.GetStepTimes()), [0, np.nan])
    (tmp_path / "p.data").write_text(mercury(0, value))
    assert read_steps(tmp_path / "p.data") == ([], [])
    reader = reader_for(tmp_path / "p.data")
    reader.AddObserver("ErrorEvent", lambda *_: None)
    reader.Update()
    assert f"line 4: found '2 {value} 0 0 0 9 9 9 '" in reader.GetErrorMessage()
