"""Pictures of vtkSpherePackingTracer: rays of the camera, structures, tiles, samples, colors."""

import os
import subprocess
import sys

import numpy as np
import pytest
import pyvista as pv
import spherepacking
from arrays import packing_of
from rays import Exact
from spherepacking.backend import reference, vtkSpherePackingTracer
from test_tracer_rays import CASES

STRUCTURES = {"none": 0, "grid": 1, "bvh": 2}
ARRAYS = ("color", "depth", "normal", "sphere_id")


def camera_of(position, focal_point=(0, 0, 0), up=(0, 0, 1), angle=30.0, scale=None):
    camera = pv.Camera()
    camera.position, camera.focal_point, camera.up = position, focal_point, up
    camera.view_angle = angle
    if scale is not None:
        camera.parallel_projection = True
        camera.parallel_scale = scale
    return camera


def tracer_of(packing, camera, size=(40, 30), structure="bvh"):
    tracer = vtkSpherePackingTracer()
    tracer.SetInputData(packing)
    tracer.SetCamera(camera)
    tracer.SetWindowSize(size)
    tracer.SetStructure(STRUCTURES[structure])
    return tracer


def picture(tracer):
    tracer.Update()
    assert tracer.GetErrorMessage() == ""
    image = pv.wrap(tracer.GetOutput())
    return {name: np.array(image.point_data[name]) for name in ARRAYS}


def camera_rays(camera, size):
    """Origins and directions (pixels, 3) by the definition of a camera, rows from the bottom."""
    position, focal = np.array(camera.position), np.array(camera.focal_point)
    towards = (focal - position) / np.linalg.norm(focal - position)
    right = np.cross(towards, camera.up)
    right /= np.linalg.norm(right)
    up = np.cross(right, towards)
    half = camera.parallel_scale
    if not camera.parallel_projection:
        half = np.tan(np.radians(camera.view_angle) / 2)
    y, x = np.mgrid[: size[1], : size[0]]
    x = ((x + 0.5) - size[0] / 2).ravel()[:, None] * (2 * half / size[1])
    y = ((y + 0.5) - size[1] / 2).ravel()[:, None] * (2 * half / size[1])
    across = x * right + y * up
    if camera.parallel_projection:
        return position + across, np.tile(towards, (len(across), 1))
    return np.tile(position, (len(across), 1)), towards + across


def random_scene(rng, n=500):
    return rng.uniform(-1, 1, (n, 3)), rng.uniform(0.01, 0.12, n)


def far_scene(rng):
    return 1e7 + rng.uniform(-1, 1, (300, 3)), rng.uniform(0.01, 0.1, 300)


VIEWS = {
    "perspective": camera_of((3, 3, 3)),
    "parallel": camera_of((3, 3, 3), scale=1.2),
    "parallel from 1000 extents away": camera_of((2000, 1500, 1200), scale=1.2),
    "narrow from 1000 extents away": camera_of((2000, 1500, 1200), angle=0.05),
    "inside": camera_of((0.1, 0.05, 0.02), (1, 0.3, 0.1), angle=100.0),
    "along an axis": camera_of((0, 0, 4), up=(0, 1, 0), scale=1.0),
    "beside the scene": camera_of((3, 0, 0), (3, 3, 0)),
}


@pytest.mark.parametrize("view", VIEWS)
def test_pictures_against_long_double(rng, view):
    centers, radii = random_scene(rng)
    camera, size = VIEWS[view], (40, 30)
    found = {s: picture(tracer_of(packing_of(centers, radii), camera, size, s)) for s in STRUCTURES}
    for structure in STRUCTURES:
        for name in ARRAYS:
            np.testing.assert_array_equal(found[structure][name], found["none"][name])
    ids, depth = found["bvh"]["sphere_id"], found["bvh"]["depth"].astype(float)
    origins, directions = camera_rays(camera, size)
    exact = Exact(centers, radii, origins, directions)
    first = exact.first()
    hit = ids >= 0
    # The rays themselves are rounded, and where a pixel's silhouette passes that may decide: on
    # none of these pixels.
    np.testing.assert_array_equal(
        ids, np.where(first.min(axis=1) < np.inf, first.argmin(axis=1), -1)
    )
    np.testing.assert_allclose(depth[hit], first.min(axis=1)[hit].astype(float), rtol=1e-6)
    assert np.isinf(depth[~hit]).all()
    normals = exact.normals(np.flatnonzero(hit), ids[hit]).astype(float)
    grazing = exact.cosine[hit, ids[hit]].astype(float)
    error = np.linalg.norm(found["bvh"]["normal"][hit] - normals, axis=1)
    assert (error * grazing <= 1e-6).all()
    assert (found["bvh"]["normal"][~hit] == 0).all()
    assert (found["bvh"]["color"][~hit] == 0).all()
    assert hit.any() == (view != "beside the scene")


@pytest.mark.parametrize("case", CASES)
def test_pictures_of_hard_cases(rng, case):
    """Blocks of rays see what single rays see, which are tested against long double."""
    centers, radii = CASES[case](rng)
    packing = packing_of(centers, radii)
    low, high = (centers - radii[:, None]).min(axis=0), (centers + radii[:, None]).max(axis=0)
    middle, extent = (low + high) / 2, np.max(high - low)
    size = (48, 36)
    seen = 0
    for *view, angle in ((0.9, 0.8, 0.7, 20.0), (0.0, 0.0, 2.0, 40.0), (0.05, 0.0, 0.02, 90.0)):
        camera = camera_of(middle + extent * np.array(view), middle, up=(0, 1, 0), angle=angle)
        found = {s: picture(tracer_of(packing, camera, size, s)) for s in STRUCTURES}
        for structure in STRUCTURES:
            for name in ARRAYS:
                np.testing.assert_array_equal(
                    found[structure][name], found["none"][name], err_msg=structure
                )
        tracer = tracer_of(packing, camera, size)
        ids, depth = found["bvh"]["sphere_id"], found["bvh"]["depth"]
        t, normal = reference(0.0), [0.0, 0.0, 0.0]
        for pixel in range(ids.size):
            x, y = pixel % size[0] + 0.5, pixel // size[0] + 0.5
            assert tracer.CastPixel(x, y, t, normal) == ids[pixel]
            assert np.float32(float(t)) == depth[pixel]
        seen += (ids >= 0).sum()
    assert seen > 0


@pytest.mark.parametrize("structure", STRUCTURES)
def test_centers_at_1e7(rng, structure):
    centers, radii = far_scene(rng)
    camera = camera_of((1e7 + 3, 1e7 + 3, 1e7 + 3), (1e7, 1e7, 1e7))
    found = picture(tracer_of(packing_of(centers, radii), camera, structure=structure))
    exact = Exact(centers, radii, *camera_rays(camera, (40, 30)))
    first = exact.first()
    expected = np.where(first.min(axis=1) < np.inf, first.argmin(axis=1), -1)
    # The camera's own matrices hold positions to 2e-9: pixels nearer than that to a silhouette.
    near = (np.abs(exact.clearance) < 1e-7).any(axis=1)
    np.testing.assert_array_equal(found["sphere_id"][~near], expected[~near])
    assert near.mean() < 0.01


def test_an_explicit_off_axis_camera(rng):
    """A window centre off the middle, and an angle of view across instead of upwards."""
    centers, radii = random_scene(rng)
    camera = camera_of((3, 3, 3))
    camera.SetWindowCenter(0.4, -0.2)
    camera.SetUseHorizontalViewAngle(True)
    size = (40, 30)
    found = picture(tracer_of(packing_of(centers, radii), camera, size))
    matrix = camera.GetCompositeProjectionTransformMatrix(size[0] / size[1], -1, 1)
    matrix = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    from spherepacking.testing import reference

    y, x = np.mgrid[: size[1], : size[0]]
    rays = reference.pixel_rays(matrix, size, x.ravel(), y.ravel())
    first = Exact(centers, radii, rays.origin, rays.direction).first()
    expected = np.where(first.min(axis=1) < np.inf, first.argmin(axis=1), -1)
    assert (found["sphere_id"] != expected).sum() <= 1
    assert (expected >= 0).any()


@pytest.mark.parametrize("tile", [(1, 1), (7, 3), (8, 8), (1000, 1), (64, 64)])
@pytest.mark.parametrize("structure", STRUCTURES)
def test_tiles_do_not_show(rng, tile, structure):
    packing = packing_of(*random_scene(rng, 100))
    tracer = tracer_of(packing, VIEWS["perspective"], (37, 29), structure)
    tracer.SetSamples(2)
    whole = picture(tracer)
    tracer.SetTileSize(tile)
    tiled = picture(tracer)
    for name in ARRAYS:
        np.testing.assert_array_equal(tiled[name], whole[name])


@pytest.mark.parametrize("view", VIEWS)
@pytest.mark.parametrize("samples", [2, 3])
def test_samples_are_those_of_a_larger_picture(rng, view, samples):
    packing = packing_of(*random_scene(rng))
    few = tracer_of(packing, VIEWS[view], (40, 30))
    few.SetRandomColors(True)
    few.SetSamples(samples)
    many = tracer_of(packing, VIEWS[view], (40 * samples, 30 * samples))
    many.SetRandomColors(True)
    fine = picture(many)["color"].reshape(30, samples, 40, samples, 4).astype(float)
    alpha = fine[..., 3].mean(axis=(1, 3))
    weighted = (fine[..., :3] * fine[..., 3:]).mean(axis=(1, 3))
    with np.errstate(invalid="ignore"):
        mean = np.nan_to_num(weighted / alpha[..., None])
    found = picture(few)["color"].reshape(30, 40, 4).astype(float)
    # Rounded once more; a sample at a silhouette may differ, for its ray is rounded otherwise.
    wrong = (np.abs(found[..., 3] - alpha) > 0.51) | (np.abs(found[..., :3] - mean).max(-1) > 0.51)
    assert wrong.sum() <= 1
    one = tracer_of(packing, VIEWS[view], (40, 30))
    for name in ("depth", "normal", "sphere_id"):
        np.testing.assert_array_equal(picture(few)[name], picture(one)[name])


def test_colors_of_scalars_and_light(rng):
    centers, radii = random_scene(rng)
    packing = packing_of(centers, radii)
    packing.GetPointData().AddArray(pv.convert_array(np.arange(500.0), name="order"))
    tracer = tracer_of(packing, VIEWS["perspective"])
    tracer.SetColorArrayName("order")
    table = pv.LookupTable("viridis", n_values=500)
    table.scalar_range = (0, 499)
    tracer.SetLookupTable(table)
    found = picture(tracer)
    hit = found["sphere_id"] >= 0
    colors = np.round(255 * table(found["sphere_id"][hit].astype(float))[:, :3])
    light = np.abs(found["normal"][hit] @ (np.ones(3) / np.sqrt(3)))  # headlight from (3, 3, 3)
    expected = colors * light[:, None]
    assert np.abs(found["color"][hit, :3] - expected).max() < 0.51
    assert (found["color"][hit, 3] == 255).all()


def test_one_color_and_random_ones(rng):
    packing = packing_of(*random_scene(rng))
    tracer = tracer_of(packing, VIEWS["perspective"])
    tracer.SetColor(1.0, 0.0, 0.5)
    found = picture(tracer)
    hit = found["sphere_id"] >= 0
    assert (found["color"][hit, 1] == 0).all()
    assert found["color"][hit, 0].max() > 250
    tracer.SetRandomColors(True)
    random = picture(tracer)
    # Where a sphere faces the camera its colour itself is seen.
    bright = hit & (found["color"][:, 0] > 240)
    ids, at = np.unique(random["sphere_id"][bright], return_index=True)
    colors = random["color"][bright][at, :3]
    assert len(ids) > 20
    assert len(np.unique(colors, axis=0)) > 0.9 * len(ids)
    assert colors.min() > 50
    assert colors.std(axis=0).min() > 30


@pytest.mark.parametrize("points", [np.float32, np.float64, np.int32])
@pytest.mark.parametrize("radii", [np.float32, np.float64, np.uint8])
def test_any_numeric_arrays(points, radii):
    packing = packing_of(np.array([[0, 0, 0], [4, 0, 0]], points), np.array([1, 2], radii))
    camera = camera_of((0, 0, 10), up=(0, 1, 0), scale=8.0)
    found = picture(tracer_of(packing, camera, (64, 64)))["sphere_id"].reshape(64, 64)
    assert (found[32, 32], found[32, 48]) == (0, 1)
    # Areas of discs, in pixels of a quarter.
    assert (found == 0).sum() == pytest.approx(np.pi * 16, rel=0.1)
    assert (found == 1).sum() == pytest.approx(np.pi * 64, rel=0.1)


@pytest.mark.parametrize("structure", STRUCTURES)
def test_an_empty_packing_gives_an_empty_picture(structure):
    found = picture(tracer_of(pv.PolyData(), VIEWS["perspective"], structure=structure))
    assert (found["sphere_id"] == -1).all()
    assert np.isinf(found["depth"]).all()
    assert not found["color"].any()


@pytest.mark.parametrize("structure", STRUCTURES)
def test_spheres_of_radius_zero_only(structure):
    packing = packing_of(np.zeros((3, 3)), np.zeros(3))
    assert (
        picture(tracer_of(packing, VIEWS["perspective"], structure=structure))["sphere_id"] < 0
    ).all()


def test_what_has_changed_is_seen(rng):
    packing = packing_of(np.zeros((2, 3)), [1.0, 0.5])
    tracer = tracer_of(packing, VIEWS["perspective"])
    assert set(picture(tracer)["sphere_id"]) == {-1, 0}
    build = pv.wrap(tracer.GetOutput()).field_data["build_seconds"][0]
    tracer.SetCamera(VIEWS["parallel"])
    picture(tracer)
    assert pv.wrap(tracer.GetOutput()).field_data["build_seconds"][0] == build, "is kept"
    radii = packing.GetPointData().GetArray("radius")
    radii.SetValue(1, 2.0)
    radii.Modified()
    packing.Modified()
    assert set(picture(tracer)["sphere_id"]) == {1}
    camera = camera_of((9, 9, 9))
    tracer.SetCamera(camera)
    before = (picture(tracer)["sphere_id"] == 1).sum()
    camera.position = (5, 5, 5)
    assert (picture(tracer)["sphere_id"] == 1).sum() > before


def test_times_and_memory_of_tiles(rng):
    packing = packing_of(*random_scene(rng))
    tracer = tracer_of(packing, VIEWS["perspective"], (100, 50))
    tracer.SetTileSize(32, 32)
    tracer.Update()
    fields = pv.wrap(tracer.GetOutput()).field_data
    extents = np.array(fields["tile_extents"])
    covered = np.zeros((50, 100), int)
    for x0, x1, y0, y1 in extents:
        covered[y0 : y1 + 1, x0 : x1 + 1] += 1
    assert (covered == 1).all()
    assert len(extents) == len(fields["compute_seconds"]) == len(fields["partial_seconds"]) == 8
    assert (np.array(fields["compute_seconds"]) > 0).all()
    assert (np.array(fields["partial_seconds"]) >= np.array(fields["compute_seconds"])).all()
    assert fields["complete_seconds"][0] >= np.max(fields["partial_seconds"])
    assert fields["memory_bytes"][0] > 500 * 16
    tracer.SetStructure(0)
    tracer.Update()
    assert pv.wrap(tracer.GetOutput()).field_data["memory_bytes"][0] == 0


def test_progress_of_every_tile(rng):
    packing = packing_of(*random_scene(rng))
    tracer = tracer_of(packing, VIEWS["perspective"], (400, 400), "none")
    tracer.SetTileSize(16, 16)
    seen = []
    tracer.AddObserver("ProgressEvent", lambda caller, _: seen.append(caller.GetProgress()))
    tracer.Update()
    tiles = sorted(p for p in seen if p > 0)
    assert len(set(tiles)) >= 625
    assert tiles[-1] == 1


def test_abort_leaves_tiles_out(rng):
    """Each tile takes so long that even very many cores begin few before the first is reported."""
    packing = packing_of(*random_scene(rng, 20_000))
    tracer = tracer_of(packing, VIEWS["perspective"], (1600, 1600), "none")
    tracer.SetTileSize(16, 16)

    def stop(caller, _):
        if caller.GetProgress() > 0:
            caller.SetAbortExecute(1)

    tracer.AddObserver("ProgressEvent", stop)
    tracer.Update()
    made = np.array(pv.wrap(tracer.GetOutput()).field_data["compute_seconds"]) > 0
    assert made.size == 10_000
    assert 1 <= made.sum() < made.size / 4


def refusal(change):
    packing = packing_of(np.zeros((1, 3)), [1.0])
    tracer = tracer_of(packing, camera_of((3, 3, 3)))
    messages = []

    def listen(_caller, _event, text):
        messages.append(text)

    listen.CallDataType = "string0"
    tracer.AddObserver("ErrorEvent", listen)
    tracer.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
    change(tracer, packing)
    tracer.Update()
    assert tracer.GetErrorCode() != 0
    assert tracer.GetErrorMessage() in messages[0]
    assert len(messages) == 1
    assert tracer.GetOutput().GetPointData().GetNumberOfArrays() == 0
    return tracer.GetErrorMessage()


BAD = {
    "window_size: found 0 5, expected": lambda t, p: t.SetWindowSize(0, 5),
    "window_size: found 5 -1, expected": lambda t, p: t.SetWindowSize(5, -1),
    "window_size: found 1000000 1000000, which is more than": lambda t, p: t.SetWindowSize(
        1000000, 1000000
    ),
    "tile: found 0 5, expected": lambda t, p: t.SetTileSize(0, 5),
    "camera: found none, expected one": lambda t, p: t.SetCamera(None),
    "camera: found one without a picture": lambda t, p: t.SetCamera(
        camera_of((0, 0, 3), up=(0, 0, 1))
    ),
    "cuts: found -2, expected 0 or more, or -1": lambda t, p: (t.SetStructure(1), t.SetCuts(-2)),
    "cuts: found 100000, which makes more cells": lambda t, p: (
        t.SetStructure(1),
        t.SetCuts(100000),
    ),
    "scalars: the packing has no point array 'mass'": lambda t, p: t.SetColorArrayName("mass"),
    "packing: found spheres over a length of 2e-200 at": lambda t, p: t.SetInputData(
        packing_of(np.zeros((1, 3)), [1e-200])
    ),
    "packing: found spheres over a length of 200000 at coordinates up to 1e+31": lambda t, p: (
        t.SetInputData(packing_of(np.array([[1e31, 0, 0]]), [1e5]))
    ),
    "packing: found spheres from -1.5e+308 to 1.5e+308 along x": lambda t, p: t.SetInputData(
        packing_of(np.array([[-1.5e308, 0, 0], [1.5e308, 0, 0]]), [1.0, 1.0])
    ),
    "found no point array 'width'": lambda t, p: t.SetRadiusArrayName("width"),
}


@pytest.mark.parametrize("message", BAD)
def test_refusals(message):
    assert message in refusal(BAD[message])


def test_numbers_that_are_clamped():
    tracer = vtkSpherePackingTracer()
    for number, expected in ((0, 1), (-3, 1), (99, 16), (3, 3)):
        tracer.SetSamples(number)
        assert tracer.GetSamples() == expected


def test_a_camera_that_is_not_finite():
    def spoil(tracer, _packing):
        tracer.GetCamera().SetPosition(float("nan"), 0, 0)

    assert "camera: found one without a picture" in refusal(spoil)


def test_large_spheres_in_small_cells(rng):
    """A list of all spheres in each of many cells would not fit anywhere."""
    packing = packing_of(rng.random((20000, 3)), np.full(20000, 10.0))
    tracer = tracer_of(packing, camera_of((30, 30, 30)), (8, 8), "grid")
    found = picture(tracer)
    np.testing.assert_array_equal(
        found["sphere_id"],
        picture(tracer_of(packing, camera_of((30, 30, 30)), (8, 8)))["sphere_id"],
    )
    assert pv.wrap(tracer.GetOutput()).field_data["memory_bytes"][0] < 1e8
    tracer.AddObserver("ErrorEvent", lambda *_: None)
    tracer.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
    tracer.SetCuts(600)
    tracer.Update()
    assert "more cells than fit in half of the memory" in tracer.GetErrorMessage()


ANY_PROCESSOR = """
import sys
import numpy as np, pyvista as pv, spherepacking
packing = spherepacking.apollonian(6)
pictures = {}
for structure in ("bvh", "grid"):
    for scale in (None, 1.3):
        camera = pv.Camera()
        camera.position, camera.focal_point, camera.up = (3, 2, 1.5), (0, 0, 0), (0, 0, 1)
        if scale:
            camera.parallel_projection, camera.parallel_scale = True, scale
        image = packing.packing.ray_cast(camera, (200, 150), structure=structure, samples=2)
        for name in image.point_data:
            pictures[f"{structure} {scale} {name}"] = np.array(image[name])
np.savez(sys.argv[1], **pictures)
"""


def test_every_processor_makes_the_same_picture(tmp_path):
    """With the vectors of this processor and with those that every one has."""
    made = []
    for without in ({}, {"SPHEREPACKING_WITHOUT_AVX2": "1"}):
        path = tmp_path / f"{len(without)}.npz"
        subprocess.run(
            [sys.executable, "-c", ANY_PROCESSOR, path], env=os.environ | without, check=True
        )
        made.append(np.load(path))
    assert len(made[0].files) == 16
    for name in made[0].files:
        np.testing.assert_array_equal(made[0][name], made[1][name], err_msg=name)


def test_apollonian_circles_touch(rng):
    """Spheres that touch without overlapping: no pixel of one shows through another."""
    packing = spherepacking.apollonian(5)
    found = {
        s: picture(tracer_of(packing, camera_of((1.6, 1.2, 1.4)), (60, 60), s)) for s in STRUCTURES
    }
    for name in ARRAYS:
        np.testing.assert_array_equal(found["bvh"][name], found["none"][name])
        np.testing.assert_array_equal(found["grid"][name], found["none"][name])
    rays = camera_rays(camera_of((1.6, 1.2, 1.4)), (60, 60))
    exact = Exact(packing.points, packing["radius"], *rays)
    first = exact.first()
    expected = np.where(first.min(axis=1) < np.inf, first.argmin(axis=1), -1)
    np.testing.assert_array_equal(found["bvh"]["sphere_id"], expected)
