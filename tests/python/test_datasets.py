"""Any dataset as a packing: where its radii are found, and `radius` wherever a packing goes in."""

import numpy as np
import pytest
import pyvista as pv
import spherepacking
from spherepacking.datasets import packing_of

POINTS = [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [0.0, 4.0, 0.0]]
RADII = [0.5, 1.0, 1.5]
VIEW = [(0.0, 0.0, 30.0), (0.0, 0.0, 0.0), (0.0, 1.0, 0.0)]
SIZE = (40, 30)


def mesh(**arrays):
    made = pv.PolyData(np.array(POINTS))
    for name, values in arrays.items():
        made.point_data[name] = np.array(values)
    return made


def grid(**arrays):
    made = pv.UnstructuredGrid(
        np.array([1, 0, 1, 1, 1, 2]), np.full(3, pv.CellType.VERTEX), np.array(POINTS)
    )
    for name, values in arrays.items():
        made.point_data[name] = np.array(values)
    return made


# --- where radii are found ------------------------------------------------------------------------

DOUBLE = [1.0, 2.0, 3.0]
OTHER = [7.0, 8.0, 9.0]


@pytest.mark.parametrize(
    "arrays",
    [
        {"radius": RADII},
        {"radii": RADII},
        {"Radius": RADII},
        {"RADIUS": RADII},
        {"rad": RADII},
        {"r": RADII},
        {"diameter": DOUBLE},
        {"Diameter": DOUBLE},
        {"d": DOUBLE},
        {"diam": DOUBLE},
        # The whole word wins.
        {"r": OTHER, "radius": RADII},
        {"r": OTHER, "d": OTHER, "Diameter": DOUBLE},
        {"Diameter": OTHER, "radii": RADII},
        {"Radius": OTHER, "radius": RADII},
        # r beside g and b is red.
        {"R": OTHER, "G": OTHER, "B": OTHER, "d": DOUBLE},
        # Molecules of VTK have the radius three times.
        {"radius": np.repeat(RADII, 3).reshape(3, 3)},
        {"radius": np.reshape(RADII, (3, 1))},
    ],
)
@pytest.mark.parametrize("make", [mesh, grid])
def test_found_by_name(make, arrays):
    dataset = make(**arrays)
    assert packing_of(dataset)["radius"].tolist() == RADII
    assert dataset.packing.radii.tolist() == RADII
    assert dataset.packing.bounds == (-1.5, 4.0, -1.0, 5.5, -1.5, 1.5)
    # It has not been changed.
    assert set(dataset.point_data) == set(arrays)


@pytest.mark.parametrize(
    ("arrays", "error", "message"),
    [
        ({"mass": RADII, "id": [1, 2, 3]}, KeyError, r"are: mass, id; radius='NAME'"),
        ({}, KeyError, "are: none; radius=0.5 gives all spheres the same"),
        ({"R": OTHER, "G": OTHER, "B": OTHER}, KeyError, "are: R, G, B"),
        ({"r": RADII, "d": DOUBLE}, ValueError, "arrays r and d, .*radius='r'"),
        ({"Radius": RADII, "radii": RADII}, ValueError, "arrays Radius and radii"),
        ({"r": RADII, "theta": OTHER}, ValueError, "array r beside theta, .*radius='r'"),
        ({"R": RADII, "Phi": OTHER, "z": OTHER}, ValueError, "array R beside Phi"),
        ({"r": RADII, "azimuth": OTHER}, ValueError, "array r beside azimuth"),
        ({"radius": np.eye(3)}, ValueError, "3 components that differ in 'radius'"),
        ({"radius": [-1.0, 1.0, 1.0]}, ValueError, "-1 at point 0"),
        ({"radii": [1.0, np.nan, 1.0]}, ValueError, "nan at point 1"),
        ({"radius": ["a", "b", "c"]}, TypeError, "radius"),
        ({"radii": ["a", "b", "c"]}, TypeError, "found <U1 values in 'radii'"),
    ],
)
def test_not_found(arrays, error, message):
    with pytest.raises(error, match=message):
        mesh(**arrays).packing.bounds  # noqa: B018


def test_a_packing_is_itself():
    packing = mesh(radius=RADII)
    assert packing_of(packing) is packing


def test_arrays_are_shared_and_the_active_one_stays():
    dataset = grid(radii=RADII, height=[5.0, 6.0, 7.0])
    dataset.set_active_scalars("height")
    packing = packing_of(dataset)
    assert np.shares_memory(packing.points, dataset.points)
    assert np.shares_memory(packing["height"], dataset["height"])
    assert np.shares_memory(packing["radius"], dataset["radii"])
    assert packing.point_data.active_scalars_name == "height"
    assert packing.n_verts == 3


def test_arrays_of_cells_that_are_the_spheres():
    """VTKRecorder and others write them; the second cell is the third point here."""
    dataset = pv.UnstructuredGrid(
        np.array([1, 0, 1, 2, 1, 1]), np.full(3, pv.CellType.VERTEX), np.array(POINTS)
    )
    dataset.cell_data["radius"] = [0.5, 1.5, 1.0]
    assert packing_of(dataset)["radius"].tolist() == RADII
    surface = pv.Triangle()
    surface.cell_data["radius"] = [1.0]
    with pytest.raises(KeyError, match="there is a cell array of that name"):
        packing_of(surface)


def test_tensors_and_texts_stay():
    stress = np.arange(27.0).reshape(3, 3, 3)
    dataset = grid(radius=RADII, element=["C", "H", "C"])
    dataset.point_data["stress"] = stress.reshape(3, 9)
    packing = packing_of(dataset)
    assert packing["element"].tolist() == ["C", "H", "C"]
    assert packing["stress"].tolist() == stress.reshape(3, 9).tolist()


def test_blocks_are_joined():
    first, second = mesh(radius=RADII, id=[1, 2, 3], heat=DOUBLE), grid(Diameter=[2, 4, 6])
    second["id"] = [7, 8, 9]
    second["kind"] = ["a", "b", "c"]
    second.points = second.points + 10.0
    inner = pv.MultiBlock({"second": second, "nothing": None})
    packing = packing_of(pv.MultiBlock({"a": first, "b": inner, "empty": pv.PolyData()}))
    assert packing.n_points == 6
    assert packing["radius"].tolist() == [*RADII, 1.0, 2.0, 3.0]
    assert packing["id"].tolist() == [1, 2, 3, 7, 8, 9]
    assert packing["kind"].tolist() == ["", "", "", "a", "b", "c"]
    assert np.isnan(packing["heat"][3:]).all()
    assert packing["heat"][:3].tolist() == DOUBLE
    assert packing.points[3].tolist() == [10.0, 10.0, 10.0]


@pytest.mark.parametrize("kind", [pv.MultiBlock, pv.PartitionedDataSet])
@pytest.mark.parametrize("count", [1, 2])
def test_field_arrays_of_blocks(kind, count):
    first, second = mesh(radius=RADII), mesh(radius=RADII)
    first.field_data["cell_vectors"] = np.eye(3)
    second.field_data["cell_vectors"] = np.eye(3)
    blocks = kind([first, second][:count])
    blocks.field_data["TimeValue"] = [2.0]
    packing = blocks.packing.with_radius()
    assert packing.n_points == 3 * count
    assert packing.field_data["cell_vectors"].tolist() == np.eye(3).tolist()
    assert packing.field_data["TimeValue"].tolist() == [2.0]


def test_no_blocks():
    assert packing_of(pv.MultiBlock()).n_points == 0


def test_the_accessor_of_blocks_and_images():
    blocks = pv.MultiBlock([mesh(radius=RADII), mesh(radius=RADII)])
    assert blocks.packing.n_spheres == 6
    assert blocks.packing.centers.shape == (6, 3)
    assert blocks.packing.bounds == mesh(radius=RADII).packing.bounds
    image = pv.ImageData(dimensions=(2, 2, 2))
    assert image.packing.with_radius(0.25).packing.bounds == (-0.25, 1.25) * 3


# --- given radii ----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "radius",
    [
        "size",
        RADII,
        np.array(RADII, np.float32),
        {1: 0.5, 2: 1.0, 7: 1.5},
        {"C": 0.5, "H": 1.0, "O": 1.5, "N": 3.0},
    ],
)
def test_radii_that_are_given(radius):
    dataset = grid(size=RADII, radius=OTHER, type=[1.0, 2.0, 7.0], element=["C", "H", "O"])
    assert dataset.packing.with_radius(radius)["radius"].tolist() == RADII
    assert dataset["radius"].tolist() == OTHER


def test_one_radius_for_all_and_diameters_by_name():
    dataset = mesh(Diameter=DOUBLE)
    assert dataset.packing.with_radius(2)["radius"].tolist() == [2.0, 2.0, 2.0]
    assert dataset.packing.with_radius("Diameter")["radius"].tolist() == RADII


@pytest.mark.parametrize("name", ["d", "D", "diam", "Diam", "diameters"])
def test_diameters_are_halved_whether_found_or_named(name):
    dataset = mesh(**{name: DOUBLE})
    assert dataset.packing.with_radius()["radius"].tolist() == RADII
    assert dataset.packing.with_radius(name)["radius"].tolist() == RADII
    assert mesh(radius=OTHER, **{name: DOUBLE}).packing.radii.tolist() == OTHER


def test_a_distance_can_be_the_radius():
    dataset = mesh(r=RADII, theta=OTHER)
    assert dataset.packing.with_radius("r")["radius"].tolist() == RADII
    assert mesh(radius=RADII, r=OTHER, theta=OTHER).packing.radii.tolist() == RADII


@pytest.mark.parametrize("name", ["type", "species", "element", "name", "type_name"])
@pytest.mark.parametrize("types", [[1, 2, 7], [1.0, 2.0, 7.0], ["1", "2", "7"]])
@pytest.mark.parametrize("keys", [(1, 2, 7), ("1", "2", "7")])
def test_radii_of_types_that_are_numbers(name, types, keys):
    dataset = mesh(**{name: types})
    radius = dict(zip(keys, RADII, strict=True))
    assert dataset.packing.with_radius(radius)["radius"].tolist() == RADII


def test_numbers_are_those_of_type_first():
    dataset = mesh(element=[7, 2, 1], species=["7", "2", "1"], type=[1, 2, 7])
    radius = dict(zip((1, 2, 7), RADII, strict=True))
    assert dataset.packing.with_radius(radius)["radius"].tolist() == RADII


@pytest.mark.parametrize(
    ("radius", "error", "message"),
    [
        ("size", KeyError, "no point array 'size'"),
        ({"C1": 0.5}, KeyError, "no radius for C, H, O of the array 'element'"),
        ([1.0, 2.0], ValueError, "found 2 values, expected one for each of 3"),
        ({1: 0.5}, KeyError, "no radius for 2.0, 7.0 of the array 'type'"),
        ({"C": 0.5}, KeyError, "no radius for H, O of the array 'element'"),
        ({"C": 0.5, 1: 2.0}, TypeError, "found the keys 'C', 1"),
        ({}, TypeError, "found the keys"),
        ({1: -0.5, 2: 1.0, 7: 1.0}, ValueError, "-0.5 at point 0"),
        (True, TypeError, "found bool values"),
    ],
)
def test_radii_that_are_given_wrongly(radius, error, message):
    dataset = mesh(type=[1.0, 2.0, 7.0], element=["C", "H", "O"])
    with pytest.raises(error, match=message):
        dataset.packing.ray_cast(VIEW, SIZE, radius=radius)


def test_diameters_that_have_become_radii():
    with pytest.raises(KeyError, match=r"'diameter', .*; without radius= the array 'radius' is"):
        mesh(radius=RADII).packing.with_radius("diameter")


USES = {
    "ray_cast": lambda p, r: p.ray_cast(VIEW, SIZE, radius=r)["sphere_id"],
    "path_trace": lambda p, r: p.path_trace(VIEW, SIZE, samples=1, radius=r)["sphere_id"],
    "pick": lambda p, r: p.pick(VIEW, SIZE, 20, 15, radius=r).point,
    "bvh_boxes": lambda p, r: p.bvh_boxes(2, radius=r).points,
    "grid_boxes": lambda p, r: p.grid_boxes(1, radius=r).points,
    "metaball_field": lambda p, r: p.metaball_field(8, threshold=1.0, radius=r)["field"],
    "metaballs": lambda p, r: p.metaballs(1.0, dimensions=8, radius=r).points,
}


@pytest.mark.parametrize("use", USES)
def test_radius_goes_in_wherever_a_packing_does(use):
    expected = np.asarray(USES[use](mesh(radius=RADII).packing, None))
    accessor = grid(size=RADII).packing
    assert np.array_equal(USES[use](accessor, "size"), expected)
    assert np.array_equal(USES[use](accessor, RADII), expected)
    assert not np.array_equal(USES[use](accessor, 2.0), expected)


def test_saved_with_given_radii(tmp_path):
    grid().packing.save(tmp_path / "a.xyzr", radius=RADII)
    assert spherepacking.read(tmp_path / "a.xyzr")["radius"].tolist() == RADII


def test_a_plotter_takes_them():
    def picture(dataset, radius):
        plotter = pv.Plotter(off_screen=True, window_size=(60, 60))
        try:
            plotter.packing.add(dataset, radius=radius, color="red")
            return np.array(plotter.screenshot(return_img=True))
        finally:
            plotter.close()

    expected = picture(mesh(radius=RADII), None)
    assert np.array_equal(picture(grid(d=DOUBLE), None), expected)
    assert np.array_equal(picture(grid(size=RADII), "size"), expected)
    assert np.array_equal(picture(pv.MultiBlock([grid(radii=RADII)]), None), expected)
    assert not np.array_equal(picture(grid(), 0.2), expected)


def test_a_plotter_traces_and_sums_them():
    plotter = pv.Plotter(off_screen=True, window_size=(60, 60))
    plotter.packing.path_trace(grid(size=RADII), radius="size", samples=1)
    plotter.packing.add_metaballs(grid(), radius=RADII, dimensions=8)
    plotter.close()


# --- the hierarchy is kept, and changes are seen --------------------------------------------------


def test_the_same_spheres_keep_their_hierarchy():
    accessor = grid(size=RADII).packing
    first = accessor.with_radius("size")
    second = accessor.with_radius(RADII)
    assert first.GetPoints() is second.GetPoints()
    kept = first.GetPointData().GetAbstractArray("radius")
    assert second.GetPointData().GetAbstractArray("radius") is kept


@pytest.mark.parametrize("name", ["radius", "Radius", "Diameter"])
@pytest.mark.parametrize("how", ["assigned", "in place"])
def test_changes_are_seen(name, how):
    dataset = grid(**{name: DOUBLE if name == "Diameter" else RADII})
    accessor = dataset.packing
    before = accessor.ray_cast(VIEW, SIZE)["sphere_id"]
    if how == "assigned":
        dataset[name] = 3.0 * np.asarray(dataset[name])
    else:
        dataset[name] *= 3.0
    after = accessor.ray_cast(VIEW, SIZE)["sphere_id"]
    expected = mesh(radius=3.0 * np.array(RADII)).packing.ray_cast(VIEW, SIZE)["sphere_id"]
    assert np.array_equal(after, expected)
    assert not np.array_equal(after, before)
    dataset.points[:] += 1.0
    expected = mesh(radius=3.0 * np.array(RADII))
    expected.points += 1.0
    assert np.array_equal(
        accessor.ray_cast(VIEW, SIZE)["sphere_id"],
        expected.packing.ray_cast(VIEW, SIZE)["sphere_id"],
    )


@pytest.mark.parametrize("point", [-1, 2, 2**30])
def test_cells_of_points_that_are_not_there(point):
    mesh = pv.PolyData(np.eye(3)[:2])
    mesh["radius"] = [1.0, 2.0]
    mesh.verts = [1, 0, 1, 1]
    mesh.cell_data["heat"] = [1.0, 2.0]
    # VTK checks no ids.
    mesh.GetVerts().GetConnectivityArray().SetComponent(1, 0, point)
    with pytest.raises(ValueError, match=f"packing: found a cell of the point {point}, expected"):
        packing_of(mesh, radius="heat")
