"""LAMMPS and LIGGGHTS dumps: columns, boxes, time steps, counts."""

import numpy as np
import pytest

FORMAT = 20005


def step(time, columns, rows, *, count=None, bounds="pp pp pp", box=("0 10", "0 20", "-5 5")):
    return "\n".join(
        [
            "ITEM: TIMESTEP",
            str(time),
            "ITEM: NUMBER OF ATOMS",
            str(len(rows) if count is None else count),
            f"ITEM: BOX BOUNDS {bounds}",
            *box,
            f"ITEM: ATOMS {columns}",
            *rows,
            "",
        ]
    )


ROWS = ["1 1 A 0.5 1.5 2.5 0.25", "2 1 B 3.5 4.5 -5.5 0.75"]
COLUMNS = "id type element x y z radius"


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"], ids=["lf", "crlf", "cr"])
@pytest.mark.parametrize(
    "name", ["p.dump", "p.lammpstrj", "p.liggghts", "p.txt", "p.sph", "p.1000"]
)
def test_columns_and_names(read_text, name, end):
    packing = read_text(step(0, COLUMNS, ROWS).replace("\n", end), name)
    assert packing.points.tolist() == [[0.5, 1.5, 2.5], [3.5, 4.5, -5.5]]
    assert packing["radius"].tolist() == [0.25, 0.75]
    assert packing.point_data.keys() == ["radius", "id", "type", "element"]
    assert packing["id"].tolist() == [1, 2]


def test_diameters_are_halved(read_text):
    packing = read_text(step(0, "diameter z y x", ["3 1 2 4"]), "p.dump")
    assert packing["radius"].tolist() == [1.5]
    assert packing.points.tolist() == [[4, 2, 1]]


def test_unwrapped_centers(read_text):
    packing = read_text(step(0, "xu yu zu radius", ["11 22 33 1"]), "p.dump")
    assert packing.points.tolist() == [[11, 22, 33]]


def test_plain_centers_come_before_scaled_ones(read_text):
    packing = read_text(step(0, "xs ys zs radius x y z", ["0.5 0.5 0.5 1 7 8 9"]), "p.dump")
    assert packing.points.tolist() == [[7, 8, 9]]
    assert packing["xs"].tolist() == [0.5]


@pytest.mark.parametrize("single", [False, True])
@pytest.mark.parametrize("family", ["xs ys zs", "xsu ysu zsu"])
def test_scaled_centers_in_a_straight_box(read_text, family, single):
    text = step(0, f"id {family} radius", ["1 0.25 0.5 0.1 2"])
    packing = read_text(text, "p.dump", single=single)
    expected = np.array([0.25 * 10, 0.5 * 20, -5 + 0.1 * 10])
    assert packing.points.tolist() == [expected.astype(np.float32 if single else float).tolist()]


def test_scaled_centers_in_a_tilted_box(read_text):
    # By the LAMMPS manual, "Triclinic simulation boxes": bounds hold the corners of the box.
    low, high, xy, xz, yz = np.array([0.0, 1, -1]), np.array([10.0, 21, 4]), 3.0, -2.0, 1.5
    size = high - low
    corners = [
        low + np.array([size[0] * i + xy * j + xz * k, size[1] * j + yz * k, size[2] * k])
        for i in (0, 1)
        for j in (0, 1)
        for k in (0, 1)
    ]
    least, most = np.min(corners, axis=0), np.max(corners, axis=0)
    box = [f"{least[i]} {most[i]} {tilt}" for i, tilt in enumerate((xy, xz, yz))]
    fractions = np.array([0.25, 0.5, 0.75])
    rows = [" ".join(map(str, [*fractions, 1]))]
    text = step(0, "xs ys zs radius", rows, bounds="xy xz yz pp pp pp", box=box)
    edges = np.array([[10, 0, 0], [xy, 20, 0], [xz, yz, 5]])
    expected = low + fractions @ edges
    np.testing.assert_allclose(read_text(text, "p.dump").points[0], expected, rtol=1e-15)


def test_scaled_centers_in_a_general_box(read_text):
    box = ["1 2 3 10", "-1 1 0 20", "0 1 4 30"]
    text = step(0, "xs ys zs radius", ["0.5 0.25 2 1"], bounds="abc origin pp pp pp", box=box)
    edges = np.array([[1, 2, 3], [-1, 1, 0], [0, 1, 4]])
    expected = [10, 20, 30] + np.array([0.5, 0.25, 2]) @ edges
    assert read_text(text, "p.dump").points.tolist() == [expected.tolist()]


def many_steps():
    times = [0, 0.5, 1, 1.5]
    parts = ["ITEM: UNITS\nsi\nITEM: TIME\n0.0\n"]
    for i, time in enumerate(times):
        rows = [f"{k} {i} {k} 0 {0.1 + k}" for k in range(i + 1)]
        number = round(1000 * time)
        parts.append(step(number, "id x y z radius", rows) + f"ITEM: TIME\n{time + 0.5}\n")
    return times, "".join(parts)


def test_the_first_step_is_the_default(read_text):
    assert read_text(many_steps()[1], "p.dump").n_points == 1


@pytest.mark.parametrize(
    ("request_time", "chosen"), [(-1, 0), (0, 0), (0.499, 0), (0.5, 1), (1.7, 3)]
)
def test_time_steps(tmp_path, request_time, chosen, reader_for):
    import pyvista as pv

    times, text = many_steps()
    path = tmp_path / "p.dump"
    path.write_text(text)
    reader = reader_for(path)
    reader.UpdateInformation()
    info = reader.GetOutputInformation(0)
    executive = reader.GetExecutive()
    assert [info.Get(executive.TIME_STEPS(), i) for i in range(4)] == times
    assert [info.Get(executive.TIME_RANGE(), i) for i in range(2)] == [0, 1.5]
    reader.UpdateTimeStep(request_time)
    packing = pv.wrap(reader.GetOutput())
    assert reader.GetErrorMessage() == ""
    assert packing.n_points == chosen + 1
    assert packing.points[:, 0].tolist() == [chosen] * (chosen + 1)
    assert packing.GetInformation().Get(packing.DATA_TIME_STEP()) == times[chosen]


def test_steps_longer_than_a_block_of_the_search(read_text, read_error, tmp_path, reader_for):
    # Titles lie at, before and after the cuts of 16 MiB; each step has another number of atoms.
    rng = np.random.default_rng(3)
    counts = rng.integers(60000, 400000, 6)
    row = "1.25 2.5 3.75 0.5" + "0" * 41
    text = "".join(step(i, "x y z radius", [row] * n) for i, n in enumerate(counts))
    pad = 16 * 2**20 - text.rindex("ITEM: TIMESTEP", 0, 16 * 2**20)
    texts = [text]
    for shift in (-1, 0, 1, 7, 15, 20):  # the title of one step across the cut
        texts.append(" " * 0 + "ITEM: UNITS\n" + "s" * (pad - 13 - shift) + "\n" + text)
    for number, content in enumerate(texts):
        path = tmp_path / f"{number}.dump"
        path.write_text(content)
        for i in (0, len(counts) - 1):
            reader = reader_for(path)
            reader.UpdateInformation()
            reader.UpdateTimeStep(i)
            assert reader.GetErrorMessage() == ""
            assert reader.GetOutput().GetNumberOfPoints() == counts[i]
    bad = content[: content.rindex(row)] + "1 2 x 4\n"
    path.write_text(bad)
    reader = reader_for(path)
    reader.AddObserver("ErrorEvent", lambda *_: None)
    reader.UpdateInformation()
    reader.UpdateTimeStep(len(counts) - 1)
    line = bad.count("\n")
    assert f"line {line}: found 'x' as z" in reader.GetErrorMessage()


def test_a_file_that_changes_is_searched_again(tmp_path, reader_for):
    path = tmp_path / "p.dump"
    path.write_text(step(0, COLUMNS, ROWS))
    reader = reader_for(path)
    reader.Update()
    assert reader.GetOutput().GetNumberOfPoints() == 2
    path.write_text("ITEM: UNITS\nlj\n" + step(7, COLUMNS, ROWS + ROWS))
    reader.Modified()
    reader.Update()
    assert reader.GetErrorMessage() == ""
    assert reader.GetOutput().GetNumberOfPoints() == 4


BAD = {
    "too few atoms": (
        step(0, COLUMNS, ROWS, count=3),
        4,
        "3 as the number of atoms, but 2",
        "as many",
    ),
    "too many atoms": (
        step(0, COLUMNS, ROWS, count=1),
        4,
        "1 as the number of atoms, but 2",
        "as many",
    ),
    "no count": (step(0, COLUMNS, ROWS, count="x"), 4, "'x'", "the number of atoms"),
    "negative count": (step(0, COLUMNS, ROWS, count=-2), 4, "'-2'", "the number of atoms"),
    "no radius": (
        step(0, "id x y z", ["1 2 3 4"]),
        9,
        "'ITEM: ATOMS id x y z'",
        "radius or diameter",
    ),
    "no centre": (
        step(0, "id x y radius", ["1 2 3 4"]),
        9,
        "'ITEM: ATOMS id x y radius'",
        "x, y, z",
    ),
    "mixed centres": (
        step(0, "x yu zs radius", ["1 2 3 4"]),
        9,
        "'ITEM: ATOMS x yu zs radius'",
        "x, y, z",
    ),
    "bad row": (
        step(0, COLUMNS, [ROWS[0], "2 1 B 3.5 q 5 1"]),
        11,
        "'q' as y in column 5",
        "a number",
    ),
    "nan": (step(0, COLUMNS, ["2 1 B nan 1 5 1"]), 10, "'nan' as x in column 4", "a finite number"),
    "short row": (
        step(0, COLUMNS, ["2 1 B 3.5"]),
        10,
        "4 columns '2 1 B 3.5'",
        "7 columns: id type",
    ),
    "bad box": (step(0, COLUMNS, ROWS, box=("0 1", "a b", "0 1")), 7, "'a b'", "bound the box"),
    "unequal box": (
        step(0, COLUMNS, ROWS, box=("0 1", "0 1 2", "0 1")),
        7,
        "'0 1 2'",
        "bound the box",
    ),
    "no time": ("ITEM: TIMESTEP\nsoon\n" + step(0, COLUMNS, ROWS), 2, "'soon'", "the time step"),
    "cut short": (step(0, COLUMNS, ROWS)[:60], 5, "end of the file within 'ITEM: BOX", "ITEM: AT"),
    "no box": (step(0, COLUMNS, ROWS)[:67], 5, "end of the step", "bound the box"),
    "names cut": (
        step(0, COLUMNS, [], box=("0 1",) * 3)[:-4],
        9,
        "end of the file within",
        "ITEM: AT",
    ),
    "no step": ("ITEM: NUMBER OF ATOMS\n2\n", 1, "'ITEM: NUMBER OF ATOMS'", "ITEM: TIMESTEP"),
    "no such item": (
        step(0, COLUMNS, ROWS).replace("ITEM: BOX", "BOX"),
        5,
        "'BOX BOUNDS pp pp pp'",
        "ITEM:",
    ),
    "huge box": (
        step(0, "xs ys zs radius", ["9 9 9 1"], box=("0 1e308",) * 3),
        10,
        "beyond all numbers as x",
        "a finite number",
    ),
}


@pytest.mark.parametrize("case", BAD, ids=[case.replace(" ", "-") for case in BAD])
def test_bad_dump(read_error, tmp_path, case):
    text, line, found, expected = BAD[case]
    path = tmp_path / "p.dump"
    path.write_text(text)
    message, code = read_error(path)
    assert message.startswith(f"{path}, line {line}: found ")
    assert found in message
    assert expected in message[message.index("expected") :]
    assert code == FORMAT


def test_fractions_without_a_box(read_error, tmp_path):
    text = step(0, "xs ys zs radius", ["1 1 1 1"])
    lines = [line for i, line in enumerate(text.split("\n")) if i not in (4, 5, 6, 7)]
    (tmp_path / "p.dump").write_text("\n".join(lines))
    message, _ = read_error(tmp_path / "p.dump")
    assert "line 5: found centres as fractions of the box, expected ITEM: BOX BOUNDS" in message


def test_the_cell(read_text):
    packing = read_text(step(0, COLUMNS, ROWS, bounds="pp ff ps"), "p.dump")
    assert packing.field_data["cell_vectors"].tolist() == [[10, 0, 0], [0, 20, 0], [0, 0, 10]]
    assert packing.field_data["cell_origin"].tolist() == [0, 0, -5]
    assert packing.field_data["cell_periodic"].tolist() == [1, 0, 0]


def test_a_tilted_cell(read_text):
    # The bounds are those of the box around the tilted cell (LAMMPS manual, "Triclinic boxes").
    text = step(
        0, COLUMNS, ROWS, bounds="xy xz yz ff pp pp", box=("-2 13 3", "1 22.5 -2", "-1 4 1.5")
    )
    data = read_text(text, "p.dump").field_data
    assert data["cell_vectors"].tolist() == [[10, 0, 0], [3, 20, 0], [-2, 1.5, 5]]
    assert data["cell_origin"].tolist() == [0, 1, -1]
    assert data["cell_periodic"].tolist() == [0, 1, 1]


def test_a_general_cell(read_text):
    box = ["1 2 3 10", "-1 1 0 20", "0 1 4 30"]
    text = step(0, COLUMNS, ROWS, bounds="abc origin pp ff pp", box=box)
    data = read_text(text, "p.dump").field_data
    assert data["cell_vectors"].tolist() == [[1, 2, 3], [-1, 1, 0], [0, 1, 4]]
    assert data["cell_origin"].tolist() == [10, 20, 30]
    assert data["cell_periodic"].tolist() == [1, 0, 1]


@pytest.mark.parametrize("bounds", ["", "xy xz yz"])
def test_without_flags_a_cell_is_not_periodic(read_text, bounds):
    box = ["0 1 0" if bounds else "0 1"] * 3
    packing = read_text(step(0, COLUMNS, ROWS, bounds=bounds, box=box), "p.dump")
    assert packing.field_data["cell_periodic"].tolist() == [0, 0, 0]
    assert packing.field_data["cell_vectors"].ravel().tolist() == [1, 0, 0, 0, 1, 0, 0, 0, 1]


def test_no_atoms(tmp_path, read_steps):
    (tmp_path / "p.dump").write_text(step(0, COLUMNS, []) + step(5, COLUMNS, ROWS))
    times, (empty, full) = read_steps(tmp_path / "p.dump")
    assert times == [0, 5]
    assert empty.n_points == empty.n_cells == 0
    assert empty.point_data.keys() == ["radius", "id", "type", "element"]
    assert empty.field_data["cell_vectors"].shape == (3, 3)
    assert full.n_points == 2


def test_labels(read_text):
    # Dumps have no comments, and no separators but blanks.
    rows = ["1 Fe#2 1 2 3 0.5", "2 a,b;c 4 5 6 0.25", "# a remark of a job script", "3 O 7 8 9 1"]
    text = step(0, "id typelabel x y z radius", rows, count=3)
    packing = read_text(text, "p.dump")
    assert packing["typelabel"].tolist() == ["Fe#2", "a,b;c", "O"]
    assert packing.points[:, 0].tolist() == [1, 4, 7]


def test_a_column_that_turns_to_text_in_a_later_block(read_text):
    rows = ["1.5 2.5 3.5 0.5 7"] * 1_100_000  # 20 MB, of which a block is 16 MiB
    rows[-1] = "1.5 2.5 3.5 0.5 seven"
    packing = read_text(step(0, "x y z radius name", rows), "p.dump")
    assert packing["name"][[0, -2, -1]].tolist() == ["7", "7", "seven"]
    assert packing["radius"].tolist() == [0.5] * len(rows)


def test_a_header_longer_than_a_block(read_text):
    count = 30_000
    names = " ".join(f"{'c' * 600}{i:07}" for i in range(count))  # 18 MB
    numbers = " 1" * count
    text = step(0, f"x y z radius {names}", [f"1 2 3 0.5{numbers}"])
    packing = read_text(text, "p.dump")
    assert packing.points.tolist() == [[1, 2, 3]]
    assert packing["c" * 600 + "0029999"].tolist() == [1]


def test_without_radii(read_text):
    text = step(0, "id x y z", ["1 2 3 4"])
    packing = read_text(text, "p.dump", optional=True)
    assert packing.points.tolist() == [[2, 3, 4]]
    assert packing.point_data.keys() == ["id"]


def test_a_count_of_atoms_that_no_file_holds(read_error, tmp_path):
    # Memory for so many would be refused, or taken.
    (tmp_path / "p.dump").write_text(step(0, COLUMNS, ROWS, count=10**15))
    message, _ = read_error(tmp_path / "p.dump")
    assert "line 4: found 1000000000000000 as the number of atoms, but 2 lines" in message


def test_rows_too_short_for_the_file_to_hold_their_columns(read_error, tmp_path):
    names = " ".join(f"c{i}" for i in range(100))
    rows = ["1 2 3 4 " + "5 " * 100] + ["1 2 3"] * 4
    (tmp_path / "p.dump").write_text(step(0, f"x y z radius {names}", rows))
    message, _ = read_error(tmp_path / "p.dump")
    assert "line 11: found 3 columns '1 2 3', expected 104 columns" in message


def test_a_dump_in_yaml(read_error, tmp_path):
    path = tmp_path / "dump.yaml"
    path.write_text("---\ncreator: LAMMPS\ntimestep: 0\n")
    message, code = read_error(path)
    assert message == (
        f"{path}, line 1: found a dump of LAMMPS in YAML, "
        "expected one in text, as dump custom writes"
    )
    assert code == FORMAT
