"""Snapshots of ESyS-Particle: a head and the files of its workers, as version 2.3.5 writes them."""

import numpy as np
import pytest

HEAD = """V 3
300
0.001
250
ESyS-Particle_2.3.4_bzr_rev.\x20
BoundingBox -10 -10 -10 10 10 12
PeriodicBoundaries 1 0 0
Dimension 3D
run_t=250_1.txt run_t=250_2.txt"""
FIRST = """2
-0.55 1 2 0.6 9 -1 1 -1 1 2 -0.7 1 2 3 0 0 0 0 0 0 0 0
-9.55 3 6 0.8 7 4 1.5 9.7 3 6 -9.8 3 6 5 0 0 0.25 0 0 -20 0 0
0
TMIG 0
"""
SECOND = "1\n9.75 0 0.333333333 0.5 10 -1 1 -9.5 0 0 10 0 0 -5 0 0 0 0 0 20 0 0\n0\nTMIG 0\n"
# One row of a particle that rotates.
ROTATING = (
    "1\n-0.1 1 2 0.6 9 -1 1 -1 1 2 -0.25 1 2 3 0 0 0 0 0 0 0 0 0.998425413 0.0149921261 "
    "0.0299842521 0.0449763782 0.1 0.2 0.3\n0\nTMIG 0\n"
)


def write(folder, head=HEAD, first=FIRST, second=SECOND):
    (folder / "run_t=250_0.txt").write_text(head)
    for number, text in enumerate((first, second), 1):
        if text is not None:
            (folder / f"run_t=250_{number}.txt").write_text(text)
    return folder / "run_t=250_0.txt"


@pytest.mark.parametrize("chunk", [None, 1])
def test_particles_of_all_workers(read, tmp_path, chunk):
    packing = read(write(tmp_path), chunk=chunk)
    assert packing.points.tolist() == [[-0.55, 1, 2], [-9.55, 3, 6], [9.75, 0, 0.333333333]]
    assert packing["radius"].tolist() == [0.6, 0.8, 0.5]
    assert packing["id"].tolist() == [9, 7, 10]
    assert packing["tag"].tolist() == [-1, 4, -1]
    assert packing["mass"].tolist() == [1, 1.5, 1]
    assert packing["velocity"].tolist() == [[3, 0, 0], [5, 0, 0], [-5, 0, 0]]
    assert packing["force"].tolist() == [[0, 0, 0], [0.25, 0, 0], [0, 0, 0]]
    assert packing["initial_position"].tolist() == [[-1, 1, 2], [9.7, 3, 6], [-9.5, 0, 0]]
    assert packing["circular_shift"].tolist() == [[0, 0, 0], [-20, 0, 0], [20, 0, 0]]
    assert "q0" not in packing.point_data
    assert packing.field_data["cell_vectors"].tolist() == [[20, 0, 0], [0, 20, 0], [0, 0, 22]]
    assert packing.field_data["cell_origin"].tolist() == [-10, -10, -10]
    assert packing.field_data["cell_periodic"].tolist() == [1, 0, 0]
    assert packing.field_data["TimeValue"].tolist() == [0.25]


def test_single_precision(read, tmp_path):
    packing = read(write(tmp_path), single=True)
    assert packing["radius"].tolist() == np.float32([0.6, 0.8, 0.5]).tolist()


def test_particles_that_rotate_and_a_worker_without_any(read, tmp_path):
    packing = read(write(tmp_path, first="0\n0\nTMIG 0\n", second=ROTATING))
    assert packing["radius"].tolist() == [0.6]
    assert packing["q0"].tolist() == [0.998425413]
    assert packing["angular_velocity"].tolist() == [[0.1, 0.2, 0.3]]


def test_folders_of_the_run_do_not_matter(read, tmp_path):
    head = HEAD.replace("run_t=250_1", "/scratch/run_t=250_1").replace(" run_t", " ../out/run_t")
    assert read(write(tmp_path, head)).n_points == 3


def test_program_that_names_two_words_and_a_geometry(read, tmp_path):
    head = HEAD.replace("bzr_rev. ", "bzr_rev. 1185")
    assert read(write(tmp_path, head)).n_points == 3


BAD_HEADS = {
    "version": (HEAD.replace("V 3", "V 2"), 1, "'V 2'", "V 3"),
    "time step": (HEAD.replace("\n250\n", "\nsoon\n"), 4, "'soon'", "number of the time step"),
    "box": (HEAD.replace("10 12", "10"), 6, "'BoundingBox", "6 numbers"),
    "periodic": (HEAD.replace("s 1 0 0", "s 2 0 0"), 7, "'PeriodicB", "0 or 1"),
    "cut": (HEAD.partition("\nDim")[0], 7, "the end of the file", "Dimension"),
    "no files": (HEAD.partition("run_t")[0] + "\n", 9, "''", "names of the files"),
    "missing": (HEAD + " run_t=250_3.txt", 9, "'run_t=250_3.txt'", "beside this one"),
    "twice": (HEAD + " run_t=250_1.txt", 9, "'run_t=250_1.txt' twice", "once"),
}


@pytest.mark.parametrize("name", BAD_HEADS)
def test_bad_head(read_error, tmp_path, name):
    head, line, found, expected = BAD_HEADS[name]
    path = write(tmp_path, head)
    message, _ = read_error(path, fmt="ESYS")
    assert message.startswith(f"{path}, line {line}: found {found}")
    assert expected in message


def test_a_head_cut_at_every_byte(reader_for, tmp_path):
    for length in range(1, len(HEAD)):
        reader = reader_for(write(tmp_path, HEAD[:length]), fmt="ESYS")
        reader.AddObserver("ErrorEvent", lambda *_: None)
        reader.Update()
        assert reader.GetErrorMessage() != "", HEAD[:length]
    reader.SetFileName(str(write(tmp_path, HEAD.replace(" run_t=250_2.txt", ""))))
    reader.Update()
    assert "line 9: found 1 files of particles, but 'run_t=250_2.txt' beside" in (
        reader.GetErrorMessage()
    )


def test_particles_cut_at_every_byte(reader_for, tmp_path):
    """Bonds and what more may be missing behind the particles do not matter."""
    rows = FIRST.index("0\nTMIG")
    for length in range(len(FIRST)):
        reader = reader_for(write(tmp_path, first=FIRST[:length]))
        reader.AddObserver("ErrorEvent", lambda *_: None)
        reader.Update()
        assert (reader.GetErrorMessage() == "") == (length >= rows), FIRST[:length]


BAD_WORKERS = {
    "count": (FIRST.replace("2\n", "5\n", 1), 1, "5 as the number of particles", "as many"),
    "huge": (FIRST.replace("2\n", "99999999999999\n", 1), 1, "99999999999999", "room"),
    "no count": (FIRST.replace("2\n", "two\n", 1), 1, "'two'", "number of particles"),
    "radius": (FIRST.replace(" 0.8 ", " -0.8 "), 3, "'-0.8' as radius", "not negative"),
    "nan": (FIRST.replace(" 0.8 ", " nan "), 3, "'nan' as radius", "finite"),
    "few columns": (FIRST.replace(" -20 0 0", ""), 3, "19 columns", "22 columns"),
    "more": (FIRST.replace("2\n", "1\n", 1), 3, "'-9.55 3 6 0.8", "groups of bonds"),
    "cut": (FIRST[:100], 3, "the end of the file within the row", "line end"),
}


@pytest.mark.parametrize("name", BAD_WORKERS)
def test_bad_particles(read_error, tmp_path, name):
    first, line, found, expected = BAD_WORKERS[name]
    path = write(tmp_path, first=first)
    message, _ = read_error(path)
    assert message.startswith(f"{path.parent / 'run_t=250_1.txt'}, line {line}: found {found}")
    assert expected in message


def test_particles_of_one_worker_alone(read_error, tmp_path):
    write(tmp_path)
    for text in (FIRST, ROTATING):
        path = tmp_path / "run_t=250_1.txt"
        path.write_text(text)
        message, _ = read_error(path)
        assert message.startswith(f"{path}, line 1: found the particles of one worker")
        assert "NAME_0.txt" in message


def test_words_among_the_numbers(read_error, tmp_path):
    message, _ = read_error(write(tmp_path, first=FIRST.replace(" 1.5 ", " heavy ")))
    assert "run_t=250_1.txt" in message
    assert "found words" in message


def test_other_numbers_of_columns(read_error, tmp_path):
    # A run has particles of one kind.
    message, _ = read_error(write(tmp_path, second=ROTATING))
    assert "run_t=250_1.txt, line 2: found 22 columns" in message
