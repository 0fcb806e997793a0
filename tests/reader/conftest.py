"""Fixtures that read and write packings."""

import importlib

import pytest
import pyvista as pv
from spherepacking.vtkSpherePackingCore import (
    vtkSpherePackingReader,
    vtkSpherePackingWriter,
)


def make_reader(path, *, single=False, chunk=None, fmt=None, columns=None, optional=False):
    reader = vtkSpherePackingReader()
    reader.SetFileName(str(path))
    if single:
        reader.SetOutputPointsPrecision(vtkSpherePackingReader.SINGLE_PRECISION)
    if chunk is not None:
        reader.SetChunkSize(chunk)
    if fmt is not None:
        reader.SetFormat(getattr(vtkSpherePackingReader, fmt))
    reader.SetColumns(columns)
    reader.SetRadiusOptional(optional)
    return reader


@pytest.fixture(scope="session")
def reader_for():
    """The function that makes a reader of a file with the given options."""
    return make_reader


@pytest.fixture(scope="session")
def vtk_core():
    """The vtkCommonCore module of the VTK that PyVista runs on."""
    vtk_class = next(c for c in pv.PolyData.__mro__ if c.__name__ == "vtkPolyData")
    return importlib.import_module(vtk_class.__module__.rpartition(".")[0] + ".vtkCommonCore")


@pytest.fixture(scope="session")
def read():
    """Read a file that has to be good."""

    def read_file(path, **options):
        reader = make_reader(path, **options)
        reader.Update()
        assert reader.GetErrorMessage() == ""
        assert reader.GetErrorCode() == 0
        packing = pv.wrap(reader.GetOutput())
        assert packing.n_points > 0
        return packing

    return read_file


@pytest.fixture(scope="session")
def read_text(read, tmp_path_factory):
    """Read a text as a file of the given name."""

    def read_string(text, name="packing.spheres", **options):
        path = tmp_path_factory.mktemp("text") / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return read(path, **options)

    return read_string


@pytest.fixture(scope="session")
def read_error():
    """Read a file that has to be bad: the one message and the error code."""

    def read_bad(path, **options):
        reader = make_reader(path, **options)
        events = []
        reader.AddObserver("ErrorEvent", lambda *_: events.append(1))
        reader.Update()
        output = reader.GetOutput()
        assert output.GetNumberOfPoints() == 0
        assert output.GetNumberOfCells() == 0
        assert output.GetPointData().GetNumberOfArrays() == 0
        assert len(events) == 1, "one error, not none and not several"
        assert reader.GetErrorCode() != 0
        return reader.GetErrorMessage(), reader.GetErrorCode()

    return read_bad


@pytest.fixture(scope="session")
def write():
    """Write a packing and return whether that went well, and the message."""

    def write_file(packing, path, *, sort=False, radius="radius", fmt=None):
        writer = vtkSpherePackingWriter()
        writer.SetInputData(packing)
        writer.SetFileName(str(path))
        writer.SetSortByRadius(sort)
        writer.SetRadiusArrayName(radius)
        if fmt is not None:
            writer.SetFormat(getattr(vtkSpherePackingReader, fmt))
        events = []
        writer.AddObserver("ErrorEvent", lambda *_: events.append(1))
        good = bool(writer.Write())
        message = writer.GetErrorMessage()
        assert good == (message == "") == (writer.GetErrorCode() == 0) == (not events)
        return good, message

    return write_file


@pytest.fixture(scope="session")
def read_steps():
    """Read all steps of a file: what each is asked for by, and its packing or error message."""

    def read_all(path, **options):
        reader = make_reader(path, **options)
        reader.AddObserver("ErrorEvent", lambda *_: None)
        reader.UpdateInformation()
        executive = reader.GetExecutive()
        times = list(reader.GetOutputInformation(0).Get(executive.TIME_STEPS()) or ())
        steps = []
        for time in times:
            reader.UpdateTimeStep(time)
            packing = pv.PolyData()
            packing.DeepCopy(reader.GetOutput())
            steps.append(reader.GetErrorMessage() or packing)
        return times, steps

    return read_all
