"""Snapshots of ESyS-Particle: the header with its parts, a part by itself, bad ones."""

import numpy as np
import pytest

FORMAT = 20005
HEADER = """V {version}
200
0.01
100
ESyS-Particle_2.3.4_bzr_rev.
BoundingBox 0 -1 -2 10 9 8
PeriodicBoundaries 1 0 0
Dimension 3D
/somewhere/else/snap_t=100_1.txt /somewhere/else/snap_t=100_2.txt
"""
BONDS = "1\nBonded\n1\n1 2 3\n"


def row(number, columns):
    """A particle whose numbers say where they stand; id 5 and radius are as they should be."""
    values = [100 * number + i for i in range(columns)]
    values[3], values[4] = 0.25 * number, number
    return " ".join(map(str, values)) + "\n"


def part(numbers, columns):
    return f"{len(numbers)}\n" + "".join(row(i, columns) for i in numbers) + BONDS


@pytest.mark.parametrize("columns", [19, 22, 26, 29])
def test_a_part(read_text, columns):
    packing = read_text(part([1, 2], columns), "snap_t=100_1.txt")
    assert packing.points.tolist() == [[100, 101, 102], [200, 201, 202]]
    assert packing["radius"].tolist() == [0.25, 0.5]
    assert packing["id"].tolist() == [1, 2]
    assert packing["initial_position"][0].tolist() == [107, 108, 109]
    assert packing["old_position"][0].tolist() == [110, 111, 112]
    assert packing["velocity"][0].tolist() == [113, 114, 115]
    assert packing["force"][0].tolist() == [116, 117, 118]
    assert ("circular_shift" in packing.point_data) == (columns in (22, 29))
    assert ("angular_velocity" in packing.point_data) == (columns >= 26)
    if columns >= 26:
        at = 100 + columns
        assert packing["angular_velocity"][0].tolist() == [at - 3, at - 2, at - 1]
        assert packing["q0"][0] == at - 7


@pytest.mark.parametrize("parts", [([1, 2, 3], [4, 5]), ([], [4]), ([1], [])])
def test_a_snapshot(tmp_path, read, parts):
    (tmp_path / "snap_t=100_0.txt").write_text(HEADER.format(version=3))
    for i, numbers in enumerate(parts):
        (tmp_path / f"snap_t=100_{i + 1}.txt").write_text(part(numbers, 29))
    packing = read(tmp_path / "snap_t=100_0.txt")
    assert packing["id"].tolist() == [*parts[0], *parts[1]]
    assert packing["radius"].tolist() == (0.25 * np.array([*parts[0], *parts[1]])).tolist()
    assert packing.field_data["cell_vectors"].tolist() == np.diag([10.0, 10, 10]).tolist()
    assert packing.field_data["cell_origin"].tolist() == [0, -1, -2]
    assert packing.field_data["cell_periodic"].tolist() == [1, 0, 0]
    assert packing.field_data["TimeValue"].tolist() == [100]


BAD = {
    "too large": ("9\n" + row(1, 29), ", line 1: found 9 as the number of particles, but 1 lines"),
    "beyond all": (f"{10**15}\n" + row(1, 29), f", line 1: found {10**15} as the number"),
    "too small": ("1\n" + row(1, 29) + row(2, 29), ", line 3: found '200 201"),
    "columns": ("1\n1 2 3 4 5\n", ", line 2: found '1 2 3 4 5', expected 19, 22, 26 or 29 columns"),
    "short row": ("2\n" + row(1, 29) + row(2, 22), ", line 3: found 22 columns"),
    "bad number": ("1\n" + row(1, 29).replace("102", "z"), ", line 2: found 'z' as z in column 3"),
    "text": ("1\n" + row(1, 29).replace("105", "t"), ": holds a row with text, expected numbers"),
    "no files": ("V 3\n1 2 3\nBoundingBox 0 0 0 1 1 1\n", ": holds no names of files, expected"),
    "box": ("V 3\n1 2 3\nBoundingBox 0 0\n", ", line 3: found 'BoundingBox 0 0', expected the num"),
    "no part": (HEADER.format(version=3), "found no such file"),
}


@pytest.mark.parametrize("case", BAD, ids=[case.replace(" ", "-") for case in BAD])
def test_bad_snapshot(read_error, tmp_path, case):
    text, found = BAD[case]
    path = tmp_path / "snap_t=100_0.txt"
    path.write_text(text)
    message, _ = read_error(path, fmt="ESYS")
    assert found in message
    assert "expected" in message
