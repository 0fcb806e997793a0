"""The command ``spherepacking``."""

import os
import re
import signal
import subprocess
import sys

import numpy as np
import pytest
import pyvista as pv
import spherepacking
from spherepacking.cli.main import main

COMMANDS = ("render", "info", "convert")


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "three.spheres"
    path.write_text("0 0 0 2\n10 0 0 1\n0 0 10 0.5\n")
    return path


def run(*arguments, stdout=subprocess.PIPE, **environment):
    return subprocess.run(
        [sys.executable, "-m", "spherepacking", *map(str, arguments)],
        env=os.environ | environment,
        stdout=stdout,
        stderr=subprocess.PIPE,
        text=True,
        timeout=120,
        check=False,
    )


def draw(file, *arguments):
    """Run ``render`` in this process and return the picture."""
    output = file.with_suffix(".png")
    assert main(["render", str(file), "-o", str(output), *map(str, arguments)]) == 0
    return spherepacking.read_image(output)


def covered(picture):
    """Return what part of the picture is not black."""
    return (picture[..., :3].max(axis=-1) > 0).mean()


# --- as a process ---------------------------------------------------------------------------------


def test_help_names_the_commands():
    result = run("--help")
    assert result.returncode == 0
    for command in COMMANDS:
        assert command in result.stdout


def test_help_imports_neither_vtk_nor_numpy():
    """They take most of a second."""
    code = """
import sys
from spherepacking.cli.main import main
main(["--help"])
print([name for name in ("numpy", "pyvista", "cvista", "vtkmodules") if name in sys.modules])
"""
    result = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True
    )
    assert result.stdout.strip().endswith("[]")


def test_version():
    result = run("--version")
    assert (result.returncode, result.stdout) == (0, f"spherepacking {spherepacking.__version__}\n")


def test_render_as_a_process(file, tmp_path):
    """Without a display and without a hint, as on a fresh machine."""
    output = tmp_path / "a.png"
    result = run("render", file, "-o", output, VTK_DEFAULT_OPENGL_WINDOW="", DISPLAY="")
    assert (result.returncode, result.stdout, result.stderr) == (0, "", "")
    assert spherepacking.read_image(output).shape == (1000, 1000, 3)


def test_info_as_a_process(file):
    result = run("info", file, PYTHONIOENCODING="ascii")
    assert (result.returncode, result.stderr) == (0, "")
    assert "spheres  3" in result.stdout


def test_a_reader_that_has_seen_enough(file):
    """As ``spherepacking info file | head -0``, whose end of the pipe is closed."""
    reading, writing = os.pipe()
    os.close(reading)
    with os.fdopen(writing, "wb") as pipe:
        result = run("info", file, stdout=pipe)
    assert (result.returncode, result.stderr) == (128 + signal.SIGPIPE, "")


def test_output_that_cannot_be_written(file):
    with open("/dev/full", "wb") as full:
        result = run("info", file, stdout=full)
    assert result.returncode == 2
    assert re.fullmatch(r"spherepacking: .*No space left on device\n", result.stderr)


@pytest.mark.parametrize("error", [KeyError, TypeError, AttributeError, RuntimeError])
def test_a_bug_is_no_error_of_the_user(monkeypatch, file, error):
    def describe(_packing):
        raise error("bug")

    monkeypatch.setattr("spherepacking.cli.info.describe", describe)
    with pytest.raises(error, match="bug"):
        main(["info", str(file)])


# --- render ---------------------------------------------------------------------------------------


PLAIN = ("--background", "black", "--color", "red", "--size", 200, 100)


def test_render_fills_the_picture(file):
    picture = draw(file, *PLAIN)
    assert picture.shape == (100, 200, 3)
    seen = np.argwhere(picture.max(axis=-1) > 0)
    # 0.92 of the height or of the width, whichever is reached first.
    extent = np.abs(seen - [49.5, 99.5]).max(axis=0) * 2 / [100, 200]
    assert extent.max() == pytest.approx(0.92, abs=0.03)


@pytest.mark.parametrize("size", [(200, 100), (100, 200), (150, 150)])
def test_nothing_is_cut_off(file, rng, size):
    mesh = pv.PolyData(rng.normal(size=(40, 3)) * [1.0, 3.0, 10.0] + 100.0)
    mesh["radius"] = rng.random(40)
    spherepacking.write(mesh, file)
    picture = draw(file, *PLAIN[:-3], "--size", *size)
    border = np.concatenate([picture[0], picture[-1], picture[:, 0], picture[:, -1]])
    assert border.max() == 0
    assert covered(picture) > 0.01


def test_render_camera(file):
    """Seen along x from afar, in parallel: the disc of the sphere in front, in the middle."""
    picture = draw(
        file, *PLAIN, "--camera", 50, 0, 0, "--focal", 0, 0, 0, "--parallel", "--view-angle", 20
    )
    height = 2 * 50 * np.tan(np.radians(10))
    rows = np.argwhere(picture[:, 100].max(axis=-1) > 0).ravel()
    assert len(rows) * height / 100 == pytest.approx(4.0, abs=2 * height / 100)
    assert (rows.min() + rows.max()) / 2 == pytest.approx(49.5, abs=1.0)


def test_render_from_above_finds_another_up(file):
    assert covered(draw(file, *PLAIN, "--camera", 0, 0, 50, "--focal", 0, 0, 0)) > 0.01


def test_render_zoom(file):
    far = covered(draw(file, *PLAIN, "--zoom", 0.5))
    near = covered(draw(file, *PLAIN, "--zoom", 0.25))
    assert far / near == pytest.approx(4.0, rel=0.25)


def test_render_transparent(file):
    picture = draw(file, "--transparent", "--color", "red", "--size", 100, 100)
    assert picture.shape == (100, 100, 4)
    assert picture[0, 0, 3] == 0
    assert picture[..., 3].max() == 255


def test_render_scalars_and_bar(file):
    with_bar = draw(file, "--size", 300, 300, "--cmap", "magma")
    without = draw(file, "--size", 300, 300, "--cmap", "magma", "--no-scalar-bar")
    assert (with_bar[250:] < 250).any()
    assert not np.array_equal(with_bar, without)


def test_what_is_in_front_is_seen_first_through_what_is_transparent(tmp_path):
    path = tmp_path / "two.csv"
    path.write_text("x,y,z,r,side\n0,0,0,1,0\n0,0,3,0.5,1\n")
    view = ["--up", 0, 1, 0, "--scalars", "side", "--cmap", "coolwarm", "--no-scalar-bar"]
    middles = []
    for z in (12, -12):
        for more in ([], ["--no-anti-aliasing"]):
            look = [*view, "--camera", 0, 0, z, "--opacity", 0.6, "--size", 200, 200, *more]
            picture = draw(path, *look).astype(int)
            middles.append(picture[100, 100])
    # Blue is at 0, red at 3.
    assert (middles[0] == middles[1]).all()
    assert (middles[2] == middles[3]).all()
    assert middles[0][0] > middles[0][2] + 50
    assert middles[2][2] > middles[2][0] + 50


def test_render_opacity(file):
    solid = draw(file, *PLAIN, "--no-anti-aliasing").max(axis=-1).astype(float)
    half = draw(file, *PLAIN, "--no-anti-aliasing", "--opacity", 0.5).max(axis=-1).astype(float)
    seen = solid > 50
    assert 0.4 < (half[seen] / solid[seen]).mean() < 0.9


def test_anti_aliasing_smooths_edges(file):
    def tones(*arguments):
        return len(np.unique(draw(file, "--transparent", "--color", "red", *arguments)[..., 3]))

    assert tones("--no-anti-aliasing", "--size", 100, 100) == 2
    assert tones("--size", 100, 100) > 4


def test_render_wide_radii_on_a_logarithmic_scale(tmp_path):
    """The middle one of three radii with equal ratios has the middle colour."""
    file = tmp_path / "wide.spheres"
    file.write_text("0 0 0 100\n300 0 0 10\n350 0 0 1\n")
    where = ("--camera", 300, -1000, 0, "--focal", 300, 0, 0, "--view-angle", 2)
    options = ("--cmap", "gray", "--background", "red", "--no-scalar-bar", "--size", 99, 99, *where)
    middle = draw(file, *options)[49, 49].astype(int)
    linear = draw(file, *options, "--no-log-scale")[49, 49].astype(int)
    assert 60 < middle[0] < 200
    assert linear[0] < 60


def test_equal_radii_are_not_colored_by(tmp_path):
    file = tmp_path / "equal.spheres"
    file.write_text("0 0 0 1\n3 0 0 1\n")
    options = ("--size", 100, 100)
    plain = draw(file, *options, "--color", pv.global_theme.color.name)
    assert np.array_equal(draw(file, *options), plain)
    assert not np.array_equal(draw(file, *options, "--scalars", "radius"), plain)


def test_render_zero_radii(tmp_path):
    file = tmp_path / "zeros.spheres"
    file.write_text("0 0 0 100\n300 0 0 0\n350 0 0 1\n")
    assert draw(file, "--size", 50, 50).std() > 5


@pytest.mark.parametrize("scale", [1e-15, 1e-8, 1e8, 1e13])
@pytest.mark.parametrize("options", [(), ("--parallel",)], ids=["perspective", "parallel"])
def test_the_unit_of_length_does_not_matter(tmp_path, scale, options):
    """Within what render accepts, pictures differ by rounding at edges only."""
    pictures = []
    for unit in (1.0, scale):
        file = tmp_path / "a.spheres"
        mesh = pv.PolyData(unit * np.array([[0, 0, 0], [10, 0, 0], [0, 0, 10]], dtype=float))
        mesh["radius"] = unit * np.array([2.0, 1.0, 0.5])
        spherepacking.write(mesh, file)
        pictures.append(draw(file, *PLAIN, "--no-anti-aliasing", *options).astype(int))
    assert covered(pictures[0]) > 0.01
    assert (np.abs(pictures[1] - pictures[0]).max(axis=-1) > 8).sum() <= 4


EXTREME = {
    "over a length of 2e\\+155": "0 0 0 1e155\n",
    "over a length of inf": "1e308 0 0 1\n-1e308 0 0 1\n",
    "over a length of 2.1e-300": "0 0 0 1e-300\n1e-300 0 0 1e-301\n",
    "at coordinates up to 1e\\+300": "1e300 0 0 1\n",
}


@pytest.mark.parametrize("message", EXTREME)
def test_render_says_what_a_picture_cannot_hold(tmp_path, capfd, message):
    file = tmp_path / "a.spheres"
    file.write_text(EXTREME[message])
    output = tmp_path / "a.png"
    assert main(["render", str(file), "-o", str(output)]) == 2
    err = capfd.readouterr().err
    assert re.fullmatch(
        f"spherepacking: .*a.spheres: found spheres .*{message}.*, expected .*\n", err
    )
    assert not output.exists()


@pytest.mark.parametrize("factor", ["1e300", "1e-300"])
def test_length_of_up_does_not_matter(file, factor):
    options = ("--camera", 20, 0, 0, "--focal", 0, 0, 0)
    expected = draw(file, *PLAIN, *options, "--up", 0, 1, 1)
    assert np.array_equal(draw(file, *PLAIN, *options, "--up", 0, factor, factor), expected)


@pytest.mark.parametrize("structure", ["bvh", "grid", "none"])
def test_render_ray_cast(file, structure):
    """Spheres are where the mapper draws them, with every structure."""
    view = ["--size", 120, 90, "--color", "white", "--no-scalar-bar", "--transparent"]
    view += ["--no-anti-aliasing"]
    drawn = draw(file, *view)[..., 3] > 0
    cast = draw(file, *view, "--technique", "raycast", "--structure", structure)[..., 3] > 0
    assert 100 < drawn.sum() < drawn.size
    assert (drawn != cast).sum() <= 1


def test_render_ray_cast_over_a_background(file):
    view = ["--size", 40, 40, "--technique", "raycast", "--background", "#0000ff"]
    assert draw(file, *view)[0, 0].tolist() == [0, 0, 255]
    picture = draw(file, *view, "--transparent", "--samples", 3)
    assert picture[0, 0].tolist() == [0, 0, 0, 0]
    assert len(np.unique(picture[..., 3])) > 3, "nine rays a pixel make steps of alpha"


@pytest.mark.parametrize(
    ("technique", "option", "few", "many"), [("bvh", "--boxes", 1, 3), ("grid", "--cuts", 0, 3)]
)
def test_render_boxes(file, technique, option, few, many):
    """Black edges, around all spheres: what is drawn around them grows with their number."""
    view = ["--size", 200, 200, "--color", "red", "--background", "white", "--no-scalar-bar"]
    dark = [
        (draw(file, *view, "--technique", technique, option, n).max(axis=-1) < 60).mean()
        for n in (few, many)
    ]
    assert 0.0 < dark[0] < dark[1]


@pytest.mark.parametrize("name", ["clump.csv", "atoms.xyzr", "chain.pqr"])
def test_render_real_input(tmp_path, data_file, name):
    output = tmp_path / "a.png"
    assert main(["render", str(data_file(name)), "-o", str(output), "--size", "200", "200"]) == 0
    assert spherepacking.read_image(output).std() > 20


# --- info and convert -----------------------------------------------------------------------------


def test_info(file, capsys):
    assert main(["info", str(file)]) == 0
    text = capsys.readouterr().out
    assert "x        -2 .. 11" in text
    assert "y        -2 .. 2" in text
    assert "z        -2 .. 10.5" in text
    assert "radius   0.5 .. 2, median 1" in text
    assert f"volume   {4 / 3 * np.pi * (8 + 1 + 0.125):.6g}" in text


@pytest.mark.parametrize(
    "radii",
    [
        [1.0],
        [1.0, 1.0, 1.0],
        [0.0, 0.0],
        [0.0, 1.0, 2.0],
        [0.0, 1e-6, 1.0, 3.0],
        [1e-5] * 9 + [7.0],
    ],
)
def test_histogram_counts_every_sphere_once(tmp_path, capsys, radii):
    file = tmp_path / "a.spheres"
    file.write_text("".join(f"0 0 0 {r}\n" for r in radii))
    assert main(["info", str(file)]) == 0
    lines = [line for line in capsys.readouterr().out.splitlines() if " .. " in line]
    bins = [line.split() for line in lines if line.startswith("  ")]
    assert sum(int(columns[3].replace(",", "")) for columns in bins) == len(radii)
    for columns in bins:
        low, high = float(columns[0]), float(columns[2])
        assert low <= high
        inside = sum(low * (1 - 1e-4) <= r <= high * (1 + 1e-4) for r in radii)
        assert inside >= int(columns[3])


@pytest.mark.parametrize(
    ("radii", "line"),
    [
        (["1e155"], "volume   4.18879e+465 "),
        (["1e308", "1e308"], "radius   1e+308 .. 1e+308, median 1e+308"),
        (["1e307", "1.5e308"], "volume   1.41414e+925 "),
        (["1e-200"], "volume   4.18879e-600 "),
        (["0", "0"], "volume   0 "),
    ],
)
def test_info_beyond_the_range_of_numbers(tmp_path, capfd, radii, line):
    file = tmp_path / "a.spheres"
    file.write_text("".join(f"0 0 0 {radius}\n" for radius in radii))
    assert main(["info", str(file)]) == 0
    out, err = capfd.readouterr()
    assert line in out
    assert err == ""


def test_convert(tmp_path, file):
    target = tmp_path / "out.spheres"
    source = tmp_path / "in.csv"
    source.write_text("x,y,z,d\n1,2,3,4\n")
    assert main(["convert", str(source), str(target)]) == 0
    packing = spherepacking.read(target)
    assert packing.points.tolist() == [[1.0, 2.0, 3.0]]
    assert packing["radius"].tolist() == [2.0]


# --- errors ---------------------------------------------------------------------------------------


ERRORS = {
    "render": "requires an argument",
    "paint": "paint",
    "info {good} --nonsense": "--nonsense",
    "info {none}": "none.spheres",
    "info {folder}": "found a directory",
    "info {bad}": "bad.spheres.*line 2",
    "render {bad} -o {png}": "bad.spheres.*line 2",
    "render {good} -o {png} --zoom big": "big",
    "render {good} -o {png} --zoom 0": "--zoom: found 0",
    "render {good} -o {png} --zoom inf": "--zoom: found inf",
    "render {good} -o {png} --zoom nan": "--zoom: found nan",
    "render {good} -o {png} --camera nan 0 0": "--camera: found nan 0 0, expected",
    "render {good} -o {png} --camera 0 inf 0": "--camera: found 0 inf 0, expected",
    "render {good} -o {png} --focal inf 0 0": "--focal: found inf 0 0, expected",
    "render {good} -o {png} --up 0 nan 0": "--up: found 0 nan 0, expected",
    "render {good} -o {png} --up 0 0 0": "--up: found 0 0 0, expected a direction",
    "render {good} -o {png} --camera 1e300 0 0": r"--camera: found a distance of 1e\+300",
    "render {good} -o {png} --clim 2 1": "clim: found .*2.0, 1.0.*, expected",
    "render {good} -o {png} --clim nan 1": "clim: found .*nan, 1.0.*, expected",
    "render {good} -o {png} --clim -1 1 --log-scale": "log_scale: found a clim from -1 to 1",
    "render {good} -o {png} --background nonsense": "--background: found 'nonsense'",
    "info /dev/null": "/dev/null: found a pipe or a device, expected a file",
    "render {good} -o {png} --size 0 5": "--size: found 0 5",
    "render {good} -o {png} --view-angle 180": "--view-angle: found 180",
    "render {good} -o {png} --scalars mass": "--scalars: found no array 'mass', .*: radius",
    "render {good} -o {png} --color nonsense": "nonsense",
    "render {good} -o {png} --cmap nonsense": "nonsense",
    "render {good} -o {png} --opacity 2": "opacity: found 2",
    "render {good} -o {png} --technique raycast --opacity 0.5": "--opacity: found 0.5",
    "render {good} -o {png} --technique raycast --samples 0": "samples: found 0, expected",
    "render {good} -o {png} --technique painting": "painting",
    "render {good} -o {png} --technique grid --cuts -1": "cuts: found -1, expected",
    "render {good} -o {png} --camera 9 0 0 --focal 9 0 0": "the position 9 0 0 at the focal",
    "render {good} -o {png} --camera 9 0 0 --focal 0 0 0 --up 1 0 0": "--up: found the direction",
    "render {good} -o {folder}/a.nonsense": "a.nonsense",
    "render {good} -o {folder}/no/a.png": "there is no folder",
    "convert {good} {good}": "good.spheres: found the source as the target, expected another file",
    "convert {good} {folder}/a.nonsense": "nonsense",
    "convert {bad} {folder}/a.spheres": "bad.spheres.*line 2",
}


def test_no_name_is_no_file(capfd):
    assert main(["info", ""]) == 2
    assert re.fullmatch(
        "spherepacking: .*found a directory, expected a file .*\n", capfd.readouterr().err
    )


@pytest.mark.parametrize("line", ERRORS)
def test_one_line_and_status_2(tmp_path, capfd, line):
    (tmp_path / "good.spheres").write_text("0 0 0 1\n")
    (tmp_path / "bad.spheres").write_text("0 0 0 1\n0 0 nan 1\n")
    names = {name: tmp_path / f"{name}.spheres" for name in ("good", "bad", "none")}
    names |= {"folder": tmp_path, "png": tmp_path / "a.png"}
    assert main([word.format_map(names) for word in line.split()]) == 2
    out, err = capfd.readouterr()
    assert out == ""
    assert err.startswith("spherepacking: ")
    assert err.count("\n") == 1
    assert re.search(ERRORS[line], err)
    assert not pv.plotting.plotter._ALL_PLOTTERS
    assert sorted(p.name for p in tmp_path.iterdir()) == ["bad.spheres", "good.spheres"]


def test_status_of_the_process(tmp_path):
    result = run("info", tmp_path / "none.spheres")
    assert result.returncode == 2
    assert result.stdout == ""
    assert result.stderr.count("\n") == 1
    assert "Traceback" not in result.stderr
