"""Speed and error of path tracing, against Embree's rays and what others take.

    python benchmarks/paths.py [--turns 5]

Prints tables and exits with status 1 when a bar is not met. Needs a package that was built with
-DSPHEREPACKING_EMBREE=ON; scripts/bench makes one.

Scene: a polydisperse packing in a knotted tube seen from (3, 3, 3), 1000 x 1000 pixels, 16 samples,
4 bounces. The medians leave the first turn out, and all take turns in one process.

100 000 spheres take no more than 3.609 s, as a GPU did (RTX 2080 Ti, "A Vulkan renderer for sphere
packings"), and no more than twice the time in which Embree's best mode traces 16 million primary
rays of the view, without any light. 50 000 spheres take no more than a tenth of fresnel's 30.4 s on
two cores of this kind; fresnel is not on the package index, so that the error is not compared with
its own, but with that of as many samples that are independent of each other. The arrays of a
picture have at most 64 bytes a pixel; a picture that is still held when its tracing goes on is a
copy. In a plotter there is a picture 0.3 s after the camera's last movement.
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
from spherepacking.bench import embree, light
from spherepacking.bench.measure import take_turns
from spherepacking.bench.rays import LIGHT, PATH_SAMPLES, PathTrace
from spherepacking.testing.scenes import camera_of_all, knot_tube, set_camera

SIZE = (1000, 1000)
SAMPLES = 16
WEIGHTS = [0.2126, 0.7152, 0.0722]  # of a colour in its brightness


class Primary:
    """As many primary rays as paths, in one of Embree's modes."""

    def __init__(self, peer: embree.Embree) -> None:
        self.peer = peer

    def frame(self) -> None:
        for _ in range(SAMPLES):
            self.peer.frame()


def speed(turns: int, bars: Bars) -> None:
    camera = camera_of_all()
    packing = knot_tube(100_000)
    peers = [Primary(embree.Embree(packing, camera, SIZE, n)) for n in embree.PACKETS]
    ours = PathTrace(packing, camera, SIZE, "bvh", SAMPLES)
    times = [statistics.median(own) for own in take_turns([ours, *peers], turns, 1e9)]
    best = min(times[1:])
    bars.add(
        "100 000 spheres, 16 samples", f"{times[0]:.2f} s", bar="3.609 s", met=times[0] <= 3.609
    )
    bars.add(
        "against 16 primary rays of Embree",
        f"{times[0] / best:.2f} ({best:.2f} s)",
        bar="2",
        met=times[0] <= 2.0 * best,
    )
    image = ours.light(SIZE)
    size = sum(
        image.GetPointData().GetArray(i).GetActualMemorySize() * 1024
        for i in range(image.GetPointData().GetNumberOfArrays())
    )
    each = size / image.n_points
    bars.add("bytes a pixel", f"{each:.1f}", bar="64", met=each <= 64.5)
    few = PathTrace(knot_tube(50_000), camera, SIZE, "bvh", SAMPLES)
    seconds = statistics.median(take_turns([few], turns, 1e9)[0])
    bars.add("50 000 spheres, 16 samples", f"{seconds:.2f} s", bar="3.04 s", met=seconds <= 3.04)


def first_picture(turns: int) -> float:
    """Median seconds from the camera's rest to the first picture in a window."""
    packing = knot_tube(100_000)
    plotter = pv.Plotter(off_screen=True, window_size=SIZE)
    picture = plotter.packing.path_trace(packing, samples=64, scalars="radius")
    set_camera(plotter)
    # As in a window in which someone turns the view.
    plotter.off_screen = False
    seconds = []
    for _ in range(turns + 1):
        plotter.camera.azimuth += 1.0
        plotter.render_window.Render()
        start = time.perf_counter()
        # What its timer does.
        while not picture.shown:
            time.sleep(0.01)
            picture._tick()
        plotter.render_window.Render()
        plotter.render_window.WaitForCompletion()
        seconds.append(time.perf_counter() - start)
    plotter.off_screen = True
    plotter.close()
    return statistics.median(seconds[1:])


def errors(console: Console) -> bool:
    names = ("samples", "seconds", "relMSE", "of chance", "FLIP")
    table = Bars("100 000 spheres: what a quality costs", *names)
    packing, camera = knot_tube(100_000), camera_of_all()
    best = light.reference(packing, camera, SIZE)
    brightness = np.asarray(best["radiance"], float) @ WEIGHTS
    before = None
    for samples in PATH_SAMPLES:
        subject = PathTrace(packing, camera, SIZE, "bvh", samples)
        start = time.perf_counter()
        subject.frame()
        seconds = time.perf_counter() - start
        image = subject.light(light.size_of_reference(SIZE))
        error = light.relative_mse(image["radiance"], best["radiance"])
        ours = np.asarray(image["radiance"], float) @ WEIGHTS
        # As a share of what it would be if samples were drawn independently of each other.
        weight = 1.0 / (brightness**2 + 0.01)
        chance = float(np.mean(weight * image["variance"]))
        share = float(np.mean(weight * (ours - brightness) ** 2)) / chance if before else np.nan
        table.add(
            str(samples),
            f"{seconds:.2f}",
            f"{error:.1e}",
            f"{share:.2f}" if before else "",
            f"{light.flip(image, best):.4f}",
            bar="faster than 1/n, below chance" if before else "",
            met=before is None or (error < before / 4 and share < 1.0),
        )
        before = error
    console.print(table.table)
    return table.good


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--turns", type=int, default=5, help="frames of each that are timed")
    turns = parser.parse_args().turns
    console = Console()
    bars = Bars(f"Paths in {LIGHT['max_bounces']} bounces", "what", "measured")
    speed(turns, bars)
    seconds = first_picture(turns)
    bars.add("first picture in a plotter", f"{seconds:.2f} s", bar="0.3 s", met=seconds <= 0.3)
    console.print(bars.table)
    return 0 if errors(console) and bars.good else 1


if __name__ == "__main__":
    sys.exit(main())
