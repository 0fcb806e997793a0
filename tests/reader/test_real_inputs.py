"""Packings of other projects, and small ones like them, against readers in plain Python."""

import numpy as np
import pytest

# How many spheres each file has.
COUNTS = {
    "clump.csv": 12,
    "deme_TeddyBear.csv": 18,
    "atoms.xyzr": 48,
    "voronota_3dlb.xyzr": 9745,
    "helix.pqr": 60,
    "apbs_membrane-helix-8.pqr": 317,
    "chain.pqr": 40,
    "apbs_achbp.pqr": 16090,
    "equal.xyzd": 216,
    "packgen_packing.xyzd": 10000,
}


def check(packing, rows):
    rows = np.array(rows)
    assert packing.points.tolist() == rows[:, :3].tolist()
    assert packing["radius"].tolist() == rows[:, 3].tolist()


def test_deme_csv(read, data_file):
    path = data_file("clump.csv")
    rows = [[float(v) for v in line.split(",")] for line in path.read_text().split()[1:]]
    assert len(rows) == COUNTS[path.name]
    check(read(path), rows)


def test_cellpack_sphere_tree(read, data_file):
    path = data_file("tree.sph")
    lines = [line.split() for line in path.read_text().splitlines()]
    rows = [[float(v) for v in line] for line in lines if len(line) == 4 and line[0] != "#"]
    packing = read(path)
    check(packing, rows)
    assert packing["level"].tolist() == [1] + [2] * 3 + [3] * 12
    assert packing["level"].dtype == np.int32


def test_voronota_xyzr(read, data_file):
    path = data_file("atoms.xyzr")
    lines = [line.split() for line in path.read_text().splitlines()]
    assert len(lines) == COUNTS[path.name]
    packing = read(path)
    check(packing, [[float(v) for v in line[3:]] for line in lines])
    assert packing["column_2"].tolist() == [float(line[1]) for line in lines]


@pytest.mark.parametrize("name", ["chain.pqr", "helix.pqr"])
def test_apbs_pqr(read, data_file, name):
    path = data_file(name)
    lines = [line.split() for line in path.read_text().splitlines()]
    lines = [line for line in lines if line[0] in ("ATOM", "HETATM")]
    assert len(lines) == COUNTS[path.name]
    packing = read(path)
    check(packing, [[float(line[i]) for i in (-5, -4, -3, -1)] for line in lines])
    assert packing["charge"].tolist() == [float(line[-2]) for line in lines]


def test_packgen_xyzd(read, data_file, tmp_path):
    path = data_file("equal.xyzd")
    rows = np.fromfile(path, "<f8").reshape(-1, 4)
    assert len(rows) == COUNTS[path.name]
    rows[:, 3] /= 2
    check(read(path), rows)  # its .nfo leaves the diameters as they are

    copy = tmp_path / "copy.xyzd"
    copy.write_bytes(path.read_bytes())
    check(read(copy), rows)  # no .nfo
    (tmp_path / "copy.nfo").write_text(
        f"N: {len(rows)}\n Theoretical Porosity: 0.36\nFinal Porosity: 0.488 (Tolerance: 1.0001)\n"
    )
    scaled = read(copy)
    assert scaled.points.tolist() == rows[:, :3].tolist()
    np.testing.assert_allclose(scaled["radius"], rows[:, 3] * 0.8 ** (1 / 3), rtol=4e-16)


def test_single_precision_is_the_rounded_double(read, data_file):
    path = data_file("equal.xyzd")
    double, single = read(path), read(path, single=True)
    assert single.points.dtype == np.float32
    assert (single.points == double.points.astype(np.float32)).all()
    assert (single["radius"] == double["radius"].astype(np.float32)).all()


def test_a_mesh_is_no_packing(read_error, data_file):
    message, _ = read_error(data_file("blob.off"))
    assert "line 1: found 'OFF', which is neither a row of numbers nor a header" in message


def test_an_archive_is_no_packing(read_error, data_file):
    message, _ = read_error(data_file("positions.npz"))
    assert "line 1: found 'PK" in message
