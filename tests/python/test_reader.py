"""``pyvista.read`` and ``spherepacking.read``; what formats hold is tested with the C++ reader."""

import os
import signal
import threading
import time
from importlib.metadata import entry_points

import numpy as np
import pytest
import pyvista as pv
import spherepacking
from spherepacking.files.readers import SpherePackingReader
from spherepacking.files.steps_reader import PackingStepsReader
from spherepacking.vtk_tools import progress_bar

TEXT = "0 0 0 1\n3.5 0 0.25 0.5\n"
# Before, entry points named functions: pyvista.read used them, and nothing else of PyVista did.
reader_classes = pytest.mark.skipif(
    pv.version_info < (0, 49), reason="PyVista before 0.49 knows no reader classes of others"
)
DUMP = """ITEM: TIMESTEP
{step}
ITEM: NUMBER OF ATOMS
1
ITEM: BOX BOUNDS pp pp pp
0 1
0 1
0 1
ITEM: ATOMS id x y z radius
1 {step} 0 0 0.5
"""


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "two.spheres"
    path.write_text(TEXT)
    return path


def check(packing):
    assert isinstance(packing, pv.PolyData)
    assert packing.points.tolist() == [[0, 0, 0], [3.5, 0, 0.25]]
    assert packing["radius"].tolist() == [1.0, 0.5]
    assert packing.point_data.active_scalars_name == "radius"


def test_pyvista_reads(file):
    check(pv.read(file))


def test_read_by_any_name(tmp_path):
    path = tmp_path / "packing without extension"
    path.write_text(TEXT)
    check(spherepacking.read(path))
    check(spherepacking.read(str(path)))


def test_precision(file):
    assert spherepacking.read(file).points.dtype == np.float64
    assert spherepacking.read(file, precision="single").points.dtype == np.float32
    with pytest.raises(ValueError, match="precision: found 'half', expected 'single' or 'double'"):
        spherepacking.read(file, precision="half")


@reader_classes
def test_pyvista_sets_the_precision(file):
    assert pv.read(file, precision="single").points.dtype == np.float32


@reader_classes
def test_get_reader(file):
    reader = pv.get_reader(file)
    assert isinstance(reader, SpherePackingReader)
    assert reader.precision == "double"
    assert reader.time_values == []
    check(reader.read())
    check(reader.read())


def test_a_second_read_keeps_the_first(file):
    first = pv.read(file)
    file.write_text("9 9 9 9\n")
    second = pv.read(file)
    check(first)
    assert second["radius"].tolist() == [9.0]


def test_extensions_do_not_override_what_pyvista_reads():
    built_in = set(pv.core.utilities.reader.CLASS_READERS)
    ours = {point.name for point in entry_points(group="pyvista.readers") if is_ours(point)}
    assert ours
    assert not ours & built_in


def is_ours(point):
    return point.value.startswith("spherepacking.")


@reader_classes
def test_every_extension_is_known_to_pyvista(tmp_path):
    for point in entry_points(group="pyvista.readers"):
        if is_ours(point):
            path = tmp_path / f"file{point.name}"
            path.write_bytes(b"")
            assert isinstance(pv.get_reader(path), (SpherePackingReader, PackingStepsReader))


def test_time_steps_of_a_dump(tmp_path):
    path = tmp_path / "run.dump"
    path.write_text(DUMP.format(step=10) + DUMP.format(step=20))
    reader = SpherePackingReader(path)
    assert reader.time_values == [10.0, 20.0]
    assert (reader.number_time_points, reader.active_time_value) == (2, 10.0)
    assert reader.read().points[0, 0] == 10.0
    reader.set_active_time_value(20.0)
    assert reader.read().points[0, 0] == 20.0
    reader.set_active_time_point(0)
    assert reader.read().points[0, 0] == 10.0
    with pytest.raises(ValueError, match=r"time_value: found 15.0, expected one of \[10.0, 20.0\]"):
        reader.set_active_time_value(15.0)
    with pytest.raises(IndexError):
        reader.set_active_time_point(2)


# --- errors ---------------------------------------------------------------------------------------


BAD = {
    "letters": ("a b c d\n", r"line 1"),
    "three columns": ("1 2 3\n", r"line 1"),
    "nan": ("0 0 0 1\n0 nan 0 1\n", r"line 2"),
    "infinity": ("0 0 0 1\n0 0 inf 1\n", r"line 2"),
    "negative radius": ("0 0 0 1\n0 0 0 -1\n", r"line 2"),
    "empty": ("", "sphere"),
}


@pytest.mark.parametrize("read", [pv.read, spherepacking.read])
@pytest.mark.parametrize("name", BAD)
def test_bad_text_is_one_exception(tmp_path, capfd, read, name):
    text, place = BAD[name]
    path = tmp_path / "bad.spheres"
    path.write_text(text)
    with pytest.raises(spherepacking.PackingFileError, match=rf"bad\.spheres.*{place}"):
        read(path)
    assert issubclass(spherepacking.PackingFileError, ValueError)
    assert capfd.readouterr() == ("", "")


def test_a_reader_works_again_after_an_error(file):
    reader = SpherePackingReader(file)
    file.write_text("0 0 0 -1\n")
    with pytest.raises(spherepacking.PackingFileError):
        reader.read()
    file.write_text(TEXT)
    reader.reader.Modified()
    check(reader.read())


@pytest.mark.parametrize("read", [pv.read, spherepacking.read])
def test_missing_file(tmp_path, capfd, read):
    with pytest.raises(FileNotFoundError, match=r"none\.spheres"):
        read(tmp_path / "none.spheres")
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize("read", [pv.read, spherepacking.read])
def test_directory(tmp_path, capfd, read):
    path = tmp_path / "folder.spheres"
    path.mkdir()
    with pytest.raises(IsADirectoryError, match=r"folder\.spheres: found a directory"):
        read(path)
    assert capfd.readouterr() == ("", "")


# --- progress -------------------------------------------------------------------------------------


def test_progress_bar(file, capfd):
    reader = SpherePackingReader(file)
    reader.show_progress()
    check(reader.read())
    assert "Reading two.spheres" in capfd.readouterr().err


@reader_classes
def test_progress_bar_of_pyvista(file, capfd):
    check(pv.read(file, progress_bar=True))
    assert "Reading two.spheres" in capfd.readouterr().err


def test_no_bar_for_short_reads(file, capfd):
    check(spherepacking.read(file, progress=True))
    assert capfd.readouterr().err == ""


def test_ctrl_c_stops_a_read(tmp_path, rng):
    before = signal.signal(signal.SIGINT, signal.default_int_handler)  # a job may ignore it
    path = tmp_path / "many.spheres"
    np.savetxt(path, rng.random((200_000, 4)), fmt="%.17g")
    reader = SpherePackingReader(path)
    sent = []

    def interrupt(_caller, _event):
        if not sent:
            sent.append(True)
            os.kill(os.getpid(), signal.SIGINT)
            time.sleep(0.01)  # lets the interpreter run the handler

    reader.reader.AddObserver("ProgressEvent", interrupt, 1.0)
    with pytest.raises(KeyboardInterrupt), progress_bar(reader.reader, "Reading", 60.0):
        reader.reader.Update()
    assert sent
    assert reader.reader.GetOutput().GetNumberOfPoints() == 0
    assert signal.signal(signal.SIGINT, before) is signal.default_int_handler


def test_reading_in_another_thread(file):
    found = []
    thread = threading.Thread(target=lambda: found.append(spherepacking.read(file, progress=True)))
    thread.start()
    thread.join()
    check(found[0])
