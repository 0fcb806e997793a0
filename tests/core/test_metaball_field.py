"""vtkMetaballField against sums in double precision, on random and on hard packings."""

import importlib
import math
import os
import subprocess
import sys
import time

import numpy as np
import pytest
import pyvista as pv
from arrays import packing_of
from fields import KERNELS, direct, field_of, filter_of, value_of
from spherepacking.backend import VTK_ROOT
from spherepacking.testing.scenes import knot_tube

# From the VTK that PyVista runs on.
vtkImageShiftScale = importlib.import_module(f"{VTK_ROOT}.vtkImagingCore").vtkImageShiftScale
POINTS = 400
# What single precision may lose, see the class.
ROUNDING = 1e-5
# What a processor's estimate of a root or of a quotient is wrong by at most, see Blobs.h.
ESTIMATE = 1.5 / 4096
# What is added to the bound, as the class says.
ABSOLUTE = {"inverse": 0.0, "inverse_square": 0.0, "gaussian": 1e-6, "wyvill": 1e-6}


def some_points(image, rng, count=POINTS):
    """Some of the points of a grid, exactly, which image.points is not."""
    chosen = rng.choice(image.n_points, min(count, image.n_points), replace=False)
    steps = np.array(np.unravel_index(chosen, image.dimensions, order="F")).T
    return chosen, np.array(image.origin) + steps * np.array(image.spacing)


def spread(rng, count, exponent=3.0):
    """Spheres in a box, with radii over three decades."""
    return packing_of(rng.uniform(-1, 1, (count, 3)), 0.3 * rng.random(count) ** exponent + 1e-4)


def clustered(rng, count):
    """Most spheres in tiny clumps, so that the tree is deep."""
    clumps = rng.uniform(-1, 1, (20, 3))
    scale = 10.0 ** rng.uniform(-6, 0, count)
    centers = clumps[rng.integers(0, 20, count)] + scale[:, None] * rng.normal(size=(count, 3))
    return packing_of(centers, 0.3 * scale)


def shells(rng, count):
    """Five concentric spheres at each place, places ever nearer to one: leaves of no extent."""
    places = rng.uniform(-1, 1, (count, 3)) * 10.0 ** rng.uniform(-4, 0, (count, 1))
    return packing_of(np.repeat(places, 5, axis=0), np.tile(0.002 * np.arange(1.0, 6.0), count))


SCENES = {
    "few": lambda rng: spread(rng, 60),
    "spread": lambda rng: spread(rng, 5000),
    "one size": lambda rng: packing_of(rng.uniform(-1, 1, (4000, 3)), np.full(4000, 0.05)),
    "clustered": lambda rng: clustered(rng, 5000),
    "in a plane": lambda rng: packing_of(
        rng.uniform(-1, 1, (3000, 3)) * [1, 1, 0], np.full(3000, 0.02)
    ),
    "on a line": lambda rng: packing_of(
        rng.uniform(-1, 1, (3000, 3)) * [1, 0, 0], np.full(3000, 0.02)
    ),
    "far away": lambda rng: packing_of(1e7 + rng.uniform(-1, 1, (2000, 3)), np.full(2000, 0.05)),
    "coincident": lambda rng: packing_of(np.zeros((500, 3)), np.full(500, 0.1)),
    "concentric": lambda rng: shells(rng, 600),
    "a heap among others": lambda rng: packing_of(
        np.vstack([np.zeros((100, 3)), 0.3 * rng.normal(size=(300, 3))]), np.full(400, 0.1)
    ),
    "ratio 1e6": lambda rng: packing_of(
        rng.uniform(-1, 1, (2000, 3)), np.where(rng.random(2000) < 0.01, 1.0, 1e-6)
    ),
    "tiny": lambda rng: packing_of(1e-25 * rng.uniform(-1, 1, (500, 3)), np.full(500, 1e-26)),
    "huge": lambda rng: packing_of(1e25 * rng.uniform(-1, 1, (500, 3)), np.full(500, 1e24)),
}


@pytest.mark.parametrize("error", [2e-5, 1e-3, 0.1, 0.0])
@pytest.mark.parametrize("kernel", KERNELS)
@pytest.mark.parametrize("scene", SCENES)
def test_error_is_below_what_was_asked_for(scene, kernel, error, rng):
    packing = SCENES[scene](rng)
    image = field_of(packing, kernel, (30, 21, 17), error)
    chosen, points = some_points(image, rng)
    expected = direct(packing, points, kernel)
    allowed = max(error, ROUNDING) * expected + ABSOLUTE[kernel]
    assert (np.abs(image["field"][chosen] - expected) <= allowed).all()


@pytest.mark.parametrize("kernel", ["inverse", "inverse_square"])
def test_the_bound_is_not_met_by_summing_all(kernel, rng):
    """A coarse field differs from a fine one: expansions are used, and their order follows."""
    packing = spread(rng, 5000)
    fields = []
    for error in (0.0, 1e-3, 0.1):
        algorithm = filter_of(packing, kernel, error=error)
        algorithm.ComputeGradientOn()  # which multilevel summation does not make
        algorithm.Update()
        fields.append(pv.wrap(algorithm.GetOutput())["field"])
    fine, medium, coarse = fields
    differences = [np.abs(some / fine - 1).max() for some in (medium, coarse)]
    assert 1e-7 < differences[0] < differences[1] < 0.1
    assert differences[1] > 1e-5


@pytest.mark.parametrize("kernel", ["inverse", "inverse_square"])
@pytest.mark.parametrize("away", [1e-2, 1e-3, 1e-5])
def test_near_all_there_is(kernel, away):
    """What is seen from near, beside its distance from the rest of the scene, is one charge."""
    packing = packing_of([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 1.0]], [0.2, 0.15, 0.1, 1e-7])
    for count in (16, 1):
        low, high = 1.0 + 2.0 * away, 1.0 + (2.0 + count) * away
        algorithm = filter_of(packing, kernel, (count,) * 3, 2e-5, (low, high) * 3)
        algorithm.SetNumberOfWeights(4)
        for i in range(3):
            algorithm.SetWeight(i, 0.0)
        algorithm.ComputeGradientOn()
        algorithm.Update()
        image = pv.wrap(algorithm.GetOutput())
        points = np.array(image.origin) + np.array(image.spacing) * np.stack(
            np.unravel_index(np.arange(image.n_points), image.dimensions, order="F"), -1
        )
        expected = direct(packing, points, kernel, np.array([0.0, 0.0, 0.0, 1.0]))
        np.testing.assert_allclose(image["field"], expected, rtol=2e-5)
        offset = points - [1.0, 1.0, 1.0]
        power = -1 if kernel == "inverse" else -2
        slope = power * expected / (offset**2).sum(axis=1)
        np.testing.assert_allclose(image["gradient"], slope[:, None] * offset, rtol=1e-4)


@pytest.mark.parametrize("scene", ["few", "concentric"])
@pytest.mark.parametrize("error", [0.0, 1e-3])
@pytest.mark.parametrize("kernel", KERNELS)
def test_gradient_is_that_of_the_field(kernel, error, scene, rng):
    packing = SCENES[scene](rng)
    algorithm = filter_of(packing, kernel, error=error)
    algorithm.ComputeGradientOn()
    algorithm.Update()
    image = pv.wrap(algorithm.GetOutput())
    chosen, points = some_points(image, rng, 200)
    step = 1e-5
    expected = np.column_stack(
        [
            direct(packing, points + step * axis, kernel)
            - direct(packing, points - step * axis, kernel)
            for axis in np.eye(3)
        ]
    ) / (2 * step)
    error = np.abs(image["gradient"][chosen] - expected)
    scale = np.linalg.norm(expected, axis=1, keepdims=True) + np.median(np.abs(expected)) + 1e-3
    assert (error / scale).max() < 2e-3


@pytest.mark.parametrize("kernel", KERNELS)
def test_strongest(kernel, rng):
    packing = spread(rng, 2000, exponent=1.0)
    algorithm = filter_of(packing, kernel, (11, 12, 13))
    algorithm.ComputeStrongestOn()
    algorithm.Update()
    image = pv.wrap(algorithm.GetOutput())
    for point, found in zip(np.asarray(image.points, float), image["strongest"], strict=True):
        each = value_of(kernel, np.linalg.norm(packing.points - point, axis=1), packing["radius"])
        if each.max() < 1e-30:
            continue
        assert each[found] >= each.max() * (1 - 1e-5)


def test_strongest_of_equals_is_the_first(rng):
    packing = packing_of(np.zeros((50, 3)), np.full(50, 0.5))
    algorithm = filter_of(packing)
    algorithm.ComputeStrongestOn()
    algorithm.Update()
    assert (pv.wrap(algorithm.GetOutput())["strongest"] == 0).all()


def test_strongest_is_nobody_where_nothing_reaches():
    algorithm = filter_of(packing_of([[0, 0, 0]], [1]), "wyvill", bounds=(-4, 4) * 3)
    algorithm.ComputeStrongestOn()
    algorithm.Update()
    image = pv.wrap(algorithm.GetOutput())
    assert ((image["strongest"] == -1) == (image["field"] == 0)).all()
    assert (image["strongest"] == -1).any()


def test_blend_is_the_weighted_mean(rng):
    packing = spread(rng, 500)
    packing["colors"] = rng.integers(0, 256, (500, 3), dtype=np.uint8)
    algorithm = filter_of(packing)
    algorithm.SetColorArrayName("colors")
    algorithm.Update()
    image = pv.wrap(algorithm.GetOutput())
    chosen, points = some_points(image, rng, 100)
    whole = direct(packing, points)
    for channel in range(3):
        part = direct(packing, points, weights=packing["colors"][:, channel] / 255.0)
        assert np.abs(image["blend"][chosen, channel] - 255 * part / whole).max() <= 1.0


# Hard cases by name --------------------------------------------------------------------------


@pytest.mark.parametrize("kernel", KERNELS)
def test_grid_point_on_a_center(kernel):
    """Finite there, and what it is at r / 1024."""
    packing = packing_of([[0, 0, 0], [0.5, 0, 0]], [0.3, 0.1])
    image = field_of(packing, kernel, (5, 5, 5), bounds=(-1, 1) * 3)
    expected = direct(packing, image.points, kernel)
    assert np.isfinite(image["field"]).all()
    np.testing.assert_allclose(image["field"], expected, rtol=1e-5, atol=1e-6)
    middle = image["field"][image.find_closest_point((0, 0, 0))]
    if kernel == "inverse":
        assert middle == pytest.approx(1024 + 0.2, rel=1e-5)


@pytest.mark.parametrize("kernel", KERNELS)
@pytest.mark.parametrize("away", [1e-9, 1e-6, 1e-3, 1e-2])
def test_grid_point_near_a_small_sphere(kernel, away):
    """Distances far below what single precision tells apart at the size of a block."""
    radius = 10 * away
    packing = packing_of([[away, 0, 0], [0.7, 0.1, 0.3]], [radius, 0.2])
    image = field_of(packing, kernel, (9, 9, 9), bounds=(-1, 1) * 3)
    at = image.find_closest_point((0, 0, 0))
    expected = direct(packing, [[0, 0, 0]], kernel)[0]
    assert image["field"][at] == pytest.approx(expected, rel=1e-5)


def test_grid_point_near_a_small_sphere_far_from_the_origin():
    packing = packing_of(np.array([[1e7 + 1e-3, 1e7, 1e7]]), [1e-2])
    image = field_of(packing, dimensions=(9, 9, 9), bounds=(1e7 - 1, 1e7 + 1) * 3)
    at = 4 + 9 * (4 + 9 * 4)
    # As far as coordinates in double precision tell.
    away = (1e7 + 1e-3) - 1e7
    assert image["field"][at] == pytest.approx(1e-2 / away, rel=1e-5)


def test_spheres_of_radius_or_weight_0_add_nothing(rng):
    packing = spread(rng, 400)
    packing["radius"][::2] = 0
    expected = direct(packing, field_of(packing).points[:50])
    np.testing.assert_allclose(field_of(packing)["field"][:50], expected, rtol=1e-3)
    algorithm = filter_of(packing)
    algorithm.SetNumberOfWeights(1)
    algorithm.SetWeight(0, 0)
    algorithm.ComputeStrongestOn()
    algorithm.ComputeGradientOn()
    algorithm.Update()
    image = pv.wrap(algorithm.GetOutput())
    assert (image["field"] == 0).all()
    assert (image["gradient"] == 0).all()
    assert (image["strongest"] == -1).all()


def test_no_spheres():
    image = field_of(pv.PolyData(), dimensions=(3, 4, 5))
    assert image.dimensions == (3, 4, 5)
    assert (image["field"] == 0).all()


@pytest.mark.parametrize(("count", "used"), [(1, 1), (7, 7), (60, 60), (1000, 60), (0, 60)])
def test_count_takes_the_largest(count, used, rng):
    packing = spread(rng, 60)
    algorithm = filter_of(packing, bounds=(-1, 1) * 3)
    algorithm.SetCount(count)
    algorithm.Update()
    image = pv.wrap(algorithm.GetOutput())
    largest = np.argsort(-packing["radius"], kind="stable")[:used]
    expected = direct(packing.extract_points(largest, include_cells=False), image.points[::999])
    np.testing.assert_allclose(image["field"][::999], expected, rtol=1e-3)


@pytest.mark.parametrize("weights", [[2.0], [1, 0.5], [0, 1, 0], np.linspace(1, 3, 8)])
def test_weights_from_large_to_small(weights, rng):
    """Each counts for an equal share of the ranks."""
    packing = spread(rng, 48)
    algorithm = filter_of(packing)
    algorithm.SetNumberOfWeights(len(weights))
    for i, weight in enumerate(weights):
        algorithm.SetWeight(i, weight)
    algorithm.Update()
    image = pv.wrap(algorithm.GetOutput())
    each = np.empty(48)
    each[np.argsort(-packing["radius"], kind="stable")] = np.repeat(weights, 48 // len(weights))
    expected = direct(packing, image.points[::999], weights=each)
    np.testing.assert_allclose(image["field"][::999], expected, rtol=1e-3)


def test_places_at_the_edge_of_what_is_summed_in_double_precision(rng):
    """Spheres just far enough from a grid point, alone, where rounding weighs most."""
    axis = np.linspace(-1, 1, 8)
    for kernel in ("inverse", "inverse_square"):
        for _ in range(100):
            away = rng.normal(size=3)
            away *= (2 / 40) * rng.uniform(1.0, 1.2) / np.abs(away).max()
            packing = packing_of([axis[rng.integers(0, 8, 3)] + away], [0.3])
            image = field_of(packing, kernel, (8, 8, 8), 0.0, (-1, 1) * 3)
            chosen, points = some_points(image, rng, 512)
            expected = direct(packing, points, kernel)
            assert np.abs(image["field"][chosen] / expected - 1).max() < ROUNDING


@pytest.mark.parametrize("weight", [1e20, 1e-20, 1e-300])
@pytest.mark.parametrize("kernel", KERNELS)
def test_very_large_and_small_weights(kernel, weight):
    """Only their ratios count for the arithmetic."""
    packing = packing_of([[0, 0, 0], [1, 0, 0]], [1e-3, 0.5])
    whole = field_of(packing, kernel, (9, 9, 9))["field"]
    algorithm = filter_of(packing, kernel, (9, 9, 9))
    algorithm.SetNumberOfWeights(1)
    algorithm.SetWeight(0, weight)
    algorithm.Update()
    found = pv.wrap(algorithm.GetOutput())["field"]
    expected = (whole.astype(float) * weight).astype(np.float32)
    np.testing.assert_allclose(found, expected, rtol=1e-6)


def test_strongest_of_many_at_one_place(rng):
    """Takes no longer than of as many that are apart."""
    radii = rng.random(10_000) + 0.1
    seconds = []
    for extent in (1.0, 0.0):
        packing = packing_of(extent * rng.uniform(-1, 1, (10_000, 3)), 0.05 * radii)
        algorithm = filter_of(packing)
        algorithm.ComputeStrongestOn()
        start = time.perf_counter()
        algorithm.Update()
        seconds.append(time.perf_counter() - start)
    assert seconds[1] < 2 * seconds[0]
    assert (pv.wrap(algorithm.GetOutput())["strongest"] == radii.argmax()).all()


@pytest.mark.parametrize("spaced", [False, True])
def test_image_filters_that_follow(spaced, rng):
    """They ask for the geometry before there is data."""
    packing = spread(rng, 50)
    algorithm = filter_of(packing)
    if spaced:
        algorithm.SetSpacing(0.2, 0.2, 0.2)
    twice = vtkImageShiftScale()
    twice.SetInputConnection(algorithm.GetOutputPort())
    twice.SetScale(2.0)
    for factor in (1.0, 3.0):
        packing.points *= factor
        packing.Modified()
        twice.Update()
        before, after = pv.wrap(algorithm.GetOutput()), pv.wrap(twice.GetOutput())
        for name in ("origin", "spacing", "dimensions"):
            assert getattr(after, name) == getattr(before, name)
        assert (after.active_scalars == 2 * before["field"]).all()
        assert after.bounds.x_max > factor * 0.8


@pytest.mark.parametrize(
    "dimensions", [(1, 1, 1), (2, 1, 3), (1, 1, 700), (700, 1, 1), (9, 17, 33)]
)
def test_grids_of_any_shape(dimensions, rng):
    packing = spread(rng, 2000)
    image = field_of(packing, dimensions=dimensions)
    assert image.dimensions == dimensions
    chosen, points = some_points(image, rng, 100)
    np.testing.assert_allclose(image["field"][chosen], direct(packing, points), rtol=1e-3)


def test_cells_of_any_shape(rng):
    packing = spread(rng, 2000)
    image = field_of(packing, dimensions=(40, 40, 40), bounds=(-1, 1, -1e-3, 1e-3, -100, 100))
    chosen, points = some_points(image, rng)
    np.testing.assert_allclose(image["field"][chosen], direct(packing, points), rtol=1e-3)


def test_spacing_makes_points_until_the_upper_bounds():
    algorithm = filter_of(packing_of([[0, 0, 0]], [1]), bounds=(0, 1, 0, 1.01, 0, 0.99))
    algorithm.SetSpacing(0.1, 0.1, 0.1)
    algorithm.Update()
    image = pv.wrap(algorithm.GetOutput())
    assert image.dimensions == (11, 12, 11)
    assert image.spacing == (0.1, 0.1, 0.1)


@pytest.mark.parametrize("kernel", KERNELS)
@pytest.mark.parametrize("threshold", [0.05, 1.0, 10.0])
@pytest.mark.parametrize("scene", ["few", "one size", "ratio 1e6", "far away", "coincident"])
def test_grown_bounds_hold_the_surface(scene, threshold, kernel, rng):
    packing = SCENES[scene](rng)
    algorithm = filter_of(packing, kernel, (20, 20, 20))
    algorithm.SetThreshold(threshold)
    algorithm.Update()
    assert algorithm.GetErrorMessage() == ""
    values = pv.wrap(algorithm.GetOutput())["field"].reshape(20, 20, 20)
    inner = values[1:-1, 1:-1, 1:-1].sum(dtype=float)
    faces = [np.take(values, side, axis) for axis in range(3) for side in (0, -1)]
    assert all((face < threshold).all() for face in faces)
    assert inner > 0


def test_grown_bounds_are_not_far_too_large(rng):
    packing = spread(rng, 200)
    algorithm = filter_of(packing, dimensions=(64, 64, 64))
    algorithm.SetThreshold(10)
    algorithm.Update()
    image = pv.wrap(algorithm.GetOutput())
    inside = np.asarray(image.points)[image["field"] >= 10]
    size = np.ptp(np.asarray(image.points), axis=0)
    assert (np.ptp(inside, axis=0) > 0.75 * size).all()


BAD = [
    ("SetDimensions", (4, 0, 4), "dimensions: found 4 0 4"),
    ("SetDimensions", (40000, 40000, 40000), "dimensions: found 40000 40000 40000"),
    ("SetSpacing", (0.1, -1, 0.1), "spacing: found 0.1 -1 0.1"),
    ("SetSpacing", (1e-9, 1e-9, 1e-9), "spacing: found 1e-09 1e-09 1e-09"),
    ("SetModelBounds", (0, 1, 1, 0, 0, 1), "bounds: found 0 1 1 0 0 1"),
    ("SetModelBounds", (0, math.inf, 0, 1, 0, 1), "bounds: found 0 inf"),
    ("SetModelBounds", (0, 1, 0, 0, 0, 1), "bounds: found 0 1 0 0 0 1"),
    ("SetThreshold", (-1,), "threshold: found -1"),
    ("SetThreshold", (math.nan,), "threshold: found nan"),
    ("SetCount", (-1,), "count: found -1"),
    ("SetRelativeError", (1e-6,), "relative_error: found 1e-06"),
    ("SetRelativeError", (math.nan,), "relative_error: found nan"),
    ("SetRelativeError", (0.6,), "relative_error: found 0.6"),
    ("SetColorArrayName", ("radius",), "colors: found no point array 'radius'"),
    ("SetRadiusArrayName", ("size",), "size"),
]


@pytest.mark.parametrize(("method", "values", "found"), BAD)
def test_refusals(method, values, found):
    algorithm = filter_of(packing_of([[0, 0, 0], [1, 2, 3]], [1, 1]))
    algorithm.AddObserver("ErrorEvent", lambda *_: None)
    algorithm.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
    getattr(algorithm, method)(*values)
    algorithm.Update()
    assert found in algorithm.GetErrorMessage()
    assert algorithm.GetOutput().GetNumberOfPoints() == 0


@pytest.mark.parametrize("weights", [[1, math.nan], [-1], [math.inf]])
def test_weights_that_are_none(weights):
    algorithm = filter_of(packing_of([[0, 0, 0]], [1]))
    algorithm.AddObserver("ErrorEvent", lambda *_: None)
    algorithm.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
    algorithm.SetNumberOfWeights(len(weights))
    for i, weight in enumerate(weights):
        algorithm.SetWeight(i, weight)
    algorithm.Update()
    assert algorithm.GetErrorMessage().startswith("weights: found")


def test_abort_keeps_the_blocks_that_were_made(rng):
    packing = spread(rng, 5000)
    whole = field_of(packing, dimensions=(128, 128, 128), bounds=(-1, 1) * 3)["field"]
    algorithm = filter_of(packing, dimensions=(128, 128, 128), bounds=(-1, 1) * 3)
    algorithm.AddObserver(
        "ProgressEvent", lambda caller, _: caller.SetAbortExecute(caller.GetProgress() > 0.0)
    )
    algorithm.Update()
    found = pv.wrap(algorithm.GetOutput())["field"]
    assert ((found == whole) | (found == 0)).all()
    assert 0 < np.count_nonzero(found) < found.size


def test_abort_before_the_first_block(rng):
    algorithm = filter_of(spread(rng, 5000))
    algorithm.AddObserver("ProgressEvent", lambda caller, _: caller.SetAbortExecute(1))
    algorithm.ComputeStrongestOn()
    algorithm.Update()
    found = pv.wrap(algorithm.GetOutput())
    assert not found["field"].any()
    assert (found["strongest"] == -1).all()


def test_progress_grows(rng):
    seen = []
    algorithm = filter_of(spread(rng, 100))
    algorithm.AddObserver("ProgressEvent", lambda caller, _: seen.append(caller.GetProgress()))
    algorithm.Update()
    assert seen == sorted(seen)
    assert seen[-1] == 1.0


SAME = """
import sys
import numpy as np
from fields import KERNELS, field_of
from spherepacking.testing.scenes import knot_tube
packing = knot_tube(1500)
fields = {
    f"{k} {e:g}": field_of(packing, k, error=e)["field"] for k in KERNELS for e in (3e-4, 1e-3)
}
np.savez(sys.argv[1], **fields)
"""


def test_any_processor_and_number_of_threads(tmp_path):
    """Threads change nothing; another processor's arithmetic stays within the bound."""
    results = []
    for i, words in enumerate(
        ({}, {"VTK_SMP_MAX_THREADS": "1"}, {"SPHEREPACKING_WITHOUT_AVX2": "1"})
    ):
        path = tmp_path / f"{i}.npz"
        env = (
            os.environ
            | words
            | {"PYTHONPATH": os.pathsep.join([os.path.dirname(__file__), *sys.path])}
        )
        subprocess.run([sys.executable, "-c", SAME, path], check=True, env=env)
        results.append(np.load(path))
    for name in results[0].files:
        assert (results[0][name] == results[1][name]).all()
        estimated = name in ("inverse 0.001", "inverse_square 0.001")
        np.testing.assert_allclose(
            results[0][name],
            results[2][name],
            rtol=2 * ROUNDING + (ESTIMATE if estimated else 0.0),
            atol=1e-6,
        )


@pytest.mark.parametrize("kernel", ["inverse", "inverse_square"])
def test_roots_are_estimated_only_where_the_error_allows_it(kernel, rng):
    packing = spread(rng, 5)  # so few that none is expanded
    exact = field_of(packing, kernel, error=0.0)["field"].astype(float)
    for error, bound in ((3e-4, ROUNDING), (4e-4, ESTIMATE + ROUNDING)):
        found = field_of(packing, kernel, error=error)["field"]
        assert np.abs(found / exact - 1.0).max() <= bound + ROUNDING


def test_scene_of_the_benchmark(rng):
    packing = knot_tube(30_000)
    image = field_of(packing, dimensions=(64, 64, 64))
    chosen, points = some_points(image, rng, 200)
    expected = direct(packing, points)
    assert (np.abs(image["field"][chosen] - expected) <= 1e-3 * expected).all()
