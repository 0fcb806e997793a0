"""Speed and error of the ray caster, against Embree 3 and float64 rays.

    python benchmarks/trace.py [--counts 50000 300000 1000000] [--without-large]

Prints tables and exits with status 1 when a bar is not met. Needs a package that was built with
-DSPHEREPACKING_EMBREE=ON; scripts/bench makes one.

Rays: frames of 1000 x 1000 pixels, colour and normals included, take no longer than with the best
of Embree's modes, and the hierarchy is built no slower than Embree's of high quality. All take
turns in one process; the medians leave the first turn out. The hierarchy has at most 48 bytes a
sphere.

Error: another sphere than float64 rays see is shown by at most one of a million pixels; the depth
is right to 1e-6.

Structures: at 50 000 spheres a frame through the hierarchy is at least 100 times as fast as without
a structure, through the grid 20 times. From 1 to 10 million spheres a frame's time grows less than
twofold. 50 million spheres are built and traced in 24 GiB, by a process of its own.
"""

from __future__ import annotations

import argparse
import resource
import statistics
import subprocess
import sys
import time

from bars import Bars
from rich.console import Console
from spherepacking.accessor import PackingAccessor
from spherepacking.bench import embree
from spherepacking.bench.measure import errors_of, expect, take_turns
from spherepacking.bench.rays import RayCast
from spherepacking.testing.scenes import camera_of_all, knot_tube

SIZE = (1000, 1000)
GIB = 1 << 30


def builds(packing, peer: embree.Embree, turns: int) -> tuple[float, float]:
    """Median seconds of our build and of Embree's."""
    ours, theirs = [], []
    for _ in range(turns + 1):
        # The structure is kept by the accessor: another one builds another one.
        image = PackingAccessor(packing).ray_cast(camera_of_all(), (8, 8))
        ours.append(float(image.field_data["build_seconds"][0]))
        theirs.append(peer.build())
    return statistics.median(ours[1:]), statistics.median(theirs[1:])


def against_embree(counts: list[int], turns: int, console: Console) -> bool:
    speed = Bars("Frame of 1000 x 1000 pixels", "spheres", "Embree, ms", "ms", "times as fast")
    build = Bars("Hierarchy", "spheres", "Embree, ms", "ms", "ratio", "bytes a sphere")
    error = Bars("Error against float64 rays", "spheres", "hit pixels", "wrong", "depth, most")
    for count in counts:
        packing, camera = knot_tube(count), camera_of_all()
        ours = RayCast(packing, camera, SIZE, "bvh", 1)
        peers = {n: embree.Embree(packing, camera, SIZE, n) for n in embree.PACKETS}
        times = [statistics.median(t) for t in take_turns([ours, *peers.values()], turns, 1e9)]
        best = min(range(1, len(times)), key=times.__getitem__)
        ratio = times[best] / times[0]
        speed.add(
            f"{count}",
            f"{1e3 * times[best]:.0f} (packets of {list(peers)[best - 1]})",
            f"{1e3 * times[0]:.0f}",
            f"{ratio:.2f}",
            bar=">= 1",
            met=ratio >= 1.0,
        )
        own, other = builds(packing, peers[8], turns)
        size = ours.memory_bytes / count
        build.add(
            f"{count}",
            f"{1e3 * other:.0f}",
            f"{1e3 * own:.0f}",
            f"{own / other:.2f}",
            f"{size:.1f}",
            bar="<= 1, <= 48 B",
            met=own <= other and size <= 48.0,
        )
        found = errors_of(ours.seen(), expect(packing, camera, SIZE))
        error.add(
            f"{count}",
            f"{found['hit_pixels']}",
            f"{found['wrong_pixels']}",
            f"{found['depth_most']:.1e}",
            bar="<= 1, <= 1e-6",
            met=found["wrong_pixels"] <= 1 and found["depth_most"] <= 1e-6,
        )
        for subject in (ours, *peers.values()):
            subject.close()
    for bars in (speed, build, error):
        console.print(bars.table)
    return speed.good and build.good and error.good


def against_no_structure(turns: int, console: Console) -> bool:
    bars = Bars("50 000 spheres", "structure", "ms", "times as fast")
    packing, camera = knot_tube(50_000), camera_of_all()
    # Slow, so that one picture has to do; making the subject makes it.
    start = time.perf_counter()
    RayCast(packing, camera, SIZE, "none", 1)
    none = time.perf_counter() - start
    bars.add("none", f"{1e3 * none:.0f}", "1", bar="", met=True)
    structures = {"bvh": 100.0, "grid": 20.0}
    subjects = [RayCast(packing, camera, SIZE, name, 1) for name in structures]
    for (name, least), own in zip(
        structures.items(), take_turns(subjects, turns, 1e9), strict=True
    ):
        ratio = none / statistics.median(own)
        bars.add(
            name,
            f"{1e3 * none / ratio:.0f}",
            f"{ratio:.0f}",
            bar=f">= {least:.0f}",
            met=ratio >= least,
        )
    console.print(bars.table)
    return bars.good


def growth(turns: int, console: Console) -> bool:
    bars = Bars("Frames of many spheres", "spheres", "build, s", "ms", "ratio to the first")
    counts = (1_000_000, 10_000_000)
    subjects = [RayCast(knot_tube(count), camera_of_all(), SIZE, "bvh", 1) for count in counts]
    times = [statistics.median(own) for own in take_turns(subjects, turns, 1e9)]
    for count, subject, seconds in zip(counts, subjects, times, strict=True):
        ratio = seconds / times[0]
        bars.add(
            f"{count}",
            f"{subject.build_seconds:.2f}",
            f"{1e3 * seconds:.0f}",
            f"{ratio:.2f}",
            bar="< 2",
            met=ratio < 2.0,
        )
    console.print(bars.table)
    return bars.good


def trace_alone(count: int) -> None:
    """What the process of the next function does."""
    subject = RayCast(knot_tube(count), camera_of_all(), SIZE, "bvh", 1)
    (times,) = take_turns([subject], 3, 1e9)
    peak = 1024 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    print(
        subject.build_seconds,
        statistics.median(times),
        peak,
        int((subject.seen().sphere_id >= 0).sum()),
    )


def largest(console: Console) -> bool:
    bars = Bars("A process of its own", "spheres", "build, s", "ms", "hit pixels", "peak, GiB")
    count = 50_000_000
    made = subprocess.run(
        [sys.executable, __file__, "--alone", f"{count}"],
        stdout=subprocess.PIPE,
        text=True,
        check=True,
    )
    build, seconds, peak, hits = map(float, made.stdout.split())
    bars.add(
        f"{count}",
        f"{build:.1f}",
        f"{1e3 * seconds:.0f}",
        f"{hits:.0f}",
        f"{peak / GIB:.1f}",
        bar="<= 24",
        met=peak <= 24 * GIB and hits > 0,
    )
    console.print(bars.table)
    return bars.good


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--counts", type=int, nargs="+", default=[50_000, 300_000, 1_000_000])
    parser.add_argument("--turns", type=int, default=7, help="timed frames of each")
    parser.add_argument("--without-large", action="store_true", help="no 10 and 50 million")
    parser.add_argument("--alone", type=int, help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.alone:
        trace_alone(arguments.alone)
        return 0
    console = Console(width=110)
    good = against_embree(arguments.counts, arguments.turns, console)
    good &= against_no_structure(arguments.turns, console)
    if not arguments.without_large:
        good &= growth(arguments.turns, console)
        good &= largest(console)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
