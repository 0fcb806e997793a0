"""Makes one long call of the package again and again, for test_interrupts to interrupt.

``python calls.py NAME SPHERES FOLDER``; for each line on stdin it prints "begin", calls until
KeyboardInterrupt comes, and prints when that was. At the end of stdin it prints "whole" if the
call's results are then what they were before any interruption.

What is raised in a destructor is ignored by Python, also a KeyboardInterrupt that comes in one of
PyVista's: these print "ignored".
"""

import resource
import signal
import sys
import time
import warnings
from pathlib import Path

import numpy as np
import pyvista as pv
import spherepacking
from spherepacking.accessor import PackingAccessor

VIEW = [(3, 3, 3), (0, 0, 0), (0, 0, 1)]


def make(count):
    rng = np.random.default_rng(0)
    packing = pv.PolyData()
    packing.points = rng.uniform(-1, 1, (count, 3))
    packing["radius"] = rng.uniform(0.1, 0.5, count) / count ** (1 / 3)
    return packing


class Calls:
    """The calls; each returns what an undisturbed one returns again."""

    def __init__(self, count, folder):
        self.packing = make(count)
        self.accessor = PackingAccessor(self.packing)
        self.folder = folder
        self.file = folder / "many.spheres"
        self.bad = folder / "bad.spheres"
        self.dump = folder / "many.dump"
        self.vtp = folder / "many.vtp"

    def prepare(self, name):
        if name in ("read", "reader", "read_bad"):
            spherepacking.write(self.packing, self.file)
            self.bad.write_text(self.file.read_text() + "0 0 0\n")
        if name == "steps":
            part = make(max(1, self.packing.n_points // 50))
            spherepacking.write(part, self.dump)
            self.dump.write_bytes(self.dump.read_bytes() * 50)
        if name == "read_vtp":
            spherepacking.write(self.packing, self.vtp)
        if name in ("live", "draw"):
            self.plotter = pv.Plotter(off_screen=True, window_size=(300, 200))
            if name == "live":
                self.live = self.plotter.packing.path_trace(self.packing, samples=2)
            else:
                self.plotter.packing.add(self.packing)
            self.plotter.show(auto_close=False)

    def fresh(self):
        return PackingAccessor(self.packing.copy(deep=False))

    def read(self):
        return spherepacking.read(self.file)["radius"].sum()

    def reader(self):
        return spherepacking.SpherePackingReader(self.file).read()["radius"].sum()

    def read_bad(self):
        try:
            spherepacking.read(self.bad)
        except spherepacking.PackingFileError as error:
            return str(error)

    def steps(self):
        return spherepacking.steps(self.dump)[0].n_points

    def read_vtp(self):
        return spherepacking.read(self.vtp)["radius"].sum()

    def write(self):
        spherepacking.write(self.packing, self.folder / "out.csv")
        return (self.folder / "out.csv").stat().st_size

    def write_dump(self):
        spherepacking.write(self.packing, self.folder / "out.dump")
        return (self.folder / "out.dump").stat().st_size

    def write_vtp(self):
        spherepacking.write(self.packing, self.folder / "out.vtp")
        return (self.folder / "out.vtp").stat().st_size

    def write_full(self):
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        limits = resource.getrlimit(resource.RLIMIT_FSIZE)
        resource.setrlimit(resource.RLIMIT_FSIZE, (10_000, limits[1]))
        try:
            spherepacking.write(self.packing, self.folder / "full.csv")
        except spherepacking.PackingFileError as error:
            return "writing stopped" in str(error)
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, limits)

    def pack(self):
        # Ctrl-C ends it early, with a warning.
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            packing = spherepacking.pack(pv.Sphere(), max(100, self.packing.n_points // 100))
        if caught:
            raise KeyboardInterrupt
        return packing.n_points

    def ray_cast(self):
        return self.fresh().ray_cast(VIEW, (300, 200), color="white")["sphere_id"].sum()

    def ray_cast_colors(self):
        image = self.fresh().ray_cast(VIEW, (300, 200), scalars="radius", structure="grid")
        return image["color"].sum()

    def path_trace(self):
        return self.accessor.path_trace(VIEW, (300, 200), samples=4)["samples"].sum()

    def path_trace_fresh(self):
        return self.fresh().path_trace(VIEW, (30, 20), samples=1)["samples"].sum()

    def pick(self):
        return self.fresh().pick(VIEW, (300, 200), 150, 100).sphere_id

    def metaballs(self):
        return self.accessor.metaballs(0.5, dimensions=64).n_points

    def metaball_field(self):
        return self.accessor.metaball_field(96)["field"].shape

    def contacts(self):
        return self.accessor.contacts().n_cells

    def bvh_boxes(self):
        return self.accessor.bvh_boxes(depth=12).n_cells

    def grid_boxes(self):
        return self.accessor.grid_boxes(60).n_cells

    def live_picture(self):
        self.plotter.camera.azimuth += 10
        self.plotter.render()
        return self.live.finished

    def draw(self):
        self.plotter.camera.azimuth += 10
        self.plotter.render()
        return True


class Ignored:
    """Notes what Python ignores."""

    found = False

    def __call__(self, what):
        self.found = True
        if what.exc_type is not KeyboardInterrupt or what.object.__name__ != "__del__":
            sys.__unraisablehook__(what)


def repeat(call, ignored):
    """Call until an interruption is ignored.

    In a function of its own: of a loop within `try`, the jump back may be outside for CPython 3.13.
    """
    while not ignored.found:
        call()


def main(name, count, folder):
    ignored = sys.unraisablehook = Ignored()
    signal.signal(signal.SIGINT, signal.default_int_handler)  # a job in the background ignores it
    calls = Calls(int(count), Path(folder))
    calls.prepare("live" if name == "live_picture" else name)
    call = getattr(calls, name)
    expected = call()
    start = time.monotonic()
    call()
    print("ready", time.monotonic() - start, flush=True)
    for _ in sys.stdin:
        left = False
        try:
            try:
                print("begin", flush=True)
                repeat(call, ignored)
                print("ignored", time.monotonic(), flush=True)
                ignored.found = False
            finally:
                left = True
        except KeyboardInterrupt:
            print("caught" if left else "lost", time.monotonic(), flush=True)
    print("whole" if call() == expected else f"{call()} {expected}", flush=True)


main(*sys.argv[1:])
