"""Compare reading a packing with numpy.loadtxt, in time and memory.

Run ``python benchmarks/read.py``. It writes a million lines ``x y z r`` to a temporary folder,
once with all digits of a double and once with six decimals, reads them in turn with
``vtkSpherePackingReader`` and ``numpy.loadtxt`` on two cores, and prints medians. The exit status
is 1 when a bar is not met.
"""

import argparse
import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
import pyvista as pv  # before the module, which needs its VTK
from spherepacking.vtkSpherePackingCore import vtkSpherePackingReader

SPEED_BAR = 6.0  # times faster than numpy.loadtxt
MEMORY_BAR = 2.0  # peak beyond the file, in sizes of the arrays


def read(path):
    """Read a packing with the reader of this project.

    Parameters
    ----------
    path : str or Path
        The file.

    Returns
    -------
    pyvista.PolyData
        The packing.
    """
    reader = vtkSpherePackingReader()
    reader.SetFileName(str(path))
    reader.Update()
    if reader.GetErrorMessage():
        raise ValueError(reader.GetErrorMessage())
    return pv.wrap(reader.GetOutput())


def write_lines(path, count, form):
    """Write a seeded random packing of `count` spheres, each number in the given form."""
    values = np.random.default_rng(1).normal(size=(count, 4))
    values[:, 3] = abs(values[:, 3])
    line = " ".join([form] * 4) + "\n"
    with open(path, "w") as file:
        file.writelines(line.format(*row) for row in values.tolist())


def seconds(function, *args):
    """How long a call takes."""
    start = time.perf_counter()
    function(*args)
    return time.perf_counter() - start


def time_both(path, repeats):
    """Median seconds of the reader and of numpy.loadtxt, in turn, the first of each dropped."""
    times = [(seconds(read, path), seconds(np.loadtxt, path)) for _ in range(repeats + 1)]
    ours, theirs = zip(*times[1:], strict=True)
    return statistics.median(ours), statistics.median(theirs)


def status(key):
    """A size from what Linux says of this process, in bytes."""
    lines = Path("/proc/self/status").read_text().splitlines()
    return next(int(line.split()[1]) * 1024 for line in lines if line.startswith(key))


def probe_memory(path):
    """Print the peak of the memory that reading takes, and the size of the arrays, in bytes."""
    # The high-water mark is reset, so that it is that of the reading and not of the imports.
    Path("/proc/self/clear_refs").write_text("5")
    before = status("VmRSS")
    packing = read(path)
    print(status("VmHWM") - before, packing.points.nbytes + packing["radius"].nbytes)


def peak_memory(path):
    """What probe_memory() finds in a fresh process."""
    command = [sys.executable, __file__, "--memory-of", str(path)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    peak, arrays = map(int, done.stdout.split())
    return peak, arrays


def check_same(path):
    """Refuse to time readers that do not read the same."""
    packing, table = read(path), np.loadtxt(path)
    if not (packing.points == table[:, :3]).all() or not (packing["radius"] == table[:, 3]).all():
        raise ValueError(f"{path}: the reader and numpy.loadtxt differ, expected the same numbers")


def measure(folder, name, form, lines, repeats):
    """Measure one file; rows of the table: what, value, bar, met."""
    path = Path(folder) / "packing.spheres"
    write_lines(path, lines, form)
    check_same(path)
    ours, theirs = time_both(path, repeats)
    size = path.stat().st_size
    ratio = theirs / ours
    rows = [
        (f"{name}: reader", f"{ours * 1e3:.0f} ms, {size / ours / 1e6:.0f} MB/s", "", None),
        (f"{name}: numpy.loadtxt", f"{theirs * 1e3:.0f} ms", "", None),
        (f"{name}: times faster", f"{ratio:.1f}", f">= {SPEED_BAR:g}", ratio >= SPEED_BAR),
    ]
    if sys.platform == "linux":
        peak, arrays = peak_memory(path)
        share = (peak - size) / arrays
        text = (
            f"{peak / 1e6:.0f} MB: file {size / 1e6:.0f} + {share:.2f} x arrays {arrays / 1e6:.0f}"
        )
        rows.append((f"{name}: peak memory", text, f"<= {MEMORY_BAR:g} x", share <= MEMORY_BAR))
    else:
        rows.append((f"{name}: peak memory", "measured on Linux only", "", None))
    return rows


def main():
    """Print the table; return whether all bars are met."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--lines", type=int, default=1_000_000, help="spheres in the file")
    parser.add_argument("--repeats", type=int, default=5, help="timed runs, one more is dropped")
    parser.add_argument("--memory-of", metavar="FILE", help="only measure the memory for a file")
    options = parser.parse_args()
    if options.memory_of:
        probe_memory(options.memory_of)
        return True
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, sorted(os.sched_getaffinity(0))[:2])
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for name, form in [("all digits", "{!r}"), ("6 decimals", "{:.6f}")]:
            rows += measure(folder, name, form, options.lines, options.repeats)
    words = {None: "", True: "met", False: "NOT MET"}
    print(f"{options.lines} lines 'x y z r', median of {options.repeats}, 2 cores")
    for what, value, bar, met in rows:
        print(f"{what:26} {value:45} {bar:8} {words[met]}")
    return all(met is not False for *_, met in rows)


if __name__ == "__main__":
    sys.exit(0 if main() else 1)
