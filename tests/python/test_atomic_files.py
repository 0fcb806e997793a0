"""A file that is written is the old one or the new one, and nothing else is left beside it."""

import fcntl
import importlib
import os
import signal
import stat
import subprocess
import sys
import time

import numpy as np
import pytest
import pyvista as pv
import spherepacking
from spherepacking.cli.main import main
from spherepacking.files import replace
from spherepacking.files.replace import replace_file, replacing

# More of each in `python tests/python/test_atomic_files.py KILLS FULL_DISKS`.
KILLS, FULL_DISKS = 8, 10
NAMES = ["a.spheres", "a.csv", "a.vtp", "a.png"]
LEFT = ".spherepacking-0123456789abcdef.part"

# Writes again and again, all numbers of a file the same; argument 3 is a limit on its size.
WRITER = """
import resource, signal, sys
import numpy as np, pyvista as pv, spherepacking
path, count, limit = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
def write(value):
    if path.endswith("png"):
        spherepacking.write_image(path, np.full((300, 300, 3), value, np.uint8))
    else:
        mesh = pv.PolyData(np.full((20000, 3), value / 7))
        mesh["radius"] = np.full(20000, value / 7)
        spherepacking.write(mesh, path)
write(1)
print("ready", flush=True)
for i in range(count):
    if limit:
        size = int(np.random.default_rng(limit + i).integers(1, 100_000))
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, resource.RLIM_INFINITY))
    try:
        write(2 + i % 200)
    except (OSError, ValueError) as error:
        print(error)
"""


def start(path, count, limit=0):
    return subprocess.Popen(
        [sys.executable, "-c", WRITER, path, str(count), str(limit)],
        stdout=subprocess.PIPE,
        text=True,
    )


def check_whole(path):
    if path.suffix == ".png":
        values = spherepacking.read_image(path)
        assert values.shape == (300, 300, 3)
    else:
        packing = spherepacking.read(path)
        assert packing.n_points == 20000
        values = np.concatenate([packing.points.ravel(), packing["radius"]])
    assert np.ptp(values) == 0


def kill_once(path, rng):
    process = start(path, 10**6)
    process.stdout.readline()
    time.sleep(rng.uniform(0, 0.1))
    process.kill()
    process.communicate()
    check_whole(path)


def write_anything(path):
    if path.suffix == ".png":
        spherepacking.write_image(path, np.zeros((300, 300, 3)))
    else:
        mesh = pv.PolyData(np.zeros((20000, 3)))
        mesh["radius"] = np.ones(20000)
        spherepacking.write(mesh, path)


@pytest.mark.parametrize("name", NAMES)
def test_killed_writers(tmp_path, rng, name):
    path = tmp_path / name
    for _ in range(KILLS // 4):
        kill_once(path, rng)
    write_anything(path)
    assert os.listdir(tmp_path) == [name]


@pytest.mark.parametrize("name", NAMES)
def test_full_disks(tmp_path, name):
    path = tmp_path / name
    said, _ = start(path, FULL_DISKS, limit=1).communicate()
    assert said.count(str(path)) == said.count("\n") - 1
    check_whole(path)
    assert os.listdir(tmp_path) == [name]


# A mount of its own without /proc, where no file without a name can be given one.
def without_proc(*command):
    return subprocess.run(
        ["unshare", "-m", "sh", "-c", 'mount -t tmpfs none /proc && exec "$@"', "sh", *command],
        capture_output=True,
        text=True,
        check=False,
    )


@pytest.mark.parametrize("name", NAMES[:3])
def test_where_files_need_a_name(tmp_path, name):
    if without_proc("true").returncode:
        pytest.skip("mounts need more rights")
    path = tmp_path / name
    code = WRITER.replace('print("ready", flush=True)', "import os; print(os.listdir('/proc'))")
    done = without_proc(sys.executable, "-c", code, path, "3", "0")
    assert done.stdout == "[]\n", done.stderr
    assert os.listdir(tmp_path) == [name]


def test_python_where_files_need_a_name(tmp_path, monkeypatch):
    monkeypatch.setattr(replace.os, "O_TMPFILE", os.O_DIRECTORY | os.O_WRONLY)
    path = tmp_path / "a.txt"
    path.write_text("earlier")
    with replacing(path) as file:
        file.write(b"new")
        (part,) = (name for name in os.listdir(tmp_path) if name != path.name)
        assert stat.S_IMODE((tmp_path / part).stat().st_mode) == 0o600
        # Others that write here leave it alone.
        spherepacking.write(spherepacking.apollonian(1), tmp_path / "b.spheres")
        replace_file(tmp_path / "b.spheres", b"")
        assert part in os.listdir(tmp_path)
    assert path.read_bytes() == b"new"
    assert sorted(os.listdir(tmp_path)) == ["a.txt", "b.spheres"]
    with pytest.raises(ZeroDivisionError), replacing(path):
        raise ZeroDivisionError
    assert sorted(os.listdir(tmp_path)) == ["a.txt", "b.spheres"]


def write_spheres(path):
    spherepacking.write(spherepacking.apollonian(2), path)


def write_bytes(path):
    replace_file(path, b"new")


BOTH = pytest.mark.parametrize("write", [write_spheres, write_bytes])


@BOTH
def test_what_killed_writers_left_is_removed(tmp_path, write):
    for i in range(150):
        (tmp_path / f".spherepacking-{i:016x}.part").write_text("left")
    # Of earlier versions, of others, and what is no file.
    (tmp_path / ".spherepacking0.part").write_text("")
    (tmp_path / ".spherepacking-0123.part").write_text("")
    (tmp_path / LEFT).symlink_to("elsewhere")
    kept = {".spherepacking0.part", ".spherepacking-0123.part", LEFT, "a.spheres"}
    write(tmp_path / "a.spheres")
    assert set(os.listdir(tmp_path)) == kept


@BOTH
def test_what_a_writer_holds_is_not_removed(tmp_path, write):
    with (tmp_path / LEFT).open("w") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        write(tmp_path / "a.spheres")
        assert sorted(os.listdir(tmp_path)) == [LEFT, "a.spheres"]
    write(tmp_path / "a.spheres")
    assert os.listdir(tmp_path) == ["a.spheres"]


@BOTH
def test_what_others_own_is_not_removed(tmp_path, write):
    if os.geteuid() != 0:
        pytest.skip("only root can give a file to others")
    (tmp_path / LEFT).write_text("")
    os.chown(tmp_path / LEFT, 12345, 12345)
    write(tmp_path / "a.spheres")
    assert sorted(os.listdir(tmp_path)) == [LEFT, "a.spheres"]


@BOTH
def test_permissions_and_group(tmp_path, write):
    path = tmp_path / "a.spheres"
    before = os.umask(0o027)
    try:
        write(path)
    finally:
        os.umask(before)
    assert stat.S_IMODE(path.stat().st_mode) == 0o640
    for mode in (0o600, 0o664, 0o777):
        path.chmod(mode)
        write(path)
        assert stat.S_IMODE(path.stat().st_mode) == mode
    if os.geteuid() == 0:
        os.chown(path, -1, 12345)
        write(path)
        assert path.stat().st_gid == 12345


def test_a_group_that_cannot_be_given(tmp_path, monkeypatch):
    def refuse(*_):
        raise PermissionError(1, "no")

    path = tmp_path / "a.txt"
    path.write_text("")
    path.chmod(0o664)
    if os.geteuid() != 0:
        pytest.skip("only root can give a file to another group")
    os.chown(path, -1, 12345)
    monkeypatch.setattr(replace.os, "fchown", refuse)
    replace_file(path, b"new")
    assert stat.S_IMODE(path.stat().st_mode) == 0o604


def modes_of_what_is_written(folder):
    """Permissions of files of this process in a folder that have no name."""
    found = []
    for descriptor in os.listdir("/proc/self/fd"):
        try:
            if os.readlink(f"/proc/self/fd/{descriptor}").startswith(f"{folder}/#"):
                found.append(stat.S_IMODE(os.fstat(int(descriptor)).st_mode))
        except OSError:
            pass
    return found


def test_others_cannot_read_what_is_written(tmp_path):
    from spherepacking.backend import vtkSpherePackingWriter

    path = tmp_path / "a.spheres"
    path.write_text("private")
    path.chmod(0o600)
    mesh = pv.PolyData(np.zeros((100000, 3)))
    mesh["radius"] = np.ones(100000)
    writer = vtkSpherePackingWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(mesh)
    modes = []
    tag = writer.AddObserver(
        "ProgressEvent", lambda *_: modes.append(modes_of_what_is_written(tmp_path))
    )
    writer.Write()
    writer.RemoveObserver(tag)
    assert [0o600] in modes
    assert stat.S_IMODE(path.stat().st_mode) == 0o600
    with replacing(path):
        assert modes_of_what_is_written(tmp_path) == [0o600]


@BOTH
def test_links(tmp_path, write):
    target = tmp_path / "folder" / "real.spheres"
    target.parent.mkdir()
    target.write_text("earlier")
    os.link(target, tmp_path / "hard")
    (tmp_path / "link.spheres").symlink_to("folder/real.spheres")
    write(tmp_path / "link.spheres")
    assert (tmp_path / "link.spheres").is_symlink()
    assert target.read_text() != "earlier"
    assert (tmp_path / "hard").read_text() == "earlier"
    (tmp_path / "new.spheres").symlink_to("folder/none.spheres")
    write(tmp_path / "new.spheres")
    assert (tmp_path / "folder" / "none.spheres").is_file()
    (tmp_path / "circle.spheres").symlink_to("circle.spheres")
    with pytest.raises((OSError, ValueError), match="found links that lead in a circle"):
        write(tmp_path / "circle.spheres")
    assert os.listdir(target.parent) and len(os.listdir(tmp_path)) == 5


def test_ctrl_c_after_the_file_has_its_name(tmp_path, monkeypatch):
    """It was written, so nothing else may be said than that Ctrl-C was pressed."""
    rename = replace.Path.replace

    def interrupted(part, target):
        rename(part, target)
        raise KeyboardInterrupt

    monkeypatch.setattr(replace.Path, "replace", interrupted)
    path = tmp_path / "a.csv"
    with pytest.raises(KeyboardInterrupt):
        replace_file(path, b"new")
    assert path.read_bytes() == b"new"
    assert os.listdir(tmp_path) == ["a.csv"]


# --- before the work ------------------------------------------------------------------------------


@pytest.fixture
def no_work(tmp_path, monkeypatch):
    """Whatever a command does after it has checked its target fails."""

    def work(*_, **__):
        raise AssertionError("there was work")

    pv.Cube().save(tmp_path / "cube.ply")
    spherepacking.write(spherepacking.apollonian(1), tmp_path / "one.spheres")
    importlib.import_module("spherepacking.cli.render")  # it would keep what is put in here
    monkeypatch.setattr("spherepacking.cli.pack.read_surface", work)
    monkeypatch.setattr("spherepacking.cli.input.open_steps", work)
    return tmp_path


@pytest.mark.parametrize("command", [["pack", "cube.ply"], ["convert", "one.spheres"]])
@pytest.mark.parametrize(
    ("target", "said"),
    [
        ("pipe.spheres", "found something that is no regular file"),
        ("pipe.vtp", "found something that is no regular file"),
        ("folder.spheres", "found a directory, expected a file name"),
        ("none/a.spheres", "there is no folder"),
        ("scaled.xyzd", "found beside it an .nfo file that scales the diameters"),
        ("a.docx", "found a format that cannot be written"),
        ("protected.spheres", "found a file that is write-protected"),
    ],
)
def test_what_cannot_be_written_is_known_before(
    no_work, monkeypatch, capsys, command, target, said
):
    monkeypatch.chdir(no_work)
    os.mkfifo("pipe.spheres")
    os.mkfifo("pipe.vtp")
    os.mkdir("folder.spheres")
    no_work.joinpath("scaled.nfo").write_text("Theoretical Porosity: 0.3\nFinal Porosity: 0.5\n")
    no_work.joinpath("protected.spheres").write_text("")
    no_work.joinpath("protected.spheres").chmod(0o444)
    if target == "protected.spheres" and os.geteuid() == 0:
        pytest.skip("nothing is protected from root")
    before = sorted(os.listdir())
    assert main([*command, target]) == 2
    assert said in capsys.readouterr().err
    assert sorted(os.listdir()) == before


def main_of_script(kills, full_disks):
    """Many more of both, by hand."""
    import tempfile
    from pathlib import Path

    rng = np.random.default_rng()
    for name in NAMES:
        folder = Path(tempfile.mkdtemp())
        path = folder / name
        left = 0
        for _ in range(kills // len(NAMES)):
            kill_once(path, rng)
            left += len(os.listdir(folder)) - 1
        write_anything(path)
        assert os.listdir(folder) == [name]
        said, _ = start(path, full_disks, limit=int(rng.integers(1, 10**6))).communicate()
        check_whole(path)
        assert os.listdir(folder) == [name]
        print(
            f"{name}: {kills // len(NAMES)} kills left {left}; full {said.count(str(path))} times"
        )


if __name__ == "__main__":
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)
    main_of_script(*map(int, sys.argv[1:3]))
