"""Steps, radii and columns on the command line, and what ``convert`` leaves out."""

import builtins
import os

import numpy as np
import pytest
import pyvista as pv
import spherepacking
from spherepacking.cli.frames import slice_of
from spherepacking.cli.input import radius_of
from spherepacking.cli.main import main
from spherepacking.files.writers import left_out

HEAD = """ITEM: TIMESTEP
{time}
ITEM: NUMBER OF ATOMS
{count}
ITEM: BOX BOUNDS pp pp ff
0 10
0 8
0 6
ITEM: ATOMS id x y z vx vy vz heat radius
"""
PLAIN = ("--size", "120", "100", "--background", "black", "--no-scalar-bar", "--no-anti-aliasing")
# Lit from the camera, so that the middle of a sphere has its colour.
MATT = (*PLAIN, "--technique", "raycast", "--cmap", "gray")


def text_of(time, *rows):
    lines = [" ".join(map(str, row)) + "\n" for row in rows]
    return HEAD.format(time=time, count=len(rows)) + "".join(lines)


@pytest.fixture
def run(tmp_path):
    """A sphere that stays, and another that moves, grows, cools and warms a third."""
    path = tmp_path / "run.dump"
    rows = [
        [(1, 0, 0, 0, 0, 0, 0, 5, 1), (2, 8, 0, 0, 1, 0, 0, 9, 0.5)],
        [(1, 0, 0, 0, 0, 0, 0, 5, 1), (2, 4, 0, 0, 1, 0, 0, 7, 1.5)],
        [(1, 0, 0, 0, 0, 0, 0, 5, 1), (2, 2, 0, 6, 1, 0, 0, 6, 1)],
        [(1, 0, 0, 0, 0, 0, 0, 5, 1), (2, 2, 0, 6, 1, 0, 0, 1, 1)],
    ]
    path.write_text("".join(text_of(10 * i, *row) for i, row in enumerate(rows)))
    return path


def ask(capfd, *arguments):
    """Run the command in this process and return its status and what it wrote."""
    status = main([str(argument) for argument in arguments])
    return status, *capfd.readouterr()


# --- info -----------------------------------------------------------------------------------------


def test_info_lists_steps_cell_and_arrays(run, capfd):
    status, out, err = ask(capfd, "info", run)
    assert status == 0
    assert "steps    4, times 0 10 20 30\nspheres  2\n" in out
    assert "velocity (3 components)" in out
    assert err == (
        f"spherepacking: {run} has 4 steps, this is the first, of time 0; --step takes another\n"
    )


def test_info_of_a_step(run, capfd):
    status, out, err = ask(capfd, "info", run, "--step", "1")
    assert (status, err) == (0, "")
    assert "radius   1 .. 1.5, median 1.25" in out
    assert "x        -1 .. 5.5" in ask(capfd, "info", run, "--step", "-3")[1]


def test_a_step_by_its_time(run, tmp_path, capfd):
    status, out, err = ask(capfd, "info", run, "--time", "10")
    assert (status, err) == (0, "")
    assert "radius   1 .. 1.5," in out
    status, _, err = ask(
        capfd, "convert", run, tmp_path / "a.csv", "--time", "0", "--radius", "heat"
    )
    assert (status, err.count("the first")) == (0, 0)
    assert spherepacking.read(tmp_path / "a.csv")["radius"].tolist() == [5, 9]


def test_convert_names_all_formats(run, tmp_path, capfd):
    status, _, err = ask(capfd, "convert", run, tmp_path / "a.gsd", "--step", "0")
    assert status == 2
    for extension in (".spheres", ".csv", ".dump", ".xyz", ".vtp", ".vtu", ".vtk"):
        assert extension in err


def test_info_of_cells_and_texts(capfd):
    from spherepacking.cli.info import describe

    packing = spherepacking.apollonian(1)
    packing["element"] = ["C"] * packing.n_points
    packing.field_data["cell_vectors"] = [[4.0, 0, 0], [1, 3, 0], [0, 0, 2]]
    packing.field_data["cell_origin"] = [-1.0, 0, 0.5]
    packing.field_data["cell_periodic"] = np.array([1, 1, 0], np.uint8)
    text = describe(packing)
    assert "cell     origin -1 0 0.5, a 4 0 0, b 1 3 0, c 0 0 2\nperiodic along a b\n" in text
    assert "element (text)" in text


def test_info_of_a_series(tmp_path, capfd):
    for i in range(10):
        (tmp_path / f"a{i}.xyzr").write_text(f"{i} 0 0 1\n")
    status, out, _ = ask(capfd, "info", tmp_path / "a*.xyzr", "--step", "-1")
    assert (status, out.splitlines()[0]) == (0, "steps    10, times 0 1 2 ... 8 9")
    assert "x        8 .. 10" in out


def test_info_of_times_that_repeat_or_are_missing(tmp_path, capfd):
    row = (1, 0, 0, 0, 0, 0, 0, 5, 1)
    path = tmp_path / "restarted.dump"
    path.write_text("".join(text_of(time, row) for time in (0, 100, 100)))
    _, out, err = ask(capfd, "info", path)
    assert out.startswith("steps    3, times 0 100 100\n")
    assert "this is the first, of time 0;" in err
    frame = "1\nProperties=pos:R:3:radius:R:1 {}\n0 0 0 1\n"
    path = tmp_path / "run.xyz"
    path.write_text(frame.format("") + frame.format("Time=0.5"))
    _, out, err = ask(capfd, "info", path)
    assert out.startswith("steps    2, times - 0.5\n")
    assert "this is the first; --step takes another" in err


def test_a_file_of_one_packing_says_nothing_of_steps(tmp_path, capfd):
    (tmp_path / "a.xyzr").write_text("0 0 0 1\n")
    _, out, err = ask(capfd, "info", tmp_path / "a.xyzr")
    assert ("step" in out, err) == (False, "")


# --- radii and columns ----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "radius"),
    [
        ("0.5", 0.5),
        ("1e-3", 1e-3),
        ("size", "size"),
        ("1=0.5,2=0.3", {1: 0.5, 2: 0.3}),
        ("C=1.7; H=1.1", {"C": 1.7, "H": 1.1}),
        ("1=0.5 X=1", {"1": 0.5, "X": 1.0}),
    ],
)
def test_radius(text, radius):
    assert radius_of(text) == radius


def test_radius_and_columns_of_a_table(tmp_path, capfd):
    path = tmp_path / "a.txt"
    path.write_text("1.5 2.5 3.5 4.5 7.5\n2.5 3.5 4.5 5.5 8.5\n")
    _, out, _ = ask(capfd, "info", path, "--columns", "w x y z r")
    assert "radius   7.5 .. 8.5" in out
    _, out, _ = ask(capfd, "info", path, "--columns", "x y z w r", "--radius", "w")
    assert "radius   4.5 .. 5.5" in out
    _, out, _ = ask(capfd, "info", path, "--columns", "x y z w v", "--radius", "0.25")
    assert "radius   0.25 .. 0.25" in out


# --- convert --------------------------------------------------------------------------------------


def test_convert_of_a_step(run, tmp_path, capfd):
    target = tmp_path / "a.xyzr"
    status, out, err = ask(capfd, "convert", run, target, "--step", "1")
    assert (status, out) == (0, "")
    assert spherepacking.read(target)["radius"].tolist() == [1.0, 1.5]
    assert err.startswith("spherepacking: a.xyzr holds x y z r alone: left out id, ")
    assert "velocity" in err


def test_convert_says_which_step_it_took(run, tmp_path, capfd):
    _, _, err = ask(capfd, "convert", run, tmp_path / "a.csv")
    assert "has 4 steps, this is the first" in err


def test_what_formats_leave_out():
    packing = spherepacking.apollonian(1)
    assert left_out(packing, "a.csv") is None
    assert left_out(packing, "a.vtp") is None
    assert left_out(packing, "a.dump") is None
    packing["element"] = ["C"] * packing.n_points
    packing["matId"] = np.zeros(packing.n_points)
    packing.field_data["cell_vectors"] = np.eye(3)
    text = "holds arrays of each sphere alone: left out the cell"
    assert left_out(packing, "/somewhere/a.csv") == f"a.csv {text}"
    text = "holds x y z r matId alone: left out level, element, the cell"
    assert left_out(packing, "a.txt") == f"a.txt {text}"


# --- render ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "indices"),
    [
        (":", [0, 1, 2, 3, 4]),
        ("0:4:2", [0, 2]),
        ("::2", [0, 2, 4]),
        ("-2:", [3, 4]),
        ("3", [3]),
        ("-1", [4]),
        ("-2", [3]),
        ("::-1", [4, 3, 2, 1, 0]),
    ],
)
def test_slices(text, indices):
    assert list(range(5)[slice_of(text)]) == indices


@pytest.mark.parametrize("text", ["", "a", "1:b", "1:2:3:4", "::0"])
def test_no_slices(text):
    with pytest.raises(ValueError, match=r"--steps: found .* expected FIRST:END:STRIDE"):
        slice_of(text)


def pictures(tmp_path, *indices):
    return [spherepacking.read_image(tmp_path / f"f_{i:03d}.png") for i in indices]


def render(run, *arguments, style=PLAIN):
    return main(["render", str(run), *style, *arguments, "-o", str(run.parent / "f_%03d.png")])


def test_a_camera_for_all(run, tmp_path):
    """The first sphere is at the same place in each picture, which its colour of its own shows."""
    assert render(run, "--steps", "::2", "--scalars", "heat", "--cmap", "gray_r") == 0
    assert sorted(file.name for file in tmp_path.glob("*.png")) == ["f_000.png", "f_002.png"]
    first, second = pictures(tmp_path, 0, 2)
    assert first.shape == (100, 120, 3)
    same = (first == second).all(axis=-1) & (first.max(axis=-1) > 0)
    assert same.sum() > 20
    # Nothing is cut off in any.
    for picture in (first, second):
        border = np.concatenate([picture[0], picture[-1], picture[:, 0], picture[:, -1]])
        assert border.max() == 0


def test_a_range_of_colours_for_all(run, tmp_path):
    """A heat of 5 is black where 5 to 9 is the range, and grey where 1 to 9 is that of all."""
    assert render(run, "--steps", "0:1", "--scalars", "heat", style=MATT) == 0
    (alone,) = pictures(tmp_path, 0)
    assert render(run, "--steps", ":", "--scalars", "heat", style=MATT) == 0
    found = pictures(tmp_path, 0, 1, 2, 3)
    brightest = [float(picture.max()) for picture in found]
    assert float(alone.max()) == pytest.approx(brightest[0], abs=2)
    # 7 of 1 to 9, and 6, are three quarters and five eighths of white; 1 is black, and 5 the half.
    assert brightest[1] / brightest[0] == pytest.approx(0.75, abs=0.06)
    assert brightest[2] / brightest[0] == pytest.approx(0.625, abs=0.06)
    assert brightest[3] / brightest[0] == pytest.approx(0.5, abs=0.06)


def test_colours_of_a_file_are_shown_as_they_are(tmp_path):
    (tmp_path / "a.csv").write_text("x,y,z,radius,R,G,B\n0,0,0,1,255,0,0\n4,0,0,1,0,0,255\n")
    assert render(tmp_path / "a.csv", "--steps", ":", "--scalars", "rgb") == 0
    (picture,) = pictures(tmp_path, 0)
    found = {tuple(np.sign(pixel)) for pixel in picture.reshape(-1, 3).astype(int) // 128}
    assert {(1, 0, 0), (0, 0, 1)} <= found
    # Colours need no scalar bar.
    style = [argument for argument in PLAIN if argument != "--no-scalar-bar"]
    assert render(tmp_path / "a.csv", "--steps", ":", "--scalars", "rgb", style=style) == 0
    assert np.array_equal(pictures(tmp_path, 0)[0], picture)


def test_radii_have_one_range_too(run, tmp_path):
    assert render(run, "--steps", "2:", style=MATT) == 0
    a, b = pictures(tmp_path, 2, 3)
    assert np.array_equal(a, b)
    (tmp_path / "f_002.png").unlink()
    assert render(run, "--steps", "1:3", style=MATT) == 0
    # The radius of 1 is the smallest of 1 to 1.5.
    assert pictures(tmp_path, 2)[0].max() == 0


def test_steps_without_spheres(tmp_path):
    """Runs that pour begin with none."""
    for i, name in enumerate(("s_0.vtp", "s_1.vtp")):
        mesh = pv.PolyData(np.zeros((i, 3)))
        if i:
            mesh["radius"], mesh["heat"] = [1.0], [2.0]
        mesh.save(tmp_path / name)
    series = tmp_path / "s_*.vtp"
    assert main(["render", str(series), *PLAIN, "--steps", ":", "--scalars", "heat",
                 "-o", str(tmp_path / "f_%03d.png")]) == 0  # fmt: skip
    nothing, one = pictures(tmp_path, 0, 1)
    assert nothing.max() == 0
    assert one.max() > 0


def test_metaballs_of_no_spheres(tmp_path):
    run = tmp_path / "pour.dump"
    run.write_text(text_of(0) + text_of(10, (1, 0, 0, 0, 0, 0, 0, 5, 1)))
    assert render(run, "--steps", ":", "--technique", "metaballs", "--dimensions", "16") == 0
    nothing, one = pictures(tmp_path, 0, 1)
    assert (nothing.max() == 0, one.max() > 0) == (True, True)


@pytest.mark.parametrize("technique", ["raycast", "metaballs", "bvh"])
def test_other_techniques(run, tmp_path, technique):
    arguments = ["--dimensions", "16"] if technique == "metaballs" else []
    assert render(run, "--steps", "1:3", "--technique", technique, *arguments) == 0
    for picture in pictures(tmp_path, 1, 2):
        assert picture.max() > 0


def test_a_step_of_a_run_and_which_one_was_taken(run, tmp_path, capfd):
    output = str(tmp_path / "a.png")
    status, _, err = ask(capfd, "render", run, *PLAIN, "-o", output, "--step", "2")
    assert (status, err) == (0, "")
    picture = spherepacking.read_image(output)
    status, _, err = ask(capfd, "render", run, *PLAIN, "-o", output)
    assert (status, "has 4 steps, this is the first" in err) == (0, True)
    assert not np.array_equal(picture, spherepacking.read_image(output))


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["-o", "a.png", "--steps", ":"], "--output: found a.png, expected a number in the name"),
        (["-o", "a_%d_%d.png", "--steps", ":"], "expected a number in the name"),
        (["-o", "a_%s%d.png", "--steps", ":"], "expected a number in the name"),
        (["-o", "a_%d.xyz", "--steps", ":"], "a_0.xyz"),
        (["-o", "a_%d.png", "--steps", "9:"], "--steps: found 9:, expected some of the 4 steps"),
        (["-o", "a_%d.png", "--steps", "x"], "--steps: found x"),
        (["-o", "a_%d.png", "--steps", ":", "--step", "1"], "--step: found with --steps"),
        (["-o", "a_%d.png", "--steps", ":", "--time", "10"], "--time: found with --steps"),
        (["-o", "a_%02d.png"], "--output: found a_%02d.png, which has a place for the numbers of"),
        (["-o", "a_%d.png", "--step", "1"], "expected --steps with it, such as --steps :"),
        (["-o", "a.png", "--step", "4"], "--step: found 4, expected -4 to 3"),
        (["-o", "a.png", "--time", "15"], "--time: found 15.0, expected one of 0, 10, 20, 30"),
        (["-o", "a.png", "--time", "nan"], "--time: found nan, expected a number"),
        (["-o", "a.png", "--time", "10", "--step", "1"], "--time: found step and time, expected"),
        (["-o", "a_%d.png", "--steps", ":", "--scalars", "no"], "--scalars: found no array 'no'"),
        (["-o", "a_%d.png", "--steps", ":", "--fps", "0"], "--fps: found 0"),
    ],
)
def test_errors(run, tmp_path, monkeypatch, capfd, arguments, message):
    monkeypatch.chdir(tmp_path)
    status, out, err = ask(capfd, "render", run, *arguments)
    assert (status, out) == (2, "")
    assert message in err
    assert err.count("\n") == 1
    assert list(tmp_path.glob("*.png")) == []


# --- movies ---------------------------------------------------------------------------------------


def test_a_movie(run, tmp_path):
    imageio = pytest.importorskip("imageio.v2")
    pytest.importorskip("imageio_ffmpeg")
    output = tmp_path / "run.mp4"
    arguments = ["--steps", ":", "--fps", "10", "-o", str(output)]
    assert main(["render", str(run), *PLAIN, *arguments]) == 0
    with imageio.get_reader(output) as reader:
        frames = [np.asarray(reader.get_data(i)) for i in range(reader.count_frames())]
        assert reader.get_meta_data()["fps"] == 10.0
    assert len(frames) == 4
    assert frames[0].shape == (100, 120, 3)
    assert [path.name for path in tmp_path.iterdir() if path != run] == ["run.mp4"]


def test_an_animation(run, tmp_path):
    imageio = pytest.importorskip("imageio.v2")
    output = tmp_path / "run.gif"
    assert main(["render", str(run), *PLAIN, "--steps", ":3", "-o", str(output)]) == 0
    assert len(imageio.mimread(output)) == 3


@pytest.mark.parametrize("name", ["run.mp4", "run.gif"])
def test_a_movie_of_one_step_says_how_to_take_all(run, tmp_path, capfd, name):
    status, _, err = ask(capfd, "render", run, "-o", tmp_path / name)
    assert (status, f"{name}, expected --steps with it" in err) == (2, True)


@pytest.mark.parametrize("name", ["run.mp4", "run.gif"])
def test_a_movie_that_cannot_be_written_is_known_before(run, tmp_path, capfd, monkeypatch, name):
    pytest.importorskip("imageio.v2")
    pytest.importorskip("imageio_ffmpeg")

    def draw(*_, **__):
        raise AssertionError("there was work")

    monkeypatch.setattr("spherepacking.cli.render.frame_writer", draw)
    os.mkfifo(tmp_path / name)
    status, _, err = ask(capfd, "render", run, "--steps", ":", "-o", tmp_path / name)
    assert (status, "found something that is no regular file" in err) == (2, True)


def test_a_movie_replaces_another_and_keeps_its_permissions(run, tmp_path):
    pytest.importorskip("imageio.v2")
    output = tmp_path / "run.gif"
    output.write_text("earlier")
    output.chmod(0o600)
    assert main(["render", str(run), "--steps", ":2", "-o", str(output), "--size", "32", "32"]) == 0
    assert output.stat().st_mode & 0o777 == 0o600
    assert output.read_bytes()[:4] == b"GIF8"
    assert [path.name for path in tmp_path.iterdir() if path != run] == ["run.gif"]


def test_odd_sizes_are_refused_for_movies(run, tmp_path, capfd):
    pytest.importorskip("imageio_ffmpeg")
    output = tmp_path / "run.mp4"
    status, _, err = ask(capfd, "render", run, "--size", "101", "100", "--steps", ":", "-o", output)
    assert (status, "--size: found 101 100, expected even numbers" in err) == (2, True)


def test_the_library_for_movies_is_named(run, tmp_path, capfd, monkeypatch):
    real = builtins.__import__

    def without(name, *args, **kwargs):
        if name.partition(".")[0] == "imageio":
            raise ImportError(name)
        return real(name, *args, **kwargs)

    monkeypatch.setattr(builtins, "__import__", without)
    status, _, err = ask(capfd, "render", run, "--steps", ":", "-o", tmp_path / "run.mp4")
    assert (status, "pip install 'spherepacking[movies]'" in err) == (2, True)


# --- the cell -------------------------------------------------------------------------------------


@pytest.mark.parametrize("technique", ["opengl", "bvh"])
def test_the_cell_is_drawn_and_seen_as_a_whole(tmp_path, capfd, technique):
    """One small sphere in a corner of a large cell: its twelve edges fill the picture."""
    path, picture = tmp_path / "a.dump", tmp_path / "a.png"
    path.write_text(text_of(0, (1, 1, 1, 1, 0, 0, 0, 5, 0.5)))
    drawn = {}
    for cell in ([], ["--cell"]):
        options = (*PLAIN, "--technique", technique, "--color", "red", *cell)
        status, _, err = ask(capfd, "render", path, "-o", picture, *options)
        assert status == 0, err
        image = (
            np.asarray(pv.read(picture).active_scalars).reshape(100, 120, -1)[..., :3].astype(int)
        )
        drawn[bool(cell)] = image
    edges = drawn[True].max(axis=2) > 60
    red = drawn[True][..., 0] > drawn[True][..., 1] + 40
    # The sphere is as small as it is in the cell, and the edges reach from side to side.
    assert 0 < red.sum() < 0.1 * (drawn[False][..., 0] > drawn[False][..., 1] + 40).sum()
    rows, columns = (edges & ~red).any(axis=1), (edges & ~red).any(axis=0)
    assert rows.sum() > 60 or columns.sum() > 70
    assert rows.sum() > 50 and columns.sum() > 50


def test_the_cell_in_several_steps(run, tmp_path, capfd):
    status, _, err = ask(
        capfd, "render", run, "--steps", ":", "-o", tmp_path / "f_%d.png", *PLAIN, "--cell"
    )
    assert status == 0, err
    assert len(list(tmp_path.glob("f_*.png"))) == 4


def test_no_cell_to_draw(tmp_path, capfd):
    (tmp_path / "a.xyzr").write_text("0 0 0 1\n")
    status, _, err = ask(
        capfd, "render", tmp_path / "a.xyzr", "-o", tmp_path / "a.png", *PLAIN, "--cell"
    )
    assert status != 0
    assert "--cell: " in err and "found no cell" in err
    assert not (tmp_path / "a.png").exists()
    status, _, err = ask(
        capfd, "render", tmp_path / "a.xyzr", "-o", tmp_path / "a.png", *MATT, "--cell"
    )
    assert status != 0
    assert "--cell: found with --technique raycast, expected --technique opengl" in err
