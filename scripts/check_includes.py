"""Check that no C++ include runs against the plan of docs/architecture.md.

    python scripts/check_includes.py [FOLDER]

Prints each include that does, with file, line and what the plan allows, and exits with status 1 if
there is one. FOLDER is vtkSpherePacking by default.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

# The rooms of Core, from the ground up, and the rooms that the files of each may include besides
# their own. These know no VTK.
PLAIN = {
    "base": (),
    "accel": ("base",),
    "contacts": ("base",),
    "trace": ("base", "accel"),
    "light": ("base", "accel", "trace"),
    "metaballs/field": ("base",),
    "metaballs/multipole": ("base", "metaballs/field"),
    "metaballs/multilevel": ("base", "metaballs/field", "metaballs/multipole"),
    "metaballs": ("base", "metaballs/field", "metaballs/multipole", "metaballs/multilevel"),
    "packer": ("base",),
}
# The room "" is that of the wrapped classes.
CORE = PLAIN | {
    "bridge": tuple(PLAIN),
    "io": ("base", "bridge"),
    "": (*PLAIN, "bridge", "io"),
}
RENDERING = {"impostor": (), "tiles": (), "": ("impostor", "tiles")}
COMMENT = r"(?:/\*.*?\*/\s*)*"
INCLUDE = re.compile(rf"""^\s*{COMMENT}#\s*{COMMENT}include\s*{COMMENT}([<"])([^>"]+)[>"]""")
# What stands in angle brackets and is no header of the language or the system.
OURS = re.compile("vtk|" + "|".join(f"{room}/" for room in (*CORE, *RENDERING) if room))
NO_SOURCES = {".glsl", ".module", ".txt"}


def room_of(path: Path) -> str:
    """The room of a file, by the folder that it lies in."""
    return "" if path.parent == Path() else path.parent.as_posix()


def includes_of(path: Path) -> list[tuple[int, str]]:
    """Line and name of what a file includes, but for the headers of the language and the system."""
    lines = path.read_text("utf-8").splitlines()
    found = [(i, m[1], m[2]) for i, line in enumerate(lines, 1) if (m := INCLUDE.match(line))]
    return [(i, name) for i, sign, name in found if sign == '"' or OURS.match(name)]


def faults_of(module: Path, rooms: dict[str, tuple[str, ...]], file: Path) -> list[str]:
    """What is wrong with the includes of one file of a module."""
    room = room_of(file.relative_to(module))
    if room not in rooms:
        return [f"{file}: found the room {room}, expected one of {', '.join(rooms)}"]
    faults = []
    for line, included in includes_of(file):
        where = f"{file}:{line}: found {included}"
        if (module / included).is_file():
            other = room_of(Path(included))
            if other not in (room, *rooms[room]):
                allowed = ", ".join(f"{r}/" for r in rooms[room]) or "no other room"
                faults.append(f"{where} in {room}/, expected its own files or those of {allowed}")
        # Generated headers, those of VTK, and the wrapped classes of the other module.
        elif module.name == "Core" and (module.parent / "Rendering" / included).is_file():
            faults.append(f"{where} of Rendering, which lies above")
        elif room in PLAIN:
            faults.append(f"{where}, expected no VTK in {room}/")
        elif "/" in included and not included.startswith("vtksys/"):
            faults.append(f"{where}, expected a wrapped class of the other module")
    return faults


def circle_in(module: Path) -> list[str]:
    """Headers that include each other in a circle, if there are any."""
    graph = {
        header.relative_to(module).as_posix(): [
            name for _, name in includes_of(header) if (module / name).is_file()
        ]
        for header in module.rglob("*.h")
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
    faults = []
    for module, rooms in ((folder / "Core", CORE), (folder / "Rendering", RENDERING)):
        files = sorted(
            path for path in module.rglob("*") if path.is_file() and path.suffix not in NO_SOURCES
        )
        for file in files:
            faults += faults_of(module, rooms, file)
        if circle := circle_in(module):
            faults.append(f"{module}: found a circle of includes: {' -> '.join(circle)}")
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    root = Path(__file__).resolve().parents[1]
    sys.exit(main(Path(sys.argv[1]) if len(sys.argv) > 1 else root / "vtkSpherePacking"))
