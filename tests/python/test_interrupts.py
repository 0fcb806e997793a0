"""What Ctrl-C means while C++ works: the handler of SIGINT decides, and VTK never sees it."""

import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest
import pyvista as pv
import spherepacking
from spherepacking.backend import vtkSpherePackingBVH
from spherepacking.interrupts import InterruptsHeld, _handler
from spherepacking.vtk_tools import ErrorLog


@pytest.fixture
def sigint():
    """Puts the handler that was there back; a job in the background ignores SIGINT."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    assert _handler.depth == 0
    assert _handler.raised is None
    assert not _handler.at_work
    signal.signal(signal.SIGINT, before)


def press():
    """Press Ctrl-C; the handler is run before the next bytecode."""
    os.kill(os.getpid(), signal.SIGINT)
    time.sleep(0.01)


def filter_of(count):
    algorithm = vtkSpherePackingBVH()
    packing = pv.PolyData(np.random.default_rng(0).random((count, 3)))
    packing["radius"] = np.full(count, 0.01)
    algorithm.SetInputData(packing)
    return algorithm


def test_the_end_of_the_block_raises(sigint):
    reached = []
    with pytest.raises(KeyboardInterrupt):  # noqa: SIM117, PT012
        with InterruptsHeld():
            press()
            reached.append(1)
    assert reached == [1]
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_blocks_within_blocks(sigint):
    reached = []
    with pytest.raises(KeyboardInterrupt):  # noqa: PT012
        with InterruptsHeld():
            try:
                with InterruptsHeld():
                    press()
                reached.append("after the inner one")
            except KeyboardInterrupt:
                reached.append("caught")
            reached.append("outer")
        reached.append("after the outer one")
    assert reached == ["caught", "outer"]


def test_it_goes_before_other_errors(sigint):
    with pytest.raises(KeyboardInterrupt), InterruptsHeld():  # noqa: PT012
        press()
        raise ValueError("that the work was stopped")


def test_an_observer_does_not_end_the_process(sigint):
    algorithm = filter_of(1000)
    algorithm.AddObserver("StartEvent", lambda *_: press())
    with pytest.raises(KeyboardInterrupt), ErrorLog(algorithm):
        algorithm.Update()
    algorithm.RemoveAllObservers()
    algorithm.Modified()
    with ErrorLog(algorithm) as log:
        algorithm.Update()
    assert not log.messages
    assert algorithm.GetOutput().GetNumberOfCells() > 0, "it is not stopped for ever"


def test_a_handler_that_returns_lets_the_work_go_on(sigint):
    heard = []
    signal.signal(signal.SIGINT, lambda number, _frame: heard.append(number))
    algorithm = filter_of(1000)
    algorithm.AddObserver("StartEvent", lambda *_: press())
    with ErrorLog(algorithm):
        algorithm.Update()
    assert heard == [signal.SIGINT]
    assert algorithm.GetOutput().GetNumberOfCells() > 0


def test_a_handler_may_raise_something_else(sigint):
    def leave(_number, _frame):
        raise SystemExit(3)

    signal.signal(signal.SIGINT, leave)
    with pytest.raises(SystemExit), InterruptsHeld():
        press()
    assert signal.getsignal(signal.SIGINT) is leave


def test_what_is_ignored_stays_ignored(sigint):
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    with InterruptsHeld():
        press()
    assert signal.getsignal(signal.SIGINT) is signal.SIG_IGN


def test_other_threads_hold_nothing(sigint):
    found = []

    def work():
        with InterruptsHeld():
            found.append(signal.getsignal(signal.SIGINT))

    thread = threading.Thread(target=work)
    thread.start()
    thread.join()
    assert found == [signal.default_int_handler]


def test_a_handler_over_that_of_a_picture_may_call_it(sigint):
    """As one does that adds to what was there."""
    plotter = pv.Plotter(off_screen=True, window_size=(60, 40))
    plotter.packing.path_trace(spherepacking.apollonian(1), samples=1)
    below = signal.getsignal(signal.SIGINT)
    assert below is _handler
    signal.signal(signal.SIGINT, lambda number, frame: below(number, frame))
    plotter.show(auto_close=False)
    with pytest.raises(KeyboardInterrupt):
        press()
    with pytest.raises(KeyboardInterrupt), InterruptsHeld():
        press()
    plotter.close()


def test_closed_pictures_leave_no_handler(sigint):
    plotter = pv.Plotter(off_screen=True, window_size=(60, 40))
    plotter.packing.path_trace(spherepacking.apollonian(1), samples=1)
    assert signal.getsignal(signal.SIGINT) is _handler
    plotter.close()
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


@pytest.mark.parametrize("arguments", [["convert", "FILE", "out.csv"], ["info", "FILE"]])
def test_commands_exit_with_130_and_leave_files_whole(arguments, tmp_path):
    file, target = tmp_path / "many.spheres", tmp_path / "out.csv"
    np.savetxt(file, np.random.default_rng(0).random((300_000, 4)), fmt="%.17g")
    target.write_text("x,y,z,r\n0,0,0,1\n")
    before = target.read_bytes()
    code = (
        "import signal, sys; signal.signal(signal.SIGINT, signal.default_int_handler);"
        "from spherepacking.cli.main import main, _load; _load(); print('loaded', flush=True);"
        "sys.exit(main(sys.argv[1:]))"
    )
    line = [str(file) if a == "FILE" else str(tmp_path / a) if "." in a else a for a in arguments]
    ended = set()
    for wait in np.linspace(0.0, 0.7, 8):
        with subprocess.Popen(
            [sys.executable, "-c", code, *line],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        ) as process:
            assert process.stdout.readline() == "loaded\n"
            time.sleep(wait)
            process.send_signal(signal.SIGINT)
            _, said = process.communicate(timeout=60)
        # 0, or the interpreter's own end, if the command had come to its end.
        assert process.returncode in (0, 130, -signal.SIGINT), (process.returncode, said)
        ended.add(process.returncode)
        if process.returncode == 130:
            assert said == "spherepacking: stopped\n"
        whole = target.read_bytes()
        assert whole == before or whole.count(b"\n") == 300_001
        assert not list(tmp_path.glob(".spherepacking*"))
        target.write_bytes(before)
    assert 130 in ended
