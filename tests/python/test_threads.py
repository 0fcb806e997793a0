"""Threads and forked processes, each in a process of its own, which may end as it likes."""

import subprocess
import sys


def told(code):
    run = subprocess.run(
        [sys.executable, "-W", "ignore", "-c", code],
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )
    assert run.returncode == 0, (run.returncode, run.stderr[-2000:])
    return run.stdout


def test_first_use_by_eight_threads():
    code = """
import threading
import pyvista as pv
import spherepacking

start, found = threading.Barrier(8), []
datasets = [pv.PolyData([[0.0, 0.0, 0.0]]) for _ in range(8)]
plotters = [pv.Plotter(off_screen=True) for _ in range(8)]

def use(dataset, plotter):
    start.wait()
    try:
        found.append((type(dataset.packing).__name__, type(plotter.packing).__name__))
    except Exception as error:
        found.append(repr(error))

threads = [threading.Thread(target=use, args=pair) for pair in zip(datasets, plotters)]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
print(set(found))
"""
    assert told(code) == "{('PackingAccessor', 'PackingComponent')}\n"


def test_importing_the_package_imports_no_pyvista():
    code = "import sys, spherepacking; print('pyvista' in sys.modules)"
    assert told(code) == "False\n"


def test_a_forked_child_works_alone():
    """It hung in VTK's pool of threads, or crashed, once the parent had used that."""
    code = """
import multiprocessing
import spherepacking

packing = spherepacking.apollonian(4)
VIEW, SIZE = [(3, 3, 3), (0, 0, 0), (0, 0, 1)], (100, 80)

def cast(_):
    image = packing.packing.ray_cast(VIEW, SIZE)
    spherepacking.pack(packing.packing.bvh_boxes(1).triangulate().clean(), 20)
    packing.packing.path_trace(VIEW, SIZE, samples=1)
    packing.packing.contacts()
    packing.packing.metaball_field(16)
    return int(image["sphere_id"].sum())

expected = cast(0)
with multiprocessing.get_context("fork").Pool(2) as pool:
    found = pool.map_async(cast, range(4)).get(60)
assert cast(0) == expected
print(found == 4 * [expected])
"""
    assert told(code) == "True\n"


def test_a_snapshot_keeps_the_memory_of_numpy():
    code = """
import gc
import numpy as np, pyvista as pv
from spherepacking.packing import snapshot

def make():
    rng = np.random.default_rng(0)
    packing = pv.PolyData(rng.random((100_000, 3)), deep=False)
    packing["radius"] = rng.random(100_000)
    return snapshot(packing)

shared = make()
gc.collect()
others = [np.zeros((100_000, 3)) for _ in range(20)]
rng = np.random.default_rng(0)
kept, points, radii = pv.wrap(shared), rng.random((100_000, 3)), rng.random(100_000)
print((kept.points == points).all(), (kept["radius"] == radii).all())
"""
    assert told(code) == "True True\n"


def test_what_is_replaced_meanwhile_stays_alive():
    """Another thread replaces points and radii: the picture is of those at the begin."""
    code = """
import numpy as np, pyvista as pv
import spherepacking
from spherepacking.packing import snapshot

rng = np.random.default_rng(0)
packing = pv.PolyData(rng.random((1000, 3)))
packing["radius"] = rng.random(1000)
shared = snapshot(packing)
radii, points = packing["radius"].sum(), packing.points.sum()
packing["radius"] = np.zeros(1000)
packing.points = np.zeros((1000, 3))
kept = pv.wrap(shared)
print(kept["radius"].sum() == radii, kept.points.sum() == points)
"""
    assert told(code) == "True True\n"
