"""vtkSpherePackingPathTracer: the same picture however it is made, what is kept, refusals."""

import os
import subprocess
import sys

import numpy as np
import pytest
import pyvista as pv
from arrays import packing_of
from spherepacking.backend import vtkSpherePackingPathTracer

STRUCTURES = {"none": 0, "grid": 1, "bvh": 2}
ARRAYS = {
    "radiance": (np.float32, 3),
    "albedo": (np.float32, 3),
    "normal": (np.float32, 3),
    "depth": (np.float32, 1),
    "coverage": (np.float32, 1),
    "variance": (np.float32, 1),
    "sphere_id": (np.int64, 1),
    "samples": (np.uint32, 1),
    "color": (np.uint8, 4),
}
SIZE = (70, 50)


def scene(rng, n=150):
    return packing_of(rng.uniform(-1, 1, (n, 3)), rng.uniform(0.05, 0.3, n))


def tracer_of(packing, samples=6, size=SIZE, structure="bvh"):
    tracer = vtkSpherePackingPathTracer()
    tracer.SetInputData(packing)
    camera = pv.Camera()
    camera.position, camera.focal_point, camera.up = (4, 3, 2), (0, 0, 0), (0, 0, 1)
    tracer.SetCamera(camera)
    tracer.SetWindowSize(size)
    tracer.SetStructure(STRUCTURES[structure])
    tracer.SetNumberOfSamples(samples)
    tracer.SetSkyBottom(0.2, 0.3, 0.4)
    tracer.SetSunDirection(1, -1, 2)
    tracer.SetSunRadiance(2, 1.5, 1)
    tracer.SetRandomColors(True)
    return tracer


def run(tracer):
    tracer.Modified()
    tracer.Update()
    assert tracer.GetErrorMessage() == ""
    image = pv.wrap(tracer.GetOutput())
    arrays = {name: np.array(image.point_data[name]) for name in image.point_data}
    return arrays, float(image.field_data["traced_samples"][0])


def same(one, other):
    assert one.keys() == other.keys()
    for name in one:
        np.testing.assert_array_equal(one[name], other[name], err_msg=name)


def test_arrays(rng):
    arrays, traced = run(tracer_of(scene(rng)))
    shapes = {name: (a.dtype, a.shape[1] if a.ndim > 1 else 1) for name, a in arrays.items()}
    assert shapes == ARRAYS
    assert traced == 6 * SIZE[0] * SIZE[1]
    assert (arrays["samples"] == 6).all()
    hit = arrays["coverage"] > 0
    assert 0.2 < hit.mean() < 0.9
    assert ((arrays["sphere_id"] >= 0) == np.isfinite(arrays["depth"])).all()
    assert (arrays["albedo"][~hit] == 0).all()
    whole = arrays["coverage"] == 1
    assert (arrays["albedo"][whole] > 0).all()
    assert np.linalg.norm(arrays["normal"][whole], axis=1).max() < 1 + 1e-6


@pytest.mark.parametrize("double", [False, True])
def test_structures_and_tiles_do_not_show(rng, double):
    packing = scene(rng)
    if not double:
        packing = packing_of(
            packing.points.astype(np.float32), packing["radius"].astype(np.float32)
        )
    expected = run(tracer_of(packing, structure="none"))[0]
    for structure, tile in (("bvh", 64), ("bvh", 7), ("bvh", 1000), ("grid", 16), ("none", 33)):
        tracer = tracer_of(packing, structure=structure)
        tracer.SetTileSize(tile, tile + 1)
        same(run(tracer)[0], expected)


def test_threads_and_processors_do_not_show(rng, tmp_path):
    """Every kind of processor and number of threads makes the same picture."""
    program = """
import sys
sys.path.insert(0, sys.argv[1])
import numpy as np
from test_path_tracer import run, scene, tracer_of
np.savez(sys.argv[2], **run(tracer_of(scene(np.random.default_rng(3))))[0])
"""
    pictures = []
    for i, variables in enumerate(
        ({}, {"SPHEREPACKING_WITHOUT_AVX2": "1"}, {"VTK_SMP_MAX_THREADS": "1"})
    ):
        path = tmp_path / f"{i}.npz"
        subprocess.run(
            [sys.executable, "-c", program, os.path.dirname(__file__), path],
            env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path), **variables},
            check=True,
        )
        with np.load(path) as arrays:
            pictures.append(dict(arrays))
    same(pictures[1], pictures[0])
    same(pictures[2], pictures[0])


def test_more_samples_go_on(rng):
    packing = scene(rng)
    expected, _ = run(tracer_of(packing, 21))
    tracer = tracer_of(packing, 5)
    first, _ = run(tracer)
    kept = pv.ImageData()
    kept.ShallowCopy(tracer.GetOutput())
    tracer.SetNumberOfSamples(21)
    arrays, traced = run(tracer)
    same(arrays, expected)
    assert traced == 16 * SIZE[0] * SIZE[1]
    # What was handed out before is as it was.
    same({name: np.array(kept.point_data[name]) for name in kept.point_data}, first)
    # Nothing is traced for what is there, nor for another look of it.
    assert run(tracer)[1] == 0
    tracer.SetExposure(1.0)
    brighter, traced = run(tracer)
    assert traced == 0
    assert (brighter["radiance"] == expected["radiance"]).all()
    assert (brighter["color"] > expected["color"]).any()
    # Fewer samples are another picture, the one that they would have been.
    tracer.SetExposure(0.0)
    tracer.SetNumberOfSamples(5)
    same(run(tracer)[0], first)


@pytest.mark.parametrize("array", ["radiance", "samples", "sphere_id", "color"])
def test_what_was_written_into_is_made_anew(rng, array):
    """Even if nobody said that it was, as NumPy does not."""
    packing = scene(rng)
    tracer = tracer_of(packing, 5)
    expected, _ = run(tracer)
    values = pv.convert_array(tracer.GetOutput().GetPointData().GetArray(array))
    values.reshape(-1)[values.size // 3] += 1
    again, traced = run(tracer)
    assert traced == 5 * SIZE[0] * SIZE[1]
    same(again, expected)


CHANGES = {
    "camera": lambda t, p: t.GetCamera().SetPosition(4, 3, 2.1),
    "seed": lambda t, p: t.SetSeed(1),
    "albedo": lambda t, p: t.SetAlbedo(0.5),
    "bounces": lambda t, p: t.SetMaximumNumberOfBounces(2),
    "sky": lambda t, p: t.SetSkyTop(1, 1, 0.5),
    "sun": lambda t, p: t.SetSunDirection(1, 1, 2),
    "sun's size": lambda t, p: t.SetSunDiameter(20.0),
    "colours": lambda t, p: t.SetRandomColors(False),
    "radii": lambda t, p: (p["radius"].__imul__(0.9), p["radius"].VTKObject.Modified()),
    "size": lambda t, p: t.SetWindowSize(60, 50),
}


@pytest.mark.parametrize("change", CHANGES)
def test_changes_start_again(rng, change):
    packing = pv.wrap(scene(rng))
    tracer = tracer_of(packing)
    first, _ = run(tracer)
    CHANGES[change](tracer, packing)
    arrays, traced = run(tracer)
    assert traced == 6 * arrays["samples"].size
    assert change == "size" or (arrays["radiance"] != first["radiance"]).any()
    fresh = tracer_of(packing)
    CHANGES[change](fresh, packing) if change != "radii" else None
    same(arrays, run(fresh)[0])


def test_an_abort_keeps_what_is_done(rng):
    packing = scene(rng)
    expected, _ = run(tracer_of(packing, 24))
    tracer = tracer_of(packing, 24)
    tracer.SetTileSize(16, 16)
    shares = []

    def stop(caller, _):
        shares.append(caller.GetProgress())
        if caller.GetProgress() > 0.5:
            caller.SetAbortExecute(1)

    tag = tracer.AddObserver("ProgressEvent", stop)
    arrays, traced = run(tracer)
    assert sorted(shares) == shares
    assert arrays["samples"].min() >= 8
    assert arrays["samples"].max() < 24
    tracer.RemoveObserver(tag)
    tracer.SetAbortExecute(0)
    tracer.SetTileSize(50, 9)
    arrays, more = run(tracer)
    assert traced + more == 24 * arrays["samples"].size
    same(arrays, expected)


def test_a_time_budget(rng):
    packing = scene(rng)
    tracer = tracer_of(packing, 100_000)
    tracer.SetTimeBudget(0.3)
    arrays, _ = run(tracer)
    assert 1 <= arrays["samples"].min() <= arrays["samples"].max() < 100_000
    least = int(arrays["samples"].max())
    tracer.SetTimeBudget(0.0)
    tracer.SetNumberOfSamples(least)
    same(run(tracer)[0], run(tracer_of(packing, least))[0])
    # Even if there is no time at all.
    tracer.SetSeed(5)
    tracer.SetTimeBudget(1e-9)
    assert (run(tracer)[0]["samples"] >= 1).all()


def test_a_preview(rng):
    packing = scene(rng)
    expected, _ = run(tracer_of(packing, 8))
    tracer = tracer_of(packing, 8)
    tracer.SetTimeBudget(1e-9)
    tracer.SetPreview(True)
    tracer.SetTileSize(8, 8)
    arrays, traced = run(tracer)
    samples = arrays["samples"].reshape(SIZE[::-1])
    assert (samples[::2, ::2] == 1).all()
    assert traced < samples.size / 2
    color = arrays["color"].reshape(*SIZE[::-1], 4)
    for y, x in ((0, 1), (1, 0), (1, 1)):
        # Where a pixel has no light it shows its neighbour's.
        none = samples[y::2, x::2] == 0
        assert none.any()
        assert (color[y::2, x::2][none] == color[::2, ::2][none]).all()
    # What the middles show is there at once.
    assert (arrays["sphere_id"] == expected["sphere_id"]).all()
    assert (arrays["depth"] == expected["depth"]).all()
    tracer.SetTimeBudget(0.0)
    same(run(tracer)[0], expected)


def test_a_noise_target(rng):
    packing = scene(rng)

    def tracer(tile=64, samples=256):
        made = tracer_of(packing, samples)
        made.SetNoiseTarget(0.08)
        made.SetMinimumNumberOfSamples(8)
        made.SetTileSize(tile, tile)
        return made

    arrays, traced = run(tracer())
    samples = arrays["samples"].reshape(SIZE[::-1])
    assert samples.min() >= 8
    assert samples.min() < samples.max()
    assert traced == samples.sum()
    brightness = arrays["radiance"] @ [0.2126, 0.7152, 0.0722]
    for y in range(0, SIZE[1], 32):
        for x in range(0, SIZE[0], 32):
            cell = np.s_[y : y + 32, x : x + 32]
            assert len(np.unique(samples[cell])) == 1
            mean = brightness.reshape(SIZE[::-1])[cell].mean()
            error = np.sqrt(arrays["variance"].reshape(SIZE[::-1])[cell].mean()) / mean
            assert error <= 0.08 * (1 + 1e-4) or samples[cell].max() == 256
    # Tiles do not show, nor that it was made in two steps.
    same(run(tracer(tile=13))[0], arrays)
    steps = tracer(samples=12)
    run(steps)
    steps.SetNumberOfSamples(256)
    same(run(steps)[0], arrays)


def test_colors(rng):
    tracer = tracer_of(scene(rng), 16)
    tracer.SetExposure(-1.0)
    arrays, _ = run(tracer)
    light = np.clip(arrays["radiance"].astype(float) / 2, 0, 1)
    encoded = np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)
    assert np.abs(arrays["color"][:, :3] - 255 * encoded).max() <= 0.5 + 1e-3
    assert (arrays["color"][:, 3] == 255).all()
    tracer.SetSkyVisible(False)
    hidden, traced = run(tracer)
    assert traced == 0
    assert np.abs(hidden["color"][:, 3] - 255 * arrays["coverage"]).max() <= 0.5 + 1e-3
    assert (hidden["color"][arrays["coverage"] == 0] == 0).all()
    whole = arrays["coverage"] == 1
    assert (hidden["color"][whole] == arrays["color"][whole]).all()
    tracer.SetFilmic(True)
    tracer.SetExposure(3.0)
    filmic, _ = run(tracer)
    assert (filmic["color"][whole, :3] < 255).any()


@pytest.mark.parametrize("structure", STRUCTURES)
def test_an_empty_packing_shows_the_sky(structure):
    tracer = tracer_of(packing_of(np.empty((0, 3)), np.empty(0)), structure=structure)
    arrays, _ = run(tracer)
    assert (arrays["sphere_id"] == -1).all()
    assert (arrays["coverage"] == 0).all()
    assert arrays["radiance"].min() >= 0.2


def bad_sky(values, components=3):
    image = pv.ImageData(dimensions=(4, 2, 1))
    image["light"] = np.full((8, components) if components > 1 else 8, values)
    image.set_active_scalars("light")
    return image


BAD = {
    "samples: found 0, expected": lambda t: t.SetNumberOfSamples(0),
    "max_bounces: found -1, expected": lambda t: t.SetMaximumNumberOfBounces(-1),
    "min_samples: found 1, expected": lambda t: t.SetMinimumNumberOfSamples(1),
    "albedo: found 1.5, expected": lambda t: t.SetAlbedo(1.5),
    "albedo: found nan, expected": lambda t: t.SetAlbedo(np.nan),
    "sky: found -1, expected": lambda t: t.SetSkyTop(1, -1, 1),
    "sky: found inf, expected": lambda t: t.SetSkyBottom(1, 1, np.inf),
    "sky: found nan, expected": lambda t: t.SetSkyImage(bad_sky(np.nan)),
    "sky: found an image without scalars of three": lambda t: t.SetSkyImage(bad_sky(1.0, 1)),
    "sun: found -2, expected": lambda t: t.SetSunRadiance(1, 1, -2),
    "sun: found 0, expected a direction": lambda t: t.SetSunDirection(0, 0, 0),
    "sun: found 181, expected": lambda t: t.SetSunDiameter(181),
    "time_budget: found -1, expected": lambda t: t.SetTimeBudget(-1),
    "noise_target: found -1, expected": lambda t: t.SetNoiseTarget(-1),
    "exposure: found 101, expected": lambda t: t.SetExposure(101),
    "window_size: found 0 5, expected": lambda t: t.SetWindowSize(0, 5),
}


@pytest.mark.parametrize("message", BAD)
def test_refusals(message):
    tracer = tracer_of(packing_of(np.zeros((1, 3)), [1.0]))
    tracer.AddObserver("ErrorEvent", lambda *_: None)
    tracer.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
    BAD[message](tracer)
    tracer.Update()
    assert tracer.GetErrorMessage().startswith(message)
    assert tracer.GetOutput().GetPointData().GetNumberOfArrays() == 0
