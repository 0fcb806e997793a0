"""The bound of metaballs/multilevel/GaussianSum.h, added up, and fields that come near it."""

import math

import numpy as np
import pytest
import pyvista as pv
from arrays import packing_of
from fields import direct, field_of, filter_of, value_of

# What the header says.
BOUND = 7e-4
ROUNDING = 2.5e-4
ALPHA = 0.55  # for a step of 1
CHARGE_VARIANCE = 0.25 / ALPHA**2
WINDOW = 4.0
TRUNCATED = math.sqrt(22.0)  # standard deviations
MERGED_BELOW = 0.2  # rate times distance, below which all further terms are merged into one
FIT = 8  # coefficients
CUTOFF = {1: 2.8 / math.sqrt(2.0) / ALPHA, 2: 3.2 / math.sqrt(2.0) / ALPHA}
POWERS = {"inverse": 1, "inverse_square": 2}


def rate(m):
    return ALPHA * 2.0 ** (-0.5 * m)


def weight(m, power):
    return math.log(2.0) / math.gamma(0.5 * power) * rate(m) ** power


def products(m):
    """Variances of the two Gaussians of each sum that makes a term, and the spacing of its grid."""
    level = 0 if m < 3 else min((m - 1) // 2, 6)
    variance = 0.5 / rate(m) ** 2
    if level == 0:
        return [(CHARGE_VARIANCE, variance - CHARGE_VARIANCE, 1.0)]
    charges = [CHARGE_VARIANCE] + [4.0**i for i in range(1, level + 1)]
    sums = [(charges[i], charges[i + 1] - charges[i], 2.0**i) for i in range(level)]
    done = charges[level]
    sums.append((done, variance - 2.0 * done, 2.0**level))
    done = variance - done
    for i in range(level, 0, -1):
        more = 4.0**i - (4.0 ** (i - 1) if i > 1 else 0.0)
        sums.append((done, more, 2.0**i))
        done += more
    return sums


def grid_error(a, b, step):
    """Of a sum in place of an integral, see the header; the frequencies are a geometric series."""
    factor = math.exp(-2.0 * math.pi**2 * a * b / (a + b) / step**2)
    return 2.0 * factor / (1.0 - factor)


def beyond(sigmas, step):
    """Bound for the part of a Gaussian's sum that is that far from its middle; step in sigmas."""
    erfc = np.vectorize(math.erfc)
    integral = 0.5 * erfc(sigmas / math.sqrt(2.0))
    first = step / math.sqrt(2.0 * math.pi) * np.exp(-0.5 * sigmas**2)
    return np.where(sigmas > 0.0, integral + first, 1.0)


def lost(a, b, step, cut, radius, distance):
    """Part of a sum that is beyond the radius where the Gaussian of variance `cut` is truncated."""
    sigma = math.sqrt(a * b / (a + b))
    middle = distance * cut / (a + b)
    return beyond((radius - middle) / sigma, step / sigma) + beyond(
        (radius + middle) / sigma, step / sigma
    )


def merging_error(power):
    """Of one term in place of all that hardly decay, at the distances it is for, times d^power."""
    terms = np.arange(200)
    rates = np.array([rate(m) for m in terms])
    weights = np.array([weight(m, power) for m in terms])
    one = math.sqrt((weights * rates**2).sum() / weights.sum())
    distance = np.linspace(0.0, MERGED_BELOW / rates[0], 400)[:, None]
    exact = (weights * np.exp(-((rates * distance) ** 2))).sum(axis=1)
    found = weights.sum() * np.exp(-((one * distance[:, 0]) ** 2))
    return (np.abs(found - exact) * distance[:, 0] ** power).max()


def fit_error(power, distance):
    """Of a polynomial in place of the long-range terms, within Cutoff, times d^power."""
    at = 0.5 + 0.5 * np.cos(math.pi * (np.arange(FIT) + 0.5) / FIT)

    def long_range(square):
        return sum(weight(m, power) * np.exp(-(rate(m) ** 2) * square) for m in range(200))

    fit = np.polynomial.Polynomial.fit(
        at, long_range(at * CUTOFF[power] ** 2), FIT - 1, domain=[0, 1]
    )
    square = np.minimum(distance, CUTOFF[power]) ** 2
    return np.abs(fit(square / CUTOFF[power] ** 2) - long_range(square)) * distance**power


@pytest.mark.parametrize("power", [1, 2])
def test_the_bound_adds_up(power):
    distance = np.exp(np.linspace(math.log(0.01), math.log(3000.0), 1500))
    step = 0.5 * math.log(2.0)
    # |Gamma(1/2 + i y)|^2 and |Gamma(1 + i y)|^2, over their values at 0.
    y = math.pi / step
    gamma = (
        1.0 / math.cosh(math.pi * y) if power == 1 else math.pi * y / math.sinh(math.pi * y)
    ) ** 0.5
    error = np.full_like(distance, 2.0 * gamma * 1.001 + merging_error(power))
    error += np.where(distance < CUTOFF[power], fit_error(power, distance), 0.0)
    total = np.zeros_like(distance)
    for m in range(-30, 70):
        part = weight(m, power) * distance**power * np.exp(-((rate(m) * distance) ** 2))
        total += part
        if m < 0:
            error += np.where(distance >= CUTOFF[power], part, 0.0)
            continue
        sums = products(m)
        factor = math.prod(1.0 + grid_error(*each) for each in sums) ** 3
        cuts = [(*sums[0], CHARGE_VARIANCE, WINDOW)]
        cuts += [(a, b, h, b, TRUNCATED * math.sqrt(b)) for a, b, h in sums]
        missing = np.zeros_like(distance)
        for a, b, h, cut, radius in cuts:
            # Its part of the way from the charge to the point; none along the other two axes.
            way = distance * (a + b) * 2.0 * rate(m) ** 2
            missing += lost(a, b, h, cut, radius, way) + 2.0 * lost(a, b, h, cut, radius, 0.0)
        error += part * (factor - 1.0 + np.minimum(missing, 1.0))
    # The sum that all this is about.
    assert abs(total - 1.0).max() < 2e-5
    assert error.max() <= BOUND


def points_of(image):
    steps = np.array(np.unravel_index(np.arange(image.n_points), image.dimensions, order="F")).T
    return np.array(image.origin) + steps * np.array(image.spacing)


@pytest.mark.parametrize("kernel", POWERS)
@pytest.mark.parametrize("shape", [(48, 48, 48), (48, 40, 28), (25, 47, 48)])
def test_gaussian_sums_are_within_their_bound(kernel, shape, rng):
    """Coincident charges, on and between grid points: nothing averages out. All distances."""
    count = 3000
    for position in (np.zeros(3), rng.uniform(-0.2, 0.2, 3), rng.uniform(-0.9, 0.9, 3)):
        packing = packing_of(np.tile(position, (count, 1)), np.full(count, 0.01))
        image = field_of(packing, kernel, shape, 1e-3, (-1, 1, -1, 1, -1, 1))
        assert image.field_data["meshes"][0] > 1
        distance = np.linalg.norm(points_of(image) - np.asarray(packing.points[0], float), axis=1)
        expected = count * value_of(kernel, distance, 0.01)
        assert np.abs(image["field"] / expected - 1.0).max() <= BOUND + ROUNDING


def nested(rng, count):
    """Half as far, and half as many, again and again."""
    scale = 10.0 ** rng.uniform(-6, 0, (count, 1))
    return packing_of(scale * rng.uniform(-1, 1, (count, 3)), 10.0 ** rng.uniform(-6, -2, count))


def lattice(shift):
    nodes = np.stack(np.meshgrid(*[np.arange(27.0)] * 3), -1).reshape(-1, 3)
    return packing_of(nodes + shift, np.full(len(nodes), 0.3))


def box(rng, count, sides=1.0):
    return packing_of(rng.uniform(-1, 1, (count, 3)) * sides, np.full(count, 0.01))


SCENES = {
    "box": (lambda rng: box(rng, 8000), (40, 40, 40), None),
    "one side short": (lambda rng: box(rng, 8000, [1, 1, 0.3]), (52, 52, 20), None),
    "steps that differ": (lambda rng: box(rng, 8000), (44, 32, 36), None),
    "radii over six decades": (
        lambda rng: packing_of(rng.uniform(-1, 1, (8000, 3)), 10 ** rng.uniform(-6, 0, 8000)),
        (40, 40, 40),
        None,
    ),
    "nested": (lambda rng: nested(rng, 8000), (40, 40, 40), None),
    "far from the origin": (
        lambda rng: packing_of(1e7 + rng.uniform(-1, 1, (8000, 3)), np.full(8000, 0.01)),
        (40, 40, 40),
        None,
    ),
    "on the nodes": (lambda _: lattice(0.0), (27, 27, 27), (0, 26) * 3),
    "between the nodes": (lambda _: lattice(0.5), (27, 27, 27), (0, 26) * 3),
    "grid in the middle": (lambda rng: box(rng, 16_000), (24, 24, 24), (-0.5, 0.5) * 3),
    "grid beside": (
        lambda rng: packing_of(rng.uniform(-1, -0.5, (8000, 3)), np.full(8000, 0.01)),
        (30, 30, 30),
        (0.3, 1.0) * 3,
    ),
    "long and thin": (
        lambda rng: box(rng, 60_000, [0.0025, 0.0025, 1]),
        (12, 12, 2048),
        (-0.006, 0.006, -0.006, 0.006, -1, 1),
    ),
    "two places": (
        lambda rng: packing_of(
            1e-3 * rng.normal(size=(8000, 3)) + rng.choice([-1, 1], (8000, 1)),
            np.full(8000, 0.01),
        ),
        (36, 36, 36),
        None,
    ),
}


@pytest.mark.parametrize("kernel", POWERS)
@pytest.mark.parametrize("scene", SCENES)
def test_fields_through_meshes_are_within_the_bound(scene, kernel, rng):
    make, dimensions, bounds = SCENES[scene]
    packing = make(rng)
    image = field_of(packing, kernel, dimensions, 1e-3, bounds)
    assert image.field_data["meshes"][0] > 1
    chosen = rng.choice(image.n_points, 300, replace=False)
    expected = direct(packing, points_of(image)[chosen], kernel)
    assert np.abs(image["field"][chosen] / expected - 1.0).max() <= BOUND + ROUNDING


@pytest.mark.parametrize(
    ("change", "why"),
    [
        ({"count": 300}, "few spheres: the grids would take more memory than they"),
        ({"error": 9e-4}, "multilevel summation is not so accurate"),
        ({"dimensions": (40, 40, 11)}, "a thin grid"),
        ({"gradient": True}, "multilevel summation makes none"),
        ({"strongest": True}, "it is found through the tree"),
        ({"dimensions": (60, 40, 28)}, "steps that differ by more than two"),
        ({"radius": 2000.0}, "a sphere whose constant core is larger than the spacing"),
        ({"size": 1e-7, "bounds": (1 - 1e-7, 1 + 1e-7) * 3}, "spheres far beside the grid"),
    ],
)
def test_other_fields_go_through_the_tree(change, why, rng):
    packing = box(rng, change.get("count", 12_000), change.get("size", 1.0))
    packing["radius"][0] = change.get("radius", 0.01)
    dimensions = change.get("dimensions", (40, 40, 40))
    error = change.get("error", 1e-3)
    bounds = change.get("bounds", (-1, 1) * 3)
    algorithm = filter_of(packing, "inverse_square", dimensions, error, bounds)
    algorithm.SetComputeGradient(change.get("gradient", False))
    algorithm.SetComputeStrongest(change.get("strongest", False))
    algorithm.Update()
    image = pv.wrap(algorithm.GetOutput())
    assert image.field_data["meshes"][0] == 0, why
    chosen = rng.choice(image.n_points, 100, replace=False)
    expected = direct(packing, points_of(image)[chosen], "inverse_square")
    assert np.abs(image["field"][chosen] / expected - 1.0).max() <= error
