"""MercuryDPM's .data: columns in three dimensions and two, domains, what it may be taken for."""

import pytest

FORMAT = 20005
ROW = "0.2 0.25 0.3 1 2 3 0.1 4 5 6 7 8 9 2 \n"
FLAT_ROW = "0.2 0.25 1 2 0.1 6 -9 2 \n"


@pytest.mark.parametrize("name", ["Run.data", "Run.data.0001", "Run.txt"])
def test_columns(read_text, name):
    packing = read_text("2 0.5 -1 -2 -3 4 5 6 \n" + ROW + ROW.replace("0.1", "1.5e-1"), name)
    assert packing.points.tolist() == [[0.2, 0.25, 0.3]] * 2
    assert packing["radius"].tolist() == [0.1, 0.15]
    assert packing["velocity"].tolist() == [[1, 2, 3]] * 2
    assert packing["angle"].tolist() == [[4, 5, 6]] * 2
    assert packing["angular_velocity"].tolist() == [[7, 8, 9]] * 2
    assert packing["info"].tolist() == [2, 2]
    data = packing.field_data
    assert data["TimeValue"].tolist() == [0.5]
    assert data["cell_vectors"].tolist() == [[5, 0, 0], [0, 7, 0], [0, 0, 9]]
    assert data["cell_origin"].tolist() == [-1, -2, -3]
    assert data["cell_periodic"].tolist() == [0, 0, 0]


def test_two_dimensions(read_text):
    packing = read_text("1 0.5 -1 -2 4 5 \n" + FLAT_ROW, "Run.data")
    assert packing.points.tolist() == [[0.2, 0.25, 0]]
    assert packing["radius"].tolist() == [0.1]
    assert [packing[name][0] for name in ("vx", "vy", "angle_z", "info")] == [1, 2, 6, 2]
    assert packing.field_data.keys() == ["TimeValue"]


def test_columns_that_a_program_adds(read_text):
    packing = read_text("1 0.5 0 0 0 1 1 1\n" + ROW.strip() + " 17\n", "Run.data")
    assert packing["info"].tolist() == [2]
    assert packing["column_15"].tolist() == [17]


@pytest.mark.parametrize(
    "text",
    [
        "2 0.5 1 0.25 0 0 0 0\n3 0.5 1 0.25 0 0 0 0\n",  # eight columns in all rows
        "0 0.5 1 0.25 7 7 7 7\n0 0.5 2 0.25 7 7 7 7\n",  # of which one could say no particles
        "1 0.5 0 0 1 1\n0 0.5 0 0 1 1\n",
    ],
)
def test_tables_are_no_steps(tmp_path, read_steps, text):
    (tmp_path / "p.data").write_text(text)
    times, _ = read_steps(tmp_path / "p.data")
    assert times == []


BAD = {
    "no header": (ROW, 1, "'0.2 0.25 0.3", "the number of particles, the time"),
    "no number": ("x 0 0 0 0 1 1 1\n" + ROW, 1, "'x 0 0", "the number of particles"),
    "no whole number": ("1.5 0 0 0 0 1 1 1\n" + ROW, 1, "'1.5 0 0", "the number of particles"),
    "no time": ("1 nan 0 0 0 1 1 1\n" + ROW, 1, "'1 nan", "the time"),
    "seven numbers": ("1 0 0 0 0 1 1\n" + ROW, 1, "'1 0 0", "the number of particles"),
    "too large": ("3 0 0 0 0 1 1 1\n" + ROW * 2, 1, "3 as the number of particles, but 2", "many"),
    "beyond all": (f"{10**15} 0 0 0 0 1 1 1\n" + ROW, 1, f"{10**15} as the number", "as many"),
    "too small": (
        "1 0 0 0 0 1 1 1\n" + ROW * 2,
        3,
        "'0.2 0.25",
        "of the domain after as many rows as line 1 says",
    ),
    "other columns": ("1 0 0 0 0 1 1 1\n" + FLAT_ROW, 2, "8 columns", "14 columns: x y z vx"),
    "bad number": ("1 0 0 0 0 1 1 1\n" + ROW.replace("0.1", "r"), 2, "'r' as radius", "a number"),
    "negative": ("1 0 0 0 0 1 1 1\n" + ROW.replace("0.1", "-1"), 2, "'-1' as rad", "not negative"),
    "cut": ("1 0 0 0 0 1 1 1\n" + ROW.strip(), 2, "the end of the file within", "a line end"),
}


@pytest.mark.parametrize("case", BAD, ids=[case.replace(" ", "-") for case in BAD])
def test_bad_mercury(read_error, tmp_path, case):
    text, line, found, expected = BAD[case]
    path = tmp_path / "p.data"
    path.write_text(text)
    message, code = read_error(path, fmt="MERCURY")
    assert message.startswith(f"{path}, line {line}: found ")
    assert found in message
    assert expected in message[message.index("expected") :]
    assert code == FORMAT
