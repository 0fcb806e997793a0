"""Compressed files of packings, by name and by content, and what is wrong with them."""

import bz2
import gzip
import lzma
import os
import shutil
import signal
import subprocess
import sys
import tempfile
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import pyvista as pv
import spherepacking
from spherepacking.files import compressed

TEXT = b"0 0 0 1\n3.5 0 0.25 0.5\n"
DUMP = b"""ITEM: TIMESTEP
%d
ITEM: NUMBER OF ATOMS
1
ITEM: BOX BOUNDS pp pp pp
0 1
0 1
0 1
ITEM: ATOMS id x y z radius
1 %d 0 0 0.5
"""


def zstandard(data):
    module = pytest.importorskip("zstandard")
    return module.ZstdCompressor(write_checksum=True).compress(data)


COMPRESS = {".gz": gzip.compress, ".bz2": bz2.compress, ".xz": lzma.compress, ".zst": zstandard}
NAMES = {".gz": "gzip", ".bz2": "bzip2", ".xz": "xz", ".zst": "zstandard"}


@pytest.fixture(autouse=True)
def temporary(tmp_path, monkeypatch):
    """A temporary folder of the test's own, which is empty in the end."""
    folder = tmp_path / "temporary"
    folder.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(folder))
    yield folder
    assert list(folder.iterdir()) == []


def check(packing):
    assert packing.points.tolist() == [[0, 0, 0], [3.5, 0, 0.25]]
    assert packing["radius"].tolist() == [1.0, 0.5]


@pytest.mark.parametrize("extension", COMPRESS)
@pytest.mark.parametrize("name", ["a.spheres{}", "a.xyzr{}", "a{}", "a.spheres", "another name"])
def test_by_name_and_by_content(tmp_path, extension, name):
    path = tmp_path / name.format(extension)
    path.write_bytes(COMPRESS[extension](TEXT))
    check(spherepacking.read(path))


@pytest.mark.parametrize("extension", COMPRESS)
def test_streams_one_after_the_other(tmp_path, extension):
    path = tmp_path / f"a.spheres{extension}"
    half = TEXT.index(b"\n") + 1
    path.write_bytes(COMPRESS[extension](TEXT[:half]) + COMPRESS[extension](TEXT[half:]))
    check(spherepacking.read(path))


@pytest.mark.parametrize("extension", COMPRESS)
def test_many_pieces(tmp_path, extension, rng):
    rows = np.round(rng.random((100_000, 4)), 6)
    text = "".join(f"{x:.6f} {y:.6f} {z:.6f} {r:.6f}\n" for x, y, z, r in rows)
    path = tmp_path / f"a.spheres{extension}"
    path.write_bytes(COMPRESS[extension](text.encode()))
    packing = spherepacking.read(path)
    assert np.array_equal(np.column_stack([packing.points, packing["radius"]]), rows)


def test_the_format_is_that_of_the_inner_name(tmp_path):
    (tmp_path / "a.csv.gz").write_bytes(gzip.compress(b"d,z,y,x\n2,3,2,1\n"))
    packing = spherepacking.read(tmp_path / "a.csv.gz")
    assert (packing.points.tolist(), packing["radius"].tolist()) == ([[1, 2, 3]], [1.0])
    grid = pv.PolyData([[1.0, 2.0, 3.0]]).cast_to_unstructured_grid()
    grid["Diameter"] = [2.0]
    grid.save(tmp_path / "a.vtu")
    (tmp_path / "a.vtu.xz").write_bytes(lzma.compress((tmp_path / "a.vtu").read_bytes()))
    packing = spherepacking.read(tmp_path / "a.vtu.xz")
    assert (packing.points.tolist(), packing["radius"].tolist()) == ([[1, 2, 3]], [1.0])


def test_porosities_beside_it(tmp_path):
    """The factor of 0.5 is ((1 - 0.9) / (1 - 0.2))^(1/3)."""
    rows = np.array([[1.0, 2.0, 3.0, 4.0]])
    (tmp_path / "a.xyzd.gz").write_bytes(gzip.compress(rows.tobytes()))
    (tmp_path / "a.nfo").write_text("Theoretical Porosity: 0.2\nFinal Porosity: 0.9\n")
    assert spherepacking.read(tmp_path / "a.xyzd.gz")["radius"] == pytest.approx([1.0])


@pytest.mark.parametrize("make", ["folder", "link", "wrong"])
def test_porosities_that_cannot_be_read(tmp_path, temporary, make):
    (tmp_path / "a.xyzd.gz").write_bytes(gzip.compress(np.ones((1, 4)).tobytes()))
    path = tmp_path / "a.nfo"
    if make == "folder":
        path.mkdir()
    elif make == "link":
        path.symlink_to(tmp_path / "gone")
    else:
        path.write_text("Theoretical Porosity: 0.2\n")
    with pytest.raises(spherepacking.PackingFileError) as error:
        spherepacking.read(tmp_path / "a.xyzd.gz")
    assert str(error.value).startswith(f"{path}: ")
    assert list(temporary.iterdir()) == []


def test_a_compressed_file_cut_at_every_byte(tmp_path):
    text = b"1.125 2.125 3.125 0.339\n4.125 5.125 6.125 0.427\n" * 3
    packed = {"gz": gzip.compress(text), "bz2": bz2.compress(text), "xz": lzma.compress(text)}
    zstandard = pytest.importorskip("zstandard")
    packed["zst"] = zstandard.ZstdCompressor(write_checksum=True).compress(text)
    for extension, whole in packed.items():
        path = tmp_path / f"p.spheres.{extension}"
        path.write_bytes(whole)
        assert spherepacking.read(path).n_points == 6
        for length in range(len(whole)):
            path.write_bytes(whole[:length])
            with pytest.raises(spherepacking.PackingFileError):
                spherepacking.read(path)


def test_steps_of_a_compressed_dump(tmp_path, temporary):
    path = tmp_path / "run.dump.gz"
    path.write_bytes(gzip.compress(DUMP % (10, 1) + DUMP % (20, 2) + DUMP % (30, 3)))
    steps = spherepacking.steps(path)
    assert steps.times == [10.0, 20.0, 30.0]
    assert len(list(temporary.iterdir())) == 1
    assert [packing.points[0, 0] for packing in steps[::-1]] == [3.0, 2.0, 1.0]
    assert spherepacking.read(path, time=20).points[0, 0] == 2.0
    # It goes away with the last of these.
    last = steps[2:]
    del steps
    assert last[0].points[0, 0] == 3.0


# --- errors ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("extension", COMPRESS)
@pytest.mark.parametrize("keep", [12, -3])
def test_a_file_that_ends_early(tmp_path, extension, keep):
    path = tmp_path / f"a.spheres{extension}"
    path.write_bytes(COMPRESS[extension](TEXT * 100)[:keep])
    with pytest.raises(
        spherepacking.PackingFileError,
        match=rf"a\.spheres{extension}: found a {NAMES[extension]} file that ends early",
    ):
        spherepacking.read(path)


@pytest.mark.parametrize("extension", COMPRESS)
def test_a_damaged_file(tmp_path, extension):
    path = tmp_path / f"a.spheres{extension}"
    data = bytearray(COMPRESS[extension](os.urandom(5000)))
    for at in range(40, len(data), 50):
        data[at] ^= 0xFF
    path.write_bytes(data)
    with pytest.raises(
        spherepacking.PackingFileError, match=rf"a\.spheres{extension}: .*{NAMES[extension]} file"
    ):
        spherepacking.read(path)


@pytest.mark.parametrize("extension", COMPRESS)
def test_what_is_not_compressed(tmp_path, extension):
    path = tmp_path / f"a.spheres{extension}"
    for data in (b"", b"\0" + TEXT, TEXT + b"\x1b", TEXT + b"\xff", TEXT.decode().encode("utf-16")):
        path.write_bytes(data)
        with pytest.raises(
            spherepacking.PackingFileError, match=f"not compressed by {NAMES[extension]}"
        ):
            spherepacking.read(path)


@pytest.mark.parametrize("extension", COMPRESS)
def test_text_by_the_name_of_a_compressed_file(tmp_path, temporary, extension):
    path = tmp_path / f"a.csv{extension}"
    path.write_bytes(b"d,z,y,x,\xc3\xa9\n2,3,2,1,\n4,6,5,4,7\n")
    packing = spherepacking.read(path)
    assert packing.points.tolist() == [[1, 2, 3], [4, 5, 6]]
    assert packing["radius"].tolist() == [1, 2]
    assert np.isnan(packing["\u00e9"][0])
    path.write_bytes(b"x,y,z,r\n1,2,3,-4\n")
    with pytest.raises(spherepacking.PackingFileError) as caught:
        spherepacking.read(path)
    assert str(caught.value).startswith(f"{path}, line 2: found '-4' as radius")
    # A letter may be cut where the look at the file ends.
    path.write_bytes(b"#" + 4094 * b"a" + b"\xc3\xa9\nx,y,z,r\n1,2,3,4\n")
    assert spherepacking.read(path)["radius"].tolist() == [4]


def test_errors_have_the_name_that_the_user_knows(tmp_path, temporary):
    path = tmp_path / "a.spheres.gz"
    path.write_bytes(gzip.compress(b"0 0 0 1\n0 0 0 -1\n"))
    with pytest.raises(spherepacking.PackingFileError) as caught:
        spherepacking.read(path)
    assert str(caught.value).startswith(f"{path}, line 2: ")
    assert str(temporary) not in str(caught.value)


def test_files_that_name_others(tmp_path):
    (tmp_path / "a.vtm.gz").write_bytes(gzip.compress(b"<VTKFile/>"))
    with pytest.raises(spherepacking.PackingFileError, match="names others, expected it uncompr"):
        spherepacking.read(tmp_path / "a.vtm.gz")


@pytest.mark.parametrize("extension", COMPRESS)
def test_a_bomb_stops_where_there_is_no_room(tmp_path, temporary, monkeypatch, extension):
    path = tmp_path / f"a.spheres{extension}"
    path.write_bytes(COMPRESS[extension](b"0 0 0 1\n" * 4_000_000))
    assert path.stat().st_size < 1_000_000
    largest = []

    def usage(folder):
        largest.append(sum(file.stat().st_size for file in Path(folder).iterdir()))
        return SimpleNamespace(free=(80 << 20) - largest[-1])

    monkeypatch.setattr(shutil, "disk_usage", usage)
    with pytest.raises(
        spherepacking.PackingFileError, match=r"a\.spheres.*: found more than .*TMPDIR names"
    ):
        spherepacking.read(path)
    assert max(largest) <= 16 << 20


@pytest.mark.skipif(sys.version_info >= (3, 14), reason="Python 3.14 has it")
def test_a_missing_library_is_named(tmp_path, monkeypatch):
    path = tmp_path / "a.spheres.zst"
    path.write_bytes(zstandard(TEXT))
    monkeypatch.setitem(sys.modules, "zstandard", None)
    with pytest.raises(ImportError, match=r"a\.spheres\.zst: .*'spherepacking\[formats\]'"):
        spherepacking.read(path)


def test_ctrl_c_leaves_nothing(tmp_path, temporary):
    path = tmp_path / "a.spheres.gz"
    path.write_bytes(gzip.compress(b"0 0 0 1\n" * 3_000_000))
    code = """
import os, signal, sys, spherepacking
from spherepacking.files import compressed
copied = compressed._gzip_pieces
def pieces(path, source):
    for i, piece in enumerate(copied(path, source)):
        if i == 3:
            os.kill(os.getpid(), signal.SIGINT)
        yield piece
compressed._PIECES["gzip"] = pieces
try:
    spherepacking.read(sys.argv[1])
except KeyboardInterrupt:
    print("stopped", os.listdir(os.environ["TMPDIR"]))
"""
    done = subprocess.run(
        [sys.executable, "-c", code, str(path)],
        env=os.environ | {"TMPDIR": str(temporary)},
        capture_output=True,
        text=True,
        check=False,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),
    )
    assert (done.stdout, done.stderr) == ("stopped []\n", "")


def test_rows_of_xyzd_may_begin_like_a_compressed_file(tmp_path):
    rows = np.array([[1.0, 2.0, 3.0, 4.0]])
    data = bytearray(rows.tobytes())
    data[:3] = b"\x1f\x8b\x08"
    (tmp_path / "a.xyzd").write_bytes(data)
    assert compressed.compression_of(tmp_path / "a.xyzd") is None
    assert spherepacking.read(tmp_path / "a.xyzd")["radius"].tolist() == [2.0]
