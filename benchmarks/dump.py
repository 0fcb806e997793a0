"""Compare reading one step of a dump with OVITO, and finding all steps with grep.

Run ``python benchmarks/dump.py --ovito PYTHON``, where PYTHON is an interpreter that has the
package `ovito`, which is best kept in an environment of its own. It writes a LAMMPS dump of ten
steps of a million spheres in ten columns to a temporary folder. ``vtkSpherePackingReader`` and
OVITO read the sixth step in turn, each in a process of its own, on two cores; ``grep -c ITEM``
reads the same file between them. It prints medians. The exit status is 1 when a bar is not met.
"""

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SPEED_BAR = 4.0  # times faster than OVITO
MEMORY_BAR = 0.5  # of OVITO's peak, both beyond what the imports take
FIND_BAR = 1.0  # of the time of grep
STEP = 5  # that is read, from 0
TITLES = 4  # lines with ITEM in a step

# Neither numpy nor PyVista is imported here, so that a child's memory is that of its reader.


def status(key):
    """A size from what Linux says of this process, in MB."""
    lines = Path("/proc/self/status").read_text().splitlines()
    return next(int(line.split()[1]) * 1024 / 1e6 for line in lines if line.startswith(key))


def prepare_reader(path):
    """Import the reader of this project; return what finds the steps and what reads one."""
    import pyvista as pv  # before the module, which needs its VTK
    from spherepacking.vtkSpherePackingCore import vtkSpherePackingReader

    reader = vtkSpherePackingReader()
    reader.SetFileName(str(path))

    def read():
        key = reader.GetExecutive().TIME_STEPS()
        reader.UpdateTimeStep(reader.GetOutputInformation(0).Get(key)[STEP])
        if reader.GetErrorMessage():
            raise ValueError(reader.GetErrorMessage())
        packing = pv.wrap(reader.GetOutput())
        return packing.points, packing["radius"]

    return reader.UpdateInformation, read


def prepare_ovito(path):
    """The same of OVITO, whose import_file() also reads the first step."""
    from ovito.io import import_file

    pipelines = []

    def read():
        particles = pipelines[0].compute(STEP).particles
        return particles.positions[...], particles["Radius"][...]

    return lambda: pipelines.append(import_file(str(path))), read


def measure_here(which, path):
    """Print what it takes to find the steps and to read one, and a digest of what was read."""
    find, read = {"reader": prepare_reader, "ovito": prepare_ovito}[which](path)
    # The high-water mark is reset, so that it is that of the reading and not of the imports.
    before = status("VmRSS")
    Path("/proc/self/clear_refs").write_text("5")
    start = time.perf_counter()
    find()
    found = time.perf_counter()
    points, radii = read()
    end = time.perf_counter()
    result = {
        "find": found - start,
        "all": end - start,
        "peak": status("VmHWM") - before,
        "process": status("VmHWM"),
        "digest": [len(points), float(points.sum()), float(radii.sum())],
    }
    print(json.dumps(result))


def measure(python, which, path):
    """What measure_here() finds in a fresh process of an interpreter."""
    command = [python, __file__, "--child", which, str(path)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return json.loads(done.stdout.splitlines()[-1])


def grep(path, steps):
    """How long it takes to count the titles."""
    start = time.perf_counter()
    done = subprocess.run(["grep", "-c", "ITEM", path], capture_output=True, text=True, check=True)
    seconds = time.perf_counter() - start
    if int(done.stdout) != TITLES * steps:
        raise ValueError(f"grep: found {done.stdout}, expected {TITLES * steps} titles")
    return seconds


def write_dump(path, count, steps):
    """Write a seeded random dump; all its steps have the same rows."""
    import numpy as np

    rng = np.random.default_rng(1)
    values = np.column_stack([rng.random((count, 4)), rng.normal(size=(count, 4))])
    values[:, 3] *= 0.01
    line = "{} {} " + " ".join(["{:.6g}"] * 8) + "\n"
    rows = "".join(line.format(i + 1, i % 3 + 1, *row) for i, row in enumerate(values.tolist()))
    with open(path, "w") as file:
        for step in range(steps):
            file.write(f"ITEM: TIMESTEP\n{1000 * step}\nITEM: NUMBER OF ATOMS\n{count}\n")
            file.write("ITEM: BOX BOUNDS pp pp ff\n0 1\n0 1\n0 1\n")
            file.write("ITEM: ATOMS id type x y z radius vx vy vz mass\n")
            file.write(rows)


def close(a, b):
    """Whether two digests are the same but for rounding; OVITO holds radii in single precision."""
    return all(abs(x - y) <= 1e-6 * abs(x) for x, y in zip(a, b, strict=True))


def compare(path, steps, ovito, repeats):
    """Rows of the table: what, value, bar, met."""
    runs = []
    for _ in range(repeats + 1):
        run = (
            measure(sys.executable, "reader", path),
            grep(path, steps),
            measure(ovito, "ovito", path),
        )
        if not close(run[0]["digest"], run[2]["digest"]):
            raise ValueError(f"found {run[0]['digest']} and {run[2]['digest']}, expected the same")
        runs.append(run)
    ours, greps, theirs = zip(*runs[1:], strict=True)

    def median(of, key):
        return statistics.median(run[key] for run in of)

    find, searched = median(ours, "find"), statistics.median(greps)
    speed = median(theirs, "all") / median(ours, "all")
    memory = median(ours, "peak") / median(theirs, "peak")
    text = "{:.0f} ms, {:.0f} MB beyond the imports, {:.0f} MB in all"
    return [
        *(
            (
                name,
                text.format(1e3 * median(of, "all"), median(of, "peak"), median(of, "process")),
                "",
                None,
            )
            for name, of in [("reader", ours), ("OVITO", theirs)]
        ),
        ("times faster", f"{speed:.1f}", f">= {SPEED_BAR:g}", speed >= SPEED_BAR),
        ("of its peak memory", f"{memory:.2f}", f"<= {MEMORY_BAR:g}", memory <= MEMORY_BAR),
        ("finding all steps", f"{1e3 * find:.0f} ms", "", None),
        ("grep -c ITEM", f"{1e3 * searched:.0f} ms", "", None),
        ("of its time", f"{find / searched:.2f}", f"<= {FIND_BAR:g}", find <= FIND_BAR * searched),
    ]


def main():
    """Print the table; return whether all bars are met."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--ovito", default=sys.executable, help="interpreter that has OVITO")
    parser.add_argument("--spheres", type=int, default=1_000_000)
    parser.add_argument("--steps", type=int, default=10)
    parser.add_argument("--repeats", type=int, default=7)
    parser.add_argument("--child", nargs=2, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.child:
        measure_here(*options.child)
        return True
    os.sched_setaffinity(0, sorted(os.sched_getaffinity(0))[:2])
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "packing.dump"
        write_dump(path, options.spheres, options.steps)
        size = path.stat().st_size
        rows = compare(path, options.steps, options.ovito, options.repeats)
    words = {None: "", True: "met", False: "NOT MET"}
    print(
        f"{options.steps} steps of {options.spheres} spheres, {size / 1e6:.0f} MB, "
        f"one step read, median of {options.repeats}, 2 cores"
    )
    for what, value, bar, met in rows:
        print(f"{what:20} {value:52} {bar:8} {words[met]}")
    return all(met is not False for *_, met in rows)


if __name__ == "__main__":
    sys.exit(0 if main() else 1)
