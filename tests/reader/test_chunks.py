"""Neither the size of a chunk nor the number of threads changes what is read or reported."""

import numpy as np
import pytest


def rows(count, end="\n", seed=5):
    rng = np.random.default_rng(seed)
    values = rng.normal(size=(count, 5))
    values[:, 3] = abs(values[:, 3])
    lines = []
    for i, row in enumerate(values.tolist()):
        if i % 7 == 3:
            lines.append("# a comment")
        if i % 11 == 5:
            lines.append("  ")
        lines.append(" ".join(map(repr, row)) + (" # note" if i % 13 == 0 else ""))
    return values, end.join(lines) + end


def arrays(packing):
    return [packing.points.tobytes()] + [packing[name].tobytes() for name in packing.array_names]


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"], ids=["lf", "crlf", "cr"])
def test_every_cut(read_text, end):
    """A chunk may end at, before and within every line end of a short text."""
    values, text = rows(12, end)
    expected = [values[:, :3].tobytes(), values[:, 3].tobytes(), values[:, 4].tobytes()]
    for chunk in [*range(1, len(text) + 2)]:
        assert arrays(read_text(text, chunk=chunk)) == expected


@pytest.fixture
def threads(vtk_core):
    yield vtk_core.vtkSMPTools.Initialize
    vtk_core.vtkSMPTools.Initialize(0)


@pytest.mark.parametrize("name", ["p.spheres", "p.csv", "p.xyzr"])
def test_threads_and_chunk_sizes(read, tmp_path, threads, name):
    values, text = rows(5000)
    path = tmp_path / name
    if name == "p.csv":
        text = "x,y,z,r,m\n" + "\n".join(",".join(map(repr, row)) for row in values.tolist()) + "\n"
    if name == "p.xyzr":
        values[:, 4] = np.arange(len(values)) % 9
        text = "\n".join(f"{id:.0f} {x!r} {y!r} {z!r} {r!r}" for x, y, z, r, id in values.tolist())
        text += "\n"
    path.write_text(text)
    expected = [values[:, :3].tobytes(), values[:, 3].tobytes(), values[:, 4].tobytes()]
    for count in (1, 2, 3, 7):
        threads(count)
        for chunk in (1, 100, 4096, 1 << 18):
            assert arrays(read(path, chunk=chunk)) == expected


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"], ids=["lf", "crlf", "cr"])
@pytest.mark.parametrize("at", [0, 1, 2499, 4999])
def test_the_line_of_an_error(read_error, tmp_path, threads, at, end):
    _, text = rows(5000, end)
    lines = text.split(end)
    numbers = [i for i, line in enumerate(lines) if line.strip() and line[0] != "#"]
    lines[numbers[at]] = "0 0 0 oops 0"
    path = tmp_path / "p.spheres"
    path.write_bytes(end.join(lines).encode())
    for count in (1, 2, 5):
        threads(count)
        for chunk in (1, 1000, 1 << 18):
            message, _ = read_error(path, chunk=chunk)
            assert f"line {numbers[at] + 1}: found 'oops' as radius" in message


def test_the_first_of_two_errors_is_reported(read_error, tmp_path, threads):
    _, text = rows(5000)
    lines = text.split("\n")
    lines[4000] = "0 0 0 second 0"
    lines[3990] = "0 first 0 1 0"
    lines[4500] = "1 2 3"
    path = tmp_path / "p.spheres"
    path.write_text("\n".join(lines))
    for count in (1, 2, 5):
        threads(count)
        for chunk in (1, 50, 1000, 1 << 18):
            message, _ = read_error(path, chunk=chunk)
            assert "line 3991: found 'first' as y" in message


def test_one_line_longer_than_all_chunks(read_text):
    text = "1. 2 3 4 " + "5 " * 3000 + "\n6 7 8 9 " + "1 " * 3000
    packing = read_text(text, chunk=10)
    assert packing["radius"].tolist() == [4, 9]
    assert len(packing.array_names) == 3001


def test_more_than_one_batch_reports_progress_from_this_thread(tmp_path, reader_for):
    import threading

    _, text = rows(20000)
    path = tmp_path / "p.spheres"
    path.write_text(text)
    reader = reader_for(path, chunk=1000)
    seen, here = [], []
    reader.AddObserver("ProgressEvent", lambda o, _: seen.append(o.GetProgress()))
    reader.AddObserver("ProgressEvent", lambda *_: here.append(threading.get_ident()))
    reader.Update()
    assert set(here) == {threading.get_ident()}
    assert seen == sorted(seen)
    assert len(set(seen)) > 20
    assert seen[-1] == 1


@pytest.mark.parametrize("after", [0.1, 0.25, 0.6])
def test_abort(tmp_path, after, reader_for):
    _, text = rows(20000)
    path = tmp_path / "p.spheres"
    path.write_text(text)
    reader = reader_for(path, chunk=1000)
    errors, later = [], []

    def stop(caller, _):
        if caller.GetProgress() >= after:
            later.append(caller.GetProgress())
            caller.SetAbortExecuteAndUpdateTime()

    reader.AddObserver("ErrorEvent", lambda *_: errors.append(1))
    tag = reader.AddObserver("ProgressEvent", stop)
    reader.Update()
    assert reader.GetOutput().GetNumberOfPoints() == 0
    assert not errors and reader.GetErrorMessage() == ""
    assert next(p for p in later if p < 1) < after + 0.25, "it stops soon"
    assert len([p for p in later if p < 1]) == 1, "and does nothing after that"

    reader.RemoveObserver(tag)
    reader.SetAbortExecute(0)
    reader.Update()
    assert reader.GetOutput().GetNumberOfPoints() == 20000


def test_a_mended_file_is_read_by_the_next_update(tmp_path, reader_for):
    path = tmp_path / "p.spheres"
    path.write_text("0 0 0\n")
    reader = reader_for(path)
    reader.AddObserver("ErrorEvent", lambda *_: None)
    reader.Update()
    assert reader.GetErrorMessage()
    path.write_text("0 0 0 1\n")
    reader.Update()
    assert reader.GetErrorMessage() == ""
    assert reader.GetOutput().GetNumberOfPoints() == 1


def test_a_bad_file_leaves_nothing_of_the_one_before(tmp_path, reader_for):
    (tmp_path / "good.spheres").write_text("0 0 0 1\n")
    (tmp_path / "bad.spheres").write_text("0 0 0 1\n0 0 0 -1\n")
    reader = reader_for(tmp_path / "good.spheres")
    reader.AddObserver("ErrorEvent", lambda *_: None)
    reader.Update()
    assert reader.GetOutput().GetNumberOfPoints() == 1
    reader.SetFileName(str(tmp_path / "bad.spheres"))
    reader.Update()
    assert reader.GetOutput().GetNumberOfPoints() == 0
    assert reader.GetOutput().GetPointData().GetNumberOfArrays() == 0
