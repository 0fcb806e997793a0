"""Steps in one file or in many: ``spherepacking.steps`` and ``read(step=…, time=…)``."""

import gzip
import json
from time import perf_counter, sleep

import numpy as np
import pytest
import pyvista as pv
import spherepacking

HEAD = """ITEM: TIMESTEP
{step}
ITEM: NUMBER OF ATOMS
1
ITEM: BOX BOUNDS pp pp pp
0 1
0 1
0 1
ITEM: ATOMS id x y z {radius}
"""
DUMP = HEAD.replace("{radius}", "radius") + "1 {x} 0 0 0.5\n"


@pytest.fixture
def dump(tmp_path):
    path = tmp_path / "run.dump"
    path.write_text("".join(DUMP.format(step=10 * i, x=i) for i in range(5)))
    return path


def vtu(path, x, **arrays):
    mesh = pv.PolyData(np.array([[x, 0.0, 0.0]])).cast_to_unstructured_grid()
    mesh["radius"] = [0.5]
    for name, values in arrays.items():
        mesh[name] = values
    mesh.save(path)
    return path


def xs(steps):
    return [packing.points[0, 0] for packing in steps]


# --- one file -------------------------------------------------------------------------------------


def test_a_sequence(dump):
    steps = spherepacking.steps(dump)
    assert isinstance(steps, spherepacking.PackingSteps)
    assert len(steps) == 5
    assert steps.times == [0.0, 10.0, 20.0, 30.0, 40.0]
    assert xs(steps) == xs(list(steps)) == [0, 1, 2, 3, 4]
    assert steps[-1].points[0, 0] == 4.0
    some = steps[1::2]
    assert (len(some), some.times, xs(some)) == (2, [10.0, 30.0], [1, 3])
    assert xs(steps[::-1][:2]) == [4, 3]
    assert repr(some) == f"<2 steps of {dump}>"
    with pytest.raises(IndexError):
        steps[5]


def test_what_is_handed_out_belongs_to_nobody_else(dump):
    steps = spherepacking.steps(dump)
    first, again = steps[0], steps[0]
    first.points[:] = 9.0
    first["radius"][:] = 9.0
    assert again.points[0, 0] == steps[0].points[0, 0] == 0.0
    assert again["radius"].tolist() == steps[0]["radius"].tolist() == [0.5]


def seconds_per_step(steps):
    """The least time of three in which each of 50 steps was read."""
    every = max(1, len(steps) // 50)
    found = []
    for _ in range(3):
        start = perf_counter()
        for i in range(0, 50 * every, every):
            assert steps[i].points[0, 0] == i
        found.append((perf_counter() - start) / 50)
    return min(found)


XYZ = "1\nProperties=species:S:1:pos:R:3:radius:R:1 Time={step}\nC {x} 0 0 0.5\n"
MERCURY = "1 {step} 0 0 0 9 9 9\n{x} 0 0 0 0 0 0.5 0 0 0 0 0 0 0\n"


@pytest.mark.parametrize(
    ("name", "text"), [("a.dump", DUMP), ("a.xyz", XYZ), ("a.data", MERCURY)], ids=["d", "x", "m"]
)
def test_a_step_of_a_long_run_takes_no_longer(tmp_path, name, text):
    runs = []
    for count in (200, 40_000):
        path = tmp_path / f"{count}_{name}"
        path.write_text("".join(text.format(step=10 * i, x=i) for i in range(count)))
        runs.append(path)
    sleep(2.1)  # a file that was written just now is looked at again
    short, long = (seconds_per_step(spherepacking.steps(path)) for path in runs)
    assert long < 2.5 * short


def test_a_run_that_goes_on_while_it_is_read(dump):
    reader = pv.get_reader(dump)
    reader.set_active_time_point(4)
    assert reader.read().points[0, 0] == 4.0
    # A restart repeats the times, so that VTK calls the steps by other numbers.
    with dump.open("a") as file:
        file.write("".join(DUMP.format(step=10 * i, x=100 + i) for i in range(2)))
    reader.reader.Modified()
    assert reader.number_time_points == 7
    assert reader.time_values == [0.0, 10.0, 20.0, 30.0, 40.0, 0.0, 10.0]
    assert reader.read().points[0, 0] == 4.0
    reader.set_active_time_point(6)
    assert reader.read().points[0, 0] == 101.0
    with pytest.raises(ValueError, match=r"time points 0, 5"):
        reader.set_active_time_value(0.0)
    reader.set_active_time_value(30)
    assert reader.active_time_value == 30.0
    assert reader.read().points[0, 0] == 3.0
    for nothing in (7.0, float("nan"), "30", None, [30.0]):
        with pytest.raises(ValueError, match="time_value: found"):
            reader.set_active_time_value(nothing)


@pytest.mark.parametrize(
    ("which", "x"),
    [
        ({}, 0),
        ({"step": 0}, 0),
        ({"step": 3}, 3),
        ({"step": -1}, 4),
        ({"step": np.int64(-5)}, 0),
        ({"time": 20}, 2),
        ({"time": 40.0}, 4),
    ],
)
def test_one_step(dump, which, x):
    assert spherepacking.read(dump, **which).points[0, 0] == x


@pytest.mark.parametrize(
    ("which", "message"),
    [
        ({"step": 5}, r"step: found 5, expected -5 to 4: .*run\.dump has 5 steps"),
        ({"step": -6}, "step: found -6"),
        ({"time": 15}, "time: found 15, expected one of 0, 10, 20, 30, 40"),
        ({"step": 1, "time": 10}, "expected one of them"),
    ],
)
def test_no_such_step(dump, which, message):
    with pytest.raises(ValueError, match=message):
        spherepacking.read(dump, **which)


def test_a_file_of_one_packing(tmp_path):
    path = tmp_path / "a.spheres"
    path.write_text("1 2 3 4\n")
    steps = spherepacking.steps(path)
    assert (len(steps), steps.times) == (1, [])
    assert steps[0]["radius"].tolist() == spherepacking.read(path, step=-1)["radius"].tolist()
    with pytest.raises(ValueError, match=r"step: found 1, expected -1 to 0: .* has one step"):
        spherepacking.read(path, step=1)
    with pytest.raises(ValueError, match=r"time: found 1, expected step: .* tells no times"):
        spherepacking.read(path, time=1)


def test_many_times_are_not_all_listed(tmp_path):
    path = tmp_path / "run.dump"
    path.write_text("".join(DUMP.format(step=i, x=i) for i in range(100)))
    with pytest.raises(ValueError, match="one of 100 from 0 to 99, such as 42, as "):
        spherepacking.read(path, time=42.2)


FRAME = "1\nProperties=species:S:1:pos:R:3:radius:R:1 {}\nA {} 0 0 0.5\n"


def xyz(path, *comments):
    path.write_text("".join(FRAME.format(comment, x) for x, comment in enumerate(comments)))
    return path


@pytest.mark.parametrize(
    ("numbers", "time", "x"), [([0, 1, 2, 2, 3, 4], 3, 4), ([0, 100, 200, 200, 300], 300, 4)]
)
def test_numbers_that_repeat_are_not_replaced_by_indices(tmp_path, numbers, time, x):
    path = tmp_path / "restarted.dump"
    path.write_text("".join(DUMP.format(step=step, x=i) for i, step in enumerate(numbers)))
    steps = spherepacking.steps(path)
    assert steps.times == numbers
    packing = spherepacking.read(path, time=time)
    assert (packing.points[0, 0], packing.field_data["TimeValue"][0]) == (x, time)
    with pytest.raises(ValueError, match=rf"found {numbers[2]}, .* it is that of the steps 2, 3"):
        spherepacking.read(path, time=numbers[2])
    assert spherepacking.read(path, step=3).points[0, 0] == 3.0


@pytest.mark.skipif(pv.version_info < (0, 49), reason="PyVista before 0.49 knows no such classes")
@pytest.mark.parametrize("numbers", [[0, 1, 2, 2, 3, 4], [0, 100, 200, 100], [5, 4, 3], [7, 8]])
def test_pyvista_has_the_times_of_the_file(tmp_path, numbers):
    path = tmp_path / "restarted.dump"
    path.write_text("".join(DUMP.format(step=step, x=i) for i, step in enumerate(numbers)))
    reader = pv.get_reader(path)
    assert reader.time_values == numbers
    for i, number in enumerate(numbers):
        reader.set_active_time_point(i)
        assert reader.active_time_value == reader.time_point_value(i) == number
        packing = reader.read()
        assert (packing.points[0, 0], packing.field_data["TimeValue"][0]) == (i, number)
        if numbers.count(number) > 1:
            with pytest.raises(ValueError, match=rf"found {number}, which .* time points \d, \d"):
                reader.set_active_time_value(number)
            assert reader.active_time_value == number
        else:
            reader.set_active_time_point(0)
            reader.set_active_time_value(number)
            assert reader.read().points[0, 0] == i
    reader.set_active_time_point(-1)
    assert reader.active_time_value == numbers[-1]
    with pytest.raises(IndexError, match=rf"time_point: found 9, expected 0 to {len(numbers) - 1}"):
        reader.set_active_time_point(9)


@pytest.mark.skipif(pv.version_info < (0, 49), reason="PyVista before 0.49 knows no such classes")
def test_pyvista_counts_steps_without_times(tmp_path):
    reader = pv.get_reader(xyz(tmp_path / "a.xyz", "", ""))
    assert reader.time_values == [0, 1]
    reader.set_active_time_value(1)
    assert reader.read().points[0, 0] == 1
    assert "TimeValue" not in reader.read().field_data


def test_arguments_that_are_none(tmp_path):
    path = tmp_path / "a.dump"
    path.write_text("".join(DUMP.format(step=step, x=step) for step in range(10)))
    steps = spherepacking.steps(path)
    with pytest.raises(IndexError, match="steps: found 30, expected 0 to 9"):
        steps[30]
    assert steps[-1].points[0, 0] == 9
    assert len(list(steps[3:5])) == 2
    with pytest.raises(TypeError, match="steps: found True, expected an integer"):
        steps[True]
    with pytest.raises(TypeError, match="time: found '3', expected a number"):
        spherepacking.read(path, time="3")
    with pytest.raises(TypeError, match="time: found nan"):
        spherepacking.read(path, time=float("nan"))


def test_names_of_columns_one_by_one(tmp_path):
    path = tmp_path / "a.txt"
    path.write_text("7 1 2 3 0.5\n9 4 5 6 0.25\n")
    for columns in ("id x y z r", ["id", "x", "y", "z", "r"], ("id", "x", "y", "z", "r")):
        packing = spherepacking.read(path, columns=columns)
        assert packing["radius"].tolist() == [0.5, 0.25]
        assert packing["id"].tolist() == [7, 9]
    with pytest.raises(ValueError, match="columns: found 'a b', expected names without blanks"):
        spherepacking.read(path, columns=["a b", "x"])
    with pytest.raises(ValueError, match="columns: found no name"):
        spherepacking.read(path, columns=[])
    for wrong in (5, ["x", 1]):
        with pytest.raises(TypeError, match=r"columns: found .*, expected names"):
            spherepacking.read(path, columns=wrong)


def test_an_index_is_no_time(tmp_path):
    path = tmp_path / "restarted.dump"
    path.write_text("".join(DUMP.format(step=step, x=0) for step in (0, 100, 200, 200)))
    with pytest.raises(ValueError, match="found 1, expected one of 0, 100, 200, 200, as"):
        spherepacking.read(path, time=1)
    path = xyz(tmp_path / "none.xyz", "", "")
    assert spherepacking.steps(path).times == []
    assert len(spherepacking.steps(path)) == 2
    with pytest.raises(ValueError, match=r"found 1, expected step: .* tells no times"):
        spherepacking.read(path, time=1)


def test_frames_without_a_time_leave_those_of_others(tmp_path):
    path = xyz(tmp_path / "run.xyz", "Time=0", "Time=0.1", "")
    np.testing.assert_array_equal(spherepacking.steps(path).times, [0.0, 0.1, np.nan])
    assert spherepacking.steps(path)[2:].times == []
    assert spherepacking.read(path, time=0.1).points[0, 0] == 1.0
    last = spherepacking.read(path, step=2)
    assert last.points[0, 0] == 2.0
    assert "TimeValue" not in last.field_data
    with pytest.raises(ValueError, match=r"found 2, expected one of 0, 0\.1, as"):
        spherepacking.read(path, time=2)


def test_times_of_some_files_of_a_run(tmp_path):
    """A number in a name is no time beside times that files say."""
    files = [xyz(tmp_path / "a_1.xyz", "Time=2.5"), xyz(tmp_path / "a_2.xyz", "")]
    steps = spherepacking.steps(files)
    np.testing.assert_array_equal(steps.times, [2.5, np.nan])
    assert [list(p.field_data.get("TimeValue", [])) for p in steps] == [[2.5], []]
    xyz(files[0], "")
    assert spherepacking.steps(tmp_path / "a_*.xyz").times == [1.0, 2.0]


# --- numbered files -------------------------------------------------------------------------------


def test_numbered_files_of_vtk(tmp_path):
    for i in (0, 2, 10):
        vtu(tmp_path / f"run_{i}.vtu", float(i))
    vtu(tmp_path / "run_last.vtu", 99.0)
    pattern = tmp_path / "run_%d.vtu"
    steps = spherepacking.steps(pattern)
    assert (steps.times, xs(steps)) == ([0.0, 2.0, 10.0], [0, 2, 10])
    assert steps[1].field_data["TimeValue"].tolist() == [2.0]
    assert spherepacking.read(str(pattern), time=10).points[0, 0] == 10.0
    # By numbers, not by letters.
    found = spherepacking.steps(str(tmp_path / "run_[0-9]*.vtu"))
    assert (found.times, xs(found)) == (steps.times, xs(steps))


def test_a_width_in_the_pattern(tmp_path):
    for name in ("f_0001.vtu", "f_0002.vtu", "f_00003.vtu", "f_10000.vtu"):
        vtu(tmp_path / name, float(name[2:-4]))
    assert xs(spherepacking.steps(tmp_path / "f_%04d.vtu")) == [1, 2, 10000]


def test_numbered_dumps_have_times_of_their_own(tmp_path):
    for number, step in ((1, 500), (2, 1000)):
        (tmp_path / f"dump.{number}.lammpstrj").write_text(DUMP.format(step=step, x=number))
    steps = spherepacking.steps(tmp_path / "dump.*.lammpstrj")
    assert (steps.times, xs(steps)) == ([500.0, 1000.0], [1, 2])


def test_runs_one_after_the_other(tmp_path):
    """A restart goes on in a file of its own."""
    first, second = tmp_path / "first.dump", tmp_path / "second.dump"
    first.write_text("".join(DUMP.format(step=i, x=i) for i in (0, 1, 2)))
    second.write_text("".join(DUMP.format(step=i, x=i) for i in (2, 3)))
    steps = spherepacking.steps([first, str(second)])
    assert (steps.times, xs(steps)) == ([0, 1, 2, 2, 3], [0, 1, 2, 2, 3])
    with pytest.raises(ValueError, match=r"time: found 2, .* steps 2, 3"):
        spherepacking.read([first, second], time=2)


def test_texts_have_numbers_for_times(tmp_path):
    for i in (5, 7):
        (tmp_path / f"a{i}.xyzr").write_text(f"{i} 0 0 1\n")
    steps = spherepacking.steps(tmp_path / "a?.xyzr")
    assert (steps.times, xs(steps)) == ([5.0, 7.0], [5, 7])


def test_files_without_numbers_have_no_times(tmp_path):
    files = [vtu(tmp_path / f"{name}.vtu", x) for name, x in (("b", 1.0), ("a", 2.0))]
    steps = spherepacking.steps(files)
    assert (len(steps), steps.times, xs(steps)) == (2, [], [1, 2])


def test_names_that_look_like_patterns_are_files_first(tmp_path):
    path = tmp_path / "a[1].xyzr"
    path.write_text("1 2 3 4\n")
    assert spherepacking.read(path)["radius"].tolist() == [4.0]


@pytest.mark.parametrize("pattern", ["none_*.vtu", "none_%03d.vtu"])
def test_nothing_fits(tmp_path, pattern):
    with pytest.raises(FileNotFoundError, match="there is no file whose name fits"):
        spherepacking.steps(tmp_path / pattern)


def test_the_files_of_two_runs(tmp_path):
    """LIGGGHTS writes the box beside the particles, and both fit part_*."""
    for i in (0, 100, 200):
        vtu(tmp_path / f"part_{i}.vtu", float(i))
        pv.Box().cast_to_unstructured_grid().save(tmp_path / f"part_boundingBox_{i}.vtu")
    with pytest.raises(
        spherepacking.PackingFileError,
        match=r"part_100\.vtu and part_boundingBox_100\.vtu, .*/part_\[0-9\]\*\.vtu or ",
    ):
        spherepacking.steps(tmp_path / "part_*.vtu")
    steps = spherepacking.steps(tmp_path / "part_[0-9]*.vtu")
    assert (steps.times, xs(steps)) == ([0, 100, 200], [0, 100, 200])


def test_one_run_of_several_names(tmp_path):
    """Numbers that go on in files of another name are one run's."""
    for i, name in enumerate(("a1", "a2", "b3", "b4", "last")):
        vtu(tmp_path / f"{name}.vtu", float(i))
    assert xs(spherepacking.steps(tmp_path / "*.vtu")) == [0, 1, 2, 3, 4]


def test_an_empty_list():
    with pytest.raises(ValueError, match="path: found no file in the list"):
        spherepacking.steps([])


def test_an_error_names_the_file_of_the_step(tmp_path):
    vtu(tmp_path / "a0.vtu", 0.0)
    (tmp_path / "a1.vtu").write_text("<VTKFile")
    steps = spherepacking.steps(tmp_path / "a*.vtu")
    assert xs(steps[:1]) == [0]
    with pytest.raises(spherepacking.PackingFileError, match=r"a1\.vtu: found no XML"):
        steps[1]


# --- collections of ParaView ----------------------------------------------------------------------

PVD = '<VTKFile type="Collection" version="0.1"><Collection>{}</Collection></VTKFile>'
SET = '<DataSet timestep="{}" group="" part="{}" file="{}"/>'


def test_a_collection(tmp_path):
    (tmp_path / "parts").mkdir()
    sets = []
    for i, time in enumerate((0.5, 0.25)):
        for part in (0, 1):
            vtu(tmp_path / "parts" / f"{i}_{part}.vtu", 10.0 * i + part)
            sets.append(SET.format(time, part, f"parts/{i}_{part}.vtu"))
    (tmp_path / "run.pvd").write_text(PVD.format("".join(sets)))
    steps = spherepacking.steps(tmp_path / "run.pvd")
    assert steps.times == [0.25, 0.5]
    assert steps[0].points[:, 0].tolist() == [10.0, 11.0]
    assert steps[1].points[:, 0].tolist() == [0.0, 1.0]
    packing = spherepacking.read(tmp_path / "run.pvd", time=0.5)
    assert packing["radius"].tolist() == [0.5, 0.5]
    assert packing.field_data["TimeValue"].tolist() == [0.5]
    assert packing.point_data.active_scalars_name == "radius"


def test_a_series(tmp_path):
    for i in range(3):
        vtu(tmp_path / f"a{i}.vtu", float(i))
    files = [{"name": f"a{i}.vtu", "time": 0.1 * i} for i in range(3)]
    path = tmp_path / "a.vtu.series"
    path.write_text(json.dumps({"file-series-version": "1.0", "files": files}))
    steps = spherepacking.steps(path)
    assert (steps.times, xs(steps)) == ([0.0, 0.1, 0.2], [0, 1, 2])
    assert spherepacking.read(path, time=0.2).points[0, 0] == 2.0


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.pvd", "nonsense"),
        ("a.pvd", PVD.format("")),
        ("a.pvd", PVD.format('<DataSet timestep="x" file="a"/>')),
        ("a.pvd", PVD.format('<DataSet timestep="1"/>')),
        ("a.series", "nonsense"),
        ("a.series", "[]"),
        ("a.series", '{"files": []}'),
        ("a.series", '{"files": [{"name": "a.vtu"}]}'),
    ],
)
def test_a_damaged_collection(tmp_path, name, text):
    (tmp_path / name).write_text(text)
    with pytest.raises(spherepacking.PackingFileError, match=r"/a\.(pvd|series): found no"):
        spherepacking.read(tmp_path / name)


def test_a_missing_file_of_a_collection(tmp_path):
    (tmp_path / "a.pvd").write_text(PVD.format(SET.format(0, 0, "none.vtu")))
    with pytest.raises(FileNotFoundError, match=r"a\.pvd: found the file .*none\.vtu in it, which"):
        spherepacking.read(tmp_path / "a.pvd")


@pytest.mark.parametrize("kind", ["vtu", "vtm"])
def test_other_steps_of_a_collection_without_a_file(tmp_path, kind):
    mesh = pv.PolyData(np.array([[7.0, 0.0, 0.0]]))
    mesh["radius"] = [0.5]
    (mesh.cast_to_unstructured_grid() if kind == "vtu" else pv.MultiBlock([mesh])).save(
        tmp_path / f"there.{kind}"
    )
    sets = [SET.format(i, 0, f"{name}.{kind}") for i, name in enumerate(("gone", "there"))]
    (tmp_path / "a.pvd").write_text(PVD.format("".join(sets)))
    files = [{"name": f"{name}.{kind}", "time": i} for i, name in enumerate(("gone", "there"))]
    (tmp_path / "a.series").write_text(json.dumps({"files": files}))
    for name in ("a.pvd", "a.series"):
        steps = spherepacking.steps(tmp_path / name)
        assert steps.times == [0, 1]
        assert steps[1].points[0, 0] == 7
        assert spherepacking.read(tmp_path / name, step=1).points[0, 0] == 7
        with pytest.raises(FileNotFoundError, match=rf"{name}: found the file .*gone\.{kind}"):
            steps[0]


def test_a_run_in_a_collection_is_refused(tmp_path, dump):
    (tmp_path / "a.pvd").write_text(PVD.format(SET.format(0, 0, dump.name)))
    with pytest.raises(spherepacking.PackingFileError, match=r"run\.dump: found 5 steps in a file"):
        spherepacking.read(tmp_path / "a.pvd")


# --- radii and columns ----------------------------------------------------------------------------


def test_radii_of_each_step(tmp_path):
    for i in range(2):
        vtu(tmp_path / f"a{i}.vtu", float(i), size=[2.0 + i])
    steps = spherepacking.steps(tmp_path / "a*.vtu", radius="size")
    assert [packing["radius"][0] for packing in steps] == [2.0, 3.0]


def test_radii_instead_of_those_of_the_file(tmp_path):
    path = tmp_path / "a.csv"
    path.write_text("x,y,z,r,size,type\n1,2,3,4,5,1\n2,3,4,5,6,2\n")
    read = spherepacking.read
    assert read(path)["radius"].tolist() == [4.0, 5.0]
    assert read(path, radius=0.5)["radius"].tolist() == [0.5, 0.5]
    assert read(path, radius="size")["radius"].tolist() == [5.0, 6.0]
    assert read(path, radius=[1, 2])["radius"].tolist() == [1.0, 2.0]
    assert read(path, radius={1: 0.25, 2: 0.75})["radius"].tolist() == [0.25, 0.75]
    packing = read(path, radius=0.5, precision="single")
    assert packing.points.dtype == np.float32
    assert packing.point_data.active_scalars_name == "radius"
    with pytest.raises(spherepacking.PackingFileError, match=r"a\.csv: .*no radius for 2"):
        read(path, radius={1: 0.25})
    with pytest.raises(spherepacking.PackingFileError, match=r"a\.csv: radius: found 3 values"):
        read(path, radius=[1, 2, 3])


PDB = """MODEL        1
ATOM      1  N   ALA A   1      12.250   7.125  -5.375  1.00  9.50           N
ENDMDL
MODEL        2
ATOM      1  N   ALA A   1      13.250   7.125  -5.375  1.00  9.50           N
ENDMDL
"""


def test_models_of_molecules(tmp_path):
    pytest.importorskip("gemmi")
    path = tmp_path / "a.pdb.gz"
    path.write_bytes(gzip.compress(PDB.encode()))
    steps = spherepacking.steps(path, precision="single")
    assert (steps.times, xs(steps)) == ([1.0, 2.0], [12.25, 13.25])
    assert steps[0].points.dtype == np.float32
    assert steps[0]["element"].tolist() == ["N"]
    assert spherepacking.read(path, radius={"N": 2.0})["radius"].tolist() == [2.0]
    with pytest.raises(spherepacking.PackingFileError, match=r"a\.pdb\.gz: .*no radius for N"):
        spherepacking.read(path, radius={"C": 2.0})


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.dump", HEAD.replace(" {radius}", "").format(step=0) + "1 1 0 0\n"),
        ("a.xyz", "1\nmade up\nC 1 0 0\n"),
        ("a.csv", "x,y,z\n1,0,0\n"),
    ],
)
def test_files_without_radii_say_how_to_give_them(tmp_path, name, text):
    path = tmp_path / name
    path.write_text(text)
    with pytest.raises(spherepacking.PackingFileError, match=r"; radius= gives radii \(--radius"):
        spherepacking.read(path)
    packing = spherepacking.read(path, radius=0.5)
    assert (packing.points.tolist(), packing["radius"].tolist()) == ([[1, 0, 0]], [0.5])


def test_other_errors_say_nothing_of_radii(tmp_path):
    (tmp_path / "a.csv").write_text("x,y,z,r\n1,0,0,-1\n")
    with pytest.raises(spherepacking.PackingFileError) as caught:
        spherepacking.read(tmp_path / "a.csv")
    assert "radius=" not in str(caught.value)


def test_columns_of_a_table(tmp_path, dump):
    path = tmp_path / "a.txt"
    path.write_text("1 2 3 4 5\n2 3 4 5 6\n")
    packing = spherepacking.read(path, columns="r y z w x")
    assert packing.points.tolist() == [[5, 2, 3], [6, 3, 4]]
    assert packing["radius"].tolist() == [1.0, 2.0]
    assert packing["w"].tolist() == [4.0, 5.0]
    with pytest.raises(spherepacking.PackingFileError, match=r"run\.dump: found names of columns"):
        spherepacking.read(dump, columns="id x y z r")


@pytest.mark.parametrize(
    ("argument", "error", "message"),
    [
        ({"precision": "half"}, ValueError, "precision: found 'half'"),
        ({"step": "1"}, TypeError, "step: found '1', expected an integer"),
        ({"step": 1.0}, TypeError, "step: found 1.0, expected an integer"),
        ({"step": True}, TypeError, "step: found True, expected an integer"),
        ({"time": 10.00001}, ValueError, "time: found 10.00001, expected one of 0, 10, 20"),
    ],
)
def test_arguments(dump, argument, error, message):
    with pytest.raises(error, match=message):
        spherepacking.read(dump, **argument)


def test_numpys_integers_are_steps(dump):
    assert spherepacking.read(dump, step=np.int64(2)).points[0, 0] == 2
