"""Speed and error of the sphere mapper, against flat discs and float64 rays.

    python benchmarks/draw.py [--counts 50000 300000] [--data FOLDER] [--no-speed | --no-error]

Prints two tables and exits with status 1 when a bar is not met.

Error: pixels whose silhouette differs from float64 rays through pixel centres (at most 1e-5 of the
hit pixels, and one more), pixels of another sphere, and the depth error in steps of the depth
buffer (99.9 % of the pixels within 2 steps).

Speed: a frame of 1000 x 1000 pixels takes at most 1.25 times that of vtkPointGaussianMapper drawing
the same packing as flat discs, in quads as tight as it makes them (BoundScale 1). The two take
turns in one process; the medians leave the first turn out. The lights are VTK's single headlight
and the five of PyVista; the samples per pixel none and PyVista's default.
"""

from __future__ import annotations

import argparse
import os
import statistics
import sys
import time
from pathlib import Path

import numpy as np
import pyvista as pv
import spherepacking
from rich.console import Console
from rich.table import Table
from spherepacking.bench.peers import add_discs
from spherepacking.draw.offscreen import choose_window
from spherepacking.testing import accuracy, reference
from spherepacking.testing.scenes import knot_tube, set_camera

BAR = 1.25
SIZE = (1000, 1000)


def window(samples: int = 0) -> pv.Plotter:
    plotter = pv.Plotter(off_screen=True, window_size=SIZE)
    plotter.render_window.SetMultiSamples(samples)
    plotter.set_background("black")
    return plotter


# --- error ----------------------------------------------------------------------------------------


def look(plotter, position, focal_point=(0, 0, 0), view_angle=40.0, parallel_scale=None):
    plotter.camera_position = [position, focal_point, (0, 0, 1)]
    plotter.camera.view_angle = view_angle
    if parallel_scale is not None:
        plotter.enable_parallel_projection()
        plotter.camera.parallel_scale = parallel_scale


def file_scene(path: Path):
    packing = spherepacking.read(path)
    low, high = packing.points.min(axis=0), packing.points.max(axis=0)
    middle, reach = (low + high) / 2, np.linalg.norm(high - low)
    position = middle + reach * np.array([0.9, 0.7, 0.6])
    return packing, {"position": tuple(position), "focal_point": tuple(middle)}


def scenes(data: Path):
    yield "Apollonian", spherepacking.apollonian(6), {"position": (1.6, 1.2, 1.4)}
    ball = pv.PolyData(np.zeros((1, 3)))
    ball["radius"] = np.ones(1)
    yield "one sphere from 1.01 radii", ball, {"position": (1.01, 0, 0), "view_angle": 60.0}
    yield "one sphere from inside", ball, {"position": (0.4, 0.2, 0.1), "view_angle": 90.0}
    knot = knot_tube(50_000)
    yield "knot, 50k", knot, {"position": (3, 3, 3)}
    yield "knot, parallel", knot, {"position": (3, 3, 3), "parallel_scale": 1.8}
    yield "knot, parallel, 1000 x away", knot, {"position": (3e3, 3e3, 3e3), "parallel_scale": 1.8}
    for name in ("deme_TeddyBear.csv", "packgen_packing.xyzd", "voronota_3dlb.xyzr"):
        if (data / name).is_file():
            yield name, *file_scene(data / name)


def errors_of(packing: pv.PolyData, view: dict) -> tuple[accuracy.Errors, float]:
    plotter = window()
    plotter.packing.add(
        packing, scalars=accuracy.id_colors(packing.n_points), rgb=True, lighting=False
    )
    look(plotter, **view)
    plotter.show(auto_close=False, interactive=False)
    plotter.renderer.ResetCameraClippingRange()
    plotter.render()
    times = []
    for _ in range(4):
        start = time.perf_counter()
        plotter.render()
        plotter.render_window.WaitForCompletion()
        times.append(time.perf_counter() - start)
    drawn = accuracy.read(plotter)
    to_device = reference.projection(plotter.renderer)
    plotter.close()
    expected = reference.cast(packing.points, packing["radius"], to_device, SIZE)
    return accuracy.compare(drawn, expected), statistics.median(times[1:])


def error_table(data: Path, console: Console) -> bool:
    table = Table(title="Error against float64 rays, 1000 x 1000 pixels")
    for name in (
        "scene",
        "spheres",
        "hit pixels",
        "silhouette wrong",
        "bar",
        "other sphere",
        "depth steps, median",
        "99.9 %",
        "frame, ms",
        "",
    ):
        table.add_column(name, justify="left" if name == "scene" else "right")
    good = True
    for name, packing, view in scenes(data):
        errors, seconds = errors_of(packing, view)
        good &= errors.good
        table.add_row(
            name,
            f"{packing.n_points}",
            f"{errors.hit_pixels}",
            f"{errors.silhouette_wrong}",
            f"<= {errors.silhouette_allowed}",
            f"{errors.sphere_wrong}",
            f"{errors.depth_steps_median:.2f}",
            f"{errors.depth_steps_999:.2f}",
            f"{1e3 * seconds:.0f}",
            "met" if errors.good else "NOT MET",
        )
    console.print(table)
    return good


# --- speed ----------------------------------------------------------------------------------------


def add_spheres(plotter: pv.Plotter, packing: pv.PolyData) -> None:
    plotter.packing.add(packing, scalars="radius", show_scalar_bar=False)


def plotters(packing: pv.PolyData, lights: str, samples: int) -> dict[str, pv.Plotter]:
    made = {}
    for name, add in (("discs", add_discs), ("spheres", add_spheres)):
        plotter = window(samples)
        if lights == "headlight":
            plotter.remove_all_lights()
            plotter.add_light(pv.Light(light_type="headlight"))
        add(plotter, packing)
        set_camera(plotter)
        plotter.show(auto_close=False, interactive=False)
        made[name] = plotter
    return made


def frame_times(packing: pv.PolyData, lights: str, samples: int, turns: int) -> dict[str, float]:
    made = plotters(packing, lights, samples)
    times = {name: [] for name in made}
    for _ in range(turns + 1):
        for name, plotter in made.items():
            plotter.render_window.MakeCurrent()
            start = time.perf_counter()
            plotter.render()
            plotter.render_window.WaitForCompletion()
            times[name].append(time.perf_counter() - start)
    for plotter in made.values():
        plotter.close()
    return {name: statistics.median(values[1:]) for name, values in times.items()}


def speed_table(counts: list[int], turns: int, console: Console) -> bool:
    table = Table(title="Frame of 1000 x 1000 pixels")
    for name in ("spheres", "lights", "samples", "discs, ms", "spheres, ms", "ratio", "bar", ""):
        table.add_column(name, justify="right")
    good = True
    for count in counts:
        packing = knot_tube(count)
        for lights in ("headlight", "PyVista's"):
            for samples in (0, pv.global_theme.multi_samples):
                seconds = frame_times(packing, lights, samples, turns)
                ratio = seconds["spheres"] / seconds["discs"]
                good &= ratio <= BAR
                table.add_row(
                    f"{count}",
                    lights,
                    f"{samples}",
                    f"{1e3 * seconds['discs']:.0f}",
                    f"{1e3 * seconds['spheres']:.0f}",
                    f"{ratio:.2f}",
                    f"<= {BAR}",
                    "met" if ratio <= BAR else "NOT MET",
                )
    console.print(table)
    return good


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--counts", type=int, nargs="+", default=[50_000, 300_000, 1_000_000])
    parser.add_argument("--turns", type=int, default=7, help="timed frames of each")
    default = Path(__file__).resolve().parents[2] / "shared" / "data"
    parser.add_argument(
        "--data",
        type=Path,
        default=Path(os.environ.get("SPHEREPACKING_DATA", default)),
        help="folder of real packings; scenes of absent files are left out",
    )
    parser.add_argument("--no-speed", action="store_true")
    parser.add_argument("--no-error", action="store_true")
    arguments = parser.parse_args()
    choose_window()
    console = Console(width=130)
    probe = window()
    probe.show(auto_close=False, interactive=False)
    capabilities = probe.render_window.ReportCapabilities().splitlines()
    probe.close()
    for line in capabilities[:3]:
        console.print(line)
    good = True
    if not arguments.no_error:
        good &= error_table(arguments.data, console)
    if not arguments.no_speed:
        good &= speed_table(arguments.counts, arguments.turns, console)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
