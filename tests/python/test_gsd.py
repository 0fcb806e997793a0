"""GSD files of HOOMD-blue; they are written here by the library gsd, chunk by chunk."""

import builtins

import numpy as np
import pytest
import pyvista as pv
import spherepacking

pytest.importorskip("gsd")
import gsd.fl

POINTS = np.array([[1, 2, 3], [-4, 1.5, 2.5], [0.5, 0.25, 0.125]], np.float32)


def write(path, *frames, schema="hoomd"):
    with gsd.fl.open(
        str(path), "w", application="a test", schema=schema, schema_version=[1, 4]
    ) as f:
        for frame in frames:
            for name, values in frame.items():
                f.write_chunk(name, np.asarray(values))
            f.end_frame()
    return path


def frame(step=0, **particles):
    made = {
        "configuration/step": np.array([step], np.uint64),
        "configuration/box": np.array([10, 8, 6, 0.5, 0.25, 0.125], np.float32),
        "particles/N": np.array([3], np.uint32),
        "particles/position": POINTS,
    }
    return made | {f"particles/{name}": values for name, values in particles.items()}


def texts(*names):
    width = max(map(len, names)) + 1
    return np.array([list(n.encode().ljust(width, b"\0")) for n in names], np.uint8)


DIAMETERS = np.array([1.0, 0.5, 0.25], np.float32)


def test_spheres_types_box_and_time(tmp_path):
    path = write(
        tmp_path / "a.gsd",
        frame(
            step=100,
            diameter=DIAMETERS,
            types=texts("A", "Big"),
            typeid=np.array([0, 1, 1], np.uint32),
            velocity=np.arange(9, dtype=np.float32).reshape(3, 3),
            image=np.array([[0, 0, 1], [0, -1, 0], [0, 0, 0]], np.int32),
        ),
    )
    packing = spherepacking.read(path)
    assert packing.points.tolist() == POINTS.tolist()
    assert packing.points.dtype == np.float64
    assert packing["radius"].tolist() == [0.5, 0.25, 0.125]
    assert packing.point_data.active_scalars_name == "radius"
    assert packing["type"].tolist() == [0, 1, 1]
    assert packing["type_name"].tolist() == ["A", "Big", "Big"]
    assert packing["velocity"][2].tolist() == [6.0, 7.0, 8.0]
    assert packing["image"].tolist() == [[0, 0, 1], [0, -1, 0], [0, 0, 0]]
    # What is not in the file is not made up.
    assert "mass" not in packing.point_data
    assert packing.field_data["TimeValue"].tolist() == [100.0]
    # lx, ly, lz = 10, 8, 6; b and c are tilted by xy ly, xz lz and yz lz.
    vectors = [[10, 0, 0], [4, 8, 0], [1.5, 0.75, 6]]
    assert packing.field_data["cell_vectors"].tolist() == vectors
    assert packing.field_data["cell_origin"].tolist() == [-7.75, -4.375, -3]
    assert packing.field_data["cell_periodic"].tolist() == [1, 1, 1]


@pytest.mark.skipif(pv.version_info < (0, 49), reason="PyVista before 0.49 knows no such classes")
def test_pyvista_reads_them_step_by_step(tmp_path):
    moved = frame(20) | {"particles/position": POINTS + 1}
    path = write(tmp_path / "a.gsd", frame(10, diameter=DIAMETERS), moved)
    assert pv.read(path)["radius"].tolist() == [0.5, 0.25, 0.125]
    reader = pv.get_reader(path)
    assert (reader.time_values, reader.number_time_points) == ([10.0, 20.0], 2)
    assert reader.active_time_value == 10.0
    reader.set_active_time_value(20.0)
    assert (reader.active_time_value, reader.time_point_value(1)) == (20.0, 20.0)
    assert reader.read().points[0].tolist() == [2.0, 3.0, 4.0]
    reader.set_active_time_point(0)
    assert reader.read().points[0].tolist() == [1.0, 2.0, 3.0]
    with pytest.raises(IndexError):
        reader.set_active_time_point(2)
    with pytest.raises(ValueError, match="time: found 5, expected one of 10, 20"):
        reader.set_active_time_value(5)


@pytest.mark.skipif(pv.version_info < (0, 49), reason="PyVista before 0.49 knows no such classes")
def test_pyvista_raises_the_same_error(tmp_path, capfd):
    path = write(tmp_path / "a.gsd", frame())
    with pytest.raises(spherepacking.PackingFileError, match=r"a\.gsd: found no diameters"):
        pv.read(path)
    assert capfd.readouterr() == ("", "")


def test_two_dimensions_are_not_periodic_along_z(tmp_path):
    made = frame(diameter=DIAMETERS) | {"configuration/dimensions": np.array([2], np.uint8)}
    packing = spherepacking.read(write(tmp_path / "a.gsd", made))
    assert packing.field_data["cell_periodic"].tolist() == [1, 1, 0]


def test_frames_are_steps_and_lack_what_the_first_one_says(tmp_path):
    moved = frame(20) | {"particles/position": POINTS + 1}
    less = {
        "configuration/step": np.array([30], np.uint64),
        "particles/N": np.array([1], np.uint32),
        "particles/position": POINTS[:1],
        "particles/diameter": np.array([3], np.float32),
    }
    steps = spherepacking.steps(
        write(tmp_path / "a.gsd", frame(10, diameter=DIAMETERS), moved, less)
    )
    assert (len(steps), steps.times) == (3, [10.0, 20.0, 30.0])
    assert steps[1].points[0].tolist() == [2.0, 3.0, 4.0]
    assert steps[1]["radius"].tolist() == [0.5, 0.25, 0.125]
    assert steps[2]["radius"].tolist() == [1.5]
    # What was handed out is nobody else's.
    steps[0]["radius"][:] = 9.0
    steps[0].points[:] = 9.0
    assert steps[0]["radius"].tolist() == steps[1]["radius"].tolist() == [0.5, 0.25, 0.125]


def test_absent_diameters_are_not_one(tmp_path):
    path = write(tmp_path / "a.gsd", frame(types=texts("A", "B"), typeid=np.array([0, 1, 0], "u4")))
    with pytest.raises(
        spherepacking.PackingFileError, match=r"a\.gsd: found no diameters .*radius="
    ):
        spherepacking.read(path)
    assert spherepacking.read(path, radius=2)["radius"].tolist() == [2.0, 2.0, 2.0]
    by_type = spherepacking.read(path, radius={0: 1.0, 1: 0.5})
    assert by_type["radius"].tolist() == [1.0, 0.5, 1.0]
    by_name = spherepacking.read(path, radius={"A": 1.0, "B": 0.5})
    assert by_name["radius"].tolist() == [1.0, 0.5, 1.0]


def test_diameters_of_another_number_of_particles_are_absent(tmp_path):
    less = frame(5) | {
        "particles/N": np.array([2], np.uint32),
        "particles/position": POINTS[:2],
    }
    steps = spherepacking.steps(write(tmp_path / "a.gsd", frame(diameter=DIAMETERS), less))
    with pytest.raises(spherepacking.PackingFileError, match="no diameters in frame 1"):
        steps[1]


def test_hard_spheres_have_shapes(tmp_path):
    shapes = texts('{"type": "Sphere", "diameter": 3.0}', '{"type": "Sphere", "diameter": 1.5}')
    types = {"types": texts("A", "B"), "typeid": np.array([0, 1, 0], np.uint32)}
    path = write(tmp_path / "a.gsd", frame(type_shapes=shapes, **types))
    assert spherepacking.read(path)["radius"].tolist() == [1.5, 0.75, 1.5]
    cubes = texts('{"type": "Sphere", "diameter": 3.0}', '{"type": "ConvexPolyhedron"}')
    path = write(tmp_path / "b.gsd", frame(type_shapes=cubes, **types))
    with pytest.raises(spherepacking.PackingFileError, match="no diameters"):
        spherepacking.read(path)


def test_no_particles(tmp_path):
    empty = {"particles/N": np.array([0], np.uint32)}
    assert spherepacking.read(write(tmp_path / "a.gsd", empty)).n_points == 0


@pytest.mark.parametrize("fault", ["schema", "text", "cut", "no frame", "type", "negative"])
def test_what_is_wrong_is_one_error(tmp_path, fault):
    path = tmp_path / "a.gsd"
    if fault == "schema":
        write(path, frame(), schema="other")
    elif fault == "text":
        path.write_text("0 0 0 1\n")
    elif fault == "cut":
        write(path, frame(diameter=DIAMETERS))
        path.write_bytes(path.read_bytes()[:300])
    elif fault == "no frame":
        write(path)
    elif fault == "type":
        write(path, frame(diameter=DIAMETERS, typeid=np.array([0, 7, 0], np.uint32)))
    else:
        write(path, frame(diameter=-DIAMETERS))
    with pytest.raises(spherepacking.PackingFileError, match=r"a\.gsd: .*(found|holds)"):
        spherepacking.read(path)


def test_the_library_is_named_when_it_is_missing(tmp_path, monkeypatch):
    path = write(tmp_path / "a.gsd", frame(diameter=DIAMETERS))
    real = builtins.__import__

    def without(name, *args, **kwargs):
        if name.partition(".")[0] == "gsd":
            raise ImportError(name)
        return real(name, *args, **kwargs)

    monkeypatch.setattr(builtins, "__import__", without)
    with pytest.raises(ImportError, match=r"a\.gsd: .*pip install 'spherepacking\[formats\]'"):
        spherepacking.read(path)


@pytest.mark.parametrize("name", ["velocity", "mass", "diameter", "image"])
def test_arrays_of_another_length(tmp_path, name):
    short = {"velocity": np.ones((1, 3), np.float32), "image": np.ones((4, 3), np.int32)}
    values = short.get(name, np.ones(2, np.float32))
    path = write(tmp_path / "a.gsd", frame(**({"diameter": DIAMETERS} | {name: values})))
    message = rf"a\.gsd: found {len(values)} values of {name} in frame 0, expected 3"
    with pytest.raises(spherepacking.PackingFileError, match=message):
        spherepacking.read(path)


@pytest.mark.parametrize("positions", [True, False])
def test_a_number_of_particles_that_the_file_cannot_hold(tmp_path, positions):
    made = frame(diameter=DIAMETERS) | {"particles/N": np.array([4 * 10**9], np.uint32)}
    if not positions:
        del made["particles/position"]
    path = write(tmp_path / "a.gsd", frame(diameter=DIAMETERS), made)
    steps = spherepacking.steps(path)
    assert steps[0].n_points == 3
    with pytest.raises(
        spherepacking.PackingFileError, match=r"a\.gsd: found 4,000,000,000 particles in frame 1"
    ):
        steps[1]


@pytest.mark.parametrize("at", [8, 16, 24, 32])
@pytest.mark.parametrize("number", [2**62, 2**64 - 1, 10**6])
def test_tables_that_do_not_lie_in_the_file(tmp_path, at, number):
    """The header says where they begin and how many entries they have."""
    path = write(tmp_path / "a.gsd", frame(diameter=DIAMETERS))
    data = bytearray(path.read_bytes())
    data[at : at + 8] = number.to_bytes(8, "little")
    path.write_bytes(data)
    with pytest.raises(spherepacking.PackingFileError, match=r"a\.gsd: found a table of \S+ entr"):
        spherepacking.read(path)


def test_a_box_that_is_none(tmp_path):
    damaged = frame(diameter=DIAMETERS) | {"configuration/box": np.ones(4, np.float32)}
    path = write(tmp_path / "a.gsd", damaged)
    with pytest.raises(
        spherepacking.PackingFileError, match=r"a\.gsd: found a frame 0 that cannot"
    ):
        spherepacking.read(path)
