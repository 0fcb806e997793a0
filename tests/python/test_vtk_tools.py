"""What VTK's algorithms report becomes one exception, printed nowhere, and Ctrl-C stops them."""

import pytest
import pyvista as pv
import spherepacking
from spherepacking.backend import vtkSpherePackingBVH, vtkSpherePackingReader
from spherepacking.files.errors import PackingFileError
from spherepacking.vtk_tools import ErrorLog, errors_raised, update, window_of


def bad_filter():
    """A filter without radii, which its update reports."""
    algorithm = vtkSpherePackingBVH()
    algorithm.SetInputData(pv.PolyData([[0.0, 0.0, 0.0]]))
    return algorithm


def observers(algorithm):
    return algorithm.HasObserver("ErrorEvent") or algorithm.GetExecutive().HasObserver("ErrorEvent")


def test_what_is_reported_is_raised_and_not_printed(capfd):
    algorithm = bad_filter()
    with pytest.raises(ValueError, match="radius") as caught, errors_raised(algorithm):
        algorithm.Update()
    assert str(caught.value) == algorithm.GetErrorMessage()
    assert not observers(algorithm)
    assert capfd.readouterr() == ("", "")


def test_the_kind_of_exception_is_chosen():
    reader = vtkSpherePackingReader()
    reader.SetFileName("/nowhere/a.spheres")
    with pytest.raises(PackingFileError, match="/nowhere"), errors_raised(reader, PackingFileError):
        reader.Update()


def test_nothing_is_raised_when_nothing_is_reported():
    algorithm = vtkSpherePackingBVH()
    algorithm.SetInputData(spherepacking.apollonian(1))
    with errors_raised(algorithm):
        algorithm.Update()
    assert algorithm.GetOutput().GetNumberOfCells() > 0


def test_another_exception_goes_first(capfd):
    algorithm = bad_filter()

    def fail():
        algorithm.Update()
        raise KeyError("other")

    with pytest.raises(KeyError, match="other"), errors_raised(algorithm):
        fail()
    assert not observers(algorithm)
    assert capfd.readouterr() == ("", "")


def test_text_of_vtk_where_an_algorithm_says_nothing():
    class Silent:
        """An algorithm that only VTK speaks for."""

        def __init__(self, algorithm):
            self.algorithm = algorithm

        def __getattr__(self, name):
            return getattr(self.algorithm, name)

        def GetErrorMessage(self):
            return ""

    algorithm = Silent(bad_filter())
    with (
        pytest.raises(ValueError, match=r"(?s)ERROR: .*vtkSpherePackingBVH"),
        errors_raised(algorithm),
    ):
        algorithm.Update()


def test_a_log_only_collects():
    algorithm = bad_filter()
    with ErrorLog(algorithm) as log:
        algorithm.Update()
    assert len(log.messages) == 2, "the algorithm's, and that of its executive"
    assert not observers(algorithm)


def test_update_raises_and_shows_no_bar(capfd):
    with pytest.raises(ValueError, match="radius"):
        update(bad_filter(), "working", progress=False)
    assert capfd.readouterr() == ("", "")


def test_a_closed_plotter_has_no_window():
    plotter = pv.Plotter(off_screen=True)
    assert window_of(plotter) is plotter.render_window
    plotter.close()
    with pytest.raises(RuntimeError, match="has been closed"):
        window_of(plotter)
