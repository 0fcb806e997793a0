"""Lets one allocation after another fail in a call of the package, for test_failing_allocations.

``python calls.py NAME FOLDER``, with the library of failing.cxx preloaded. Prints each try before
it begins, so that its number is known should the process end.
"""

import ctypes
import sys
from pathlib import Path

import numpy as np
import pyvista as pv
import spherepacking
from spherepacking.accessor import PackingAccessor

VIEW = [(3, 3, 3), (0, 0, 0), (0, 0, 1)]
SIZE = (40, 30)
shim = ctypes.CDLL(None)


def make(count=3000):
    rng = np.random.default_rng(0)
    packing = pv.PolyData()
    packing.points = rng.uniform(-1, 1, (count, 3))
    packing["radius"] = rng.uniform(0.05, 0.1, count)
    return packing


def sums(dataset):
    """What stays the same in every run."""
    data = dataset.point_data
    chosen = {"radius", "sphere_id", "depth", "color", "field", "radiance", "samples"} & set(data)
    return dataset.n_points, dataset.n_cells, *(float(np.nansum(data[n])) for n in sorted(chosen))


class Calls:
    def __init__(self, folder):
        self.packing = make()
        self.folder = folder
        self.files = {}
        for name in ("a.spheres", "a.csv", "a.xyzd", "a.dump", "a.xyz", "a.txt"):
            self.files[name] = folder / name
            spherepacking.write(self.packing, folder / name)
        self.mesh = pv.Sphere(theta_resolution=12, phi_resolution=12)

    def fresh(self):
        return PackingAccessor(self.packing.copy(deep=False))

    def read(self):
        return [sums(spherepacking.read(path)) for path in self.files.values()]

    def steps(self):
        return [sums(packing) for packing in spherepacking.steps(self.files["a.dump"])]

    def write(self):
        sizes = []
        for name in self.files:
            spherepacking.write(self.packing, self.folder / f"out.{name}")
            sizes.append((self.folder / f"out.{name}").stat().st_size)
        return sizes

    def pack(self):
        return sums(spherepacking.pack(self.mesh, 30))

    def pick(self):
        return self.fresh().pick(VIEW, SIZE, 20, 15).sphere_id

    def ray_cast(self):
        return sums(self.fresh().ray_cast(VIEW, SIZE, scalars="radius"))

    def ray_cast_grid(self):
        return sums(self.fresh().ray_cast(VIEW, SIZE, structure="grid", color="white"))

    def path_trace(self):
        return sums(self.fresh().path_trace(VIEW, SIZE, samples=2))

    def metaball_field(self):
        return sums(self.fresh().metaball_field(12, threshold=1.0, weights=[1, 2]))

    def strongest(self):
        return sums(self.fresh().metaball_field(12, strongest=True, gradient=True))

    def multilevel(self):
        return sums(self.fresh().metaball_field(40))

    def metaballs(self):
        return sums(self.fresh().metaballs(1.0, dimensions=12))

    def contacts(self):
        return sums(self.fresh().contacts())

    def bvh_boxes(self):
        return sums(self.fresh().bvh_boxes(50))

    def grid_boxes(self):
        return sums(self.fresh().grid_boxes(5))

    def draw(self):
        plotter = pv.Plotter(off_screen=True, window_size=SIZE)
        try:
            plotter.packing.add(self.packing.copy(deep=False), color="white")
            return int(plotter.packing.screenshot(self.folder / "a.png").sum())
        finally:
            plotter.close()


def attempt(call, n, lasting, expected):
    """Whether the n-th allocation was reached."""
    print("try", n, lasting, flush=True)
    told = ""
    shim.arm(n, lasting)
    try:
        found = call()
    except (MemoryError, ValueError, RuntimeError, spherepacking.PackingFileError) as error:
        told = f"{type(error).__name__}: {error}"
    finally:
        fired = shim.disarm()
    assert not told or told.startswith("MemoryError") or "memory" in told, told
    if not told:
        assert found == expected, (n, lasting, "nothing was said", found, expected)
    again = call()
    assert again == expected, (n, lasting, told, again, expected)
    return fired


def main(name, folder):
    call = getattr(Calls(Path(folder)), name)
    call()
    expected = call()
    tries = []
    for lasting in (0, 1):
        n = 1
        while attempt(call, n, lasting, expected):
            tries.append(n)
            n = n + 1 if n < 30 else int(1.3 * n)
    print("done", len(tries), max(tries, default=0), flush=True)


main(*sys.argv[1:])
