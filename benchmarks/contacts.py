"""Contacts of polydisperse spheres beside the neighbour queries of SciPy and freud.

    pip install --target build/peers scipy freud-analysis
    PYTHONPATH=$PYTHONPATH:build/peers python benchmarks/contacts.py [--spheres N]

Prints a table and exits with status 1 when a bar is not met: ``packing.packing.contacts`` finds the
contacts of a million spheres at least 3 times as fast as either, medians of several turns one after
the other, and exactly the same pairs and gaps.

The others find all pairs of centres within two of the largest radii, and NumPy then keeps those
whose gap is at most 0. Without freud it is left out. Ours is measured as a user calls it, lines and
all arrays included; two cores each, though SciPy uses one.
"""

from __future__ import annotations

import argparse
import statistics
import sys
import time

import numpy as np
import pyvista as pv
from bars import Bars
from rich.console import Console
from scipy.spatial import cKDTree

try:
    import freud
except ImportError:
    freud = None

FACTOR_BAR = 3.0
TURNS = 3
FILLED = 0.6  # volume of the spheres over that of their box
BATCH = 1 << 20  # pairs that are filtered at a time


def uniform(rng, count):
    return rng.uniform(1.0, 5.0, count)


def logarithmic(factor):
    return lambda rng, count: factor ** rng.random(count)


RADII = {
    "1 to 5, uniform": uniform,
    "1 to 5, logarithmic": logarithmic(5.0),
    "1 to 50, logarithmic": logarithmic(50.0),
}


def scene(radii, count):
    rng = np.random.default_rng(0)
    radii = radii(rng, count)
    side = (4.0 / 3.0 * np.pi * np.sum(radii**3) / FILLED) ** (1.0 / 3.0)
    packing = pv.PolyData(rng.random((count, 3)) * side)
    packing["radius"] = radii
    return packing, side


def touching(centers, radii, first, second):
    """Rows i < j and gaps of those candidate pairs that touch, in order."""
    rows, gaps = [], []
    for begin in range(0, len(first), BATCH):
        i, j = first[begin : begin + BATCH], second[begin : begin + BATCH]
        d = centers[j] - centers[i]
        distance = np.sqrt((d[:, 0] * d[:, 0] + d[:, 1] * d[:, 1]) + d[:, 2] * d[:, 2])
        gap = distance - (radii[i] + radii[j])
        near = gap <= 0.0
        rows.append(np.column_stack([i[near], j[near]]))
        gaps.append(gap[near])
    rows, gaps = np.concatenate(rows), np.concatenate(gaps)
    order = np.lexsort((rows[:, 1], rows[:, 0]))
    return rows[order], gaps[order]


def by_scipy(packing, _side):
    centers, radii = np.asarray(packing.points), np.asarray(packing["radius"])
    pairs = cKDTree(centers).query_pairs(2.0 * radii.max(), output_type="ndarray")
    pairs.sort(axis=1)
    return touching(centers, radii, pairs[:, 0], pairs[:, 1])


def by_freud(packing, side):
    centers, radii = np.asarray(packing.points), np.asarray(packing["radius"])
    # Single precision, so the query reaches a little farther; the box is too large for images.
    reach = 2.0 * radii.max() * (1.0 + 1e-6) + 1e-6 * side
    box = freud.box.Box.cube(side + 3.0 * reach)
    points = (centers - 0.5 * side).astype(np.float32)
    query = freud.locality.AABBQuery(box, points).query(
        points, {"r_max": reach, "exclude_ii": True}
    )
    found = query.toNeighborList()
    once = found.query_point_indices < found.point_indices
    return touching(centers, radii, found.query_point_indices[once], found.point_indices[once])


def by_us(packing, _side):
    lines = packing.packing.contacts()
    return np.column_stack([lines["i"], lines["j"]]), lines.cell_data["gap"]


def measure(finders, packing, side):
    """Medians of the seconds of each, and whether all found the same."""
    seconds = {name: [] for name in finders}
    same = True
    for _ in range(TURNS):
        first = None
        for name, find in finders.items():
            start = time.perf_counter()
            rows, gaps = find(packing, side)
            seconds[name].append(time.perf_counter() - start)
            if first is None:
                first = rows, gaps
            same &= np.array_equal(first[0], rows) and np.array_equal(first[1], gaps)
    return (
        {name: statistics.median(values) for name, values in seconds.items()},
        same,
        len(first[1]),
    )


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--spheres", type=int, default=1_000_000)
    count = parser.parse_args().spheres
    finders = {"spherepacking": by_us, "SciPy": by_scipy}
    if freud is not None:
        freud.parallel.set_num_threads(2)
        finders["freud"] = by_freud
    bars = Bars(f"Contacts of {count:,} spheres", "radii", "contacts", *finders, "same pairs")
    for name, radii in RADII.items():
        packing, side = scene(radii, count)
        seconds, same, contacts = measure(finders, packing, side)
        ours = seconds["spherepacking"]
        factors = [value / ours for other, value in seconds.items() if other != "spherepacking"]
        bars.add(
            name,
            f"{contacts:,}",
            *(f"{value:.2f} s" for value in seconds.values()),
            "yes" if same else "no",
            bar=f"{min(factors):.1f} of {FACTOR_BAR:g} times",
            met=same and min(factors) >= FACTOR_BAR,
        )
    Console(width=140).print(bars.table)
    return 0 if bars.good else 1


if __name__ == "__main__":
    sys.exit(main())
