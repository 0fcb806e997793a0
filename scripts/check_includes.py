"""Check that no C++ include runs against the plan of docs/architecture.md.

    python scripts/check_includes.py [FOLDER]

Prints each include that does, with file, line and what the plan allows, and exits with status 1 if
there is one. FOLDER is vtkSpherePacking by default.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

# Each room of Core, from the ground up, and the rooms that its files may include besides their own.
# The rooms up to the packer know no VTK.
PLAIN = {
    "base": (),
    "accel": ("base",),
    "trace": ("base", "accel"),
    "light": ("base", "accel", "trace"),
    "metaballs/field": ("base",),
    "metaballs/multipole": ("base", "metaballs/field"),
    "metaballs/multilevel": ("base", "metaballs/field", "metaballs/multipole"),
    "metaballs": ("base", "metaballs/field", "metaballs/multipole", "metaballs/multilevel"),
    "packer": ("base",),
}
ROOMS = PLAIN | {
    "bridge": tuple(PLAIN),
    "io": ("base", "bridge"),
    "": (*PLAIN, "bridge", "io"),  # the wrapped classes
}
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"')


def room_of(path: Path) -> str:
    """The room of a file, by the folder that it lies in."""
    return "" if path.parent == Path() else path.parent.as_posix()


def includes_of(path: Path) -> list[tuple[int, str]]:
    lines = path.read_text("utf-8").splitlines()
    return [(i, m[1]) for i, line in enumerate(lines, 1) if (m := INCLUDE.match(line))]


def faults_of(core: Path, file: Path) -> list[str]:
    """What is wrong with the includes of one file."""
    name = file.relative_to(core)
    room = room_of(name)
    if room not in ROOMS:
        return [f"{file}: found the room {room}, expected one of {', '.join(ROOMS)}"]
    faults = []
    for line, included in includes_of(file):
        where = f"{file}:{line}: found {included}"
        if not (core / included).is_file():
            # Generated headers, and those of VTK.
            if room in PLAIN:
                faults.append(f"{where}, expected no VTK in {room}/")
            continue
        other = room_of(Path(included))
        if other not in (room, *ROOMS[room]):
            allowed = ", ".join(f"{r}/" for r in ROOMS[room]) or "no other room"
            faults.append(f"{where} in {room}/, expected its own files or those of {allowed}")
    return faults


def circle_in(core: Path) -> list[str]:
    """Headers that include each other in a circle, if there are any."""
    graph = {
        header.relative_to(core).as_posix(): [
            name for _, name in includes_of(header) if (core / name).is_file()
        ]
        for header in core.rglob("*.h")
    }
    done: set[str] = set()

    def visit(name: str, trail: list[str]) -> list[str]:
        if name in trail:
            return [*trail[trail.index(name) :], name]
        if name in done:
            return []
        done.add(name)
        for following in graph.get(name, ()):
            if found := visit(following, [*trail, name]):
                return found
        return []

    return next((found for name in sorted(graph) if (found := visit(name, []))), [])


def main(folder: Path) -> int:
    core = folder / "Core"
    files = sorted(path for path in core.rglob("*") if path.suffix in (".h", ".cxx"))
    faults = [fault for file in files for fault in faults_of(core, file)]
    if circle := circle_in(core):
        faults.append(f"{core}: found a circle of includes: {' -> '.join(circle)}")
    # Another module, which sees the wrapped classes of Core alone.
    for file in sorted((folder / "Rendering").rglob("*.*")):
        if file.suffix in (".h", ".cxx"):
            faults += [
                f"{file}:{line}: found {name} of Core, expected one of its wrapped classes"
                for line, name in includes_of(file)
                if "/" in name and (core / name).is_file()
            ]
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    root = Path(__file__).resolve().parents[1]
    sys.exit(main(Path(sys.argv[1]) if len(sys.argv) > 1 else root / "vtkSpherePacking"))
