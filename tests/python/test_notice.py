"""Numbers that are written to: who sees it at once, and who after ``packing.packing.modified()``.

One rule: what keeps something of a packing shows it as it was when VTK was last told of a change,
all of it; everything else takes the numbers that are there.
"""

import numpy as np
import pytest
import pyvista as pv
import spherepacking

VIEW = [(4, 3, 2), (0, 0, 0), (0, 0, 1)]
SIZE = (50, 40)
COUNT = 300


def packing(kind=np.float64, count=COUNT):
    rng = np.random.default_rng(7)
    spheres = pv.PolyData(rng.uniform(-1, 1, (count, 3)).astype(kind))
    spheres["radius"] = rng.uniform(0.02, 0.05, count).astype(kind)
    spheres["height"] = np.linspace(0.0, 1.0, count)
    return spheres


# Ways to write into the array of radii, of which VTK is told by the first ones alone.
TOLD = {
    "assign": lambda p, r: p.point_data.set_array(np.asarray(r) * 3, "radius"),
    "item": lambda p, r: p["radius"].__setitem__(slice(None), np.asarray(r) * 3),
    "one item": lambda p, r: p["radius"].__setitem__(17, 0.5),
}
WHOLE = {
    "in place": lambda p, r: r.__imul__(3),
    "fill": lambda p, r: r.fill(0.1),
    "sort": lambda p, r: r.sort(),
    "out": lambda p, r: np.multiply(r, 3, out=r),
    "copyto": lambda p, r: np.copyto(r, np.full(len(r), 0.1, r.dtype)),
    "base": lambda p, r: np.asarray(r).__imul__(3),
    "put": lambda p, r: r.put(range(len(r)), 0.1),
}
SINGLE = {
    "flat": lambda p, r: r.flat.__setitem__(17, 0.5),
    "view": lambda p, r: np.asarray(r).__setitem__(17, 0.5),
    "at": lambda p, r: np.add.at(np.asarray(r), 17, 0.5),
    "centre": lambda p, r: np.asarray(p.points).__setitem__((17, 2), 1.5),
}
EVERY = TOLD | WHOLE | SINGLE
STRUCTURES = ["bvh", "grid", "none"]


def cast(spheres, structure="bvh", **kwargs):
    image = spheres.packing.ray_cast(VIEW, SIZE, structure=structure, **kwargs)
    return {name: np.array(image[name]) for name in ("sphere_id", "depth", "normal", "color")}


def same(first, second):
    return all(np.array_equal(first[name], second[name]) for name in first)


def fresh(spheres):
    """The same packing, of which nobody has kept anything."""
    return spheres.copy(deep=True)


@pytest.mark.parametrize("kind", [np.float32, np.float64])
@pytest.mark.parametrize("structure", STRUCTURES)
@pytest.mark.parametrize("way", EVERY)
def test_ray_cast(way, structure, kind):
    """It is of the new packing where VTK was told or the whole array changed, else of the old one.

    Old boxes around new spheres made a picture that was neither.
    """
    spheres = packing(kind)
    before = cast(spheres, structure)
    EVERY[way](spheres, spheres["radius"])
    expected = cast(fresh(spheres), structure)
    assert not same(before, expected)
    found = cast(spheres, structure)
    assert same(found, before if way in SINGLE else expected)
    spheres.packing.modified()
    assert same(cast(spheres, structure), expected)


@pytest.mark.parametrize("kind", [np.float32, np.float64])
@pytest.mark.parametrize("way", EVERY)
def test_pick(way, kind):
    spheres = packing(kind)

    def picks(spheres):
        found = [
            spheres.packing.pick(VIEW, SIZE, x, y) for x in range(0, 50, 3) for y in range(0, 40, 3)
        ]
        return [
            None if pick is None else (pick.sphere_id, *pick.point, *pick.normal) for pick in found
        ]

    before = picks(spheres)
    assert len(set(before)) > 20
    EVERY[way](spheres, spheres["radius"])
    expected = picks(fresh(spheres))
    found = picks(spheres)
    assert found == (before if way in SINGLE else expected)
    spheres.packing.modified()
    assert picks(spheres) == expected


@pytest.mark.parametrize("way", EVERY)
def test_path_trace_finds_everything(way):
    spheres = packing()

    def trace(spheres):
        image = spheres.packing.path_trace(VIEW, SIZE, samples=2, scalars="height")
        return {name: np.array(image[name]) for name in ("sphere_id", "radiance")}

    before = trace(spheres)
    EVERY[way](spheres, spheres["radius"])
    expected = trace(fresh(spheres))
    assert not same(before, expected)
    assert same(trace(spheres), expected)


@pytest.mark.parametrize("way", EVERY)
@pytest.mark.parametrize(
    "technique",
    {
        "metaballs": lambda p: p.metaballs(1.0, dimensions=16).points,
        "field": lambda p: p.metaball_field(dimensions=12)["field"],
        "contacts": lambda p: p.contacts(gap=0.5).lines,
        "boxes": lambda p: p.bvh_boxes(7).points,
        "grid": lambda p: p.grid_boxes(3).points,
        "bounds": lambda p: p.bounds,
        "volume": lambda p: p.volume,
    }.items(),
    ids=lambda pair: pair[0],
)
def test_what_keeps_nothing(way, technique):
    spheres = packing()
    compute = technique[1]
    before = np.array(compute(spheres.packing))
    EVERY[way](spheres, spheres["radius"])
    found = np.array(compute(spheres.packing))
    assert np.array_equal(found, compute(fresh(spheres).packing))
    if technique[0] in ("field", "volume"):
        assert way in ("sort", "centre") or not np.array_equal(before, found)


@pytest.mark.parametrize("way", EVERY)
def test_the_mapper(way):
    spheres = packing()
    plotter = pv.Plotter(off_screen=True, window_size=SIZE)
    other = pv.Plotter(off_screen=True, window_size=SIZE)
    try:
        for one in (plotter, other):
            one.render_window.SetMultiSamples(0)
            one.camera_position = VIEW

        def drawn(one):
            one.render()
            return np.array(one.screenshot(None, return_img=True))

        plotter.packing.add(spheres, color="red", reset_camera=False)
        before = drawn(plotter)
        EVERY[way](spheres, spheres["radius"])
        other.packing.add(fresh(spheres), color="red", reset_camera=False)
        expected = drawn(other)
        assert not np.array_equal(before, expected)
        plotter.renderer.ResetCameraClippingRange()
        found = drawn(plotter)
        assert np.array_equal(found, expected) or np.array_equal(found, before)
        spheres.packing.modified()
        assert np.array_equal(drawn(plotter), expected)
    finally:
        plotter.close()
        other.close()


def test_a_live_picture():
    spheres = packing()
    plotter = pv.Plotter(off_screen=True, window_size=SIZE)
    try:
        plotter.camera_position = VIEW
        plotter.packing.path_trace(spheres, samples=2, reset_camera=False)
        before = np.array(plotter.screenshot(None, return_img=True))
        np.asarray(spheres["radius"])[17] = 0.5
        spheres.packing.modified()
        plotter.render()
        assert not np.array_equal(plotter.screenshot(None, return_img=True), before)
    finally:
        plotter.close()


def test_scalars():
    spheres = packing()
    before = cast(spheres, scalars="height", clim=(0, 1))
    spheres["height"].sort()
    spheres["height"].fill(0.5)
    expected = cast(fresh(spheres), scalars="height", clim=(0, 1))
    assert not same(before, expected)
    assert same(cast(spheres, scalars="height", clim=(0, 1)), expected)
    np.asarray(spheres["height"])[17] = 1.0
    assert same(cast(spheres, scalars="height", clim=(0, 1)), expected)
    spheres.packing.modified()
    after = cast(fresh(spheres), scalars="height", clim=(0, 1))
    assert same(cast(spheres, scalars="height", clim=(0, 1)), after)


@pytest.mark.parametrize("count", [1, 2, 64])
@pytest.mark.parametrize("way", ["flat", "view", "centre"])
def test_of_few_spheres_all_are_looked_at(way, count, monkeypatch):
    spheres = packing(count=count)
    cast(spheres)
    last = {"flat": SINGLE["flat"], "view": SINGLE["view"], "centre": SINGLE["centre"]}[way]
    if count <= 17:
        np.asarray(spheres["radius"])[-1] = 0.4
    else:
        last(spheres, spheres["radius"])
    assert same(cast(spheres), cast(fresh(spheres)))


def test_other_datasets():
    grid = pv.ImageData(dimensions=(3, 3, 3))
    grid["d"] = np.full(27, 0.4)
    mesh = pv.UnstructuredGrid(packing())
    blocks = pv.MultiBlock([packing(), packing()])
    for dataset, array in (
        (grid, grid["d"]),
        (mesh, mesh["radius"]),
        (blocks, blocks[0]["radius"]),
    ):
        cast(dataset)
        np.asarray(array)[3] = 0.9
        dataset.packing.modified()
        assert same(cast(dataset), cast(dataset.copy(deep=True)))


def test_large_packings_are_looked_at_all_over(rng):
    """Changes of a part, such as the first or the last tenth, are found, too."""
    spheres = packing(count=5000)
    for part in (slice(0, 500), slice(4500, 5000), slice(2000, 2500)):
        cast(spheres)
        np.asarray(spheres["radius"])[part] *= 2
        assert same(cast(spheres), cast(fresh(spheres)))


def test_wrong_numbers_are_found():
    spheres = packing()
    cast(spheres)
    np.asarray(spheres["radius"])[:] = -1.0
    with pytest.raises(ValueError, match="holds -1 at point 0"):
        cast(spheres)


def test_nothing_is_wrong_with_an_empty_packing():
    empty = pv.PolyData()
    empty.packing.modified()
    assert empty.packing.ray_cast(VIEW, SIZE)["sphere_id"].max() == -1
    assert spherepacking.apollonian(1).packing.modified() is None
