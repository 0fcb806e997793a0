"""Times of every technique of two builds, in turn, to see whether a change made any slower.

    python benchmarks/pace.py BEFORE AFTER [--only WORD ...] [--turns 15]

BEFORE and AFTER are folders with a package ``spherepacking`` in them; ``scripts/compare`` builds
two commits and runs this. Each has a process of its own, and jobs are done alternately, so that
what else the machine does meets both. Prints the medians of both, without their first turn, and
their ratio, which may be 1.03; a job above that gets three times as many turns before it counts.
Exits with status 1 when a bar is not met.

Only what users see is used, so that older commits run it, too.
"""

from __future__ import annotations

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from bars import Bars
from rich.console import Console

if TYPE_CHECKING:
    from collections.abc import Callable

BAR = 1.03
VIEW = [(3.0, 3.0, 3.0), (0.0, 0.0, 0.0), (0.0, 0.0, 1.0)]
SIZE = (1000, 1000)


# --- what a process does --------------------------------------------------------------------------


def packing_of(count: int) -> object:
    """Spheres of radius ∝ rank^(-1/2.8) around a knotted curve, in single precision."""
    import pyvista as pv

    rng = np.random.default_rng(count)
    t = rng.uniform(0.0, 2.0 * np.pi, count)
    knot = [
        np.sin(t) + 2.0 * np.sin(2.0 * t),
        np.cos(t) - 2.0 * np.cos(2.0 * t),
        -np.sin(3.0 * t),
    ]
    packing = pv.PolyData()
    away = rng.normal(0.0, 0.15, (count, 3))
    packing.points = (0.45 * np.column_stack(knot) + away).astype(np.float32)
    law = np.arange(1, count + 1) ** (-1.0 / 2.8)
    packing["radius"] = (0.36 * law * np.cbrt(0.5 / np.sum(law**3) / 0.046)).astype(np.float32)
    packing.set_active_scalars("radius", preference="point")
    return packing


def draw(count: int, samples: int) -> Callable[[], None]:
    import pyvista as pv

    plotter = pv.Plotter(off_screen=True, window_size=SIZE)
    plotter.render_window.SetMultiSamples(samples)
    plotter.packing.add(packing_of(count), scalars="radius", show_scalar_bar=False)
    plotter.camera_position = VIEW
    plotter.show(auto_close=False, interactive=False)

    def frame() -> None:
        plotter.render_window.MakeCurrent()
        plotter.render()
        plotter.render_window.WaitForCompletion()

    return frame


def cast(count: int, structure: str, samples: int = 1) -> Callable[[], None]:
    spheres = accessor(packing_of(count))
    return lambda: spheres.ray_cast(VIEW, SIZE, structure=structure, samples=samples)


def build(count: int, structure: str) -> Callable[[], float]:
    packing = packing_of(count)

    def seconds() -> float:
        image = accessor(packing).ray_cast(VIEW, (1, 1), structure=structure, color="white")
        return float(image.field_data["build_seconds"][0])

    return seconds


def trace(count: int, samples: int, sky: object) -> Callable[[], None]:
    spheres = accessor(packing_of(count))
    seeds = iter(range(1 << 30))
    return lambda: spheres.path_trace(VIEW, (500, 500), samples=samples, sky=sky, seed=next(seeds))


def field(count: int, grid: int, **kwargs: object) -> Callable[[], None]:
    spheres = accessor(packing_of(count))
    return lambda: spheres.metaball_field(grid, **kwargs)


def pack(count: int) -> Callable[[], None]:
    import pyvista as pv
    import spherepacking

    mesh = pv.read(pv.examples.antfile)
    return lambda: spherepacking.pack(mesh, count)


def read(extension: str, form: str) -> Callable[[], None]:
    import spherepacking

    folder = tempfile.TemporaryDirectory()
    path = Path(folder.name) / f"packing.{extension}"
    values = np.abs(np.random.default_rng(1).normal(size=(1_000_000, 4)))
    np.savetxt(path, values, form)

    def again() -> None:
        spherepacking.read(path)
        assert folder  # kept for as long as it is read from

    return again


def write(extension: str) -> Callable[[], None]:
    import spherepacking

    folder = tempfile.TemporaryDirectory()
    packing = packing_of(300_000)
    return lambda: spherepacking.write(packing, Path(folder.name) / f"packing.{extension}")


def accessor(packing: object) -> object:
    """A fresh one; that of the packing would outlive it under some versions of PyVista."""
    from spherepacking.accessor import PackingAccessor

    return PackingAccessor(packing)


def jobs() -> dict[str, Callable[[], Callable[[], float | None]]]:
    sky = np.random.default_rng(3).gamma(0.3, 2.0, (64, 128, 3)).astype(np.float32)
    made = {
        f"draw {count}, {samples} samples": lambda c=count, s=samples: draw(c, s)
        for count in (50_000, 300_000, 1_000_000)
        for samples in (0, 8)
    }
    for count in (50_000, 300_000, 1_000_000):
        made[f"rays {count}, bvh"] = lambda c=count: cast(c, "bvh")
        made[f"build {count}, bvh"] = lambda c=count: build(c, "bvh")
    return made | {
        "rays 300000, bvh, 3 x 3": lambda: cast(300_000, "bvh", 3),
        "rays 50000, grid": lambda: cast(50_000, "grid"),
        "build 300000, grid": lambda: build(300_000, "grid"),
        "paths 100000, 4, white sky": lambda: trace(100_000, 4, 1.0),
        "paths 100000, 4, image": lambda: trace(100_000, 4, sky),
        "field 100000, 128³": lambda: field(100_000, 128),
        "field 50000, 128³": lambda: field(50_000, 128),
        "field 2000, 256³": lambda: field(2000, 256),
        "field 1000000, 256³": lambda: field(1_000_000, 256),
        "field 2000, 128³, direct": lambda: field(2000, 128, relative_error=0.0),
        "field 50000, 96³, gradient": lambda: field(50_000, 96, gradient=True),
        "field 50000, 96³, strongest": lambda: field(50_000, 96, strongest=True),
        "field 50000, 96³, wyvill": lambda: field(50_000, 96, kernel="wyvill"),
        "surface 20000, 96³": lambda: surface(20_000, 96),
        "boxes 300000, 5000": lambda: boxes(300_000, 5000),
        "pack ant, 3000": lambda: pack(3000),
        "read 1000000, 17 digits": lambda: read("spheres", "%.17g"),
        "read 1000000, 6 decimals": lambda: read("xyzr", "%.6f"),
        "write 300000, csv": lambda: write("csv"),
        "write 300000, xyzd": lambda: write("xyzd"),
    }


def surface(count: int, grid: int) -> Callable[[], None]:
    spheres = accessor(packing_of(count))
    return lambda: spheres.metaballs(1.0, dimensions=grid)


def boxes(count: int, number: int) -> Callable[[], None]:
    spheres = accessor(packing_of(count))
    return lambda: spheres.bvh_boxes(number)


def work() -> None:
    """Set a job up for a line with its name, and do it for each empty line; prints seconds."""
    import pyvista as pv

    pv.OFF_SCREEN = True
    made, job = jobs(), None
    for line in sys.stdin:
        name = line.strip()
        if name:
            job = None
            job = made[json.loads(name)]()
            print("ready", flush=True)
            continue
        start = time.perf_counter()
        told = job()
        print(told if isinstance(told, float) else time.perf_counter() - start, flush=True)


# --- the driver -----------------------------------------------------------------------------------


class Worker:
    """A process with one of the packages."""

    def __init__(self, site: Path) -> None:
        environment = os.environ | {"PYTHONPATH": str(site)}
        if sys.platform.startswith("linux"):
            environment.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkOSOpenGLRenderWindow")
        self.process = subprocess.Popen(
            [sys.executable, __file__, "--worker"],
            env=environment,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
        )

    def ask(self, line: str) -> str:
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()
        answer = self.process.stdout.readline().strip()
        if not answer:
            raise RuntimeError(f"the process for {line or 'a job'} has ended")
        return answer


def take_turns(workers: list[Worker], name: str, turns: int) -> list[float]:
    """Medians of both."""
    for worker in workers:
        worker.ask(json.dumps(name))
    times: list[list[float]] = [[], []]
    for turn in range(turns + 1):
        # In the order 0 1, 1 0, 0 1, ..., so that neither always comes after the other.
        for k in (0, 1) if turn % 2 else (1, 0):
            times[k].append(float(workers[k].ask("")))
    return [statistics.median(own[1:]) for own in times]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("sites", type=Path, nargs="*", help="BEFORE AFTER")
    parser.add_argument("--only", nargs="+", help="jobs with one of these words in their name")
    parser.add_argument("--turns", type=int, default=15)
    parser.add_argument("--worker", action="store_true", help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.worker:
        work()
        return 0
    if len(arguments.sites) != 2:
        parser.error("expected two folders")
    workers = [Worker(site) for site in arguments.sites]
    table = Bars("Medians", "job", "before, ms", "after, ms", "ratio")
    for name in jobs():
        if arguments.only and not any(word in name for word in arguments.only):
            continue
        before, after = take_turns(workers, name, arguments.turns)
        if after > BAR * before:
            before, after = take_turns(workers, name, 3 * arguments.turns)
        ratio = after / before
        print(f"{name:32} {ratio:.3f}", file=sys.stderr, flush=True)
        table.add(
            name,
            f"{1e3 * before:.1f}",
            f"{1e3 * after:.1f}",
            f"{ratio:.3f}",
            bar=f"{BAR}",
            met=ratio <= BAR,
        )
    for worker in workers:
        worker.process.stdin.close()
    Console(width=100).print(table.table)
    return 0 if table.good else 1


if __name__ == "__main__":
    sys.exit(main())
