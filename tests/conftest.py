"""Fixtures for all tests: data, randomness, the offscreen window, leaked VTK objects."""

import gc
import os
import subprocess
import sys
import zlib
from pathlib import Path

import hypothesis
import numpy as np
import pytest
from spherepacking.draw.offscreen import choose_window

TESTS = Path(__file__).resolve().parent
ROOT = TESTS.parent
# Folders whose tests open no window, and those that also run under the sanitizers.
WINDOWLESS = {"core", "light", "packaging", "reader"}
HARD = {"core", "reader"}

# The same examples in every run: a failure on one machine is a failure on all.
hypothesis.settings.register_profile("repeatable", derandomize=True, deadline=None)
hypothesis.settings.load_profile("repeatable")


choose_window(with_display=True)  # VTK reads the variable when it makes its first window


def layer(path):
    """Return the folder of tests/ that a test file lies in, or an empty string."""
    parts = path.relative_to(TESTS).parts
    return parts[0] if len(parts) > 1 else ""


def pytest_collection_modifyitems(items):
    for item in items:
        if layer(item.path) in HARD:
            item.add_marker(pytest.mark.hard)


def pytest_report_header():
    window = os.environ["VTK_DEFAULT_OPENGL_WINDOW"]
    data = data_folder()
    return [f"window: {window}", f"real inputs: {data} ({'found' if data.is_dir() else 'absent'})"]


def pytest_terminal_summary(terminalreporter):
    """Say which tests ran on small inputs alone, since the real ones are absent."""
    skipped = terminalreporter.stats.get("skipped", [])
    reasons = [report.longrepr[2] for report in skipped if isinstance(report.longrepr, tuple)]
    absent = sorted(reason.partition(ABSENT)[2] for reason in reasons if ABSENT in reason)
    if absent:
        terminalreporter.section("real inputs")
        terminalreporter.write_line(
            f"{len(absent)} tests were skipped, since their real input is absent from "
            f"{data_folder()} (SPHEREPACKING_DATA names another folder); each ran on a small input "
            "of tests/data, too:"
        )
        for name in dict.fromkeys(absent):
            terminalreporter.write_line(f"  {name}: {absent.count(name)}")


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item, call):
    report = yield
    if report.when == "call":
        item.stash[PASSED] = report.passed
    return report


PASSED = pytest.StashKey[bool]()


# --- data -----------------------------------------------------------------------------------------


# Small inputs in tests/data, and the real ones whose format and style they have.
REAL = {
    "atoms.xyzr": "voronota_3dlb.xyzr",
    "blob.obj": "imb_bunny.obj",
    "blob.off": "vhacd_pig.off",
    "chain.pqr": "apbs_achbp.pqr",
    "clump.csv": "deme_TeddyBear.csv",
    "cubes.ply": "stanford_dragon_vrip_res3.ply",
    "equal.xyzd": "packgen_packing.xyzd",
    "helix.pqr": "apbs_membrane-helix-8.pqr",
    "planets.json": "starscape_solar-system.json",
    "positions.npz": "fresnel_spheres.npz",
    "protein.pdb": "ngl_3J6R.pdb",
    "tree.sph": "cellpack_test.sph",
}
ABSENT = "the real input is absent: "


def data_folder():
    default = ROOT.parent / "shared" / "data"
    return Path(os.environ.get("SPHEREPACKING_DATA", default))


def real_file(name):
    """Return the path of a real input, or skip the test where it is absent."""
    path = data_folder() / name
    if not path.is_file():
        pytest.skip(ABSENT + name)
    return path


@pytest.fixture(params=["small", "real"])
def data_file(request):
    """Return a function from the name of a small input to its path, or to that of the real one.

    A test that uses it runs twice; with the real input only where that is present.
    """

    def find(name):
        return TESTS / "data" / name if request.param == "small" else real_file(REAL[name])

    return find


# --- randomness -----------------------------------------------------------------------------------


@pytest.fixture
def rng(request):
    """Return a NumPy generator, seeded by the test's name; the seed is shown on failure.

    SPHEREPACKING_SEED=<integer> replaces the seed of every test.
    """
    seed = int(os.environ.get("SPHEREPACKING_SEED", zlib.crc32(request.node.nodeid.encode())))
    print(f"rng seed: SPHEREPACKING_SEED={seed}")
    return np.random.default_rng(seed)


# --- window ---------------------------------------------------------------------------------------

PROBE = """
import pyvista
plotter = pyvista.Plotter(off_screen=True, window_size=(64, 64))
plotter.background_color = "black"
plotter.add_mesh(pyvista.Sphere(), color="white", lighting=False)
picture = plotter.screenshot(return_img=True)
plotter.close()
assert picture[32, 32].min() > 250 and picture[0, 0].max() < 5, "the picture is not the sphere"
"""


@pytest.fixture(scope="session")
def window_works():
    """Return an empty string, or why the window class cannot draw.

    The attempt runs in another process, because a broken driver crashes the one that asks it.
    """
    probe = subprocess.run(
        [sys.executable, "-c", PROBE], capture_output=True, text=True, timeout=300, check=False
    )
    if probe.returncode == 0:
        return ""
    window = os.environ["VTK_DEFAULT_OPENGL_WINDOW"]
    last = "\n".join((probe.stdout + probe.stderr).splitlines()[-15:])
    return (
        f"{window} cannot draw offscreen here (exit code {probe.returncode}). "
        "Install libosmesa6, or libegl1, libegl-mesa0 and libgl1-mesa-dri.\n" + last
    )


@pytest.fixture(autouse=True)
def offscreen(request):
    """Let a test that may open a window fail with one clear message where none can draw."""
    if layer(request.path) in WINDOWLESS:
        return
    message = request.getfixturevalue("window_works")
    if message:
        pytest.fail(message, pytrace=False)


# --- leaks ----------------------------------------------------------------------------------------


def vtk_cores():
    """Return the modules that hold the roots of VTK's classes, as far as they are loaded."""
    names = ("cvista.vtkCommonCore", "vtkmodules.vtkCommonCore")
    return [sys.modules[name] for name in names if name in sys.modules]


def living_vtk_objects():
    """Return the VTK objects that Python's garbage collector knows, by id."""
    bases = tuple(core.vtkObjectBase for core in vtk_cores())
    gc.collect()
    # Not isinstance: it asks a weak proxy for its class, which fails when the object is gone.
    return {id(thing): thing for thing in gc.get_objects() if issubclass(type(thing), bases)}


def forget_the_dead():
    """Let VTK drop the attributes of Python objects whose C++ object has gone.

    VTK keeps them when the Python object goes before the C++ object, in case that comes back to
    Python, and looks through what it keeps only when it has one more to keep.
    """
    for core in vtk_cores():
        keeper = core.vtkCollection()
        one_more = core.vtkObject()
        one_more.attribute = True
        keeper.AddItem(one_more)
        del one_more  # now, while the keeper holds its C++ object


@pytest.fixture(scope="module", autouse=True)
def what_is_there_before():
    """Put what a module of tests finds alive out of the collector's sight, for its speed.

    Libraries leave a million objects, which no_leaks would look through several times a test.
    """
    gc.collect()
    gc.freeze()
    yield
    gc.unfreeze()


@pytest.fixture(autouse=True)
def no_leaks(request):
    """Fail a test that leaves VTK objects behind, as a cycle through an observer would."""
    if request.node.get_closest_marker("allow_leaks"):
        yield
        return
    before = set(living_vtk_objects())
    yield
    if not request.node.stash.get(PASSED, False):
        return  # the traceback of a failed test keeps its objects
    if "pyvista" in sys.modules:
        sys.modules["pyvista"].close_all()
    request.node.funcargs.clear()  # or pytest would hold what finished fixtures have returned
    if living_vtk_objects().keys() - before:
        forget_the_dead()
    left = [thing for key, thing in living_vtk_objects().items() if key not in before]
    names = sorted(type(thing).__name__ for thing in left)
    left.clear()
    if names:
        pytest.fail(f"{len(names)} VTK objects were left: {', '.join(names)}", pytrace=False)
