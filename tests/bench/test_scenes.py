"""The packing of the benchmarks."""

import numpy as np
import pytest
from spherepacking.accessor import PackingAccessor
from spherepacking.testing.scenes import knot_tube


def knot(t):
    """Return points (n, 3) of the trefoil in the middle of the tube."""
    columns = [np.sin(t) + 2 * np.sin(2 * t), np.cos(t) - 2 * np.cos(2 * t), -np.sin(3 * t)]
    return 0.45 * np.column_stack(columns)


@pytest.mark.parametrize("count", [100, 50_000])
def test_knot_tube(count):
    packing = knot_tube(count)
    radii = np.asarray(packing["radius"], dtype=float)
    assert packing.n_points == len(radii) == count
    assert np.all(np.diff(radii) <= 0.0)
    # The law, away from the few that were cut down to fit the tube: 2.8 octaves of rank halve them.
    rank = np.array([count // 4, count // 2])
    slope = np.diff(np.log(radii[rank - 1])) / np.diff(np.log(rank))
    assert slope == pytest.approx(-1 / 2.8, abs=1e-3)


def test_volume_is_six_tenths_of_the_tube():
    radii = np.asarray(knot_tube(20_000)["radius"], dtype=float)
    # Length of the knot by its chords.
    t = np.linspace(0, 2 * np.pi, 200_001)
    length = np.linalg.norm(np.diff(knot(t), axis=0), axis=1).sum()
    assert 4 / 3 * np.pi * (radii**3).sum() == pytest.approx(
        0.6 * np.pi * 0.36**2 * length, rel=1e-4
    )


def test_spheres_stay_in_the_tube():
    packing = knot_tube(5_000)
    t = np.linspace(0, 2 * np.pi, 5_001)
    curve, points = knot(t), np.asarray(packing.points, dtype=float)
    distance = np.array([np.linalg.norm(curve - p, axis=1).min() for p in points])
    assert (distance + packing["radius"]).max() < 0.36 + 1e-3


def test_spheres_fill_the_box_of_the_tube():
    """Spheres touch the tube's wall only now and then, so they come within 1 % of its box."""
    t = np.linspace(0, 2 * np.pi, 5_001)
    low, high = knot(t).min(axis=0) - 0.36, knot(t).max(axis=0) + 0.36
    assert (high - low).max() == pytest.approx(3.18, abs=0.005)
    bounds = np.reshape(PackingAccessor(knot_tube(50_000)).bounds, (3, 2))
    filled = np.ptp(bounds, axis=1) / (high - low)
    assert np.all((filled > 0.99) & (filled < 1.0))


def test_same_seed_same_packing():
    assert knot_tube(1000, seed=3) == knot_tube(1000, seed=3)
    assert knot_tube(1000, seed=3) != knot_tube(1000, seed=4)
