"""How far pictures are from what they converge to, and that it is the right one."""

import numpy as np
import pytest
from spherepacking import Sun
from views import camera_of, cluster, packing_of, trace

LIGHT = {"sky": (0.5, (1.0, 1.5, 2.0)), "sun": Sun((1, -1, 2), (2.0, 1.8, 1.5), 5.0)}


def image_sky(rng):
    sky = rng.random((16, 32, 3)).astype(np.float32)
    sky[3, 5] = 60.0
    return sky


@pytest.mark.parametrize("sky", ["gradient and sun", "image"])
def test_no_bias(rng, sky):
    """The mean over seeds is that of 65536 samples, in whole and pixel by pixel."""
    kwargs = LIGHT if sky == "gradient and sun" else {"sky": image_sky(rng)}
    # Paths are ended by chance from the fourth bounce on.
    kwargs = kwargs | {"max_bounces": 12, "albedo": 0.7}
    packing, camera, size = cluster(rng), camera_of((4, 3, 2), angle=30.0), (8, 8)
    reference = np.array(trace(packing, camera, size, samples=65536, seed=1, **kwargs)["radiance"])
    seeds = rng.integers(2, 2**32, 200)
    found = np.array(
        [trace(packing, camera, size, samples=4, seed=int(s), **kwargs)["radiance"] for s in seeds]
    )
    mean, error = found.mean(axis=0), found.std(axis=0, ddof=1) / np.sqrt(len(seeds))
    whole = found.mean(axis=(1, 2))
    difference = whole.mean() - reference.mean()
    assert abs(difference) < 3 * whole.std(ddof=1) / np.sqrt(len(seeds))
    beyond = np.abs(mean - reference) > 3 * error + 1e-3
    # Of 192 numbers 0.5 are expected beyond three standard errors.
    assert beyond.sum() <= 4


def slope(errors, samples):
    return np.polyfit(np.log(samples), np.log(errors), 1)[0]


def test_sobol_points_converge_faster_than_chance():
    """On a smooth scene: one over n rather than one over its root."""
    normal = np.array([1.0, 2.0, 3.0]) / np.sqrt(14)
    packing = packing_of([[0, 0, 0]], 1.0)
    camera = camera_of(5 * normal, angle=1e-4)
    expected = 0.8 * (0.2 + 1.8 * (0.5 + normal[2] / 3))
    samples = 4 ** np.arange(1, 7)
    errors = []
    for n in samples:
        image = trace(packing, camera, (24, 24), samples=int(n), sky=(0.2, 2.0))
        errors.append(np.sqrt(np.mean((image["radiance"][:, 0] - expected) ** 2)))
    assert slope(errors, samples) < -0.9
    # Independent samples would be as far off as the variance says.
    assert errors[-1] < 0.1 * np.sqrt(image["variance"].mean())


def test_convergence_with_shadows(rng):
    """Where spheres hide each other no points do as well, but better than chance."""
    packing, camera, size = cluster(rng), camera_of((4, 3, 2), angle=30.0), (24, 24)
    reference = np.array(trace(packing, camera, size, samples=16384, seed=9, **LIGHT)["radiance"])
    samples = 2 ** np.arange(2, 10)
    errors = []
    for n in samples:
        found = trace(packing, camera, size, samples=int(n), **LIGHT)
        errors.append(np.sqrt(np.mean((found["radiance"] - reference) ** 2)))
    assert slope(errors, samples) < -0.55


def test_the_variance_is_not_too_small(rng):
    packing, camera, size = cluster(rng), camera_of((4, 3, 2), angle=30.0), (16, 16)
    weights = np.array([0.2126, 0.7152, 0.0722])
    found = [trace(packing, camera, size, samples=16, seed=seed, **LIGHT) for seed in range(60)]
    brightness = np.array([image["radiance"] @ weights for image in found])
    claimed = np.mean([image["variance"] for image in found])
    measured = brightness.var(axis=0, ddof=1).mean()
    assert measured < claimed < 10 * measured
