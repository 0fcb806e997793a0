"""``spherepacking.pack`` and the command ``spherepacking pack``."""

import contextlib
import os
import pty
import signal
import subprocess
import sys
import time

import numpy as np
import pytest
import pyvista as pv
import spherepacking
from spherepacking.cli.main import main


@pytest.fixture
def cube_file(tmp_path):
    path = tmp_path / "cube.ply"
    pv.Cube().triangulate().clean().save(path)
    return path


def test_a_packing_is_drawn_as_any_other():
    packing = spherepacking.pack(pv.Cube(), 30)
    assert isinstance(packing, pv.PolyData)
    assert packing.n_points == packing.n_verts == 30
    assert list(packing.point_data) == ["radius"]
    plotter = pv.Plotter(off_screen=True, window_size=(100, 100))
    plotter.packing.add(packing)
    assert plotter.screenshot(None, return_img=True).std() > 20
    plotter.close()
    assert 0.6 < packing.field_data["volume_fraction"][0] < 0.8
    assert packing.field_data["surface_volume"][0] == pytest.approx(1.0)


def test_the_mesh_is_left_alone():
    mesh = pv.Cube()
    before = mesh.copy()
    spherepacking.pack(mesh, 3)
    assert mesh == before


def test_limits():
    ball = pv.Icosphere(nsub=2)
    assert spherepacking.pack(ball, 10**6, fraction=0.5).n_points == 1
    large = spherepacking.pack(pv.Cube(), 10**6, min_radius=0.1)
    assert large.n_points == 9
    assert large["radius"].min() > 0.1


@pytest.mark.parametrize(
    ("kwargs", "error", "message"),
    [
        ({"mesh": pv.ImageData(dimensions=(3, 3, 3))}, TypeError, "mesh: found an ImageData"),
        ({"mesh": None}, TypeError, "mesh: found a NoneType"),
        ({"mesh": pv.Plane()}, ValueError, "surface: found 40 open edges"),
        ({"mesh": pv.PolyData()}, ValueError, "surface: found no triangles"),
        ({"mesh": pv.Cube(z_length=1e-6)}, ValueError, "surface: found no sphere of a millionth"),
        ({"count": 0}, ValueError, "count: found 0"),
        ({"count": 2.5}, TypeError, "count: found 2.5"),
        ({"seed": -1}, ValueError, "seed: found -1"),
        ({"min_radius": -1}, ValueError, "min_radius: found -1"),
        ({"min_radius": 0.6}, ValueError, "min_radius: found 0.6, expected less"),
        ({"min_radius": np.nan}, ValueError, "min_radius: found nan"),
        ({"min_radius": np.inf}, ValueError, "min_radius: found inf"),
        ({"min_radius": "0.1"}, ValueError, "min_radius: found '0.1', expected a number"),
        ({"min_radius": 10**400}, ValueError, "min_radius: found 1000"),
        ({"fraction": True}, ValueError, "fraction: found True, expected a number"),
        ({"fraction": 0}, ValueError, "fraction: found 0"),
        ({"fraction": 1.1}, ValueError, "fraction: found 1.1"),
        ({"progress_bar": 1}, TypeError, "progress_bar: found 1"),
    ],
)
def test_bad_arguments(kwargs, error, message):
    arguments = {"mesh": pv.Cube(), "count": 5, **kwargs}
    with pytest.raises(error, match=message):
        spherepacking.pack(arguments.pop("mesh"), arguments.pop("count"), **arguments)


def test_ctrl_c_when_all_are_there(monkeypatch):
    def stopped(algorithm, *_, **__):
        algorithm.Update()
        raise KeyboardInterrupt

    monkeypatch.setattr("spherepacking.make.pack.update", stopped)
    with pytest.warns(UserWarning, match="stopped after 20 of 20 spheres"):
        assert spherepacking.pack(pv.Cube(), 20).n_points == 20


# --- the command ------------------------------------------------------------------------------


def test_command(cube_file, capsys):
    target = cube_file.with_suffix(".spheres")
    assert main(["pack", str(cube_file), str(target), "--count", "40"]) == 0
    packing = spherepacking.read(target)
    assert packing.n_points == 40
    filled = 4 / 3 * np.pi * (packing["radius"] ** 3).sum()
    assert capsys.readouterr().out == f"40 spheres fill {filled:.1%} of the volume\n"
    made = spherepacking.pack(pv.read(cube_file), 40)
    np.testing.assert_array_equal(packing.points, made.points)
    np.testing.assert_array_equal(packing["radius"], made["radius"])


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("none.ply", "out.spheres"), "none.ply: there is no such file"),
        (("cube.ply", "nowhere/out.spheres"), "there is no folder"),
        (("cube.ply", "out.docx"), "docx"),
        (("cube.ply", "out.spheres", "--count", "0"), "count: found 0"),
        (("open.ply", "out.spheres"), "open edges"),
        (("points.ply", "out.spheres"), "found no polygons"),
        (("text.ply", "out.spheres"), "text.ply"),
        (("text.vtk", "out.spheres"), "text.vtk: found no surface that can be read: "),
        (("cube.ply", "out.spheres", "--min-radius", "9"), "no sphere above that was found"),
        (("cube.ply", "out.spheres", "--count", "1.5"), "found 1.5, expected an integer"),
        (("cut.ply", "out.spheres"), "cut.ply: found a file that ends early, expected"),
        (("text.glb", "out.spheres"), "text.glb: found the extension .glb, expected .off, .stl"),
    ],
)
def test_command_errors(cube_file, monkeypatch, capsys, arguments, message):
    monkeypatch.chdir(cube_file.parent)
    pv.Plane().save("open.ply")
    pv.PolyData(np.zeros((3, 3))).save("points.ply")
    cube_file.with_name("cut.ply").write_bytes(cube_file.read_bytes()[:-5])
    cube_file.with_name("text.txt").write_text("no surface\n")
    cube_file.with_name("text.ply").write_text("no surface\n")
    cube_file.with_name("text.glb").write_text("no surface\n")
    cube_file.with_name("text.vtk").write_text("no surface\n")
    assert main(["pack", *arguments]) == 2
    said = capsys.readouterr().err
    assert message in said
    assert said.startswith("spherepacking: ")
    assert not cube_file.with_name("out.spheres").exists()


def test_stopped_packings_are_written(cube_file):
    target = cube_file.with_suffix(".spheres")
    terminal, stderr = pty.openpty()
    process = subprocess.Popen(
        [sys.executable, "-m", "spherepacking", "pack", cube_file, target, "--count", "9999999"],
        stdout=subprocess.PIPE,
        stderr=stderr,
        text=True,
        env={**os.environ, "PYTHONUNBUFFERED": "1", "TERM": "xterm"},
    )
    os.close(stderr)
    said = ""
    while "packing" not in said:  # the bar is drawn, so there are spheres
        said += os.read(terminal, 1024).decode()
    time.sleep(0.5)
    process.send_signal(signal.SIGINT)
    with contextlib.suppress(OSError):  # that of Linux for the end
        while part := os.read(terminal, 1024).decode():
            said += part
    out, _ = process.communicate(timeout=60)
    os.close(terminal)
    assert process.returncode == 130
    packing = spherepacking.read(target)
    assert out.startswith(f"{packing.n_points} spheres fill")
    assert f"stopped after {packing.n_points} of 9999999 spheres" in said
    assert "100%" not in said
    assert packing["radius"][0] == pytest.approx(0.5, rel=1e-5)
