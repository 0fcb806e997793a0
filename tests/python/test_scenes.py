"""The packing of the benchmarks."""

import numpy as np
import pytest
from spherepacking._scenes import knot_tube
from spherepacking.accessor import PackingAccessor


@pytest.mark.parametrize("count", [100, 50_000])
def test_knot_tube(count):
    packing = knot_tube(count)
    radii = np.asarray(packing["radius"], dtype=float)
    assert packing.n_points == len(radii) == count
    assert np.all(np.diff(radii) <= 0.0)
    # The law, away from the few that were cut down to fit the tube: a factor of 2.8 octaves halves.
    rank = np.array([count // 4, count // 2])
    slope = np.diff(np.log(radii[rank - 1])) / np.diff(np.log(rank))
    assert slope == pytest.approx(-1 / 2.8, abs=1e-3)


def test_volume_is_six_tenths_of_the_tube():
    radii = np.asarray(knot_tube(20_000)["radius"], dtype=float)
    # Length of the knot by its chords.
    t = np.linspace(0, 2 * np.pi, 200_001)
    knot = 0.45 * np.column_stack(
        [np.sin(t) + 2 * np.sin(2 * t), np.cos(t) - 2 * np.cos(2 * t), -np.sin(3 * t)]
    )
    length = np.linalg.norm(np.diff(knot, axis=0), axis=1).sum()
    assert 4 / 3 * np.pi * (radii**3).sum() == pytest.approx(
        0.6 * np.pi * 0.36**2 * length, rel=1e-4
    )


def test_spheres_stay_in_the_tube():
    packing = knot_tube(5_000)
    t = np.linspace(0, 2 * np.pi, 5_001)
    knot = 0.45 * np.column_stack(
        [np.sin(t) + 2 * np.sin(2 * t), np.cos(t) - 2 * np.cos(2 * t), -np.sin(3 * t)]
    )
    points = np.asarray(packing.points, dtype=float)
    distance = np.array([np.linalg.norm(knot - p, axis=1).min() for p in points])
    assert (distance + packing["radius"]).max() < 0.36 + 1e-3


def test_width_is_about_3_4():
    bounds = np.reshape(PackingAccessor(knot_tube(50_000)).bounds, (3, 2))
    assert np.ptp(bounds, axis=1).max() == pytest.approx(3.3, abs=0.2)


def test_same_seed_same_packing():
    assert knot_tube(1000, seed=3) == knot_tube(1000, seed=3)
    assert knot_tube(1000, seed=3) != knot_tube(1000, seed=4)
