"""Single rays of vtkSpherePackingTracer against long double, on easy and on hard packings."""

import json

import numpy as np
import pytest
from arrays import packing_of
from rays import Exact, check, towards
from spherepacking.backend import reference, vtkSpherePackingTracer

STRUCTURES = {"none": 0, "grid": 1, "bvh": 2}


def tracer_of(packing, structure, cuts=-1):
    tracer = vtkSpherePackingTracer()
    tracer.SetInputData(packing)
    tracer.SetStructure(STRUCTURES[structure])
    tracer.SetCuts(cuts)
    return tracer


def cast(tracer, origins, directions):
    ids, ts, normals = [], [], []
    for origin, direction in zip(origins.tolist(), directions.tolist(), strict=True):
        t, normal = reference(0.0), [0.0, 0.0, 0.0]
        ids.append(tracer.CastRay(origin, direction, t, normal))
        ts.append(float(t))
        normals.append(normal)
        assert not tracer.GetErrorMessage()
    return np.array(ids), np.array(ts), np.array(normals)


def around(rng, centers, radii, m):
    """Origins outside, inside and between the spheres; directions to and past them."""
    low = (centers - radii[:, None]).min(axis=0)
    high = (centers + radii[:, None]).max(axis=0)
    extent = np.max(high - low)
    extent = extent if extent > 0 else 1.0
    distance = extent * np.where(rng.random((m, 1)) < 0.5, 3.0, 0.6)
    origins = (low + high) / 2 + distance * rng.normal(size=(m, 3)) / np.sqrt(3)
    # To the middle, at random, and past the border by less and less.
    shares = rng.random(m)
    grazing = rng.random(m) < 0.5
    shares[grazing] = 1 + rng.choice([-1, 1], m)[grazing] * 10.0 ** rng.uniform(-15, -2, m)[grazing]
    directions = towards(rng, centers, radii, origins, shares)
    # And some that start in a sphere.
    start = rng.random(m) < 0.1
    inside = rng.integers(len(radii), size=m)
    origins[start] = (centers + 0.5 * radii[:, None] * rng.normal(size=centers.shape))[
        inside[start]
    ]
    directions *= 10.0 ** rng.uniform(-3, 3, (m, 1))  # no unit vectors
    return origins, directions


CASES = {
    "random": lambda rng: (rng.random((400, 3)), rng.uniform(0.0, 0.08, 400)),
    "centres at 1e7 with radii 1e-3": lambda rng: (
        1e7 + 0.02 * rng.random((300, 3)),
        np.full(300, 1e-3),
    ),
    "radius ratio 1e6": lambda rng: (rng.random((300, 3)), np.logspace(-6, 0, 300) * 0.3),
    "tangent": lambda rng: (np.argwhere(np.ones((6, 6, 6))).astype(float), np.full(216, 0.5)),
    "coincident": lambda rng: (
        np.repeat(rng.random((20, 3)), 10, axis=0),
        np.repeat(rng.uniform(0.05, 0.1, 20), 10),
    ),
    "thousands of duplicates": lambda rng: (
        np.repeat(rng.random((3, 3)), 1500, axis=0),
        np.full(4500, 0.1),
    ),
    "one plane": lambda rng: (rng.random((300, 3)) * [1, 1, 0], rng.random(300) * 0.05),
    "one line": lambda rng: (rng.random((300, 3)) * [0, 0, 1], rng.random(300) * 0.01),
    "one point": lambda rng: (np.full((50, 3), 0.3), np.linspace(0.01, 1, 50)),
    "exponential distances": lambda rng: (
        np.outer(2.0 ** -np.arange(120.0), [1, 0.5, 0.25]),
        2.0 ** -np.arange(120.0) / 8,
    ),
    "tiny lengths": lambda rng: (1e-12 * rng.random((200, 3)), np.full(200, 1e-13)),
    "large lengths": lambda rng: (1e12 * rng.random((200, 3)), np.full(200, 5e10)),
    "one sphere": lambda rng: (np.array([[1.0, 2.0, 3.0]]), np.array([0.5])),
}


@pytest.mark.parametrize("case", CASES)
def test_rays_against_long_double(rng, case):
    centers, radii = CASES[case](rng)
    m = 300 if len(radii) > 1000 else 1500
    origins, directions = around(rng, centers, radii, m)
    packing = packing_of(centers, radii)
    results = {s: cast(tracer_of(packing, s), origins, directions) for s in STRUCTURES}
    exact = Exact(centers, radii, origins, directions)
    ids, t, normals = results["none"]
    check(exact, ids, t)
    for structure in ("grid", "bvh"):
        for expected, found in zip(results["none"], results[structure], strict=True):
            np.testing.assert_array_equal(found, expected, err_msg=structure)
    hit = ids >= 0
    assert hit.any()
    assert np.abs(np.linalg.norm(normals[hit], axis=1) - 1).max() < 1e-14
    # A normal is off by what its point is off by, over the radius: along the ray and across it.
    rows = np.flatnonzero(hit)[exact.certain()[hit, ids[hit]]]
    error = np.linalg.norm((normals[rows] - exact.normals(rows, ids[rows])).astype(float), axis=1)
    off = exact.bound()[rows, ids[rows]] * exact.length[rows, 0] / exact.radii[ids[rows]]
    assert (error <= 2 * off).all()


def test_the_bound_is_no_empty_promise(rng):
    """Errors come within a factor of a hundred of the bound, so that it says something."""
    centers, radii = CASES["random"](rng)
    origins, directions = around(rng, centers, radii, 3000)
    ids, t, _ = cast(tracer_of(packing_of(centers, radii), "bvh"), origins, directions)
    assert check(Exact(centers, radii, origins, directions), ids, t) > 0.01


def test_a_sphere_ten_thousand_radii_away(rng):
    centers, radii = np.zeros((1, 3)), np.array([1.0])
    origins = rng.normal(size=(2000, 3))
    origins *= 1e4 / np.linalg.norm(origins, axis=1, keepdims=True)
    shares = np.where(np.arange(2000) % 2, rng.random(2000), 1 - 10.0 ** rng.uniform(-9, -1, 2000))
    directions = towards(rng, np.tile(centers, (1, 1)), radii, origins, shares)
    for structure in STRUCTURES:
        ids, t, _ = cast(tracer_of(packing_of(centers, radii), structure), origins, directions)
        check(Exact(centers, radii, origins, directions), ids, t)
        assert (ids == 0).mean() > 0.99


@pytest.mark.parametrize("cuts", [0, 1, 4, 9])
@pytest.mark.parametrize("axis", [0, 1, 2])
@pytest.mark.parametrize("sign", [-1, 1])
def test_rays_along_an_axis_through_cell_faces(cuts, axis, sign):
    """Two components of the direction are 0 (of either sign), and 0 times infinity is no number."""
    grid = np.argwhere(np.ones((6, 6, 6))).astype(float)
    centers, radii = grid, np.full(len(grid), 0.5)
    # Bounds from -0.5 to 5.5: planes between cells lie at multiples of 6 / (cuts + 1).
    planes = -0.5 + 6.0 / (cuts + 1) * np.arange(cuts + 2)
    a, b = np.meshgrid(planes, np.concatenate([planes, [0.0, 2.0, 0.25]]))
    origins = np.insert(np.column_stack([a.ravel(), b.ravel()]), axis, -sign * 10.0, axis=1)
    directions = np.where(np.arange(len(origins))[:, None] % 2, -0.0, 0.0) * np.ones((1, 3))
    directions[:, axis] = sign
    exact = Exact(centers, radii, origins, directions)
    expected = None
    for structure in STRUCTURES:
        found = cast(tracer_of(packing_of(centers, radii), structure, cuts), origins, directions)
        check(exact, *found[:2])
        expected = expected or found
        for one, other in zip(expected, found, strict=True):
            np.testing.assert_array_equal(one, other)


def test_grazing_rays_along_an_axis():
    """Past a unit sphere by ever less, up to the last digit; touching is missing."""
    gaps = 2.0 ** -np.arange(1.0, 54.0)
    beside = np.concatenate([1 - gaps, 1 + gaps, [1.0]])
    origins = np.column_stack([beside, np.zeros_like(beside), np.full_like(beside, 5.0)])
    directions = np.tile([0.0, 0.0, -1.0], (len(beside), 1))
    for structure in STRUCTURES:
        tracer = tracer_of(packing_of(np.zeros((1, 3)), [1.0]), structure)
        ids, t, _ = cast(tracer, origins, directions)
        # Everything here is exact but the square of the distance.
        assert (ids[:27] == 0).all()
        assert (ids[53:80] == -1).all()
        assert ids[-1] == -1
        check(Exact(np.zeros((1, 3)), [1.0], origins, directions), ids, t)


def test_from_inside_the_exit_is_seen():
    tracer = tracer_of(
        packing_of(np.array([[0.0, 0, 0], [0, 0, 0], [5, 0, 0]]), [1.0, 2, 1]), "bvh"
    )
    ids, t, normals = cast(tracer, np.zeros((1, 3)), np.array([[2.0, 0, 0]]))
    assert (ids[0], t[0]) == (0, 0.5)
    assert normals[0].tolist() == [1.0, 0.0, 0.0]


def test_behind_is_not_seen():
    for structure in STRUCTURES:
        tracer = tracer_of(packing_of(np.zeros((1, 3)), [1.0]), structure)
        ids, t, normals = cast(tracer, np.array([[3.0, 0, 0]]), np.array([[1.0, 0, 0]]))
        assert ids[0] == -1
        assert np.isinf(t[0])
        assert normals[0].tolist() == [0, 0, 0]


def test_equal_spheres_show_the_lower_id(rng):
    centers = np.repeat(rng.random((5, 3)), 7, axis=0)
    order = rng.permutation(35)
    for structure in STRUCTURES:
        tracer = tracer_of(packing_of(centers[order], np.full(35, 0.05)), structure)
        origins = np.full((35, 3), 4.0)
        ids, _, _ = cast(tracer, origins, centers[order] - origins)
        place = centers[order][:, None] == centers[order][None]
        assert (ids <= place.all(axis=2).argmax(axis=1)).all()
        assert np.isin(ids, place.all(axis=2).argmax(axis=1)).all()


def test_radius_zero_is_never_hit():
    for structure in STRUCTURES:
        tracer = tracer_of(packing_of(np.array([[0.0, 0, 0], [0, 0, -2]]), [0.0, 1.0]), structure)
        ids, t, _ = cast(tracer, np.array([[0.0, 0, 5]]), np.array([[0.0, 0, -1]]))
        assert (ids[0], t[0]) == (1, 6.0)


def test_the_solar_system(rng, data_file):
    """Radii from 1000 to 700 000 km, up to 6e9 km apart."""
    bodies = json.loads(data_file("planets.json").read_text())["bodies"]
    centers = np.array([body["position"] for body in bodies])
    radii = np.array([body["radius"] for body in bodies])
    origins, directions = around(rng, centers, radii, 1500)
    exact = Exact(centers, radii, origins, directions)
    for structure in STRUCTURES:
        ids, t, _ = cast(tracer_of(packing_of(centers, radii), structure), origins, directions)
        check(exact, ids, t)
        assert len(np.unique(ids)) > len(bodies) / 2


@pytest.mark.parametrize(
    ("origin", "direction"),
    [((0, 0, 5), (0, 0, 0)), ((np.nan, 0, 5), (0, 0, 1)), ((0, 0, 5), (0, np.inf, 1))],
)
def test_no_ray(origin, direction):
    tracer = tracer_of(packing_of(np.zeros((1, 3)), [1.0]), "bvh")
    tracer.AddObserver("ErrorEvent", lambda *_: None)
    assert tracer.CastRay(origin, direction, reference(0.0), [0.0, 0.0, 0.0]) == -1
    assert tracer.GetErrorMessage().startswith("ray: found")
