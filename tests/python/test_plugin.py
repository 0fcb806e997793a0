"""What PyVista finds by itself, and the VTK that it has to run on; each in a fresh process."""

import os
import subprocess
import sys

import pytest
import spherepacking
from spherepacking.backend.build_config import VTK_ROOT

OTHER = {"cvista": "vtk", "vtkmodules": "cvista"}[VTK_ROOT]


def run(code, *arguments, **environment):
    return subprocess.run(
        [sys.executable, "-W", "error", "-c", code, *map(str, arguments)],
        env=os.environ | environment,
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )


def test_everything_with_pyvista_alone(tmp_path):
    path = tmp_path / "two.spheres"
    path.write_text("0 0 0 1\n3 0 0 0.5\n")
    code = """
import sys
import pyvista as pv
packing = pv.read(sys.argv[1])
assert packing.packing.n_spheres == 2
plotter = pv.Plotter(off_screen=True, window_size=(80, 80))
actor = plotter.packing.add(packing, scalars="radius")
plotter.screenshot(sys.argv[2])
plotter.close()
packing.save(sys.argv[3])
"""
    result = run(code, path, tmp_path / "two.png", tmp_path / "copy.spheres")
    assert (result.returncode, result.stdout, result.stderr) == (0, "", "")
    picture = spherepacking.read_image(tmp_path / "two.png")
    assert picture.std() > 10
    assert spherepacking.read(tmp_path / "copy.spheres")["radius"].tolist() == [1.0, 0.5]


def test_importing_pyvista_does_not_import_the_package():
    assert run("import pyvista, sys; assert 'spherepacking' not in sys.modules").returncode == 0


def test_importing_the_package_does_not_import_pyvista():
    code = "import spherepacking, sys; assert 'pyvista' not in sys.modules; spherepacking.read"
    assert run(code).returncode == 0


USES = {
    "read": "pv.read(sys.argv[1])",
    "add": "pv.Plotter(off_screen=True).packing.add(pv.PolyData([[0.0, 0.0, 0.0]]), radius=1.0)",
    "save": "pv.PolyData([[0.0, 0.0, 0.0]]).save('x.spheres')",
    "bounds": "m = pv.PolyData([[0.0, 0.0, 0.0]]); m['radius'] = [1.0]; m.packing.bounds",
}


@pytest.mark.parametrize("use", USES)
def test_another_vtk_is_one_error_that_says_what_to_set(tmp_path, use):
    pytest.importorskip("vtkmodules" if OTHER == "vtk" else "cvista")
    path = tmp_path / "one.spheres"
    path.write_text("0 0 0 1\n")
    code = f"""
import sys, pyvista as pv
try:
    {USES[use]}
except ImportError as error:
    print(error)
else:
    print("no error")
"""
    result = run(code, path, PYVISTA_VTK_BACKEND=OTHER)
    wanted = "vtk" if VTK_ROOT == "vtkmodules" else VTK_ROOT
    assert f"PYVISTA_VTK_BACKEND={wanted}" in result.stdout
    assert "pip install" in result.stdout
    assert result.stdout.count("\n") == 1
    assert result.stderr == ""


def test_the_right_vtk_named_explicitly():
    wanted = "vtk" if VTK_ROOT == "vtkmodules" else VTK_ROOT
    assert run("import spherepacking.backend", PYVISTA_VTK_BACKEND=wanted).returncode == 0


def test_public_names():
    for name in spherepacking.__all__:
        assert callable(getattr(spherepacking, name))
        assert getattr(spherepacking, name).__doc__
        assert name in dir(spherepacking)
    with pytest.raises(AttributeError, match="no attribute 'nonsense'"):
        spherepacking.nonsense  # noqa: B018


DISPLAY = {
    "DISPLAY": "",
    "WAYLAND_DISPLAY": "",
    "VTK_DEFAULT_OPENGL_WINDOW": "",
}
CHOOSE = """
import os
from spherepacking.draw import offscreen
{change}
offscreen.choose_window()
print(os.environ.get("VTK_DEFAULT_OPENGL_WINDOW"))
"""
WITH = "offscreen._osmesa_loads = lambda: True"
WITHOUT = "offscreen._osmesa_loads = lambda: False"


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="only Linux has no display")
@pytest.mark.parametrize(
    ("change", "environment", "expected"),
    [
        (WITH, {}, "vtkOSOpenGLRenderWindow"),
        (WITHOUT, {}, "vtkEGLRenderWindow"),
        (WITH, {"DISPLAY": ":0"}, ""),
        (WITH, {"WAYLAND_DISPLAY": "wayland-0"}, ""),
        (WITH, {"VTK_DEFAULT_OPENGL_WINDOW": "vtkEGLRenderWindow"}, "vtkEGLRenderWindow"),
    ],
)
def test_window_where_there_is_no_display(change, environment, expected):
    result = run(CHOOSE.format(change=change), **(DISPLAY | environment))
    assert (result.stdout.strip(), result.stderr) == (expected, "")


def test_a_bad_file_is_told_once_by_pyvista_read(tmp_path):
    # In a process of its own: pytest's logging would hide what is logged besides.
    path = tmp_path / "three.spheres"
    path.write_text("1 2 3\n")
    code = f"""
import pyvista as pv
try:
    pv.read({str(path)!r})
except ValueError as error:
    print(type(error).__name__, error)
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.startswith(f"PackingFileError {path}, line 1: ")
    assert done.stderr == ""
