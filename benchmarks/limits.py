"""Check what reading takes at most: time that is linear in the file, and memory bounded by it.

    python benchmarks/limits.py [NAME ...]

Makes files of every format in text that are large in one way each: rows, columns, long lines,
remarks, steps, sections, or a count in the header that lies. Each is read once at SIZE and once at
four times that, in a process of its own. Prints the time of a byte of the larger by that of the
smaller, and the memory beside what the file allows, 64 bytes a byte and 64 MiB. NAME picks cases by
a part of their name. The exit status is 1 when a bar is not met.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

from bars import Bars
from rich import print

GROWTH_BAR = 1.6  # time of a byte, four times the file; machines are shared and caches end
BYTES_BAR, SPARE = 64, 64 << 20
SIZE = 4 << 20  # bytes, about
# What takes no longer than this says nothing about growth.
BRIEF = 0.02  # seconds

READ = """
import sys, time
from pathlib import Path
import pyvista as pv
import spherepacking

def status(key):
    lines = Path("/proc/self/status").read_text().splitlines()
    return next(int(line.split()[1]) * 1024 for line in lines if line.startswith(key))

small, path = sys.argv[1:]
try:
    spherepacking.read(small)  # imports
except ValueError:
    pass
Path("/proc/self/clear_refs").write_text("5")
before = status("VmRSS")
start = time.perf_counter()
try:
    packing = spherepacking.read(path)
    told = f"{packing.n_points} spheres"
except ValueError as error:
    told = "refused: " + str(error).removeprefix(path)[:70]
print(time.perf_counter() - start, status("VmHWM") - before, told)
"""


def rows(n: int, width: int = 4) -> str:
    """`n` rows of numbers."""
    more = " 7.25" * (width - 4)
    return "".join(f"{i % 97}.25 {i % 89}.5 {i % 83}.125 0.5{more}\n" for i in range(n))


def dump_step(time: int, n: int) -> str:
    head = f"ITEM: TIMESTEP\n{time}\nITEM: NUMBER OF ATOMS\n{n}\nITEM: BOX BOUNDS pp pp pp\n"
    head += "0 100\n" * 3 + "ITEM: ATOMS id type x y z radius vx vy vz label\n"
    return head + "".join(f"{i} 1 {i % 97}.5 2.5 3.5 0.5 1 2 3 Fe{i % 7}\n" for i in range(n))


def xyz_frame(n: int, claimed: int | None = None) -> str:
    head = f"{n if claimed is None else claimed}\n"
    head += 'Lattice="9 0 0 0 9 0 0 0 9" Properties=species:S:1:pos:R:3:radius:R:1\n'
    return head + "".join(f"Fe {i % 97}.5 2.5 3.5 0.5\n" for i in range(n))


def lammps_data(n: int, claimed: int | None = None) -> str:
    atoms = n if claimed is None else claimed
    head = f"LAMMPS data\n\n{atoms} atoms\n1 atom types\n\n0 9 xlo xhi\n0 9 ylo yhi\n0 9 zlo zhi\n"
    body = "".join(f"{i + 1} 1 0.5 1.5 {i % 97}.5 2.5 3.5\n" for i in range(n))
    speeds = "".join(f"{i + 1} 1 2 3\n" for i in range(n))
    return f"{head}\nAtoms # sphere\n\n{body}\nVelocities\n\n{speeds}"


def mercury(time: float, n: int, claimed: int | None = None) -> str:
    count = n if claimed is None else claimed
    row = "{}.5 2 3 0 0 0 0.5 0 0 0 0 0 0 0\n"
    return f"{count} {time} 0 0 0 9 9 9\n" + "".join(row.format(i % 97) for i in range(n))


def pqr(n: int) -> str:
    form = "ATOM  {:5d}  N   ALA A{:4d}    {:8.3f}{:8.3f}{:8.3f} -0.4000 1.8240\n"
    return "".join(form.format(i % 9999, i % 999, i % 97, 2, 3) for i in range(n))


def csv(n: int) -> str:
    return "x,y,z,radius,material\n" + "".join(f"{i % 97},2,3,0.5,m{i % 9}\n" for i in range(n))


# The name of a file and its text, by the number of bytes that it is to have about. Divisors are
# about the bytes of a row.
CASES = {
    "rows": ("p.spheres", lambda b: rows(b // 20)),
    "rows of 30 columns": ("p.txt", lambda b: rows(b // 150, 30)),
    "one row of many columns": ("p.txt", lambda b: "1 2 3 0.5" + " 7" * (b // 2) + "\n"),
    "rows of the most columns": (
        "p.txt",
        lambda b: ("1.5 2 3 .5" + " 7" * 32764 + "\n") * (b // 65538),
    ),
    "names of many columns": (
        "p.csv",
        lambda b: (
            ",".join(["x,y,z,radius", *(f"n{i}" for i in range(b // 10))])
            + "\n1,2,3,0.5"
            + ",7" * (b // 10)
            + "\n"
        ),
    ),
    "names in a remark": (
        "p.txt",
        lambda b: (
            "# x y z r" + "".join(f" n{i}" for i in range(b // 7)) + "\n" + "1 2 3 .5 6\n" * 9
        ),
    ),
    "many remarks": ("p.txt", lambda b: "# x y z r\n" * (b // 10) + "1 2 3 0.5\n"),
    "remarks between rows": ("p.txt", lambda b: "# of 4\n1 2 3 0.5\n" * (b // 17)),
    "blank lines": ("p.txt", lambda b: "\n" * b + "1 2 3 0.5\n"),
    "a long number": ("p.txt", lambda b: "1 2 3 0." + "1" * b + "\n"),
    "lone CRs": ("p.txt", lambda b: rows(b // 20).replace("\n", "\r")),
    "text in columns": ("p.csv", lambda b: csv(b // 14)),
    "text that begins late": ("p.txt", lambda b: rows(b // 25, 5) + "1 2 3 0.5 late\n"),
    "ids": ("p.txt", lambda b: "".join(f"{i + 1} 1.5 2.5 3.5 0.5\n" for i in range(b // 22))),
    "prose": ("p.txt", lambda b: "word and word\n" * (b // 14) + "1 2 3 0.5\n"),
    "PQR": ("p.pqr", lambda b: pqr(b // 70)),
    "PQR of one long record": ("p.pqr", lambda b: "ATOM 1 N ALA" + " A" * (b // 2) + "\n"),
    "a dump of one step": ("p.dump", lambda b: dump_step(0, b // 36)),
    "a dump of many steps": (
        "p.dump",
        lambda b: "".join(dump_step(i, 1) for i in range(b // 200)),
    ),
    "a dump that claims atoms": (
        "p.dump",
        lambda b: dump_step(0, b // 36).replace(f"ATOMS\n{b // 36}", "ATOMS\n999999999999"),
    ),
    "extended XYZ": ("p.xyz", lambda b: xyz_frame(b // 23)),
    "extended XYZ of many frames": ("p.xyz", lambda b: xyz_frame(1) * (b // 100)),
    "extended XYZ that claims atoms": ("p.xyz", lambda b: xyz_frame(b // 23, 999999999999)),
    "a long comment of XYZ": (
        "p.xyz",
        lambda b: xyz_frame(2).replace("Lattice", "a=1 " * (b // 4) + "Lattice"),
    ),
    "LAMMPS data": ("p.data", lambda b: lammps_data(b // 45)),
    "LAMMPS data that claims atoms": ("p.data", lambda b: lammps_data(b // 45, 999999999999)),
    "MercuryDPM": ("p.data", lambda b: mercury(0, b // 38)),
    "MercuryDPM of many steps": (
        "p.data",
        lambda b: "".join(mercury(i, 1) for i in range(b // 60)),
    ),
    "MercuryDPM that claims particles": ("p.data", lambda b: mercury(0, b // 38, 999999999999)),
    "a sphere tree that claims levels": ("p.sph", lambda b: "1 1\n999999999999\n" + rows(b // 20)),
    "SWC": (
        "p.swc",
        lambda b: "".join(f"{i + 1} 3 {i % 97}.5 2.5 3.5 0.5 {i or -1}\n" for i in range(b // 28)),
    ),
    "a medial mesh that claims vertices": (
        "p.ma",
        lambda b: (
            "999999999999 0 0\n" + "".join(f"v {r}\n" for r in rows(b // 22).split("\n")[:-1])
        ),
    ),
    "a geometry that claims particles": (
        "p.geo",
        lambda b: (
            "LSMGeometry 1.2\nBoundingBox 0 0 0 9 9 9\nPeriodicBoundaries 0 0 0\n"
            "Dimension 3D\nBeginParticles\nSimple\n999999999999\n"
            + rows(b // 24, 6)
            + "EndParticles\n"
        ),
    ),
    "nodes of Kratos": (
        "p.mdpa",
        lambda b: (
            "Begin Nodes\n"
            + "".join(f"{i + 1} {i % 97}.5 2 3\n" for i in range(b // 30))
            + "End Nodes\nBegin NodalData RADIUS\n"
            + "".join(f"{i + 1} 0 0.5\n" for i in range(b // 30))
            + "End NodalData\n"
        ),
    ),
}


def read(small: Path, path: Path) -> tuple[float, int, str]:
    """Seconds, bytes and what came of reading a file in a process of its own."""
    command = [sys.executable, "-c", READ, str(small), str(path)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    seconds, memory, told = done.stdout.strip().split(" ", 2)
    return float(seconds), int(memory), told


def main() -> bool:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--size", type=int, default=SIZE, help="bytes of the smaller file")
    options = parser.parse_args()
    bars = Bars("Reading", "case", "MB", "ms", "growth", "bytes a byte", "came of it")
    with tempfile.TemporaryDirectory() as folder:
        for case, (name, text_of) in CASES.items():
            if options.names and not any(word in case for word in options.names):
                continue
            paths = [Path(folder) / str(i) / name for i in range(3)]
            for path, size in zip(paths, (2000, options.size, 4 * options.size), strict=True):
                path.parent.mkdir(exist_ok=True)
                path.write_text(text_of(size))
            sizes = [path.stat().st_size for path in paths]
            # The least of two, since others run on the machine.
            runs = [[read(paths[0], path) for _ in range(2)] for path in paths[1:]]
            seconds = [min(run[0] for run in pair) for pair in runs]
            memory, told = runs[1][0][1:]
            growth = seconds[1] / seconds[0] / (sizes[2] / sizes[1])
            met = growth <= GROWTH_BAR or seconds[1] < BRIEF
            met &= memory <= BYTES_BAR * sizes[2] + SPARE
            bars.add(
                case,
                f"{sizes[2] / 1e6:.1f}",
                f"{seconds[1] * 1e3:.1f}",
                f"{growth:.2f}",
                f"{memory / sizes[2]:.1f}",
                told,
                bar=f"{GROWTH_BAR}, {BYTES_BAR} + 64 MiB",
                met=met,
            )
    print(bars.table)
    return bars.good


if __name__ == "__main__":
    sys.exit(0 if main() else 1)
